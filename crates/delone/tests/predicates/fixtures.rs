//! Fixtures of other libraries (`tests/data/predicates`) and cases that went wrong elsewhere.

use crate::{orientation, side};
use delone::Point;
use delone::predicates::{CircleSide, Orientation, in_circle, orient2d};
use std::cmp::Ordering;

/// Reads lines of `id`, the coordinates of N points and a sign.
fn read<const N: usize>(text: &str) -> Vec<([Point; N], Ordering)> {
    let parse = |line: &str| {
        let numbers: Vec<f64> = line
            .split_whitespace()
            .map(|word| word.parse().expect("a number"))
            .collect();
        let points = std::array::from_fn(|i| Point::new(numbers[1 + 2 * i], numbers[2 + 2 * i]));
        (points, numbers[1 + 2 * N].total_cmp(&0.0))
    };
    text.lines().map(parse).collect()
}

#[test]
fn orient2d_fixtures() {
    let cases = read(include_str!("../data/predicates/orient2d.txt"));
    assert_eq!(cases.len(), 500);
    for ([a, b, c], sign) in cases {
        assert_eq!(orient2d(a, b, c), orientation(sign), "{a:?} {b:?} {c:?}");
    }
}

#[test]
fn in_circle_fixtures() {
    let cases = read(include_str!("../data/predicates/incircle.txt"));
    assert_eq!(cases.len(), 500);
    for ([a, b, c, d], sign) in cases {
        let found = in_circle(a, b, c, d);
        assert_eq!(found, side(sign), "{a:?} {b:?} {c:?} {d:?}");
    }
}

/// Expansions underflow to zero here:
/// <https://github.com/JuliaGeometry/AdaptivePredicates.jl/issues/4>.
#[test]
fn adaptivepredicates_4_underflow() {
    let [a, b, c] = [(0.0, 0.0), (0.0, 5e-324), (5e-324, 0.0)].map(Point::from);
    assert_eq!(orient2d(a, b, c), Orientation::Right);
}

/// An older release found +1.9e-16; the exact determinant is −8.0140565430358e-30:
/// <https://github.com/georust/robust/issues/48>.
#[test]
fn robust_48_near_cocircular() {
    let [a, b, c, d] = [
        (2.1045541600524288e-15, -1.0000000000000016),
        (1.000000000000005, -3.350874324301223e-16),
        (7.553997323229233e-15, 0.9999999999999958),
        (-0.9999999999999922, -7.073397829693697e-15),
    ]
    .map(Point::from);
    assert_eq!(in_circle(a, b, c, d), CircleSide::Outside);
}
