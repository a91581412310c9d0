//! The center of the circle through three points, and the place of equal power with respect to three
//! points with weights: each coordinate correctly rounded, to nearest, ties to even.
//!
//! With u = b − a, v = c − a and D = 2·(u × v) it is a + N/D, where N = (v.y·u² − u.y·v²,
//! u.x·v² − v.x·u²); weights add to u² that of a less that of b, and to v² likewise. As for [crossings](super::crossing), stage 1 computes this in [`Double`]s with an
//! error bound, and big integers decide where candidates round apart.
//!
//! *Cost*: 80 to 100 ns in stage 1, 2 to 3 µs in big integers.

use super::Weighted;
use super::crossing::{certain, is_ordinary, power_of_two, vector};
use super::double::Double;
use super::exact;
use super::polynomial::{cross, dot};
use crate::Point;

/// Bounds the error of a coordinate a + N/D, relative to (|N|₊/|D|)·(|D|₊/|D|) + |a + N/D|, where
/// |·|₊ is the sum of the two terms' magnitudes.
///
/// Squared lengths err by at most 10.1u² of themselves, with weights by 13.2u² of the sum of magnitudes,
/// which then counts in |N|₊; terms of N by 20.3u², N by 24u²·|N|₊, and D by 10.1u²·|D|₊. That |D|₊/|D| is below 2⁵⁰ is checked, so dividing adds 10.1u²·(|N|₊/|D|)·(|D|₊/|D|) and
/// 32u² of the quotient, and the sum 2u² of the result. All this is below 70u²; 128u² = 2⁻⁹⁹ leaves room
/// for the roundings of the bound itself.
const BOUND: f64 = power_of_two(-99);

/// What underflow may add: differences are multiples of 2⁻²⁵² up to 2²⁵¹, so N is a multiple of 2⁻⁷⁵⁶
/// below 2⁷⁵⁶ and D, unless zero, at least 2⁻⁵⁰³: only quotients can underflow, by less than 2⁻¹⁰⁷⁰.
/// Weights of the same class are multiples of 2⁻²⁵² up to 2²⁵⁰ and change nothing of that.
const FLOOR: f64 = power_of_two(-700);

/// Finds the center, if the points are not on one line; a coordinate beyond the largest number becomes
/// that number.
pub(super) fn circumcenter([a, b, c]: [Point; 3]) -> Option<Point> {
    let unweighted = || exact::power_center([a, b, c].map(|p| Weighted::new(p, 0.0)));
    together(filtered([a, b, c], None)).or_else(unweighted)
}

/// Finds the place of equal power, as [`circumcenter`] does.
pub(super) fn power_center(sites: [Weighted; 3]) -> Option<Point> {
    let [a, b, c] = sites.map(|s| s.weight);
    let rises = || [Double::sum(a, -b), Double::sum(a, -c)];
    let is_filtered = [a, b, c].into_iter().all(is_ordinary);
    let center = is_filtered.then(|| filtered(sites.map(|s| s.point), Some(rises())));
    center
        .and_then(together)
        .or_else(|| exact::power_center(sites))
}

fn together(center: [Option<f64>; 2]) -> Option<Point> {
    let [x, y] = center;
    // Adding zero turns −0.0 into 0.0.
    Some(Point::new(x? + 0.0, y? + 0.0))
}

