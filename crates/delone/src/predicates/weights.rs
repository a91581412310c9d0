//! How a point of a triangle is mixed from its corners: weights that are rounded once, and sum to 1 exactly.
//!
//! The true weights are the barycentric coordinates, quotients of areas. They are multiples of 2⁻⁵² once they are
//! rounded down; zero, one or two such steps are then missing from 1, and go to the weights that lost most, one each.
//! That gives, of all weights of this kind, those that are nearest to the true ones: each is one of the two multiples
//! beside its true value, and where the nearest ones sum to 1, it is these.
//!
//! *Cost*: 1 to 2 µs, for areas and quotients are big integers.

use super::exact;
use crate::Point;
use num_bigint::{BigInt, BigUint, Sign};

/// The weights are multiples of 2 to the power of minus this.
const BITS: u32 = 52;

/// Finds weights of the corners of a triangle, however it turns, with which they give a point in it; `None` if the
/// corners are on one line, or the point lies outside.
///
/// Laws, for all finite points: weights are multiples of 2⁻⁵², not negative, less than 2⁻⁵² from the barycentric
/// coordinates, and sum to 1 without rounding; 0 where a coordinate is 0; permuting the corners permutes them. What
/// the rounded weights give differs from the point by less than 3 units in the last place of the corners' largest
/// coordinate, on each axis; with the errors of `(u·a + v·b) + w·c` in `f64`, by at most 6. Of coordinates that lost
/// equally much, that of the lexicographically first corner gets the step.
///
/// ```
/// use delone::predicates::corner_weights;
/// let corners = [(0.0, 0.0), (4.0, 0.0), (0.0, 4.0)].map(Into::into);
/// assert_eq!(corner_weights(corners, (1.0, 2.0).into()), Some([0.25, 0.25, 0.5]));
/// let [u, v, w] = corner_weights(corners, (4.0 / 3.0, 4.0 / 3.0).into()).expect("a point inside");
/// assert_eq!(u + v + w, 1.0);
/// assert_eq!(corner_weights(corners, (3.0, 3.0).into()), None);
/// ```
pub fn corner_weights(corners: [Point; 3], p: Point) -> Option<[f64; 3]> {
    let areas = exact::areas(corners, p);
    let area: BigInt = areas.iter().sum();
    let is_within = |part: &BigInt| [Sign::NoSign, area.sign()].contains(&part.sign());
    if area.sign() == Sign::NoSign || !areas.iter().all(is_within) {
        return None;
    }
    let (mut steps, lost) = rounded_down(&areas, area.magnitude());
    let missing = (1 << BITS) - steps.iter().sum::<u64>();
    let mut order = [0, 1, 2];
    order.sort_by(|&i, &j| {
        let first = corners[i].lex_cmp(&corners[j]);
        lost[j].cmp(&lost[i]).then(first)
    });
    for k in order.into_iter().take(missing as usize) {
        steps[k] += 1;
    }
    Some(steps.map(|steps| steps as f64 / (1_u64 << BITS) as f64))
}

/// Returns the quotients of areas and their sum as whole steps, and the remainders.
fn rounded_down(areas: &[BigInt; 3], area: &BigUint) -> ([u64; 3], [BigUint; 3]) {
    let parts = [0, 1, 2].map(|k| {
        let part = areas[k].magnitude() << BITS;
        let steps = &part / area;
        let lost = part - &steps * area;
        let steps = u64::try_from(steps).expect("bug: a part that exceeds the whole");
        (steps, lost)
    });
    let [(a, lost_a), (b, lost_b), (c, lost_c)] = parts;
    ([a, b, c], [lost_a, lost_b, lost_c])
}

#[cfg(test)]
mod tests {
    use super::*;

    const STEPS: f64 = (1_u64 << BITS) as f64;

