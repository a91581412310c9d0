//! Outlines with what makes meshing hard: acute corners, thin teeth, thin channels, sharp trailing
//! edges.

use super::Drawing;
use super::rings::{Rings, on_circle, polygon, square};
use crate::Random;
use std::f64::consts::{PI, TAU};

const CENTER: [f64; 2] = [0.5, 0.5];

/// Returns the vertices of a star of `count` ≥ 3 segments whose spikes are deep or shallow: of 100
/// spikes, the sharpest have 2.5 degrees.
pub fn star(count: usize, random: &mut Random) -> Vec<[f64; 2]> {
    let phase = TAU * random.unit();
    polygon(CENTER, count, phase, |k| {
        // The last of an odd number stands between two spikes.
        let is_tip = k % 2 == 0 && (k + 1 < count || count == 3);
        if is_tip {
            0.49
        } else {
            random.between(0.2, 0.4)
        }
    })
}

/// Returns the vertices of a comb of `count` ≥ 3 segments: a bar with thin teeth of all lengths.
pub fn comb(count: usize, random: &mut Random) -> Vec<[f64; 2]> {
    let [left_end, right_end, top] = [0.02, 0.98, 0.2];
    let teeth = count.saturating_sub(4) / 4;
    if teeth == 0 {
        return square(count);
    }
    let below = count - 4 * teeth - 3;
    let pitch = (right_end - left_end) / teeth as f64;
    let bottom = (0..below).map(|i| {
        [
            left_end + (right_end - left_end) * i as f64 / below as f64,
            0.02,
        ]
    });
    let mut vertices: Vec<_> = bottom
        .chain([[right_end, 0.02], [right_end, top]])
        .collect();
    for k in (0..teeth).rev() {
        let middle = left_end + pitch * (k as f64 + 0.5);
        let half = pitch * random.between(0.1, 0.4);
        let tip = top + random.between(0.05, 0.75);
        let [left, right] = [middle - half, middle + half];
        vertices.extend([[right, top], [right, tip], [left, tip], [left, top]]);
    }
    vertices.push([left_end, top]);
    vertices
}

/// Draws a gear: trapezoidal teeth, and a round hole for the shaft that has a quarter of the segments.
pub fn gear(count: usize, random: &mut Random) -> Drawing {
    let mut rings = Rings::default();
    let teeth = count * 3 / 16;
    if teeth < 3 {
        rings.add(square(count));
        return rings.finish();
    }
    let pitch = TAU / teeth as f64;
    let phase = TAU * random.unit();
    let height = (1.8 / teeth as f64).min(0.18);
    let tooth = |k: usize| {
        let corner = |at: f64, radius| on_circle(CENTER, radius, phase + pitch * (k as f64 + at));
        let [tip, root] = [0.48, 0.48 - height];
        [(-0.3, root), (-0.12, tip), (0.12, tip), (0.3, root)].map(|(at, r)| corner(at, r))
    };
    rings.add((0..teeth).flat_map(tooth));
    let shaft = polygon(CENTER, count - 4 * teeth, phase, |_| 0.12);
    rings.add_hole(shaft, CENTER);
    rings.finish()
}

/// Draws rings in rings, every other one left out: channels of all widths, as long as they go round.
///
/// Each ring is smaller than the largest circle inside the one around it, by a factor that varies.
pub fn nested(count: usize, random: &mut Random) -> Drawing {
    // All factors together.
    const INNERMOST: f64 = 0.2;
    let number = (count / 8).isqrt().max(1);
    let shares: Vec<f64> = (0..number)
        .map(|_| libm::pow(20.0, random.unit()))
        .collect();
    let all: f64 = shares.iter().sum();
    let mut rings = Rings::default();
    let mut radius = 0.49;
    for (i, share) in shares.iter().enumerate() {
        let sides = (count + i) / number;
        let ring = polygon(CENTER, sides, TAU * random.unit(), |_| radius);
        let inside = radius * libm::cos(PI / sides as f64);
        let next = inside * libm::pow(INNERMOST, share / all);
        if i % 2 == 0 {
            rings.add(ring);
        } else {
            let is_last = i + 1 == number;
            let middle = if is_last { 0.0 } else { 0.5 * (inside + next) };
            rings.add_hole(ring, [CENTER[0] + middle, CENTER[1]]);
        }
        radius = next;
    }
    rings.finish()
}

/// Draws a channel around an airfoil of the NACA's family of four digits, whose thickness, camber and
/// angle of attack vary, with a sharp trailing edge (Jacobs, Ward, Pinkerton, report 460, 1933).
pub fn airfoil(count: usize, random: &mut Random) -> Drawing {
    const CHORD: f64 = 0.4;
    let mut rings = Rings::default();
    rings.add(square(if count < 12 { count } else { 4 }));
    if count < 12 {
        return rings.finish();
    }
    let thickness = random.between(0.08, 0.16);
    let camber = random.between(0.0, 0.04);
    let highest = random.between(0.3, 0.5);
    let (sin, cos) = libm::sincos(-random.between(0.0, 0.15));
    let place = |[x, y]: [f64; 2]| {
        let [x, y] = [CHORD * (x - 0.5), CHORD * y];
        [0.5 + cos * x - sin * y, 0.5 + sin * x + cos * y]
    };
    let surface = |x: f64, side: f64| {
        let half = half_thickness(x, thickness);
        let (line, slope) = camber_line(x, camber, highest);
        let length = (1.0 + slope * slope).sqrt();
        place([
            x - side * half * slope / length,
            line + side * half / length,
        ])
    };
    let sides = count - 4;
    let upper = sides / 2;
    let lower = sides - upper;
    // Closer together at both ends.
    let along = |k: usize, of: usize| 0.5 - 0.5 * libm::cos(PI * k as f64 / of as f64);
    let above = (0..upper).map(|k| surface(1.0 - along(k, upper), 1.0));
    let below = (0..lower).map(|k| surface(along(k, lower), -1.0));
    let foil = above.chain(below).collect();
    let (line, _) = camber_line(0.5, camber, highest);
    rings.add_hole(foil, place([0.5, line]));
    rings.finish()
}

/// The last coefficient closes the trailing edge.
fn half_thickness(x: f64, thickness: f64) -> f64 {
    let polynomial = x * (-0.126 + x * (-0.3516 + x * (0.2843 - 0.1036 * x)));
    5.0 * thickness * (0.2969 * x.sqrt() + polynomial)
}

/// Returns height and slope of the line in the middle.
fn camber_line(x: f64, camber: f64, highest: f64) -> (f64, f64) {
    let base = if x < highest { highest } else { 1.0 - highest };
    let factor = camber / (base * base);
    let height = if x < highest {
        factor * x * (2.0 * highest - x)
    } else {
        factor * (1.0 - 2.0 * highest + x * (2.0 * highest - x))
    };
    (height, 2.0 * factor * (highest - x))
}
