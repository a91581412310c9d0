//! What a verification of quality comes to.

use super::super::super::{Certificate, Shape};
use super::Excuse;
use crate::{Broken, TriangleId, VertexId};

/// A triangle that breaks a bound.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unmet {
    /// The triangle.
    pub triangle: TriangleId,
    /// What it breaks.
    pub broken: Broken,
    /// Its angles, lengths and area.
    pub shape: Shape,
    /// What excuses all that it breaks, if anything does.
    pub excuse: Option<Excuse>,
}

/// A subsegment with a vertex inside its diametral circle that sees it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Encroached {
    /// Its ends, as the triangle of the vertex runs through them.
    pub edge: [VertexId; 2],
    /// The vertex.
    pub apex: VertexId,
    /// What excuses that it was not split: [`Locked`](Excuse::Locked), or [`Precision`](Excuse::Precision) if
    /// the vertex is nearer to it than 2¹² units in the last place of their largest coordinate, for then
    /// there is no room for another vertex between.
    pub excuse: Option<Excuse>,
}

/// How many of the unmet triangles have which excuse.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Those without any.
    pub unexcused: usize,
    /// Those at small angles of the input.
    pub small_input_angle: usize,
    /// Those at a boundary that must not be split.
    pub locked: usize,
    /// Those where coordinates have no room.
    pub precision: usize,
}

/// A refined mesh that has been proven right, and how good it is.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
#[must_use = "a verdict may say that bounds are not met"]
pub struct QualityVerdict {
    /// The numbers of the mesh.
    pub certificate: Certificate,
    /// The triangles that break a bound: first those without an excuse, and of either kind first those
    /// with the smallest angles.
    pub unmet: Vec<Unmet>,
    /// If [conforming](super::Asked::conforming) was asked for, the subsegments that are encroached upon,
    /// first those without an excuse.
    pub encroached: Vec<Encroached>,
    /// Steiner points on segments that had to stay as they were.
    pub on_locked: Vec<VertexId>,
}

impl QualityVerdict {
    /// Counts the unmet triangles by their excuses.
    pub fn counts(&self) -> Counts {
        let mut counts = Counts::default();
        for unmet in &self.unmet {
            *match unmet.excuse {
                None => &mut counts.unexcused,
                Some(Excuse::SmallInputAngle { .. }) => &mut counts.small_input_angle,
                Some(Excuse::Locked) => &mut counts.locked,
                Some(Excuse::Precision) => &mut counts.precision,
            } += 1;
        }
        counts
    }

    /// Tells whether all that was asked for is there, or has an excuse.
    pub fn is_met(&self) -> bool {
        self.unmet.iter().all(|unmet| unmet.excuse.is_some())
            && self.encroached.iter().all(|e| e.excuse.is_some())
            && self.on_locked.is_empty()
    }
}
