//! Fortune's sweep: a line comes down, and behind it the Voronoi diagram is finished.
//!
//! Points that are as far from the line as from the nearest site form the beach line: arcs of parabolas, one
//! beside the other, that meet in breakpoints. As the line comes down, breakpoints trace the edges of the
//! diagram. An arc appears when the line meets a site, below which it begins; it ends when its two
//! breakpoints meet: in the center of a circle through three sites that holds no other, at the time when the
//! line touches the lowest point of that circle. Nothing else ever happens. What is kept here is the dual: two
//! arcs that become neighbours make an edge between their sites, an arc that ends makes a triangle.
//!
//! *Exact*: a site against a breakpoint is the sign of a polynomial ([`compare_parabolas`]); which circle ends
//! first is the sign of A + √B − √C ([`Bottom`]). So the order of events is the true one, and in general
//! position the result is the Delaunay triangulation at once.
//!
//! *Corrected*: the paper asks for no two events at one height and no four points on a circle. Here
//! circles come before sites of the same height; a site below a breakpoint divides one of the two arcs, the
//! other part of which has no width and ends at once; sites in the highest row stand side by side. Where more
//! than three points are on an empty circle, chance decides on the diagonals, and flips make them
//! canonical in the end; elsewhere nothing is flipped.
//!
//! *Cost*: O(n log n) expected for the beach line, O(n log n) for the queue; where k points share an empty circle,
//! up to O(k²) flips besides.

mod beach;
mod events;

use self::beach::{ArcId, Beach};
use self::events::Circles;
use super::restoring::Restoring;
use super::swept::Swept;
use super::{About, Board, Input, Output, Takes};
use crate::observe::{Item, Queue, Stage};
use crate::predicates::{Bottom, Orientation, circumcenter, circumradius_up, compare_parabolas};
use crate::{Error, Event, Observer, Point, Sweep, VertexId};
use std::cmp::Ordering;

/// What there is to say of it.
pub(super) const ABOUT: About = About {
    name: "fortune",
    title: "Fortune's sweep",
    source: "Fortune 1987",
    idea: "A line sweeps down the plane; where points are as near to it as to the nearest site there is a front \
           of parabolas, whose arcs appear at sites and end where three sites are on one empty circle.",
    cost: "O(n log n) expected; where k points share an empty circle, up to O(k²) flips besides",
    guarantees: "the Delaunay triangulation, made canonical by flips where four points are on a circle",
    takes: Takes::Points,
    is_delaunay: true,
    code: &[
        "put all points into the queue",
        "while there is something in the queue:",
        "  take out the highest; of equal ones circles first, then the leftmost point",
        "  if it is a point p:",
        "    find the arc above p; let a be its point",
        "    forget the circle in which this arc would end",
        "    divide the arc by one of p, and join p to a by an edge",
        "  if it is the lowest point of a circle, where an arc of b between those of a and c ends:",
        "    take the arc out, and forget the circles of its two neighbours",
        "    join a to c by an edge; a, b, c are a triangle",
        "  for each arc that has a new neighbour, and whose two breakpoints will meet:",
        "    put the lowest point of the circle of its point and its neighbours' into the queue",
        "push all edges",
        "while an edge e can be popped:",
        "  if e is not locally Delaunay, because a tie was decided otherwise:",
        "    flip e, and push the four edges around it",
    ],
};

const RESTORING: Restoring = Restoring {
    push: 13,
    pop: 14,
    examine: 15,
    flip: 16,
};

/// Sweeps from the highest point to the lowest circle.
pub(super) fn run(input: &Input, observer: &mut impl Observer) -> Result<Output, Error> {
    let (board, mut sites) = Board::new(input, observer)?;
    sites.sort_by(|&v, &w| by_height(board.point(v), board.point(w)));
    let mut sweep = Descent {
        board,
        beach: Beach::default(),
        circles: Circles::default(),
        line: Swept::default(),
        triangles: Vec::new(),
    };
    sweep.announce(&sites);
    for &site in &sites {
        sweep.close_down_to(Some(site));
        sweep.board.step()?;
        sweep.meet(site);
    }
    sweep.close_down_to(None);
    sweep.finish()
}

