//! Angles, edges and area of a triangle, whatever its size.

use super::magnitude;
use crate::generate::scaled;
use delone::Point;

/// Shape of a triangle, in rounded numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shape {
    /// Angles at the corners, in degrees.
    pub angles: [f64; 3],
    /// Lengths of the edges opposite the corners.
    pub edges: [f64; 3],
    /// Area; may round to zero or infinity.
    pub area: f64,
}

impl Shape {
    /// Measures a triangle, to some units in the last place.
    pub fn of(corners: [Point; 3]) -> Self {
        let exponent = safe_exponent(corners);
        let [a, b, c] = corners.map(|p| [scaled(p.x, exponent), scaled(p.y, exponent)]);
        let sides = [minus(c, b), minus(a, c), minus(b, a)];
        let [u, v, w] = sides;
        let edges = sides.map(|[x, y]| x.hypot(y));
        Self {
            angles: [angle(w, v), angle(u, w), angle(v, u)],
            edges: edges.map(|e| scaled(e, -exponent)),
            area: scaled(doubled_area(sides, edges) / 2.0, -2 * exponent),
        }
    }

    /// Returns the smallest angle, in degrees.
    pub fn min_angle(&self) -> f64 {
        self.angles.into_iter().fold(f64::INFINITY, f64::min)
    }

    /// Returns the length of the longest edge.
    pub fn longest(&self) -> f64 {
        self.edges.into_iter().fold(0.0, f64::max)
    }

    /// Returns the length of the shortest edge.
    pub fn shortest(&self) -> f64 {
        self.edges.into_iter().fold(f64::INFINITY, f64::min)
    }
}

/// The power of two that brings coordinates near 1, if they are so large or small that squares of
/// their differences would leave the range.
fn safe_exponent(corners: [Point; 3]) -> i32 {
    let size = magnitude(corners);
    if size > 0.0 && !(1e-60..1e60).contains(&size) {
        // The logarithm of a subnormal is right, too.
        -(size.log2().round() as i32)
    } else {
        0
    }
}

fn minus([ax, ay]: [f64; 2], [bx, by]: [f64; 2]) -> [f64; 2] {
    [ax - bx, ay - by]
}

/// The angle between a side that ends in a corner and the one that starts there, in degrees.
fn angle([ax, ay]: [f64; 2], [bx, by]: [f64; 2]) -> f64 {
    let cross = ax * by - ay * bx;
    let dot = -(ax * bx + ay * by);
    cross.abs().atan2(dot).to_degrees()
}

/// Twice the area, from the two shorter sides: their differences are the most exact.
fn doubled_area(sides: [[f64; 2]; 3], edges: [f64; 3]) -> f64 {
    let longest = (0..3).fold(0, |most, i| if edges[i] > edges[most] { i } else { most });
    let [[ax, ay], [bx, by]] = [1, 2].map(|step| sides[(longest + step) % 3]);
    (ax * by - ay * bx).abs()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn triangles_of_every_size_are_measured() {
        for exponent in [-1060, -300, 0, 300, 1000] {
            let corners = [(0.0, 0.0), (3.0, 0.0), (3.0, 3.0)];
            let corners =
                corners.map(|(x, y)| Point::new(scaled(x, exponent), scaled(y, exponent)));
            let shape = Shape::of(corners);
            let expected = [45.0, 90.0, 45.0];
            let is_right = |(found, right): (f64, f64)| (found - right).abs() < 1e-12;
            assert!(
                shape.angles.into_iter().zip(expected).all(is_right),
                "{shape:?}"
            );
            assert!((shape.min_angle() - 45.0).abs() < 1e-12);
            assert_eq!(shape.shortest(), scaled(3.0, exponent));
            let diagonal = scaled(shape.longest(), -exponent);
            assert!((diagonal - 18f64.sqrt()).abs() < 0.5, "{diagonal}");
            assert_eq!(shape.area, scaled(4.5, 2 * exponent));
        }
    }
}
