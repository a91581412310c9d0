//! What of each cell lies in a domain, from the crossings of its boundaries with the edges.
//!
//! Along the edges of the diagram the *level* counts how often the domain lies around: 0 outside, 1
//! inside. It changes where a boundary crosses, is 0 at infinity, and as every boundary is a closed walk
//! from cell to cell, it is the same whichever way it is found: no coordinate is asked.
//!
//! ```text
//!       ┌─────────×───┐        Around a cell, counter-clockwise, the domain begins at × where a chain
//!       │  part  ↗    │        of the boundary leaves, and ends at + where one enters. So from each ×
//!       ×       /     │        the outline of a part goes on along the cell to the + that belongs to
//!       │ `.___+──────┘        it, and from there along the chain.
//! ```
//!
//! Along an edge crossings are sorted by their coordinates, which rounding may make equal, but does not
//! exchange. Of those in one place the order is chosen so that levels stay 0 and 1, if it can be.
//!
//! *Cost*: O(n + k log k) for n cells and k crossings.

use super::cut::Cutter;
use super::diagram::{AT_INFINITY, Diagram, Side};
use super::domain::Domain;
use super::measure::distance;
use super::parts::Shapes;
use super::trace::Trace;
use crate::pace::{Pace, Strides};
use crate::parallel::{Workers, joined};
use crate::{Error, Point, VertexId};
use std::cmp::Ordering;
use std::ops::Range;

/// The level of an edge that has not been reached yet.
const UNKNOWN: i32 = i32::MIN;

/// A diagram and what crosses it.
pub(super) struct Overlay<'a> {
    pub diagram: &'a Diagram,
    pub domain: &'a Domain,
    pub trace: Trace,
    /// The crossings, edge by edge, in the order along each.
    order: Vec<u32>,
    /// Where those of each edge begin in `order`.
    starts: Vec<u32>,
    /// The level at the beginning of each edge.
    pub levels: Vec<i32>,
    /// For each crossing the chain that begins there.
    pub begins: Vec<u32>,
    /// The chains by their cells.
    by_cell: Vec<u32>,
    /// The boundaries within a cell, by their cells.
    inner: Vec<(VertexId, u32)>,
}

impl<'a> Overlay<'a> {
    pub fn new(
        diagram: &'a Diagram,
        sites: &[Point],
        domain: &'a Domain,
        mut trace: Trace,
        pace: &mut Pace,
    ) -> Result<Self, Error> {
        let mut begins = vec![0; trace.crossings.len()];
        for (i, chain) in (0..).zip(&trace.chains) {
            begins[chain.enter as usize] = i;
        }
        let mut by_cell: Vec<u32> = (0..trace.chains.len() as u32).collect();
        by_cell.sort_by_key(|&i| trace.chains[i as usize].cell);
        let mut inner = std::mem::take(&mut trace.inner);
        inner.sort();
        let (order, starts) = sorted(diagram, sites, &trace);
        let mut overlay = Self {
            diagram,
            domain,
            trace,
            order,
            starts,
            levels: vec![UNKNOWN; diagram.edges.len()],
            begins,
            by_cell,
            inner,
        };
        overlay.find_levels(sites.len(), pace)?;
        overlay.settle_ties();
        Ok(overlay)
    }

    /// Returns the crossings of an edge, in order.
    pub fn crossings(&self, edge: u32) -> &[u32] {
        let [start, end] = [0, 1].map(|k| self.starts[edge as usize + k] as usize);
        &self.order[start..end]
    }

    /// Returns by how much the level rises along an edge.
    pub fn rise(&self, edge: u32) -> i32 {
        let crossings = self.crossings(edge).iter();
        crossings
            .map(|&c| self.trace.crossings[c as usize].sign)
            .sum()
    }

    /// Finds the levels, from cell to cell, beginning at infinity.
    fn find_levels(&mut self, num_sites: usize, pace: &mut Pace) -> Result<(), Error> {
        let mut stack: Vec<VertexId> = Vec::new();
        let mut is_seen = vec![false; num_sites];
        for site in (0..num_sites).map(VertexId::new) {
            let first = self.diagram.sides(site).next();
            if first.is_some_and(|side| self.diagram.ends(side)[0] == AT_INFINITY) {
                is_seen[site.index()] = true;
                stack.push(site);
            }
        }
        while let Some(site) = stack.pop() {
            pace.step()?;
            self.find_levels_around(site);
            for side in self.diagram.sides(site) {
                let beyond = self.diagram.beyond(side);
                if !std::mem::replace(&mut is_seen[beyond.index()], true) {
                    stack.push(beyond);
                }
            }
        }
        Ok(())
    }

    /// Finds the levels around a cell, which touches infinity, or of which some level is known.
    fn find_levels_around(&mut self, site: VertexId) {
        let diagram = self.diagram;
        let known = |side: Side| {
            let at_infinity = diagram.ends(side)[0] == AT_INFINITY;
            at_infinity || self.levels[side.edge as usize] != UNKNOWN
        };
        let sides = diagram.sides(site);
        let first = sides.clone().position(known);
        let first = first.expect("bug: a cell of which no level is known");
        let mut level = 0;
        for side in sides.clone().skip(first).chain(sides.take(first)) {
            let rise = self.rise(side.edge);
            let [from, to] = diagram.ends(side);
            let found = &mut self.levels[side.edge as usize];
            if *found == UNKNOWN {
                let start = if from == AT_INFINITY { 0 } else { level };
                *found = if side.is_reversed {
                    start - rise
                } else {
                    start
                };
            }
            level = match side.is_reversed {
                _ if to == AT_INFINITY => 0,
                true => *found,
                false => *found + rise,
            };
        }
    }