/// The highest first, of equal ones the leftmost.
fn by_height(p: Point, q: Point) -> Ordering {
    let descending = q.y.partial_cmp(&p.y).unwrap_or(Ordering::Equal);
    descending.then_with(|| p.lex_cmp(&q))
}

/// The line on its way down.
struct Descent<'r, O> {
    board: Board<'r, O>,
    beach: Beach,
    circles: Circles,
    line: Swept,
    /// What is finished, counter-clockwise.
    triangles: Vec<[VertexId; 3]>,
}

impl<O: Observer> Descent<'_, O> {
    fn announce(&mut self, sites: &[VertexId]) {
        self.board.at(1);
        for &v in sites {
            let item = Item::Vertex(v);
            self.board.tell_waiting(Queue::Events, item, true);
        }
    }

    /// The line meets a site, above which an arc is divided.
    fn meet(&mut self, p: VertexId) {
        self.take(Item::Vertex(p));
        let y = self.board.point(p).y;
        self.line.tell_at(&mut self.board, || Sweep::Horizontal(y));
        self.board.at(4);
        self.board.tell(|| Event::PointConsidered { vertex: p });
        self.board.at(5);
        let Some(arc) = self.find_above(p) else {
            let arc = self.beach.begin(p);
            self.tell_arc(arc, true);
            return;
        };
        let a = self.beach.site(arc);
        let at = Some(Item::Vertex(a));
        self.board.tell(|| Event::PointLocated { vertex: p, at });
        self.board.at(6);
        self.forget(arc);
        self.board.at(7);
        let middle = self.insert_after(arc, p);
        self.board.tell(|| Event::EdgeCreated { edge: [a, p] });
        if self.board.point(a).y == self.board.point(p).y {
            return; // The highest row: side by side.
        }
        let right = self.insert_after(middle, a);
        self.await_end(arc);
        self.await_end(right);
    }

    /// Ends all arcs that end before the line comes to `site`, or at the same time.
    fn close_down_to(&mut self, site: Option<VertexId>) {
        let next = site.map(|v| self.board.point(v));
        let is_next = |bottom: &Bottom| next.is_none_or(|p| bottom.compare_to(p).is_ge());
        while let Some(circle) = self.circles.pop_if(is_next) {
            self.take(Item::Triangle(circle.triangle));
            self.descend(circle.bottom, circle.triangle, next);
            self.close(circle.arc, circle.triangle);
        }
    }

    /// An arc ends.
    fn close(&mut self, arc: ArcId, triangle: [VertexId; 3]) {
        self.board.at(8);
        self.board.tell(|| Event::TriangleConsidered { triangle });
        let neighbors = [self.beach.before(arc), self.beach.after(arc)];
        self.board.at(9);
        self.tell_arc(arc, false);
        self.beach.remove(arc);
        for neighbor in neighbors.into_iter().flatten() {
            self.forget(neighbor);
        }
        self.board.at(10);
        let [c, _, a] = triangle;
        self.board.tell(|| Event::EdgeCreated { edge: [a, c] });
        self.board.tell(|| Event::TriangleCreated { triangle });
        self.triangles.push(triangle);
        for neighbor in neighbors.into_iter().flatten() {
            self.await_end(neighbor);
        }
    }

    /// Finds the arc above a site; of two that meet there either will do.
    fn find_above(&self, p: VertexId) -> Option<ArcId> {
        let p = self.board.point(p);
        let site = |arc| self.board.point(self.beach.site(arc));
        self.beach.find(|arc| {
            let left = self.beach.before(arc);
            let right = self.beach.after(arc);
            if left.is_some_and(|left| beside_breakpoint(p, site(left), site(arc)).is_lt()) {
                Ordering::Less
            } else if right
                .is_some_and(|right| beside_breakpoint(p, site(arc), site(right)).is_gt())
            {
                Ordering::Greater
            } else {
                Ordering::Equal
            }
        })
    }

    /// If the breakpoints of an arc will meet, lets the circle wait in whose lowest point they do: the sites
    /// then turn right, from the left neighbour's to the right one's.
    fn await_end(&mut self, arc: ArcId) {
        let (Some(left), Some(right)) = (self.beach.before(arc), self.beach.after(arc)) else {
            return;
        };
        let [a, b, c] = [left, arc, right].map(|arc| self.beach.site(arc));
        self.board.at(11);
        if a == c || self.board.orient(a, b, c) != Orientation::Right {
            return;
        }
        self.board.at(12);
        let triangle = [c, b, a];
        let bottom = Bottom::new(triangle.map(|v| self.board.point(v)));
        self.circles.push(arc, triangle, bottom);
        let item = Item::Triangle(triangle);
        self.board.tell_waiting(Queue::Events, item, true);
    }

    fn forget(&mut self, arc: ArcId) {
        if let Some(triangle) = self.circles.forget(arc) {
            let item = Item::Triangle(triangle);
            self.board.tell_waiting(Queue::Events, item, false);
        }
    }

    /// Tells that it is the turn of an event.
    fn take(&mut self, item: Item) {
        self.board.at(3);
        self.board.tell_waiting(Queue::Events, item, false);
    }

    fn insert_after(&mut self, left: ArcId, site: VertexId) -> ArcId {
        let arc = self.beach.insert_after(left, site);
        self.tell_arc(arc, true);
        arc
    }

    /// Tells that an arc appears, or ends.
    fn tell_arc(&mut self, arc: ArcId, appears: bool) {
        let (place, vertex, after) = (arc, self.beach.site(arc), self.beach.before(arc));
        self.board.tell(|| match appears {
            true => Event::FrontEntered {
                place,
                vertex,
                after,
            },
            false => Event::FrontLeft {
                place,
                vertex,
                after,
            },
        });
    }

    /// Tells that the line has come to the lowest point of a circle. That is rounded, but the line never goes
    /// up, nor below the next site.
    fn descend(&mut self, bottom: Bottom, triangle: [VertexId; 3], next: Option<Point>) {
        let [a, b, c] = triangle.map(|v| self.board.point(v));
        let rough = || circumcenter(a, b, c).map_or(0.0, |o| o.y - circumradius_up(a, b, c));
        let highest = match self.line.position() {
            Some(Sweep::Horizontal(y)) => y,
            _ => f64::MAX,
        };
        let lowest = next.map_or(-f64::MAX, |p| p.y);
        self.line.tell_at(&mut self.board, || {
            let y = bottom.rounded().unwrap_or_else(rough);
            Sweep::Horizontal(y.min(highest).max(lowest))
        });
    }

    /// Makes a mesh of the triangles, and flips where there were ties.
    fn finish(mut self) -> Result<Output, Error> {
        self.board.end(Stage::Sweep);
        if !self.triangles.is_empty() {
            self.board.adopt(&self.triangles);
            self.board.restore_all(RESTORING, Board::flip)?;
        }
        self.board.end(Stage::Repair);
        Ok(self.board.finish())
    }
}

/// Compares the abscissa of `p`, which is on the line, with that of the breakpoint where an arc of `a`
/// ends and one of `b` begins.
///
/// The lower site has the narrower parabola; of the two points where the parabolas meet, the one to the
/// right of it ends its arc, the one to the left begins it. Between both it is the lower parabola. Where
/// sites are equally high, so that there is one such point, `b` lies to the right of it.
fn beside_breakpoint(p: Point, a: Point, b: Point) -> Ordering {
    if a.y < b.y && p.x <= a.x {
        Ordering::Less
    } else if a.y >= b.y && p.x >= b.x {
        Ordering::Greater
    } else {
        compare_parabolas(p, a, b)
    }
}
