//! Points with double-precision coordinates near one that has none.
//!
//! The exact search ends where two lines through corners and data meet. If each line may be left to one side or the
//! other, something in one of the quadrants between them will do, close enough: how close, and which, is tried.

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

/// Lists points, beginning with the nearest: that, its eight neighbours, and others farther away, the farthest of
/// them first.
pub(super) fn places(corners: [Point; 3], exact: &Barycentric) -> impl Iterator<Item = Point> {
    let Point { x, y } = exact.place(corners).rounded();
    let steps = |c: f64| [c, c.next_down(), c.next_up()];
    let near = steps(x)
        .into_iter()
        .flat_map(move |x| steps(y).map(|y| Point::new(x, y)));
    let weights = exact.weights();
    // From 1/16 to 2⁻⁴⁸.
    let sizes = std::iter::successors(Some(0.0625), |size| Some(size / 16.0)).take(12);
    let far = sizes.flat_map(move |size| {
        DIRECTIONS.map(|way| {
            let moved = [0, 1, 2].map(|k| weights[k] * (1.0 + size * way[k]));
            balanced::place(corners, moved)
        })
    });
    near.chain(far)
}
