//! Areas, centroids, lengths and moments of polygons, in rounded numbers.
//!
//! Nothing but the four operations and the square root, which round alike everywhere. Coordinates are
//! scaled by a power of two, so that products neither overflow nor vanish on the way.

use crate::Point;

/// What a part of the plane amounts to.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Measure {
    /// Area, in squared units of the coordinates; may round to zero or infinity.
    pub area: f64,
    /// Center of mass; NaN if the area rounds to nothing even beside the extent of the part.
    pub centroid: Point,
    /// Length of the boundary, holes included, in units of the coordinates.
    pub perimeter: f64,
}

/// A power of two by which to divide, so that the largest of some coordinates becomes about one.
#[derive(Clone, Copy, Debug)]
pub(super) struct Unit {
    size: f64,
    /// One divided by it, without rounding; multiplying by it is dividing by the size.
    inverse: f64,
}

impl Unit {
    /// Finds the unit of some lengths or coordinates.
    pub fn of(numbers: impl Iterator<Item = f64>) -> Self {
        let largest = numbers.fold(0.0, |most: f64, c| most.max(c.abs()));
        let exponent = (largest.to_bits() >> 52) as i32 - 1023;
        // Within these limits its inverse is a normal number, too.
        let exponent = exponent.clamp(-1000, 1000);
        Self {
            size: power_of_two(exponent),
            inverse: power_of_two(-exponent),
        }
    }

    pub fn of_points<'p>(points: impl Iterator<Item = &'p Point>) -> Self {
        Self::of(points.flat_map(|p| [p.x, p.y]))
    }

    /// Returns a position in units.
    #[inline]
    pub fn scaled(self, p: Point) -> Point {
        Point::new(p.x * self.inverse, p.y * self.inverse)
    }

    /// Returns what so many units are, at most the largest number.
    #[inline]
    pub fn length(self, units: f64) -> f64 {
        (units * self.size).clamp(-f64::MAX, f64::MAX)
    }
}

fn power_of_two(exponent: i32) -> f64 {
    f64::from_bits(((exponent + 1023) as u64) << 52)
}

/// Sums up the boundary of a part, ring by ring: outlines counter-clockwise, holes clockwise.
#[derive(Clone, Copy, Debug)]
pub(super) struct Moments {
    unit: Unit,
    /// Everything is measured from here: the first point of all.
    origin: Point,
    has_origin: bool,
    doubled_area: f64,
    /// Six times the first moments about the origin.
    first: [f64; 2],
    perimeter: f64,
}

impl Moments {
    /// Begins with nothing; `unit` is that of all points to come.
    pub fn new(unit: Unit) -> Self {
        Self {
            unit,
            origin: Point::default(),
            has_origin: false,
            doubled_area: 0.0,
            first: [0.0; 2],
            perimeter: 0.0,
        }
    }

    /// Measures some rings.
    pub fn of<'r>(rings: impl Iterator<Item = &'r [Point]> + Clone) -> Self {
        let mut moments = Self::new(Unit::of_points(rings.clone().flatten()));
        rings.for_each(|ring| moments.add(ring));
        moments
    }

    /// Adds a closed ring.
    pub fn add(&mut self, ring: &[Point]) {
        let Some(&last) = ring.last() else { return };
        if !self.has_origin {
            self.origin = self.unit.scaled(ring[0]);
            self.has_origin = true;
        }
        let mut a = self.relative(last);
        for &p in ring {
            let b = self.relative(p);
            let cross = a[0] * b[1] - a[1] * b[0];
            self.doubled_area += cross;
            for (k, first) in self.first.iter_mut().enumerate() {
                *first += cross * (a[k] + b[k]);
            }
            let [x, y] = [b[0] - a[0], b[1] - a[1]];
            self.perimeter += length(x, y);
            a = b;
        }
    }

    fn relative(&self, p: Point) -> [f64; 2] {
        let p = self.unit.scaled(p);
        [p.x - self.origin.x, p.y - self.origin.y]
    }

    pub fn finish(&self) -> Measure {
        let [x, y] = self.first.map(|first| first / (3.0 * self.doubled_area));
        let size = self.unit.size;
        Measure {
            area: 0.5 * self.doubled_area * size * size,
            centroid: Point::new(
                self.unit.length(self.origin.x + x),
                self.unit.length(self.origin.y + y),
            ),
            perimeter: self.unit.length(self.perimeter),
        }
    }
}

