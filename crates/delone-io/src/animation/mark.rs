//! Marks: all that can be seen in a frame, each with a look. Their order is that in which they are drawn.
//!
//! Places are tenths of a pixel, so marks can be compared: what is the same in two frames is drawn once
//! and lasts.

use crate::picture::domain::REGION_COLORS;
use crate::picture::{Color, INK, PAPER, scale};

/// Classes of colour of triangles.
pub(super) const CLASSES: u8 = 24;

/// How much of the colour of its angle a triangle has; the rest is paper.
const TINT: f32 = 0.34;

/// A place on the page, in tenths of a pixel.
pub(super) type Spot = [i32; 2];

/// Something to be seen.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Mark {
    pub look: Look,
    pub form: Form,
}

/// Where something is, and of what shape. Lengths are tenths of a pixel.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Form {
    Disc {
        center: Spot,
        radius: i32,
    },
    Line([Spot; 2]),
    /// A line that moves from one place to another.
    Turn([[Spot; 2]; 2]),
    Triangle([Spot; 3]),
    /// Many lines, one after the other.
    Path(Vec<Spot>),
    Bar {
        corner: Spot,
        extent: Spot,
    },
    Text {
        start: Spot,
        /// Thousandths of a pixel.
        size: i32,
        text: Box<str>,
    },
}

/// What something looks like; what is drawn first comes first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Look {
    /// A triangle of the mesh, by class of its smallest angle.
    Triangle(u8),
    /// A triangle that a walk has come by.
    Visited,
    /// A triangle that waits.
    WaitingTriangle,
    /// A triangle that the step is about.
    Face(Tone),
    /// Where a set was cut.
    Cut,
    /// The sweep line or circle.
    Sweep,
    /// An edge that waits.
    WaitingEdge,
    /// An edge of the mesh.
    Edge,
    /// A constraint.
    Segment,
    /// A piece of the front.
    Front,
    /// A line that the step is about.
    Trace(Tone),
    /// A line that has gone, or that is only thought of.
    Dashed(Tone),
    /// A vertex of the input.
    Vertex,
    /// A vertex that was added.
    Added,
    /// A vertex that waits.
    WaitingVertex,
    /// The center of a cluster.
    Cluster,
    /// The paper around the vertex whose turn it is, and the vertex.
    Casing,
    Considered,
    /// A vertex that the step is about.
    Ring(Tone),
    /// The side of the page beside the drawing.
    Panel,
    /// The line of pseudocode that runs.
    Running,
    /// How far the work has come.
    Track,
    Progress,
    /// Words.
    Faint,
    Plain,
    Strong,
}

/// What a mark says.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Tone {
    /// It is looked at.
    Asked,
    /// It has come, or may stay.
    Good,
    /// It goes, or must go.
    Bad,
}

/// How a mark is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Ink {
    pub fill: Option<Color>,
    /// Colour and width of the outline.
    pub line: Option<(Color, f32)>,
    pub is_dashed: bool,
    pub opacity: f32,
}

/// Sizes that depend on the page, and on how close vertices lie.
#[derive(Clone, Copy, Debug)]
pub(super) struct Detail {
    /// A pixel of a page of the usual size.
    pub unit: f32,
    /// From 0.3, dense, to 1, roomy.
    pub room: f32,
}

impl Detail {
    /// Returns the width of the dashes of a line.
    pub fn dash(self) -> f32 {
        8.0 * self.unit * self.room.max(0.5)
    }

    /// Returns the radius of the dot of a vertex.
    pub fn dot(self) -> f32 {
        4.6 * self.unit * self.room
    }

    /// Returns the radius of what is drawn around a vertex.
    pub fn ring(self) -> f32 {
        9.5 * self.unit * self.room.max(0.55)
    }
}

