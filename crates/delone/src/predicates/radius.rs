//! Lengths and circumradii, rounded up: the smallest `f64` that is not less.
//!
//! For a radius r that is an `f64` itself, the true value is at most r if and only if the value rounded
//! up is: so one number per edge or triangle decides all questions of that kind exactly, and the rest is
//! plain comparison. The circumradius is R = |ab|·|bc|·|ca| / (2·|cross|) with the cross product of two
//! sides.
//!
//! Stage 1 computes in [`Double`]s with an error bound and decides where all candidates round up alike;
//! stage 2 takes the root of a 128-bit integer; big integers do the rest (`exact.rs`). Values that are
//! numbers of few digits, as on a lattice, are certain in stage 2 only.
//!
//! *Cost*: about 30 ns for a length and 60 ns for a circumradius in stage 1, about twice that in stage
//! 2, 1 µs and more in big integers.

use super::crossing::power_of_two;
use super::double::Double;
use super::polynomial::{cross, dot};
use super::quotient::{Root, upward};
use super::stage::Stage;
use super::{exact, integer};
use crate::Point;

/// Bounds the relative error of a length: 10u² from the squared length (7 for its products, 3 for their
/// sum), half of which passes the root, which adds 16u² itself (see [`Double::sqrt`]). Twice that.
const LENGTH_BOUND: f64 = power_of_two(-100);

/// Bounds the error of a circumradius, relative to R·|·|₊/|cross|, where |·|₊ is the sum of the
/// magnitudes of the two products in the cross product.
///
/// A squared side errs by 10u², their product by 44u² therefore; the cross product by 10u²·|·|₊, its
/// square, divided by itself, by (20 + 7)u² times the quotient q = |·|₊/|cross| ≥ 1; the division
/// adds 32u². Half of these 103u²·q pass the root, which adds 16u²: 68u²·q. Terms of order q²u⁴ and the
/// roundings of the bound find room in twice that, since q < 2⁴⁰.
const RADIUS_BOUND: f64 = power_of_two(-98);

/// Returns the length of a segment, rounded up, and which stage found it.
pub(super) fn length([a, b]: [Point; 2]) -> (f64, Stage) {
    staged(
        filtered_length([a, b]),
        || integer::length([a, b]).map(Some),
        || Some(exact::length([a, b])),
    )
}

/// Returns half the length of a segment, rounded up, and which stage found it.
pub(super) fn half_length(ends: [Point; 2]) -> (f64, Stage) {
    staged(
        // No subnormal number is tame.
        filtered_length(ends).map(|length| length / 2.0),
        || integer::length(ends).map(|root| Some(root.half())),
        || Some(exact::length(ends).half()),
    )
}

/// Returns the radius of the circle through three points, rounded up, and which stage found it;
/// infinite if they are collinear.
pub(super) fn circumradius(corners: [Point; 3]) -> (f64, Stage) {
    staged(
        filtered_circumradius(corners),
        || integer::circumradius(corners),
        || exact::circumradius(corners),
    )
}

/// Asks one stage after the other; a root of `None` is infinite.
fn staged(
    filtered: Option<f64>,
    integer: impl FnOnce() -> Option<Option<Root>>,
    exact: impl FnOnce() -> Option<Root>,
) -> (f64, Stage) {
    let up = |root: Option<Root>| root.map_or(f64::INFINITY, upward);
    if let Some(value) = filtered {
        (value, Stage::Filter)
    } else if let Some(root) = integer() {
        (up(root), Stage::Integer)
    } else {
        (up(exact()), Stage::BigInteger)
    }
}

fn filtered_length([a, b]: [Point; 2]) -> Option<f64> {
    if !is_tame(&[a, b]) {
        return None;
    }
    let along = vector(a, b);
    certain(dot(&along, &along).sqrt(), LENGTH_BOUND)
}

fn filtered_circumradius([a, b, c]: [Point; 3]) -> Option<f64> {
    if !is_tame(&[a, b, c]) {
        return None;
    }
    let [u, v, w] = [vector(c, a), vector(c, b), vector(a, b)];
    let area = cross(&u, &v);
    let size = (u[0].high * v[1].high).abs() + (u[1].high * v[0].high).abs();
    let ratio = size / area.high.abs();
    if ratio.is_nan() || ratio >= power_of_two(40) {
        return None;
    }
    let [ul, vl, wl] = [&u, &v, &w].map(|side| dot(side, side));
    let sides = &(&ul * &vl) * &wl;
    let twice = area + area;
    certain((sides / (&twice * &twice)).sqrt(), RADIUS_BOUND * ratio)
}

/// Whether no step of stage 1 can over- or underflow: coordinates are zero or of magnitude 2⁻¹⁰⁰ …
/// 2¹⁰⁰, hence multiples of 2⁻¹⁵². Squared sides are at least 2⁻³⁰⁴, their product is 2⁻⁹¹² … 2⁶⁰⁶, with
/// a low part above 2⁻¹⁰²⁰; squares of the cross product are 2⁻⁶⁰⁸ … 2⁴⁰⁶. A quotient that overflows
/// leaves no number that [`certain`] would take.
pub(super) fn is_tame(points: &[Point]) -> bool {
    let is_tame = |c: f64| c == 0.0 || (power_of_two(-100)..=power_of_two(100)).contains(&c.abs());
    points.iter().all(|p| is_tame(p.x) && is_tame(p.y))
}

/// The exact vector from `a` to `b`.
fn vector(a: Point, b: Point) -> [Double; 2] {
    [Double::sum(b.x, -a.x), Double::sum(b.y, -a.y)]
}

/// Rounds up a positive number that is known up to a relative `bound`, if it is certain how.
fn certain(value: Double, bound: f64) -> Option<f64> {
    let Double { high, low } = value;
    let error = bound * high;
    if low - error > 0.0 {
        Some(high.next_up())
    } else if low + error < 0.0 {
        Some(high)
    } else {
        None
    }
}
