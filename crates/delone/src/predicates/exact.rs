//! Stage 3: big integers; decides every finite input, subnormals and 1e±300 mixtures included.
//!
//! Coordinates are scaled by the power of two that makes all of them integers. *Cost*: 0.2
//! (orient2d) to 0.8 µs (in_circle) where exponents are close, most of it allocations; at worst, over
//! the full exponent range, coordinates of 2,100 bits.

use super::Weighted;
use super::dyadic::Dyadic;
use super::polynomial::{cross, dot, in_circle_terms};
use super::quotient::{Root, root_of_quotient, saturated};
use crate::Point;
use num_bigint::{BigInt, Sign};
use std::cmp::Ordering;

/// Finds the sign of the cross product of `a − c` and `b − c`.
pub(super) fn orient2d(a: Point, b: Point, c: Point) -> Ordering {
    let [u, v] = vectors([a, b], c);
    sign(&cross(&u, &v))
}

/// Finds the sign of the in-circle determinant.
pub(super) fn in_circle(a: Point, b: Point, c: Point, d: Point) -> Ordering {
    let terms = in_circle_terms(&vectors([a, b, c], d));
    sign(&terms.into_iter().map(|[lift, cross]| lift * cross).sum())
}

/// Compares the squared lengths of `a − p` and `b − p`.
pub(super) fn compare_distances(p: Point, a: Point, b: Point) -> Ordering {
    let [u, v] = vectors([a, b], p);
    dot(&u, &u).cmp(&dot(&v, &v))
}

/// Tells whether `p` is at most `radius` away from the line through two points.
pub(super) fn line_is_near([a, b]: [Point; 2], radius: f64, p: Point) -> bool {
    let arm = [Point::default(), Point::new(radius, 0.0)];
    let [u, v, arm] = along([[a, b], [a, p], arm]).0;
    let cross = cross(&u, &v);
    &cross * &cross <= dot(&arm, &arm) * dot(&u, &u)
}

/// Tells whether the angle at the apex is less than the acute one whose cosine has the square `square`.
pub(super) fn is_sharper(apex: Point, sides: [Point; 2], square: f64) -> bool {
    let [u, v] = vectors(sides, apex);
    let along = dot(&u, &v);
    let square = Dyadic::new(square);
    // Below 1, so its exponent is negative.
    let unit = square.exponent.min(0);
    let scaled = square.in_units_of(unit) * dot(&u, &u) * dot(&v, &v);
    sign(&along) == Ordering::Greater && (&along * &along) << unit.unsigned_abs() > scaled
}

/// Compares the squared lengths of two segments.
pub(super) fn compare_lengths(s: [Point; 2], t: [Point; 2]) -> Ordering {
    let [u, v] = along([s, t]).0;
    dot(&u, &u).cmp(&dot(&v, &v))
}

/// Finds the sign of the dot product of `a − p` and `b − p`.
pub(super) fn diametral(a: Point, b: Point, p: Point) -> Ordering {
    let [u, v] = vectors([a, b], p);
    sign(&dot(&u, &v))
}

/// Finds the sign of the power determinant.
pub(super) fn in_power_circle(a: Weighted, b: Weighted, c: Weighted, d: Weighted) -> Ordering {
    let lifted = Lifted::new([a, b, c], d);
    let mut terms = in_circle_terms(&lifted.vectors);
    for ([lift, _], rise) in terms.iter_mut().zip(lifted.rises) {
        *lift += rise;
    }
    sign(&terms.into_iter().map(|[lift, cross]| lift * cross).sum())
}

/// Finds the sign of the power determinant on a line, where `a` is the lexicographically smaller end.
pub(super) fn in_power_segment(a: Weighted, b: Weighted, p: Weighted) -> Ordering {
    let Lifted {
        vectors: [u, v],
        rises: [u_rise, v_rise],
        ..
    } = Lifted::new([a, b], p);
    let along = usize::from(a.point.x == b.point.x);
    let [u_lift, v_lift] = [dot(&u, &u) + u_rise, dot(&v, &v) + v_rise];
    (u_lift * &v[along]).cmp(&(v_lift * &u[along]))
}