/// Stage 1: the coordinates of which the rounding is certain. `rises` is what weights add to the squared
/// lengths.
fn filtered(points @ [a, b, c]: [Point; 3], rises: Option<[Double; 2]>) -> [Option<f64>; 2] {
    let mut coordinates = points.iter().flat_map(|p| [p.x, p.y]);
    if !coordinates.all(is_ordinary) {
        return [None; 2];
    }
    let [u, v] = [vector(a, b), vector(a, c)];
    let area = cross(&u, &v);
    let size = (u[0].high * v[1].high).abs() + (u[1].high * v[0].high).abs();
    let ratio = size / area.high.abs();
    // A NaN, as of equal points, does not compare.
    if ratio.is_nan() || ratio >= power_of_two(50) {
        return [None; 2];
    }
    let squares = [dot(&u, &u), dot(&v, &v)];
    let [uu, vv] = [0, 1].map(|k| Lift::new(squares[k], rises.map(|r| r[k])));
    let doubled = Double {
        high: 2.0 * area.high,
        low: 2.0 * area.low,
    };
    let place = |origin: f64, (p, pp): (&Double, &Lift), (q, qq): (&Double, &Lift)| {
        let numerator = p * &pp.value - q * &qq.value;
        let size = p.high.abs() * pp.size + q.high.abs() * qq.size;
        let reach = size / doubled.high.abs() * ratio;
        let center = numerator / doubled + origin;
        certain(center, |x| BOUND * (reach + x) + FLOOR).filter(|x| x.is_finite())
    };
    [
        place(a.x, (&v[1], &uu), (&u[1], &vv)),
        place(a.y, (&u[0], &vv), (&v[0], &uu)),
    ]
}

/// A squared length and what weights add to it, and the sum of the magnitudes of the two.
struct Lift {
    value: Double,
    size: f64,
}

impl Lift {
    #[inline(always)]
    fn new(square: Double, rise: Option<Double>) -> Self {
        let size = square.high;
        match rise {
            Some(rise) => Self {
                value: square + rise,
                size: size + rise.high.abs(),
            },
            None => Self {
                value: square,
                size,
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_stages_agree_where_the_first_is_certain() {
        let mut bits = 88_172_645_463_325_252_u64;
        let mut next = || {
            bits ^= bits << 13;
            bits ^= bits >> 7;
            bits ^= bits << 17;
            (bits >> 11) as f64 / (1_u64 << 53) as f64
        };
        let mut certain = 0;
        for round in 0..2000 {
            // From well-shaped triangles to slivers.
            let flatness = [1.0, 1e-3, 1e-9, 1e-14][round % 4];
            let triangle = [(); 3].map(|()| Point::new(next(), 0.25 + flatness * next()));
            // Without weights, and with weights that move the center near and far.
            let weights = [None, Some(1.0), Some(1e5)];
            let weight = weights[round / 4 % 3].map(|size| [(); 3].map(|()| size * next()));
            let [a, b, c] = weight.unwrap_or_default();
            let rises = weight.map(|_| [Double::sum(a, -b), Double::sum(a, -c)]);
            let [x, y] = filtered(triangle, rises);
            let [p, q, r] = triangle;
            let sites = [
                Weighted::new(p, a),
                Weighted::new(q, b),
                Weighted::new(r, c),
            ];
            let exact = exact::power_center(sites).expect("a triangle");
            for (filtered, exact) in [(x, exact.x), (y, exact.y)] {
                certain += usize::from(filtered.is_some());
                assert_eq!(filtered.unwrap_or(exact), exact, "{sites:?}");
            }
        }
        assert!(certain > 3500, "only {certain} certain");
    }

    #[test]
    fn centers_are_right_at_any_size() {
        for exponent in [-1040, -600, -150, 0, 100, 500, 1000] {
            let size = f64::powi(2.0, exponent / 2) * f64::powi(2.0, exponent - exponent / 2);
            let at = |x: f64, y: f64| Point::new(x * size, y * size);
            let corners = [at(0.0, 0.0), at(6.0, 0.0), at(0.0, 8.0)];
            assert_eq!(circumcenter(corners), Some(at(3.0, 4.0)));
        }
        let p = |x, y| Point::new(x, y);
        assert_eq!(circumcenter([p(0.0, 0.0), p(1.0, 1.0), p(3.0, 3.0)]), None);
        assert_eq!(circumcenter([p(0.0, 0.0); 3]), None);
        // Too far away for a number.
        let flat = [p(0.0, 0.0), p(2.0, 0.0), p(1.0, 1e-320)];
        assert_eq!(circumcenter(flat), Some(p(1.0, -f64::MAX)));
        let wide = [p(-f64::MAX, 0.0), p(f64::MAX, 0.0), p(0.0, f64::MAX)];
        assert_eq!(circumcenter(wide), Some(p(0.0, 0.0)));
    }
}
