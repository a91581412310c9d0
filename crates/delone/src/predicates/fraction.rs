//! How far along a segment a point lies: a fraction that is rounded once, correctly.
//!
//! The fraction is taken along the longer side of the segment's bounding box, so it is that of the point of
//! the segment which lies straight above, below or beside. It is rounded to a multiple of 2⁻⁵², whose complement
//! is one too: weights of the two ends sum to 1 without rounding.
//!
//! Whether to round up or down is asked of [`orient2d`]: a point at height h beside the segment that rises to
//! 2⁵³ lies to its left, or not. *Cost*: about 60 ns.

use super::{Orientation, orient2d};
use crate::Point;

/// 2⁵²: the fractions are multiples of its inverse.
const STEPS: f64 = (1_u64 << 52) as f64;

/// Tells how far along `ab` a point lies that is near it: 0 at `a`, 1 at `b`, and never outside of these.
///
/// Laws, for all finite points: monotone along the longer axis of the segment; a multiple of 2⁻⁵², the nearest
/// one to the true fraction, and of two nearest ones the even one; 0 if `a` equals `b`.
///
/// ```
/// use delone::predicates::fraction_along;
/// let [a, b] = [(0.0, 0.0), (3.0, 1.0)].map(Into::into);
/// let t = fraction_along([a, b], (1.0, 1.0 / 3.0).into());
/// assert_eq!(t, (2_f64.powi(52) / 3.0).round() / 2_f64.powi(52));
/// assert_eq!(t + (1.0 - t), 1.0);
/// ```
pub fn fraction_along([a, b]: [Point; 2], p: Point) -> f64 {
    let half = |from: f64, to: f64| to * 0.5 - from * 0.5;
    let is_wide = half(a.x, b.x).abs() >= half(a.y, b.y).abs();
    let [a, b, p] = [a, b, p].map(|q| if is_wide { q.x } else { q.y });
    if a == b {
        return 0.0;
    }
    // Differences that overflow are halved; the others err by a part in 2⁵³ only, subnormal or not.
    let whole = b - a;
    let guess = match whole.is_finite() && (p - a).is_finite() {
        true => (p - a) / whole,
        false => half(a, p) / half(a, b),
    };
    let mut k = (guess.clamp(0.0, 1.0) * STEPS).round();
    while k < STEPS && goes_beyond([a, b], p, 2.0 * k + 1.0, k) {
        k += 1.0;
    }
    while k > 0.0 && !goes_beyond([a, b], p, 2.0 * k - 1.0, k - 1.0) {
        k -= 1.0;
    }
    k / STEPS
}

/// Tells whether the fraction at `p` is above `halves` / 2⁵³; if it is just that, whether `below`, the step below,
/// is odd.
fn goes_beyond([a, b]: [f64; 2], p: f64, halves: f64, below: f64) -> bool {
    let [a, end, at] = [
        Point::new(a, 0.0),
        Point::new(b, 2.0 * STEPS),
        Point::new(p, halves),
    ];
    // To the left of what rises to the right there is too little of p.
    match (orient2d(a, end, at), b > a.x) {
        (Orientation::Collinear, _) => below % 2.0 == 1.0,
        (side, true) => side == Orientation::Right,
        (side, false) => side == Orientation::Left,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn along(a: f64, b: f64, p: f64) -> f64 {
        let at = |c: f64| Point::new(1.0, c);
        fraction_along([at(a), at(b)], at(p))
    }

    #[test]
    fn fractions_are_the_nearest_multiples() {
        for (a, b, p) in [
            (0.0, 3.0, 1.0),
            (0.1, 0.7, 0.3),
            (5.0, -2.0, 1.0),
            (1e300, -1e300, 3e299),
        ] {
            let t = along(a, b, p);
            let k = t * STEPS;
            assert_eq!(k, k.round());
            // Exactly, in integers: |k (b − a) − 2⁵² (p − a)| is at most half of |b − a|.
            let [a, b, p] = [a, b, p].map(|c: f64| scaled(c));
            let k = num_bigint::BigInt::from(k as i64);
            let error = k * (&b - &a) - (&p - &a) * (1_i64 << 52);
            assert!(error.magnitude() * 2_u32 <= (b - a).into_parts().1);
        }
        fn scaled(c: f64) -> num_bigint::BigInt {
            super::super::dyadic::Dyadic::new(c).in_units_of(-1074)
        }
    }

    #[test]
    fn ends_and_beyond_are_the_ends() {
        assert_eq!([along(2.0, 4.0, 2.0), along(2.0, 4.0, 4.0)], [0.0, 1.0]);
        assert_eq!([along(2.0, 4.0, 1.0), along(2.0, 4.0, 9.0)], [0.0, 1.0]);
        assert_eq!(along(f64::MIN, f64::MAX, 0.0), 0.5);
        assert_eq!(along(0.0, 15e-324, 5e-324), along(0.0, 3.0, 1.0));
        assert_eq!(along(7.0, 7.0, 7.0), 0.0);
    }

    #[test]
    fn of_two_equal_axes_the_first_counts() {
        let [a, b] = [(1.0, 3.0), (5.0, -1.0)].map(Point::from);
        assert_eq!(fraction_along([a, b], Point::new(2.0, 1.0)), 0.25);
        assert_eq!(fraction_along([b, a], Point::new(2.0, 1.0)), 0.75);
    }

    #[test]
    fn of_two_nearest_the_even_one_counts() {
        let ulp = 1.0 / STEPS;
        let two = 1.0 + ulp;
        // p is half of the way along a segment of odd length in units of 2⁻⁵²: 2⁵¹ exactly.
        assert_eq!(along(1.0, two + 2.0 * ulp, 1.0), 0.0);
        assert_eq!(along(0.0, 2.0 * STEPS, 1.0), 0.0);
        assert_eq!(along(0.0, 2.0 * STEPS, 3.0), 2.0 * ulp);
        assert_eq!(along(2.0 * STEPS, 0.0, 2.0 * STEPS - 3.0), 2.0 * ulp);
    }
}
