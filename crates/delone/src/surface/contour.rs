//! Contour lines of the surface that is flat over every triangle.
//!
//! A vertex whose value equals the level counts as *above*. So no vertex is on the level, every
//! triangle is crossed by one line or none, and lines neither branch nor end but at the border: whatever
//! plateaus and ridges the values make, topology is right without any tolerance. The line is directed
//! with the higher side to its left.
//!
//! ```text
//!         above               a triangle is left through its half-edge from below to above,
//!          / \                and entered through the one from above to below
//!         /   \ ←──
//!        / ←── \
//!    above ─── below
//! ```
//!
//! Only then places are computed: from the end below to the end above, rounded; the vertex itself if
//! its value is the level. Places on one edge are in the order of their levels.
//!
//! *Cost*: O(n log L) for L levels, and a few steps for each crossing.

use super::{Ground, Samples};
use crate::pace::Pace;
use crate::{Error, HalfEdgeId, Phase, Point, TriangleId, VertexId, Watch};

/// A line along which the surface has one value.
#[derive(Clone, Debug, PartialEq)]
pub struct Contour {
    /// Which level, as an index of those given.
    pub level: usize,
    /// Its value.
    pub value: f64,
    /// The points, the higher side to the left; no two that follow each other are equal, nor are first
    /// and last of a ring.
    pub points: Vec<Point>,
    /// Whether the last point is joined to the first one. Others begin and end at the border.
    pub is_closed: bool,
}

/// Follows all contour lines of the levels given.
///
/// The lines come level by level, open ones first, and are the same for the same triangulation. A line
/// whose points are all one, around a summit that is exactly a level, is left out; one around a ridge
/// that is exactly a level runs there and back.
///
/// # Errors
/// [`Error::BadLevel`] for a level that is not finite; [`Error::Cancelled`] if the watch says so.
///
/// ```
/// use delone::surface::{Samples, contours};
/// let t = delone::triangulate([(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0), (2.0, 2.0)])?;
/// let samples = Samples::new(&t, [0.0, 0.0, 0.0, 0.0, 4.0])?;
/// let lines = contours(&samples, &[1.0, 3.0], &())?;
/// assert_eq!(lines.len(), 2);
/// assert!(lines[1].is_closed && lines[1].value == 3.0);
/// assert!(lines[1].points.contains(&(1.5, 1.5).into()));
/// # Ok::<(), delone::Error>(())
/// ```
pub fn contours(
    samples: &Samples<'_>,
    levels: &[f64],
    watch: &dyn Watch,
) -> Result<Vec<Contour>, Error> {
    if let Some(&given) = levels.iter().find(|level| !level.is_finite()) {
        return Err(Error::BadLevel {
            what: "level",
            given,
            must: "it must be finite",
        });
    }
    let crossed = Crossed::new(samples, levels, watch)?;
    let total = crossed.triangles.len() as u64;
    let mut tracer = Tracer {
        samples,
        ground: samples.ground(),
        is_done: vec![false; samples.ground().triangulation().num_triangles()],
        pace: Pace::new(watch, Phase::Contour, total),
        lines: Vec::new(),
    };
    for (level, &value) in levels.iter().enumerate() {
        tracer.trace(level, value, crossed.by(level))?;
    }
    tracer.pace.finish();
    Ok(tracer.lines)
}

/// The triangles that each level crosses.
struct Crossed {
    /// Where the triangles of each level start, and the end of the last.
    starts: Vec<usize>,
    triangles: Vec<TriangleId>,
}

impl Crossed {
    fn new(samples: &Samples<'_>, levels: &[f64], watch: &dyn Watch) -> Result<Self, Error> {
        let mut sorted: Vec<usize> = (0..levels.len()).collect();
        sorted.sort_by(|&a, &b| levels[a].total_cmp(&levels[b]));
        let rows = samples.ground().triangulation().triangles();
        let mut pace = Pace::new(watch, Phase::Contour, 2 * rows.len() as u64);
        let mut each = |visit: &mut dyn FnMut(usize, usize)| {
            rows.iter().enumerate().try_for_each(|(t, corners)| {
                let values = corners.map(|v| samples.value(v));
                let low = values.into_iter().fold(f64::INFINITY, f64::min);
                let high = values.into_iter().fold(f64::NEG_INFINITY, f64::max);
                // Crossed by those above the lowest corner and not above the highest.
                let [from, to] = [low, high]
                    .map(|value| sorted.partition_point(|&level| levels[level] <= value));
                sorted[from..to].iter().for_each(|&level| visit(level, t));
                pace.step()
            })
        };
        let mut starts = vec![0; levels.len() + 1];
        each(&mut |level, _| starts[level + 1] += 1)?;
        for i in 0..levels.len() {
            starts[i + 1] += starts[i];
        }
        let mut next = starts.clone();
        let mut triangles = vec![TriangleId::new(0); starts[levels.len()]];
        each(&mut |level, t| {
            triangles[next[level]] = TriangleId::new(t);
            next[level] += 1;
        })?;
        Ok(Self { starts, triangles })
    }

