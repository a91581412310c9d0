//! Angles, lengths and area of one triangle, in rounded numbers: for reports and pictures, never for
//! decisions.
//!
//! Nothing here but the four operations and the square root, which round alike everywhere: the same
//! triangle has the same shape on every machine.

use crate::Point;

/// Shape of one triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shape {
    /// Angles at the corners, in degrees.
    pub angles: [f64; 3],
    /// Lengths of the edges opposite the corners, in units of the coordinates.
    pub edges: [f64; 3],
    /// Area, in squared units of the coordinates, never negative; may round to zero or infinity.
    pub area: f64,
    /// Longest edge divided by the height upon it: 1.1547 for an equilateral triangle, infinite for
    /// a flat one.
    pub aspect: f64,
    /// Radius of the circumcircle divided by the shortest edge: 0.5774 for an equilateral triangle,
    /// infinite for a flat one.
    pub radius_edge: f64,
}

/// Coordinates between which products of three neither overflow nor lose digits.
const ORDINARY: std::ops::Range<f64> = 1e-90..1e90;

impl Shape {
    /// Measures a triangle with corners in either orientation.
    ///
    /// Angles keep their meaning for coordinates of any size; differences beyond the largest `f64`
    /// count as that.
    ///
    /// *Cost*: about 30 ns.
    pub fn of(corners: [Point; 3]) -> Self {
        let [a, b, c] = corners;
        let sides = [(b, c), (c, a), (a, b)].map(|(from, to)| difference(from, to));
        let longest = sides.as_flattened().iter().fold(0.0, greater);
        if ORDINARY.contains(&longest) {
            return Self::of_sides(sides);
        }
        // Angles do not depend on the scale, so neither products nor sums can overflow; and a power of two
        // changes no digit of them.
        let scale = power_of_two_up_to(longest.max(f64::MIN_POSITIVE));
        let unit = Self::of_sides(sides.map(|side| side.map(|c| c / scale)));
        Self {
            edges: unit.edges.map(|edge| edge * scale),
            area: unit.area * scale * scale,
            ..unit
        }
    }

    /// Measures a triangle by its directed sides, which are of ordinary size.
    fn of_sides(sides @ [u, v, w]: [[f64; 2]; 3]) -> Self {
        let doubled_area = cross(u, v).abs();
        // The angle at a corner is that between the side that goes out and the one that came in.
        let angles = [(v, w), (w, u), (u, v)].map(|(p, q)| angle(doubled_area, -dot(p, q)));
        let edges @ [p, q, r] = sides.map(length);
        let (shortest, longest) = (p.min(q).min(r), p.max(q).max(r));
        let per_area = |product: f64| match doubled_area {
            0.0 => f64::INFINITY,
            area => product / area,
        };
        Self {
            angles,
            edges,
            area: 0.5 * doubled_area,
            aspect: per_area(longest * longest),
            radius_edge: per_area(p / shortest * q * r / 2.0),
        }
    }

    /// Returns the smallest angle, in degrees: 60 for an equilateral triangle, 0 for a flat one.
    pub fn min_angle(&self) -> f64 {
        let [a, b, c] = self.angles;
        a.min(b).min(c)
    }

    /// Returns the largest angle, in degrees.
    pub fn max_angle(&self) -> f64 {
        let [a, b, c] = self.angles;
        a.max(b).max(c)
    }
}

/// Measures how far two points are apart, in units of the coordinates.
pub(super) fn distance(a: Point, b: Point) -> f64 {
    // As a triangle's side, so that it counts the same as those.
    Shape::of([a, b, b]).edges[2]
}

fn difference(from: Point, to: Point) -> [f64; 2] {
    [to.x - from.x, to.y - from.y].map(|c| c.clamp(-f64::MAX, f64::MAX))
}

/// Drops all digits of a positive normal number but the first.
fn power_of_two_up_to(number: f64) -> f64 {
    f64::from_bits(number.to_bits() & f64::INFINITY.to_bits())
}

fn greater(most: f64, c: &f64) -> f64 {
    most.max(c.abs())
}

fn length(side: [f64; 2]) -> f64 {
    let square = dot(side, side);
    if square > 1e-290 {
        return square.sqrt();
    }
    // Far shorter than the other sides: the square has lost digits, or vanished.
    let longest = side.iter().fold(f64::MIN_POSITIVE, greater);
    let unit = side.map(|c| c / longest);
    longest * dot(unit, unit).sqrt()
}

fn cross([ax, ay]: [f64; 2], [bx, by]: [f64; 2]) -> f64 {
    ax * by - ay * bx
}

fn dot([ax, ay]: [f64; 2], [bx, by]: [f64; 2]) -> f64 {
    ax * bx + ay * by
}

/// Steps of the table from 0 to 45 degrees.
const STEPS: usize = 64;

const DEGREES: f64 = 180.0 / std::f64::consts::PI;