/// Finds the place of equal power with respect to three sites, correctly rounded; a coordinate beyond the
/// largest number becomes that number. `None` if the points are on one line.
///
/// With u and v the vectors from a to b and c, its vector z from a has 2u·z = |u|² + a's weight − b's
/// and 2v·z likewise.
pub(super) fn power_center([a, b, c]: [Weighted; 3]) -> Option<Point> {
    let Lifted {
        vectors: [u, v],
        rises: [u_rise, v_rise],
        unit,
    } = Lifted::new([b, c], a);
    let doubled_area: BigInt = cross(&u, &v) * 2;
    if doubled_area.sign() == Sign::NoSign {
        return None;
    }
    let [uu, vv] = [dot(&u, &u) + u_rise, dot(&v, &v) + v_rise];
    let numerators = [&v[1] * &uu - &u[1] * &vv, &u[0] * &vv - &v[0] * &uu];
    let origin = scaled(a.point, unit);
    let [x, y] = [0, 1].map(|k| {
        let product = &origin[k] * &doubled_area + &numerators[k];
        saturated(&product, &doubled_area, unit)
    });
    Some(Point::new(x, y))
}

/// Sites relative to one of them, on a common lattice.
struct Lifted<const K: usize> {
    vectors: [[BigInt; 2]; K],
    /// The weight of the origin less that of the site: what weights add to a squared length.
    rises: [BigInt; K],
    /// Vectors are in units of 2 to this power, rises in its square.
    unit: i32,
}

impl<const K: usize> Lifted<K> {
    /// Returns the power of the origin with respect to a site, the weight of the origin added.
    fn power(&self, site: usize) -> BigInt {
        let vector = &self.vectors[site];
        dot(vector, vector) + &self.rises[site]
    }

    fn new(sites: [Weighted; K], origin: Weighted) -> Self {
        let all = || sites.iter().chain([&origin]);
        let points = all().map(|s| common_unit(&[s.point]));
        let weights = all().map(|s| Dyadic::new(s.weight).exponent.div_euclid(2));
        // If all numbers are zero, any unit will do.
        let unit = points.chain(weights).fold(1024, i32::min);
        let weight = |s: Weighted| Dyadic::new(s.weight).in_units_of(2 * unit);
        let (place, level) = (scaled(origin.point, unit), weight(origin));
        Self {
            vectors: sites.map(|s| minus(&scaled(s.point, unit), &place)),
            rises: sites.map(|s| &level - weight(s)),
            unit,
        }
    }
}

/// Finds the length of a segment.
pub(super) fn length(ends: [Point; 2]) -> Root {
    let ([u], unit) = along([ends]);
    root_of_quotient(&dot(&u, &u), &BigInt::from(1), unit)
}

/// Finds the radius of the circle through three points; `None` if they are collinear.
pub(super) fn circumradius([a, b, c]: [Point; 3]) -> Option<Root> {
    let (sides, unit) = along([[a, b], [b, c], [c, a]]);
    let twice: BigInt = cross(&sides[0], &sides[1]) * 2;
    let squares = sides.map(|side| dot(&side, &side));
    let product = squares.into_iter().product();
    let is_circle = twice.sign() != Sign::NoSign;
    is_circle.then(|| root_of_quotient(&product, &(&twice * &twice), unit))
}

/// Compares the heights above `p` of two parabolas with foci `a` and `b` and the horizontal directrix
/// through `p`: |u|²/(2u.y) for the vector u from `p` to the focus, infinite for a focus beside `p`.
pub(super) fn compare_parabolas(p: Point, a: Point, b: Point) -> Ordering {
    let [u, v] = vectors([a, b], p);
    (dot(&u, &u) * &v[1]).cmp(&(dot(&v, &v) * &u[1]))
}

/// The lowest point of a circle, on a lattice: `(reach − √square) / scale`, the scale positive.
struct Bottom {
    reach: BigInt,
    square: BigInt,
    scale: BigInt,
}

