//! Constructed cases of which it is known which stage must decide them.

use delone::Point;
use delone::predicates::stage::{
    Stage, compare_distances, compare_lengths, in_circle, in_circle_perturbed, in_diametral_circle,
    in_disc, orient2d,
};
use delone::predicates::{CircleSide, Orientation};
use std::cmp::Ordering;

fn points<const N: usize>(coordinates: [(f64, f64); N]) -> [Point; N] {
    coordinates.map(Point::from)
}

const ULP: f64 = f64::EPSILON;

#[test]
fn clear_cases_stop_at_the_filter() {
    let [a, b, c, d] = points([(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (0.25, 0.25)]);
    assert_eq!(orient2d(a, b, c), (Orientation::Left, Stage::Filter));
    assert_eq!(in_circle(a, b, c, d), (CircleSide::Inside, Stage::Filter));
    assert_eq!(in_circle_perturbed(a, b, c, d), (true, Stage::Filter));
    assert_eq!(compare_distances(d, a, b), (Ordering::Less, Stage::Filter));
    assert_eq!(
        in_diametral_circle(b, c, d),
        (CircleSide::Inside, Stage::Filter)
    );
}

#[test]
fn ties_on_a_lattice_stop_at_integers() {
    for exponent in [-800, -300, -1, 0, 5, 300, 900] {
        let scale = 2_f64.powi(exponent);
        let coordinates = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (2.0, 2.0)];
        let [a, b, c, d, e] = points(coordinates.map(|(x, y)| (x * scale, y * scale)));
        assert_eq!(orient2d(a, c, e), (Orientation::Collinear, Stage::Integer));
        assert_eq!(in_circle(a, b, c, d), (CircleSide::On, Stage::Integer));
        assert_eq!(in_circle_perturbed(a, b, c, d), (true, Stage::Integer));
        assert_eq!(
            compare_distances(c, b, d),
            (Ordering::Equal, Stage::Integer)
        );
        assert_eq!(
            in_diametral_circle(a, c, b),
            (CircleSide::On, Stage::Integer)
        );
    }
}

#[test]
fn discs_on_a_lattice_stop_at_integers() {
    let [c, p, q] = points([(1.0, 1.0), (4.0, 5.0), (4.0, 5.0 + 4.0 * ULP)]);
    assert_eq!(in_disc(c, 6.0, p), (CircleSide::Inside, Stage::Filter));
    assert_eq!(in_disc(c, 5.0, p), (CircleSide::On, Stage::Integer));
    assert_eq!(in_disc(c, 5.0, q), (CircleSide::Outside, Stage::Integer));
    let [far] = points([(3e300, 4e300)]);
    assert_eq!(in_disc(c, 5e300, far).1, Stage::BigInteger);
}

/// One more or one less in the last place of a coordinate decides, and 62 bits are enough to see it.
#[test]
fn last_places_are_seen_by_integers() {
    let unit = points([(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0)]);
    let [a, b, c] = unit;
    for (d, expected) in [
        ((0.0, -1.0 - ULP), CircleSide::Outside),
        ((0.0, -1.0), CircleSide::On),
        ((0.0, -1.0 + ULP / 2.0), CircleSide::Inside),
    ] {
        assert_eq!(in_circle(a, b, c, d.into()), (expected, Stage::Integer));
    }
    let [p, q] = points([(1.0, 1.0), (3.0, 3.0)]);
    for (r, expected) in [
        ((2.0, 2.0 - ULP), Orientation::Right),
        ((2.0, 2.0), Orientation::Collinear),
        ((2.0 - ULP, 2.0), Orientation::Left),
    ] {
        assert_eq!(orient2d(p, q, r.into()), (expected, Stage::Integer));
    }
}

/// Vectors of exactly 61 bits in magnitude fit; one bit more does not.
#[test]
fn width_decides_between_integers() {
    for (bits, stage) in [(60, Stage::Integer), (61, Stage::BigInteger)] {
        let far = 2_f64.powi(bits);
        let square = [(0.0, 0.0), (far, 1.0), (far - far, 1.0), (far, 0.0)];
        let [a, b, c, d] = points(square);
        assert_eq!(in_circle(a, d, b, c), (CircleSide::On, stage));
        assert_eq!(in_diametral_circle(a, b, d), (CircleSide::On, stage));
        assert_eq!(compare_distances(d, a, d).0, Ordering::Greater);
    }
}

