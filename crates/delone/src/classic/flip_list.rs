//! Greedy flips with a work list: what has been tested is not tested again until something beside it changes.
//!
//! Whether an edge is locally Delaunay depends on its two triangles alone, so a flip puts only the four edges
//! around it in doubt. All else is as in [`greedy_flips`](super::greedy_flips), and the number of flips is of the
//! same order; but each costs O(1), so O(n²) in all. (Lawson 1977; the lecture leaves the search as it is.)
//!
//! The list is a stack, on which an edge waits at most once: [`restoring`](super::restoring).
//! *Does not* order the edges: the end is the same in any order, the number of flips is not.

use super::conflicts::Conflicts;
use super::restoring::Restoring;
use super::{About, Board, Input, Output, Takes};
use crate::{Error, Observer};

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

const LINES: Restoring = Restoring {
    push: 1,
    pop: 2,
    examine: 3,
    flip: 4,
};

/// Flips until the list is empty.
pub(super) fn run(input: &Input, observer: &mut impl Observer) -> Result<Output, Error> {
    let mut board = Board::begin(input, observer)?;
    let mut conflicts = Conflicts::count(&mut board)?;
    board.restore_all(LINES, |board, h| {
        conflicts.flip(board, h);
        board.at(5);
    })?;
    Ok(board.finish())
}
