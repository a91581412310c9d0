//! The sweep circle: points by their distance from a center, each joined to all that it sees of the hull.
//!
//! This is Sinclair's s-hull, which Delaunator made popular; Biniaz and Dastghaibyfard sweep with a circle,
//! too, but leave notches in their front, which they fill later.
//!
//! *Why a point never lies inside.* All points that are there lie in the disc about the center whose circle
//! goes through the new one. A disc is strictly convex, so a new point on its rim, or beyond, is a corner of
//! the hull of both: it lies outside of the old hull, strictly left of some edge as seen from there, or, while
//! all are on one line, beyond an end. No point need be located, and the center may lie anywhere.
//!
//! *Corrected*: both papers sort by rounded distances, and begin with a triangle around the center; where
//! distances are equal, or the first points collinear, they go wrong. Here distances are compared exactly,
//! equal ones by the lexicographic order, and a row of points lasts as long as it has to.
//!
//! *Cost*: O(n log n) for sorting; then the hash table of directions makes the search short in practice, and
//! flips are O(n) for points that are spread evenly, O(n²) at worst. The table only says where to begin.

use super::restoring::Restoring;
use super::swept::Swept;
use super::{About, Board, Input, Output, Takes};
use crate::locate::Location;
use crate::predicates::{Orientation, compare_distances, length_up};
use crate::{Error, Event, HalfEdgeId, Observer, Point, Sweep, VertexId};
use std::cmp::Ordering;

/// What there is to say of it.
pub(super) const ABOUT: About = About {
    name: "sweep-circle",
    title: "sweep circle",
    source: "Sinclair 2016 (s-hull); Biniaz and Dastghaibyfard 2012",
    idea: "A circle grows from the middle; each point that it comes to lies outside of the hull so far, and is \
           joined to all edges that it sees; then edges are flipped.",
    cost: "O(n log n) for sorting; flips O(n) if points are spread evenly, O(n²) at worst",
    guarantees: "the canonical Delaunay triangulation, after every point",
    takes: Takes::Points,
    is_delaunay: true,
    code: &[
        "let c be the point nearest to the middle of the bounding box",
        "sort the points by their distance from c, equal ones by x, then y",
        "join the first two points by an edge",
        "for each further point p:",
        "  let the circle about c grow until p is on it",
        "  begin at a hull edge in the direction of p",
        "  go on along the hull until p sees an edge",
        "  join p to all hull edges around that it sees",
        "  push the edges opposite to p",
        "  while an edge e can be popped:",
        "    if e is not locally Delaunay:",
        "      flip e, and push the two edges behind it",
    ],
};

const RESTORING: Restoring = Restoring {
    push: 9,
    pop: 10,
    examine: 11,
    flip: 12,
};

/// Inserts the points by their distance from one in the middle.
pub(super) fn run(input: &Input, observer: &mut impl Observer) -> Result<Output, Error> {
    let (mut board, mut order) = Board::new(input, observer)?;
    board.at(1);
    let Some(center) = middle(&board, &order) else {
        return Ok(board.finish());
    };
    board.at(2);
    order.sort_by(|&v, &w| by_distance(&board, center, v, w));
    let [a, b, rest @ ..] = &order[..] else {
        return Ok(board.finish());
    };
    board.at(3);
    let mut circle = Circle::new(&mut board, center, [*a, *b]);
    for &p in rest {
        board.step()?;
        board.at(4);
        board.tell(|| Event::PointConsidered { vertex: p });
        circle.grow(&mut board, p);
        match circle.find(&mut board, p) {
            Location::Outside(h) => circle.join_outside(&mut board, h, p),
            beyond => circle.lengthen(&mut board, beyond, p),
        }
    }
    Ok(board.finish())
}

/// Finds the point nearest to the middle of the bounding box, of several the lexicographically smallest.
fn middle<O: Observer>(board: &Board<O>, order: &[VertexId]) -> Option<Point> {
    let points = || order.iter().map(|&v| board.point(v));
    let [low, high] = [f64::min, f64::max].map(|extreme| {
        let both = |p: Point, q: Point| Point::new(extreme(p.x, q.x), extreme(p.y, q.y));
        points().reduce(both)
    });
    let (low, high) = (low?, high?);
    // Halved first: a sum might overflow.
    let middle = Point::new(low.x / 2.0 + high.x / 2.0, low.y / 2.0 + high.y / 2.0);
    points().min_by(|p, q| compare_distances(middle, *p, *q).then_with(|| p.lex_cmp(q)))
}

fn by_distance<O: Observer>(board: &Board<O>, c: Point, v: VertexId, w: VertexId) -> Ordering {
    let [p, q] = [v, w].map(|v| board.point(v));
    compare_distances(c, p, q).then_with(|| p.lex_cmp(&q))
}

/// The circle about a center through a point; its radius is rounded up, but finite.
fn around(center: Point, p: Point) -> Sweep {
    let radius = length_up([center, p]).min(f64::MAX);
    Sweep::Circle { center, radius }
}

/// The circle, and the hull within it.
struct Circle {
    center: Point,
    swept: Swept,
    /// The edge of the first two points.
    seed: HalfEdgeId,
    /// From the ends of the row to infinity, the lexicographically smaller end first, while all points are
    /// on a line.
    ends: [HalfEdgeId; 2],
    /// A hull edge, once there are triangles.
    latest: Option<HalfEdgeId>,
    /// For each range of directions a half-edge that was on the hull there.
    directions: Vec<Option<HalfEdgeId>>,
    /// The first vertex of the front, as it was told.
    first: VertexId,
}

