//! The lists of neighbours, read off the mesh.
//!
//! A list runs counter-clockwise. That of a vertex on the boundary begins at its successor there; that of
//! any other, which in the text begins anywhere, at the neighbour of lowest number.

use crate::classic::Board;
use crate::{HalfEdgeId, Observer, VertexId};

/// The list of a vertex: the half-edges to its first and its last neighbour.
#[derive(Clone, Copy)]
pub(super) struct List {
    pub first: HalfEdgeId,
    pub last: HalfEdgeId,
    pub is_boundary: bool,
}

/// Reads the list of a vertex.
pub(super) fn list<O: Observer>(board: &Board<O>, v: VertexId) -> List {
    let mesh = board.mesh();
    let mut star = mesh.star(board.spoke(v));
    if let Some(outwards) = star.find(|&h| mesh.dest(h).is_infinite()) {
        return List {
            first: mesh.onext(outwards),
            last: mesh.oprev(outwards),
            is_boundary: true,
        };
    }
    let first = mesh.star(board.spoke(v)).min_by_key(|&h| mesh.dest(h));
    let first = first.expect("bug: a vertex without neighbours");
    List {
        first,
        last: mesh.oprev(first),
        is_boundary: false,
    }
}
