//! Greedy flips with a work list: what has been tested is not tested again until something beside it changes.
//!
//! Whether an edge is locally Delaunay depends on its two triangles alone, so a flip puts only the four edges
//! around it in doubt. All else is as in [`greedy_flips`](super::greedy_flips), and the number of flips is of the
//! same order; but each costs O(1), so O(n²) in all. (Lawson 1977; the lecture leaves the search as it is.)
//!
//! The list is a stack, on which an edge waits at most once. An edge keeps its number when it is flipped.
//! *Does not* order the edges: the end is the same in any order, the number of flips is not.

use super::conflicts::Conflicts;
use super::greedy_flips::begin;
use super::{About, Board, Input, Output, Takes};
use crate::{Error, HalfEdgeId, Observer};

/// What there is to say of it.
pub(super) const ABOUT: About = About {
    name: "flip-list",
    title: "greedy flips with a work list",
    source: "Lecture on geometric graphs, 6.1.2; Lawson 1977",
    idea: "Keep the edges that may not be locally Delaunay on a list; a flip adds its four neighbours.",
    cost: "O(n²): up to n(n−1)/2 flips, each with four tests",
    guarantees: "the canonical (constrained) Delaunay triangulation",
    takes: Takes::Triangulation,
    is_delaunay: true,
    code: &[
        "push all edges of T",
        "while an edge e can be popped:",
        "  if e is not locally Delaunay:",
        "    flip(e)",
        "    push the four edges around it that do not wait",
    ],
};

/// Flips until the list is empty.
pub(super) fn run(input: &Input, observer: &mut impl Observer) -> Result<Output, Error> {
    let mut board = begin(input, observer)?;
    let mut conflicts = Conflicts::count(&mut board)?;
    let mut list = List::of(&board);
    board.at(1);
    for edge in 0..list.half_edges.len() {
        list.push(&mut board, edge);
    }
    while let Some(h) = list.pop(&mut board) {
        board.at(3);
        if board.is_locally_delaunay(h) {
            continue;
        }
        board.step()?;
        board.at(4);
        let around = list.flip(h, board.mesh().twin(h));
        conflicts.flip(&mut board, h);
        board.at(5);
        for edge in around {
            list.push(&mut board, edge);
        }
    }
    Ok(board.finish())
}

/// Edges that have numbers, and those that wait.
struct List {
    /// The number of the edge of each half-edge; nothing to read at infinity or amid carved faces.
    numbers: Vec<usize>,
    /// A half-edge of each edge.
    half_edges: Vec<HalfEdgeId>,
    waits: Vec<bool>,
    stack: Vec<usize>,
}

impl List {
    /// Numbers the edges.
    fn of<O: Observer>(board: &Board<O>) -> Self {
        let mesh = board.mesh();
        let half_edges = board.visible_edges();
        let mut numbers = vec![usize::MAX; 3 * mesh.num_faces()];
        for (edge, &h) in half_edges.iter().enumerate() {
            numbers[h.index()] = edge;
            numbers[mesh.twin(h).index()] = edge;
        }
        Self {
            numbers,
            waits: vec![false; half_edges.len()],
            stack: Vec::new(),
            half_edges,
        }
    }

    fn push<O: Observer>(&mut self, board: &mut Board<O>, edge: usize) {
        if !std::mem::replace(&mut self.waits[edge], true) {
            board.tell_suspect(self.half_edges[edge], true);
            self.stack.push(edge);
        }
    }

    fn pop<O: Observer>(&mut self, board: &mut Board<O>) -> Option<HalfEdgeId> {
        let edge = self.stack.pop()?;
        self.waits[edge] = false;
        board.at(2);
        board.tell_suspect(self.half_edges[edge], false);
        Some(self.half_edges[edge])
    }

    /// Follows the edges through a flip of `h`, whose twin is `g`, and returns the numbers of those around.
    ///
    /// Of these, two change their half-edges, as drawn at [`Mesh::flip`](crate::Mesh::flip): what was
    /// `g.next()` is then `h`, what was `h.next()` is `g`, and both become halves of the diagonal.
    fn flip(&mut self, h: HalfEdgeId, g: HalfEdgeId) -> [usize; 4] {
        let diagonal = self.numbers[h.index()];
        let around = [h.next(), h.prev(), g.next(), g.prev()].map(|s| self.numbers[s.index()]);
        let [bc, _, ad, _] = around;
        for (side, edge) in [(h, ad), (g, bc), (h.next(), diagonal), (g.next(), diagonal)] {
            self.numbers[side.index()] = edge;
            self.half_edges[edge] = side;
        }
        around
    }
}
