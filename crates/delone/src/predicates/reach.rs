//! Distances from lines, and angles, compared with numbers.
//!
//! With u and v the vectors from a to b and to p, p is as far from the line as |u × v| / |u|; the angle
//! between two sides u and v has the cosine u·v / (|u| |v|). Stage 1 compares these in `f64` and gives up
//! where rounding might matter; big integers compare the squares.

use super::exact;
use crate::Point;

/// Bounds the relative errors of everything below: a difference errs by 1 u, a product of two by 3 u, a sum
/// of two such by 4 u of the sum of their magnitudes, a root halves that and adds 1 u, further products add
/// 1 u each: fewer than 16 in all.
const SHARE: f64 = 8.0 * f64::EPSILON;

/// Sums of products from here on are free of underflow, to well below [`SHARE`] of themselves; so are the
/// products of their roots.
const TAME: std::ops::Range<f64> = 1e-250..1e250;

/// Tells whether `p` is at most `radius` away from the line through two points; if they are equal, it always
/// is.
pub(super) fn line_is_near([a, b]: [Point; 2], radius: f64, p: Point) -> bool {
    let (u, v) = (vector(a, b), vector(a, p));
    let [cross, size] = sums([u[0] * v[1], -u[1] * v[0]]);
    let reach = radius * (u[0] * u[0] + u[1] * u[1]).sqrt();
    if TAME.contains(&size) && TAME.contains(&reach) {
        let error = SHARE * (size + reach);
        if (cross.abs() - reach).abs() > error {
            return cross.abs() < reach;
        }
    }
    exact::line_is_near([a, b], radius, p)
}

/// Tells whether the angle from `a` over the apex to `b` is less than the acute one whose cosine has the square
/// `square`, between 0 and 1. A side of no length has no angle.
pub(super) fn is_sharper(apex: Point, [a, b]: [Point; 2], square: f64) -> bool {
    let (u, v) = (vector(apex, a), vector(apex, b));
    let [dot, size] = sums([u[0] * v[0], u[1] * v[1]]);
    let length = |w: [f64; 2]| (w[0] * w[0] + w[1] * w[1]).sqrt();
    let limit = square.sqrt() * length(u) * length(v);
    if TAME.contains(&size) && TAME.contains(&limit) {
        let error = SHARE * (size + limit);
        if (dot - limit).abs() > error {
            return dot > limit;
        }
    }
    exact::is_sharper(apex, [a, b], square)
}

fn vector(from: Point, to: Point) -> [f64; 2] {
    [to.x - from.x, to.y - from.y]
}

/// The sum of two terms, and of their magnitudes.
fn sums([s, t]: [f64; 2]) -> [f64; 2] {
    [s + t, s.abs() + t.abs()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_stages_agree() {
        let mut state = 7_u64;
        let mut next = move || {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1);
            (state >> 59) as f64 * [1.0, 0.1, 1e-3, 1e9][(state >> 40) as usize % 4]
        };
        for _ in 0..20_000 {
            let [a, b, p] = [0; 3].map(|_| Point::new(next(), next()));
            let radius = next();
            let expected = exact::line_is_near([a, b], radius, p);
            assert_eq!(
                line_is_near([a, b], radius, p),
                expected,
                "{a:?} {b:?} {p:?} {radius}"
            );
            for square in [0.25, 0.5, 0.9, 0.999] {
                let expected = exact::is_sharper(p, [a, b], square);
                assert_eq!(
                    is_sharper(p, [a, b], square),
                    expected,
                    "{a:?} {b:?} {p:?} {square}"
                );
            }
        }
    }

    #[test]
    fn what_rounding_hides_is_left_to_integers() {
        let numbers = || (1..40).map(|i| f64::from(i) * 0.1);
        for (x, y) in numbers().zip(numbers().rev()) {
            let [a, b] = [Point::new(0.3, 0.7), Point::new(x, 3.0 * y)];
            for t in numbers() {
                // On the line, but for rounding; it is a few units in the last place away.
                let p = Point::new(a.x + t * (b.x - a.x), a.y + t * (b.y - a.y));
                for units in 0..8 {
                    let radius = f64::from(units) * 0.25 * f64::EPSILON;
                    for [a, b] in [[a, b], [b, a]] {
                        let expected = exact::line_is_near([a, b], radius, p);
                        assert_eq!(
                            line_is_near([a, b], radius, p),
                            expected,
                            "{a:?} {b:?} {p:?}"
                        );
                    }
                }
            }
        }
    }

    #[test]
    fn touching_counts_as_near_and_not_as_sharper() {
        let [o, x, far] = [(0.0, 0.0), (8.0, 0.0), (3.0, 5.0)].map(Point::from);
        assert!(line_is_near([o, x], 5.0, far));
        assert!(!line_is_near([o, x], 5.0_f64.next_down(), far));
        assert!(line_is_near([o, o], 0.0, far), "no line");
        let diagonal = Point::new(7.0, 7.0);
        assert!(!is_sharper(o, [x, diagonal], 0.5));
        assert!(is_sharper(o, [x, diagonal], 0.5_f64.next_down()));
        assert!(!is_sharper(o, [x, Point::new(-8.0, 1.0)], 0.25), "obtuse");
        let tiny = 2_f64.powi(-1070);
        let thin = [(1e300, 0.0), (1e300, tiny)].map(Point::from);
        assert!(is_sharper(o, thin, 0.999_999));
        assert!(line_is_near([o, thin[0]], tiny, thin[1]));
        assert!(!line_is_near([o, thin[0]], tiny / 2.0, thin[1]));
    }
}
