//! Stage 2: fixed-width integers; exact, no allocation, declines when they are too narrow.
//!
//! Near-degenerate input is rarely arbitrary: coordinates of one scale are multiples of one power of
//! two, and so are their differences. If all differences to one of the points, divided by that power
//! q, fit 62 bits (sign included), their polynomials fit 128 bits, and the in-circle determinant 256.
//! On lattices they mostly fit 31 bits, and 128 suffice for everything.
//!
//! Weights are in units of q²; to fit they must be multiples of it below 2¹²¹.
//!
//! *Cost*: in_circle about 15 ns on lattices, 35 ns otherwise; no branch but for width.
//!
//! *How a difference becomes an integer.* Its rounding error is a float again, so it is exactly
//! `head + tail` (Knuth's two-sum). Adding 1.5·2⁵²·s to a float rounds it to a multiple of s and
//! leaves the multiple in the low bits. With M the power of two below the largest head, `high` is
//! the multiple of s = M·2⁻²⁹, and what is left of head, and tail, must be multiples of q = M·2⁻⁶⁰.
//! Additions never underflow, so this holds for subnormals too.

use super::Weighted;
use super::dyadic::Dyadic;
use super::polynomial::{cross, dot, in_circle_terms};
use super::quotient::Root;
use crate::Point;
use std::cmp::Ordering;

/// Finds the sign of the cross product of `a − c` and `b − c`.
#[inline(always)]
pub(super) fn orient2d(a: Point, b: Point, c: Point) -> Option<Ordering> {
    let [u, v] = Vectors::new([a, b], c)?.wide();
    Some(cross(&u, &v).cmp(&0))
}

/// Finds the sign of the in-circle determinant.
#[inline(always)]
pub(super) fn in_circle(a: Point, b: Point, c: Point, d: Point) -> Option<Ordering> {
    let vectors = Vectors::new([a, b, c], d)?;
    Some(if vectors.narrow {
        // 30-bit magnitudes: lifts and cross products fit 61 bits, their products 122.
        let terms = in_circle_terms(&vectors.coordinates);
        let products = terms.map(|[lift, cross]| i128::from(lift) * i128::from(cross));
        products.iter().sum::<i128>().cmp(&0)
    } else {
        sign_of_sum(in_circle_terms(&vectors.wide()))
    })
}

/// Finds the sign of the power determinant.
#[inline(always)]
pub(super) fn in_power_circle(
    a: Weighted,
    b: Weighted,
    c: Weighted,
    d: Weighted,
) -> Option<Ordering> {
    let (vectors, rises) = lifted([a, b, c], d)?;
    let mut terms = in_circle_terms(&vectors);
    for ([lift, _], rise) in terms.iter_mut().zip(rises) {
        *lift += rise;
    }
    Some(sign_of_sum(terms))
}

/// Finds the sign of the power determinant on a line: with weights lifted, that of how far `p` lies
/// below the line through `a` and `b`, `a` being the lexicographically smaller one.
#[inline(always)]
pub(super) fn in_power_segment(a: Weighted, b: Weighted, p: Weighted) -> Option<Ordering> {
    let ([u, v], [u_rise, v_rise]) = lifted([a, b], p)?;
    let along = usize::from(a.point.x == b.point.x);
    let [u_lift, v_lift] = [dot(&u, &u) + u_rise, dot(&v, &v) + v_rise];
    Some(sign_of_sum([
        [u_lift, v[along]],
        [-v_lift, u[along]],
        [0, 0],
    ]))
}

/// Vectors on a common lattice, magnitudes at most 2⁶¹, and what weights add to the squared length of
/// each, magnitudes below 2¹²²; if that fits. On the fine lattice more weights are integers, on the
/// coarse one larger ones fit.
#[inline(always)]
fn lifted<const K: usize>(
    sites: [Weighted; K],
    origin: Weighted,
) -> Option<([[i128; 2]; K], [i128; K])> {
    let vectors = Vectors::new(sites.map(|s| s.point), origin.point)?;
    let wide = vectors.wide();
    if let Some(rises) = rises(sites, origin, 2 * vectors.unit) {
        return Some((wide, rises));
    }
    if !vectors.narrow {
        return None;
    }
    let refined = wide.map(|v| v.map(|c| c << REFINEMENT));
    let unit = vectors.unit - REFINEMENT.cast_signed();
    Some((refined, rises(sites, origin, 2 * unit)?))
}

