//! Following boundaries through the cells: where each crosses from one cell to the next.
//!
//! ```text
//!      cell s   ┊   cell s'
//!    p ·────────×─────────── · q      a chain of the boundary leaves s at the crossing ×,
//!               ┊                     and another begins there in s'
//! ```
//!
//! Every step is exact: in which cell a vertex of the boundary lies, and through which side a segment
//! leaves a cell. Where that is undecided, because the boundary runs along edges or through vertices of the
//! diagram, it counts as if it were shifted to its left, a little into the domain: so the cells at its
//! other side are not touched. Only the places of crossings are rounded, correctly.
//!
//! *Terminates*: each step along a segment leads to a site that lies farther along.
//!
//! *Cost*: the sides of each cell that is passed, for each segment that passes it.

use super::diagram::{Diagram, Metric, Side};
use super::domain::Boundary;
use crate::pace::Pace;
use crate::predicates::{Orientation, orient2d, turning};
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
    trace: Trace,
    /// The chain that is open: where its vertices begin, and the crossing where it does.
    open: (usize, u32),
}

impl<'a, M: Metric> Tracer<'a, M> {
    pub fn new(diagram: &'a Diagram, sites: &'a [Point], metric: &'a M) -> Self {
        Self {
            diagram,
            sites,
            metric,
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
        let mut start = self.locate(ring[0], near, pace)?;
        let way = |i: usize| [ring[i], ring[(i + 1) % ring.len()]];
        while let Some(side) = self.side_to_the_left(way(0), ring[0], start) {
            start = self.diagram.beyond(side);
        }
        self.open = (self.trace.trail.len(), UNKNOWN);
        let mut cell = start;
        for (i, &p) in ring.iter().enumerate() {
            self.trace.trail.push(p);
            cell = self.keep_left(number, way(i), p, cell);
            cell = self.walk(number, way(i), cell, pace)?;
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
        way: [Point; 2],
        mut cell: VertexId,
        pace: &mut Pace,
    ) -> Result<VertexId, Error> {
        while self.nearest_side(way[1], cell).is_some() {
            pace.step()?;
            let side = self.next_side(way, cell);
            let beyond = self.diagram.beyond(side);
            let at = self.metric.place(way, cell, beyond);
            self.cross(ring, cell, side, at);
            cell = beyond;
        }
        Ok(self.keep_left(ring, way, way[1], cell))
    }

    /// Finds the side through which a segment that ends elsewhere leaves a cell. If it leaves through a
    /// corner, that is the side at its left.
    fn next_side(&self, way: [Point; 2], cell: VertexId) -> Side {
        let at = |site: VertexId| self.sites[site.index()];
        let mut best: Option<(Side, VertexId)> = None;
        for side in self.diagram.sides(cell) {
            let site = self.diagram.beyond(side);
            if self.metric.towards(way, cell, site) != Ordering::Greater {
                continue;
            }
            let is_first = best.is_none_or(|(_, other)| {
                match self.metric.compare_meetings(way, cell, site, other) {
                    Ordering::Less => true,
                    Ordering::Greater => false,
                    Ordering::Equal => orient2d(at(cell), at(other), at(site)) == Orientation::Left,
                }
            });
            if is_first {
                best = Some((side, site));
            }
        }
        best.expect("bug: a way that leads nowhere").0
    }

    /// Of the cells that touch at a point of a segment, goes to the one at its left.
    fn keep_left(&mut self, ring: u32, way: [Point; 2], p: Point, mut cell: VertexId) -> VertexId {
        while let Some(side) = self.side_to_the_left(way, p, cell) {
            self.cross(ring, cell, side, p);
            cell = self.diagram.beyond(side);
        }
        cell
    }

    /// Finds the side of a cell through `p` beyond which the site lies most to the left, if it lies more so
    /// than the cell's own.
    fn side_to_the_left(&self, way: [Point; 2], p: Point, cell: VertexId) -> Option<Side> {
        let mut best = None;
        let mut leftmost = cell;
        for side in self.diagram.sides(cell) {
            let site = self.diagram.beyond(side);
            if self.metric.compare(p, site, cell) == Ordering::Equal {
                let ends = [leftmost, site].map(|v| self.sites[v.index()]);
                if turning(way, ends) == Orientation::Left {
                    (best, leftmost) = (Some(side), site);
                }
            }
        }
        best
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
