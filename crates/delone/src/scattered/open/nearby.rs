//! Points with double-precision coordinates near one that has none.
//!
//! The exact search ends where two lines through corners and data meet. If each line may be left to one side or the
//! other, something in one of the quadrants between them will do, close enough: how close, and which, is tried. If
//! one must be kept to, since data on it must go to both sides, points on it are tried that divide the way from the
//! corner to a datum in a ratio of few digits: these are exact where coordinates have few.

use super::balanced;
use crate::Point;
use crate::predicates::Barycentric;

/// Which coordinates grow, and which shrink: twelve directions, one or two between any two lines to corners.
const DIRECTIONS: [[f64; 3]; 12] = [
    [1.0, 0.0, 0.0],
    [0.0, 1.0, 0.0],
    [0.0, 0.0, 1.0],
    [-1.0, 0.0, 0.0],
    [0.0, -1.0, 0.0],
    [0.0, 0.0, -1.0],
    [1.0, -1.0, 0.0],
    [0.0, 1.0, -1.0],
    [-1.0, 0.0, 1.0],
    [-1.0, 1.0, 0.0],
    [0.0, -1.0, 1.0],
    [1.0, 0.0, -1.0],
];

/// Lists points, beginning with the nearest: that, its eight neighbours, some on the lines through each corner and a
/// datum, and others farther away, the farthest of them first.
pub(super) fn places(
    corners: [Point; 3],
    exact: &Barycentric,
    on_lines: [Option<Point>; 3],
) -> impl Iterator<Item = Point> {
    let nearest = exact.place(corners).rounded();
    let Point { x, y } = nearest;
    let steps = |c: f64| [c, c.next_down(), c.next_up()];
    let near = steps(x)
        .into_iter()
        .flat_map(move |x| steps(y).map(|y| Point::new(x, y)));
    let along = (0..3).flat_map(move |k| {
        let line = on_lines[k].map(|datum| [corners[k], datum]);
        line.into_iter().flat_map(move |line| along(line, nearest))
    });
    let weights = exact.weights();
    // From 1/16 to 2⁻⁴⁸.
    let sizes = std::iter::successors(Some(0.0625), |size| Some(size / 16.0)).take(12);
    let far = sizes.flat_map(move |size| {
        DIRECTIONS.map(|way| {
            let moved = [0, 1, 2].map(|k| weights[k] * (1.0 + size * way[k]));
            balanced::place(corners, moved)
        })
    });
    near.chain(along).chain(far)
}

/// Lists points of a line on both sides of one near it, at ratios of few digits, the fewest last.
fn along([from, to]: [Point; 2], near: Point) -> impl Iterator<Item = Point> {
    let way = Point::new(to.x - from.x, to.y - from.y);
    let ratio = match way.x.abs() > way.y.abs() {
        true => (near.x - from.x) / way.x,
        false => (near.y - from.y) / way.y,
    };
    let digits = [24, 16, 12, 8, 6, 4, 2, 0].map(|digits| f64::from(1 << digits));
    let both = move |scale: f64| {
        [
            (ratio * scale).floor() / scale,
            (ratio * scale).ceil() / scale,
        ]
    };
    let ratios = digits.into_iter().flat_map(both);
    ratios.map(move |ratio| Point::new(from.x + way.x * ratio, from.y + way.y * ratio))
}
