//! Arcs of ellipses, circles among them.

use super::{Affine, MAX_PIECES, Place3, too_fine};
use crate::Problem;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// The points c + u cos t + v sin t for t from `start` on, as far as `sweep`, which may be negative.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Arc {
    pub center: Place3,
    pub u: Place3,
    pub v: Place3,
    pub start: f64,
    pub sweep: f64,
}

impl Arc {
    /// Makes a whole ellipse of two half axes, counter-clockwise if u and v are.
    pub fn whole(center: Place3, u: Place3, v: Place3) -> Self {
        Self {
            center,
            u,
            v,
            start: 0.0,
            sweep: TAU,
        }
    }

    /// Makes the arc of a circle from one point to another, that bulges to the right of the way by `bulge`
    /// times half of the chord, as DXF has it: the tangent of a quarter of the angle, negative for
    /// clockwise arcs. None if the points are the same, or there is no bulge.
    pub fn bulge([from, to]: [Place3; 2], bulge: f64) -> Option<Self> {
        let [dx, dy] = [to[0] - from[0], to[1] - from[1]];
        if bulge == 0.0 || (dx == 0.0 && dy == 0.0) {
            return None;
        }
        // The center lies on the bisector, to the left of the chord by its half times (1 - b²) / 2b.
        let along = (1.0 - bulge * bulge) / (4.0 * bulge);
        let center = [
            0.5 * from[0] + 0.5 * to[0] - dy * along,
            0.5 * from[1] + 0.5 * to[1] + dx * along,
            from[2],
        ];
        // Not the difference to the center, which may be far away.
        let u = [dy * along - 0.5 * dx, -dx * along - 0.5 * dy, 0.0];
        Some(Self {
            center,
            u,
            v: [-u[1], u[0], 0.0],
            start: 0.0,
            sweep: 4.0 * libm::atan(bulge),
        })
    }

    /// Returns the arc as a map moves it.
    pub fn mapped(&self, map: &Affine) -> Self {
        Self {
            center: map.place(self.center),
            u: map.direction(self.u),
            v: map.direction(self.v),
            ..*self
        }
    }

    /// Returns the point of a parameter.
    pub fn at(&self, t: f64) -> Place3 {
        self.toward([libm::cos(t), libm::sin(t)])
    }

    /// Returns the point of a cosine and sine.
    pub fn toward(&self, [cos, sin]: [f64; 2]) -> Place3 {
        [0, 1, 2].map(|k| self.center[k] + (self.u[k] * cos + self.v[k] * sin))
    }

    /// Adds the points between the ends, the first of which is there.
    pub(super) fn flatten(&self, flatness: f64, line: &mut Vec<Place3>) -> Result<(), Problem> {
        let pieces = self.pieces(flatness)?;
        if self.start == 0.0 && self.is_whole() {
            line.extend((1..pieces).map(|i| self.of_turn(i, pieces)));
            return Ok(());
        }
        // Measured from the first point: the center of a flat arc is so far away that its rounding would show.
        let from = line[line.len() - 1];
        let [cos, sin] = [libm::cos(self.start), libm::sin(self.start)];
        let outward = [0, 1, 2].map(|k| self.u[k] * cos + self.v[k] * sin);
        let onward = [0, 1, 2].map(|k| self.v[k] * cos - self.u[k] * sin);
        line.extend((1..pieces).map(|i| {
            let turned = self.sweep * (i as f64 / pieces as f64);
            let half = libm::sin(0.5 * turned);
            let (along, back) = (libm::sin(turned), 2.0 * half * half);
            [0, 1, 2].map(|k| from[k] + (onward[k] * along - outward[k] * back))
        }));
        Ok(())
    }

    fn is_whole(&self) -> bool {
        self.sweep.abs() == TAU
    }

    /// Returns the point of a part of a whole turn; quarters are exact.
    fn of_turn(&self, i: usize, pieces: usize) -> Place3 {
        let (quarter, rest) = (4 * i / pieces, 4 * i % pieces);
        let angle = FRAC_PI_2 * (rest as f64 / pieces as f64);
        let [cos, sin] = [libm::cos(angle), libm::sin(angle)];
        let [cos, sin] = [[cos, sin], [-sin, cos], [-cos, -sin], [sin, -cos]][quarter];
        self.toward([cos, sin * self.sweep.signum()])
    }

    /// Counts the pieces: a multiple of four for a whole ellipse, else at least one a quarter.
    fn pieces(&self, flatness: f64) -> Result<usize, Problem> {
        let radius = longest(self.u, self.v);
        let quarters = self.sweep.abs() / FRAC_PI_2;
        let needed = match radius == 0.0 {
            true => 1.0,
            false => self.sweep.abs() * (radius / (8.0 * flatness)).sqrt(),
        };
        let needed = needed.max(quarters).ceil().max(1.0);
        if needed.is_nan() || needed > (MAX_PIECES - 3) as f64 {
            return Err(too_fine());
        }
        let needed = needed as usize;
        Ok(match self.is_whole() {
            true => needed.next_multiple_of(4),
            false => needed,
        })
    }

    /// Returns the points of extreme x and y that lie on the arc.
    pub(super) fn extremes(&self) -> Vec<Place3> {
        let on_arc = |t: &f64| {
            let way = (t - self.start) * self.sweep.signum();
            way.rem_euclid(TAU) <= self.sweep.abs()
        };
        let of_axis = |k: usize| {
            let first = libm::atan2(self.v[k], self.u[k]);
            [first, first + PI]
        };
        let extremes = [of_axis(0), of_axis(1)].into_iter().flatten();
        let mut found: Vec<_> = extremes.filter(on_arc).map(|t| self.at(t)).collect();
        // Whatever lies on the arc, these show what is not finite.
        let is_finite = self.u.iter().chain(&self.v).all(|value| value.is_finite());
        found.extend((!is_finite).then_some([f64::NAN; 3]));
        found
    }
}

/// Returns the longer half axis of the ellipse of two vectors, seen from above, or a little more.
fn longest(u: Place3, v: Place3) -> f64 {
    // Without squares of large numbers; the largest singular value of a matrix of entries up to 1.
    let scale = [u[0], u[1], v[0], v[1]]
        .map(f64::abs)
        .into_iter()
        .fold(0.0, f64::max);
    if scale == 0.0 {
        return 0.0;
    }
    let [a, b, c, d] = [u[0], u[1], v[0], v[1]].map(|value| value / scale);
    let half = 0.5 * (a * a + b * b + c * c + d * d);
    let area = a * d - b * c;
    let root = ((half - area) * (half + area)).max(0.0).sqrt();
    scale * (half + root).sqrt()
}
