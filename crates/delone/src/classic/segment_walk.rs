//! The program of the slides: walk along the segment from the last point to the next, clear, and join.
//!
//! `s := init; for each p: D := find_face(s, p); triangulate(D, p); s := p`. The triangles that have the new point
//! p in their circles are opened one after the other, from D outwards, with a stack of edges; an edge that stays
//! gets a spoke from p. What is deleted are the edges that Lawson's method flips, so both do the same work.
//!
//! *Corrected*: **the bounding triangle.** The one of the slides does not contain the points
//! ([`printed_bounding_triangle`](super::printed_bounding_triangle)), and no finite one is neutral: its corners lie in
//! circles of flat triangles at the hull. Ours are at infinity, as one vertex; the circle of a face there is the
//! half-plane beyond its hull edge. No step tells of it. Who wants to show a triangle around the points takes
//! [`bounding_triangle`](super::bounding_triangle). The first walk starts at the second point. **The test**: the print
//! has ≥ 0, which opens cocircular triangles, too; here the perturbation decides. **The walk**: the slides assume that
//! the segment meets no vertex and no edge lengthwise. Here it may:
//!
//! ```text
//!     s ──────●          at a vertex it begins anew, as it did in s: along the edge that leads towards p,
//!        ╲   ╱ ╲         or through the face whose corner there it enters; if there is neither, p lies
//!     ╲───╲─╱───●──→ p   outside, and an edge of the hull at this vertex sees it
//! ```
//!
//! *Cost*: the walk crosses O(√n) edges for evenly spread points in random order, O(n) at worst. *Does not* jump:
//! the way begins at the last point, so points that come along a curve are found quickly.

use super::{About, Board, Input, Output, Takes};
use crate::locate::Location;
use crate::predicates::Orientation;
use crate::{Error, Event, HalfEdgeId, Observer, VertexId};

/// What there is to say of it.
pub(super) const ABOUT: About = About {
    name: "segment-walk",
    title: "incremental construction with a walk along segments",
    source: "Slides on an animated Delaunay program (LEDA)",
    idea: "Walk from the last point straight to the next, open the triangles around it, and join it to the rim.",
    cost: "O(n√n) in practice, O(n²) at worst",
    guarantees: "the canonical Delaunay triangulation, after every point",
    takes: Takes::Points,
    is_delaunay: true,
    code: &[
        "join the first two points, with all corners of the bounding triangle at infinity",
        "for each further point p, s being the one before:",
        "  f := the face at s that the segment sp enters",
        "  while sp leaves f over an edge: f := the face beyond",
        "  push the edges of f, if p lies on one of them those of both faces there",
        "  while an edge ab can be popped:",
        "    c := the vertex beyond ab",
        "    if p lies inside the circle of a, b, c:",
        "      delete ab, push cb and ac",
        "    else: join a and p",
    ],
};

/// Inserts the points in the given order.
pub(super) fn run(input: &Input, observer: &mut impl Observer) -> Result<Output, Error> {
    let (mut board, order) = Board::new(input, observer)?;
    let [a, b, rest @ ..] = &order[..] else {
        return Ok(board.finish());
    };
    board.at(1);
    let ab = board.seed(*a, *b);
    let mut at_last = board.mesh().twin(ab);
    for &p in rest {
        board.step()?;
        board.at(2);
        board.tell(|| Event::PointConsidered { vertex: p });
        let found = Walk {
            board: &mut board,
            p,
        }
        .find_face(at_last);
        at_last = board.open_and_join(found, p);
    }
    Ok(board.finish())
}

/// A walk to a point.
struct Walk<'b, 'r, O> {
    board: &'b mut Board<'r, O>,
    p: VertexId,
}

/// How the segment from a vertex to the point begins.
enum Ahead {
    /// Along the edge of this half-edge, which starts at the vertex.
    Along(HalfEdgeId),
    /// Through the face of this half-edge, which lies opposite the vertex.
    Across(HalfEdgeId),
    /// It leaves the convex hull.
    Away(Location),
}

