//! The predicates once more, telling which stage decided: for tests and measurements.
//!
//! Answers are those of the functions of the same name [one level up](super).

use super::power::segment_sign;
use super::{
    Bottom, CircleSide, Orientation, Weighted, crossing, exact, filter, integer, perturbation,
    radius,
};
use crate::Point;
use std::cmp::Ordering;

/// The arithmetic that decided a predicate, cheapest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Stage {
    /// Floating point with an error bound.
    Filter,
    /// Integers of fixed width.
    Integer,
    /// Integers of any width.
    BigInteger,
}

/// Tells where `c` lies relative to the line from `a` to `b`, and which stage found it.
pub fn orient2d(a: Point, b: Point, c: Point) -> (Orientation, Stage) {
    let (sign, stage) = first(
        filter::orient2d(a, b, c),
        || integer::orient2d(a, b, c),
        || exact::orient2d(a, b, c),
    );
    (Orientation::from_sign(sign), stage)
}

/// Tells where `d` lies relative to the circle through the counter-clockwise `a`, `b`, `c`, and which
/// stage found it.
pub fn in_circle(a: Point, b: Point, c: Point, d: Point) -> (CircleSide, Stage) {
    let (sign, stage) = first(
        filter::in_circle(a, b, c, d),
        || integer::in_circle(a, b, c, d),
        || exact::in_circle(a, b, c, d),
    );
    (CircleSide::from_sign(sign), stage)
}

/// Tells whether `d` lies inside the circle through the counter-clockwise `a`, `b`, `c` under the
/// symbolic perturbation, and which stage found the unperturbed side.
pub fn in_circle_perturbed(a: Point, b: Point, c: Point, d: Point) -> (bool, Stage) {
    let (side, stage) = in_circle(a, b, c, d);
    let is_inside = match side {
        CircleSide::Inside => true,
        CircleSide::Outside => false,
        CircleSide::On => perturbation::is_inside(a, b, c, d),
    };
    (is_inside, stage)
}

/// Compares the distances from `p` to `a` and to `b`, and tells which stage found the order.
pub fn compare_distances(p: Point, a: Point, b: Point) -> (Ordering, Stage) {
    first(
        filter::compare_distances(p, a, b),
        || integer::compare_distances(p, a, b),
        || exact::compare_distances(p, a, b),
    )
}

/// Compares the lengths of two segments, and tells which stage found the order.
pub fn compare_lengths(s: [Point; 2], t: [Point; 2]) -> (Ordering, Stage) {
    first(
        filter::compare_squares(filter::squared_length(s), filter::squared_length(t)),
        || integer::compare_lengths(s, t),
        || exact::compare_lengths(s, t),
    )
}

/// Tells where `p` lies relative to the circle about `center`, and which stage found it.
pub fn in_disc(center: Point, radius: f64, p: Point) -> (CircleSide, Stage) {
    let arm = [Point::new(0.0, 0.0), Point::new(radius, 0.0)];
    let (order, stage) = compare_lengths([center, p], arm);
    (CircleSide::from_sign(order.reverse()), stage)
}

/// Tells where `p` lies relative to the circle with diameter `ab`, and which stage found it.
pub fn in_diametral_circle(a: Point, b: Point, p: Point) -> (CircleSide, Stage) {
    let (sign, stage) = first(
        filter::diametral(a, b, p),
        || integer::diametral(a, b, p),
        || exact::diametral(a, b, p),
    );
    (CircleSide::from_sign(sign.reverse()), stage)
}

/// Tells where `d` lies relative to the power circle of the counter-clockwise `a`, `b`, `c`, and which
/// stage found it.
pub fn in_power_circle(a: Weighted, b: Weighted, c: Weighted, d: Weighted) -> (CircleSide, Stage) {
    let (sign, stage) = first(
        filter::in_power_circle(a, b, c, d),
        || integer::in_power_circle(a, b, c, d),
        || exact::in_power_circle(a, b, c, d),
    );
    (CircleSide::from_sign(sign), stage)
}

/// Tells where `p` lies relative to the power interval of `a` and `b` on its line, and which stage
/// found it; there is no filter for this.
pub fn in_power_segment(a: Weighted, b: Weighted, p: Weighted) -> (CircleSide, Stage) {
    let (sign, is_fixed) = segment_sign(a, b, p);
    let stage = if is_fixed {
        Stage::Integer
    } else {
        Stage::BigInteger
    };
    (CircleSide::from_sign(sign), stage)
}

/// Returns the point where the segments cross properly, correctly rounded, and which stage found it;
/// there are no fixed-width integers for this.
pub fn crossing_point(s: [Point; 2], t: [Point; 2]) -> Option<(Point, Stage)> {
    super::cross_properly(s, t).then(|| crossing::crossing(s, t))
}

/// Returns the length of a segment, rounded up, and which stage found it.
pub fn length_up(s: [Point; 2]) -> (f64, Stage) {
    radius::length(s)
}

/// Returns the radius of the circle through three points, rounded up, and which stage found it.
pub fn circumradius_up(a: Point, b: Point, c: Point) -> (f64, Stage) {
    radius::circumradius([a, b, c])
}

/// Compares the heights of two parabolas above `p`, and tells which stage found the order; there are no
/// fixed-width integers for this, nor for the next two.
pub fn compare_parabolas(p: Point, a: Point, b: Point) -> (Ordering, Stage) {
    first(
        filter::compare_parabolas(p, a, b),
        || None,
        || exact::compare_parabolas(p, a, b),
    )
}

/// Compares the lowest points of two circles, and tells which stage found the order.
pub fn compare_bottoms(t: [Point; 3], u: [Point; 3]) -> (Ordering, Stage) {
    Bottom::new(t).compare_staged(&Bottom::new(u))
}

/// Compares the ordinates of the lowest point of a circle and of `p`, and tells which stage found the order.
pub fn compare_bottom(t: [Point; 3], p: Point) -> (Ordering, Stage) {
    Bottom::new(t).compare_to_staged(p)
}

/// Takes the answer of the first stage that has one.
fn first(
    filter: Option<Ordering>,
    integer: impl FnOnce() -> Option<Ordering>,
    exact: impl FnOnce() -> Ordering,
) -> (Ordering, Stage) {
    if let Some(sign) = filter {
        return (sign, Stage::Filter);
    }
    match integer() {
        Some(sign) => (sign, Stage::Integer),
        None => (exact(), Stage::BigInteger),
    }
}
