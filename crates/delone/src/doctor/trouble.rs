//! What can be wrong with a drawing, in words for programs.

use crate::{Listed, Point, Seed, VertexId};

/// How bad a trouble is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Severity {
    /// Triangulation refuses it, at least unless crossings are split.
    Error,
    /// There is a result, but perhaps not the one that was meant.
    Warning,
    /// The result is right; it may be good to know, or limit the quality of a mesh.
    Note,
}

/// A kind of trouble.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Kind {
    /// Two segments cross inside both. Refused unless crossings are split, or there is a vertex exactly there.
    Crossing,
    /// The seed of a hole or region lies on a segment.
    SeedOnSegment,
    /// An odd number of segments of a polygon end in a point.
    OpenPolygon,
    /// Two segments share more than a point; `at` and `to` are the ends of that.
    Overlap,
    /// A vertex lies inside a segment.
    VertexOnSegment,
    /// A segment joins equal points.
    ZeroLength,
    /// Two points are different, but within the tolerance.
    NearVertices,
    /// A vertex is within the tolerance of a segment, and sees its ends at an angle of 90° or more.
    NearSegment,
    /// A line ends near its beginning: it may be meant as a ring. Near is what is within the tolerance or, of
    /// three segments and more, less than half of the longest.
    UnclosedRing,
    /// A ring of a polygon meets a point twice.
    SelfTouch,
    /// A ring of a polygon does not lie directly in the first one, its outline.
    Misnested,
    /// The segments enclose nothing, or holes take all of it.
    Nothing,
    /// The seed of a hole or region lies outside the domain.
    SeedOutside,
    /// The seeds of two regions lie in the same.
    SeedTwice,
    /// Two segments meet at an angle below 1°.
    Needle,
    /// The extent is so small beside the coordinates that rounding is felt: below 2²⁴ units in the last place.
    FarAway,
    /// A point equals an earlier one.
    Duplicate,
    /// A segment equals an earlier one.
    Repeated,
    /// A line ends in nothing.
    OpenEnd,
    /// No segment ends in a point, though there are segments.
    LoosePoint,
    /// Two segments meet at an angle from 1° to below 20°.
    SharpCorner,
    /// The bounding box is a thousand times as long as wide, or more.
    Elongated,
}

impl Kind {
    /// All kinds, the worst first.
    pub const ALL: [Self; 22] = [
        Self::Crossing,
        Self::SeedOnSegment,
        Self::OpenPolygon,
        Self::Overlap,
        Self::VertexOnSegment,
        Self::ZeroLength,
        Self::NearVertices,
        Self::NearSegment,
        Self::UnclosedRing,
        Self::SelfTouch,
        Self::Misnested,
        Self::Nothing,
        Self::SeedOutside,
        Self::SeedTwice,
        Self::Needle,
        Self::FarAway,
        Self::Duplicate,
        Self::Repeated,
        Self::OpenEnd,
        Self::LoosePoint,
        Self::SharpCorner,
        Self::Elongated,
    ];

    /// Tells how bad it is.
    pub fn severity(self) -> Severity {
        match self {
            Self::Crossing | Self::SeedOnSegment | Self::OpenPolygon => Severity::Error,
            Self::Duplicate
            | Self::Repeated
            | Self::OpenEnd
            | Self::LoosePoint
            | Self::SharpCorner
            | Self::Elongated => Severity::Note,
            _ => Severity::Warning,
        }
    }

    /// Returns the name that programs know it by, such as `vertex_on_segment`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Crossing => "crossing",
            Self::SeedOnSegment => "seed_on_segment",
            Self::OpenPolygon => "open_polygon",
            Self::Overlap => "overlap",
            Self::VertexOnSegment => "vertex_on_segment",
            Self::ZeroLength => "zero_length",
            Self::NearVertices => "near_vertices",
            Self::NearSegment => "near_segment",
            Self::UnclosedRing => "unclosed_ring",
            Self::SelfTouch => "self_touch",
            Self::Misnested => "misnested",
            Self::Nothing => "nothing",
            Self::SeedOutside => "seed_outside",
            Self::SeedTwice => "seed_twice",
            Self::Needle => "needle",
            Self::FarAway => "far_away",
            Self::Duplicate => "duplicate",
            Self::Repeated => "repeated",
            Self::OpenEnd => "open_end",
            Self::LoosePoint => "loose_point",
            Self::SharpCorner => "sharp_corner",
            Self::Elongated => "elongated",
        }
    }
}

/// One trouble: who has part in it, and where it is.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Trouble {
    /// The points that have part in it; of a duplicate, the later one first.
    pub points: Vec<VertexId>,
    /// The segments, by index; of a repeated one, the later one first.
    pub segments: Vec<usize>,
    /// The polygon, if it is about one.
    pub polygon: Option<usize>,
    /// The seeds of holes and regions.
    pub seeds: Vec<Seed>,
    /// Where it is; `None` if it is about the whole.
    pub at: Option<Point>,
    /// Where it ends, if it has an extent.
    pub to: Option<Point>,
    /// A distance, rounded up; of corners, an angle in degrees; a ratio, of what is far away or elongated.
    pub size: Option<f64>,
}

/// What has been found.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Diagnosis {
    /// The kinds of which there is something, the worst first.
    pub troubles: Vec<(Kind, Listed<Trouble>)>,
    /// Corners between neighbouring segments below 60°, sharper ones included: there, no triangle can have its
    /// angles above that.
    pub corners_below_60: u64,
    /// The sharpest corner of all.
    pub sharpest: Option<Trouble>,
    /// Whether the domain was asked for its seeds: not where segments meet more than ten times as often as
    /// there are segments, which takes too long to triangulate.
    pub is_domain_known: bool,
    /// A tolerance that would close the gaps that look like mistakes, if there are some.
    pub suggestion: Option<f64>,
}

impl Diagnosis {
    /// Counts what is so bad.
    pub fn count(&self, severity: Severity) -> u64 {
        let all = self.troubles.iter();
        let such = all.filter(|(kind, _)| kind.severity() == severity);
        such.map(|(_, listed)| listed.count).sum()
    }

    /// Counts what is of a kind.
    pub fn count_of(&self, kind: Kind) -> u64 {
        self.of(kind).map_or(0, |listed| listed.count)
    }

    /// Returns what is of a kind, if there is something.
    pub fn of(&self, kind: Kind) -> Option<&Listed<Trouble>> {
        let mut all = self.troubles.iter();
        all.find(|(k, _)| *k == kind).map(|(_, listed)| listed)
    }

    /// Tells whether there are neither errors nor warnings.
    pub fn is_healthy(&self) -> bool {
        self.count(Severity::Error) + self.count(Severity::Warning) == 0
    }

    pub(super) fn add(&mut self, kind: Kind, listed: Listed<Trouble>) {
        if listed.count > 0 {
            self.troubles.push((kind, listed));
        }
    }

    pub(super) fn add_all(&mut self, kind: Kind, mut troubles: Vec<Trouble>, limit: usize) {
        let count = troubles.len() as u64;
        troubles.truncate(limit);
        let first = troubles;
        self.add(kind, Listed { count, first });
    }
}