/// How much less the sites weigh than the origin, in units of 2^`unit`, if that fits.
#[inline(always)]
fn rises<const K: usize>(sites: [Weighted; K], origin: Weighted, unit: i32) -> Option<[i128; K]> {
    let origin = Dyadic::new(origin.weight).fixed(unit)?;
    let mut rises = [0; K];
    for (rise, site) in rises.iter_mut().zip(sites) {
        *rise = origin - Dyadic::new(site.weight).fixed(unit)?;
    }
    Some(rises)
}

/// Compares the squared lengths of `a − p` and `b − p`.
#[inline(always)]
pub(super) fn compare_distances(p: Point, a: Point, b: Point) -> Option<Ordering> {
    let [u, v] = Vectors::new([a, b], p)?.wide();
    Some(dot(&u, &u).cmp(&dot(&v, &v)))
}

/// Compares the squared lengths of two segments.
#[inline(always)]
pub(super) fn compare_lengths(s: [Point; 2], t: [Point; 2]) -> Option<Ordering> {
    let [u, v] = Vectors::along([s, t])?.wide();
    Some(dot(&u, &u).cmp(&dot(&v, &v)))
}

/// Finds the sign of the dot product of `a − p` and `b − p`.
#[inline(always)]
pub(super) fn diametral(a: Point, b: Point, p: Point) -> Option<Ordering> {
    let [u, v] = Vectors::new([a, b], p)?.wide();
    Some(dot(&u, &v).cmp(&0))
}

/// Finds the length of a segment.
#[inline(always)]
pub(super) fn length(ends: [Point; 2]) -> Option<Root> {
    let vectors = Vectors::along([ends])?;
    let [u] = vectors.wide();
    let square = dot(&u, &u).cast_unsigned();
    let shift = (square.leading_zeros() & !1).min(126);
    Root::of(
        square << shift,
        true,
        2 * vectors.unit - shift.cast_signed(),
    )
}

/// Finds the radius of the circle through three points, `Some(None)` if they are collinear. They must lie
/// on a coarse lattice: the product of the squared sides must fit 128 bits, and its quotient by the squared
/// area must leave enough of them.
#[inline(always)]
pub(super) fn circumradius([a, b, c]: [Point; 3]) -> Option<Option<Root>> {
    let vectors = Vectors::along([[a, b], [b, c], [c, a]])?;
    let zeros = vectors.coordinates.as_flattened().iter();
    let zeros = zeros.fold(0, |all, c| all | c).trailing_zeros();
    let sides = vectors.wide().map(|side| side.map(|c| c >> zeros));
    let twice = (2 * cross(&sides[0], &sides[1])).unsigned_abs();
    if twice == 0 {
        return Some(None);
    }
    let squares = sides.map(|side| dot(&side, &side).cast_unsigned());
    let product = squares[0]
        .checked_mul(squares[1])?
        .checked_mul(squares[2])?;
    let shift = product.leading_zeros() & !1;
    let (numerator, divisor) = (product << shift, twice.checked_mul(twice)?);
    let quotient = numerator / divisor;
    let is_exact = quotient * divisor == numerator;
    let unit = vectors.unit + zeros.cast_signed();
    Root::of(quotient, is_exact, 2 * unit - shift.cast_signed()).map(Some)
}

/// Vectors on a common lattice, magnitudes at most 2⁶¹.
struct Vectors<const K: usize> {
    coordinates: [[i64; 2]; K],
    /// Whether magnitudes are at most 2³⁰.
    narrow: bool,
    /// Coordinates are in units of 2 to this power.
    unit: i32,
}

