//! Rounds a fraction of big integers to the nearest `f64`, ties to even, subnormals included.

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

/// Returns the integer part of `n / d · 2^shift`, which fits 64 bits, and whether that is all.
fn divided(n: &BigUint, d: &BigUint, shift: i64) -> (u64, bool) {
    let (n, d) = if shift >= 0 {
        (n << shift, d.clone())
    } else {
        (n.clone(), d << -shift)
    };
    let quotient = &n / &d;
    let is_exact = &quotient * &d == n;
    let digits = u64::try_from(quotient).expect("bug: a quotient of more than 64 bits");
    (digits, is_exact)
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

/// Returns `mantissa · 2^exponent`, which is an `f64`: at most 2⁵³ units in the last place, one of
/// which is 2^`exponent`.
fn from_parts(mantissa: u64, exponent: i32) -> f64 {
    // The leading bit of a normal number's mantissa is not stored: it raises the exponent by one,
    // and so does the carry of 2⁵³.
    f64::from_bits((u64::from((exponent - LEAST).cast_unsigned()) << 52) + mantissa)
}
