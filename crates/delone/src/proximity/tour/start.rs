//! The first tour: once around the spanning tree.

use crate::proximity::Proximity;
use crate::{Error, HalfEdgeId, VertexId};

/// Lists the vertices as a walk around the tree from `start` comes to them for the first time.
///
/// The tree lies in the plane, and the walk keeps it to its right, as one who follows a wall: each edge is
/// passed twice, and shortcuts cross each other less than in an arbitrary order.
pub(super) fn around(
    proximity: &Proximity,
    tree: &[HalfEdgeId],
    start: VertexId,
) -> Result<Vec<VertexId>, Error> {
    let t = &proximity.triangulation;
    let mesh = t.mesh();
    let mut pace = proximity.pace();
    let mut is_tree = vec![false; 3 * mesh.num_faces()];
    for &h in tree {
        is_tree[h.index()] = true;
        is_tree[mesh.twin(h).index()] = true;
    }
    let mut is_seen = vec![false; t.points().len()];
    is_seen[start.index()] = true;
    let mut order = vec![start];
    let Some(first) = t.star(start).find(|h| is_tree[h.index()]) else {
        return Ok(order);
    };
    let mut h = first;
    loop {
        pace.step()?;
        let v = mesh.dest(h);
        if !is_seen[v.index()] {
            is_seen[v.index()] = true;
            order.push(v);
        }
        h = mesh.onext(mesh.twin(h));
        while !is_tree[h.index()] {
            pace.step()?;
            h = mesh.onext(h);
        }
        if h == first {
            return Ok(order);
        }
    }
}
