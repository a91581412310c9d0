//! The order in which circles end: that of their lowest points, as a sweep line meets them that comes from
//! above.
//!
//! The lowest point of the circle through a, b, c has the ordinate a.y + N/D − R, where N/D is the vertical
//! way to the center (see [centers](super::center)) and R the radius (see [radii](super::radius)). Stage 1
//! computes that once for each circle in [`Double`](super::Double)s and keeps two `f64` between which it lies; two circles
//! whose intervals overlap are compared by big integers: with a common denominator their difference is
//! A + √B − √C, whose sign takes two squarings (`exact.rs`).
//!
//! *Cost*: 100 ns for a circle, then 1 ns a comparison in stage 1; 5 µs and more in big integers, which ties
//! need.

use super::crossing::{power_of_two, vector};
use super::exact;
use super::polynomial::{cross, dot};
use super::radius::is_tame;
use super::stage::Stage;
use crate::Point;
use std::cmp::Ordering;

/// Bounds the error of the ordinate, relative to (|N|₊/|D|)·q + |cy| + q·R, where cy is the ordinate of the
/// center, |·|₊ the sum of the two terms' magnitudes and q = |D|₊/|D| ≥ 1.
///
/// The center errs by at most 70u²·((|N|₊/|D|)·q + |cy|), the radius by 68u²·q·R (see there), their
/// difference by 3u²·(|cy| + R). All this is below 74u²; 256u² = 2⁻⁹⁸ leaves room for terms of order q²u⁴,
/// since q < 2⁴⁰, and for the roundings of the bound itself.
const BOUND: f64 = power_of_two(-98);

/// The lowest point of the circle through three points that are not collinear.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bottom {
    corners: [Point; 3],
    /// Its ordinate is not less, and not more.
    within: [f64; 2],
}

impl Bottom {
    /// Looks where it lies.
    pub fn new(corners: [Point; 3]) -> Self {
        let within = filtered(corners).unwrap_or([f64::NEG_INFINITY, f64::INFINITY]);
        Self { corners, within }
    }

    /// Compares the ordinates of two of them.
    pub fn compare(&self, other: &Self) -> Ordering {
        self.compare_staged(other).0
    }

    pub(super) fn compare_staged(&self, other: &Self) -> (Ordering, Stage) {
        match apart(self.within, other.within) {
            Some(order) => (order, Stage::Filter),
            None => {
                let order = exact::compare_bottoms(self.corners, other.corners);
                (order, Stage::BigInteger)
            }
        }
    }

    /// Compares its ordinate with that of a point.
    pub fn compare_to(&self, p: Point) -> Ordering {
        self.compare_to_staged(p).0
    }

    pub(super) fn compare_to_staged(&self, p: Point) -> (Ordering, Stage) {
        match apart(self.within, [p.y; 2]) {
            Some(order) => (order, Stage::Filter),
            None => (exact::compare_bottom(self.corners, p), Stage::BigInteger),
        }
    }

    /// Returns its ordinate, if that is known but for a few roundings.
    pub fn rounded(&self) -> Option<f64> {
        let [low, high] = self.within;
        let middle = low / 2.0 + high / 2.0;
        middle.is_finite().then_some(middle)
    }
}

/// Compares two numbers that lie in closed intervals, if these do not meet.
fn apart([a_low, a_high]: [f64; 2], [b_low, b_high]: [f64; 2]) -> Option<Ordering> {
    if a_high < b_low {
        Some(Ordering::Less)
    } else if a_low > b_high {
        Some(Ordering::Greater)
    } else {
        None
    }
}

/// Stage 1: an interval that holds the ordinate. With [tame](is_tame) coordinates nothing over- or
/// underflows: N is a multiple of 2⁻⁴⁵⁶ below 2³⁰⁶, D, unless zero, of magnitude 2⁻³⁰³ … 2²⁰⁴.
fn filtered([a, b, c]: [Point; 3]) -> Option<[f64; 2]> {
    if !is_tame(&[a, b, c]) {
        return None;
    }
    let [u, v, w] = [vector(a, b), vector(a, c), vector(b, c)];
    let area = cross(&u, &v);
    let size = (u[0].high * v[1].high).abs() + (u[1].high * v[0].high).abs();
    let ratio = size / area.high.abs();
    if ratio.is_nan() || ratio >= power_of_two(40) {
        return None;
    }
    let [uu, vv, ww] = [&u, &v, &w].map(|side| dot(side, side));
    let doubled = area + area;
    let lift = (&u[0] * &vv - &v[0] * &uu) / doubled;
    let lift_size = (u[0].high * vv.high).abs() + (v[0].high * uu.high).abs();
    let reach = lift_size / doubled.high.abs() * ratio;
    let center = lift + a.y;
    let square = &(&uu * &vv) * &ww;
    let radius = (square / (&doubled * &doubled)).sqrt();
    let bottom = center - radius;
    let bound = BOUND * (reach + center.high.abs() + ratio * radius.high);
    let [low, high] = [bottom.low - bound, bottom.low + bound].map(|low| bottom.high + low);
    Some([low.next_down(), high.next_up()])
}
