//! A mesh from triangles that somebody else has found, and flips wherever they are needed.

use super::Board;
use super::joining::Restoring;
use crate::observe::{Item, Queue};
use crate::{Event, HalfEdgeId, Mesh, Observer, TriangleId, VertexId};
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

    /// Flips edges until all are locally Delaunay, wherever they are (Lawson).
    pub fn mend(&mut self, lines: Restoring) {
        self.at(lines.push);
        let mut suspects = Vec::new();
        for h in self.mesh().half_edges() {
            let twin = self.mesh().twin(h);
            let is_inner = [h, twin]
                .iter()
                .all(|s| !self.mesh().is_ghost(s.triangle()));
            if h < twin && is_inner {
                self.suspect(&mut suspects, h);
            }
        }
        while let Some((h, edge)) = suspects.pop() {
            self.at(lines.pop);
            let (queue, item) = (Queue::Suspects, Item::Edge(edge));
            self.tell(|| Event::Popped { queue, item });
            self.at(lines.examine);
            // A flip beside it gives an edge another half-edge, which then waits, too.
            if ascending(self.ends(h)) != edge || self.is_locally_delaunay(h) {
                continue;
            }
            let twin = self.mesh().twin(h);
            self.at(lines.flip);
            self.flip(h);
            for around in [h, h.prev(), twin, twin.prev()] {
                self.suspect(&mut suspects, around);
            }
        }
    }

    fn suspect(&mut self, suspects: &mut Vec<(HalfEdgeId, [VertexId; 2])>, h: HalfEdgeId) {
        let edge = ascending(self.ends(h));
        suspects.push((h, edge));
        let (queue, item) = (Queue::Suspects, Item::Edge(edge));
        self.tell(|| Event::Pushed { queue, item });
    }
}

fn ascending([a, b]: [VertexId; 2]) -> [VertexId; 2] {
    [a.min(b), a.max(b)]
}

/// The directed edges of a face, each opposite its corner.
fn edges_of([a, b, c]: [VertexId; 3]) -> [[VertexId; 2]; 3] {
    [[b, c], [c, a], [a, b]]
}

/// One ghost for each edge that has a triangle on one side only.
fn ghosts_of(triangles: &[[VertexId; 3]]) -> Vec<[VertexId; 3]> {
    let mut edges: Vec<_> = triangles.iter().copied().flat_map(edges_of).collect();
    edges.sort_unstable();
    let is_rim = |&&[a, b]: &&[VertexId; 2]| edges.binary_search(&[b, a]).is_err();
    let rim = edges.iter().filter(is_rim);
    rim.map(|&[a, b]| [b, a, VertexId::INFINITE]).collect()
}

/// Makes the mesh of faces that close a sphere.
fn closed(faces: &[[VertexId; 3]]) -> Mesh {
    let mut mesh = Mesh::default();
    let ids: Vec<TriangleId> = faces.iter().map(|&face| mesh.push_face(face)).collect();
    let half_edges = ids.iter().flat_map(|t| t.half_edges());
    let ends = faces.iter().copied().flat_map(edges_of).map(ascending);
    let mut sides: Vec<_> = ends.zip(half_edges).collect();
    sides.sort_unstable();
    for pair in sides.chunks_exact(2) {
        mesh.bond(pair[0].1, pair[1].1);
    }
    mesh
}
