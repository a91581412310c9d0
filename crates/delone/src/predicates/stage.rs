//! The predicates once more, telling which stage decided: for tests and measurements.
//!
//! Answers are those of the functions of the same name [one level up](super).

use super::{CircleSide, Orientation, crossing, exact, filter, integer, perturbation};
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

/// Tells where `p` lies relative to the circle about `center`, and which stage found it.
pub fn in_disc(center: Point, radius: f64, p: Point) -> (CircleSide, Stage) {
    let (order, stage) = first(
        filter::compare_squares(filter::squared_distance(center, p), radius * radius),
        || integer::in_disc(center, radius, p),
        || exact::in_disc(center, radius, p),
    );
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

/// Returns the point where the segments cross properly, correctly rounded, and which stage found it;
/// there are no fixed-width integers for this.
pub fn crossing_point(s: [Point; 2], t: [Point; 2]) -> Option<(Point, Stage)> {
    super::cross_properly(s, t).then(|| crossing::crossing(s, t))
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
