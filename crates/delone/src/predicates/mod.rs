//! The signs on which all topology rests: exact for every finite `f64`.
//!
//! Each predicate is the sign of a polynomial in the coordinates, found in up to three
//! [stages](stage): a floating-point filter with a proven error bound (`filter.rs`), fixed-width
//! integers for whatever is near a tie (`integer.rs`), and big integers for the rest (`exact.rs`).
//! Ties on a circle are broken by a symbolic perturbation (`perturbation.rs`). Points with weights have
//! predicates of their own (`power.rs`). Constructions live here too, because they are as exact as
//! rounded numbers can be: [`crossing_point`], [`circumcenter`] and [`power_center`], and lengths and
//! circumradii rounded up ([`length_up`], [`circumradius_up`]).
//!
//! *Cost*: a few nanoseconds where the filter decides, 15 to 40 in fixed integers, 200 to 800 and
//! some allocations in big integers (`cargo run --release --example predicate_cost` measures).
//!
//! *Assumes* finite coordinates; a NaN or an infinity gives some answer, never undefined
//! behaviour. −0.0 counts as 0.0. *Does not* know ids, meshes or tolerances.
//!
//! The filter and its bounds follow Shewchuk, *Adaptive precision floating-point arithmetic and
//! fast robust geometric predicates* (1997); the perturbation Devillers and Teillaud,
//! *Perturbations for Delaunay and weighted Delaunay 3D triangulations* (2011).

use crate::Point;
use std::cmp::Ordering;

mod barycentric;
mod bisector;
mod bottom;
mod center;
mod crossing;
mod double;
mod dyadic;
mod exact;
mod filter;
mod fraction;
mod integer;
mod perturbation;
mod polynomial;
mod power;
mod quotient;
mod radius;
mod reach;
mod slope;
pub mod stage;
mod weights;

pub(crate) use barycentric::Barycentric;
pub use barycentric::ExactPoint;
pub(crate) use bottom::Bottom;
pub(crate) use double::Double;
pub(crate) use filter::{
    IN_CIRCLE_BOUND, ORIENT2D_BOUND, compare_squares, in_circle_relative, squared_length,
};
pub use fraction::fraction_along;
pub use power::{
    Weighted, compare_powers, in_power_circle, in_power_circle_perturbed, in_power_segment,
    in_power_segment_perturbed, power_center,
};
pub(crate) use power::{compare_power_meetings, power_place};
pub use slope::angles_are_at_least;
pub use weights::corner_weights;

/// Where a point lies relative to a directed line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "kebab-case")
)]
pub enum Orientation {
    /// To the left: the three points turn counter-clockwise.
    Left,
    /// To the right: the three points turn clockwise.
    Right,
    /// On the line.
    Collinear,
}

impl Orientation {
    /// Reads the sign of a determinant, positive for counter-clockwise.
    #[inline]
    fn from_sign(sign: Ordering) -> Self {
        match sign {
            Ordering::Greater => Self::Left,
            Ordering::Less => Self::Right,
            Ordering::Equal => Self::Collinear,
        }
    }

    /// Returns the orientation in a mirror: left and right swapped.
    #[inline]
    pub fn reversed(self) -> Self {
        match self {
            Self::Left => Self::Right,
            Self::Right => Self::Left,
            Self::Collinear => Self::Collinear,
        }
    }
}

/// Where a point lies relative to a circle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "kebab-case")
)]
pub enum CircleSide {
    /// Strictly inside.
    Inside,
    /// On the circle.
    On,
    /// Strictly outside.
    Outside,
}

impl CircleSide {
    /// Reads the sign of a determinant, positive for inside.
    #[inline]
    fn from_sign(sign: Ordering) -> Self {
        match sign {
            Ordering::Greater => Self::Inside,
            Ordering::Less => Self::Outside,
            Ordering::Equal => Self::On,
        }
    }

    /// Returns the side as seen from the other one: inside and outside swapped.
    #[inline]
    pub fn reversed(self) -> Self {
        match self {
            Self::Inside => Self::Outside,
            Self::Outside => Self::Inside,
            Self::On => Self::On,
        }
    }
}

