//! Who is joined to whom by edges of the ground, in one table.

use super::Ground;
use crate::{HalfEdgeId, TriangleId, VertexId};

/// The neighbours of every vertex.
pub(super) struct Adjacency {
    /// Where the row of each vertex starts, and the end of the last.
    starts: Vec<u32>,
    neighbors: Vec<VertexId>,
    /// The vertices that have neighbours, in the order in which triangles name them: close in the plane
    /// is close in the list.
    pub order: Vec<VertexId>,
}

impl Adjacency {
    /// *Cost*: O(n).
    pub fn new(ground: &Ground<'_>) -> Self {
        let num_points = ground.triangulation().points().len();
        let mut starts = vec![0_u32; num_points + 1];
        let mut order = Vec::new();
        each_directed_edge(ground, |a, _| {
            if starts[a.index() + 1] == 0 {
                order.push(a);
            }
            starts[a.index() + 1] += 1;
        });
        for i in 0..num_points {
            starts[i + 1] += starts[i];
        }
        let mut next = starts.clone();
        let mut neighbors = vec![VertexId::INFINITE; starts[num_points] as usize];
        each_directed_edge(ground, |a, b| {
            neighbors[next[a.index()] as usize] = b;
            next[a.index()] += 1;
        });
        Self {
            starts,
            neighbors,
            order,
        }
    }

    /// Returns the neighbours of `v`.
    pub fn of(&self, v: VertexId) -> &[VertexId] {
        let [start, end] = [0, 1].map(|k| self.starts[v.index() + k] as usize);
        &self.neighbors[start..end]
    }
}

/// Visits every edge of the ground once in each direction.
fn each_directed_edge(ground: &Ground<'_>, mut visit: impl FnMut(VertexId, VertexId)) {
    let mesh = ground.mesh();
    for t in (0..ground.triangulation().num_triangles()).map(TriangleId::new) {
        for h in t.half_edges() {
            let [a, b] = [mesh.origin(h), mesh.dest(h)];
            visit(a, b);
            if !ground.has(HalfEdgeId::triangle(mesh.twin(h))) {
                visit(b, a);
            }
        }
    }
}