impl Circle {
    /// Begins with an edge.
    fn new<O: Observer>(board: &mut Board<O>, center: Point, ends: [VertexId; 2]) -> Self {
        let mut swept = Swept::default();
        for v in ends {
            board.tell(|| Event::PointConsidered { vertex: v });
            let p = board.point(v);
            swept.tell_at(board, || around(center, p));
        }
        let [a, b] = ends;
        let is_reversed = board.point(a).lex_cmp(&board.point(b)).is_gt();
        let seed = if is_reversed {
            board.seed(b, a)
        } else {
            board.seed(a, b)
        };
        let size = board.points().len().isqrt();
        Self {
            center,
            swept,
            seed,
            ends: [board.mesh().twin(seed).next(), seed.next()],
            latest: None,
            directions: vec![None; size],
            first: a,
        }
    }

    /// Grows until `p` is on the circle.
    fn grow<O: Observer>(&mut self, board: &mut Board<O>, p: VertexId) {
        board.at(5);
        let p = board.point(p);
        self.swept.tell_at(board, || around(self.center, p));
    }

    /// Finds a hull edge that `p` sees, or the end of the row beyond which it lies.
    fn find<O: Observer>(&self, board: &mut Board<O>, p: VertexId) -> Location {
        board.at(6);
        let Some(latest) = self.latest else {
            return self.find_at_row(board, p);
        };
        let from = self.start(board, p).unwrap_or(latest);
        board.at(7);
        let [mut onwards, mut backwards] = [from; 2];
        loop {
            if sees(board, p, onwards) {
                return Location::Outside(onwards);
            }
            onwards = board.mesh().next_hull_edge(onwards);
            // The hull edge before.
            backwards = board.mesh().twin(backwards.next()).next();
            if sees(board, p, backwards) {
                return Location::Outside(backwards);
            }
        }
    }

    fn find_at_row<O: Observer>(&self, board: &mut Board<O>, p: VertexId) -> Location {
        let [a, b] = board.ends(self.seed);
        match board.orient(a, b, p) {
            Orientation::Left => Location::Outside(self.seed),
            Orientation::Right => Location::Outside(board.mesh().twin(self.seed)),
            Orientation::Collinear => {
                let is_after = board.point(a).lex_cmp(&board.point(p)).is_lt();
                Location::Beyond(self.ends[usize::from(is_after)])
            }
        }
    }

    /// Finds a hull edge in about the direction of `p`.
    fn start<O: Observer>(&self, board: &Board<O>, p: VertexId) -> Option<HalfEdgeId> {
        let (before, after) = self.directions.split_at(self.direction(board.point(p)));
        let mut all = after.iter().chain(before).flatten().copied();
        // Half-edges whose ghost has become a triangle are out of date.
        all.find(|&h| board.mesh().apex(h).is_infinite())
    }

    /// Returns in which range a direction is: as the circle goes around, roughly.
    fn direction(&self, p: Point) -> usize {
        let [x, y] = [p.x - self.center.x, p.y - self.center.y];
        let slope = x / (x.abs() + y.abs());
        let turn = if y > 0.0 { 3.0 - slope } else { 1.0 + slope } / 4.0;
        // A NaN becomes 0.
        let range = (turn * self.directions.len() as f64) as usize;
        range.min(self.directions.len() - 1)
    }

    /// Lengthens the row.
    fn lengthen<O: Observer>(&mut self, board: &mut Board<O>, at: Location, p: VertexId) {
        board.at(8);
        let link = board.join(at, p);
        let end = usize::from(at == Location::Beyond(self.ends[1]));
        self.ends[end] = link[0].prev();
    }

    /// Joins `p` to all that it sees around the hull edge of `h`, and flips.
    fn join_outside<O: Observer>(&mut self, board: &mut Board<O>, h: HalfEdgeId, p: VertexId) {
        board.at(8);
        let link = board.join(Location::Outside(h), p);
        self.tell_front(board, &link, p);
        let [first, last] = [link[0], link[link.len() - 1]];
        let edges = [first.prev(), last.next()].map(|spoke| board.mesh().twin(spoke));
        for edge in edges {
            let [from, to] = board.ends(edge);
            let range = self.direction(board.point(if from == p { to } else { from }));
            self.directions[range] = Some(edge);
        }
        let range = self.direction(board.point(p));
        self.directions[range] = Some(edges[0]);
        self.latest = Some(edges[0]);
        board.restore(link, RESTORING);
    }

    /// Tells that `p` takes the place of what it sees on the front, which is the hull, counter-clockwise.
    ///
    /// The link goes along the hull clockwise: p comes after its last vertex.
    fn tell_front<O: Observer>(&mut self, board: &mut Board<O>, link: &[HalfEdgeId], p: VertexId) {
        let (next, last) = (board.ends(link[0])[0], board.ends(link[link.len() - 1])[1]);
        if self.latest.is_none() {
            self.first = p;
            board.enter_front(p, None);
            board.enter_front(next, Some(p));
            for &h in link {
                let [before, v] = board.ends(h);
                board.enter_front(v, Some(before));
            }
            return;
        }
        for &h in &link[1..] {
            let [v, before] = board.ends(h);
            let is_first = v == self.first;
            board.leave_front(v, (!is_first).then_some(before));
            if is_first {
                self.first = next;
            }
        }
        board.enter_front(p, Some(last));
    }
}

/// Tells whether `p` sees the hull edge of `h`, a half-edge of a ghost.
fn sees<O: Observer>(board: &mut Board<O>, p: VertexId, h: HalfEdgeId) -> bool {
    let [a, b] = board.ends(h);
    board.orient(a, b, p) == Orientation::Left
}
