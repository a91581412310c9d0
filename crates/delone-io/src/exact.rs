//! Integers as doubles: only those that lose nothing.

use crate::Problem;

/// Converts an integer to the double of the same value, if there is one.
///
/// Every integer up to 2⁵³ has one, beyond it only multiples of ever larger powers of two.
pub(crate) fn to_double(value: i128) -> Option<f64> {
    let double = value as f64;
    (double as i128 == value).then_some(double)
}

/// Makes the problem of an integer without a double.
pub(crate) fn inexact(row: usize, value: i128) -> Problem {
    Problem::Other(format!(
        "row {row}: {value} cannot be held exactly by a double; subtract an offset, or save as float64"
    ))
}

#[cfg(test)]
mod tests {
    use super::to_double;

    #[test]
    fn only_integers_of_53_bits_are_exact() {
        let limit = 1i128 << 53;
        assert_eq!(to_double(limit), Some(2f64.powi(53)));
        assert_eq!(to_double(-limit), Some(-(2f64.powi(53))));
        assert_eq!(to_double(limit + 1), None);
        assert_eq!(to_double(-limit - 1), None);
        assert_eq!(to_double(limit + 2), Some(2f64.powi(53) + 2.0));
        assert_eq!(to_double(i64::MAX.into()), None);
        assert_eq!(to_double(i64::MIN.into()), Some(-(2f64.powi(63))));
        assert_eq!(to_double(u64::MAX.into()), None);
    }
}
