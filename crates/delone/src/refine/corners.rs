//! Small angles of the input: where two segments meet at less than 60 degrees.
//!
//! Angles are those between the segments as they were drawn: of the subsegments at a vertex, rounding may
//! have turned the short ones. Segments that run along the same edge of a vertex enclose nothing there:
//! those that overlap, or lie so close that rounding joins them, meet where they part.

use super::Reason;
use crate::{Angle, ConstrainedTriangulation, Point, VertexId, check};
use std::collections::{HashMap, HashSet};

/// The angle below which a corner is small, in degrees: what equilateral triangles have.
const SMALL: f64 = 60.0;

/// That a segment runs through a vertex, which is at this position of its chain.
#[derive(Clone, Copy)]
struct Pass {
    segment: u32,
    position: u32,
}

/// A segment that leaves a vertex.
#[derive(Clone, Copy)]
struct Way {
    segment: u32,
    /// Where it comes to next.
    next: VertexId,
    /// Its direction, the larger coordinate 1 or −1.
    heading: [f64; 2],
}

/// Looks for small angles, and remembers those that it found: many triangles have the same.
pub(super) struct Corners<'a> {
    mesh: &'a ConstrainedTriangulation,
    /// For each vertex the segments through it, ascending, of equal ones the first.
    passes: Vec<Pass>,
    starts: Vec<u32>,
    at_vertex: HashMap<VertexId, Option<Reason>>,
    of_pair: HashMap<[u32; 2], Option<Reason>>,
}

impl<'a> Corners<'a> {
    /// *Cost*: linear in the edges along segments.
    pub fn of(mesh: &'a ConstrainedTriangulation) -> Self {
        let mut seen = HashSet::new();
        let mut is_first = |&s: &usize| {
            let chain = mesh.chain(s);
            let [a, b] = [chain[0], chain[chain.len() - 1]];
            seen.insert([a.min(b), a.max(b)])
        };
        let segments: Vec<usize> = (0..mesh.segments().len()).filter(&mut is_first).collect();
        let mut starts = vec![0; mesh.triangulation().points().len() + 1];
        for &s in &segments {
            for v in mesh.chain(s) {
                starts[v.index() + 1] += 1;
            }
        }
        for v in 1..starts.len() {
            starts[v] += starts[v - 1];
        }
        let nothing = Pass {
            segment: 0,
            position: 0,
        };
        let mut passes = vec![nothing; starts.last().map_or(0, |&n: &u32| n as usize)];
        let mut free = starts.clone();
        for s in segments {
            for (position, v) in mesh.chain(s).iter().enumerate() {
                let slot = &mut free[v.index()];
                passes[*slot as usize] = Pass {
                    segment: s as u32,
                    position: position as u32,
                };
                *slot += 1;
            }
        }
        Self {
            mesh,
            passes,
            starts,
            at_vertex: HashMap::new(),
            of_pair: HashMap::new(),
        }
    }

    /// Finds the smallest of the small angles at a vertex.
    ///
    /// *Cost*: O(n log n) for n segments at the vertex, once for each vertex.
    pub fn at(&mut self, v: VertexId) -> Option<Reason> {
        if let Some(&reason) = self.at_vertex.get(&v) {
            return reason;
        }
        let mut ways: Vec<Way> = self.through(v).iter().flat_map(|&p| self.ways(p)).collect();
        ways.sort_by(|a, b| turn(a.heading).total_cmp(&turn(b.heading)));
        let following = ways.iter().skip(1).chain(ways.first());
        let pairs = ways.iter().zip(following);
        let reason = self.sharpest(v, pairs.map(|(&a, &b)| [a, b]));
        self.at_vertex.insert(v, reason);
        reason
    }

    /// Finds two segments that meet at a small angle and run through an end each of an edge.
    ///
    /// *Cost*: for each pair of segments through the ends once the vertices of the shorter chain.
    pub fn joined_by(&mut self, ends: [VertexId; 2]) -> Option<Reason> {
        let [first, second] = ends.map(|v| self.range(v));
        let pairs = first.flat_map(|i| second.clone().map(move |j| [i, j]));
        for [i, j] in pairs {
            let [s, t] = [i, j].map(|i| self.passes[i].segment);
            let pair = [s.min(t), s.max(t)];
            let reason = match self.of_pair.get(&pair) {
                Some(&reason) => reason,
                None => self.meeting(pair),
            };
            self.of_pair.insert(pair, reason);
            if reason.is_some() {
                return reason;
            }
        }
        None
    }

