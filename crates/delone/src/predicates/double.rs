//! Double-double arithmetic: a number as the unevaluated sum of two `f64`, about 106 bits.
//!
//! The operations and bounds are those of Joldes, Muller and Popescu, *Tight and rigorous error
//! bounds for basic building blocks of double-word arithmetic* (2017); u = 2⁻⁵³. They hold as long
//! as nothing under- or overflows, which callers must see to. Products are split by Dekker's method
//! instead of fused: without the hardware for it, fusing is slow, and results must not depend on it.

use std::ops::{Add, Div, Mul, Sub};

/// The number `high + low`, where `high` is the sum rounded to nearest.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Double {
    pub high: f64,
    pub low: f64,
}

impl Double {
    /// Returns `a + b`, exactly (Knuth).
    #[inline(always)]
    pub fn sum(a: f64, b: f64) -> Self {
        let high = a + b;
        let a_virtual = high - b;
        let b_virtual = high - a_virtual;
        let low = (a - a_virtual) + (b - b_virtual);
        Self { high, low }
    }

    /// Returns `a + b`, exactly, for |a| ≥ |b| (Dekker).
    #[inline(always)]
    fn ordered_sum(a: f64, b: f64) -> Self {
        let high = a + b;
        Self {
            high,
            low: b - (high - a),
        }
    }

    /// Returns `a · b`, exactly (Dekker).
    #[inline(always)]
    fn product(a: f64, b: f64) -> Self {
        let high = a * b;
        let ([a1, a0], [b1, b0]) = (halves(a), halves(b));
        let low = a0 * b0 - (((high - a1 * b1) - a0 * b1) - a1 * b0);
        Self { high, low }
    }

    /// Returns the square root of a positive number. Relative error at most 16u².
    ///
    /// With s the rounded root of the high part, the remainder r = self − s² is at most 4u of the
    /// number; it is computed with three roundings, each of that size, r/(2s) adds two more, and of the
    /// series of the root (s² + r) − s = r/(2s) − … the rest is below 2u² of s.
    #[inline(always)]
    pub fn sqrt(self) -> Self {
        let root = self.high.sqrt();
        let square = Self::product(root, root);
        let rest = ((self.high - square.high) - square.low) + self.low;
        Self::ordered_sum(root, rest / (2.0 * root))
    }
}

/// Returns `a + t(b − a)` rounded once: off by at most half a unit in its last place, and 2⁻¹⁰⁰ of b − a.
/// Where b − a overflows, or its products do, by a few units of the larger of `a` and `b`.
#[inline]
pub(super) fn interpolated([a, b]: [f64; 2], t: f64) -> f64 {
    let factor = Double { high: t, low: 0.0 };
    let way = &Double::sum(b, -a) * &factor;
    let sum = (way + a).high;
    match sum.is_finite() {
        true => sum,
        false => (1.0 - t) * a + t * b,
    }
}

/// Splits into a sum of two numbers of at most 26 bits each.
#[inline(always)]
fn halves(a: f64) -> [f64; 2] {
    const SPLITTER: f64 = ((1_u64 << 27) + 1) as f64;
    let shifted = SPLITTER * a;
    let high = shifted - (shifted - a);
    [high, a - high]
}

/// Relative error at most 2u².
impl Add<f64> for Double {
    type Output = Self;

    #[inline(always)]
    fn add(self, b: f64) -> Self {
        let sum = Self::sum(self.high, b);
        Self::ordered_sum(sum.high, self.low + sum.low)
    }
}

/// Relative error at most 3u² + 13u³.
impl Add for Double {
    type Output = Self;

    #[inline(always)]
    fn add(self, b: Self) -> Self {
        self - Self {
            high: -b.high,
            low: -b.low,
        }
    }
}

/// Relative error at most 3u² + 13u³.
impl Sub for Double {
    type Output = Self;

    #[inline(always)]
    fn sub(self, b: Self) -> Self {
        let high = Self::sum(self.high, -b.high);
        let low = Self::sum(self.low, -b.low);
        let first = Self::ordered_sum(high.high, high.low + low.high);
        Self::ordered_sum(first.high, low.low + first.low)
    }
}

/// Relative error at most 7u².
impl Mul for &Double {
    type Output = Double;

    #[inline(always)]
    fn mul(self, b: Self) -> Double {
        let product = Double::product(self.high, b.high);
        let cross = self.high * b.low + self.low * b.high;
        Double::ordered_sum(product.high, product.low + cross)
    }
}

/// Relative error at most 32u².
///
/// With q = high/high rounded, the remainder r = self − q·b is computed from pieces of at most
/// 6u·|self| with four roundings, hence to 16u²·|self|; r/b.high errs by two more factors 1 + u and
/// the final sum by nothing.
impl Div for Double {
    type Output = Self;

    #[inline(always)]
    fn div(self, b: Self) -> Self {
        let quotient = self.high / b.high;
        let back = Self::product(quotient, b.high);
        let rest = (((self.high - back.high) - back.low) + self.low) - quotient * b.low;
        Self::ordered_sum(quotient, rest / b.high)
    }
}

#[cfg(test)]
mod tests {
    use super::interpolated;

    #[test]
    fn interpolation_rounds_once() {
        // The way back from 7.4 takes one digit more than a rounded product has.
        let (a, b, t) = (7.415_023_051_653_653_f64, -9.673_080_687_424_875, 0.581_322);
        let rounded = a + t * (b - a);
        let found = interpolated([a, b], t);
        assert!(rounded != found && (rounded - found).abs() < 1e-14);
        assert_eq!(interpolated([1.0, 3.0], 0.5), 2.0);
        assert_eq!(interpolated([0.1, 0.7], 0.0), 0.1);
        assert_eq!(interpolated([0.1, 0.7], 1.0), 0.7);
    }

    #[test]
    fn interpolation_overflows_nowhere() {
        let far = interpolated([-f64::MAX, f64::MAX], 0.25) / f64::MAX;
        assert!((far + 0.5).abs() < 1e-15);
        assert_eq!(interpolated([0.0, 1e-323], 0.5), 5e-324);
    }
}