impl Bottom {
    /// With u and v the vectors from a to b and c, and D = 2·(u × v), the center is a + N/D, where N.y is
    /// u.x·v² − v.x·u², and the radius √(|u|²·|v|²·|u − v|²)/|D|.
    fn new([a, b, c]: [Point; 3], unit: i32) -> Self {
        let [a, b, c] = [a, b, c].map(|p| scaled(p, unit));
        let [u, v, w] = [(&b, &a), (&c, &a), (&c, &b)].map(|(to, from)| minus(to, from));
        let [uu, vv, ww] = [&u, &v, &w].map(|side| dot(side, side));
        let doubled: BigInt = cross(&u, &v) * 2;
        let reach = &u[0] * &vv - &v[0] * &uu + &a[1] * &doubled;
        let is_reversed = doubled.sign() == Sign::Minus;
        let [reach, scale] = [reach, doubled].map(|n| if is_reversed { -n } else { n });
        Self {
            reach,
            square: uu * vv * ww,
            scale,
        }
    }
}

/// Compares the ordinates of the lowest points of two circles.
///
/// Multiplied by both scales, their difference is A + √B − √C with integers A, B and C.
pub(super) fn compare_bottoms(t: [Point; 3], u: [Point; 3]) -> Ordering {
    let unit = common_unit(&t).min(common_unit(&u));
    let [t, u] = [t, u].map(|corners| Bottom::new(corners, unit));
    let rational = &t.reach * &u.scale - &u.reach * &t.scale;
    let [plus, minus] = [(&u, &t), (&t, &u)].map(|(own, other)| &own.square * &other.scale.pow(2));
    sign_with_roots(&rational, &plus, &minus)
}

/// Compares the ordinate of the lowest point of a circle with that of `p`.
pub(super) fn compare_bottom(t: [Point; 3], p: Point) -> Ordering {
    let unit = common_unit(&t).min(common_unit(&[p]));
    let bottom = Bottom::new(t, unit);
    let [_, y] = scaled(p, unit);
    let above: BigInt = bottom.reach - y * bottom.scale;
    sign_with_roots(&above, &BigInt::ZERO, &bottom.square)
}

/// Finds the sign of a + √b − √c.
///
/// Where a and √b − √c disagree in sign, that of a² − (√b − √c)² = (a² − b − c) + √(4bc) decides.
fn sign_with_roots(a: &BigInt, b: &BigInt, c: &BigInt) -> Ordering {
    let (rational, roots) = (sign(a), b.cmp(c));
    if rational != roots.reverse() {
        return rational.then(roots);
    }
    let difference: BigInt = a.pow(2) - b - c;
    let product: BigInt = b * c * 4;
    let larger = match difference.sign() {
        Sign::Minus => product.cmp(&difference.pow(2)),
        Sign::NoSign | Sign::Plus => sign(&(difference + product)),
    };
    match rational {
        Ordering::Less => larger.reverse(),
        _ => larger,
    }
}

fn sign(value: &BigInt) -> Ordering {
    match value.sign() {
        Sign::Minus => Ordering::Less,
        Sign::NoSign => Ordering::Equal,
        Sign::Plus => Ordering::Greater,
    }
}

/// Finds where two lines that are not parallel meet, correctly rounded; a coordinate beyond the largest number
/// becomes that number.
pub(super) fn crossing([a, b]: [Point; 2], [c, d]: [Point; 2]) -> Point {
    let unit = common_unit(&[a, b, c, d]);
    let [a, b, c, d] = [a, b, c, d].map(|p| scaled(p, unit));
    let [along, other, between] = [[&b, &a], [&d, &c], [&c, &a]].map(|[to, from]| minus(to, from));
    let denominator = cross(&along, &other);
    let numerator = cross(&between, &other);
    let [x, y] = [0, 1].map(|k| {
        let product = &a[k] * &denominator + &along[k] * &numerator;
        saturated(&product, &denominator, unit)
    });
    Point::new(x, y)
}

/// Finds the sign of the dot product of the vectors along two segments.
pub(super) fn towards(way: [Point; 2], ends: [Point; 2]) -> Ordering {
    let [way, other] = along([way, ends]).0;
    sign(&dot(&way, &other))
}

/// Finds the sign of the cross product of the vectors along two segments.
pub(super) fn turning(way: [Point; 2], ends: [Point; 2]) -> Ordering {
    let [way, other] = along([way, ends]).0;
    sign(&cross(&way, &other))
}

