//! One vertex more: where it lies says which edit puts it in, and flips do the rest.
//!
//! Lawson, *Software for C¹ surface interpolation*, 1977. Only edges opposite to the new vertex can
//! have ceased to be Delaunay; edges that are locked stay, and hide from the vertex what lies behind
//! them, so a constrained Delaunay triangulation stays one.
//!
//! Ghosts make most cases disappear. A ghost on the hull edge ab is in conflict with p if p lies
//! strictly outside ab, or on the line strictly between a and b. The second means that p splits the
//! edge; so does any point on an edge. By the first, a point outside the hull splits a ghost, also
//! one off the line of collinear vertices, and legalising does the rest. Only two things are done
//! by hand: the first two points, and a point beyond the end of a row.

use crate::locate::Location;
use crate::predicates::{Orientation, in_circle_perturbed, orient2d};
use crate::{HalfEdgeId, Mesh, Point, TriangleId, VertexId};

/// A triangulation that takes in single vertices: the edits of its mesh, each with whatever is kept
/// beside it.
pub(crate) trait Growing {
    /// Returns the mesh.
    fn mesh(&self) -> &Mesh;
    /// Returns where a vertex lies.
    fn point(&self, v: VertexId) -> Point;
    /// Tells whether the edge of `h` must stay.
    fn is_locked(&self, h: HalfEdgeId) -> bool;
    /// As [`Mesh::split_face`].
    fn split_face(&mut self, t: TriangleId, v: VertexId) -> [HalfEdgeId; 3];
    /// As [`Mesh::split_edge`].
    fn split_edge(&mut self, h: HalfEdgeId, v: VertexId) -> [HalfEdgeId; 4];
    /// As [`Mesh::open_edge`].
    fn open_edge(&mut self, h: HalfEdgeId, v: VertexId) -> [HalfEdgeId; 2];
    /// As [`Mesh::flip`].
    fn flip(&mut self, h: HalfEdgeId);
}

/// Makes `v` part of the mesh and legalises; `at` is where its point lies. Returns a half-edge opposite
/// to it, or the vertex that lies there already. `suspects` is room to work in.
pub(crate) fn insert(
    t: &mut impl Growing,
    at: Location,
    v: VertexId,
    suspects: &mut Vec<HalfEdgeId>,
) -> Result<HalfEdgeId, VertexId> {
    match at {
        Location::Vertex(there) => return Err(there),
        Location::Face(face) => suspects.extend(t.split_face(face, v)),
        Location::Outside(h) => suspects.extend(t.split_face(h.triangle(), v)),
        Location::Edge(h) => suspects.extend(t.split_edge(h, v)),
        Location::Beyond(h) => suspects.extend(t.open_edge(h, v)),
        Location::Carved(_) | Location::Apart => {
            unreachable!("bug: a mesh with vertices and without a domain")
        }
    }
    Ok(legalise(t, t.point(v), suspects))
}

/// Flips until no face is in conflict with the new vertex, which lies at `p`.
///
/// ```text
///         p                 p
///        / \               /|\       p is the apex of h = ab. If the face beyond is in
///       /   \             / | \      conflict with p, p gets its corner d, and the edges ad
///      a --h- b    →     a  |  b     and db become suspect.
///       \   /             \ | /
///        \ /               \|/
///         d                 d
/// ```
fn legalise(t: &mut impl Growing, p: Point, suspects: &mut Vec<HalfEdgeId>) -> HalfEdgeId {
    let mut last = suspects[0];
    while let Some(h) = suspects.pop() {
        let twin = t.mesh().twin(h);
        if !t.is_locked(h) && conflicts(t, twin.triangle(), p) {
            t.flip(h);
            suspects.extend([h, twin.prev()]);
        }
        last = h;
    }
    last
}

/// Tells whether `face` cannot stay when there is a vertex at `p`, which lies on no hull edge: placing
/// it there has split that edge and its ghost.
fn conflicts(t: &impl Growing, face: TriangleId, p: Point) -> bool {
    let mesh = t.mesh();
    if mesh.is_ghost(face) {
        let h = mesh.hull_edge_of(face);
        let [a, b] = [mesh.origin(h), mesh.dest(h)].map(|v| t.point(v));
        orient2d(a, b, p) == Orientation::Left
    } else {
        let [a, b, c] = mesh.corners(face).map(|v| t.point(v));
        in_circle_perturbed(a, b, c, p)
    }
}
