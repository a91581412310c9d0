//! Arithmetic in which weights are computed: `f64`, and where that is not enough, twice as many bits.

use crate::Point;
use crate::predicates::Double;
use std::cmp::Ordering;

/// What the formulae of weights need to know about numbers.
pub(super) trait Number: Copy {
    const ZERO: Self;
    /// Whether there are bits to spare.
    const IS_WIDE: bool;
    /// Returns `a − b`.
    fn difference(a: f64, b: f64) -> Self;
    fn add(self, other: Self) -> Self;
    fn sub(self, other: Self) -> Self;
    fn mul(self, other: Self) -> Self;
    fn div(self, other: Self) -> Self;
    fn value(self) -> f64;
}

impl Number for f64 {
    const ZERO: Self = 0.0;
    const IS_WIDE: bool = false;

    #[inline(always)]
    fn difference(a: f64, b: f64) -> Self {
        a - b
    }

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self + other
    }

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self - other
    }

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self * other
    }

    #[inline(always)]
    fn div(self, other: Self) -> Self {
        self / other
    }

    #[inline(always)]
    fn value(self) -> f64 {
        self
    }
}

impl Number for Double {
    const ZERO: Self = Double {
        high: 0.0,
        low: 0.0,
    };
    const IS_WIDE: bool = true;

    fn difference(a: f64, b: f64) -> Self {
        Double::sum(a, -b)
    }

    fn add(self, other: Self) -> Self {
        self - Double {
            high: -other.high,
            low: -other.low,
        }
    }

    fn sub(self, other: Self) -> Self {
        self - other
    }

    fn mul(self, other: Self) -> Self {
        &self * &other
    }

    fn div(self, other: Self) -> Self {
        self / other
    }

    fn value(self) -> f64 {
        self.high
    }
}

/// A vector.
pub(super) type Vector<N> = [N; 2];

#[inline(always)]
pub(super) fn minus<N: Number>(a: Vector<N>, b: Vector<N>) -> Vector<N> {
    [a[0].sub(b[0]), a[1].sub(b[1])]
}

#[inline(always)]
pub(super) fn plus<N: Number>(a: Vector<N>, b: Vector<N>) -> Vector<N> {
    [a[0].add(b[0]), a[1].add(b[1])]
}

/// Twice the signed area between two vectors.
#[inline(always)]
pub(super) fn cross<N: Number>(a: Vector<N>, b: Vector<N>) -> N {
    a[0].mul(b[1]).sub(a[1].mul(b[0]))
}

/// As [`cross`], adding the magnitudes of the two products, which cancel, to `gross`.
#[inline(always)]
pub(super) fn cross_gross<N: Number>(a: Vector<N>, b: Vector<N>, gross: &mut f64) -> N {
    let (left, right) = (a[0].mul(b[1]), a[1].mul(b[0]));
    *gross += left.value().abs() + right.value().abs();
    left.sub(right)
}

#[inline(always)]
pub(super) fn dot<N: Number>(a: Vector<N>, b: Vector<N>) -> N {
    a[0].mul(b[0]).add(a[1].mul(b[1]))
}

/// The plane about a point, each axis scaled by a power of two, so that the differences at hand are
/// of the size of 1 and no product over- or underflows. Scaling is exact, except for what vanishes
/// beside the largest difference.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frame {
    pub scale: [f64; 2],
    /// The middle, scaled.
    middle: [f64; 2],
}

impl Frame {
    /// Makes a frame about `middle` in which the largest difference along each axis is about 1.
    pub fn by_axis(middle: Point, points: impl Iterator<Item = Point>) -> Self {
        let [x, y] = largest_halves(middle, points);
        Self::of(middle, [power_below(x), power_below(y)])
    }

    /// As [`by_axis`](Self::by_axis), with the same scale along both axes.
    pub fn alike(middle: Point, points: impl Iterator<Item = Point>) -> Self {
        let [x, y] = largest_halves(middle, points);
        Self::of(middle, [power_below(x.max(y)); 2])
    }

    fn of(middle: Point, scale: [f64; 2]) -> Self {
        let middle = [middle.x * scale[0], middle.y * scale[1]];
        Self { scale, middle }
    }

    /// Returns the scaled vector from `a` to `b`: more exact than the difference of their vectors, which
    /// are rounded.
    #[inline(always)]
    pub fn between<N: Number>(&self, a: Point, b: Point) -> Vector<N> {
        [
            N::difference(b.x * self.scale[0], a.x * self.scale[0]),
            N::difference(b.y * self.scale[1], a.y * self.scale[1]),
        ]
    }

