//! Where two segments cross: each coordinate correctly rounded, to nearest, ties to even.
//!
//! The point where a + t(b − a) meets the line through c and d has t = N/D with the cross products
//! N = (c − a) × (d − c) and D = (b − a) × (d − c). Stage 1 computes this in [`Double`]s with an
//! error bound E. Rounding is monotone: if x − E and x + E round to the same `f64`, so does the exact
//! coordinate. Where they do not (near a tie, near zero, or because the segments are almost parallel)
//! big integers decide (`exact.rs`).
//!
//! *Cost*: 60 ns in stage 1, about 2 µs in big integers.

use super::double::Double;
use super::exact;
use super::polynomial::cross;
use super::stage::Stage;
use crate::Point;

/// Bounds the error of a computed coordinate a + t·w, relative to
/// |w|·(|N|₊ + |D|₊)/|D| + |a + t·w|, where |·|₊ is the sum of the two products' magnitudes.
///
/// N and D err by at most 10u² of |·|₊ each: seven from the products, three from the difference.
/// That D is known within a quarter is checked, so t = N/D errs by at most
/// (4/3)·10u²·(|N|₊ + t|D|₊)/|D| and, since 0 < t < 1 and |D| ≤ |D|₊, by 32u²·|D|₊/|D| in its own
/// division. The product with w adds 7u²·|w|, the sum 2u² of the result. All this is below 55u²;
/// 128u² = 2⁻⁹⁹ leaves room for the roundings of the bound itself and of `low ± bound`.
const BOUND: f64 = power_of_two(-99);

/// What underflow may add to the error of an [ordinary](is_ordinary) coordinate. Differences are
/// multiples of 2⁻²⁵², so N and D of 2⁻⁵⁰⁴: they are exact to their last place, and what t and t·w
/// lose below 2⁻¹⁰⁷⁴ is, times |w| ≤ 2²⁵¹, less than 2⁻⁸⁰⁰.
const FLOOR: f64 = power_of_two(-700);

pub(super) const fn power_of_two(e: i32) -> f64 {
    f64::from_bits(((1023 + e) as u64) << 52)
}

/// Returns the point where the segments `ab` and `cd`, which cross properly, meet, and which stage
/// decided its last coordinate.
pub(super) fn crossing([a, b]: [Point; 2], [c, d]: [Point; 2]) -> (Point, Stage) {
    let shared = [
        shared([a.x, b.x], [c.x, d.x]),
        shared([a.y, b.y], [c.y, d.y]),
    ];
    let filtered = match shared {
        [Some(_), Some(_)] => [None; 2],
        _ => filtered([a, b], [c, d]),
    };
    // Adding zero turns −0.0 into 0.0.
    if let [Some(x), Some(y)] = [0, 1].map(|k| shared[k].or(filtered[k])) {
        return (Point::new(x + 0.0, y + 0.0), Stage::Filter);
    }
    (exact::crossing([a, b], [c, d]), Stage::BigInteger)
}

/// Returns the coordinate of a segment that is perpendicular to the axis.
fn shared([a, b]: [f64; 2], [c, d]: [f64; 2]) -> Option<f64> {
    if a == b {
        Some(a)
    } else if c == d {
        Some(c)
    } else {
        None
    }
}

/// Stage 1: the coordinates of which the rounding is certain.
fn filtered([a, b]: [Point; 2], [c, d]: [Point; 2]) -> [Option<f64>; 2] {
    if ![a, b, c, d]
        .iter()
        .all(|p| is_ordinary(p.x) && is_ordinary(p.y))
    {
        return [None; 2];
    }
    let [along, other, between] = [vector(a, b), vector(c, d), vector(a, c)];
    let (numerator, denominator) = (cross(&between, &other), cross(&along, &other));
    let size = cross_size(&between, &other) + cross_size(&along, &other);
    let ratio = size / denominator.high.abs();
    // Far less than the 2¹⁰⁰ at which the denominator would not be known within a quarter.
    if ratio >= power_of_two(50) {
        return [None; 2];
    }
    let t = numerator / denominator;
    let place = |origin: f64, along: Double| {
        certain(&t * &along + origin, |x| {
            BOUND * (along.high.abs() * ratio + x) + FLOOR
        })
    };
    [place(a.x, along[0]), place(a.y, along[1])]
}

/// Whether no step of stage 1 can overflow, and none but the last ones underflow.
pub(super) fn is_ordinary(c: f64) -> bool {
    c == 0.0 || (power_of_two(-200)..=power_of_two(250)).contains(&c.abs())
}

/// The exact vector from `a` to `b`.
pub(super) fn vector(a: Point, b: Point) -> [Double; 2] {
    [Double::sum(b.x, -a.x), Double::sum(b.y, -a.y)]
}

/// The sum of the magnitudes of the two products in a cross product.
fn cross_size([ax, ay]: &[Double; 2], [bx, by]: &[Double; 2]) -> f64 {
    (ax.high * by.high).abs() + (ay.high * bx.high).abs()
}

/// Rounds a number that is known up to `bound` of its magnitude, if all candidates round alike.
pub(super) fn certain(value: Double, bound: impl Fn(f64) -> f64) -> Option<f64> {
    let bound = bound(value.high.abs());
    let [least, largest] = [value.low - bound, value.low + bound].map(|low| value.high + low);
    (least == largest).then_some(least)
}
