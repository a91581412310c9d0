//! The laws that the documentation of the predicates states, on all families.

use crate::families::FAMILIES;
use crate::oracle;
use crate::random::Random;
use delone::Point;
use delone::predicates::{
    CircleSide, Orientation, compare_distances, compare_lengths, in_circle, in_circle_perturbed,
    in_diametral_circle, in_disc, orient2d, stage,
};
use std::cmp::Ordering;

/// The orders of four things, each with whether it is odd.
fn permutations() -> Vec<([usize; 4], bool)> {
    let mut all = vec![];
    for code in 0..24 {
        let [i, j, k] = [code % 4, code / 4 % 3, code / 12];
        let mut order = [0, 1, 2, 3];
        order.swap(0, i);
        order.swap(1, 1 + j);
        order.swap(2, 2 + k);
        let swaps = [i, j, k].iter().filter(|&&n| n != 0).count();
        all.push((order, swaps % 2 == 1));
    }
    all
}

fn on_all_families(law: impl Fn([Point; 4])) {
    for family in FAMILIES {
        let mut random = Random(7);
        for _ in 0..500 {
            law((family.make)(&mut random));
        }
    }
}

#[test]
fn orient2d_laws() {
    on_all_families(|[a, b, c, _]| {
        let found = orient2d(a, b, c);
        assert_eq!(orient2d(b, c, a), found);
        assert_eq!(orient2d(c, a, b), found);
        assert_eq!(orient2d(b, a, c), found.reversed());
        assert_eq!(orient2d(a, c, b), found.reversed());
        assert_eq!(orient2d(a, a, c), Orientation::Collinear);
        assert_eq!(orient2d(a, c, c), Orientation::Collinear);
    });
}

/// Distances that are exact along an axis, rounded ones, their neighbours, and numbers that have nothing to
/// do with them.
#[test]
fn in_disc_agrees_with_rational_arithmetic() {
    on_all_families(|[a, b, c, _]| {
        let along = (b.x - a.x).abs();
        let rounded = along.hypot(b.y - a.y);
        let radii = [
            along,
            rounded,
            rounded.next_up(),
            rounded.next_down(),
            c.x,
            c.y,
            0.0,
        ];
        let level = Point::new(b.x, a.y);
        for radius in radii.into_iter().filter(|r| r.is_finite()) {
            for p in [b, level] {
                let expected = match oracle::in_disc(a, radius, p) {
                    Ordering::Less => CircleSide::Inside,
                    Ordering::Equal => CircleSide::On,
                    Ordering::Greater => CircleSide::Outside,
                };
                assert_eq!(in_disc(a, radius, p), expected, "{a:?} {radius} {p:?}");
                assert_eq!(in_disc(p, -radius, a), expected);
                assert_eq!(stage::in_disc(a, radius, p).0, expected);
            }
        }
    });
}

#[test]
fn in_circle_is_antisymmetric() {
    let permutations = permutations();
    on_all_families(|points| {
        let [a, b, c, d] = points;
        let found = in_circle(a, b, c, d);
        for &(order, is_odd) in &permutations {
            let [a, b, c, d] = order.map(|i| points[i]);
            let expected = if is_odd { found.reversed() } else { found };
            assert_eq!(in_circle(a, b, c, d), expected, "{points:?} {order:?}");
        }
        assert_eq!(in_circle(a, b, c, a), CircleSide::On);
    });
}

#[test]
fn circles_through_collinear_points_are_half_planes() {
    let [a, b, c] = [(0.0, 0.0), (1.0, 0.0), (3.0, 0.0)].map(Point::from);
    let probe = |y: f64| in_circle(a, b, c, Point::new(7.0, y));
    assert_eq!(probe(5e-324), CircleSide::Inside);
    assert_eq!(probe(0.0), CircleSide::On);
    assert_eq!(probe(-1e300), CircleSide::Outside);
}

/// Extends the perturbed test to clockwise triangles; undefined for collinear ones.
fn perturbed([a, b, c, d]: [Point; 4]) -> Option<bool> {
    match orient2d(a, b, c) {
        Orientation::Left => Some(in_circle_perturbed(a, b, c, d)),
        Orientation::Right => Some(!in_circle_perturbed(b, a, c, d)),
        Orientation::Collinear => None,
    }
}

/// All 24 ways to ask about four distinct points give one answer, up to the parity of the order.
#[test]
fn perturbed_in_circle_is_antisymmetric_and_never_zero() {
    let permutations = permutations();
    on_all_families(|points| {
        if (0..4).any(|i| points[..i].contains(&points[i])) {
            return;
        }
        let answers: Vec<bool> = permutations
            .iter()
            .filter_map(|&(order, is_odd)| Some(perturbed(order.map(|i| points[i]))? ^ is_odd))
            .collect();
        assert!(answers.windows(2).all(|w| w[0] == w[1]), "{points:?}");
    });
}

#[test]
fn corners_are_not_inside() {
    on_all_families(|[a, b, c, _]| {
        let (a, b) = match orient2d(a, b, c) {
            Orientation::Left => (a, b),
            Orientation::Right => (b, a),
            Orientation::Collinear => return,
        };
        for corner in [a, b, c] {
            assert!(!in_circle_perturbed(a, b, c, corner));
        }
    });
}

#[test]
fn distance_laws() {
    on_all_families(|[p, a, b, c]| {
        let order = |a, b| compare_distances(p, a, b);
        assert_eq!(order(a, b), order(b, a).reverse());
        assert_eq!(order(a, a), Ordering::Equal);
        assert_eq!(order(p, a).is_eq(), p == a);
        if order(a, b).is_le() && order(b, c).is_le() {
            assert!(order(a, c).is_le());
        }
    });
}

#[test]
fn length_laws() {
    on_all_families(|[a, b, c, d]| {
        let found = compare_lengths([a, b], [c, d]);
        assert_eq!(compare_lengths([c, d], [a, b]), found.reverse());
        assert_eq!(compare_lengths([b, a], [c, d]), found);
        assert_eq!(compare_lengths([a, b], [d, c]), found);
        assert_eq!(compare_lengths([a, b], [c, c]).is_eq(), a == b);
        assert_eq!(compare_lengths([a, b], [a, c]), compare_distances(a, b, c));
    });
}

#[test]
fn diametral_circle_laws() {
    on_all_families(|[a, b, p, _]| {
        let found = in_diametral_circle(a, b, p);
        assert_eq!(in_diametral_circle(b, a, p), found);
        assert_eq!(in_diametral_circle(a, b, a), CircleSide::On);
        assert_eq!(in_diametral_circle(a, b, b), CircleSide::On);
        if p != a {
            assert_eq!(in_diametral_circle(a, a, p), CircleSide::Outside);
        }
    });
}
