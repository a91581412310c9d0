//! A mesh of given triangles: ghosts close it to a sphere.

use crate::{Error, HalfEdgeId, Mesh, TriangleId, VertexId};
use std::collections::HashMap;

/// Makes the mesh of triangles that cover a polygon without holes.
///
/// # Errors
/// [`Error::SameSide`] names triangles that lie on one side of an edge; [`Error::BadStart`] one at which the outline
/// is no simple cycle.
///
/// *Cost*: linear.
pub(super) fn mesh_of(triangles: &[[VertexId; 3]]) -> Result<Mesh, Error> {
    let mut by_edge: HashMap<[VertexId; 2], HalfEdgeId> =
        HashMap::with_capacity(3 * triangles.len());
    for (t, &[a, b, c]) in triangles.iter().enumerate() {
        let half_edges = TriangleId::new(t).half_edges();
        for (edge, h) in [[b, c], [c, a], [a, b]].into_iter().zip(half_edges) {
            if let Some(other) = by_edge.insert(edge, h) {
                let triangles = [other.triangle().index(), t];
                return Err(Error::SameSide { triangles, edge });
            }
        }
    }
    let mut corners = triangles.to_vec();
    let mut twins: Vec<_> = (0..triangles.len())
        .map(|t| TriangleId::new(t).half_edges())
        .collect();
    // The ghost at the boundary edge that starts at each vertex.
    let mut ghosts: HashMap<VertexId, TriangleId> = HashMap::new();
    for (t, &[a, b, c]) in triangles.iter().enumerate() {
        for (k, [from, to]) in [[b, c], [c, a], [a, b]].into_iter().enumerate() {
            if let Some(&twin) = by_edge.get(&[to, from]) {
                twins[t][k] = twin;
                continue;
            }
            let ghost = TriangleId::new(corners.len());
            corners.push([to, from, VertexId::INFINITE]);
            let [from_out, in_to, base] = ghost.half_edges();
            twins.push([from_out, in_to, TriangleId::new(t).half_edges()[k]]);
            twins[t][k] = base;
            if ghosts.insert(from, ghost).is_some() {
                let why = "the outline passes twice through one of its corners";
                return Err(Error::BadStart { triangle: t, why });
            }
        }
    }
    let mut first = None;
    for (triangle, &[to, ..]) in corners.iter().enumerate().skip(triangles.len()) {
        let this = TriangleId::new(triangle);
        let next = *ghosts.get(&to).expect("bug: an outline is closed");
        // From infinity to `to` in this ghost, and back in the next.
        let (inwards, outwards) = (this.half_edges()[1], next.half_edges()[0]);
        twins[triangle][1] = outwards;
        twins[next.index()][0] = inwards;
        first.get_or_insert(this);
    }
    let cycle = first.map_or(0, |first| {
        let mut length = 1;
        let mut at = twins[first.index()][1].triangle();
        while at != first {
            length += 1;
            at = twins[at.index()][1].triangle();
        }
        length
    });
    if cycle != corners.len() - triangles.len() {
        let why = "the triangles have several outlines: parts of their own, or holes";
        return Err(Error::BadStart { triangle: 0, why });
    }
    Ok(Mesh::from_rows(corners, twins))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::triangulate;

    fn v(corners: [usize; 3]) -> [VertexId; 3] {
        corners.map(VertexId::new)
    }

    #[test]
    fn the_mesh_of_a_triangulation_is_its_own() {
        let points = (0..40).map(|i| (f64::from(i * 37 % 41), f64::from(i * 11 % 17)));
        let t = triangulate(points).unwrap();
        let mesh = mesh_of(t.triangles()).unwrap();
        mesh.validate().expect("a sphere");
        assert_eq!(mesh.num_faces(), t.mesh().num_faces());
        assert_eq!(&mesh.faces()[..t.num_triangles()], t.triangles());
    }

    #[test]
    fn outlines_that_are_no_single_cycle_are_refused() {
        let apart = [v([0, 1, 2]), v([3, 4, 5])];
        assert!(matches!(mesh_of(&apart), Err(Error::BadStart { .. })));
        let pinched = [v([0, 1, 2]), v([0, 3, 4])];
        assert!(matches!(mesh_of(&pinched), Err(Error::BadStart { .. })));
        let twice = [v([0, 1, 2]), v([0, 1, 3])];
        assert!(matches!(mesh_of(&twice), Err(Error::SameSide { .. })));
    }
}
