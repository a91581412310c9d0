//! Points with weights: the signs behind the regular triangulation, and its dual points.
//!
//! The *power* of a place q with respect to a point p of weight w is |q − p|² − w: outside the circle
//! of squared radius w about p it is the squared length of a tangent. The three circles of a triangle
//! have one place of equal power, its [power center](power_center); with equal weights that is the
//! circumcenter. Lifting p to height |p|² − w turns all of this into planes: whether a point lies
//! below the plane of three others is the [power test](in_power_circle).

use super::{CircleSide, center, exact, filter, integer, perturbation};
use crate::Point;
use std::cmp::Ordering;

/// A point with a weight, in units of squared length: the weight of a circle is its radius squared.
///
/// Only differences of weights matter. They may be negative, and must be finite.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Weighted {
    /// The position.
    pub point: Point,
    /// The weight.
    pub weight: f64,
}

impl Weighted {
    /// Gives `point` a weight.
    pub fn new(point: impl Into<Point>, weight: f64) -> Self {
        Self {
            point: point.into(),
            weight,
        }
    }
}

/// Tells where `d` lies relative to the power circle of `a`, `b`, `c`, which turn counter-clockwise:
/// inside if it lies below their plane when lifted, that is, if the triangle cannot stay.
///
/// Laws, for all finite points and weights:
/// - *cyclic* in `a`, `b`, `c`, and *antisymmetric*: exchanging any two of the four arguments reverses
///   the side;
/// - *equal weights*: the answer is that of [`in_circle`](super::in_circle);
/// - *equal points*: `d` in the place of a corner is inside if it is heavier, outside if lighter;
/// - *collinear*: `On` if all four are collinear.
#[inline]
pub fn in_power_circle(a: Weighted, b: Weighted, c: Weighted, d: Weighted) -> CircleSide {
    CircleSide::from_sign(power_sign(a, b, c, d))
}

/// Tells whether `d` lies inside the power circle of `a`, `b`, `c` under the symbolic perturbation,
/// which leaves no point on it.
///
/// `a`, `b`, `c` must turn counter-clockwise; if they do not, nothing is promised of the answer.
///
/// Laws, for `abc` and any other triangle that is compared counter-clockwise:
/// - *faithful*: where [`in_power_circle`] is not `On`, this agrees with it;
/// - *cyclic*: in `a`, `b`, `c`;
/// - *symmetric*: an edge is judged alike from both sides:
///   `in_power_circle_perturbed(a, b, c, d) == in_power_circle_perturbed(b, a, d, c)`;
/// - *equal weights*: the answer is that of [`in_circle_perturbed`](super::in_circle_perturbed);
/// - *degenerate*: a corner of the triangle is not inside; a point of the triangle that is `On` is.
///
/// ```
/// use delone::predicates::{Weighted, in_power_circle_perturbed};
/// let [a, b, c] = [(0.0, 0.0), (4.0, 0.0), (0.0, 4.0)].map(|p| Weighted::new(p, 0.0));
/// // The plane of the three lies 6 above the paraboloid at (1, 1).
/// assert!(in_power_circle_perturbed(a, b, c, Weighted::new((1.0, 1.0), -5.0)));
/// assert!(in_power_circle_perturbed(a, b, c, Weighted::new((1.0, 1.0), -6.0)));
/// assert!(!in_power_circle_perturbed(a, b, c, Weighted::new((1.0, 1.0), -7.0)));
/// ```
#[inline]
pub fn in_power_circle_perturbed(a: Weighted, b: Weighted, c: Weighted, d: Weighted) -> bool {
    match power_sign(a, b, c, d) {
        Ordering::Greater => true,
        Ordering::Less => false,
        Ordering::Equal => {
            perturbation::is_inside_power_circle([a.point, b.point, c.point], d.point)
        }
    }
}

#[inline]
fn power_sign(a: Weighted, b: Weighted, c: Weighted, d: Weighted) -> Ordering {
    match filter::in_power_circle(a, b, c, d) {
        Some(sign) => sign,
        None => power_sign_exact(a, b, c, d),
    }
}

#[cold]
#[inline(never)]
fn power_sign_exact(a: Weighted, b: Weighted, c: Weighted, d: Weighted) -> Ordering {
    integer::in_power_circle(a, b, c, d).unwrap_or_else(|| exact::in_power_circle(a, b, c, d))
}