    /// Requires the laws; returns the weights.
    fn of(corners: [(f64, f64); 3], p: (f64, f64)) -> [f64; 3] {
        let corners = corners.map(Point::from);
        let p = Point::from(p);
        let weights = corner_weights(corners, p).expect("a point in the triangle");
        assert_eq!(weights.iter().sum::<f64>(), 1.0);
        let areas = exact::areas(corners, p);
        let area: BigInt = areas.iter().sum();
        for (weight, part) in weights.iter().zip(&areas) {
            let steps = weight * STEPS;
            assert_eq!(steps, steps.trunc());
            let error: BigInt = BigInt::from(steps as i64) * &area - (part << BITS);
            assert!(error.magnitude() < area.magnitude());
            assert!(part.sign() != Sign::NoSign || *weight == 0.0);
        }
        let [a, b, c] = corners;
        let [u, v, w] = weights;
        let turned = corner_weights([b, c, a], p);
        let mirrored = corner_weights([a, c, b], p);
        assert_eq!([turned, mirrored], [Some([v, w, u]), Some([u, w, v])]);
        weights
    }

    #[test]
    fn weights_are_the_nearest_that_sum_to_one() {
        let corners = [(0.1, 0.7), (3.3, -0.2), (1.9, 2.6)];
        for i in 0..200 {
            let (u, v) = (f64::from(i) / 211.0, f64::from(i * i % 97) / 98.0);
            let (v, w) = ((1.0 - u) * v, (1.0 - u) * (1.0 - v));
            let mix = |c: [f64; 3]| u * c[0] + v * c[1] + w * c[2];
            let p = (mix([0.1, 3.3, 1.9]), mix([0.7, -0.2, 2.6]));
            if corner_weights(corners.map(Point::from), p.into()).is_none() {
                assert_eq!(i, 0, "only on an edge a point may be rounded out");
                continue;
            }
            let [x, y, z] = of(corners, p);
            assert!(
                [x - u, y - v, z - w]
                    .iter()
                    .all(|error| error.abs() < 1e-15)
            );
        }
    }

    #[test]
    fn of_equal_remainders_the_first_corner_gets_the_step() {
        let corners = [(0.0, 3.0), (3.0, 0.0), (0.0, 0.0)];
        let third = (STEPS / 3.0).floor() / STEPS;
        // 2⁵² is one more than a multiple of 3.
        let [u, v, w] = of(corners, (1.0, 1.0));
        assert_eq!([u, v, w], [third, third, third + 1.0 / STEPS]);
    }

    #[test]
    fn edges_and_corners_have_zeros() {
        let corners = [(0.0, 0.0), (4.0, 0.0), (0.0, 4.0)];
        assert_eq!(of(corners, (1.0, 0.0)), [0.75, 0.25, 0.0]);
        assert_eq!(of(corners, (0.0, 4.0)), [0.0, 0.0, 1.0]);
    }

    #[test]
    fn all_finite_triangles_do_that_have_an_area() {
        let huge = 1e308;
        let wide = [(-huge, -huge), (huge, -huge), (-huge, huge)];
        assert_eq!(of(wide, (-huge, 0.0)), [0.5, 0.0, 0.5]);
        let tiny = 5e-324;
        let low = [(0.0, 0.0), (4.0 * tiny, 0.0), (0.0, 4.0 * tiny)];
        assert_eq!(of(low, (tiny, 2.0 * tiny)), [0.25, 0.25, 0.5]);
        // Inside, and nearer to a corner than weights can tell.
        assert_eq!(
            of([(0.0, 0.0), (huge, 0.0), (0.0, huge)], (1.0, 1.0)),
            [1.0, 0.0, 0.0]
        );
        let flat = [(0.0, 0.0), (1.0, 1.0), (3.0, 3.0)].map(Point::from);
        assert_eq!(corner_weights(flat, flat[1]), None);
        let beside = corner_weights(corners_of_unit(), Point::new(0.5, -tiny));
        assert_eq!(beside, None);
    }

    fn corners_of_unit() -> [Point; 3] {
        [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)].map(Point::from)
    }
}