/// Returns twice the area of a ring, in units of its own, as [`Moments`] finds it.
pub(super) fn doubled_area(ring: &[Point]) -> f64 {
    let [Some(&first), Some(&last)] = [ring.first(), ring.last()] else {
        return 0.0;
    };
    let unit = Unit::of_points(ring.iter());
    let origin = unit.scaled(first);
    let relative = |p: Point| {
        let p = unit.scaled(p);
        [p.x - origin.x, p.y - origin.y]
    };
    let mut a = relative(last);
    let mut sum = 0.0;
    for &p in ring {
        let b = relative(p);
        sum += a[0] * b[1] - a[1] * b[0];
        a = b;
    }
    sum
}

/// Integrates the squared distance from `site` over what `ring` surrounds, in units to the fourth
/// power: negative for a ring that turns clockwise.
pub(super) fn second_moment(unit: Unit, site: Point, ring: &[Point]) -> f64 {
    let Some(&last) = ring.last() else {
        return 0.0;
    };
    let site = unit.scaled(site);
    let relative = |p: Point| {
        let p = unit.scaled(p);
        [p.x - site.x, p.y - site.y]
    };
    let mut a = relative(last);
    let mut sum = 0.0;
    for &p in ring {
        let b = relative(p);
        let dot = |u: [f64; 2], v: [f64; 2]| u[0] * v[0] + u[1] * v[1];
        sum += (a[0] * b[1] - a[1] * b[0]) * (dot(a, a) + dot(a, b) + dot(b, b));
        a = b;
    }
    sum / 12.0
}

/// Returns the length of a vector whose components are not far beyond one.
pub(super) fn length(x: f64, y: f64) -> f64 {
    let most = x.abs().max(y.abs());
    if most == 0.0 {
        return 0.0;
    }
    let [x, y] = [x / most, y / most];
    most * (x * x + y * y).sqrt()
}

/// Returns the vector between two points divided by its larger component, and that component.
pub(super) fn difference(from: Point, to: Point) -> ([f64; 2], f64) {
    let mut vector = [to.x - from.x, to.y - from.y];
    let mut size = vector[0].abs().max(vector[1].abs());
    let factor = if size.is_finite() { 1.0 } else { 0.5 };
    if factor < 1.0 {
        vector = [0.5 * to.x - 0.5 * from.x, 0.5 * to.y - 0.5 * from.y];
        size = vector[0].abs().max(vector[1].abs());
    }
    if size == 0.0 {
        return (vector, 0.0);
    }
    (vector.map(|c| c / size), (size / factor).min(f64::MAX))
}

/// Returns how far two points are apart, at most the largest number.
pub(super) fn distance(a: Point, b: Point) -> f64 {
    // The larger component is one, or both are zero.
    let ([x, y], size) = difference(a, b);
    (size * (x * x + y * y).sqrt()).min(f64::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_frame_is_measured_at_any_size() {
        for size in [1e-300, 1e-100, 1.0, 1e150, 1e300] {
            let at = |x: f64, y: f64| Point::new(x * size, y * size);
            let outline = [at(1.0, 1.0), at(5.0, 1.0), at(5.0, 3.0), at(1.0, 3.0)];
            let hole = [at(2.0, 1.5), at(2.0, 2.5), at(3.0, 2.5), at(3.0, 1.5)];
            let rings = [&outline[..], &hole[..]];
            let found = Moments::of(rings.into_iter()).finish();
            let near = |value: f64, expected: f64| {
                value == expected || (value / expected - 1.0).abs() < 1e-14
            };
            assert!(near(found.area, 7.0 * size * size), "{found:?}");
            assert!(near(found.perimeter, 16.0 * size), "{found:?}");
            assert!(near(found.centroid.x, (8.0 * 3.0 - 2.5) / 7.0 * size));
            assert!(near(found.centroid.y, 2.0 * size));
        }
    }

    #[test]
    fn moments_are_those_of_a_square() {
        let square = [(1.0, 1.0), (3.0, 1.0), (3.0, 3.0), (1.0, 3.0)].map(Point::from);
        let unit = Unit::of([0.75].into_iter());
        // 8/3 about its center, and 4 times the squared distance elsewhere; in halves, 16 times that.
        let found = second_moment(unit, Point::new(2.0, 2.0), &square);
        assert!((found - 16.0 * 8.0 / 3.0).abs() < 1e-12, "{found}");
        let found = second_moment(unit, Point::new(2.0, 5.0), &square);
        assert!((found - 16.0 * (8.0 / 3.0 + 36.0)).abs() < 1e-11, "{found}");
    }
}
