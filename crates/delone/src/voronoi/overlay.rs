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
//! Where crossings nearly coincide, rounding may exchange them, so that levels of −1 and 2 occur for an
//! instant; there × and + are matched as parentheses are, backwards if need be. What one cell gets too
//! much, its neighbour gets too little, so areas still add up.
//!
//! *Cost*: O(n + k log k) for n cells and k crossings.

use super::diagram::{AT_INFINITY, Diagram, Side};
use super::domain::Domain;
use super::measure::{Moments, Unit, difference, distance};
use super::parts::Shapes;
use super::trace::Trace;
use crate::pace::Pace;
use crate::{Error, Point, VertexId};

/// The level of an edge that has not been reached yet.
const UNKNOWN: i32 = i32::MIN;

/// A diagram and what crosses it.
pub(super) struct Overlay<'a> {
    diagram: &'a Diagram,
    domain: &'a Domain,
    trace: Trace,
    /// The crossings, edge by edge, in the order along each.
    order: Vec<u32>,
    /// Where those of each edge begin in `order`.
    starts: Vec<u32>,
    /// The level at the beginning of each edge.
    levels: Vec<i32>,
    /// For each crossing the chain that begins there.
    begins: Vec<u32>,
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
    fn crossings(&self, edge: u32) -> &[u32] {
        let [start, end] = [0, 1].map(|k| self.starts[edge as usize + k] as usize);
        &self.order[start..end]
    }

    /// Returns by how much the level rises along an edge.
    fn rise(&self, edge: u32) -> i32 {
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
    pub fn cut(self, num_sites: usize, pace: &mut Pace) -> Result<(Shapes, Vec<f64>), Error> {
        let mut shapes = Shapes::default();
        let mut cutter = Cutter::new(&self);
        let (mut chains, mut inner) = (&self.by_cell[..], &self.inner[..]);
        for site in (0..num_sites).map(VertexId::new) {
            pace.step()?;
            let of_cell = |&i: &u32| self.trace.chains[i as usize].cell == site;
            let number = chains.iter().take_while(|i| of_cell(i)).count();
            let rings = inner.iter().take_while(|(cell, _)| *cell == site).count();
            cutter.cut(site, number > 0, &inner[..rings], &mut shapes);
            (chains, inner) = (&chains[number..], &inner[rings..]);
            shapes.end_cell();
        }
        let edges = 0..self.diagram.edges.len() as u32;
        let lengths = edges.map(|edge| self.length_inside(edge)).collect();
        Ok((shapes, lengths))
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
    let unit = Unit::of_points(sites.iter().chain(trace.crossings.iter().map(|c| &c.at)));
    let key = |c: u32| {
        let crossing = &trace.crossings[c as usize];
        let edge = &diagram.edges[crossing.edge as usize];
        let [left, right] = edge.sites.map(|v| sites[v.index()]);
        // Along the edge: the vector from the left to the right, turned to the left.
        let ([x, y], _) = difference(left, right);
        let [at, left] = [crossing.at, left].map(|p| unit.scaled(p));
        (at.y - left.y) * x - (at.x - left.x) * y
    };
    let mut order: Vec<(u32, f64, u32)> = (0..trace.crossings.len() as u32)
        .map(|c| (trace.crossings[c as usize].edge, key(c), c))
        .collect();
    order.sort_by(|a, b| a.0.cmp(&b.0).then_with(|| a.1.total_cmp(&b.1)));
    (order.into_iter().map(|(.., c)| c).collect(), starts)
}

/// What one meets around a cell.
#[derive(Clone, Copy, Debug)]
enum Event {
    /// A crossing, and by how much the level rises there.
    Crossing(u32, i32),
    Corner(u32),
    Infinity,
}

/// How the outline of a part goes on from where a chain leaves the cell.
#[derive(Clone, Copy, Debug)]
struct Arc {
    /// The event where the next chain enters.
    to: usize,
    is_backwards: bool,
}

/// An outline of a part of the cell, and the piece of the domain that it belongs to, if that is known.
struct Outline {
    points: Vec<Point>,
    piece: Option<u32>,
}

/// Cuts out one cell after the other.
struct Cutter<'a> {
    overlay: &'a Overlay<'a>,
    events: Vec<Event>,
    arcs: Vec<Option<Arc>>,
    /// For each crossing its event around the present cell.
    places: Vec<u32>,
    outlines: Vec<Outline>,
}