/// Tells where `p` lies relative to the power interval of `a` and `b`, three collinear points: inside
/// if it lies below their line when lifted, that is, if the edge `ab` cannot stay.
///
/// `p` may lie beyond an end, and may be inside even so, if it is heavy enough.
///
/// Laws, for all finite points and weights, collinear: symmetric in `a` and `b`; with equal weights,
/// inside is what lies strictly between `a` and `b`; `On` if `a` and `b` are in the same place.
#[inline]
pub fn in_power_segment(a: Weighted, b: Weighted, p: Weighted) -> CircleSide {
    CircleSide::from_sign(segment_sign(a, b, p).0)
}

/// Tells whether `p` lies inside the power interval of `a` and `b`, two other places on its line, under
/// the symbolic perturbation, which leaves no point on its border.
///
/// Where [`in_power_segment`] is `On`, that is so strictly between `a` and `b`, and nowhere else.
#[inline]
pub fn in_power_segment_perturbed(a: Weighted, b: Weighted, p: Weighted) -> bool {
    match segment_sign(a, b, p).0 {
        Ordering::Greater => true,
        Ordering::Less => false,
        Ordering::Equal => perturbation::is_inside_power_segment(a.point, b.point, p.point),
    }
}

/// The sign, and whether integers of fixed width have found it. There is no filter: that the points
/// are collinear has been decided exactly just before, and on hulls only.
pub(super) fn segment_sign(a: Weighted, b: Weighted, p: Weighted) -> (Ordering, bool) {
    let [a, b] = if a.point.lex_cmp(&b.point).is_le() {
        [a, b]
    } else {
        [b, a]
    };
    match integer::in_power_segment(a, b, p) {
        Some(sign) => (sign, true),
        None => (exact::in_power_segment(a, b, p), false),
    }
}

/// Returns the place that has the same power with respect to `a`, `b` and `c`, each coordinate the
/// `f64` nearest to the exact one (of two, the even one); `None` if the three points lie on one line.
///
/// A coordinate beyond the largest `f64` becomes that number.
///
/// Laws, for all finite points and weights: the same for every order of the three; if their weights
/// are equal, the [circumcenter](super::circumcenter).
///
/// ```
/// use delone::predicates::{Weighted, power_center};
/// let [a, b] = [(0.0, 0.0), (4.0, 0.0)].map(|p| Weighted::new(p, 0.0));
/// let center = |weight| power_center(a, b, Weighted::new((0.0, 4.0), weight));
/// assert_eq!(center(0.0), Some((2.0, 2.0).into()));
/// assert_eq!(center(8.0), Some((2.0, 1.0).into())); // a heavy point pushes it away
/// ```
pub fn power_center(a: Weighted, b: Weighted, c: Weighted) -> Option<Point> {
    center::power_center([a, b, c])
}

/// Compares the powers of `p` with respect to `a` and to `b`: the site of less power has `p` in its cell
/// of their power diagram.
///
/// Laws, for all finite points and weights: a total preorder of the sites for each `p`, reversed when `a`
/// and `b` are exchanged; with equal weights, that of
/// [`compare_distances`](super::compare_distances).
#[inline]
pub fn compare_powers(p: Point, a: Weighted, b: Weighted) -> Ordering {
    filter::compare_powers(p, a, b).unwrap_or_else(|| exact::compare_powers(p, a, b))
}

/// Compares where a way, going on for ever, comes to have the same power with respect to `a` as to
/// `site`, and where the same as to `b`. It must lead from `site` [towards](super::towards) both.
pub(crate) fn compare_power_meetings(
    way: [Point; 2],
    site: Weighted,
    a: Weighted,
    b: Weighted,
) -> Ordering {
    exact::compare_meetings(way, [site, a, b])
}

/// Returns the point on the line of a segment that has the same power with respect to two sites, each
/// coordinate the `f64` nearest to the exact one, at most the largest. There must be exactly one such
/// point on the line.
pub(crate) fn power_place(segment: [Point; 2], a: Weighted, b: Weighted) -> Point {
    exact::bisector_place(segment, a, b)
}