const BLUE: Color = Color([0.04, 0.40, 0.78]);
const RED: Color = REGION_COLORS[0];
const CYAN: Color = REGION_COLORS[1];
const MAGENTA: Color = REGION_COLORS[2];
const ORANGE: Color = REGION_COLORS[3];
const BROWN: Color = REGION_COLORS[4];
const GREY: Color = Color([0.45, 0.46, 0.50]);
const PALE: Color = Color([0.965, 0.965, 0.975]);

/// Colours unlike each other for the color-blind, too: light and dark, warm and cold.
fn tone(tone: Tone) -> Color {
    match tone {
        Tone::Asked => MAGENTA,
        Tone::Good => BLUE,
        Tone::Bad => RED,
    }
}

/// Mixes a share of a colour with paper.
fn pale(Color(color): Color, share: f32) -> Color {
    Color([0, 1, 2].map(|k| PAPER.0[k] + share * (color[k] - PAPER.0[k])))
}

impl Look {
    /// Tells how it is drawn.
    pub fn ink(self, detail: Detail) -> Ink {
        let wide = detail.unit * detail.room;
        let clear = detail.unit * detail.room.max(0.6);
        match self {
            Self::Triangle(class) => {
                let share = (f32::from(class) + 0.5) / f32::from(CLASSES);
                fill(pale(scale(share), TINT), 1.0)
            }
            Self::Visited => fill(CYAN, 0.22),
            Self::WaitingTriangle => fill(ORANGE, 0.45),
            Self::Face(t) => fill(tone(t), 0.26),
            Self::Cut => dashed(line(GREY, 1.6 * clear, 0.7)),
            Self::Sweep => line(CYAN, 5.0 * clear, 0.55),
            Self::WaitingEdge => line(ORANGE, 8.0 * clear, 0.75),
            Self::Edge => line(INK, 1.7 * wide, 0.85),
            Self::Segment => line(INK, 4.4 * wide, 1.0),
            Self::Front => line(CYAN, 4.6 * clear, 1.0),
            Self::Trace(t) => line(tone(t), 4.2 * clear, 1.0),
            Self::Dashed(t) => dashed(line(tone(t), 2.6 * clear, 1.0)),
            Self::Vertex => fill(INK, 1.0),
            Self::Added => fill(BROWN, 1.0),
            Self::WaitingVertex => line(ORANGE, 3.4 * clear, 1.0),
            Self::Cluster => fill(MAGENTA, 1.0),
            Self::Casing => fill(PAPER, 1.0),
            Self::Considered => fill(MAGENTA, 1.0),
            Self::Ring(t) => line(tone(t), 3.0 * clear, 1.0),
            Self::Panel => fill(PALE, 1.0),
            Self::Running => fill(pale(ORANGE, 0.38), 1.0),
            Self::Track => fill(pale(GREY, 0.3), 1.0),
            Self::Progress => fill(BLUE, 1.0),
            Self::Faint => line(GREY, 0.0, 1.0),
            Self::Plain | Self::Strong => line(INK, 0.0, 1.0),
        }
    }

    /// Returns the width of the strokes of letters, as a multiple of their size.
    pub fn weight(self) -> f32 {
        match self {
            Self::Strong => 1.05,
            _ => 0.76,
        }
    }
}

fn fill(color: Color, opacity: f32) -> Ink {
    Ink {
        fill: Some(color),
        line: None,
        is_dashed: false,
        opacity,
    }
}

fn line(color: Color, width: f32, opacity: f32) -> Ink {
    Ink {
        fill: None,
        line: Some((color, width)),
        is_dashed: false,
        opacity,
    }
}

fn dashed(ink: Ink) -> Ink {
    Ink {
        is_dashed: true,
        ..ink
    }
}

/// Returns the nearest place of tenths.
pub(super) fn spot(place: [f32; 2]) -> Spot {
    place.map(tenths)
}

/// Rounds a length to tenths.
pub(super) fn tenths(length: f32) -> i32 {
    (length * 10.0).round() as i32
}