    /// Finds where two segments meet at a small angle.
    fn meeting(&self, pair: [u32; 2]) -> Option<Reason> {
        let mut chains = pair.map(|s| (s, self.mesh.chain(s as usize)));
        chains.sort_by_key(|(_, chain)| chain.len());
        let [(s, shorter), (t, _)] = chains;
        if s == t {
            return None;
        }
        shorter.iter().enumerate().find_map(|(position, &v)| {
            let through = self.through(v);
            let other = through.binary_search_by_key(&t, |p| p.segment).ok()?;
            let pass = Pass {
                segment: s,
                position: position as u32,
            };
            let [first, second] = [pass, through[other]].map(|p| self.ways(p));
            let second: Vec<Way> = second.collect();
            let pairs = first.flat_map(|a| second.iter().map(move |&b| [a, b]));
            self.sharpest(v, pairs)
        })
    }

    /// Of pairs of ways from a vertex, finds the one with the smallest angle, if that is small.
    fn sharpest(&self, vertex: VertexId, pairs: impl Iterator<Item = [Way; 2]>) -> Option<Reason> {
        let parting = pairs.filter(|[a, b]| a.segment != b.segment && a.next != b.next);
        let angles = parting.map(|ways| (ways, angle(ways.map(|way| way.heading))));
        let ([a, b], angle) = angles.min_by(|(_, x), (_, y)| x.total_cmp(y))?;
        let mut segments = [a, b].map(|way| way.segment as usize);
        segments.sort_unstable();
        (angle < SMALL).then_some(Reason::SmallInputAngle {
            vertex,
            segments,
            angle: Angle::degrees(angle),
        })
    }

    /// Visits the one or two ways on which a segment leaves a vertex of its chain.
    fn ways(&self, Pass { segment, position }: Pass) -> impl Iterator<Item = Way> + use<> {
        let chain = self.mesh.chain(segment as usize);
        let ends = [chain[0], chain[chain.len() - 1]];
        let [from, to] = ends.map(|v| self.mesh.triangulation().point(v));
        let position = position as usize;
        let ahead = chain.get(position + 1).map(|&next| (next, [from, to]));
        let behind = position.checked_sub(1).map(|i| (chain[i], [to, from]));
        let both = ahead.into_iter().chain(behind);
        both.map(move |(next, [from, to])| Way {
            segment,
            next,
            heading: heading(from, to),
        })
    }

    fn through(&self, v: VertexId) -> &[Pass] {
        &self.passes[self.range(v)]
    }

    fn range(&self, v: VertexId) -> std::ops::Range<usize> {
        let [first, end] = [0, 1].map(|i| self.starts[v.index() + i] as usize);
        first..end
    }
}

/// The direction from one point to another, the larger coordinate 1 or −1.
fn heading(from: Point, to: Point) -> [f64; 2] {
    let mut d = [to.x - from.x, to.y - from.y];
    if !d.iter().all(|c| c.is_finite()) {
        d = [to.x / 2.0 - from.x / 2.0, to.y / 2.0 - from.y / 2.0];
    }
    let larger = d[0].abs().max(d[1].abs());
    d.map(|c| c / larger)
}

/// Increases with the angle of a heading: counter-clockwise, from −1 to 7.
fn turn([x, y]: [f64; 2]) -> f64 {
    match (x, y) {
        (1.0, y) => y,
        (x, 1.0) => 2.0 - x,
        (-1.0, y) => 4.0 - y,
        (x, _) => 6.0 + x,
    }
}

/// The angle between two headings, in degrees.
fn angle(headings: [[f64; 2]; 2]) -> f64 {
    let [u, v] = headings.map(|[x, y]| Point::new(x, y));
    check::Shape::of([Point::new(0.0, 0.0), u, v]).angles[0]
}
