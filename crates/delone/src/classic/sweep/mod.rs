//! The plane sweep of the thesis, with its faults mended: a triangulation of a domain, not yet Delaunay.
//!
//! A vertical line goes over the points from left to right. What it has passed is triangulated, and the
//! *front*, a convex cycle of vertices, bounds that; each point is joined to what it sees of the front. Two
//! helper points to the left of all give the first triangle a base; they are removed in the end. Then the
//! segments are inserted, and the triangles outside of the domain are removed.
//!
//! *Mended here*
//! - The print sweeps with the segments in its test of visibility. A point that sees a single vertex of the
//!   front then becomes a spike, or it sees several runs of vertices, and segments get lost:
//!   [`PrintedSweep`](super::Algorithm::PrintedSweep) shows that. Ours sweeps without segments, so its front
//!   is the convex hull, and inserts them exactly afterwards.
//! - Where all vertices of the front are visible, the print cuts the cycle at the start of its array. Ours
//!   takes the front edges that have the point strictly on their right; the edge between the helpers never has.
//! - The helpers are at finite distance, so deleting their triangles leaves dents in the hull: that happens
//!   to 989 of 1000 random sets. Ours deletes them as vertices of the hull, after it has made the chain of
//!   their neighbours convex.
//! - If all ordinates are equal, the printed helpers coincide; so they are moved one up and one down. For
//!   coordinates where one more or less is none at all, they are moved by the least that is representable. If
//!   nothing lies to the left of the smallest abscissa, the sweep does without.
//! - In the inside test a flood replaces the printed rays; the result is the same.
//!
//! *Cost*: O(n log n) for sorting, then O(n); segments and inside test apart.

mod front;
mod helpers;

pub(super) use helpers::places as helper_places;

use super::inside::{self, carve};
use super::segments::{self, insert_all};
use super::{About, Board, Input, Output, Takes};
use crate::predicates::Orientation;
use crate::pslg::input::{check, require_closed};
use crate::{DomainRule, Error, Observer, Stage};

/// What there is to say of it.
pub(super) const ABOUT: About = About {
    name: "sweep",
    title: "plane sweep, segments inserted afterwards",
    source: "Thesis on refinement, Ulm 2012, programs 1.3 to 1.8; corrected",
    idea: "Join each point, from left to right, to what it sees of the convex front; then insert the \
           segments by flips, and remove what lies outside.",
    cost: "O(n log n), and O(k²) at worst for a segment that crosses k edges",
    guarantees: "a triangulation of the domain that has all segments; nothing about its angles",
    takes: Takes::Domain,
    is_delaunay: false,
    code: &[
        "place two helper points to the left of all points",
        "sort the points by x, then y",
        "join both helpers and the first point: that is the front",
        "for each further point p:",
        "  find the front edges that have p on their right",
        "  join p to the ends of these edges",
        "  let p replace the vertices between them on the front",
        "for each helper point:",
        "  while its neighbours form a dent:",
        "    close the dent by a triangle",
        "  delete the helper, its edges and its triangles",
        "turn each clockwise triangle",
        "for each segment ab:",
        "  push all edges that cross ab, walking from a to b",
        "  while an edge waits that has a convex quadrilateral:",
        "    pop and flip it; push the other diagonal if that crosses ab",
        "  lock the edge ab",
        "for each triangle that is outside of the domain:",
        "  delete it",
    ],
};

/// Triangulates a domain.
pub(super) fn run(input: &Input, observer: &mut impl Observer) -> Result<Output, Error> {
    Ok(triangulate(input, observer)?.finish())
}

/// Sweeps without being observed, and begins with the result, told in steps of line 0.
///
/// # Errors
/// As [`run`].
pub(super) fn lay_out<'r, O: Observer>(
    input: &Input<'r>,
    observer: &'r mut O,
) -> Result<Board<'r, O>, Error> {
    let mut nobody = ();
    let swept = triangulate(input, &mut nobody)?;
    Ok(Board::lay_out(swept, input, observer))
}

/// Takes one stage after the other.
fn triangulate<'r, O: Observer>(
    input: &Input<'r>,
    observer: &'r mut O,
) -> Result<Board<'r, O>, Error> {
    check(&input.pslg)?;
    let (mut board, mut order) = Board::new(input, observer)?;
    if input.domain == DomainRule::EvenOdd {
        require_closed(&input.pslg)?;
    }
    board.at(1);
    let helpers = helpers::place(&mut board, &order)?;
    board.at(2);
    order.sort_unstable_by(|&v, &w| board.point(v).lex_cmp(&board.point(w)));
    order.splice(0..0, helpers.iter().copied());
    front::sweep(&mut board, &order)?;
    board.end(Stage::Sweep);
    for &helper in helpers.iter().rev() {
        helpers::strip(&mut board, helper);
    }
    board.at(12);
    require_upright(&mut board);
    board.end(Stage::StripHelpers);
    let lines = segments::Lines {
        consider: 13,
        walk: 14,
        pop: 15,
        flip: 16,
        lock: 17,
    };
    let chains = insert_all(&mut board, input, lines)?;
    board.end(Stage::InsertSegments);
    let lines = inside::Lines {
        test: 18,
        delete: 19,
    };
    carve(&mut board, input, &chains, lines)?;
    board.end(Stage::InsideTest);
    Ok(board)
}

/// Looks for triangles that turn clockwise: exact signs make none.
fn require_upright(board: &mut Board<impl Observer>) {
    if !board.is_watched() && !cfg!(debug_assertions) {
        return;
    }
    for t in board.mesh().triangles().collect::<Vec<_>>() {
        let [a, b, c] = board.mesh().corners(t);
        let turn = board.orient(a, b, c);
        debug_assert_eq!(turn, Orientation::Left, "bug: a triangle is not upright");
    }
}