/// Tells where `c` lies relative to the line from `a` to `b`.
///
/// Laws, for all finite points:
/// - *cyclic*: `orient2d(a, b, c) == orient2d(b, c, a)`;
/// - *antisymmetric*: `orient2d(b, a, c) == orient2d(a, b, c).reversed()`;
/// - *degenerate*: two equal points are collinear with everything;
/// - *scale-free*: multiplying all coordinates by a power of two changes nothing as long as no
///   coordinate is rounded.
///
/// ```
/// use delone::{Point, predicates::{Orientation, orient2d}};
/// let [a, b] = [Point::new(0.0, 0.0), Point::new(1e-300, 1e-300)];
/// assert_eq!(orient2d(a, b, Point::new(0.0, 5e-324)), Orientation::Left);
/// assert_eq!(orient2d(a, b, Point::new(1e300, 1e300)), Orientation::Collinear);
/// ```
#[inline]
pub fn orient2d(a: Point, b: Point, c: Point) -> Orientation {
    match filter::orient2d(a, b, c) {
        Some(sign) => Orientation::from_sign(sign),
        None => orient2d_exact(a, b, c),
    }
}

/// Tells where `d` lies relative to the circle through `a`, `b`, `c`, which turn counter-clockwise.
///
/// Laws, for all finite points:
/// - *cyclic*: `in_circle(a, b, c, d) == in_circle(b, c, a, d)`;
/// - *antisymmetric*: exchanging any two of the four arguments reverses the side. So `Inside` and
///   `Outside` trade places if `a`, `b`, `c` turn clockwise;
/// - *degenerate*: if two arguments are equal, the answer is `On`;
/// - *collinear*: if `a`, `b`, `c` follow each other on a line, the half-plane to its left is
///   `Inside`; on the line itself everything is `On`.
#[inline]
pub fn in_circle(a: Point, b: Point, c: Point, d: Point) -> CircleSide {
    match filter::in_circle(a, b, c, d) {
        Some(sign) => CircleSide::from_sign(sign),
        None => in_circle_exact(a, b, c, d),
    }
}

/// Tells whether `d` lies inside the circle through `a`, `b`, `c` under the symbolic perturbation,
/// which leaves no point on a circle.
///
/// `a`, `b`, `c` must turn counter-clockwise; if they do not, nothing is promised of the answer.
///
/// Laws, for `abc` and the other triangle that is compared counter-clockwise:
/// - *faithful*: where [`in_circle`] is not `On`, this agrees with it;
/// - *cyclic*: in `a`, `b`, `c`;
/// - *never zero*: of the two diagonals of a strictly convex quadrilateral `abcd` exactly one is
///   Delaunay: `in_circle_perturbed(a, b, c, d) != in_circle_perturbed(b, c, d, a)`;
/// - *symmetric*: an edge is judged alike from both sides:
///   `in_circle_perturbed(a, b, c, d) == in_circle_perturbed(b, a, d, c)`;
/// - *degenerate*: a corner of the triangle is not inside.
///
/// ```
/// use delone::{Point, predicates::in_circle_perturbed};
/// let [a, b, c, d] = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(Point::from);
/// // The diagonal that avoids the largest corner, (1, 1), is the Delaunay one: b–d.
/// assert!(in_circle_perturbed(a, b, c, d));
/// assert!(!in_circle_perturbed(a, b, d, c));
/// ```
#[inline]
pub fn in_circle_perturbed(a: Point, b: Point, c: Point, d: Point) -> bool {
    match filter::in_circle(a, b, c, d) {
        Some(sign) => sign.is_gt(),
        None => in_circle_perturbed_exact(a, b, c, d),
    }
}

/// Compares the distances from `p` to `a` and to `b`.
///
/// Laws, for all finite points: a total preorder of the plane for each `p`, reversed when `a` and
/// `b` are exchanged; `p` itself comes first.
#[inline]
pub fn compare_distances(p: Point, a: Point, b: Point) -> Ordering {
    match filter::compare_distances(p, a, b) {
        Some(order) => order,
        None => compare_distances_exact(p, a, b),
    }
}

