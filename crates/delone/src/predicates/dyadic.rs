//! A finite `f64` taken apart: an integer times a power of two.

use num_bigint::BigInt;

/// The number `mantissa · 2^exponent`, the mantissa odd unless the number is zero.
pub(super) struct Dyadic {
    mantissa: i64,
    pub exponent: i32,
}

impl Dyadic {
    /// Takes a finite number apart.
    pub fn new(value: f64) -> Self {
        let bits = value.to_bits();
        let biased = (bits >> 52 & 0x7ff) as i32;
        let fraction = (bits & ((1 << 52) - 1)) as i64;
        let magnitude = fraction | i64::from(biased != 0) << 52;
        if magnitude == 0 {
            // No power of two is too coarse for zero.
            return Self {
                mantissa: 0,
                exponent: i32::MAX,
            };
        }
        let zeros = magnitude.trailing_zeros();
        let odd = magnitude >> zeros;
        Self {
            mantissa: if value < 0.0 { -odd } else { odd },
            exponent: biased.max(1) - 1075 + zeros.cast_signed(),
        }
    }

    /// Divides by 2^`unit`, which divides the number.
    pub fn in_units_of(&self, unit: i32) -> BigInt {
        if self.mantissa == 0 {
            return BigInt::ZERO;
        }
        BigInt::from(self.mantissa) << (self.exponent - unit)
    }

    /// As [`in_units_of`](Self::in_units_of), if 2^`unit` divides the number and the quotient is below
    /// 2¹²¹ in magnitude.
    #[inline]
    pub fn fixed(&self, unit: i32) -> Option<i128> {
        if self.mantissa == 0 {
            return Some(0);
        }
        let shift = self.exponent.checked_sub(unit)?;
        let free = 121 - 64 + self.mantissa.unsigned_abs().leading_zeros().cast_signed();
        (0..=free)
            .contains(&shift)
            .then(|| i128::from(self.mantissa) << shift)
    }
}
