//! The order in which circles end: that of their lowest points, as a sweep line meets them that comes from
//! above.
//!
//! The lowest point of the circle through a, b, c has the ordinate a.y + N/D − R, where N/D is the vertical
//! way to the center (see [centers](super::center)) and R the radius (see [radii](super::radius)). Stage 1
//! computes that once for each circle in [`Double`]s and keeps it with a bound of its error. Big integers
//! compare what is closer than that: with a common denominator, the difference of two circles is
//! A + √B − √C, whose sign takes two squarings (`exact.rs`).
//!
//! *Cost*: 100 ns for a circle, then 1 ns a comparison in stage 1; 5 µs and more in big integers, which ties
//! need.

use super::crossing::{power_of_two, vector};
use super::double::Double;
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
    known: Option<Known>,
}

/// A number that is known but for a `bound`.
#[derive(Clone, Copy, Debug)]
struct Known {
    value: Double,
    bound: f64,
}

impl Bottom {
    /// Looks where it lies.
    pub fn new(corners: [Point; 3]) -> Self {
        let known = filtered(corners);
        Self { corners, known }
    }

    /// Compares the ordinates of two of them.
    pub fn compare(&self, other: &Self) -> Ordering {
        self.compare_staged(other).0
    }

    pub(super) fn compare_staged(&self, other: &Self) -> (Ordering, Stage) {
        let both = self.known.zip(other.known);
        let filtered = both.and_then(|(a, b)| certain(a.value - b.value, a.bound + b.bound));
        staged(filtered, || {
            exact::compare_bottoms(self.corners, other.corners)
        })
    }

    /// Compares its ordinate with that of a point.
    pub fn compare_to(&self, p: Point) -> Ordering {
        self.compare_to_staged(p).0
    }

    pub(super) fn compare_to_staged(&self, p: Point) -> (Ordering, Stage) {
        let filtered = self.known.and_then(|a| certain(a.value + -p.y, a.bound));
        staged(filtered, || exact::compare_bottom(self.corners, p))
    }

    /// Returns its ordinate, rounded, if it is known.
    pub fn rounded(&self) -> Option<f64> {
        self.known.map(|known| known.value.high)
    }
}

fn staged(filtered: Option<Ordering>, exact: impl FnOnce() -> Ordering) -> (Ordering, Stage) {
    match filtered {
        Some(order) => (order, Stage::Filter),
        None => (exact(), Stage::BigInteger),
    }
}

/// Finds the sign of a difference whose terms are known but for `bound` together. The difference itself has
/// an error of 3u² of its magnitude, for which there is room in 2⁻²⁰ of the bound. What is known is below
/// 2⁶¹⁰, so that no sum overflows.
fn certain(difference: Double, bound: f64) -> Option<Ordering> {
    const MARGIN: f64 = 1.0 + power_of_two(-20);
    let is_certain = difference.high.abs() > bound * MARGIN;
    is_certain.then(|| difference.high.partial_cmp(&0.0))?
}

/// Stage 1: the ordinate, and how far off it may be. With [tame](is_tame) coordinates nothing over- or
/// underflows: N is a multiple of 2⁻⁴⁵⁶ below 2³⁰⁶, D, unless zero, of magnitude 2⁻³⁰³ … 2²⁰⁴.
fn filtered([a, b, c]: [Point; 3]) -> Option<Known> {
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
    Some(Known {
        value: center - radius,
        bound: BOUND * (reach + center.high.abs() + ratio * radius.high),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn circles_that_are_nearly_lines_are_not_known() {
        let through = |y: f64| Bottom::new([(0.0, 0.0), (1.0, 1.0), (2.0, y)].map(Point::from));
        assert!(through(2.5).rounded().is_some());
        assert!(through(2.0 + 2_f64.powi(-30)).rounded().is_some());
        assert_eq!(through(2.0 + 2_f64.powi(-45)).rounded(), None);
    }
}
