//! Stage 3: big integers; decides every finite input, subnormals and 1e±300 mixtures included.
//!
//! Coordinates are scaled by the power of two that makes all of them integers. *Cost*: 0.2
//! (orient2d) to 0.8 µs (in_circle) where exponents are close, most of it allocations; at worst, over
//! the full exponent range, coordinates of 2,100 bits.

use super::polynomial::{cross, dot, in_circle_terms};
use super::quotient::rounded;
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

/// Compares the squared length of `p − center` with the square of `radius`.
pub(super) fn in_disc(center: Point, radius: f64, p: Point) -> Ordering {
    let radius = Point::new(radius, 0.0);
    let unit = common_unit(&[p, center, radius]);
    let [p, center, radius] = [p, center, radius].map(|q| scaled(q, unit));
    let arm = minus(&p, &center);
    dot(&arm, &arm).cmp(&dot(&radius, &radius))
}

/// Finds the sign of the dot product of `a − p` and `b − p`.
pub(super) fn diametral(a: Point, b: Point, p: Point) -> Ordering {
    let [u, v] = vectors([a, b], p);
    sign(&dot(&u, &v))
}

fn sign(value: &BigInt) -> Ordering {
    match value.sign() {
        Sign::Minus => Ordering::Less,
        Sign::NoSign => Ordering::Equal,
        Sign::Plus => Ordering::Greater,
    }
}

/// Finds where two segments that cross properly meet, correctly rounded.
pub(super) fn crossing([a, b]: [Point; 2], [c, d]: [Point; 2]) -> Point {
    let unit = common_unit(&[a, b, c, d]);
    let [a, b, c, d] = [a, b, c, d].map(|p| scaled(p, unit));
    let [along, other, between] = [[&b, &a], [&d, &c], [&c, &a]].map(|[to, from]| minus(to, from));
    let denominator = cross(&along, &other);
    let numerator = cross(&between, &other);
    let [x, y] = [0, 1].map(|k| {
        let product = &a[k] * &denominator + &along[k] * &numerator;
        rounded(&product, &denominator, unit)
    });
    Point::new(x, y)
}

/// Finds the vectors from `origin` to `points`, up to a common factor.
fn vectors<const K: usize>(points: [Point; K], origin: Point) -> [[BigInt; 2]; K] {
    let unit = common_unit(&points).min(common_unit(&[origin]));
    let origin = scaled(origin, unit);
    points.map(|p| minus(&scaled(p, unit), &origin))
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

/// The number `mantissa · 2^exponent`, the mantissa odd unless the number is zero.
struct Dyadic {
    mantissa: i64,
    exponent: i32,
}

impl Dyadic {
    /// Takes a finite number apart.
    fn new(value: f64) -> Self {
        let bits = value.to_bits();
        let biased = (bits >> 52 & 0x7ff) as i32;
        let fraction = (bits & ((1 << 52) - 1)) as i64;
        let magnitude = fraction | i64::from(biased != 0) << 52;
        if magnitude == 0 {
            // No power of two is too coarse for zero.
            return Self {
                mantissa: 0,
                exponent: i32::MAX,
            };
        }
        let zeros = magnitude.trailing_zeros();
        let odd = magnitude >> zeros;
        Self {
            mantissa: if value < 0.0 { -odd } else { odd },
            exponent: biased.max(1) - 1075 + zeros.cast_signed(),
        }
    }

    /// Divides by 2^`unit`, which divides the number.
    fn in_units_of(&self, unit: i32) -> BigInt {
        if self.mantissa == 0 {
            return BigInt::ZERO;
        }
        BigInt::from(self.mantissa) << (self.exponent - unit)
    }
}