/// Compares the lengths of two segments.
///
/// Laws, for all finite points: a total preorder of the segments, reversed when the two are exchanged;
/// symmetric in the ends of each; segments of no length come first. Where they share an end this is
/// [`compare_distances`].
///
/// ```
/// use delone::{Point, predicates::compare_lengths};
/// let tiny = 2_f64.powi(-1000);
/// let [a, b, c] = [(0.0, 0.0), (3.0 * tiny, 4.0 * tiny), (5.0 * tiny, 0.0)].map(Point::from);
/// assert!(compare_lengths([a, b], [c, a]).is_eq());
/// ```
#[inline]
pub fn compare_lengths(s: [Point; 2], t: [Point; 2]) -> Ordering {
    match filter::compare_squares(filter::squared_length(s), filter::squared_length(t)) {
        Some(order) => order,
        None => compare_lengths_exact(s, t),
    }
}

/// [`compare_distances`] for callers who keep the [rounded squares](squared_length).
#[inline]
pub(crate) fn compare_squared(p: Point, [a, b]: [Point; 2], [al, bl]: [f64; 2]) -> Ordering {
    filter::compare_squares(al, bl).unwrap_or_else(|| compare_distances_exact(p, a, b))
}

/// Tells where `p` lies relative to the circle of `radius` about `center`; of a negative radius the
/// absolute value counts. The radius must be finite, too.
///
/// Laws, for all finite points: symmetric in `center` and `p`; agrees with [`compare_distances`] where the
/// distance to some point is `radius` exactly; if `p` equals `center`, it is `Inside`, or `On` if the radius
/// is zero.
///
/// ```
/// use delone::{Point, predicates::{CircleSide, in_disc}};
/// let [c, p] = [Point::new(1e16, 0.0), Point::new(1e16 + 3e300, 4e300)];
/// assert_eq!(in_disc(Point::new(0.0, 0.0), 5.0, Point::new(3.0, 4.0)), CircleSide::On);
/// assert_eq!(in_disc(c, 5e300, p), in_disc(p, 5e300, c));
/// ```
#[inline]
pub fn in_disc(center: Point, radius: f64, p: Point) -> CircleSide {
    let arm = [Point::new(0.0, 0.0), Point::new(radius, 0.0)];
    CircleSide::from_sign(compare_lengths([center, p], arm).reverse())
}

/// Tells whether `p` is at most `radius` away from the segment between two points, ends included. The radius
/// must be finite and not negative.
///
/// Laws, for all finite points: symmetric in the ends; if they are equal, that of [`in_disc`]; with a radius of
/// zero, true for the ends and what [is between](is_between) them.
///
/// ```
/// use delone::predicates::is_near_segment;
/// let [a, b, p] = [(0.0, 0.0), (8.0, 0.0), (11.0, 4.0)].map(Into::into);
/// assert!(is_near_segment([a, b], 5.0, p) && !is_near_segment([a, b], 5.0_f64.next_down(), p));
/// ```
pub fn is_near_segment([a, b]: [Point; 2], radius: f64, p: Point) -> bool {
    let is_beside = |from: Point, to: Point| towards([from, to], [from, p]).is_gt();
    if is_beside(a, b) && is_beside(b, a) {
        return reach::line_is_near([a, b], radius, p);
    }
    [a, b]
        .iter()
        .any(|&end| in_disc(end, radius, p) != CircleSide::Outside)
}

/// Tells whether the angle from `a` over `apex` to `b`, at most 180°, is less than the acute angle whose cosine
/// has the square `square`, a number from 0 to 1. A side of no length has no angle.
///
/// Laws, for all finite points: symmetric in `a` and `b`; monotone in `square`.
///
/// ```
/// use delone::predicates::is_sharper;
/// let [o, a, b] = [(0.0, 0.0), (5.0, 0.0), (7.0, 7.0)].map(Into::into);
/// assert!(!is_sharper(o, a, b, 0.5)); // 45° are not less than 45°
/// assert!(is_sharper(o, a, b, 0.25)); // but less than 60°
/// ```
pub fn is_sharper(apex: Point, a: Point, b: Point, square: f64) -> bool {
    reach::is_sharper(apex, [a, b], square)
}