/// Coordinates that need 120 bits on their common lattice, differences that need few.
#[test]
fn large_offsets_stay_fixed_width() {
    let (far, step) = (2_f64.powi(60), 2_f64.powi(8));
    let near = 2_f64.powi(-40);
    let [a, b, c] = points([(far, near), (far, 2.0 * near), (far + step, near)]);
    assert_eq!(orient2d(a, b, a), (Orientation::Collinear, Stage::Integer));
    let [d] = points([(far + step, 2.0 * near)]);
    assert_eq!(in_circle(a, c, d, b), (CircleSide::On, Stage::Integer));
}

/// Lengths of segments far from each other: only the segments themselves must fit.
#[test]
fn lengths_are_compared_wherever_the_segments_lie() {
    let (far, near) = (2_f64.powi(60), 2_f64.powi(-40));
    let step = 2_f64.powi(8);
    let [a, b] = points([(far, near), (far + 3.0 * step, near + 4.0 * step)]);
    let [c, d] = points([(0.0, 0.0), (5.0 * step, 0.0)]);
    let [e] = points([(5.0 * step * (1.0 + ULP), 0.0)]);
    assert_eq!(
        compare_lengths([a, b], [c, d]),
        (Ordering::Equal, Stage::Integer)
    );
    assert_eq!(
        compare_lengths([a, b], [c, e]),
        (Ordering::Less, Stage::Integer)
    );
    let [f] = points([(5.0 * step, 1e-30)]);
    assert_eq!(
        compare_lengths([a, b], [c, f]),
        (Ordering::Less, Stage::BigInteger)
    );
    let [g, h] = points([(0.0, 0.0), (0.0, 1e200)]);
    assert_eq!(compare_lengths([a, b], [g, h]).0, Ordering::Less);
}

#[test]
fn extremes_need_big_integers() {
    let tiny = 5e-324;
    let [a, b, c, d] = points([(0.0, 0.0), (tiny, 0.0), (tiny, tiny), (0.0, tiny)]);
    assert_eq!(orient2d(a, b, c), (Orientation::Left, Stage::BigInteger));
    assert_eq!(in_circle(a, b, c, d), (CircleSide::On, Stage::BigInteger));
    assert_eq!(
        compare_distances(a, b, d),
        (Ordering::Equal, Stage::BigInteger)
    );
    let huge = f64::MAX;
    let [a, b, c, d] = points([(-huge, -huge), (huge, -huge), (huge, huge), (-huge, huge)]);
    assert_eq!(orient2d(a, b, c), (Orientation::Left, Stage::BigInteger));
    assert_eq!(in_circle_perturbed(a, b, c, d), (true, Stage::BigInteger));
    let [p, q, r] = points([(1e-300, 1e300), (1e300, 1e-300), (0.0, 0.0)]);
    assert_eq!(orient2d(r, p, q).0, Orientation::Right);
    assert_eq!(
        compare_distances(r, p, q),
        (Ordering::Equal, Stage::BigInteger)
    );
}

/// Subnormal numbers continue the normal ones without a step.
#[test]
fn the_smallest_normal_number_is_no_step() {
    let unit = |n: i64| n as f64 * 5e-324;
    let border = 1 << 52;
    assert_eq!(unit(border), f64::MIN_POSITIVE);
    let line = [(-1, 0), (0, 1), (1, 2)].map(|(x, y)| (unit(border + x), unit(y)));
    let [a, b, c] = points(line);
    assert_eq!(
        orient2d(a, b, c),
        (Orientation::Collinear, Stage::BigInteger)
    );
}

#[test]
fn negative_zero_is_zero() {
    let [a, b, c, d] = points([(-0.0, 0.0), (1.0, -0.0), (1.0, 1.0), (0.0, 1.0)]);
    let [a0, b0] = points([(0.0, 0.0), (1.0, 0.0)]);
    assert_eq!(
        in_circle_perturbed(a, b, c, d),
        in_circle_perturbed(a0, b0, c, d)
    );
    assert_eq!(orient2d(a, b, a0).0, Orientation::Collinear);
    assert_eq!(compare_distances(d, a, a0).0, Ordering::Equal);
}
