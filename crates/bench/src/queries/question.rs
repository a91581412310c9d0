//! What is asked.

use std::fmt;
use std::str::FromStr;

/// What is asked about each point, or done with it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Question {
    /// In which triangle, on which edge or vertex it lies.
    Locate,
    /// Which vertex is nearest.
    Nearest,
    /// Which ten are.
    TenNearest,
    /// The cells of the Voronoi diagram.
    Voronoi,
    /// The value of the surface that is flat over each triangle.
    Linear,
    /// That of natural neighbours, after Sibson.
    Natural,
    /// That of Clough and Tocher, smooth.
    CloughTocher,
    /// Insert vertices in random order.
    Insert,
    /// Insert vertices, each near the one before.
    InsertNear,
    /// Remove vertices in random order.
    Remove,
    /// Remove vertices, each near the one before.
    RemoveNear,
    /// Move vertices to anywhere.
    Move,
    /// Move vertices by a tenth of the way to the nearest.
    Nudge,
    /// Insert vertices, each near the one before, and undo it all.
    Undo,
}

/// How many of [`Question::TenNearest`].
pub const TEN: usize = 10;

/// So many answers are compared; the slowest are asked no more.
pub const COMPARED: usize = 20_000;

/// Questions whose tables stand together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Room {
    /// Where points lie, and what is near.
    Places,
    /// Cells of sites.
    Cells,
    /// Values between vertices.
    Surfaces,
    /// Vertices that come, go and move.
    Edits,
}

impl Question {
    /// All of them, in the order of the tables.
    pub const ALL: [Self; 14] = [
        Self::Locate,
        Self::Nearest,
        Self::TenNearest,
        Self::Voronoi,
        Self::Linear,
        Self::Natural,
        Self::CloughTocher,
        Self::Insert,
        Self::InsertNear,
        Self::Remove,
        Self::RemoveNear,
        Self::Move,
        Self::Nudge,
        Self::Undo,
    ];

    /// Returns the name by which commands and tables call it.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Locate => "locate",
            Self::Nearest => "nearest",
            Self::TenNearest => "ten-nearest",
            Self::Voronoi => "voronoi",
            Self::Linear => "linear",
            Self::Natural => "natural",
            Self::CloughTocher => "clough-tocher",
            Self::Insert => "insert",
            Self::InsertNear => "insert-near",
            Self::Remove => "remove",
            Self::RemoveNear => "remove-near",
            Self::Move => "move",
            Self::Nudge => "nudge",
            Self::Undo => "undo",
        }
    }

    /// Returns by which part what answers come to may differ: by rounding; and gradients are sought until they
    /// change by a millionth.
    pub const fn slack(self) -> f64 {
        match self {
            Self::CloughTocher => 1e-6,
            _ => 1e-9,
        }
    }

    /// Returns where its table stands.
    pub const fn room(self) -> Room {
        match self {
            Self::Locate | Self::Nearest | Self::TenNearest => Room::Places,
            Self::Voronoi => Room::Cells,
            Self::Linear | Self::Natural | Self::CloughTocher => Room::Surfaces,
            Self::Insert
            | Self::InsertNear
            | Self::Remove
            | Self::RemoveNear
            | Self::Move
            | Self::Nudge
            | Self::Undo => Room::Edits,
        }
    }
}

impl Room {
    /// All of them, in the order of the tables.
    pub const ALL: [Self; 4] = [Self::Places, Self::Cells, Self::Surfaces, Self::Edits];

    /// Returns the title of its tables.
    pub const fn title(self) -> &'static str {
        match self {
            Self::Places => "Where points lie, and what is nearest",
            Self::Cells => "Voronoi diagrams",
            Self::Surfaces => "Values between vertices",
            Self::Edits => "Edits",
        }
    }

    /// Says what times are for.
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Places | Self::Surfaces => "a query",
            Self::Cells => "a site",
            Self::Edits => "an edit",
        }
    }
}

impl fmt::Display for Question {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

impl FromStr for Question {
    type Err = String;

    fn from_str(name: &str) -> Result<Self, Self::Err> {
        let found = Self::ALL.into_iter().find(|q| q.name() == name);
        found.ok_or_else(|| {
            let names = Self::ALL.map(Self::name).join(", ");
            format!("nobody can be asked `{name}`; there are {names}")
        })
    }
}

/// Returns the square of the distance, as everybody rounds it.
pub fn square(p: [f64; 2], q: [f64; 2]) -> f64 {
    let [x, y] = [p[0] - q[0], p[1] - q[1]];
    x * x + y * y
}
