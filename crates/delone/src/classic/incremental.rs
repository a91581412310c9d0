//! Incremental construction, as the lecture gives it: one point after the other, restored by flips.

use super::joining::Restoring;
use super::{About, Board, Input, Output, Takes};
use crate::locate::locate;
use crate::{Error, Event, HalfEdgeId, Observer};

/// What there is to say of it.
pub(super) const ABOUT: About = About {
    name: "incremental",
    title: "incremental construction",
    source: "Lecture on geometric graphs; Lawson 1977",
    idea: "Join each point to what it sees; then flip edges until all are locally Delaunay again.",
    cost: "O(n²) at worst; in random order O(n) flips expected",
    guarantees: "the canonical Delaunay triangulation, after every point",
    takes: Takes::Points,
    is_delaunay: true,
    code: &[
        "join the first two points by an edge",
        "for each further point p:",
        "  find where p lies",
        "  join p to all corners that it sees",
        "  push the edges opposite to p",
        "  while an edge e can be popped:",
        "    if e is not locally Delaunay:",
        "      flip e, and push the two edges behind it",
    ],
};

/// Inserts the points in the given order.
pub(super) fn run(input: &Input, observer: &mut impl Observer) -> Result<Output, Error> {
    let (mut board, order) = Board::new(input, observer)?;
    let [a, b, rest @ ..] = &order[..] else {
        return Ok(board.finish());
    };
    board.at(1);
    board.seed(*a, *b);
    for &p in rest {
        board.step()?;
        board.at(2);
        board.tell(|| Event::PointConsidered { vertex: p });
        board.at(3);
        let at = locate(
            board.mesh(),
            board.points(),
            HalfEdgeId::new(0),
            board.point(p),
        );
        board.at(4);
        let link = board.join(at, p);
        let lines = Restoring {
            push: 5,
            pop: 6,
            examine: 7,
            flip: 8,
        };
        board.restore(link, lines);
    }
    Ok(board.finish())
}
