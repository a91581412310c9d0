//! Angles compared exactly with one whose tangent is a number.
//!
//! The angle between u and v is at least that of tangent t, if u × v ≥ t (u · v): a polynomial in coordinates and t.

use super::dyadic::Dyadic;
use super::exact;
use super::polynomial::{cross, dot};
use crate::Point;

/// Bounds the error of u × v − t (u · v), relative to the sum of the magnitudes of its four products: none has
/// more than seven roundings, 7u = 7.8e-16.
const BOUND: f64 = 1e-15;

/// 2⁻⁹⁰⁰: sums of products below this are not trusted.
const FLOOR: f64 = f64::from_bits((1023 - 900) << 52);

/// Tells whether each angle of the counter-clockwise triangle `abc` is at least the one below 90 degrees that has
/// this tangent, which must be finite and not negative.
///
/// Laws: monotone, if the tangent falls; cyclic in the corners.
///
/// ```
/// use delone::predicates::angles_are_at_least;
/// let corners = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0)].map(Into::into);
/// assert!(angles_are_at_least(corners, 1.0)); // 45 degrees twice
/// assert!(!angles_are_at_least(corners, 1.0_f64.next_up()));
/// ```
pub fn angles_are_at_least([a, b, c]: [Point; 3], tangent: f64) -> bool {
    [[a, b, c], [b, c, a], [c, a, b]]
        .into_iter()
        .all(|corners| is_at_least(corners, tangent))
}

/// Tells it of the angle at `a`.
fn is_at_least([a, b, c]: [Point; 3], tangent: f64) -> bool {
    let [ux, uy, vx, vy] = [b.x - a.x, b.y - a.y, c.x - a.x, c.y - a.y];
    let [l, r, x, y] = [ux * vy, uy * vx, ux * vx, uy * vy];
    let value = l - r - tangent * (x + y);
    let size = l.abs() + r.abs() + tangent * (x.abs() + y.abs());
    let bound = BOUND * size + FLOOR * (1.0 + tangent);
    if value > bound {
        true
    } else if value < -bound {
        false
    } else {
        exactly([a, b, c], tangent)
    }
}

#[cold]
fn exactly([a, b, c]: [Point; 3], tangent: f64) -> bool {
    let [u, v] = exact::vectors([b, c], a);
    let tangent = Dyadic::new(tangent);
    let unit = tangent.exponent.min(0);
    cross(&u, &v) << unit.unsigned_abs() >= dot(&u, &v) * tangent.in_units_of(unit)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn triangle(corners: [(f64, f64); 3]) -> [Point; 3] {
        corners.map(Point::from)
    }

    #[test]
    fn bounds_are_met_up_to_the_last_digit() {
        for scale in [1.0, 1e-160, 1e-300, 1e150, 2_f64.powi(-1060)] {
            let corners = triangle([(0.0, 0.0), (8.0 * scale, 0.0), (8.0 * scale, 4.0 * scale)]);
            assert!(angles_are_at_least(corners, 0.5), "{scale}");
            assert!(!angles_are_at_least(corners, 0.5_f64.next_up()), "{scale}");
        }
    }

    #[test]
    fn steep_bounds_are_met_at_any_size() {
        for exponent in [-1060, -500, 0, 500] {
            let scale = 2_f64.powi(exponent);
            let corners = triangle([(0.0, 0.0), (4.0 * scale, 0.0), (2.0 * scale, 3.0 * scale)]);
            assert!(angles_are_at_least(corners, 1.5), "{exponent}");
            assert!(
                !angles_are_at_least(corners, 1.5_f64.next_up()),
                "{exponent}"
            );
        }
    }

    #[test]
    fn the_smallest_angle_decides_wherever_it_is() {
        let [a, b, c] = triangle([(0.0, 0.0), (4.0, 0.0), (0.0, 1.0)]);
        for corners in [[a, b, c], [b, c, a], [c, a, b]] {
            assert!(angles_are_at_least(corners, 0.25));
            assert!(!angles_are_at_least(corners, 0.25_f64.next_up()));
        }
    }

    #[test]
    fn no_angle_is_below_nothing() {
        let corners = triangle([(0.0, 0.0), (1e200, 0.0), (0.0, 1e-200)]);
        assert!(angles_are_at_least(corners, 0.0));
        assert!(!angles_are_at_least(corners, 1e-300));
    }
}
