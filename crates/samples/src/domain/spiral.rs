//! A band wound up along the spiral of Archimedes, r = θ in units of pitch / 2π.
//!
//! The band is half a pitch wide, so that band and water between are equally wide: the *gap*. Both
//! borders have vertices at θₖ = √(θ₀² + 4π k), which lie one pitch apart along the border whatever
//! the radius is. No two edges meet: vertices lie off their spiral by an eighth of the gap at most,
//! and edges inside of it by another eighth at most, as the radius is never less than two pitches
//! (the sagitta of a chord s at radius r is s² / 8 r).

use crate::Random;
use std::f64::consts::{PI, TAU};

/// Makes the vertices of a spiral band of `count` ≥ 3 segments, counter-clockwise: out along the
/// outer border, back along the inner one. The band makes about √(count / 2π) turns.
pub fn vertices(count: usize, random: &mut Random) -> Vec<[f64; 2]> {
    let inner = count / 2;
    let outer = count - inner;
    let scale = 0.49 / (angle(outer) + 2.0 * PI);
    let phase = TAU * random.unit();
    let mut vertex = |k: usize, offset: f64| {
        let jitter = random.between(-1.0, 1.0) * PI / 8.0;
        let radius = scale * (angle(k) + offset + jitter);
        let (sin, cos) = libm::sincos(angle(k) + phase);
        [0.5 + radius * cos, 0.5 + radius * sin]
    };
    let mut vertices = Vec::with_capacity(count);
    vertices.extend((0..outer).map(|k| vertex(k, PI)));
    vertices.extend((0..inner).rev().map(|k| vertex(k, 0.0)));
    vertices
}

/// Returns θₖ. The first is two turns, at a radius of two pitches.
fn angle(k: usize) -> f64 {
    const FIRST: f64 = 2.0 * TAU;
    (FIRST * FIRST + 4.0 * PI * k as f64).sqrt()
}
