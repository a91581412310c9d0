//! Rounds a fraction of big integers to the nearest `f64`, ties to even, subnormals included; and roots
//! upwards.

use num_bigint::{BigInt, BigUint, Sign};

/// The exponent of the least subnormal number.
const LEAST: i32 = -1074;

/// Bits of a quotient: two or three more than a mantissa has, the remainder on top.
const BITS: i64 = 55;

/// Returns `numerator / denominator · 2^unit`, correctly rounded; the magnitude must not exceed that
/// of the largest `f64`, and the denominator must not be zero.
pub(super) fn rounded(numerator: &BigInt, denominator: &BigInt, unit: i32) -> f64 {
    if numerator.sign() == Sign::NoSign {
        return 0.0;
    }
    let (n, d) = (numerator.magnitude(), denominator.magnitude());
    // The quotient gets 55 or 56 bits.
    let shift = BITS - (n.bits() as i64 - d.bits() as i64);
    let (quotient, is_exact) = divided(n, d, shift);
    let quotient = u64::try_from(quotient).expect("bug: a quotient of more than 64 bits");
    let magnitude = nearest(quotient, is_exact, unit - shift as i32);
    let is_negative = (numerator.sign() == Sign::Minus) != (denominator.sign() == Sign::Minus);
    if is_negative && magnitude != 0.0 {
        -magnitude
    } else {
        magnitude
    }
}

/// As [`rounded`], for any magnitude: what exceeds that of the largest `f64` becomes that.
pub(super) fn saturated(numerator: &BigInt, denominator: &BigInt, unit: i32) -> f64 {
    /// Far from both ends of the range of numbers.
    const REDUCTION: i32 = 100;
    let excess = numerator.bits() as i64 - denominator.bits() as i64 + i64::from(unit);
    match excess {
        ..1000 => rounded(numerator, denominator, unit),
        // Scaled down, so that the quotient fits; scaling it back is exact, or overflows.
        1000..1050 => {
            let reduced = rounded(numerator, denominator, unit - REDUCTION);
            let restored = reduced * f64::from_bits(((1023 + REDUCTION) as u64) << 52);
            restored.clamp(-f64::MAX, f64::MAX)
        }
        _ if numerator.sign() == denominator.sign() => f64::MAX,
        _ => -f64::MAX,
    }
}

/// Returns the integer part of `n / d · 2^shift`, and whether that is all.
fn divided(n: &BigUint, d: &BigUint, shift: i64) -> (BigUint, bool) {
    let (n, d) = if shift >= 0 {
        (n << shift, d.clone())
    } else {
        (n.clone(), d << -shift)
    };
    let quotient = &n / &d;
    let is_exact = &quotient * &d == n;
    (quotient, is_exact)
}

/// Rounds `quotient · 2^exponent`, to which something less than one unit is to be added unless it
/// `is_exact`.
fn nearest(quotient: u64, is_exact: bool, exponent: i32) -> f64 {
    let length = (u64::BITS - quotient.leading_zeros()).cast_signed();
    // Fewer bits are kept where the least subnormal is larger than the last of 53.
    let last = (exponent + length - 53).max(LEAST);
    let drop = last - exponent;
    if drop > length + 1 {
        return 0.0;
    }
    // A quotient has at least 55 bits, so at least two are dropped.
    let kept = quotient >> drop;
    let dropped = quotient - (kept << drop);
    let half = 1_u64 << (drop - 1);
    let is_up = dropped > half || (dropped == half && (!is_exact || kept % 2 == 1));
    from_parts(kept + u64::from(is_up), last)
}

/// A square root of which the leading bits are known: `digits · 2^exponent`, to which something less
/// than one unit is to be added unless it `is_exact`. Zero, or at least 54 bits long.
#[derive(Clone, Copy, Debug)]
pub(super) struct Root {
    pub digits: u64,
    pub is_exact: bool,
    pub exponent: i32,
}

impl Root {
    /// Divides by two.
    pub fn half(self) -> Self {
        Self {
            exponent: self.exponent - 1,
            ..self
        }
    }

    /// Takes the root of `square · 2^exponent`, to the square of which something less than one unit is to
    /// be added unless it `is_exact`; the exponent is even. `None` if it has too few bits.
    pub fn of(square: u128, is_exact: bool, exponent: i32) -> Option<Self> {
        /// Roots of 54 bits and more.
        const LEAST: u128 = 1 << 106;
        debug_assert!(exponent % 2 == 0);
        if square < LEAST && !(square == 0 && is_exact) {
            return None;
        }
        let root = square.isqrt();
        Some(Self {
            digits: root as u64,
            is_exact: is_exact && root * root == square,
            exponent: exponent / 2,
        })
    }
}

/// Returns `√(numerator / denominator) · 2^unit`; neither number is negative, the denominator not zero.
pub(super) fn root_of_quotient(numerator: &BigInt, denominator: &BigInt, unit: i32) -> Root {
    let (n, d) = (numerator.magnitude(), denominator.magnitude());
    // The quotient gets 111 to 113 bits, its root 56 or 57; the shift is even.
    let shift = (112 - (n.bits() as i64 - d.bits() as i64)) & !1;
    let (quotient, is_exact) = divided(n, d, shift);
    let square = u128::try_from(quotient).expect("bug: a quotient of more than 128 bits");
    let root = Root::of(square, is_exact, -(shift as i32)).expect("bug: a quotient too short");
    Root {
        exponent: root.exponent + unit,
        ..root
    }
}

/// Returns the smallest `f64` that is not less than the root, infinity if need be.
pub(super) fn upward(root: Root) -> f64 {
    let Root {
        digits,
        is_exact,
        exponent,
    } = root;
    if digits == 0 {
        return 0.0;
    }
    let length = (u64::BITS - digits.leading_zeros()).cast_signed();
    let last = (exponent + length - 53).max(LEAST);
    let drop = last - exponent;
    let kept = digits.checked_shr(drop.cast_unsigned()).unwrap_or(0);
    let is_whole = is_exact && digits.trailing_zeros().cast_signed() >= drop;
    let kept = kept + u64::from(!is_whole);
    if last + (u64::BITS - kept.leading_zeros()).cast_signed() > 1024 {
        return f64::INFINITY;
    }
    from_parts(kept, last)
}

/// Returns `mantissa · 2^exponent`, which is an `f64`: at most 2⁵³ units in the last place, one of
/// which is 2^`exponent`.
fn from_parts(mantissa: u64, exponent: i32) -> f64 {
    // The leading bit of a normal number's mantissa is not stored: it raises the exponent by one,
    // and so does the carry of 2⁵³.
    f64::from_bits((u64::from((exponent - LEAST).cast_unsigned()) << 52) + mantissa)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_have_54_bits_or_are_declined() {
        let least = Root::of(1 << 106, true, 0).expect("54 bits");
        assert_eq!((least.digits, least.is_exact), (1 << 53, true));
        assert!(Root::of((1 << 106) - 1, true, 0).is_none());
        assert!(Root::of(0, true, 0).is_some_and(|root| root.digits == 0));
        assert!(Root::of(0, false, 0).is_none());
    }
}