impl<'a> Cutter<'a> {
    fn new(overlay: &'a Overlay<'a>) -> Self {
        Self {
            overlay,
            events: Vec::new(),
            arcs: Vec::new(),
            places: vec![0; overlay.trace.crossings.len()],
            outlines: Vec::new(),
        }
    }

    /// Adds the parts of a cell.
    fn cut(
        &mut self,
        site: VertexId,
        has_chains: bool,
        rings: &[(VertexId, u32)],
        shapes: &mut Shapes,
    ) {
        self.outlines.clear();
        let level = self.collect(site);
        if has_chains {
            let base = self.match_crossings(level);
            if base >= 1 {
                self.add_whole();
            }
            self.add_outlines();
        } else if level >= 1 {
            self.add_whole();
        }
        let mut holes = Vec::new();
        for &(_, number) in rings {
            let ring = &self.overlay.domain.rings()[number as usize];
            let points = &self.overlay.domain.points()[ring.points.clone()];
            if ring.is_outer {
                self.add_outline(points.to_vec(), Some(ring.piece));
            } else {
                holes.push((points, ring.piece));
            }
        }
        self.hand_out(holes, shapes);
    }

    /// Lists what lies around a cell and returns the level before the first of it.
    fn collect(&mut self, site: VertexId) -> i32 {
        let overlay = self.overlay;
        self.events.clear();
        let mut first = None;
        for side in overlay.diagram.sides(site) {
            let sign = if side.is_reversed { -1 } else { 1 };
            let event = |&c: &u32| {
                let rise = overlay.trace.crossings[c as usize].sign;
                Event::Crossing(c, sign * rise)
            };
            let crossings = overlay.crossings(side.edge);
            let level = overlay.levels[side.edge as usize];
            if side.is_reversed {
                first = first.or(Some(level + overlay.rise(side.edge)));
                self.events.extend(crossings.iter().rev().map(event));
            } else {
                first = first.or(Some(level));
                self.events.extend(crossings.iter().map(event));
            }
            self.events.push(match overlay.diagram.ends(side)[1] {
                AT_INFINITY => Event::Infinity,
                corner => Event::Corner(corner),
            });
        }
        first.unwrap_or(0)
    }

    /// Matches the crossings where chains leave the cell with those where chains enter it, and returns
    /// the level that the whole of the cell has beyond that: 0, unless its boundary is inside all around.
    fn match_crossings(&mut self, level: i32) -> i32 {
        let (mut least, mut most, mut now) = (level, level, level);
        for event in &self.events {
            if let Event::Crossing(_, rise) = event {
                now += rise;
                (least, most) = (least.min(now), most.max(now));
            }
        }
        debug_assert_eq!(now, level, "levels around a cell do not close");
        let base = 0_i32.clamp(least, most);
        let len = self.events.len();
        self.arcs.clear();
        self.arcs.resize(len, None);
        let start = self.first_at(level, base);
        let (mut leaving, mut entering) = (Vec::new(), Vec::new());
        let mut now = base;
        for i in (start..len).chain(0..start) {
            let Event::Crossing(c, rise) = self.events[i] else {
                continue;
            };
            self.places[c as usize] = i as u32;
            match rise > 0 {
                true if now >= base => leaving.push(i),
                true => {
                    let to = entering.pop().expect("bug: levels that do not add up");
                    let is_backwards = true;
                    self.arcs[i] = Some(Arc { to, is_backwards });
                }
                false if now > base => {
                    let from: usize = leaving.pop().expect("bug: levels that do not add up");
                    let is_backwards = false;
                    self.arcs[from] = Some(Arc {
                        to: i,
                        is_backwards,
                    });
                }
                false => entering.push(i),
            }
            now += rise;
        }
        base
    }

    /// Finds an event before which the level is `base`.
    fn first_at(&self, level: i32, base: i32) -> usize {
        let mut now = level;
        for (i, event) in self.events.iter().enumerate() {
            if now == base {
                return i;
            }
            if let Event::Crossing(_, rise) = event {
                now += rise;
            }
        }
        0
    }

