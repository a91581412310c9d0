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
//! A cell that no boundary enters or lies in is taken as it is, or left out.
//!
//! *Cost*: O(n log n + k log k) for n cells and k crossings, in practice linear in n; see `levels.rs`.

use super::cut::Cutter;
use super::diagram::Diagram;
use super::domain::Domain;
use super::levels::Levels;
use super::measure::distance;
use super::parts::Shapes;
use super::trace::{Crossing, Trace};
use crate::memory::reserve;
use crate::pace::{Pace, Strides};
use crate::parallel::{Workers, joined};
use crate::{Error, Point, VertexId};
use std::cmp::Ordering;

/// A diagram and what crosses it.
pub(super) struct Overlay<'a> {
    pub diagram: &'a Diagram,
    pub domain: &'a Domain,
    pub trace: Trace,
    /// The crossings, edge by edge, in the order along each.
    order: Vec<u32>,
    pub levels: Levels,
    /// For each crossing the chain that begins there.
    pub begins: Vec<u32>,
    /// The cells that chains pass, sorted.
    passed: Vec<VertexId>,
    /// The boundaries within a cell, by their cells.
    inner: Vec<(VertexId, u32)>,
    /// For each cell whether it is one of those.
    is_touched: Vec<bool>,
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
        let mut passed: Vec<_> = trace.chains.iter().map(|chain| chain.cell).collect();
        passed.sort_unstable();
        passed.dedup();
        let mut inner = std::mem::take(&mut trace.inner);
        inner.sort();
        let mut is_touched = vec![false; sites.len()];
        let entered = inner.iter().map(|(cell, _)| cell).chain(&passed);
        entered.for_each(|cell| is_touched[cell.index()] = true);
        let order = sorted(diagram, sites, &trace);
        let mut overlay = Self {
            diagram,
            domain,
            trace,
            order,
            levels: Levels::of(diagram.vertices.len()),
            begins,
            passed,
            inner,
            is_touched,
        };
        overlay.find_levels(pace)?;
        overlay.settle_ties();
        Ok(overlay)
    }

    /// Returns the crossings of an edge, in order.
    pub fn crossings(&self, edge: u32) -> &[u32] {
        self.crossings_from(edge).of(edge)
    }

    /// Returns the crossings of an edge and of those after it.
    fn crossings_from(&self, edge: u32) -> Crossings<'_> {
        let crossings = &self.trace.crossings;
        let start = self
            .order
            .partition_point(|&c| crossings[c as usize].edge < edge);
        Crossings {
            crossings,
            order: &self.order[start..],
        }
    }

    /// Finds the levels of all vertices.
    fn find_levels(&mut self, pace: &mut Pace) -> Result<(), Error> {
        let trace = &self.trace;
        let mut crossings = Crossings {
            crossings: &trace.crossings,
            order: &self.order,
        };
        for (number, edge) in (0..).zip(&self.diagram.edges) {
            pace.step()?;
            let signs = crossings
                .of(number)
                .iter()
                .map(|&c| trace.crossings[c as usize].sign);
            self.levels.join(edge.ends, signs.sum());
        }
        self.levels.settle();
        Ok(())
    }

    /// Orders crossings in one place so that levels stay between 0 and 1, if they can.
    fn settle_ties(&mut self) {
        let crossings = &self.trace.crossings;
        let crossing = |c: u32| crossings[c as usize];
        let is_same = |&c: &u32, &d: &u32| crossing(c).edge == crossing(d).edge;
        for order in self
            .order
            .chunk_by_mut(is_same)
            .filter(|order| order.len() > 1)
        {
            let [from, _] = self.diagram.edges[crossing(order[0]).edge as usize].ends;
            let mut level = self.levels.at(from);
            for i in 0..order.len() {
                let here = crossing(order[i]).at;
                let mut alike = (i..order.len()).take_while(|&j| crossing(order[j]).at == here);
                let wanted = if level <= 0 { 1 } else { -1 };
                if let Some(j) = alike.find(|&j| crossing(order[j]).sign == wanted) {
                    order[i..=j].rotate_right(1);
                }
                level += crossing(order[i]).sign;
            }
        }
    }

    /// Cuts out all cells, and measures how much of each edge lies in the domain.
    pub fn cut(&self, workers: Workers, pace: &Pace) -> Result<(Shapes, Vec<f64>), Error> {
        let order = &self.diagram.order;
        let shapes = workers.ranges(order.len(), |ranks| {
            self.cut_some(&order[ranks], pace.strides())
        })?;
        let mut shapes = shapes.into_iter();
        let mut all = shapes.next().unwrap_or_default();
        shapes.for_each(|shapes| all.append(&shapes));
        all.number(order);
        let lengths = workers.ranges(self.diagram.edges.len(), |edges| {
            let mut crossings = self.crossings_from(edges.start as u32);
            let mut lengths = reserve(edges.len());
            lengths.extend(edges.map(|edge| {
                let edge = edge as u32;
                self.length_inside(edge, crossings.of(edge))
            }));
            Ok(lengths)
        })?;
        Ok((all, joined(lengths)))
    }

    /// Cuts out some cells.
    fn cut_some(&self, sites: &[VertexId], mut strides: Strides) -> Result<Shapes, Error> {
        let mut shapes = Shapes::with_capacity(sites.len());
        let mut cutter = Cutter::new(self);
        for &site in sites {
            strides.step()?;
            if self.is_touched[site.index()] {
                let has_chains = self.passed.binary_search(&site).is_ok();
                cutter.cut(site, has_chains, self.rings_in(site), &mut shapes);
            } else {
                cutter.take(site, &mut shapes);
            }
            shapes.end_cell();
        }
        Ok(shapes)
    }

    /// Returns the boundaries that lie in a cell.
    fn rings_in(&self, site: VertexId) -> &[(VertexId, u32)] {
        let start = self.inner.partition_point(|&(cell, _)| cell < site);
        let end = self.inner.partition_point(|&(cell, _)| cell <= site);
        &self.inner[start..end]
    }

    /// Measures how much of an edge lies in the domain.
    fn length_inside(&self, edge: u32, crossings: &[u32]) -> f64 {
        let [from, to] = self.diagram.edges[edge as usize].ends;
        let mut level = self.levels.at(from);
        if level < 1 && crossings.is_empty() {
            return 0.0;
        }
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

/// Crossings edge by edge, to be asked for edges in their order.
struct Crossings<'a> {
    crossings: &'a [Crossing],
    /// Those that have not been passed.
    order: &'a [u32],
}

impl<'a> Crossings<'a> {
    /// Passes those of an edge, and returns them; none of an edge before it may be left.
    #[inline]
    fn of(&mut self, edge: u32) -> &'a [u32] {
        let is_here = |c: &&u32| self.crossings[**c as usize].edge == edge;
        let number = self.order.iter().take_while(is_here).count();
        let (here, rest) = self.order.split_at(number);
        self.order = rest;
        here
    }
}

/// Sorts crossings by their edges, and along each of these.
fn sorted(diagram: &Diagram, sites: &[Point], trace: &Trace) -> Vec<u32> {
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
    order
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
