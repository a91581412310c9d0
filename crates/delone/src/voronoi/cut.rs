//! Cutting one cell: chains of the boundary and pieces of the cell's own border, put together.
//!
//! Where the level rises and where it falls again are matched as parentheses are, relative to the level
//! that the cell has all around. Where a sharp corner of the boundary falls on a vertex of the diagram, it may
//! be −1 or 2 in that place; there they are matched backwards or nested, around nothing.

use super::diagram::AT_INFINITY;
use super::measure::doubled_area;
use super::overlay::Overlay;
use super::parts::{Shapes, without_repeated};
use crate::predicates::{Orientation, orient2d};
use crate::{Point, VertexId};

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
pub(super) struct Cutter<'a> {
    overlay: &'a Overlay<'a>,
    events: Vec<Event>,
    arcs: Vec<Option<Arc>>,
    /// For each crossing its event around the present cell.
    places: Vec<u32>,
    outlines: Vec<Outline>,
}

impl<'a> Cutter<'a> {
    pub fn new(overlay: &'a Overlay<'a>) -> Self {
        Self {
            overlay,
            events: Vec::new(),
            arcs: Vec::new(),
            places: vec![0; overlay.trace.crossings.len()],
            outlines: Vec::new(),
        }
    }

    /// Adds a cell that no boundary enters or lies in: all of it, or nothing.
    pub fn take(&self, site: VertexId, shapes: &mut Shapes) {
        let diagram = self.overlay.diagram;
        let ends = diagram.sides(site).map(|side| diagram.ends(side)[1]);
        let is_inside = |&v: &u32| v != AT_INFINITY && self.overlay.levels.at(v) >= 1;
        // Its level is the same all around.
        if ends.clone().next().as_ref().is_some_and(is_inside) {
            shapes.extend(ends.map(|v| diagram.vertices[v as usize]));
            shapes.end_simple_part();
        }
    }

    /// Adds the parts of a cell.
    pub fn cut(
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
            let [from, to] = overlay.diagram.ends(side);
            first = first.or(Some(overlay.levels.at(from)));
            if side.is_reversed {
                self.events.extend(crossings.iter().rev().map(event));
            } else {
                self.events.extend(crossings.iter().map(event));
            }
            self.events.push(match to {
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
        let mut points = Vec::with_capacity(self.events.len());
        points.extend(self.events.iter().filter_map(|&e| self.corner(e)));
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
        let len = without_repeated(&mut points);
        points.truncate(len);
        if points.len() >= 3 && doubled_area(&points) > 0.0 {
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