    /// Returns the scaled vector from the middle to `p`.
    #[inline(always)]
    pub fn vector<N: Number>(&self, p: Point) -> Vector<N> {
        [
            N::difference(p.x * self.scale[0], self.middle[0]),
            N::difference(p.y * self.scale[1], self.middle[1]),
        ]
    }
}

/// Halves of the largest differences: whole ones may overflow.
#[inline]
fn largest_halves(middle: Point, points: impl Iterator<Item = Point>) -> [f64; 2] {
    points.fold([0.0; 2], |[x, y]: [f64; 2], p| {
        let half = |a: f64, b: f64| (a * 0.5 - b * 0.5).abs();
        [x.max(half(p.x, middle.x)), y.max(half(p.y, middle.y))]
    })
}

/// Returns the power of two whose product with `half` is from ½ to 1, as far as there is one.
#[inline]
fn power_below(half: f64) -> f64 {
    if half == 0.0 {
        return 1.0;
    }
    let exponent = (half.to_bits() >> 52) as i64 & 0x7ff;
    // Biased, and kept within the normal numbers.
    let inverse = (2 * 1023 - 1 - exponent).clamp(1, 2046);
    f64::from_bits((inverse as u64) << 52)
}

/// Tells how much of a point in a triangle belongs to each corner: at least 0, and 1 together, all
/// within some 10⁻¹³. A point beyond an edge counts as on it.
///
/// The shares are those of the areas of the three triangles between the point and the edges. Of a
/// triangle that is 2⁶⁰ times as long as wide, less wide than coordinates are exact, only two corners
/// count, between which the point is.
pub(super) fn shares(corners: [Point; 3], at: Point) -> [f64; 3] {
    shares_of_areas(corners, at, |area| area.max(0.0)).unwrap_or_else(|| shares_along(corners, at))
}

/// As [`shares`], but negative for corners whose opposite edge has the point beyond it. `None` if the triangle is
/// less than 2⁻⁶⁰ as large as what reaches from it to the point, or as wide as it is long.
pub(super) fn signed_shares(corners: [Point; 3], at: Point) -> Option<[f64; 3]> {
    shares_of_areas(corners, at, |area| area)
}

/// Returns shares by the areas, of each of which `part` counts.
fn shares_of_areas(corners: [Point; 3], at: Point, part: impl Fn(f64) -> f64) -> Option<[f64; 3]> {
    const LEAST: f64 = 1.0 / (1_u64 << 60) as f64;
    let frame = Frame::by_axis(at, corners.into_iter());
    let vectors: [Vector<f64>; 3] = corners.map(|c| frame.vector(c));
    let areas = areas(vectors).map(&part);
    let sum: f64 = areas.iter().sum();
    // The vectors are of the size of 1: so is what cancels in the areas.
    if sum > 0.03 {
        return Some(areas.map(|area| area / sum));
    }
    let areas = self::areas::<Double>(corners.map(|c| frame.vector(c))).map(&part);
    let sum: f64 = areas.iter().sum();
    (sum > LEAST).then(|| areas.map(|area| area / sum))
}

/// Returns shares of the two corners between which a point is, on a line as far as can be told.
fn shares_along(corners: [Point; 3], at: Point) -> [f64; 3] {
    let mut order = [0, 1, 2];
    order.sort_by(|&i, &j| corners[i].lex_cmp(&corners[j]));
    let [low, middle, high] = order;
    let [from, to] = match at.lex_cmp(&corners[middle]) {
        Ordering::Less => [low, middle],
        _ => [middle, high],
    };
    let share = share_along([corners[from], corners[to]], at);
    let mut shares = [0.0; 3];
    shares[from] = 1.0 - share;
    shares[to] = share;
    shares
}

fn areas<N: Number>([u, v, w]: [Vector<N>; 3]) -> [f64; 3] {
    [cross(v, w), cross(w, u), cross(u, v)].map(Number::value)
}

/// Tells how far a point on the segment from `a` to `b` is along it, from 0 to 1.
pub(super) fn share_along([a, b]: [Point; 2], at: Point) -> f64 {
    let half = |p: Point, q: Point| [q.x * 0.5 - p.x * 0.5, q.y * 0.5 - p.y * 0.5];
    let (whole, part) = (half(a, b), half(a, at));
    let axis = usize::from(whole[1].abs() > whole[0].abs());
    match whole[axis] {
        0.0 => 0.0,
        length => (part[axis] / length).clamp(0.0, 1.0),
    }
}