    /// Returns the triangles that a level crosses, ascending.
    fn by(&self, level: usize) -> &[TriangleId] {
        &self.triangles[self.starts[level]..self.starts[level + 1]]
    }
}

struct Tracer<'a> {
    samples: &'a Samples<'a>,
    ground: Ground<'a>,
    /// The triangles that this level's lines have gone through.
    is_done: Vec<bool>,
    pace: Pace<'a>,
    lines: Vec<Contour>,
}

impl Tracer<'_> {
    /// Follows all lines of one level: first those that enter at the border, then rings.
    fn trace(&mut self, level: usize, value: f64, crossed: &[TriangleId]) -> Result<(), Error> {
        let mesh = self.ground.mesh();
        for &t in crossed {
            let entry = self.entry(t, value);
            if !self.ground.has(mesh.twin(entry).triangle()) {
                self.follow(level, value, entry)?;
            }
        }
        for &t in crossed {
            if !self.is_done[t.index()] {
                self.follow(level, value, self.entry(t, value))?;
            }
        }
        crossed.iter().for_each(|t| self.is_done[t.index()] = false);
        Ok(())
    }

    /// Follows one line from the half-edge through which it enters a triangle.
    fn follow(&mut self, level: usize, value: f64, start: HalfEdgeId) -> Result<(), Error> {
        let mut points = vec![self.crossing(start, value)];
        let mut entry = start;
        let is_closed = loop {
            self.pace.step()?;
            self.is_done[entry.triangle().index()] = true;
            let exit = self.exit(entry, value);
            entry = self.ground.mesh().twin(exit);
            if entry == start {
                break true;
            }
            points.push(self.crossing(exit, value));
            if !self.ground.has(entry.triangle()) {
                break false;
            }
        };
        points.dedup();
        while is_closed && points.len() > 1 && points.first() == points.last() {
            points.pop();
        }
        if points.len() > 1 {
            self.lines.push(Contour {
                level,
                value,
                points,
                is_closed,
            });
        }
        Ok(())
    }

    /// Returns the half-edge of a crossed triangle that runs from above to below.
    fn entry(&self, t: TriangleId, value: f64) -> HalfEdgeId {
        let [a, b, c] = t.half_edges();
        if self.descends(a, value) {
            a
        } else if self.descends(b, value) {
            b
        } else {
            c
        }
    }

    /// Returns the half-edge from below to above, given that from above to below.
    fn exit(&self, entry: HalfEdgeId, value: f64) -> HalfEdgeId {
        // The entry's destination is below: where the line leaves depends on the apex alone.
        match self.is_above(self.ground.mesh().apex(entry), value) {
            true => entry.next(),
            false => entry.prev(),
        }
    }

    fn descends(&self, h: HalfEdgeId, value: f64) -> bool {
        let mesh = self.ground.mesh();
        self.is_above(mesh.origin(h), value) && !self.is_above(mesh.dest(h), value)
    }

    fn is_above(&self, v: VertexId, value: f64) -> bool {
        self.samples.value(v) >= value
    }

    /// Returns where the edge of `h` has the value, the same from both sides.
    fn crossing(&self, h: HalfEdgeId, value: f64) -> Point {
        let mesh = self.ground.mesh();
        let [mut below, mut above] = [mesh.origin(h), mesh.dest(h)];
        if self.is_above(below, value) {
            (below, above) = (above, below);
        }
        let [low, high] = [below, above].map(|v| self.samples.value(v));
        let [from, to] = [below, above].map(|v| self.ground.triangulation().point(v));
        if high == value {
            return to;
        }
        let share = share(low, high, value);
        Point::new(between(from.x, to.x, share), between(from.y, to.y, share))
    }
}

/// Returns how far `value` is from `low` to `high`, without overflow; never less for a larger value.
fn share(low: f64, high: f64, value: f64) -> f64 {
    match (high - low).is_finite() {
        true => (value - low) / (high - low),
        false => (value / 2.0 - low / 2.0) / (high / 2.0 - low / 2.0),
    }
}

/// Returns the number that is `share` of the way from `a` to `b`, not beyond either.
fn between(a: f64, b: f64, share: f64) -> f64 {
    let c = match (b - a).is_finite() {
        true => a + share * (b - a),
        false => 2.0 * (a / 2.0 + share * (b / 2.0 - a / 2.0)),
    };
    // Adding zero turns −0.0 into 0.0.
    c.clamp(a.min(b), a.max(b)) + 0.0
}
