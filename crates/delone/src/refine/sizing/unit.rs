//! The unit in which distances are measured, so that their squares neither overflow nor vanish.

use crate::Point;

/// A power of two near the largest coordinate of some points. Dividing by it rounds nothing but what is
/// too small beside that coordinate to matter.
#[derive(Clone, Copy, Debug)]
pub(super) struct Unit {
    per_unit: f64,
    unit: f64,
}

/// Farthest that a question is looked for, in units; what is farther is asked here instead.
const FARTHEST: f64 = (1_u128 << 100) as f64;

impl Unit {
    /// Finds the unit of points.
    pub fn of<'p>(points: impl Iterator<Item = &'p Point>) -> Self {
        let sizes = points.map(|p| p.x.abs().max(p.y.abs()));
        let largest = sizes.fold(0.0, f64::max);
        // Beyond these limits it, or its inverse, would not be a normal number.
        let exponent = (exponent_of(largest)).clamp(-1000, 1000);
        Self {
            per_unit: power_of_two(-exponent),
            unit: power_of_two(exponent),
        }
    }

    /// Expresses a position in units.
    #[inline]
    pub fn measure(&self, p: Point) -> Point {
        let [x, y] = [p.x, p.y].map(|c| (c * self.per_unit).clamp(-FARTHEST, FARTHEST));
        Point::new(x, y)
    }

    /// Returns the length of so many units, at most the largest number.
    #[inline]
    pub fn length(&self, units: f64) -> f64 {
        (units * self.unit).min(f64::MAX)
    }
}

fn exponent_of(x: f64) -> i32 {
    (x.to_bits() >> 52 & 0x7ff) as i32 - 1023
}

fn power_of_two(exponent: i32) -> f64 {
    f64::from_bits(((exponent + 1023) as u64) << 52)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn everything_is_near_one_and_comes_back() {
        for largest in [5e-324, 1e-300, 1e-9, 0.75, 1.0, 3.0, 1e9, f64::MAX] {
            let p = Point::new(largest / 2.0, -largest);
            let unit = Unit::of([p].iter());
            let measured = unit.measure(p);
            // At the ends of the range of numbers units are not so near.
            let reach = if (1e-300..1e300).contains(&largest) {
                1.0..2.0
            } else {
                1e-24..1e8
            };
            assert!(reach.contains(&-measured.y), "{largest}: {measured:?}");
            assert_eq!(unit.length(-measured.y), largest);
        }
    }

    #[test]
    fn what_is_far_stays_finite() {
        let small = Unit::of([Point::new(1e-300, 0.0)].iter());
        let far = small.measure(Point::new(1e300, -1.0));
        assert_eq!(far, Point::new(FARTHEST, -FARTHEST));
        let large = Unit::of([Point::new(1e300, 0.0)].iter());
        assert_eq!(large.length(1e30), f64::MAX);
        assert_eq!(
            Unit::of([].iter()).measure(Point::new(1.0, 2.0)).x,
            FARTHEST
        );
    }
}
