//! Stage 1: plain `f64` arithmetic with an error bound; decides, or says that it cannot.
//!
//! Every function returns the sign of its polynomial, or `None` when the computed value is within
//! its error bound of zero. It never returns `Equal`, and never a wrong sign for finite input.
//!
//! # Why the bounds hold
//!
//! Let u = 2⁻⁵³. An operation without under- or overflow returns x with exact value x(1 + δ),
//! |δ| ≤ u; sums and differences of `f64` obey this even among subnormals. A product that underflows
//! errs by at most η = 2⁻¹⁰⁷⁵ on top.
//!
//! *Overflow* makes the bound infinite or NaN (each bound contains, in absolute value, everything
//! that the determinant sums up), no comparison with it is true, and the filter declines.
//!
//! *Underflow* would be silent. The two-vector predicates compare with `bound + FLOOR`: rounding is
//! monotone, so whoever passes has |det| > [`FLOOR`], hence a magnitude of at least `FLOOR`/2, and
//! the slack that each constant leaves (≥ 3u² of the magnitude, 2⁻¹⁰⁶⁶) is larger than the at most
//! four η that products contribute. The in-circle filter requires lifts above [`LIFT_FLOOR`]
//! instead; see [`in_circle`].

use super::Weighted;
use crate::Point;
use std::cmp::Ordering;

/// Bounds the error of orientation and dot product, relative to |l| + |r| for products l and r.
///
/// Each product has three roundings (two differences, one product), so the exact det is l − r up to
/// ((1 + u)³ − 1)(|l| + |r|). The last subtraction cannot change the sign, but it rounds, as do the
/// sum |l| + |r| and its product with the bound: 3u + 12u² + O(u³) suffices. The constant is
/// Shewchuk's `ccwerrboundA` (3 + 16u)u.
pub(crate) const ORIENT2D_BOUND: f64 = 3.3306690738754716e-16;

/// Bounds the error of the in-circle determinant, relative to S = al·bl + bl·cl + cl·al.
///
/// Let al, bl, cl be the squared lengths of a, b, c relative to the fourth point and
/// X = bx·cy − by·cx the cross product that belongs to al. Roundings that reach the term al·X: in al
/// four (differences, squares, sum), in X four, relative to |bx·cy| + |by·cx|, one in their product,
/// one in the first of the two sums of terms; the last sum cannot change the sign. By Cauchy
/// |bx·cy| + |by·cx| ≤ √(bl·cl), so the term errs by at most 10u·al·√(bl·cl), and by the inequality
/// of arithmetic and geometric means al·√(bl·cl) = √(al·bl)·√(al·cl) ≤ (al·bl + al·cl)/2. Over the
/// three terms that adds up to 10u·S = 1.1103e-15·S; terms of order u², the roundings of S and of
/// its product with the bound included, are far below the rest of the constant.
pub(crate) const IN_CIRCLE_BOUND: f64 = 1.12e-15;

/// Bounds the error of the power determinant, relative to al·(bs + cs) + bl·(cs + as) + cl·(as + bs),
/// where as, bs, cs are the squared lengths of a, b, c relative to the fourth point, and al, bl, cl
/// are these plus the magnitudes of the differences of weights.
///
/// As for [`IN_CIRCLE_BOUND`], with one rounding more: a lift is a squared length (four roundings)
/// plus a difference (one), and their sum is rounded, hence at most five, relative to al. With four in
/// the cross product, one in its product with the lift and one in the sum of two terms, the term errs
/// by at most 11u·al·√(bs·cs) ≤ 11u·al·(bs + cs)/2, and 11u/2 = 6.107e-16. The rest of the constant
/// is for terms of order u² and for the roundings of the bound itself.
const POWER_BOUND: f64 = 6.2e-16;

/// Bounds the error of the difference of two squared lengths, relative to their sum: four roundings
/// each (difference, square, sum), 4u = 4.441e-16, and 20u² for what follows.
const DISTANCE_BOUND: f64 = 4.5e-16;

/// Bounds the error of the difference of two powers, relative to the sum of squared lengths and the
/// difference of weights: four roundings in each squared length, one in the difference of weights and
/// one in that of the lengths, 5u = 5.551e-16, and 20u² for what follows.
const COMPARE_POWERS_BOUND: f64 = 5.6e-16;

