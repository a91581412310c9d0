//! Incremental construction, as the lecture gives it: one point after the other, restored by flips.
//!
//! Join each point to the corners of the face that holds it, which a breadth-first search finds, or to the
//! outer edges that it sees; then flip edges, beginning with those opposite to the point, until all are
//! locally Delaunay. Only edges that form a triangle with the point can fail (star lemma), so that one test
//! decides: the other end of a flipped edge never has to be looked at again.
//!
//! The lecture's subroutines, in its names; `e` is an edge a → c, the new point d lies to its left, b is the
//! apex on the other side:
//!
//! ```text
//! is_locally_delaunay(e):                          flip(ac):
//!   if e.twin.outer or e.outer: return true          b := ac.twin.next.next.start
//!   a := e.start                                     d := ac.next.next.start
//!   c := e.next.start                                bd, db := new twins
//!   d := e.next.next.start                           cd := ac.next;  ab := ac.twin.next
//!   b := e.twin.next.next.start                      da := cd.next;  bc := ab.next
//!   return d outside of circle(a, b, c)              bd.next := da;  da.next := ab;  ab.next := bd
//!      and b outside of circle(a, c, d)              db.next := bc;  bc.next := cd;  cd.next := db
//!                                                    a.edge := ab;   c.edge := cd
//!                                                    return bd
//! ```
//!
//! [`Mesh::flip`](crate::Mesh::flip) of ac makes the same cycles and keeps no twins and no edges of nodes, since
//! faces hold both implicitly. It calls what was ac from then on ab, and what was ca, cd; bd is the `next` of
//! ab. So with g = flip(e), the lecture's g.next.next is the half-edge that was flipped, and g.twin.next the
//! `prev` of its old twin. The test asks one side only: d lies in the circle of (a, b, c) if and only if b lies
//! in that of (a, c, d), and that also holds once the perturbation has decided.
//!
//! *Corrected*: the text assumes general position. First points on one line are laid into a row, and the first
//! point beside it is joined to all of them; a point on an edge splits both faces there; a point that lies on
//! the line of an outer edge does not see it. The recursion is a stack, popped in the order of the recursion.
//! *Does not* look for a good place to begin the search, nor choose the order of the points.

use super::restoring::Restoring;
use super::{About, Board, Input, Output, Takes};
use crate::{Error, Event, HalfEdgeId, Observer, VertexId};

/// What there is to say of it.
pub(super) const ABOUT: About = About {
    name: "incremental",
    title: "incremental construction",
    source: "Lecture on geometric graphs, 6.1.4; Lawson 1977",
    idea: "Join each point to what it sees; then flip edges until all are locally Delaunay again.",
    cost: "O(n²) at worst: a search is O(n), and so are the flips for one point",
    guarantees: "the canonical Delaunay triangulation, after every point",
    takes: Takes::Points,
    is_delaunay: true,
    code: &[
        "find the first point q that is not on one line with all before it",
        "T := the points before q in a row, all joined to q",
        "for each further point p:",
        "  search the faces of T breadth-first for one that holds p",
        "  inside: join p to the corners of its face; on an edge: of both faces",
        "  outside: join p to each outer half-edge a→c with (a, c, p) counter-clockwise",
        "  push the edges opposite to p",
        "  while an edge e can be popped:",
        "    if e is not locally Delaunay:",
        "      g := flip(e); push g.twin.next and g.next.next",
    ],
};

/// Inserts the points in the given order.
pub(super) fn run(input: &Input, observer: &mut impl Observer) -> Result<Output, Error> {
    let (mut board, order) = Board::new(input, observer)?;
    insert_all(&mut board, &order, 0)?;
    Ok(board.finish())
}

/// Inserts points in this order; the first line of the pseudocode comes after `before` others.
pub(super) fn insert_all<O: Observer>(
    board: &mut Board<O>,
    order: &[VertexId],
    before: u16,
) -> Result<(), Error> {
    for &p in begin(board, order, before)? {
        board.step()?;
        board.at(before + 3);
        board.tell(|| Event::PointConsidered { vertex: p });
        insert(board, p, before);
    }
    Ok(())
}

/// Triangulates the first points: those on one line, and the first beside it. Returns the others.
fn begin<'v, O: Observer>(
    board: &mut Board<O>,
    order: &'v [VertexId],
    before: u16,
) -> Result<&'v [VertexId], Error> {
    board.at(before + 1);
    let (row, rest) = board.first_row(order)?;
    board.at(before + 2);
    board.lay_row(&row);
    let Some((&q, rest)) = rest.split_first() else {
        return Ok(&[]);
    };
    join_outside(board, q);
    Ok(rest)
}

/// Joins `p` to the ends of all outer half-edges that it sees.
fn join_outside<O: Observer>(board: &mut Board<O>, p: VertexId) -> Vec<HalfEdgeId> {
    let seen = board.outer_edges_seen(p);
    let [start, end] = [seen[0], seen[seen.len() - 1]].map(|h| board.ends(h));
    board.join_chain(seen[0], p, [end[1], start[0]])
}

fn insert<O: Observer>(board: &mut Board<O>, p: VertexId, before: u16) {
    board.at(before + 4);
    let found = board.search(p);
    board.tell_located(p, found);
    let link = match found {
        Some(at) => {
            board.at(before + 5);
            board.join(at, p)
        }
        None => {
            board.at(before + 6);
            join_outside(board, p)
        }
    };
    let lines = Restoring {
        push: before + 7,
        pop: before + 8,
        examine: before + 9,
        flip: before + 10,
    };
    board.restore(link, lines);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Log;

    #[test]
    fn a_row_at_the_beginning_is_joined_to_the_first_point_beside_it() {
        let points = [(2.0, 2.0), (0.0, 0.0), (3.0, 3.0), (1.0, 1.0), (0.0, 5.0)];
        let input = Input::from_points(points);
        let mut log = Log::new(ABOUT.name, input.pslg.points.clone());
        let output = run(&input, &mut log).expect("finite");
        assert_eq!(output.triangles.len(), 3);
        let q = VertexId::new(4);
        assert!(output.triangles.iter().all(|t| t.contains(&q)));
        let flips = log.steps.iter();
        let flips = flips.filter(|s| matches!(s.event, Event::EdgeFlipped { .. }));
        assert_eq!(flips.count(), 0);
        assert!(log.steps.iter().all(|step| step.line <= 2));
    }
}