/// Returns the mean of values with the given weights, which sum to 1: never beyond the values.
#[inline]
pub(super) fn blend(values: impl Iterator<Item = (f64, f64)>) -> f64 {
    let (mut sum, mut low, mut high) = (0.0, f64::INFINITY, f64::NEG_INFINITY);
    for (weight, value) in values {
        sum += weight * value;
        low = low.min(value);
        high = high.max(value);
    }
    sum.clamp(low, high)
}

#[cfg(test)]
mod tests {
    use super::*;

    type Pair = (f64, f64);

    fn require(corners: [Pair; 3], at: Pair, expected: [f64; 3]) {
        let shares = shares(corners.map(Point::from), at.into());
        let is_near = |(a, b): (&f64, &f64)| (a - b).abs() < 1e-13;
        assert!(shares.iter().zip(&expected).all(is_near), "{shares:?}");
    }

    #[test]
    fn shares_are_barycentric_at_any_size() {
        let [o, x, y] = [(0.0, 0.0), (4.0, 0.0), (0.0, 4.0)];
        require([o, x, y], (1.0, 2.0), [0.25, 0.25, 0.5]);
        require([o, x, y], x, [0.0, 1.0, 0.0]);
        let huge = 1e308;
        let wide = [(-huge, -huge), (huge, -huge), (-huge, huge)];
        require(wide, (-huge, 0.0), [0.5, 0.0, 0.5]);
        let narrow = [o, (1e-300, 0.0), (0.0, 4e200)];
        require(narrow, (2.5e-301, 2e200), [0.25, 0.25, 0.5]);
        let tiny = [o, (4e-323, 0.0), (0.0, 4e-323)];
        require(tiny, (2e-323, 2e-323), [0.0, 0.5, 0.5]);
    }

    /// Far from the origin and a unit in the last place high: plain areas would be all noise.
    #[test]
    fn shares_of_slivers_are_right() {
        let (x, e) = (1e6, 1.0 / (1_u64 << 30) as f64);
        let corners = [(x, x), (x + 4.0, x + 4.0), (x + 2.0, x + 2.0 + e)];
        require(corners, (x + 2.0, x + 2.0 + e / 2.0), [0.25, 0.25, 0.5]);
        let flat = [
            (0.0, 0.0),
            (1e300, 1e300),
            (4e300, 4.000_000_000_000_001e300),
        ];
        require(flat, (1e299, 1e299), [0.9, 0.1, 0.0]);
        let line = [(0.0, 0.0), (4e307, 4e307), (1e-300, 0.0)];
        require(line, (1e307, 1e307), [0.0, 0.25, 0.75]);
    }

    #[test]
    fn signed_shares_go_beyond_the_edges() {
        let corners = [(1e6, 1e6), (1e6 + 1e-3, 1e6), (1e6, 1e6 + 1e-3)].map(Point::from);
        let [a, b, c] = signed_shares(corners, Point::new(1e6 + 4.0, 1e6 - 2.0)).expect("shares");
        let unit = 1e6 + 1e-3 - 1e6; // a thousandth as it is there
        let is_near = |found: f64, expected: f64| (found / expected - 1.0).abs() < 1e-12;
        assert!(is_near(b, 4.0 / unit) && is_near(c, -2.0 / unit));
        assert!(is_near(a, 1.0 - 2.0 / unit));
        assert_eq!(signed_shares(corners, Point::new(-1e30, 0.0)), None);
    }

    #[test]
    fn a_blend_stays_within_its_values() {
        let third = 1.0 / 3.0;
        assert_eq!(blend([(third, 0.1); 3].into_iter()), 0.1);
        assert_eq!(blend([(0.5, f64::MAX); 2].into_iter()), f64::MAX);
    }

    #[test]
    fn shares_along_segments() {
        let [a, b] = [(0.0, 0.0), (-1e308, 1.7e308)].map(Point::from);
        assert_eq!(share_along([a, b], Point::new(-5e307, 8.5e307)), 0.5);
        assert_eq!(share_along([a, a], a), 0.0);
        assert_eq!((share_along([a, b], a), share_along([a, b], b)), (0.0, 1.0));
    }
}
