//! Coordinates of clouds and grids without a second rounding.
//!
//! A file holds integers, and for each axis a scale and an offset. `integer as f64 * scale + offset` rounds up to three times: 0.01 is no double, nor is the product, nor the sum.
//! Here scale and offset stand for the shortest decimals that name them, so that every coordinate is an integer
//! times a power of ten, exact in 128 bits, and is rounded once:
//!
//! - up to 2⁵³ over 10⁰ … 10²², or times it, both sides are doubles, and IEEE division or multiplication rounds
//!   right (W. Clinger, *How to read floating point numbers accurately*, 1990);
//! - up to 2⁶³ over 10¹⁸ the quotient is taken to more than 64 bits, and what is left over counts as one more;
//! - all else goes through text, whose reading rounds right.

/// Doubles that are powers of ten.
const POWERS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16,
    1e17, 1e18, 1e19, 1e20, 1e21, 1e22,
];

/// Integers up to this are doubles.
const EXACT: u64 = 1 << 53;

/// Largest power of ten below that quotients of 64 bits by it are taken in 128.
const MAX_DIVISOR: usize = 18;

/// Turns the integers of one axis into coordinates.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Axis {
    /// A coordinate is (integer · `factor` + `shift`) · 10^`power`.
    factor: i128,
    shift: i128,
    power: i32,
    /// Whether all coordinates come of integers of 64 bits.
    is_narrow: bool,
}

impl Axis {
    /// Takes scale and offset of an axis.
    ///
    /// # Errors
    /// Why they are not those of a survey.
    pub fn new(scale: f64, offset: f64) -> Result<Self, &'static str> {
        if !scale.is_finite() || !offset.is_finite() {
            return Err("must be finite");
        }
        if scale == 0.0 {
            return Err("the scale must not be 0");
        }
        let apart = "scale and offset are too far apart";
        let ((factor, power_of_scale), (shift, power_of_offset)) =
            (shortest(scale), shortest(offset));
        let power = match shift {
            0 => power_of_scale,
            _ => power_of_scale.min(power_of_offset),
        };
        let factor = raised(factor, power_of_scale - power).ok_or(apart)?;
        let shift = match shift {
            0 => 0,
            _ => raised(shift, power_of_offset - power).ok_or(apart)?,
        };
        let largest = factor
            .checked_mul(1 << 31)
            .and_then(|product| product.abs().checked_add(shift.abs()))
            .ok_or(apart)?;
        let axis = Self {
            factor,
            shift,
            power,
            is_narrow: i64::try_from(largest).is_ok(),
        };
        match rounded(largest, power).is_finite() {
            true => Ok(axis),
            false => Err("coordinates would be beyond all doubles"),
        }
    }

    /// Returns the double nearest to the coordinate; equal integers have equal ones.
    pub fn coordinate(&self, integer: i32) -> f64 {
        if self.is_narrow {
            let sum = i64::from(integer) * self.factor as i64 + self.shift as i64;
            if sum.unsigned_abs() <= EXACT && self.power.unsigned_abs() < POWERS.len() as u32 {
                let power = POWERS[self.power.unsigned_abs() as usize];
                return match self.power < 0 {
                    true => sum as f64 / power,
                    false => sum as f64 * power,
                };
            }
        }
        rounded(i128::from(integer) * self.factor + self.shift, self.power)
    }
}

/// Returns the double nearest to `number` · 10^`power`.
fn rounded(number: i128, power: i32) -> f64 {
    let magnitude = u64::try_from(number.unsigned_abs());
    match (magnitude, usize::try_from(-power)) {
        (Ok(magnitude @ EXACT..), Ok(places @ 0..=MAX_DIVISOR)) => {
            let divisor = 10u128.pow(places as u32);
            // At least 2¹¹⁶ over less than 2⁶⁰.
            let up = 63;
            let dividend = u128::from(magnitude) << up;
            let sticky = u128::from(!dividend.is_multiple_of(divisor));
            let quotient = ((dividend / divisor) | sticky) as f64 / (1u64 << up) as f64;
            if number < 0 { -quotient } else { quotient }
        }
        _ => {
            let text = format!("{number}e{power}");
            text.parse().expect("bug: an integer and a power of ten")
        }
    }
}

