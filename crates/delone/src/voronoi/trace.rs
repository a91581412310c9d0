//! Following boundaries through the cells: where each crosses from one cell to the next.
//!
//! ```text
//!      cell s   ┊   cell s'
//!    p ·────────×─────────── · q      a chain of the boundary leaves s at the crossing ×,
//!               ┊                     and another begins there in s'
//! ```
//!
//! In which cell a vertex of the boundary lies is decided exactly. On the way from one vertex to the
//! next, rounded numbers say which side of the cell comes first; each step leads to a site that lies
//! farther along, so the walk ends. If rounding has led it astray, it goes on from site to nearer site,
//! which is exact again. So the crossings of a boundary always form a closed walk from cell to
//! neighbouring cell, and with them alone, not with coordinates, the overlay reasons.
//!
//! *Cost*: the sides of each cell that is passed, for each segment that passes it.

use super::diagram::{Diagram, Metric, Side};
use super::domain::Boundary;
use super::measure::{Unit, difference};
use crate::pace::Pace;
use crate::{Error, Point, VertexId};
use std::cmp::Ordering;
use std::ops::Range;

/// A boundary that goes from one cell to another.
#[derive(Clone, Copy, Debug)]
pub(super) struct Crossing {
    pub edge: u32,
    /// 1 if it goes from the left of the edge to the right, so that the domain is before it, seen along
    /// the edge, outside, and inside behind it; else −1.
    pub sign: i32,
    /// Where, rounded.
    pub at: Point,
}

/// A piece of a boundary within a cell. The one with index i ends at crossing i.
#[derive(Clone, Debug)]
pub(super) struct Chain {
    pub cell: VertexId,
    /// The crossing where it begins.
    pub enter: u32,
    /// Its vertices between the crossings, as a range of the trail.
    pub vertices: Range<usize>,
    /// The boundary that it is a piece of.
    pub ring: u32,
}

/// All boundaries, taken apart.
#[derive(Default)]
pub(super) struct Trace {
    pub crossings: Vec<Crossing>,
    pub chains: Vec<Chain>,
    pub trail: Vec<Point>,
    /// The boundaries that stay in one cell, with that cell.
    pub inner: Vec<(VertexId, u32)>,
}

/// Stands for the crossing where the first chain begins as long as it is not known.
const UNKNOWN: u32 = u32::MAX;

/// Follows boundaries.
pub(super) struct Tracer<'a, M> {
    diagram: &'a Diagram,
    sites: &'a [Point],
    metric: &'a M,
    unit: Unit,
    trace: Trace,
    /// The chain that is open: where its vertices begin, and the crossing where it does.
    open: (usize, u32),
}

/// The segment that is followed, in units.
struct Way {
    p: Point,
    q: Point,
    from: Point,
    vector: [f64; 2],
    direction: [f64; 2],
}

impl<'a, M: Metric> Tracer<'a, M> {
    /// `points` are the vertices of all boundaries.
    pub fn new(diagram: &'a Diagram, sites: &'a [Point], metric: &'a M, points: &[Point]) -> Self {
        Self {
            diagram,
            sites,
            metric,
            unit: Unit::of_points(sites.iter().chain(points)),
            trace: Trace::default(),
            open: (0, UNKNOWN),
        }
    }

    /// Follows all boundaries of a domain; `start` is some site with a cell.
    pub fn follow(
        mut self,
        rings: &[Boundary],
        points: &[Point],
        start: VertexId,
        pace: &mut Pace,
    ) -> Result<Trace, Error> {
        let mut near = start;
        for (number, ring) in (0..).zip(rings) {
            near = self.ring(number, &points[ring.points.clone()], near, pace)?;
        }
        Ok(self.trace)
    }

    /// Follows one boundary and returns the cell of its first vertex.
    fn ring(
        &mut self,
        number: u32,
        ring: &[Point],
        near: VertexId,
        pace: &mut Pace,
    ) -> Result<VertexId, Error> {
        let first_chain = self.trace.chains.len();
        let start = self.locate(ring[0], near, pace)?;
        self.open = (self.trace.trail.len(), UNKNOWN);
        let mut cell = start;
        for (i, &p) in ring.iter().enumerate() {
            self.trace.trail.push(p);
            let q = ring[(i + 1) % ring.len()];
            cell = self.walk(number, [p, q], cell, pace)?;
        }
        self.turn(number, ring[0], cell, start);
        self.close(number, first_chain, start);
        Ok(start)
    }

    /// Joins the end of a boundary to its beginning.
    fn close(&mut self, number: u32, first_chain: usize, start: VertexId) {
        let (from, enter) = self.open;
        let trace = &mut self.trace;
        if enter == UNKNOWN {
            trace.trail.truncate(from);
            trace.inner.push((start, number));
            return;
        }
        let first = trace.chains[first_chain].vertices.clone();
        trace.trail.extend_from_within(first);
        let chain = &mut trace.chains[first_chain];
        chain.enter = enter;
        chain.vertices = from..trace.trail.len();
    }

    /// Finds the cell of a point from that of another.
    fn locate(&self, q: Point, near: VertexId, pace: &mut Pace) -> Result<VertexId, Error> {
        let mut cell = near;
        while let Some(side) = self.nearest_side(q, cell) {
            pace.step()?;
            cell = self.diagram.beyond(side);
        }
        Ok(cell)
    }