    /// Orders crossings in one place so that levels stay between 0 and 1, if they can.
    fn settle_ties(&mut self) {
        for edge in 0..self.diagram.edges.len() {
            let [start, end] = [0, 1].map(|k| self.starts[edge + k] as usize);
            if end - start < 2 {
                continue;
            }
            let crossing = |c: u32| self.trace.crossings[c as usize];
            let mut level = self.levels[edge];
            for i in start..end {
                let here = crossing(self.order[i]).at;
                let mut alike = (i..end).take_while(|&j| crossing(self.order[j]).at == here);
                let wanted = if level <= 0 { 1 } else { -1 };
                if let Some(j) = alike.find(|&j| crossing(self.order[j]).sign == wanted) {
                    self.order[i..=j].rotate_right(1);
                }
                level += crossing(self.order[i]).sign;
            }
        }
    }

    /// Cuts out all cells, and measures how much of each edge lies in the domain.
    pub fn cut(
        &self,
        num_sites: usize,
        workers: Workers,
        pace: &Pace,
    ) -> Result<(Shapes, Vec<f64>), Error> {
        let shapes = workers.ranges(num_sites, |sites| self.cut_some(sites, pace.strides()))?;
        let mut shapes = shapes.into_iter();
        let mut all = shapes.next().unwrap_or_default();
        shapes.for_each(|shapes| all.append(&shapes));
        let lengths = workers.ranges(self.diagram.edges.len(), |edges| {
            let lengths = edges.map(|edge| self.length_inside(edge as u32));
            Ok(lengths.collect())
        })?;
        Ok((all, joined(lengths)))
    }

    /// Cuts out some cells.
    fn cut_some(&self, sites: Range<usize>, mut strides: Strides) -> Result<Shapes, Error> {
        let mut shapes = Shapes::default();
        let mut cutter = Cutter::new(self);
        let first = VertexId::new(sites.start);
        let cell_of = |&i: &u32| self.trace.chains[i as usize].cell;
        let (mut chains, mut inner) = (&self.by_cell[..], &self.inner[..]);
        chains = &chains[chains.partition_point(|i| cell_of(i) < first)..];
        inner = &inner[inner.partition_point(|&(cell, _)| cell < first)..];
        for site in sites.map(VertexId::new) {
            strides.step()?;
            let number = chains.iter().take_while(|i| cell_of(i) == site).count();
            let rings = inner.iter().take_while(|(cell, _)| *cell == site).count();
            cutter.cut(site, number > 0, &inner[..rings], &mut shapes);
            (chains, inner) = (&chains[number..], &inner[rings..]);
            shapes.end_cell();
        }
        Ok(shapes)
    }

    /// Measures how much of an edge lies in the domain.
    fn length_inside(&self, edge: u32) -> f64 {
        let mut level = self.levels[edge as usize];
        let crossings = self.crossings(edge);
        if level < 1 && crossings.is_empty() {
            return 0.0;
        }
        let [from, to] = self.diagram.edges[edge as usize].ends;
        let corner = |v: u32| self.diagram.vertices.get(v as usize).copied();
        let mut last = corner(from);
        let mut sum = 0.0;
        for crossing in crossings.iter().map(|&c| self.trace.crossings[c as usize]) {
            if level >= 1 {
                sum += last.map_or(0.0, |last| distance(last, crossing.at));
            }
            level += crossing.sign;
            last = Some(crossing.at);
        }
        match (last, corner(to)) {
            (Some(last), Some(end)) if level >= 1 => sum + distance(last, end),
            _ => sum,
        }
    }
}

/// Sorts crossings by their edges, and along each of these.
fn sorted(diagram: &Diagram, sites: &[Point], trace: &Trace) -> (Vec<u32>, Vec<u32>) {
    let mut starts = vec![0; diagram.edges.len() + 1];
    for crossing in &trace.crossings {
        starts[crossing.edge as usize + 1] += 1;
    }
    for i in 1..starts.len() {
        starts[i] += starts[i - 1];
    }
    let mut order: Vec<u32> = (0..trace.crossings.len() as u32).collect();
    let crossing = |c: u32| &trace.crossings[c as usize];
    order.sort_by(|&c, &d| {
        let (c, d) = (crossing(c), crossing(d));
        let along = || {
            along(
                diagram.edges[c.edge as usize]
                    .sites
                    .map(|v| sites[v.index()]),
            )
        };
        c.edge
            .cmp(&d.edge)
            .then_with(|| compare_along(along(), c.at, d.at))
    });
    (order, starts)
}

/// Returns to which side and in which vertical direction an edge between two sites runs, the first to its
/// left: to where the vector from the first to the second points when it is turned to the left.
fn along([left, right]: [Point; 2]) -> [Ordering; 2] {
    let compare = |a: f64, b: f64| a.partial_cmp(&b).unwrap_or(Ordering::Equal);
    [compare(left.y, right.y), compare(right.x, left.x)]
}

/// Compares places on a line. They are rounded, but rounding is monotone: neither of their coordinates is
/// ever in the wrong order.
fn compare_along([x, y]: [Ordering; 2], p: Point, q: Point) -> Ordering {
    let by = |direction: Ordering, a: f64, b: f64| match direction {
        Ordering::Greater => a.total_cmp(&b),
        Ordering::Less => b.total_cmp(&a),
        Ordering::Equal => Ordering::Equal,
    };
    by(x, p.x, q.x).then_with(|| by(y, p.y, q.y))
}