    /// Adds the cell itself.
    fn add_whole(&mut self) {
        let points = self.events.iter().filter_map(|&e| self.corner(e)).collect();
        self.add_outline(points, None);
    }

    fn corner(&self, event: Event) -> Option<Point> {
        match event {
            Event::Corner(v) => Some(self.overlay.diagram.vertices[v as usize]),
            _ => None,
        }
    }

    /// Follows chains and arcs until all are used up.
    fn add_outlines(&mut self) {
        let overlay = self.overlay;
        for first in 0..self.events.len() {
            let Event::Crossing(enter, -1) = self.events[first] else {
                continue;
            };
            let mut points = Vec::new();
            let mut piece = None;
            let mut enter = enter;
            loop {
                let chain = &overlay.trace.chains[overlay.begins[enter as usize] as usize];
                let exit = overlay.begins[enter as usize];
                points.push(overlay.trace.crossings[enter as usize].at);
                points.extend(&overlay.trace.trail[chain.vertices.clone()]);
                points.push(overlay.trace.crossings[exit as usize].at);
                piece = Some(overlay.domain.rings()[chain.ring as usize].piece).or(piece);
                // An arc that is used up begins no more.
                let place = self.places[exit as usize] as usize;
                let Some(arc) = self.arcs[place].take() else {
                    points.clear();
                    break;
                };
                self.add_arc(place, arc, &mut points);
                if arc.to == first {
                    break;
                }
                let Event::Crossing(next, _) = self.events[arc.to] else {
                    unreachable!("bug: an arc leads to a crossing");
                };
                enter = next;
            }
            self.add_outline(points, piece);
        }
    }

    /// Adds the corners of the cell along an arc.
    fn add_arc(&self, from: usize, arc: Arc, points: &mut Vec<Point>) {
        let len = self.events.len();
        let mut i = from;
        while i != arc.to {
            i = match arc.is_backwards {
                true => (i + len - 1) % len,
                false => (i + 1) % len,
            };
            points.extend(self.corner(self.events[i]));
        }
    }

    /// Adds an outline, without repeated points, unless there is no area in it.
    fn add_outline(&mut self, mut points: Vec<Point>, piece: Option<u32>) {
        points.dedup();
        while points.len() > 1 && points.first() == points.last() {
            points.pop();
        }
        if points.len() < 3 {
            return;
        }
        if Moments::of(std::iter::once(&points[..])).doubled_area() > 0.0 {
            self.outlines.push(Outline { points, piece });
        }
    }

    /// Hands out the parts, each with the holes in it.
    fn hand_out(&mut self, holes: Vec<(&[Point], u32)>, shapes: &mut Shapes) {
        let mut by_part: Vec<Vec<&[Point]>> = vec![Vec::new(); self.outlines.len()];
        for (hole, piece) in holes {
            if let Some(part) = self.part_around(hole, piece) {
                by_part[part].push(hole);
            }
        }
        for (outline, holes) in self.outlines.iter().zip(by_part) {
            shapes.add_ring(&outline.points);
            holes.into_iter().for_each(|hole| shapes.add_ring(hole));
            shapes.end_part();
        }
    }

    /// Finds the part in which a hole lies: most often only one belongs to the same piece of the domain.
    fn part_around(&self, hole: &[Point], piece: u32) -> Option<usize> {
        let belongs = |&i: &usize| self.outlines[i].piece.is_none_or(|p| p == piece);
        let mut candidates = (0..self.outlines.len()).filter(belongs);
        let first = candidates.next()?;
        let Some(second) = candidates.next() else {
            return Some(first);
        };
        let mut all = [first, second].into_iter().chain(candidates);
        let around = all.find(|&i| surrounds(&self.outlines[i].points, hole[0]));
        Some(around.unwrap_or(first))
    }
}

/// Tells whether a ring goes around a point: whether it passes below it an odd number of times.
fn surrounds(ring: &[Point], p: Point) -> bool {
    use crate::predicates::{Orientation, orient2d};
    let mut is_inside = false;
    let mut a = ring[ring.len() - 1];
    for &b in ring {
        if (a.x <= p.x) != (b.x <= p.x) {
            let [left, right] = if a.x <= p.x { [a, b] } else { [b, a] };
            is_inside ^= orient2d(left, right, p) == Orientation::Left;
        }
        a = b;
    }
    is_inside
}