impl<const K: usize> Vectors<K> {
    /// Finds the vectors from `origin` to `points`, up to a common factor, if they fit.
    #[inline(always)]
    fn new(points: [Point; K], origin: Point) -> Option<Self> {
        Self::along(points.map(|p| [origin, p]))
    }

    /// Finds the vectors from the first to the second end of `segments`, up to a common factor, if they
    /// fit.
    #[inline(always)]
    fn along(segments: [[Point; 2]; K]) -> Option<Self> {
        let heads = segments.map(|[from, to]| [to.x - from.x, to.y - from.y]);
        let coarse = Lattice::for_largest(largest_magnitude(&heads))?;
        let parts: [[Parts; 2]; K] = std::array::from_fn(|i| {
            let ([from, to], [x, y]) = (segments[i], heads[i]);
            [
                Parts::new(coarse, x, tail(to.x, from.x, x)),
                Parts::new(coarse, y, tail(to.y, from.y, y)),
            ]
        });
        // Bitwise `&` instead of `all`: one branch, not one for each coordinate.
        let narrow = parts
            .as_flattened()
            .iter()
            .fold(true, |all, part| all & part.is_coarse());
        if narrow {
            let coordinates = parts.map(|v| v.map(|part| part.high));
            return Some(Self {
                coordinates,
                narrow,
                unit: coarse.unit(),
            });
        }
        let fine = coarse.refined();
        let mut fits = true;
        let coordinates = parts.map(|v| v.map(|part| part.refine(fine, &mut fits)));
        fits.then_some(Self {
            coordinates,
            narrow,
            unit: fine.unit(),
        })
    }

    /// Widens the coordinates, so that sums of two products fit.
    #[inline(always)]
    fn wide(&self) -> [[i128; 2]; K] {
        self.coordinates.map(|v| v.map(i128::from))
    }
}

/// An exact difference: a multiple of the coarse lattice's spacing and two small remainders.
struct Parts {
    high: i64,
    rest: f64,
    tail: f64,
}

impl Parts {
    #[inline(always)]
    fn new(coarse: Lattice, head: f64, tail: f64) -> Self {
        let nearest = coarse.nearest(head);
        Self {
            high: nearest.multiple,
            rest: head - nearest.value,
            tail,
        }
    }

    /// Tells whether the difference lies on the coarse lattice.
    #[inline(always)]
    fn is_coarse(&self) -> bool {
        (self.rest == 0.0) & (self.tail == 0.0)
    }

    /// Returns the multiple of the fine lattice's spacing, and clears `fits` if there is none.
    #[inline(always)]
    fn refine(&self, fine: Lattice, fits: &mut bool) -> i64 {
        let [rest, tail] = [self.rest, self.tail].map(|x| fine.nearest(x));
        *fits &= (rest.value == self.rest) & (tail.value == self.tail);
        (self.high << REFINEMENT) + rest.multiple + tail.multiple
    }
}

/// Bits by which the fine lattice is finer than the coarse one.
const REFINEMENT: u32 = 31;

/// The multiples of a power of two s, represented by 1.5·2⁵²·s, whose unit in the last place is s.
#[derive(Clone, Copy)]
struct Lattice {
    anchor: f64,
}

/// The point of a lattice nearest to some number.
struct Nearest {
    value: f64,
    /// `value` divided by the spacing of the lattice.
    multiple: i64,
}

impl Lattice {
    /// Makes the lattice on which numbers up to `largest` are multiples below 2³⁰.
    ///
    /// `None` near the ends of the exponent range (infinity included), where an anchor might not be
    /// a normal number.
    #[inline(always)]
    fn for_largest(largest: f64) -> Option<Self> {
        let is_zero = largest == 0.0;
        let exponent = if is_zero {
            1023
        } else {
            largest.to_bits() >> 52
        };
        (64..=2000)
            .contains(&exponent)
            .then(|| Self::anchored(exponent + 52 - 29))
    }

    /// The exponent of the spacing, which is the unit in the last place of the anchor.
    #[inline(always)]
    fn unit(self) -> i32 {
        (self.anchor.to_bits() >> 52) as i32 - 1075
    }

