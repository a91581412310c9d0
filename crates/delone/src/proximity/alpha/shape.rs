//! The shape of one radius: its triangles, its boundary as rings, and what has no triangle.

use super::AlphaShapes;
use crate::{Error, HalfEdgeId, TriangleId, VertexId};

/// The alpha shape of one radius.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct AlphaShape {
    /// The triangles of [`Proximity::triangulation`](super::Proximity::triangulation) that belong to it,
    /// ascending.
    pub triangles: Vec<TriangleId>,
    /// The boundary of their union: closed rings with the triangles to the left, so outer ones are
    /// counter-clockwise and holes clockwise. Each edge with a triangle on one side only occurs once.
    /// Where parts of the shape meet in one vertex the rings stay apart, but may both pass it, or one of
    /// them may twice.
    pub boundary: Vec<Vec<VertexId>>,
    /// Edges with no triangle on either side, lower end first, sorted.
    pub singular_edges: Vec<[VertexId; 2]>,
    /// Vertices with no edge, ascending.
    pub singular_vertices: Vec<VertexId>,
}

/// Collects the shape of radius `alpha`.
pub(super) fn of_radius(shapes: &AlphaShapes, alpha: f64) -> Result<AlphaShape, Error> {
    let proximity = shapes.proximity;
    let mut pace = proximity.pace();
    let mut singular_edges = Vec::new();
    let mut is_touched = vec![false; proximity.triangulation.points().len()];
    let mesh = proximity.triangulation.mesh();
    let is_inside = |h: HalfEdgeId| {
        let face = h.triangle();
        shapes.faces[face.index()] <= alpha && !mesh.is_ghost(face)
    };
    for &(h, radius) in &shapes.edges {
        pace.step()?;
        if radius <= alpha {
            let ends = proximity.undirected(h);
            ends.iter().for_each(|v| is_touched[v.index()] = true);
            if !is_inside(h) && !is_inside(mesh.twin(h)) {
                singular_edges.push(ends);
            }
        }
    }
    singular_edges.sort_unstable();
    for d in proximity.triangulation.duplicates() {
        is_touched[d.dropped.index()] = true;
    }
    let vertices = (0..is_touched.len()).filter(|&v| !is_touched[v]);
    let rows = (0..shapes.faces.len()).map(TriangleId::new);
    Ok(AlphaShape {
        triangles: rows.filter(|t| is_inside(t.half_edges()[0])).collect(),
        boundary: rings(shapes, is_inside, &mut || pace.step())?,
        singular_edges,
        singular_vertices: vertices.map(VertexId::new).collect(),
    })
}

/// Walks along the boundary of the faces inside.
///
/// ```text
///        outside /        h comes to v; the ring goes on along the last half-edge of the fan of
///   ----h-----> v ---->   faces inside to its left, clockwise about v from h.
///      inside    inside
/// ```
fn rings(
    shapes: &AlphaShapes,
    is_inside: impl Fn(HalfEdgeId) -> bool,
    step: &mut dyn FnMut() -> Result<(), Error>,
) -> Result<Vec<Vec<VertexId>>, Error> {
    let mesh = shapes.proximity.triangulation.mesh();
    let is_border = |h| is_inside(h) && !is_inside(mesh.twin(h));
    let mut is_done = vec![false; 3 * mesh.num_faces()];
    let mut rings = Vec::new();
    for first in mesh.half_edges() {
        if is_done[first.index()] || !is_border(first) {
            continue;
        }
        let mut ring = Vec::new();
        let mut h = first;
        while !is_done[h.index()] {
            step()?;
            is_done[h.index()] = true;
            ring.push(mesh.origin(h));
            h = h.next();
            while !is_border(h) {
                step()?;
                h = mesh.twin(h).next();
            }
        }
        rings.push(ring);
    }
    Ok(rings)
}
