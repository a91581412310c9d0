//! What refinement has reached, and what not, and why.

use crate::{Angle, Broken, Quality, TriangleId, VertexId};

/// Why refinement stopped.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Outcome {
    /// Nothing is left that may be improved: every triangle meets the bounds, or has an
    /// [excuse](Reason::is_excused).
    Complete,
    /// The [`Budget`](crate::Budget) is used up.
    BudgetExhausted,
    /// Triangles are left that could be improved only with vertices closer together than coordinates
    /// or the input's own features allow.
    PrecisionLimit,
    /// The watch cancelled.
    Cancelled,
    /// The [strategy of the thesis](crate::Strategy::Thesis) has opened skinny triangles until they became
    /// too small, or edges too long: the mesh from before that, with its smallest angle, is the result.
    FellBack,
}

/// Why a triangle does not meet the bounds.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Reason {
    /// Two segments of the input meet at less than 60 degrees: the triangle has their corner, or its
    /// shortest edge joins them.
    SmallInputAngle {
        /// The corner where they meet.
        vertex: VertexId,
        /// The two segments of the input.
        segments: [usize; 2],
        /// The angle between them.
        angle: Angle,
    },
    /// One of its edges is locked, that is, lies on a boundary that must not be split; or its path of
    /// longest edges ends at a locked one.
    ///
    /// The path leads across the longest edge into the triangle beyond, and from there across the longest
    /// edge again, as long as edges get longer; of equally long ones it takes that opposite the
    /// lexicographically smallest corner. A triangle with a locked edge ab has another that is at least half
    /// as long, the one beyond that edge has one of at least a quarter, and so on: near long locked edges
    /// some triangles have to be large, or skinny, that do not touch them. Those hang on the locked edge by
    /// such a path. Where it ends at any other edge, that could be split.
    LockedBoundary,
    /// Coordinates have no room for another vertex: its shortest edge is below 2¹² units in the last
    /// place of its largest coordinate; or, next to zero, where these are finer than that, below 2⁻²⁴⁸ (if the
    /// largest coordinate of the mesh is below 1e-30 or from 1e30 on: of that).
    Precision,
    /// Another vertex would be far closer to others than the features of the input are.
    Gradation,
    /// The work stopped before its turn.
    Stopped,
}

impl Reason {
    /// Tells whether the input, or what was asked for, forbids a better triangle; such a triangle does
    /// not make a mesh incomplete.
    pub fn is_excused(self) -> bool {
        matches!(
            self,
            Self::SmallInputAngle { .. } | Self::LockedBoundary | Self::Precision
        )
    }
}

/// A triangle that does not meet the bounds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unmet {
    /// The triangle.
    pub triangle: TriangleId,
    /// What it breaks.
    pub broken: Broken,
    /// Its smallest angle.
    pub min_angle: Angle,
    /// Why it was left so.
    pub reason: Reason,
}

/// What refinement has reached.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Report {
    /// Why it stopped.
    pub outcome: Outcome,
    /// What was asked for.
    pub asked: Quality,
    /// The triangles that do not meet the bounds, ascending.
    pub unmet: Vec<Unmet>,
    /// Vertices added on segments.
    pub on_segments: usize,
    /// Vertices added elsewhere.
    pub free: usize,
}

impl Report {
    /// Counts the unmet triangles that nothing excuses. *Cost*: linear in the unmet triangles.
    pub fn num_unexcused(&self) -> usize {
        let excused = self.unmet.iter().filter(|u| u.reason.is_excused());
        self.unmet.len() - excused.count()
    }
}
