//! Greedy flips, as the lecture gives them: as long as an edge can be found that is not locally Delaunay, flip it.
//!
//! The edge is found by a breadth-first search over the vertices, from one on the outer face; each edge that it
//! comes to is tested once. After a flip the search begins anew, which is what makes this slow, and simple.
//! [`flip_list`](super::flip_list) remembers what has been tested.
//!
//! *Ends* since the conflicts Φ become fewer by two or more with each flip ([`conflicts`](super::conflicts)); an
//! edge that was flipped away never returns, either. *Corrected*: among cocircular points the perturbation decides,
//! or the end would depend on the beginning. Constraints are never flipped; then the end is the constrained Delaunay
//! triangulation, as Lee and Lin showed (1986). Where the triangulation does not fill its convex hull, the search goes
//! through what is missing, and tests nothing there. *Does not* need a flip to be checked for admissibility: an edge that
//! is not locally Delaunay has a strictly convex quadrilateral.

use super::conflicts::Conflicts;
use super::{About, Board, Input, Output, Takes};
use crate::observe::{Item, Queue};
use crate::{Error, HalfEdgeId, Observer, VertexId};
use std::collections::VecDeque;

/// What there is to say of it.
pub(super) const ABOUT: About = About {
    name: "greedy-flips",
    title: "greedy flips",
    source: "Lecture on geometric graphs, 6.1.2 and 6.1.3; Lawson 1977",
    idea: "Whatever the triangulation: as long as some edge is not locally Delaunay, flip one.",
    cost: "O(n³): up to n(n−1)/2 flips, and a search of O(n) for each",
    guarantees: "the canonical (constrained) Delaunay triangulation",
    takes: Takes::Triangulation,
    is_delaunay: true,
    code: &[
        "e := an edge of the outer face",
        "repeat:",
        "  begin a breadth-first search of T at e.start",
        "  for each edge f that it comes to:",
        "    if f is not locally Delaunay: leave the search",
        "  if there was none: end",
        "  flip(f)",
    ],
};

/// Flips until all edges are locally Delaunay.
pub(super) fn run(input: &Input, observer: &mut impl Observer) -> Result<Output, Error> {
    let mut board = Board::begin(input, observer)?;
    let mut conflicts = Conflicts::count(&mut board)?;
    board.at(1);
    let Some(e) = outer_edge(&board) else {
        return Ok(board.finish());
    };
    while let Some(f) = search(&mut board, e) {
        board.step()?;
        board.at(7);
        conflicts.flip(&mut board, f);
    }
    Ok(board.finish())
}

/// Finds the half-edge of the outer face that starts at the lowest vertex. No flip touches it.
fn outer_edge<O: Observer>(board: &Board<O>) -> Option<HalfEdgeId> {
    let mesh = board.mesh();
    let outer = mesh.ghosts().map(|t| mesh.hull_edge_of(t));
    outer.min_by_key(|&h| mesh.origin(h))
}

/// Searches breadth-first from the origin of `e` for an edge that is not locally Delaunay.
fn search<O: Observer>(board: &mut Board<O>, e: HalfEdgeId) -> Option<HalfEdgeId> {
    let mut search = Search {
        states: vec![State::Unseen; board.points().len()],
        waiting: VecDeque::new(),
    };
    board.at(3);
    search.await_origin(board, e);
    let found = search.run(board);
    for h in search.waiting {
        let v = board.mesh().origin(h);
        tell_search(board, v, false);
    }
    found
}

#[derive(Clone, Copy, PartialEq)]
enum State {
    Unseen,
    Waiting,
    Done,
}

struct Search {
    states: Vec<State>,
    /// For each vertex that waits, a half-edge that starts there.
    waiting: VecDeque<HalfEdgeId>,
}

impl Search {
    fn run<O: Observer>(&mut self, board: &mut Board<O>) -> Option<HalfEdgeId> {
        while let Some(first) = self.waiting.pop_front() {
            let v = board.mesh().origin(first);
            board.at(3);
            tell_search(board, v, false);
            let star: Vec<_> = board.mesh().star(first).collect();
            for h in star {
                if self.is_new(board, h) {
                    board.at(5);
                    if board.is_visible(h) && !board.is_locally_delaunay(h) {
                        return Some(h);
                    }
                    board.at(4);
                    let back = board.mesh().twin(h);
                    self.await_origin(board, back);
                }
            }
            self.states[v.index()] = State::Done;
        }
        None
    }

    /// Tells whether an edge has not been tested from its other end.
    fn is_new<O: Observer>(&self, board: &Board<O>, h: HalfEdgeId) -> bool {
        let other = board.mesh().dest(h);
        !other.is_infinite() && self.states[other.index()] != State::Done
    }

    /// Lets the origin of a half-edge wait, once.
    fn await_origin<O: Observer>(&mut self, board: &mut Board<O>, h: HalfEdgeId) {
        let v = board.mesh().origin(h);
        if self.states[v.index()] == State::Unseen {
            self.states[v.index()] = State::Waiting;
            tell_search(board, v, true);
            self.waiting.push_back(h);
        }
    }
}

fn tell_search<O: Observer>(board: &mut Board<O>, v: VertexId, is_pushed: bool) {
    let item = Item::Vertex(v);
    board.tell_waiting(Queue::Search, item, is_pushed);
}
