//! A triangle that encloses all data, for when nothing else does (3.31).
//!
//! Around the box A B C D of the data, enlarged a little, it is A, A + 2(B − A), A + 2(D − A). Its third side goes
//! through C. Corners are rounded, so that it encloses the data is tested.

use crate::predicates::{Orientation, orient2d};
use crate::scattered::extent::Extent;
use crate::{Error, Point};

/// How much the box is enlarged on each side, by its longer side.
const MARGIN: f64 = 1.0 / 16.0;

/// By how much at least, by the coordinates: a few units in the last place.
const LEAST_MARGIN: f64 = 16.0 * f64::EPSILON;

/// Finds the triangle, counter-clockwise.
///
/// # Errors
/// [`Error::BadChoice`] if a corner would be beyond the largest number.
pub(super) fn enclosing(extent: Extent) -> Result<[Point; 3], Error> {
    let Extent { low, high } = extent;
    let longer = (high.x - low.x).max(high.y - low.y);
    let mut margins = [[low.x, high.x], [low.y, high.y]].map(|[low, high]| {
        let size = low.abs().max(high.abs());
        // The box of a single point has no size, nor has that of the origin a coordinate.
        (longer * MARGIN)
            .max(size * LEAST_MARGIN)
            .max(f64::MIN_POSITIVE)
    });
    loop {
        let [x, y] = [
            legs([low.x, high.x], margins[0]),
            legs([low.y, high.y], margins[1]),
        ];
        let corners = [
            Point::new(x[0], y[0]),
            Point::new(x[1], y[0]),
            Point::new(x[0], y[1]),
        ];
        if !corners.iter().all(Point::is_finite) {
            return Err(too_large(extent));
        }
        if encloses(corners, extent) {
            return Ok(corners);
        }
        // It ends, at the latest, where corners are beyond the largest number.
        margins = margins.map(|margin| 2.0 * margin);
    }
}

/// Where the corners are along an axis.
fn legs([low, high]: [f64; 2], margin: f64) -> [f64; 2] {
    let start = low - margin;
    let length = (high + margin) - start;
    [start, start + 2.0 * length]
}

/// Tells whether the corners of a box, and so all of it, lie strictly inside a triangle.
fn encloses([a, b, c]: [Point; 3], Extent { low, high }: Extent) -> bool {
    let is_beyond = a.x < low.x && a.y < low.y && a.y == b.y && a.x == c.x;
    is_beyond && orient2d(b, c, high) == Orientation::Left
}

fn too_large(extent: Extent) -> Error {
    let ends = [extent.low, extent.high].map(|p| [p.x, p.y]);
    let largest = |a: f64, b: f64| if b.abs() > a.abs() { b } else { a };
    Error::BadChoice {
        what: "the largest coordinate of the data",
        given: ends.as_flattened().iter().copied().fold(0.0, largest),
        must: "it must leave room for a triangle around them; divide all by a power of two",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn triangle(points: &[[f64; 2]]) -> Result<[Point; 3], Error> {
        let points: Vec<Point> = points.iter().copied().map(Point::from).collect();
        let extent = Extent::of(points.iter().copied()).expect("points");
        let found = enclosing(extent);
        if let Ok([a, b, c]) = found {
            for &p in &points {
                for [a, b] in [[a, b], [b, c], [c, a]] {
                    assert_eq!(orient2d(a, b, p), Orientation::Left, "{p:?} of {found:?}");
                }
            }
        }
        found
    }

    #[test]
    fn boxes_of_any_size_are_enclosed() {
        let square = triangle(&[[0.0, 0.0], [16.0, 16.0]]);
        let corners = [[-1.0, -1.0], [35.0, -1.0], [-1.0, 35.0]].map(Point::from);
        assert_eq!(square, Ok(corners));
        let sizes = [0.0, 5e-324, 1e-310, 1e-300, 1e-10, 1.0, 1e6, 1e300, 1e307];
        for a in sizes {
            for b in sizes {
                let bits = |c: f64| c.next_up();
                triangle(&[[a, b]]).expect("room");
                triangle(&[[-a, b]]).expect("room");
                triangle(&[[a, -b], [bits(a), -b]]).expect("room");
                triangle(&[[-a, b], [-a, bits(b)]]).expect("room");
                triangle(&[[-a, -b], [b, a]]).expect("room");
            }
        }
    }

    #[test]
    fn what_is_too_large_is_named() {
        let found = triangle(&[[-1e308, 1.0], [1.5e308, 2.0]]);
        let Err(Error::BadChoice { given, .. }) = found else {
            panic!("{found:?}");
        };
        assert_eq!(given, 1.5e308);
        triangle(&[[f64::MAX, 1.0]]).expect_err("no room");
    }
}
