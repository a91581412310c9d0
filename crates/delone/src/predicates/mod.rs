//! The signs on which all topology rests: exact for every finite `f64`.

use crate::Point;
use num_bigint::BigInt;
use std::cmp::Ordering;

/// Where a point lies relative to a directed line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Orientation {
    /// To the left: the three points turn counter-clockwise.
    Left,
    /// To the right: the three points turn clockwise.
    Right,
    /// On the line.
    Collinear,
}

/// Where a point lies relative to a circle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum CircleSide {
    /// Strictly inside.
    Inside,
    /// On the circle.
    On,
    /// Strictly outside.
    Outside,
}

/// Tells where `c` lies relative to the line from `a` to `b`.
pub fn orient2d(a: Point, b: Point, c: Point) -> Orientation {
    let [ax, ay, bx, by, cx, cy] = [a.x, a.y, b.x, b.y, c.x, c.y].map(big);
    let det = (&bx - &ax) * (&cy - &ay) - (&by - &ay) * (&cx - &ax);
    match det.sign() {
        num_bigint::Sign::Plus => Orientation::Left,
        num_bigint::Sign::Minus => Orientation::Right,
        num_bigint::Sign::NoSign => Orientation::Collinear,
    }
}

/// Tells where `d` lies relative to the circle through `a`, `b`, `c`, which turn counter-clockwise.
pub fn in_circle(a: Point, b: Point, c: Point, d: Point) -> CircleSide {
    let row = |p: Point| {
        let x = big(p.x) - big(d.x);
        let y = big(p.y) - big(d.y);
        let lift = &x * &x + &y * &y;
        (x, y, lift)
    };
    let ((ax, ay, al), (bx, by, bl), (cx, cy, cl)) = (row(a), row(b), row(c));
    let det =
        al * (&bx * &cy - &by * &cx) + bl * (&cx * &ay - &cy * &ax) + cl * (&ax * &by - &ay * &bx);
    match det.sign() {
        num_bigint::Sign::Plus => CircleSide::Inside,
        num_bigint::Sign::Minus => CircleSide::Outside,
        num_bigint::Sign::NoSign => CircleSide::On,
    }
}

/// Tells whether `d` lies inside the circle through `a`, `b`, `c` (counter-clockwise) under the
/// symbolic perturbation; never undecided for four distinct points.
pub fn in_circle_perturbed(a: Point, b: Point, c: Point, d: Point) -> bool {
    match in_circle(a, b, c, d) {
        CircleSide::Inside => true,
        CircleSide::Outside => false,
        CircleSide::On => perturbed(a, b, c, d),
    }
}

fn perturbed(a: Point, b: Point, c: Point, d: Point) -> bool {
    let largest = [a, b, c, d]
        .into_iter()
        .max_by(Point::lex_cmp)
        .expect("four points");
    let decisive = if largest == d {
        return false;
    } else if largest == c {
        orient2d(a, b, d)
    } else if largest == b {
        orient2d(a, d, c)
    } else {
        orient2d(d, b, c)
    };
    decisive == Orientation::Left
}

pub(crate) const ORIENT2D_BOUND: f64 = 3.3306690738754716e-16;
pub(crate) const IN_CIRCLE_BOUND: f64 = 1.12e-15;

pub(crate) fn orient2d_exact(a: Point, b: Point, c: Point) -> Orientation {
    orient2d(a, b, c)
}

pub(crate) fn in_circle_perturbed_exact(a: Point, b: Point, c: Point, d: Point) -> bool {
    in_circle_perturbed(a, b, c, d)
}

/// Compares the distances from `p` to `a` and to `b`.
pub fn compare_distances(p: Point, a: Point, b: Point) -> Ordering {
    let square = |q: Point| {
        let x = big(q.x) - big(p.x);
        let y = big(q.y) - big(p.y);
        &x * &x + &y * &y
    };
    square(a).cmp(&square(b))
}

/// Tells where `p` lies relative to the circle with diameter `ab`.
pub fn in_diametral_circle(a: Point, b: Point, p: Point) -> CircleSide {
    let dot = (big(a.x) - big(p.x)) * (big(b.x) - big(p.x))
        + (big(a.y) - big(p.y)) * (big(b.y) - big(p.y));
    match dot.sign() {
        num_bigint::Sign::Minus => CircleSide::Inside,
        num_bigint::Sign::Plus => CircleSide::Outside,
        num_bigint::Sign::NoSign => CircleSide::On,
    }
}

/// The integer `value · 2¹⁰⁷⁴`.
fn big(value: f64) -> BigInt {
    let bits = value.to_bits();
    let exponent = ((bits >> 52) & 0x7ff) as u32;
    let fraction = bits & ((1 << 52) - 1);
    let mantissa = if exponent == 0 {
        fraction
    } else {
        fraction | (1 << 52)
    };
    let magnitude = BigInt::from(mantissa) << exponent.saturating_sub(1);
    if value < 0.0 { -magnitude } else { magnitude }
}