/// Tells where `p` lies relative to the circle with diameter `ab`.
///
/// Laws, for all finite points: symmetric in `a` and `b`; the ends themselves are `On`; if `a`
/// equals `b`, everything else is `Outside`.
#[inline]
pub fn in_diametral_circle(a: Point, b: Point, p: Point) -> CircleSide {
    match filter::diametral(a, b, p) {
        Some(sign) => CircleSide::from_sign(sign.reverse()),
        None => in_diametral_circle_exact(a, b, p),
    }
}

/// Compares the heights above `p` of two parabolas, with foci `a` and `b` and the horizontal line through `p`
/// as directrix: where a circle touches that line in `p` and goes through the focus, its center is on the
/// parabola.
///
/// Neither focus may lie below `p`, or in `p`; beside it, the parabola is infinitely high.
///
/// Laws, for all such points: a total preorder of the foci for each `p`, reversed when `a` and `b` are
/// exchanged; for foci of the same height, above `p`, that of [`compare_distances`]; where it is equal, and the foci
/// differ, `p` is the lowest point of the circle through the three.
///
/// ```
/// use delone::predicates::compare_parabolas;
/// let [p, a, b] = [(0.0, -5.0), (3.0, 4.0), (0.0, 5.0)].map(Into::into);
/// assert!(compare_parabolas(p, a, b).is_eq()); // the circle about the origin
/// ```
#[inline]
pub fn compare_parabolas(p: Point, a: Point, b: Point) -> Ordering {
    filter::compare_parabolas(p, a, b).unwrap_or_else(|| exact::compare_parabolas(p, a, b))
}

/// Compares the ordinates of the lowest points of two circles, each through three points that are not
/// collinear.
///
/// Laws, for all such points: a total preorder of the circles, reversed when the two are exchanged; symmetric
/// in the points of each; the same for any three points on one circle; agrees with
/// [`compare_bottom`] where one of them goes through its lowest point.
///
/// ```
/// use delone::predicates::compare_bottoms;
/// let t = [(5.0, 0.0), (3.0, 4.0), (-4.0, 3.0)].map(Into::into);
/// let u = [(2.0, -5.0), (4.0, -3.0), (2.0, -1.0)].map(Into::into);
/// assert!(compare_bottoms(t, u).is_eq()); // both touch the line y = −5
/// ```
pub fn compare_bottoms(t: [Point; 3], u: [Point; 3]) -> Ordering {
    Bottom::new(t).compare(&Bottom::new(u))
}

/// Compares the ordinate of the lowest point of a circle, through three points that are not collinear, with
/// that of `p`.
///
/// Laws, for all such points: symmetric in the three; unless `Less`, none of them lies below `p`.
pub fn compare_bottom(t: [Point; 3], p: Point) -> Ordering {
    Bottom::new(t).compare_to(p)
}

/// Tells whether the segments `ab` and `cd` cross properly: in one point that is an end of neither.
///
/// Laws, for all finite points: symmetric in the two segments and in the ends of each; segments that
/// touch, overlap or share an end do not cross.
#[inline]
pub fn cross_properly([a, b]: [Point; 2], [c, d]: [Point; 2]) -> bool {
    are_separated([c, d], [a, b]) && are_separated([a, b], [c, d])
}

/// Tells whether `c` and `d` lie strictly on different sides of the line `ab`.
#[inline]
fn are_separated([c, d]: [Point; 2], [a, b]: [Point; 2]) -> bool {
    match orient2d(a, b, c) {
        Orientation::Collinear => false,
        side => orient2d(a, b, d) == side.reversed(),
    }
}

/// Tells whether `p` lies on the segment `ab`, ends excluded.
///
/// Laws, for all finite points: symmetric in `a` and `b`; false if `a` equals `b`.
#[inline]
pub fn is_between(a: Point, b: Point, p: Point) -> bool {
    let (ap, pb) = (a.lex_cmp(&p), p.lex_cmp(&b));
    ap == pb && ap.is_ne() && orient2d(a, b, p) == Orientation::Collinear
}

