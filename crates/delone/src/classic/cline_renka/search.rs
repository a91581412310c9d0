//! Algorithm 3.20: where a point lies.

use super::line;
use super::lists::list;
use crate::classic::Board;
use crate::predicates::Orientation;
use crate::{Event, HalfEdgeId, Observer, VertexId};

/// Where a point lies.
pub(super) enum Place {
    /// In the closed triangle of this half-edge, on no outer edge.
    Inside(HalfEdgeId),
    /// On this outer edge.
    Boundary(HalfEdgeId),
    /// Outside; it sees the boundary between two vertices, of which this edge is a part.
    Outside(HalfEdgeId, [VertexId; 2]),
}

/// Looks for `t`, beginning at vertex `start`.
pub(super) fn locate<O: Observer>(board: &mut Board<O>, start: VertexId, t: VertexId) -> Place {
    let mut delta = start;
    let to_beta = loop {
        board.at(line::LISTS);
        let list = list(board, delta);
        if list.is_boundary {
            board.at(line::BOUNDARY);
            for edge in [list.first, board.mesh().twin(list.last)] {
                if is_right(board, edge, t) {
                    return outside(board, edge, t);
                }
            }
        }
        board.at(line::NEIGHBOUR);
        if let Some(found) = neighbour_left_of(board, list.first, list.last, t) {
            break found;
        }
        delta = board.mesh().apex(board.mesh().twin(list.last));
    };
    let edge = rotate(board, to_beta, t);
    walk(board, delta, edge, t)
}

/// A neighbour β of δ with `t` to the right of δ→β: the first in the list.
fn neighbour_left_of<O: Observer>(
    board: &mut Board<O>,
    first: HalfEdgeId,
    last: HalfEdgeId,
    t: VertexId,
) -> Option<HalfEdgeId> {
    let mut h = first;
    loop {
        if is_right(board, h, t) {
            return Some(h);
        }
        if h == last {
            return None;
        }
        h = board.mesh().onext(h);
    }
}

/// Rotates clockwise about δ until `t` lies between two neighbours; returns the edge αβ between them.
fn rotate<O: Observer>(board: &mut Board<O>, mut to_beta: HalfEdgeId, t: VertexId) -> HalfEdgeId {
    board.at(line::ROTATE);
    loop {
        let from_beta = board.mesh().twin(to_beta);
        let to_alpha = from_beta.next();
        if !is_right(board, to_alpha, t) {
            return from_beta.prev();
        }
        to_beta = to_alpha;
    }
}

/// Walks from δ towards `t`, beginning over the edge αβ.
fn walk<O: Observer>(
    board: &mut Board<O>,
    delta: VertexId,
    mut edge: HalfEdgeId,
    t: VertexId,
) -> Place {
    loop {
        board.at(line::WALK);
        if !is_right(board, edge, t) {
            return on_or_in(board, edge, t);
        }
        let beyond = board.mesh().twin(edge);
        if board.mesh().is_ghost(beyond.triangle()) {
            return outside(board, edge, t);
        }
        board.at(line::CROSS);
        let ends = board.ends(edge);
        board.tell(|| Event::WalkStepped { edge: ends });
        let kappa = board.mesh().apex(beyond);
        edge = match board.orient(delta, kappa, t) {
            Orientation::Right => beyond.next(),
            _ => beyond.prev(),
        };
    }
}

/// The triangle of αβ, which holds `t`, or one of its edges, if that is an outer one.
fn on_or_in<O: Observer>(board: &mut Board<O>, edge: HalfEdgeId, t: VertexId) -> Place {
    board.at(line::BORDER);
    for side in [edge.prev(), edge] {
        let outer = board.mesh().twin(side);
        if board.mesh().is_ghost(outer.triangle()) && !is_right(board, outer, t) {
            return Place::Boundary(side);
        }
    }
    Place::Inside(edge)
}

/// Extends the edge αβ, which `t` sees from outside, to all of the boundary that it sees.
fn outside<O: Observer>(board: &mut Board<O>, edge: HalfEdgeId, t: VertexId) -> Place {
    let [mut alpha, mut beta] = board.ends(edge);
    board.at(line::ONWARDS);
    loop {
        let next = list(board, beta).first;
        if !is_right(board, next, t) {
            break;
        }
        beta = board.mesh().dest(next);
    }
    board.at(line::BACKWARDS);
    loop {
        let last = list(board, alpha).last;
        let before = board.mesh().twin(last);
        if !is_right(board, before, t) {
            break;
        }
        alpha = board.mesh().origin(before);
    }
    Place::Outside(edge, [alpha, beta])
}

/// Tells whether `t` lies strictly to the right of a half-edge.
fn is_right<O: Observer>(board: &mut Board<O>, h: HalfEdgeId, t: VertexId) -> bool {
    let [a, b] = board.ends(h);
    board.orient(a, b, t) == Orientation::Right
}
