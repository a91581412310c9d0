//! What some triangles are worth, before and after a vertex has moved.

use super::bounds::{Bounds, Shape};
use super::patch::Face;

/// The squared sine of 30 degrees. Whatever the bound, an angle below stays the smallest one around only
/// if it grows.
const MODEST: f64 = 0.25;

/// What some triangles are like.
#[derive(Clone, Copy, Debug)]
pub(super) struct Worth {
    /// The sum over triangles of area divided by squared lengths of edges.
    quality: f64,
    /// The squared sine of the smallest angle.
    sine: f64,
    /// How many break a bound.
    pub broken: usize,
    /// By how much the worst of them is too large.
    oversize: f64,
    /// How many are too close to one of their own segments.
    pub encroached: usize,
}

impl Worth {
    /// Weighs some faces.
    pub fn of(bounds: &Bounds, faces: impl Iterator<Item = Face>) -> Self {
        let mut worth = Self {
            quality: 0.0,
            sine: 1.0,
            broken: 0,
            oversize: 0.0,
            encroached: 0,
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
        self.encroached += usize::from(is_encroached(bounds, face));
    }

    /// Tells whether as many triangles are better on average, and none for the price of a bound.
    pub fn is_better_than(&self, before: &Self) -> bool {
        // With a margin, so that rounding makes no vertex wander for ever.
        self.quality > before.quality * (1.0 + 1e-9)
            && self.broken <= before.broken
            && self.encroached <= before.encroached
            && self.sine >= before.sine.min(MODEST)
            && (self.broken == 0 || self.sine >= before.sine && self.oversize <= before.oversize)
    }
}

/// Tells whether the triangle is too close to one of its own segments.
fn is_encroached(bounds: &Bounds, face: &Face) -> bool {
    let [a, b, c] = face.points;
    let edges = [([b, c], a), ([c, a], b), ([a, b], c)];
    let mut segments = (0..3).filter(|&k| face.traits.is_constrained(k));
    segments.any(|k| bounds.encroaches(edges[k].0, edges[k].1))
}