/// Returns the point where the segments `ab` and `cd` cross, each coordinate the `f64` nearest to
/// the exact one (of two, the even one); `None` if they do not [cross properly](cross_properly).
///
/// Laws, for all finite points: symmetric in the two segments and in the ends of each; the point lies
/// in the bounding boxes of both; multiplying all coordinates by a power of two multiplies the result
/// as long as nothing is rounded.
///
/// ```
/// use delone::predicates::crossing_point;
/// let s = [(0.0, 0.0), (3.0, 1.0)].map(Into::into);
/// let t = [(0.0, 1.0), (3.0, 0.0)].map(Into::into);
/// assert_eq!(crossing_point(s, t), Some((1.5, 0.5).into()));
/// assert_eq!(crossing_point(s, [s[0], t[1]]), None);
/// ```
pub fn crossing_point(s: [Point; 2], t: [Point; 2]) -> Option<Point> {
    cross_properly(s, t).then(|| construct_crossing(s, t))
}

/// Returns the center of the circle through three points, each coordinate the `f64` nearest to the exact
/// one (of two, the even one); `None` if they lie on one line.
///
/// A coordinate beyond the largest `f64` becomes that number.
///
/// Laws, for all finite points: symmetric in the three; the same for any three of a set of points on one
/// circle; multiplying all coordinates by a power of two multiplies the result as long as nothing is
/// rounded.
///
/// ```
/// use delone::predicates::circumcenter;
/// let [a, b, c] = [(0.0, 0.0), (6.0, 0.0), (0.0, 8.0)].map(Into::into);
/// assert_eq!(circumcenter(a, b, c), Some((3.0, 4.0).into()));
/// assert_eq!(circumcenter(a, b, b), None);
/// ```
pub fn circumcenter(a: Point, b: Point, c: Point) -> Option<Point> {
    center::circumcenter([a, b, c])
}

/// Returns the length of a segment, rounded up: the smallest `f64` that is not less, infinite beyond the
/// largest.
///
/// Laws, for all finite points: for every `f64` r, the length is at most r if and only if
/// `length_up(s) <= r`; symmetric in the ends; zero only if they are equal; whoever is
/// [not longer](compare_lengths) has no larger one; multiplying all coordinates by a power of two
/// multiplies the result as long as nothing leaves the range of normal numbers.
///
/// ```
/// use delone::predicates::length_up;
/// let tiny = 2_f64.powi(-1000);
/// assert_eq!(length_up([(0.0, 0.0), (3.0 * tiny, 4.0 * tiny)].map(Into::into)), 5.0 * tiny);
/// let diagonal = length_up([(0.0, 0.0), (1.0, 1.0)].map(Into::into));
/// assert!(diagonal == 2_f64.sqrt(), "which happens to be rounded up itself");
/// ```
pub fn length_up(s: [Point; 2]) -> f64 {
    radius::length(s).0
}

/// Returns half the length of a segment, rounded up, which may be finite where the length is not.
pub(crate) fn half_length_up(s: [Point; 2]) -> f64 {
    radius::half_length(s).0
}

/// Returns the radius of the circle through three points, rounded up: the smallest `f64` that is not
/// less, infinite beyond the largest, and if the points are collinear.
///
/// Laws, for all finite points: for every finite `f64` r, the radius is at most r if and only if
/// `circumradius_up(a, b, c) <= r`; symmetric in the points; not less than half of each
/// [length](length_up) between them; multiplying all coordinates by a power of two multiplies the result
/// as long as nothing leaves the range of normal numbers.
///
/// ```
/// use delone::predicates::circumradius_up;
/// let [a, b, c] = [(0.0, 0.0), (6.0, 0.0), (6.0, 8.0)].map(Into::into);
/// assert_eq!(circumradius_up(a, b, c), 5.0);
/// assert_eq!(circumradius_up(a, b, b), f64::INFINITY);
/// ```
pub fn circumradius_up(a: Point, b: Point, c: Point) -> f64 {
    radius::circumradius([a, b, c]).0
}

/// [`crossing_point`] for callers who know that the segments cross properly.
pub(crate) fn construct_crossing(s: [Point; 2], t: [Point; 2]) -> Point {
    crossing::crossing(s, t).0
}

