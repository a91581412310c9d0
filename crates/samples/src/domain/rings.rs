//! Closed rings, put together: borders run with the domain on their left.

use super::{Drawing, exact, index};

/// A drawing to which rings are added.
#[derive(Default)]
pub struct Rings {
    drawing: Drawing,
}

impl Rings {
    /// Adds a ring of vertices in order, each joined to the next and the last to the first: outlines
    /// counter-clockwise.
    pub fn add(&mut self, vertices: impl IntoIterator<Item = [f64; 2]>) {
        let drawing = &mut self.drawing;
        let first = index(drawing.points.len());
        let snapped = vertices.into_iter().map(|p| p.map(exact::snap));
        drawing.points.extend(snapped);
        let last = index(drawing.points.len() - 1);
        let along = (first..last).map(|i| [i, i + 1]);
        drawing.segments.extend(along.chain([[last, first]]));
    }

    /// Adds the border of a hole, given counter-clockwise, too, and a point inside it.
    pub fn add_hole(&mut self, mut vertices: Vec<[f64; 2]>, inside: [f64; 2]) {
        vertices.reverse();
        self.add(vertices);
        self.drawing.holes.push(inside);
    }

    /// Returns the drawing.
    pub fn finish(self) -> Drawing {
        self.drawing
    }
}

/// Returns the vertices of a regular polygon, or of something like it: vertex k of `count` lies at
/// `radius(k)`.
pub fn polygon(
    center: [f64; 2],
    count: usize,
    phase: f64,
    mut radius: impl FnMut(usize) -> f64,
) -> Vec<[f64; 2]> {
    let vertex = |k| {
        let turn = std::f64::consts::TAU * k as f64 / count as f64;
        on_circle(center, radius(k), phase + turn)
    };
    (0..count).map(vertex).collect()
}

/// Returns the point of a circle at `angle`.
pub fn on_circle(center: [f64; 2], radius: f64, angle: f64) -> [f64; 2] {
    let (sin, cos) = libm::sincos(angle);
    [center[0] + radius * cos, center[1] + radius * sin]
}

/// Returns the unit square as a ring of `count` ≥ 3 vertices, equally spaced on each side. Of three,
/// one is a corner less.
pub fn square(count: usize) -> Vec<[f64; 2]> {
    const CORNERS: [[f64; 2]; 4] = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let side = |k: usize| {
        let [from, to] = [CORNERS[k], CORNERS[(k + 1) % 4]];
        let pieces = (count + k) / 4;
        (0..pieces).map(move |i| {
            let along = i as f64 / pieces as f64;
            [0, 1].map(|c| from[c] + (to[c] - from[c]) * along)
        })
    };
    (0..4).flat_map(side).collect()
}
