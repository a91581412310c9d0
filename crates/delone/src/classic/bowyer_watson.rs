//! Bowyer–Watson: the triangles in whose circles a new point lies go, and their hole is joined to it.
//!
//! Ghosts stand in for the triangle around everything that the papers begin with: one is in conflict with
//! what lies outside its hull edge, or on the edge.

use super::{About, Board, Input, Output, Takes};
use crate::locate::{Location, locate};
use crate::observe::{Item, Queue};
use crate::predicates::Orientation;
use crate::{Error, Event, HalfEdgeId, Observer, TriangleId, VertexId};
use std::collections::HashSet;

/// What there is to say of it.
pub(super) const ABOUT: About = About {
    name: "bowyer-watson",
    title: "Bowyer–Watson",
    source: "Bowyer 1981; Watson 1981",
    idea: "A point destroys the triangles in whose circles it lies. They form a star-shaped hole; joining the \
           point to its rim repairs everything at once.",
    cost: "O(n²) at worst; O(n log n) expected in random order, with good location",
    guarantees: "the canonical Delaunay triangulation, after every point",
    takes: Takes::Points,
    is_delaunay: true,
    code: &[
        "join the first two points by an edge",
        "for each further point p:",
        "  find the face where p lies, and push it",
        "  while a face can be popped:",
        "    for each face beside it that has not been seen:",
        "      p lies in its circle: push it",
        "      else the edge between belongs to the rim",
        "  delete the faces in conflict, and join p to the rim",
    ],
};

/// Inserts the points in the given order.
pub(super) fn run(input: &Input, observer: &mut impl Observer) -> Result<Output, Error> {
    let (mut board, order) = Board::new(input, observer)?;
    let [a, b, rest @ ..] = &order[..] else {
        return Ok(board.finish());
    };
    board.at(1);
    let mut hint = *a;
    board.seed(*a, *b);
    for &p in rest {
        board.step()?;
        board.at(2);
        board.tell(|| Event::PointConsidered { vertex: p });
        board.at(3);
        let start = board.spoke(hint);
        match locate(board.mesh(), board.points(), start, board.point(p)) {
            // A row: there are no circles yet.
            at if is_in_row(&board, at) => drop(board.join(at, p)),
            at => insert(&mut board, first_face(at), p),
        }
        hint = p;
    }
    Ok(board.finish())
}

/// Tells whether a location is in a row of collinear vertices, where no face is a triangle.
fn is_in_row<O: Observer>(board: &Board<O>, at: Location) -> bool {
    let is_ghost = |h: HalfEdgeId| board.mesh().is_ghost(h.triangle());
    match at {
        Location::Beyond(_) => true,
        Location::Edge(h) => is_ghost(h) && is_ghost(board.mesh().twin(h)),
        _ => false,
    }
}

/// The face in conflict to begin with.
fn first_face(at: Location) -> TriangleId {
    match at {
        Location::Face(t) => t,
        Location::Edge(h) | Location::Outside(h) => h.triangle(),
        _ => unreachable!("bug: the points are distinct, and nothing is carved"),
    }
}

fn insert<O: Observer>(board: &mut Board<O>, first: TriangleId, p: VertexId) {
    let mut cavity = vec![first];
    let mut seen = HashSet::from([first]);
    let mut rim = Vec::new();
    tell_face(board, first, true);
    // Depth first, the rim is met counter-clockwise.
    let [a, b, c] = first.half_edges();
    let mut stack = vec![c, b, a];
    while let Some(h) = stack.pop() {
        let outer = board.mesh().twin(h);
        let beyond = outer.triangle();
        if seen.contains(&beyond) {
            continue;
        }
        board.at(6);
        if conflicts(board, beyond, p) {
            tell_face(board, beyond, true);
            seen.insert(beyond);
            cavity.push(beyond);
            stack.extend([outer.prev(), outer.next()]);
        } else {
            board.at(7);
            let edge = board.ends(outer);
            if !edge.iter().any(|v| v.is_infinite()) {
                board.tell(|| Event::EdgeExamined { edge });
            }
            rim.push(outer);
        }
    }
    board.at(8);
    for &t in &cavity {
        tell_face(board, t, false);
    }
    board.fill(cavity, &rim, p);
}

/// Tells whether a face must go: `p` lies in its circle; of a ghost, outside the hull edge or on it.
fn conflicts<O: Observer>(board: &mut Board<O>, t: TriangleId, p: VertexId) -> bool {
    if !board.mesh().is_ghost(t) {
        return board.in_circle(board.mesh().corners(t), p);
    }
    let [a, b] = board.ends(board.mesh().hull_edge_of(t));
    match board.orient(a, b, p) {
        Orientation::Left => true,
        Orientation::Right => false,
        Orientation::Collinear => {
            let [a, b, p] = [a, b, p].map(|v| board.point(v));
            a.lex_cmp(&p) == p.lex_cmp(&b)
        }
    }
}

/// Tells that a triangle begins to wait for its end, or has found it.
fn tell_face<O: Observer>(board: &mut Board<O>, t: TriangleId, is_pushed: bool) {
    let corners = board.mesh().corners(t);
    if corners.iter().any(|v| v.is_infinite()) {
        return;
    }
    let item = Item::Triangle(corners);
    board.tell_waiting(Queue::Cavity, item, is_pushed);
}