/// Returns the point where the lines through two segments meet, each coordinate the `f64` nearest to the exact
/// one; one beyond the largest becomes that number. `None` if they are parallel, or a segment has no length.
///
/// *Cost*: about 2 µs, in big integers: they may meet far from both.
pub(crate) fn meeting_of_lines(s: [Point; 2], t: [Point; 2]) -> Option<Point> {
    (turning(s, t) != Orientation::Collinear).then(|| exact::crossing(s, t))
}

/// Returns the point that divides the segment from `a` to `b` at the share `t` of its length, each
/// coordinate rounded once: off by half a unit in its last place, for all but overflowing differences.
pub(crate) fn point_between([a, b]: [Point; 2], t: f64) -> Point {
    let [x, y] = [[a.x, b.x], [a.y, b.y]].map(|ends| double::interpolated(ends, t));
    Point::new(x, y)
}

/// Tells whether the way from `p` to `q` leads from `a` towards `b`: the sign of the dot product of the two
/// vectors.
pub(crate) fn towards(way: [Point; 2], ends: [Point; 2]) -> Ordering {
    filter::towards(way, ends).unwrap_or_else(|| exact::towards(way, ends))
}

/// Tells whether `b` lies to the left or right of `a` for someone who looks from `p` to `q`.
pub(crate) fn turning(way: [Point; 2], ends: [Point; 2]) -> Orientation {
    let sign = filter::turning(way, ends).unwrap_or_else(|| exact::turning(way, ends));
    Orientation::from_sign(sign)
}

/// Compares where a way, going on for ever, comes to be as near to `a` as to `site`, and where as near to
/// `b`. It must lead from `site` [towards] both.
pub(crate) fn compare_meetings(way: [Point; 2], site: Point, a: Point, b: Point) -> Ordering {
    bisector::compare(way, site, a, b).unwrap_or_else(|| {
        exact::compare_meetings(way, [site, a, b].map(|p| Weighted::new(p, 0.0)))
    })
}

/// Returns the point of a segment that is equally far from two sites, each coordinate the `f64` nearest to
/// the exact one. There must be exactly one such point between its ends, or at one.
pub(crate) fn bisector_place(segment: [Point; 2], a: Point, b: Point) -> Point {
    bisector::place(segment, a, b)
}

/// Tells whether a segment passes `p` as far as `f64` can tell: its point of the same abscissa, or of
/// the same ordinate, rounds to `p`. Its ends do not count.
pub(crate) fn passes([a, b]: [Point; 2], p: Point) -> bool {
    let is_within = |a: f64, b: f64, c: f64| (a <= c && c <= b) || (b <= c && c <= a);
    if p == a || p == b || !is_within(a.x, b.x, p.x) || !is_within(a.y, b.y, p.y) {
        return false;
    }
    let meets = |c: Point, d: Point| construct_crossing([a, b], [c, d]) == p;
    a.x == b.x
        || a.y == b.y
        || meets(Point::new(p.x, a.y), Point::new(p.x, b.y))
        || meets(Point::new(a.x, p.y), Point::new(b.x, p.y))
}

/// [`orient2d`] for callers whose own filter has failed.
#[cold]
#[inline(never)]
pub(crate) fn orient2d_exact(a: Point, b: Point, c: Point) -> Orientation {
    let sign = integer::orient2d(a, b, c).unwrap_or_else(|| exact::orient2d(a, b, c));
    Orientation::from_sign(sign)
}

/// [`in_circle_perturbed`] for callers whose own filter has failed.
#[cold]
#[inline(never)]
pub(crate) fn in_circle_perturbed_exact(a: Point, b: Point, c: Point, d: Point) -> bool {
    let sign = integer::in_circle(a, b, c, d).unwrap_or_else(|| exact::in_circle(a, b, c, d));
    match sign {
        Ordering::Greater => true,
        Ordering::Less => false,
        Ordering::Equal => perturbation::is_inside(a, b, c, d),
    }
}

#[cold]
#[inline(never)]
fn in_circle_exact(a: Point, b: Point, c: Point, d: Point) -> CircleSide {
    let sign = integer::in_circle(a, b, c, d).unwrap_or_else(|| exact::in_circle(a, b, c, d));
    CircleSide::from_sign(sign)
}

#[cold]
#[inline(never)]
fn compare_distances_exact(p: Point, a: Point, b: Point) -> Ordering {
    integer::compare_distances(p, a, b).unwrap_or_else(|| exact::compare_distances(p, a, b))
}

