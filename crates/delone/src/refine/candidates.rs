//! Where a new vertex could make a bad triangle vanish.
//!
//! The classical choice is the circumcenter (Ruppert 1995). Nearer to the shortest edge pq lies the
//! off-center (Üngör 2004), which leaves a triangle pqc that is just good enough: fewer vertices do. Any
//! point that sees pq under an angle that is good enough, but larger than the bad one, will do; several of
//! them are compared by what they would make and destroy, in the spirit of Erten and Üngör (*Triangulations
//! with locally optimal Steiner points*, 2007).

use crate::Point;
use std::f64::consts::PI;

/// The directions, seen from the center of the circle of good apexes, in which candidates are looked for:
/// radians from the bisector of the shortest edge.
const SPREAD: [f64; 4] = [0.6, -0.6, 1.2, -1.2];

/// The angle under which an off-center sees the shortest edge, at least: 35 degrees. Well above the smallest
/// angles that are usually asked for, where fewer vertices do than at the bound itself (measured).
const APEX: f64 = 35.0 * PI / 180.0;

/// The angle under which those candidates see the shortest edge, as a multiple of the smallest allowed.
const INSCRIBED: f64 = 1.03;

/// What is the same for all skinny triangles.
pub(super) struct Candidates {
    /// Height of the off-center above half the shortest edge.
    off_center: f64,
    /// Radius of the circle of good apexes over the length of the shortest edge, and how far its center
    /// lies above it.
    radius: f64,
    center: f64,
    /// Cosine and sine of each direction of the spread.
    directions: [[f64; 2]; SPREAD.len()],
}

impl Candidates {
    pub const MOST: usize = SPREAD.len() + 1;

    /// Prepares for a smallest angle, in radians.
    pub fn new(min_angle: f64) -> Self {
        let apex = APEX.max(1.12 * min_angle);
        let half = 0.5 / libm::tan(0.5 * apex);
        let inscribed = (INSCRIBED * min_angle).clamp(1e-6, 0.5 * PI);
        let radius = 0.5 / libm::sin(inscribed);
        Self {
            off_center: half,
            radius,
            center: radius * libm::cos(inscribed),
            directions: SPREAD.map(|angle| [libm::cos(angle), libm::sin(angle)]),
        }
    }

    /// Lists candidates for the triangle to the left of its shortest edge pq, the off-center first;
    /// `circumcenter` is that of the triangle.
    pub fn of(&self, [p, q]: [Point; 2], circumcenter: Point) -> [Point; Self::MOST] {
        let [ux, uy] = [q.x - p.x, q.y - p.y];
        let middle = Point::new(0.5 * (p.x + q.x), 0.5 * (p.y + q.y));
        // Across and above, in units of pq.
        let at = |across: f64, above: f64| {
            Point::new(
                middle.x + across * ux - above * uy,
                middle.y + across * uy + above * ux,
            )
        };
        let [mx, my] = [circumcenter.x - middle.x, circumcenter.y - middle.y];
        let height_squared = mx * mx + my * my;
        let reach = self.off_center * self.off_center * (ux * ux + uy * uy);
        let first = match height_squared <= reach {
            true => circumcenter,
            false => at(0.0, self.off_center),
        };
        let mut all = [first; Self::MOST];
        for (candidate, [cos, sin]) in all[1..].iter_mut().zip(self.directions) {
            *candidate = at(self.radius * sin, self.center + self.radius * cos);
        }
        all
    }
}

/// Returns the circumcenter, rounded; not finite if the triangle is too flat.
pub(super) fn circumcenter([a, b, c]: [Point; 3]) -> Point {
    let [ux, uy] = [b.x - a.x, b.y - a.y];
    let [vx, vy] = [c.x - a.x, c.y - a.y];
    let [ul, vl] = [ux * ux + uy * uy, vx * vx + vy * vy];
    let factor = 0.5 / (ux * vy - uy * vx);
    Point::new(
        a.x + factor * (vy * ul - uy * vl),
        a.y + factor * (ux * vl - vx * ul),
    )
}
