//! What a table must say of each engine at each task: how exact it is, what part of the plane it
//! triangulates, what is timed.

use super::Engine;
use crate::subject::Task;

/// What a table must say of an engine at a task.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Facts {
    /// Are the predicates exact, and on the caller's own coordinates?
    pub exact: bool,
    /// What part of the plane is triangulated.
    pub extent: Extent,
    /// What is called, and what it hands out.
    pub timed: &'static str,
}

/// What part of the plane an engine triangulates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Extent {
    /// The convex hull.
    Hull,
    /// The inside of a ring; of segments that are no ring, the convex hull.
    InsideRings,
    /// The inside of a ring, and it takes nothing but rings.
    OnlyRings,
}

const fn facts(exact: bool, extent: Extent, timed: &'static str) -> Option<Facts> {
    Some(Facts {
        exact,
        extent,
        timed,
    })
}

impl Engine {
    /// Returns what a table must say of the engine at `task`, if it can do that at all.
    pub const fn facts(self, task: Task) -> Option<Facts> {
        match task {
            Task::Points => self.facts_on_points(),
            Task::Domain => self.facts_on_domains(),
            Task::Crossings => self.facts_on_crossings(),
        }
    }

    const fn facts_on_points(self) -> Option<Facts> {
        use Extent::Hull;
        match self {
            Self::Delone { .. } => facts(
                true,
                Hull,
                "`Delaunay::triangulate`: triangles and neighbours, caller's numbering",
            ),
            Self::Spade => facts(
                true,
                Hull,
                "`bulk_load`: half-edges, own vertex numbering; takes the points over",
            ),
            Self::SpadeStable => facts(
                true,
                Hull,
                "`bulk_load_stable`: half-edges, caller's numbering; takes the points over",
            ),
            Self::Delaunator => facts(
                false,
                Hull,
                "`triangulate`: triangles and half-edges, caller's numbering",
            ),
            Self::Cdt => facts(
                true,
                Hull,
                "`triangulate_points`: triangles only, caller's numbering",
            ),
            Self::SimpleDelaunay => facts(
                true,
                Hull,
                "`insert_vertices` along a Hilbert curve: half-edges, caller's numbering",
            ),
            Self::ITriangle | Self::Poly2Tri | Self::Ghx => None,
        }
    }

    const fn facts_on_domains(self) -> Option<Facts> {
        use Extent::{Hull, InsideRings, OnlyRings};
        match self {
            Self::Delone { .. } => facts(
                true,
                Hull,
                "`ConstrainedDelaunay::triangulate`, crossings refused: triangles, neighbours \
                 and constrained edges of the hull, caller's numbering",
            ),
            Self::Spade => facts(
                true,
                Hull,
                "`bulk_load_cdt`: half-edges and constrained edges of the hull, caller's \
                 numbering; takes points and segments over",
            ),
            Self::Cdt => facts(
                true,
                OnlyRings,
                "`triangulate_with_edges`: triangles of the inside only, caller's numbering",
            ),
            Self::ITriangle => facts(
                false,
                OnlyRings,
                "`triangulate().into_delaunay()`: triangles and neighbours of the inside, on a \
                 lattice of 32 bits, own numbering",
            ),
            Self::Poly2Tri => facts(
                false,
                OnlyRings,
                "`Sweeper::triangulate`: triangles of the inside, as points",
            ),
            Self::Ghx => facts(
                false,
                InsideRings,
                "`constrained_triangulation_from_2d_vertices`: triangles only (of a ring those \
                 inside), caller's numbering",
            ),
            Self::SpadeStable | Self::Delaunator | Self::SimpleDelaunay => None,
        }
    }

    const fn facts_on_crossings(self) -> Option<Facts> {
        match self {
            Self::Delone { .. } => facts(
                true,
                Extent::Hull,
                "`ConstrainedDelaunay::triangulate`, crossings split: triangles, neighbours, \
                 constrained edges and lineage, caller's numbering",
            ),
            Self::Spade => facts(
                true,
                Extent::Hull,
                "`bulk_load_cdt` of the points, then `add_constraint_and_split` segment by segment: \
                 half-edges and constrained edges, caller's numbering",
            ),
            _ => None,
        }
    }
}