/// Bounds the error of the difference of two heights, relative to their sum: each is the product of a
/// squared length (four roundings) and a difference (one), hence six roundings, 6u = 6.661e-16; one more,
/// and terms of order u², for what follows.
const PARABOLA_BOUND: f64 = 8e-16;

/// 2⁻⁹⁶⁰: determinants of two vectors below this are not trusted.
const FLOOR: f64 = f64::from_bits((1023 - 960) << 52);

/// 2⁻⁴⁰⁰: squared lengths below this are not trusted in the in-circle determinant.
const LIFT_FLOOR: f64 = f64::from_bits((1023 - 400) << 52);

/// Finds the sign of the cross product of `a − c` and `b − c`.
#[inline(always)]
pub(super) fn orient2d(a: Point, b: Point, c: Point) -> Option<Ordering> {
    let l = (a.x - c.x) * (b.y - c.y);
    let r = (a.y - c.y) * (b.x - c.x);
    certain(l - r, ORIENT2D_BOUND * (l.abs() + r.abs()) + FLOOR)
}

/// Finds the sign of the in-circle determinant, positive if `d` is inside the counter-clockwise
/// `abc`.
///
/// Underflow: with every lift above 2⁻⁴⁰⁰ a square that underflows changes its lift by less than
/// 2⁻⁶⁰⁰ of it; a product in a cross product errs by η, which times al is less than 2⁻⁶⁰⁰ of
/// al·bl ≤ S; S itself exceeds 2⁻⁸⁰⁰, so that its products do not underflow, and dwarfs the η of the
/// last three products. All this together is below u²·S, within the slack of the constant.
#[inline(always)]
pub(super) fn in_circle(a: Point, b: Point, c: Point, d: Point) -> Option<Ordering> {
    let [ax, ay] = [a.x - d.x, a.y - d.y];
    let [bx, by] = [b.x - d.x, b.y - d.y];
    let [cx, cy] = [c.x - d.x, c.y - d.y];
    let al = ax * ax + ay * ay;
    let bl = bx * bx + by * by;
    let cl = cx * cx + cy * cy;
    in_circle_relative(
        [al, bl, cl],
        [bx * cy - by * cx, cx * ay - cy * ax, ax * by - ay * bx],
    )
}

/// [`in_circle`] for callers who have the squared lengths of a, b, c relative to d, and the cross products
/// b × c, c × a, a × b.
#[inline(always)]
pub(crate) fn in_circle_relative(
    [al, bl, cl]: [f64; 3],
    [bc, ca, ab]: [f64; 3],
) -> Option<Ordering> {
    let det = al * bc + bl * ca + cl * ab;
    let bound = IN_CIRCLE_BOUND * (al * bl + bl * cl + cl * al);
    if al > LIFT_FLOOR && bl > LIFT_FLOOR && cl > LIFT_FLOOR {
        certain(det, bound)
    } else {
        None
    }
}

/// Finds the sign of the power determinant, positive if `d` is inside the circle of the
/// counter-clockwise `abc`.
///
/// Underflow: differences of weights have none, and with every squared length above 2⁻⁴⁰⁰ the rest
/// is as in [`in_circle`]: the terms of the bound exceed 2⁻⁸⁰⁰ and dwarf what products lose. Overflow:
/// a lift is at most al, and a cross product at most (bs + cs)/2, so no term overflows without its
/// share of the bound.
#[inline(always)]
pub(super) fn in_power_circle(
    a: Weighted,
    b: Weighted,
    c: Weighted,
    d: Weighted,
) -> Option<Ordering> {
    let arm = |s: Weighted| [s.point.x - d.point.x, s.point.y - d.point.y];
    let [[ax, ay], [bx, by], [cx, cy]] = [arm(a), arm(b), arm(c)];
    let [a_square, b_square, c_square] = [ax * ax + ay * ay, bx * bx + by * by, cx * cx + cy * cy];
    let [a_rise, b_rise, c_rise] = [a, b, c].map(|s| d.weight - s.weight);
    let det = (a_square + a_rise) * (bx * cy - by * cx)
        + (b_square + b_rise) * (cx * ay - cy * ax)
        + (c_square + c_rise) * (ax * by - ay * bx);
    let size = (a_square + a_rise.abs()) * (b_square + c_square)
        + (b_square + b_rise.abs()) * (c_square + a_square)
        + (c_square + c_rise.abs()) * (a_square + b_square);
    if a_square > LIFT_FLOOR && b_square > LIFT_FLOOR && c_square > LIFT_FLOOR {
        certain(det, POWER_BOUND * size)
    } else {
        None
    }
}