    /// Makes the lattice that is 2³¹ times finer.
    #[inline(always)]
    fn refined(self) -> Self {
        Self::anchored((self.anchor.to_bits() >> 52) - u64::from(REFINEMENT))
    }

    #[inline(always)]
    fn anchored(exponent: u64) -> Self {
        let anchor = f64::from_bits((exponent << 52) | (1 << 51));
        Self { anchor }
    }

    /// Rounds `x`, which is less than 2⁵¹ spacings from zero, to the lattice.
    #[inline(always)]
    fn nearest(self, x: f64) -> Nearest {
        let shifted = x + self.anchor;
        Nearest {
            value: shifted - self.anchor,
            multiple: shifted.to_bits().cast_signed() - self.anchor.to_bits().cast_signed(),
        }
    }
}

/// Returns the largest absolute value, by way of that of each column: two lanes of a register.
#[inline(always)]
fn largest_magnitude(vectors: &[[f64; 2]]) -> f64 {
    let larger = |m: f64, n: f64| if n > m { n } else { m };
    let [x, y] = vectors.iter().fold([0.0; 2], |[mx, my], [x, y]| {
        [larger(mx, x.abs()), larger(my, y.abs())]
    });
    larger(x, y)
}

/// Returns what `head`, the rounded `a − b`, lacks: `a − b − head`, exactly.
#[inline(always)]
fn tail(a: f64, b: f64, head: f64) -> f64 {
    let b_virtual = a - head;
    let a_virtual = head + b_virtual;
    (a - a_virtual) + (b_virtual - b)
}

/// Finds the sign of the sum of three products in 256 bits.
///
/// Factors are at most 2¹²⁴ in magnitude (2¹²³ without weights), so with a = a₁·2⁶⁴ + a₀ each column
/// of partial products fits 128 bits: |a₁| ≤ 2⁶⁰, and six times 2⁶⁰·2⁶⁴ stays below 2¹²⁷.
#[inline(always)]
fn sign_of_sum(products: [[i128; 2]; 3]) -> Ordering {
    let (mut top, mut middle, mut bottom) = (0_i128, 0_i128, 0_u128);
    for [a, b] in products {
        let [(a1, a0), (b1, b0)] = [a, b].map(split);
        let low = u128::from(a0) * u128::from(b0);
        bottom += u128::from(low as u64);
        middle += i128::from(a1) * i128::from(b0) + i128::from(b1) * i128::from(a0);
        middle += (low >> 64).cast_signed();
        top += i128::from(a1) * i128::from(b1);
    }
    middle += (bottom >> 64).cast_signed();
    top += middle >> 64;
    let is_rest_zero = (middle as u64 | bottom as u64) == 0;
    top.cmp(&0).then(if is_rest_zero {
        Ordering::Equal
    } else {
        Ordering::Greater
    })
}

/// Splits into a signed high and an unsigned low half.
#[inline(always)]
fn split(x: i128) -> (i64, u64) {
    ((x >> 64) as i64, x as u64)
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_bigint::BigInt;

    /// All carries and borrows, on factors around powers of two up to the largest allowed.
    #[test]
    fn sign_of_sum_agrees_with_big_integers() {
        let factors: Vec<i128> = [0, 1, 63, 64, 65, 122, 124]
            .iter()
            .flat_map(|&bits| {
                let power = 1_i128 << bits;
                let inner = (power - 1).max(1);
                [power, -power, inner, -inner]
            })
            .collect();
        let products: Vec<[i128; 2]> = factors
            .iter()
            .flat_map(|&a| factors.iter().map(move |&b| [a, b]))
            .collect();
        let zero = BigInt::ZERO;
        for (i, &p) in products.iter().enumerate() {
            for (j, &q) in products.iter().enumerate() {
                let r = products[(i * 31 + j * 17) % products.len()];
                let sum: BigInt = [p, q, r].map(|[a, b]| BigInt::from(a) * b).iter().sum();
                assert_eq!(sign_of_sum([p, q, r]), sum.cmp(&zero), "{p:?} {q:?} {r:?}");
            }
        }
    }
}
