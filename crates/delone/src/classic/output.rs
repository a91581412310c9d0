//! What an algorithm hands out.

use super::ascending;
use crate::{
    ConstrainedTriangulation, Duplicate, Failure, Point, TriangulationHash, VertexId,
    hash_triangles,
};

/// Triangles, over the points of the input and those that were added.
///
/// | field | filled by |
/// |---|---|
/// | `points`, `duplicates` | all; only those that [refine](super::Algorithm::refines) or take data add points |
/// | `triangles` | all but [`ConvexHull`](super::Algorithm::ConvexHull) |
/// | `constrained` | all that take segments |
/// | `hull` | only `ConvexHull` |
/// | `failures` | only [`PrintedSweep`](super::Algorithm::PrintedSweep), which may name segments in `constrained` that it lost |
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Output {
    /// The points of the input, in its order, then those that were added.
    pub points: Vec<Point>,
    /// The triangles, counter-clockwise.
    pub triangles: Vec<[VertexId; 3]>,
    /// The edges that are constraints, smaller end first, sorted.
    pub constrained: Vec<[VertexId; 2]>,
    /// The points on the boundary of the convex hull, counter-clockwise.
    pub hull: Vec<VertexId>,
    /// What goes wrong, if the algorithm is replayed as it was printed.
    pub failures: Vec<Failure>,
    /// Points that equal an earlier one, which stands for them.
    pub duplicates: Vec<Duplicate>,
}

impl Output {
    /// Takes over what the engine has made of a domain.
    pub(super) fn of_domain(mesh: &ConstrainedTriangulation) -> Self {
        let mut constrained: Vec<_> = mesh.constrained_edges().map(ascending).collect();
        constrained.sort_unstable();
        let t = mesh.triangulation();
        Self {
            points: t.points().to_vec(),
            triangles: t.triangles().to_vec(),
            constrained,
            duplicates: t.duplicates().to_vec(),
            ..Self::default()
        }
    }

    /// Hashes the triangles, as [`Triangulation::hash`](crate::Triangulation::hash) does.
    pub fn hash(&self) -> TriangulationHash {
        let point = |v: VertexId| self.points[v.index()];
        hash_triangles(self.triangles.iter().map(|t| t.map(point)))
    }
}