    /// Returns the side of a cell beyond which the nearest site lies, if one beyond is nearer than its
    /// own.
    fn nearest_side(&self, q: Point, cell: VertexId) -> Option<Side> {
        let mut best = None;
        let mut nearest = cell;
        for side in self.diagram.sides(cell) {
            let site = self.diagram.beyond(side);
            if self.metric.compare(q, site, nearest) == Ordering::Less {
                (best, nearest) = (Some(side), site);
            }
        }
        best
    }

    /// Follows a segment from the cell of its start, and returns that of its end.
    fn walk(
        &mut self,
        ring: u32,
        segment: [Point; 2],
        mut cell: VertexId,
        pace: &mut Pace,
    ) -> Result<VertexId, Error> {
        let way = self.way(segment);
        let (mut at, mut is_astray) = (0.0, false);
        while let Some(nearest) = self.nearest_side(way.q, cell) {
            pace.step()?;
            // Astray, there is no way on along the segment, but there is one to the end of it.
            let on_the_way = if is_astray {
                None
            } else {
                self.next_side(&way, cell)
            };
            let side = match on_the_way {
                Some((side, next)) => {
                    at = next.clamp(at, 1.0);
                    side
                }
                None => {
                    at = self.meeting(&way, cell, nearest).clamp(at, 1.0);
                    is_astray = true;
                    nearest
                }
            };
            self.cross(ring, cell, side, way.place(at));
            cell = self.diagram.beyond(side);
        }
        Ok(cell)
    }

    /// Turns about a point that is equally far from several sites, from the cell of one to that of
    /// another.
    fn turn(&mut self, ring: u32, p: Point, mut cell: VertexId, goal: VertexId) {
        let mut previous = cell;
        while cell != goal {
            let is_next = |&side: &Side| {
                let site = self.diagram.beyond(side);
                site != previous && self.metric.compare(p, site, cell) == Ordering::Equal
            };
            let mut sides = self.diagram.sides(cell).filter(is_next);
            let straight = sides.clone().find(|&s| self.diagram.beyond(s) == goal);
            let side = straight.or_else(|| sides.next());
            let side = side.expect("bug: cells around a point are neighbours");
            self.cross(ring, cell, side, p);
            previous = cell;
            cell = self.diagram.beyond(side);
        }
    }

    /// Finds the side through which a segment leaves a cell, and where on the segment, if there is one.
    ///
    /// Only sites that lie farther along count; so nothing is passed twice, however numbers are rounded.
    fn next_side(&self, way: &Way, cell: VertexId) -> Option<(Side, f64)> {
        let here = self.along(way, cell);
        let mut best: Option<(Side, f64)> = None;
        for side in self.diagram.sides(cell) {
            if self.along(way, self.diagram.beyond(side)) > here {
                let at = self.meeting(way, cell, side);
                if at < best.map_or(f64::INFINITY, |(_, least)| least) {
                    best = Some((side, at));
                }
            }
        }
        best
    }

    /// How far along a segment a site lies.
    fn along(&self, way: &Way, site: VertexId) -> f64 {
        let s = self.unit.scaled(self.sites[site.index()]);
        let [x, y] = way.direction;
        (s.x - way.from.x) * x + (s.y - way.from.y) * y
    }

    /// Finds at which part of a segment the sites at both sides of an edge are equally far: infinity if
    /// nowhere.
    fn meeting(&self, way: &Way, cell: VertexId, side: Side) -> f64 {
        let sites = [cell, self.diagram.beyond(side)];
        let [s, t] = sites.map(|v| self.sites[v.index()]);
        let (normal, size) = difference(s, t);
        let [a, b] = [s, t].map(|s| {
            let s = self.unit.scaled(s);
            [s.x - way.from.x, s.y - way.from.y]
        });
        let [h, k] = sites.map(|v| self.unit.squares(self.metric.handicap(v)));
        let middle = [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])];
        let mut distance = normal[0] * middle[0] + normal[1] * middle[1];
        if h != k {
            distance += 0.5 * (k - h) / self.unit.units(size);
        }
        let speed = normal[0] * way.vector[0] + normal[1] * way.vector[1];
        if speed > 0.0 {
            distance / speed
        } else {
            f64::INFINITY
        }
    }

    fn way(&self, [p, q]: [Point; 2]) -> Way {
        let [from, to] = [p, q].map(|p| self.unit.scaled(p));
        Way {
            p,
            q,
            from,
            vector: [to.x - from.x, to.y - from.y],
            direction: difference(p, q).0,
        }
    }

    /// Ends the open chain at a crossing, and opens the next.
    fn cross(&mut self, ring: u32, cell: VertexId, side: Side, at: Point) {
        let (from, enter) = self.open;
        let trace = &mut self.trace;
        let number = trace.crossings.len() as u32;
        trace.crossings.push(Crossing {
            edge: side.edge,
            sign: if side.is_reversed { -1 } else { 1 },
            at,
        });
        trace.chains.push(Chain {
            cell,
            enter,
            vertices: from..trace.trail.len(),
            ring,
        });
        self.open = (trace.trail.len(), number);
    }
}

impl Way {
    /// Returns the point at a part of the segment, rounded, never outside its box.
    fn place(&self, at: f64) -> Point {
        let between = |a: f64, b: f64| {
            let c = (1.0 - at) * a + at * b;
            c.clamp(a.min(b), a.max(b))
        };
        Point::new(between(self.p.x, self.q.x), between(self.p.y, self.q.y))
    }
}