/// Compares the squared lengths of `a − p` and `b − p`.
#[inline(always)]
pub(super) fn compare_distances(p: Point, a: Point, b: Point) -> Option<Ordering> {
    compare_squares(squared_length([p, a]), squared_length([p, b]))
}

/// Returns the squared length of a segment: differences, squares and their sum are rounded.
#[inline(always)]
pub(crate) fn squared_length([a, b]: [Point; 2]) -> f64 {
    let [x, y] = [b.x - a.x, b.y - a.y];
    x * x + y * y
}

/// Compares two lengths by their [rounded squares](squared_length).
///
/// Whoever is certainly shorter than a segment is so, too, than one whose rounded square is larger:
/// every operation here is monotone.
#[inline(always)]
pub(crate) fn compare_squares(al: f64, bl: f64) -> Option<Ordering> {
    certain(al - bl, DISTANCE_BOUND * (al + bl) + FLOOR)
}

/// Compares the powers of `p` with respect to two sites.
#[inline(always)]
pub(super) fn compare_powers(p: Point, a: Weighted, b: Weighted) -> Option<Ordering> {
    let [al, bl] = [a, b].map(|site| squared_length([p, site.point]));
    let rise = b.weight - a.weight;
    let bound = COMPARE_POWERS_BOUND * (al + bl + rise.abs()) + FLOOR;
    certain(al - bl + rise, bound)
}

/// Compares the heights above `p` of the parabolas with foci `a` and `b` and the horizontal directrix
/// through `p`, which lies not above them.
///
/// Underflow: with squared lengths above 2⁻⁴⁰⁰ what squares lose does not count, and the two last
/// products lose less than what FLOOR leaves.
#[inline(always)]
pub(super) fn compare_parabolas(p: Point, a: Point, b: Point) -> Option<Ordering> {
    let [al, bl] = [a, b].map(|focus| squared_length([p, focus]));
    let [a_height, b_height] = [al * (b.y - p.y), bl * (a.y - p.y)];
    if al > LIFT_FLOOR && bl > LIFT_FLOOR {
        let bound = PARABOLA_BOUND * (a_height + b_height) + FLOOR;
        certain(a_height - b_height, bound)
    } else {
        None
    }
}

/// Finds the sign of the dot product of `a − p` and `b − p`.
#[inline(always)]
pub(super) fn diametral(a: Point, b: Point, p: Point) -> Option<Ordering> {
    let l = (a.x - p.x) * (b.x - p.x);
    let r = (a.y - p.y) * (b.y - p.y);
    certain(l + r, ORIENT2D_BOUND * (l.abs() + r.abs()) + FLOOR)
}

/// Finds the sign of the dot product of `b − a` and `q − p`.
#[inline(always)]
pub(super) fn towards([p, q]: [Point; 2], [a, b]: [Point; 2]) -> Option<Ordering> {
    let l = (q.x - p.x) * (b.x - a.x);
    let r = (q.y - p.y) * (b.y - a.y);
    certain(l + r, ORIENT2D_BOUND * (l.abs() + r.abs()) + FLOOR)
}

/// Finds the sign of the cross product of `q − p` and `b − a`.
#[inline(always)]
pub(super) fn turning([p, q]: [Point; 2], [a, b]: [Point; 2]) -> Option<Ordering> {
    let l = (q.x - p.x) * (b.y - a.y);
    let r = (q.y - p.y) * (b.x - a.x);
    certain(l - r, ORIENT2D_BOUND * (l.abs() + r.abs()) + FLOOR)
}

/// Reads the sign of `value` if it is farther from zero than `bound`.
#[inline(always)]
fn certain(value: f64, bound: f64) -> Option<Ordering> {
    if value > bound {
        Some(Ordering::Greater)
    } else if value < -bound {
        Some(Ordering::Less)
    } else {
        None
    }
}
