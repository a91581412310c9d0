//! A mesh from triangles that somebody else has found.

use super::{Board, ascending, sides};
use crate::{Mesh, Observer, TriangleId, VertexId};
use std::collections::BTreeSet;

impl<O: Observer> Board<'_, O> {
    /// Takes over triangles, of which everything has been told: they must cover a convex polygon, all
    /// counter-clockwise.
    ///
    /// *Cost*: O(n log n).
    pub fn adopt(&mut self, triangles: &[[VertexId; 3]]) {
        let mut faces = triangles.to_vec();
        faces.extend(ghosts_of(triangles));
        self.take(closed(&faces), BTreeSet::new(), Vec::new());
    }
}

/// One ghost for each edge that has a triangle on one side only.
fn ghosts_of(triangles: &[[VertexId; 3]]) -> Vec<[VertexId; 3]> {
    let mut edges: Vec<_> = triangles.iter().copied().flat_map(sides).collect();
    edges.sort_unstable();
    let is_rim = |&&[a, b]: &&[VertexId; 2]| edges.binary_search(&[b, a]).is_err();
    let rim = edges.iter().filter(is_rim);
    rim.map(|&[a, b]| [b, a, VertexId::INFINITE]).collect()
}

/// The sides of a face, each opposite its corner, as half-edges are.
fn opposites([a, b, c]: [VertexId; 3]) -> [[VertexId; 2]; 3] {
    sides([b, c, a])
}

/// Makes the mesh of faces that close a sphere.
fn closed(faces: &[[VertexId; 3]]) -> Mesh {
    let mut mesh = Mesh::default();
    let ids: Vec<TriangleId> = faces.iter().map(|&face| mesh.push_face(face)).collect();
    let half_edges = ids.iter().flat_map(|t| t.half_edges());
    let ends = faces.iter().copied().flat_map(opposites).map(ascending);
    let mut sides: Vec<_> = ends.zip(half_edges).collect();
    sides.sort_unstable();
    for pair in sides.chunks_exact(2) {
        mesh.bond(pair[0].1, pair[1].1);
    }
    mesh
}