/// Compares the powers of `p` with respect to two sites.
pub(super) fn compare_powers(p: Point, a: Weighted, b: Weighted) -> Ordering {
    let lifted = Lifted::new([a, b], Weighted::new(p, 0.0));
    lifted.power(0).cmp(&lifted.power(1))
}

/// Compares where a segment meets two bisectors, towards whose other sites it runs: where powers are
/// equal; without weights that is where distances are.
pub(super) fn compare_meetings([p, q]: [Point; 2], sites: [Weighted; 3]) -> Ordering {
    let [site, a, b] = sites;
    let [p, q] = [p, q].map(|p| Weighted::new(p, 0.0));
    let lifted = Lifted::new([site, a, b, q], p);
    let [site, _, _, along] = &lifted.vectors;
    let meeting = |other: usize| {
        let normal = minus(&lifted.vectors[other], site);
        (lifted.power(other) - lifted.power(0), dot(&normal, along))
    };
    let [(na, da), (nb, db)] = [meeting(1), meeting(2)];
    (na * db).cmp(&(nb * da))
}

/// Finds the point on the line of a segment that has equal powers with respect to two sites, correctly
/// rounded; a coordinate beyond the largest number becomes that number.
pub(super) fn bisector_place([p, q]: [Point; 2], a: Weighted, b: Weighted) -> Point {
    let [origin, q] = [p, q].map(|p| Weighted::new(p, 0.0));
    let lifted = Lifted::new([a, b, q], origin);
    let [a, b, along] = &lifted.vectors;
    let numerator = lifted.power(1) - lifted.power(0);
    let denominator: BigInt = dot(&minus(b, a), along) * 2;
    let p = scaled(p, lifted.unit);
    let [x, y] = [0, 1].map(|k| {
        let product = &p[k] * &denominator + &along[k] * &numerator;
        saturated(&product, &denominator, lifted.unit)
    });
    Point::new(x, y)
}

/// Finds twice the areas of the triangles that `p` makes with the edges opposite each corner, in a common unit,
/// positive if they turn counter-clockwise.
pub(super) fn areas(corners: [Point; 3], p: Point) -> [BigInt; 3] {
    let [a, b, c] = vectors(corners, p);
    [cross(&b, &c), cross(&c, &a), cross(&a, &b)]
}

/// Returns the sums of abscissas and of ordinates, each times its weight, in units of a power of two, and its
/// exponent.
pub(super) fn weighted_sum(points: [Point; 3], weights: &[BigInt; 3]) -> ([BigInt; 2], i32) {
    let unit = common_unit(&points).min(1024);
    let points = points.map(|p| scaled(p, unit));
    let terms = |k: usize| points.iter().zip(weights).map(move |(p, w)| &p[k] * w);
    ([terms(0).sum(), terms(1).sum()], unit)
}

/// Finds the vectors from `origin` to `points`, up to a common factor.
pub(super) fn vectors<const K: usize>(points: [Point; K], origin: Point) -> [[BigInt; 2]; K] {
    let unit = common_unit(&points).min(common_unit(&[origin]));
    let origin = scaled(origin, unit);
    points.map(|p| minus(&scaled(p, unit), &origin))
}

/// Finds the vectors from the first to the second end of `segments` in units of a power of two, and its
/// exponent.
fn along<const K: usize>(segments: [[Point; 2]; K]) -> ([[BigInt; 2]; K], i32) {
    let unit = common_unit(segments.as_flattened());
    let vectors = segments.map(|[from, to]| minus(&scaled(to, unit), &scaled(from, unit)));
    (vectors, unit)
}

/// Finds the exponent of a power of two that divides all coordinates.
fn common_unit(points: &[Point]) -> i32 {
    let coordinates = points.iter().flat_map(|p| [p.x, p.y]);
    let exponents = coordinates.map(|x| Dyadic::new(x).exponent);
    exponents.min().unwrap_or(i32::MAX)
}

fn scaled(p: Point, unit: i32) -> [BigInt; 2] {
    [p.x, p.y].map(|x| Dyadic::new(x).in_units_of(unit))
}

fn minus([ax, ay]: &[BigInt; 2], [bx, by]: &[BigInt; 2]) -> [BigInt; 2] {
    [ax - bx, ay - by]
}
