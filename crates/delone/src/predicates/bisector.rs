//! Where segments meet bisectors: which bisector first, and in what point.
//!
//! For sites a, b let n = b − a and m = (a − p) + (b − p). The point p + t(q − p) is equally far from both
//! where 2t·(n · (q − p)) = n · m: t = N/2D with the dot products N = n · m and D = n · (q − p).
//!
//! *Cost*: a comparison 5 ns, or 1 µs in big integers; a point 60 ns, or about 2 µs.

use super::Weighted;
use super::crossing::{certain, is_ordinary, power_of_two, vector};
use super::double::Double;
use super::exact;
use super::polynomial::dot;
use crate::Point;
use std::cmp::Ordering;

/// Bounds the error of N·D′ − N′·D, relative to |N|₊·|D′|₊ + |N′|₊·|D|₊, where |·|₊ is the sum of the
/// magnitudes of all products, differences in m apart.
///
/// A term of N has a rounding in n, two in m, relative to the sum of magnitudes, and one in the product;
/// with the sum, N errs by at most 5u·|N|₊ and D by 4u·|D|₊. With their product, and u² and the roundings
/// of the bound itself, that is below 11u for each term, and the difference adds one more: 16u is enough.
const ORDER_BOUND: f64 = power_of_two(-49);

/// Bounds the error of a coordinate, as for crossings of segments: there N errs by 10u², here by 14u² of
/// |N|₊, because m errs by 3u² itself. What follows stays below 62u².
const PLACE_BOUND: f64 = power_of_two(-99);

/// What underflow may add, as for crossings of segments.
const FLOOR: f64 = power_of_two(-700);

/// Finds which of two bisectors a segment meets first, as far as rounded numbers can tell: that of `site`
/// and `a`, or that of `site` and `b`. It must run towards `a` and towards `b`.
///
/// Coordinates are ordinary, so products of four differences are multiples of 2⁻¹⁰⁰⁸ below 2¹⁰¹⁰: nothing
/// under- or overflows.
pub(super) fn compare([p, q]: [Point; 2], site: Point, a: Point, b: Point) -> Option<Ordering> {
    let mut all = [p, q, site, a, b].into_iter().flat_map(|p| [p.x, p.y]);
    if !all.all(is_ordinary) {
        return None;
    }
    let meeting = |other: Point| {
        let n = [other.x - site.x, other.y - site.y];
        let (from, to) = ([site.x - p.x, site.y - p.y], [other.x - p.x, other.y - p.y]);
        let along = [q.x - p.x, q.y - p.y];
        let [mut numerator, mut denominator, mut n_size, mut d_size] = [0.0; 4];
        for k in 0..2 {
            numerator += n[k] * (from[k] + to[k]);
            n_size += n[k].abs() * (from[k].abs() + to[k].abs());
            denominator += n[k] * along[k];
            d_size += (n[k] * along[k]).abs();
        }
        (numerator, denominator, n_size, d_size)
    };
    let (na, da, na_size, da_size) = meeting(a);
    let (nb, db, nb_size, db_size) = meeting(b);
    let difference = na * db - nb * da;
    let bound = ORDER_BOUND * (na_size * db_size + nb_size * da_size);
    if difference > bound {
        Some(Ordering::Greater)
    } else if difference < -bound {
        Some(Ordering::Less)
    } else {
        None
    }
}

/// Finds the point of a segment, which has it between its ends, that is equally far from two sites, each
/// coordinate rounded correctly.
pub(super) fn place([p, q]: [Point; 2], a: Point, b: Point) -> Point {
    match filtered([p, q], a, b) {
        // Adding zero turns −0.0 into 0.0.
        [Some(x), Some(y)] => Point::new(x + 0.0, y + 0.0),
        _ => {
            let [a, b] = [a, b].map(|p| Weighted::new(p, 0.0));
            exact::bisector_place([p, q], a, b)
        }
    }
}

fn filtered([p, q]: [Point; 2], a: Point, b: Point) -> [Option<f64>; 2] {
    let mut all = [p, q, a, b].into_iter().flat_map(|p| [p.x, p.y]);
    if !all.all(is_ordinary) {
        return [None; 2];
    }
    let [n, along, from, to] = [(a, b), (p, q), (p, a), (p, b)].map(|(p, q)| vector(p, q));
    let middle = [0, 1].map(|k| from[k] + to[k]);
    let (numerator, half) = (dot(&n, &middle), dot(&n, &along));
    let denominator = Double {
        high: 2.0 * half.high,
        low: 2.0 * half.low,
    };
    let size = |v: &[Double; 2]| (n[0].high * v[0].high).abs() + (n[1].high * v[1].high).abs();
    let ratio = (size(&middle) + 2.0 * size(&along)) / denominator.high.abs();
    if ratio.is_nan() || ratio >= power_of_two(50) {
        return [None; 2];
    }
    let t = numerator / denominator;
    let place = |origin: f64, along: Double| {
        if along.high == 0.0 {
            return Some(origin);
        }
        certain(&t * &along + origin, |x| {
            PLACE_BOUND * (along.high.abs() * ratio + x) + FLOOR
        })
    };
    [place(p.x, along[0]), place(p.y, along[1])]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn unweighted(p: Point) -> Weighted {
        Weighted::new(p, 0.0)
    }

    #[test]
    fn both_stages_agree() {
        let mut bits = 88_172_645_463_325_252_u64;
        let mut next = |round: usize| {
            bits ^= bits << 13;
            bits ^= bits >> 7;
            bits ^= bits << 17;
            // Of small lattices, too, where ties are, and what nearly is one.
            match round % 3 {
                0 => (bits >> 11) as f64 / (1_u64 << 53) as f64,
                1 => (bits >> 61) as f64,
                _ => (bits >> 61) as f64 * 1e3 / 7.0,
            }
        };
        let [mut orders, mut places, mut ties] = [0; 3];
        for round in 0..6000 {
            let [p, q, site, a, b] = [(); 5].map(|()| Point::new(next(round), next(round)));
            let towards = |s: Point| (s.x - site.x) * (q.x - p.x) + (s.y - site.y) * (q.y - p.y);
            if towards(a) < 0.1 || towards(b) < 0.1 {
                continue;
            }
            let exact = exact::compare_meetings([p, q], [site, a, b].map(unweighted));
            let found = compare([p, q], site, a, b);
            assert_eq!(
                found.unwrap_or(exact),
                exact,
                "{p:?} {q:?} {site:?} {a:?} {b:?}"
            );
            orders += usize::from(found.is_some());
            ties += usize::from(exact.is_eq());
            let exact = exact::bisector_place([p, q], unweighted(site), unweighted(a));
            let [x, y] = filtered([p, q], site, a);
            assert_eq!((x.unwrap_or(exact.x), y.unwrap_or(exact.y)), exact.into());
            places += usize::from(x.is_some());
        }
        assert!(
            orders > 500 && places > 500 && ties > 5,
            "{orders} {places} {ties}"
        );
    }

    #[test]
    fn coordinates_may_have_any_size() {
        let p = |x: f64, y: f64| Point::new(x, y);
        let way = [p(-1e300, 1e-300), p(1e300, 1e-300)];
        let sites = [p(-1e-310, 0.0), p(3e-310, 0.0)];
        assert_eq!(place(way, sites[0], sites[1]), p(1e-310, 1e-300));
        let farther = p(1e-300, 5.0);
        assert_eq!(
            exact::compare_meetings(way, [sites[0], sites[1], farther].map(unweighted)),
            Ordering::Less
        );
    }
}