impl<O: Observer> Walk<'_, '_, O> {
    /// Walks from the origin of `h` straight to the point, and says where it lies.
    fn find_face(&mut self, mut h: HalfEdgeId) -> Location {
        let found = loop {
            self.board.at(3);
            match self.ahead(h) {
                Ahead::Away(found) => break found,
                Ahead::Along(g) if self.ends_on(g) => break Location::Edge(g),
                Ahead::Along(g) => h = self.board.mesh().twin(g),
                Ahead::Across(exit) => match self.cross(h, exit) {
                    Ok(found) => break found,
                    Err(next) => h = next,
                },
            }
        };
        self.board.tell_located(self.p, Some(found));
        found
    }

    /// Looks from the origin of `h` towards the point, once around counter-clockwise.
    fn ahead(&mut self, h: HalfEdgeId) -> Ahead {
        use Orientation::{Collinear, Left, Right};
        let s = self.board.mesh().origin(h);
        let star: Vec<_> = self.board.mesh().star(h).collect();
        for &g in &star {
            let [v, w] = [self.board.mesh().dest(g), self.board.mesh().apex(g)];
            if v.is_infinite() {
                continue;
            }
            let side = self.board.orient(s, self.p, v);
            if side == Collinear && self.board.is_towards(s, v, self.p) {
                return Ahead::Along(g);
            }
            if side == Right && !w.is_infinite() && self.board.orient(s, self.p, w) == Left {
                return Ahead::Across(g.next());
            }
        }
        Ahead::Away(self.away(&star))
    }

    /// Says where the point lies if it is outside and no face of this star leads to it: an edge of the hull here
    /// sees it, or it lies beyond the end of a row.
    fn away(&mut self, star: &[HalfEdgeId]) -> Location {
        for &g in star {
            for side in [g, self.board.mesh().twin(g)] {
                let is_outer = self.board.mesh().apex(side).is_infinite();
                if is_outer && self.side(side) == Orientation::Left {
                    return Location::Outside(side);
                }
            }
        }
        let mut outwards = star.iter();
        let end = outwards.find(|&&g| self.board.mesh().dest(g).is_infinite());
        Location::Beyond(*end.expect("bug: the mesh does not cover its convex hull"))
    }

    /// Goes through the face of `exit`, opposite the origin of `from`, and on: where the point lies, or a
    /// half-edge that starts at a vertex on the way.
    fn cross(&mut self, from: HalfEdgeId, mut exit: HalfEdgeId) -> Result<Location, HalfEdgeId> {
        let s = self.board.mesh().origin(from);
        self.visit(exit);
        loop {
            self.board.at(4);
            match self.side(exit) {
                Orientation::Left => return Ok(Location::Face(exit.triangle())),
                Orientation::Collinear => return Ok(Location::Edge(exit)),
                Orientation::Right => {}
            }
            let edge = self.board.ends(exit);
            self.board.tell(|| Event::WalkStepped { edge });
            let entry = self.board.mesh().twin(exit);
            let w = self.board.mesh().apex(entry);
            if w.is_infinite() {
                return Ok(Location::Outside(entry));
            }
            self.visit(entry);
            exit = match self.board.orient(s, self.p, w) {
                Orientation::Left => entry.next(),
                Orientation::Right => entry.prev(),
                Orientation::Collinear if self.is_before(s, w) => {
                    return Ok(Location::Face(entry.triangle()));
                }
                Orientation::Collinear => return Err(entry.prev()),
            };
        }
    }

    fn visit(&mut self, h: HalfEdgeId) {
        let triangle = self.board.mesh().corners(h.triangle());
        self.board.tell(|| Event::TriangleVisited { triangle });
    }

    /// On which side of `h` the point lies.
    fn side(&mut self, h: HalfEdgeId) -> Orientation {
        let [a, b] = self.board.ends(h);
        self.board.orient(a, b, self.p)
    }

    /// Tells whether the point, which lies ahead on the line from `s` to `v`, comes before `v`.
    fn is_before(&self, s: VertexId, v: VertexId) -> bool {
        let [s, p, v] = [s, self.p, v].map(|v| self.board.point(v));
        s.lex_cmp(&p) == p.lex_cmp(&v)
    }

    /// Tells whether the point, which lies ahead on the line of `g`, lies in its open segment.
    fn ends_on(&self, g: HalfEdgeId) -> bool {
        let [a, b] = self.board.ends(g);
        self.is_before(a, b)
    }
}
