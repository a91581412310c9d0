//! What the mesh is like in the end, and which triangles do not meet the bounds.

use crate::refine::{Outcome, Report, reasons};
use crate::tables::{Shape, length};
use crate::{
    Broken, ConstrainedTriangulation, HalfEdgeId, Locked, Origin, Quality, TriangleId, VertexId,
};

/// Reports on a mesh that was made for `asked`.
pub(super) fn report(mesh: &ConstrainedTriangulation, asked: Quality, outcome: Outcome) -> Report {
    let t = mesh.triangulation();
    let first = t.points().len() - mesh.num_steiner();
    let added = (first..t.points().len()).map(VertexId::new);
    let free = added.filter(|&v| mesh.origin(v) == Origin::Free).count();
    let triangles = (0..t.num_triangles()).map(TriangleId::new);
    let unmet = triangles.map(|t| (t, broken(mesh, asked, t)));
    let unmet = unmet.filter(|&(_, broken)| broken != Broken::default());
    Report {
        outcome,
        asked,
        unmet: reasons::explain(mesh, unmet.collect(), Locked::Nothing, true),
        on_segments: mesh.num_steiner() - free,
        free,
    }
}

/// Judges a triangle by the same numbers as the algorithm.
fn broken(mesh: &ConstrainedTriangulation, asked: Quality, triangle: TriangleId) -> Broken {
    let (t, topology) = (mesh.triangulation(), mesh.triangulation().mesh());
    let lengths = triangle.half_edges().map(|h: HalfEdgeId| {
        let [a, b] = [topology.origin(h), topology.dest(h)].map(|v| t.point(v));
        length(a, b)
    });
    let shape = Shape::of(lengths);
    let is_skinny = |angle: crate::Angle| shape.cosine > libm::cos(angle.to_radians());
    Broken {
        angle: asked.min_angle.is_some_and(is_skinny),
        edge: asked.max_edge.is_some_and(|l| lengths[shape.longest] > l),
        area: false,
    }
}