/// Returns the shortest decimal that names a number, as an integer and a power of ten.
fn shortest(number: f64) -> (i128, i32) {
    let mut buffer = ryu::Buffer::new();
    let text = buffer.format_finite(number);
    let (digits, power) = text.split_once('e').unwrap_or((text, "0"));
    let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
    let fraction = fraction.trim_end_matches('0');
    let power: i32 = power.parse().expect("bug: a small integer");
    let number = format!("{whole}{fraction}");
    let mut number: i128 = number.parse().expect("bug: at most 17 digits");
    let mut power = power - fraction.len() as i32;
    while number != 0 && number % 10 == 0 {
        number /= 10;
        power += 1;
    }
    (number, power)
}

/// Multiplies by a power of ten, if 128 bits hold the product.
fn raised(number: i128, power: i32) -> Option<i128> {
    let power = u32::try_from(power).ok()?;
    10i128.checked_pow(power)?.checked_mul(number)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::cmp::Ordering;

    /// A natural number of any size, in base 10⁹, the lowest digit first.
    #[derive(Clone, Debug, PartialEq, Eq)]
    struct Natural(Vec<u32>);

    impl Natural {
        const BASE: u64 = 1_000_000_000;

        fn new(mut value: u128) -> Self {
            let mut digits = Vec::new();
            while value > 0 {
                digits.push((value % u128::from(Self::BASE)) as u32);
                value /= u128::from(Self::BASE);
            }
            Self(digits)
        }

        fn times(mut self, factor: u32, count: u32) -> Self {
            for _ in 0..count {
                let mut carry = 0;
                for digit in &mut self.0 {
                    let product = u64::from(*digit) * u64::from(factor) + carry;
                    *digit = (product % Self::BASE) as u32;
                    carry = product / Self::BASE;
                }
                if carry > 0 {
                    self.0.push(carry as u32);
                }
            }
            self
        }

        fn cmp(&self, other: &Self) -> Ordering {
            let by_len = self.0.len().cmp(&other.0.len());
            by_len.then_with(|| self.0.iter().rev().cmp(other.0.iter().rev()))
        }
    }

    /// Compares `number` · 10^`power` with `mantissa` · 2^`exponent`, both as ratios of integers.
    fn compare(number: u128, power: i32, mantissa: u128, exponent: i32) -> Ordering {
        let up = |value: i32| value.max(0).unsigned_abs();
        let left = Natural::new(number)
            .times(10, up(power))
            .times(2, up(-exponent));
        let right = Natural::new(mantissa)
            .times(10, up(-power))
            .times(2, up(exponent));
        left.cmp(&right)
    }

    /// Requires a positive double to be the one nearest to a decimal, even in ties.
    fn assert_nearest(number: u128, power: i32, double: f64) {
        let bits = double.to_bits();
        let (raw, exponent) = (u128::from(bits & ((1 << 52) - 1)), (bits >> 52) as i32);
        let (mantissa, exponent) = match exponent {
            0 => (raw, -1074),
            _ => (raw | 1 << 52, exponent - 1075),
        };
        // Below a power of two the neighbour is nearer still; this much holds there, too.
        let above = compare(number, power, 2 * mantissa + 1, exponent - 1);
        let below = compare(
            number,
            power,
            (2 * mantissa).saturating_sub(1),
            exponent - 1,
        );
        let is_even = mantissa % 2 == 0;
        assert!(
            (above == Ordering::Less || is_even && above == Ordering::Equal)
                && (below == Ordering::Greater || is_even && below == Ordering::Equal),
            "{number}e{power} as {double:e}: {below:?} {above:?}"
        );
    }

    #[test]
    fn shortest_decimals_are_taken_apart() {
        for (number, expected) in [
            (0.01, (1, -2)),
            (500_000.0, (5, 5)),
            (-4e-7, (-4, -7)),
            (637_012.24, (63_701_224, -2)),
            (1e22, (1, 22)),
            (0.0, (0, 0)),
            (123.0, (123, 0)),
            (1.5e300, (15, 299)),
            (5e-324, (5, -324)),
        ] {
            assert_eq!(shortest(number), expected, "{number}");
        }
    }

    #[test]
    fn coordinates_are_what_the_decimals_say() {
        let axis = Axis::new(0.01, 500_000.0).unwrap();
        assert_eq!(axis.coordinate(3), 500_000.03);
        assert_eq!(axis.coordinate(-7), 499_999.93);
        // The product of doubles is another one.
        assert_eq!(Axis::new(0.01, 0.0).unwrap().coordinate(35), 0.35);
        assert_ne!(35.0 * 0.01, 0.35);
        let axis = Axis::new(1e-7, 9.0).unwrap();
        assert_eq!(axis.coordinate(i32::MAX), 223.748_364_7);
        let axis = Axis::new(0.001, 340_280.123_456_789).unwrap();
        assert_eq!(axis.coordinate(1), 340_280.124_456_789);
        assert_eq!(Axis::new(100.0, 0.0).unwrap().coordinate(-5), -500.0);
        assert_eq!(Axis::new(-0.5, 0.25).unwrap().coordinate(1), -0.25);
    }

    #[test]
    fn ties_go_to_the_even_neighbour() {
        let tie = 1i128 << 53;
        assert_eq!(rounded(tie + 1, 0), tie as f64);
        assert_eq!(rounded(-tie - 3, 0), -(tie + 4) as f64);
        assert_eq!(rounded(45_035_996_273_704_965, -1), 4_503_599_627_370_496.0);
        assert_eq!(rounded(45_035_996_273_704_975, -1), 4_503_599_627_370_498.0);
    }

    #[test]
    fn absurd_headers_are_refused() {
        for (scale, offset) in [
            (0.0, 1.0),
            (f64::NAN, 0.0),
            (1.0, f64::INFINITY),
            (1e-300, 1e300),
            (0.01, 5e-324),
            (1e305, 0.0),
        ] {
            assert!(Axis::new(scale, offset).is_err(), "{scale} {offset}");
        }
    }

    proptest! {
        #[test]
        fn every_coordinate_is_rounded_once(
            digits in 1u64..100_000_000_000_000_000,
            scale_power in -30i32..4,
            offset_digits in -100_000_000_000_000_000i64..100_000_000_000_000_000,
            offset_power in -20i32..6,
            keep in 0u32..17,
            integers in prop::collection::vec(any::<i32>(), 1..20),
        ) {
            // Few digits are what headers have; many are what the slower ways are for.
            let digits = digits / 10u64.pow(keep);
            let scale: f64 = format!("{}e{scale_power}", digits.max(1)).parse().unwrap();
            let offset: f64 = format!("{offset_digits}e{offset_power}").parse().unwrap();
            let Ok(axis) = Axis::new(scale, offset) else {
                return Ok(());
            };
            for integer in integers {
                let sum = i128::from(integer) * axis.factor + axis.shift;
                let double = axis.coordinate(integer);
                prop_assert_eq!(double < 0.0, sum < 0);
                assert_nearest(sum.unsigned_abs(), axis.power, double.abs());
            }
        }

        #[test]
        fn every_way_of_rounding_is_right(number in any::<i64>(), bits in 0u32..63, places in 0i32..25) {
            let number = number >> bits;
            let double = rounded(number.into(), -places);
            assert_nearest(number.unsigned_abs().into(), -places, double.abs());
            let wide = i128::from(number) * 1_000_003_000_007;
            assert_nearest(wide.unsigned_abs(), -places, rounded(wide, -places).abs());
        }
    }
}
