//! The first look at the input: finiteness, bounding box, and the class of its coordinates.

use crate::order::exponent;
use crate::{Error, Point};

/// The bounding box and the range of magnitudes of a set of points.
#[derive(Clone, Copy, Debug)]
pub(super) struct Extent {
    pub min: [f64; 2],
    pub max: [f64; 2],
    /// The least magnitude of a coordinate that is not zero; infinite if all are zero.
    least: f64,
    /// NaN if some coordinate is not finite, else zero.
    poison: f64,
}

impl Extent {
    /// The empty set.
    pub const EMPTY: Self = Self {
        min: [f64::INFINITY; 2],
        max: [f64::NEG_INFINITY; 2],
        least: f64::INFINITY,
        poison: 0.0,
    };

    /// Measures points.
    pub fn of(points: &[Point]) -> Self {
        points.iter().fold(Self::EMPTY, |extent, &p| extent.with(p))
    }

    #[inline(always)]
    fn with(self, p: Point) -> Self {
        let lesser = |a: f64, b: f64| if a < b { a } else { b };
        let magnitude = |c: f64| if c == 0.0 { f64::INFINITY } else { c.abs() };
        Self {
            min: [lesser(p.x, self.min[0]), lesser(p.y, self.min[1])],
            max: [-lesser(-p.x, -self.max[0]), -lesser(-p.y, -self.max[1])],
            least: lesser(lesser(magnitude(p.x), magnitude(p.y)), self.least),
            poison: self.poison + 0.0 * p.x + 0.0 * p.y,
        }
    }

    /// Measures the union of two sets.
    pub fn union(self, other: Self) -> Self {
        let min = [0, 1].map(|k| self.min[k].min(other.min[k]));
        let max = [0, 1].map(|k| self.max[k].max(other.max[k]));
        Self {
            min,
            max,
            least: self.least.min(other.least),
            poison: self.poison + other.poison,
        }
    }

    pub fn is_finite(&self) -> bool {
        self.poison == 0.0
    }

    /// Chooses how to compute with these coordinates.
    pub fn class(&self) -> Class {
        let largest = [self.min, self.max]
            .as_flattened()
            .iter()
            .fold(0.0, |m: f64, c| m.max(c.abs()));
        if largest <= ORDINARY_MAX && self.least >= ORDINARY_MIN {
            return Class::Ordinary { scale: 0 };
        }
        // Moves the largest coordinate to just below the upper end of the ordinary class.
        let scale = 249 - exponent(largest);
        if exponent(self.least) + scale >= -200 {
            Class::Ordinary { scale }
        } else {
            Class::Wide
        }
    }
}

/// Ordinary coordinates are zero or of a magnitude between 2⁻²⁰⁰ and 2²⁵⁰; then no product in a
/// filter over- or underflows.
const ORDINARY_MIN: f64 = f64::from_bits((1023 - 200) << 52);
const ORDINARY_MAX: f64 = f64::from_bits((1023 + 250) << 52);

/// How to compute with a set of coordinates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Class {
    /// Multiplied by 2^`scale` (which is exact and changes no sign) all are ordinary.
    Ordinary { scale: i32 },
    /// Magnitudes too far apart for any scale: every sign is taken exactly.
    Wide,
}

/// Finds the first coordinate that is not finite.
pub(super) fn first_not_finite(points: &[Point]) -> Option<Error> {
    let index = points.iter().position(|p| !p.is_finite())?;
    let Point { x, y } = points[index];
    Some(Error::NotFinite { index, x, y })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::order::split_power;

    fn class(values: [f64; 2]) -> Class {
        Extent::of(&[Point::new(values[0], values[1])]).class()
    }

    #[test]
    fn classes() {
        let scale = |e| Class::Ordinary { scale: e };
        assert_eq!(class([0.0, -0.0]), scale(0));
        assert_eq!(class([1.0, -1e60]), scale(0));
        assert_eq!(class([1e300, 1e290]), scale(249 - 996));
        assert_eq!(class([5e-324, 0.0]), scale(249 + 1074));
        assert_eq!(class([1e-300, 1.0]), Class::Wide);
        assert_eq!(class([1e300, 1.0]), Class::Wide);
        // The largest coordinate lies where no scale is needed: the least must be looked at still.
        let top = 2f64.powi(249);
        for least in [1e-300, 5e-324, 2f64.powi(-201)] {
            assert_eq!(class([top, least]), Class::Wide);
        }
        assert_eq!(class([top, 2f64.powi(-200)]), scale(0));
    }

    #[test]
    fn scaling_is_exact_both_ways() {
        for (value, scale) in [(5e-324, 249 + 1074), (f64::MAX, 249 - 1023), (3.0, 0)] {
            let [a, b] = split_power(scale);
            let scaled: f64 = value * a * b;
            assert!((ORDINARY_MIN..=ORDINARY_MAX).contains(&scaled));
            let [a, b] = split_power(-scale);
            assert_eq!(scaled * a * b, value);
        }
    }

    #[test]
    fn the_first_point_that_is_not_finite_is_named() {
        let points = [(0.0, 1.0), (2.0, f64::NAN), (f64::INFINITY, 0.0)].map(Point::from);
        assert!(!Extent::of(&points).is_finite());
        let Some(Error::NotFinite { index, x, y }) = first_not_finite(&points) else {
            panic!("an error");
        };
        assert!(index == 1 && x == 2.0 && y.is_nan());
        for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert!(!Extent::of(&[Point::new(0.0, value)]).is_finite());
        }
    }
}