/// Angles in degrees with the tangents 0, 1/64, 2/64 … 1.
const ANGLES: [f64; STEPS + 1] = {
    let mut table = [0.0; STEPS + 1];
    let mut i = 0;
    while i + 1 < STEPS {
        // From one tangent to the next turns an angle of this tangent.
        let step = (STEPS as f64) / ((STEPS * STEPS + i * (i + 1)) as f64);
        table[i + 1] = table[i] + DEGREES * arc(step);
        i += 1;
    }
    table[STEPS] = 45.0;
    table
};

/// Returns the angle in radians of a small tangent: the begin of Taylor's series, good to the last digit
/// up to 1/64.
const fn arc(tangent: f64) -> f64 {
    let square = tangent * tangent;
    tangent * (1.0 - square * (1.0 / 3.0 - square * (0.2 - square / 7.0)))
}

/// Returns the angle in degrees with this sine and cosine, of any common size; the sine is not negative.
/// Zero if both are zero.
fn angle(sine: f64, cosine: f64) -> f64 {
    let along = cosine.abs();
    let is_steep = sine > along;
    let (y, x) = if is_steep {
        (along, sine)
    } else {
        (sine, along)
    };
    let x = x.max(f64::MIN_POSITIVE);
    let step = (y / x * STEPS as f64 + 0.5) as usize;
    let near = step as f64 / STEPS as f64;
    let acute = ANGLES[step] + DEGREES * arc((y - near * x) / (x + near * y));
    let acute = if is_steep { 90.0 - acute } else { acute };
    if cosine < 0.0 { 180.0 - acute } else { acute }
}

#[cfg(test)]
mod tests {
    use super::{Shape, angle};
    use crate::Point;

    #[test]
    fn angles_are_those_of_the_arc_tangent() {
        for i in 0..=100_000 {
            let expected = f64::from(i) * 0.0018;
            let (sine, cosine) = expected.to_radians().sin_cos();
            let found = angle(sine.abs() * 7.0, cosine * 7.0);
            assert!((found - expected).abs() < 1e-13, "{found} {expected}");
        }
        for tiny in [1e-10, 1e-100, 1e-300] {
            let found = angle(tiny, 1.0);
            assert!((found / tiny.to_degrees() - 1.0).abs() < 1e-15, "{found}");
        }
        let plain = [(0.0, 1.0), (1.0, 1.0), (1.0, 0.0), (1.0, -1.0), (0.0, -1.0)];
        let found = plain.map(|(sine, cosine)| angle(sine, cosine));
        assert_eq!(found, [0.0, 45.0, 90.0, 135.0, 180.0]);
        assert_eq!(angle(0.0, 0.0), 0.0);
    }

    #[test]
    fn an_equilateral_triangle_is_the_best() {
        let corners = [(0., 0.), (2., 0.), (1., 3f64.sqrt())].map(Point::from);
        let shape = Shape::of(corners);
        let close =
            |found: f64, expected: f64| assert!((found - expected).abs() < 1e-12, "{found}");
        close(shape.min_angle(), 60.0);
        close(shape.max_angle(), 60.0);
        close(shape.area, 3f64.sqrt());
        close(shape.aspect, 2.0 / 3f64.sqrt());
        close(shape.radius_edge, 1.0 / 3f64.sqrt());
    }

    #[test]
    fn flat_triangles_have_a_shape_too() {
        for c in [(1.0, 0.0), (0.5, 0.0), (0.0, 0.0), (3.0, 0.0)] {
            let shape = Shape::of([(0., 0.), (1., 0.), c].map(Point::from));
            assert_eq!((shape.min_angle(), shape.area), (0.0, 0.0));
            assert_eq!(shape.aspect, f64::INFINITY);
        }
        let point = Shape::of([Point::new(1.0, 2.0); 3]);
        assert_eq!((point.edges, point.angles), ([0.0; 3], [0.0; 3]));
        assert_eq!(point.radius_edge, f64::INFINITY);
    }

    #[test]
    fn angles_are_the_same_at_every_scale() {
        let at = |exponent: i32| {
            let scale = 2f64.powi(exponent);
            let corners = [(0.3, 0.1), (0.9, 0.2), (0.5, 0.7)];
            Shape::of(corners.map(|(x, y)| Point::new(x * scale, y * scale)))
        };
        for exponent in [-900, -300, 300, 900] {
            assert_eq!(at(exponent).angles, at(0).angles);
            let edges = at(0).edges.map(|edge| edge * 2f64.powi(exponent));
            assert_eq!(at(exponent).edges, edges);
        }
    }

    #[test]
    fn a_needle_keeps_its_short_edge() {
        let shape = Shape::of([(0., 0.), (1., 0.), (0., 3e-200)].map(Point::from));
        assert_eq!(shape.edges, [1.0, 3e-200, 1.0]);
        assert!((shape.min_angle() / 3e-200f64.to_degrees() - 1.0).abs() < 1e-12);
    }
}
