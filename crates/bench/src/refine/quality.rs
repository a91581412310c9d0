//! What a mesh is like: measured alike for everyone, by the peers' script in the same words.

use super::goal::Goal;
use serde::{Deserialize, Serialize};

/// A bound missed by less, relative to it, is rounding.
const SLACK: f64 = 1e-9;

/// What the check found out about a mesh.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Quality {
    /// Number of triangles.
    pub triangles: usize,
    /// Smallest angle, degrees; 180 if there are no triangles.
    pub min_angle: f64,
    /// Largest area; 0 if there are no triangles.
    pub max_area: f64,
    /// Sum of the areas: that of the domain.
    pub area: f64,
    /// Triangles with a smaller angle than asked for.
    pub skinny: usize,
    /// Triangles with a larger area than asked for.
    pub oversized: usize,
    /// Triangles that miss a bound without an excuse, if the mesher knows excuses.
    pub unexcused: Option<usize>,
    /// Name of the set of triangles, if the mesher has one.
    pub hash: Option<String>,
}

impl Quality {
    /// Measures triangles.
    pub fn of(triangles: impl IntoIterator<Item = [[f64; 2]; 3]>, goal: Goal) -> Self {
        let mut quality = Self {
            triangles: 0,
            min_angle: 180.0,
            max_area: 0.0,
            area: 0.0,
            skinny: 0,
            oversized: 0,
            unexcused: None,
            hash: None,
        };
        for corners in triangles {
            quality.add(corners, goal);
        }
        quality
    }

    fn add(&mut self, corners: [[f64; 2]; 3], goal: Goal) {
        let (angle, area) = measure(corners);
        self.triangles += 1;
        self.min_angle = self.min_angle.min(angle);
        self.max_area = self.max_area.max(area);
        self.area += area;
        self.skinny += usize::from(angle < goal.angle * (1.0 - SLACK));
        let is_oversized = goal.area.is_some_and(|bound| area > bound * (1.0 + SLACK));
        self.oversized += usize::from(is_oversized);
    }
}

/// Returns the smallest angle of a triangle in degrees, and its area; clockwise ones are negative.
fn measure([a, b, c]: [[f64; 2]; 3]) -> (f64, f64) {
    let side = |p: [f64; 2], q: [f64; 2]| [q[0] - p[0], q[1] - p[1]];
    let cross = |[ux, uy]: [f64; 2], [vx, vy]: [f64; 2]| ux * vy - uy * vx;
    let dot = |[ux, uy]: [f64; 2], [vx, vy]: [f64; 2]| ux * vx + uy * vy;
    let corner = |p, q, r| {
        let [along, back] = [side(p, q), side(p, r)];
        cross(along, back).atan2(dot(along, back)).to_degrees()
    };
    let angle = corner(a, b, c).min(corner(b, c, a)).min(corner(c, a, b));
    (angle, 0.5 * cross(side(a, b), side(a, c)))
}

#[cfg(test)]
mod tests {
    use super::{Goal, Quality};

    #[test]
    fn bounds_are_held_against_every_triangle() {
        let [o, e, n, far] = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.0, 10.0]];
        let goal = Goal {
            angle: 45.0,
            area: Some(0.5),
        };
        let quality = Quality::of([[o, e, n], [o, e, far], [o, n, e]], goal);
        assert_eq!(quality.triangles, 3);
        // The clockwise one has negative angles.
        assert_eq!((quality.skinny, quality.oversized), (2, 1));
        assert_eq!((quality.min_angle, quality.max_area), (-90.0, 5.0));
        assert_eq!(quality.area, 5.0);
        let lax = Goal {
            angle: 5.0,
            area: None,
        };
        let quality = Quality::of([[o, e, far]], lax);
        assert_eq!((quality.skinny, quality.oversized), (0, 0));
        assert!((quality.min_angle - 5.710_593_137_499_643).abs() < 1e-12);
    }
}
