//! Small angles of the input: corners where two segments meet at less than 60 degrees, and edges that go
//! from one of such segments to the other.
//!
//! Angles are those between the segments as they were drawn: of the subsegments at a corner, rounding may
//! have turned the short ones. Segments meet where they share an end, where one ends upon the other, and
//! where they cross; those on one line do not.

use super::super::places::Place;
use super::{Excuse, Found, SLACK, Shape};
use crate::pace::Pace;
use crate::predicates::{Orientation, orient2d};
use crate::{Angle, Error, Point, VertexId};
use std::collections::{BTreeSet, HashMap};

/// The angle below which a corner is small, in degrees: what equilateral triangles have.
const SMALL: f64 = 60.0;

/// Looks for small angles.
pub(super) struct Corners<'c> {
    found: &'c Found<'c>,
    /// For each place that was asked about the small angle there; only asked, never listed.
    known: HashMap<Place, Option<Excuse>>,
    /// Made when an edge is asked about first.
    passing: Option<Passing>,
}

impl<'c> Corners<'c> {
    pub fn new(found: &'c Found<'c>) -> Self {
        Self {
            found,
            known: HashMap::new(),
            passing: None,
        }
    }

    /// Finds the small angle between segments that meet in a vertex.
    pub fn at(&mut self, v: VertexId, pace: &mut Pace) -> Result<Option<Excuse>, Error> {
        let place = self.found.graph.places.of(v);
        if let Some(&excuse) = self.known.get(&place) {
            return Ok(excuse);
        }
        let excuse = self.look(place, pace)?;
        self.known.insert(place, excuse);
        Ok(excuse)
    }

    /// Looks at subsegments that follow one another around a place: no others are at smaller angles.
    fn look(&self, place: Place, pace: &mut Pace) -> Result<Option<Excuse>, Error> {
        let Found {
            segments, chains, ..
        } = *self.found;
        let star = self.found.graph.star(place);
        let following = star.iter().skip(1).chain(star.first());
        for (&d, &e) in star.iter().zip(following) {
            pace.step()?;
            let owners = [d, e].map(|dart| chains.owners[dart.edge()]);
            let [Some(a), Some(b)] = owners.map(|o| o.map(|s| s as usize)) else {
                continue;
            };
            if a == b {
                continue;
            }
            let headings = [(a, d), (b, e)].map(|(segment, dart)| {
                let to = self.found.graph.places.at(self.found.graph.dest(dart));
                let step = heading(self.found.graph.places.at(place), to);
                let [from, to] = segments[segment].map(|v| self.point(v));
                let [x, y] = heading(from, to);
                if x * step[0] + y * step[1] < 0.0 {
                    [-x, -y]
                } else {
                    [x, y]
                }
            });
            let corner = self.corner(place, [a, b], angle(headings));
            if corner.is_some() {
                return Ok(corner);
            }
        }
        Ok(None)
    }

    /// Finds two segments that meet at a small angle and have an end each of an edge.
    pub fn joined_by(
        &mut self,
        ends: [VertexId; 2],
        pace: &mut Pace,
    ) -> Result<Option<Excuse>, Error> {
        let passing = match self.passing.take() {
            Some(passing) => passing,
            None => Passing::find(self.found, pace)?,
        };
        let passing = self.passing.insert(passing);
        let [first, second] = ends.map(|v| passing.at(self.found.graph.places.of(v)).to_vec());
        for &a in &first {
            for &b in &second {
                pace.step()?;
                let corner = self.meeting([a, b].map(|s| s as usize));
                if corner.is_some() {
                    return Ok(corner);
                }
            }
        }
        Ok(None)
    }

    /// Finds the small angle at which two segments meet, if they do.
    fn meeting(&self, segments: [usize; 2]) -> Option<Excuse> {
        let places = &self.found.graph.places;
        let [a, b] = segments.map(|s| self.found.segments[s].map(|v| places.of(v)));
        let shared = a.into_iter().find(|end| b.contains(end));
        if let Some(corner) = shared {
            let far = [a, b].map(|[from, to]| places.at(if from == corner { to } else { from }));
            let at = places.at(corner);
            let is_straight = orient2d(at, far[0], far[1]) == Orientation::Collinear;
            let angle = angle(far.map(|far| heading(at, far)));
            return self
                .corner(corner, segments, angle)
                .filter(|_| !is_straight);
        }
        let [p, q] = [a, b].map(|ends| ends.map(|end| places.at(end)));
        let parts = |[from, to]: [Point; 2], others: [Point; 2]| {
            let [first, second] = others.map(|other| orient2d(from, to, other));
            first != second
        };
        if !parts(p, q) || !parts(q, p) {
            return None;
        }
        let angle = angle([p, q].map(|[from, to]| heading(from, to)));
        let corner = self.common_place(segments)?;
        self.corner(corner, segments, angle.min(180.0 - angle))
    }

    /// Finds where the chains of two segments meet.
    fn common_place(&self, [a, b]: [usize; 2]) -> Option<Place> {
        let passed: BTreeSet<Place> = self.found.places_along(b).collect();
        self.found.places_along(a).find(|p| passed.contains(p))
    }

    /// Names a corner, if its angle is small.
    fn corner(&self, place: Place, mut segments: [usize; 2], degrees: f64) -> Option<Excuse> {
        segments.sort_unstable();
        (degrees < SMALL * (1.0 + SLACK)).then(|| Excuse::SmallInputAngle {
            vertex: self.found.graph.places.vertex(place),
            segments,
            angle: Angle::degrees(degrees),
        })
    }

    fn point(&self, v: VertexId) -> Point {
        self.found.points[v.index()]
    }
}

/// For each place the segments that pass it, equal ones only once.
struct Passing {
    starts: Vec<u32>,
    segments: Vec<u32>,
}

impl Passing {
    /// *Cost*: O(m log m) for m edges along segments.
    fn find(found: &Found, pace: &mut Pace) -> Result<Self, Error> {
        let mut seen = BTreeSet::new();
        let mut passing: Vec<(Place, u32)> = Vec::new();
        for (segment, ends) in found.segments.iter().enumerate() {
            let mut ends = ends.map(|v| found.graph.places.of(v));
            ends.sort_unstable();
            if !seen.insert(ends) {
                continue;
            }
            for place in found.places_along(segment) {
                pace.step()?;
                passing.push((place, segment as u32));
            }
        }
        super::super::sort::sort(&mut passing, pace, Ord::cmp)?;
        let mut starts = vec![0; found.graph.places.len() + 1];
        for &(place, _) in &passing {
            pace.step()?;
            starts[place as usize + 1] += 1;
        }
        for place in 1..starts.len() {
            starts[place] += starts[place - 1];
        }
        Ok(Self {
            starts,
            segments: passing.into_iter().map(|(_, segment)| segment).collect(),
        })
    }

    fn at(&self, place: Place) -> &[u32] {
        let [first, end] = [0, 1].map(|i| self.starts[place as usize + i] as usize);
        &self.segments[first..end]
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

/// The angle between two directions, in degrees.
fn angle(headings: [[f64; 2]; 2]) -> f64 {
    let [u, v] = headings.map(|[x, y]| Point::new(x, y));
    Shape::of([Point::new(0.0, 0.0), u, v]).angles[0]
}
