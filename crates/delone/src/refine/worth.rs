//! What some triangles are worth, before and after a vertex has moved.

use super::bounds::{Bounds, Shape};
use super::patch::Face;
use crate::VertexId;

/// The squared sine of 30 degrees. Whatever the bound, an angle below stays the smallest one around only
/// if it grows.
const MODEST: f64 = 0.25;

/// What some triangles are like.
#[derive(Clone, Debug)]
pub(super) struct Worth {
    /// The sum over triangles of area divided by squared lengths of edges.
    quality: f64,
    /// The squared sine of the smallest angle.
    sine: f64,
    /// How many break a bound.
    pub broken: usize,
    /// By how much the worst of them is too large.
    oversize: f64,
    /// Vertices too close to a segment of their triangle, each before the ends of that.
    encroached: Vec<[VertexId; 3]>,
}

impl Worth {
    /// Weighs some faces.
    pub fn of(bounds: &Bounds, faces: impl Iterator<Item = Face>) -> Self {
        let mut worth = Self {
            quality: 0.0,
            sine: 1.0,
            broken: 0,
            oversize: 0.0,
            encroached: Vec::new(),
        };
        for face in faces {
            worth.add(bounds, &face);
        }
        worth
    }

    fn add(&mut self, bounds: &Bounds, face: &Face) {
        let shape = Shape::of(face.points);
        let oversize = match bounds.has_sizes() {
            true => bounds.oversize(face.points, &shape, face.region),
            false => 0.0,
        };
        let is_broken = oversize > 1.0 || bounds.is_skinny(shape.squares, shape.cross);
        let [a, b, c] = shape.squares;
        let [low, high] = [a.min(b), a.max(b)];
        self.quality += shape.cross / (a + b + c);
        self.sine = self
            .sine
            .min(shape.cross * shape.cross / (high * low.max(c)));
        self.broken += usize::from(is_broken);
        self.oversize = self.oversize.max(oversize);
        self.encroached.extend(encroached(bounds, face));
    }

    /// Tells whether whatever is encroached upon was so before, by the same vertex. One for another will not
    /// do: some cannot be avoided, others could be split no more.
    pub fn encroaches_nothing_new(&self, before: &Self) -> bool {
        self.encroached
            .iter()
            .all(|e| before.encroached.contains(e))
    }

    /// Tells whether as many triangles are better on average, and none for the price of a bound.
    pub fn is_better_than(&self, before: &Self) -> bool {
        // With a margin, so that rounding makes no vertex wander for ever.
        self.quality > before.quality * (1.0 + 1e-9)
            && self.broken <= before.broken
            && self.encroaches_nothing_new(before)
            && self.sine >= before.sine.min(MODEST)
            && (self.broken == 0 || self.sine >= before.sine && self.oversize <= before.oversize)
    }
}

/// Lists the vertices of a triangle that are too close to the segment opposite, each before its ends.
fn encroached<'a>(bounds: &'a Bounds, face: &'a Face) -> impl Iterator<Item = [VertexId; 3]> + 'a {
    let segments = (0..3).filter(|&k| face.traits.is_constrained(k));
    let slots = segments.map(|k| [k, (k + 1) % 3, (k + 2) % 3]);
    let close = slots.filter(|&[k, i, j]| {
        let ends = [face.points[i], face.points[j]];
        bounds.encroaches(ends, face.points[k])
    });
    close.map(|slots| slots.map(|k| face.corners[k]))
}