/// [`compare_lengths`] for callers whose own filter has failed.
#[cold]
#[inline(never)]
pub(crate) fn compare_lengths_exact(s: [Point; 2], t: [Point; 2]) -> Ordering {
    integer::compare_lengths(s, t).unwrap_or_else(|| exact::compare_lengths(s, t))
}

#[cold]
#[inline(never)]
fn in_diametral_circle_exact(a: Point, b: Point, p: Point) -> CircleSide {
    let sign = integer::diametral(a, b, p).unwrap_or_else(|| exact::diametral(a, b, p));
    CircleSide::from_sign(sign.reverse())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// All vectors with small integer coordinates.
    fn small_vectors() -> impl Iterator<Item = [i32; 2]> {
        (-2..=2).flat_map(|x| (-2..=2).map(move |y| [x, y]))
    }

    fn place([x, y]: [i32; 2], scale: f64) -> Point {
        Point::new(f64::from(x) * scale, f64::from(y) * scale)
    }

    #[test]
    fn ways_are_compared_by_their_products() {
        // From where squares underflow to where they overflow.
        for scale in [2_f64.powi(-1000), 2_f64.powi(-500), 1.0, 2_f64.powi(700)] {
            for [ux, uy] in small_vectors() {
                for [vx, vy] in small_vectors() {
                    let way = [[-1, 5], [ux - 1, uy + 5]].map(|p| place(p, scale));
                    let ends = [[3, -2], [vx + 3, vy - 2]].map(|p| place(p, scale));
                    assert_eq!(towards(way, ends), (ux * vx + uy * vy).cmp(&0));
                    let turn = Orientation::from_sign((ux * vy - uy * vx).cmp(&0));
                    assert_eq!(turning(way, ends), turn);
                }
            }
        }
    }

    #[test]
    fn products_that_are_nearly_zero_are_decided_exactly() {
        // Multiples of 0.1, each rounded: what would be a tie is none, or only just.
        let near = |p: [i32; 2]| place(p, 0.1);
        for [ux, uy] in small_vectors() {
            for [vx, vy] in small_vectors() {
                let way = [near([11, 35]), near([11 + 3 * ux, 35 + 3 * uy])];
                let ends = [near([7, 24]), near([7 + 5 * vx, 24 + 5 * vy])];
                assert_eq!(towards(way, ends), exact::towards(way, ends));
                let turn = Orientation::from_sign(exact::turning(way, ends));
                assert_eq!(turning(way, ends), turn);
            }
        }
    }

    #[test]
    fn segments_on_a_lattice_pass_what_is_between() {
        let lattice = || small_vectors().map(|p| place(p, 1.0));
        for a in lattice() {
            for b in lattice() {
                for p in lattice() {
                    assert_eq!(passes([a, b], p), is_between(a, b, p), "{a:?} {b:?} {p:?}");
                }
            }
        }
    }

    #[test]
    fn segments_pass_what_one_of_their_points_rounds_to() {
        let assert_passes = |a: (f64, f64), b: (f64, f64), p: (f64, f64)| {
            for swap in [false, true] {
                let place = |(x, y)| Point::from(if swap { (y, x) } else { (x, y) });
                let [a, b, p] = [a, b, p].map(place);
                assert!(passes([a, b], p) && passes([b, a], p), "{a:?} {b:?} {p:?}");
            }
        };
        // Where y is 29/7, rounded, x is not quite 29.
        assert_ne!(29.0 / 7.0 * 7.0, 29.0);
        assert_passes((0.0, 0.0), (700.0, 100.0), (29.0, 29.0 / 7.0));
        // Steep: near its ends the abscissa is that of the end, rounded.
        let beside = 1.0_f64.next_up();
        assert_passes((1.0, 0.0), (beside, 1.0), (1.0, 0.25));
        assert_passes((1.0, 0.0), (beside, 1.0), (beside, 0.75));
        let outside = Point::new(beside, 1.25);
        assert!(!passes(
            [Point::new(1.0, 0.0), Point::new(beside, 1.0)],
            outside
        ));
    }
}
