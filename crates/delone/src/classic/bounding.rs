//! Triangles around all points: the one of the slides, which is not, and one that is.

use crate::Point;
use crate::predicates::{Orientation, orient2d};

/// Returns the triangle that the slides begin with: its base, at the lowest ordinate, is twice as long as the
/// bounding box is wide, and its apex lies half its height above it. Rounded.
///
/// It never contains both upper corners of the box: at their height it is at most two thirds as wide. And even a
/// triangle that contains all points is in the way at the hull, however large it is, since nearly flat triangles
/// have larger circles. It is here to be shown beside [`bounding_triangle`]; no algorithm builds on it.
///
/// Returns `None` without points.
pub fn printed_bounding_triangle(points: &[Point]) -> Option<[Point; 3]> {
    let [low, high] = bounding_box(points)?;
    let middle = low.x / 2.0 + high.x / 2.0;
    let half_base = high.x - low.x;
    Some([
        Point::new(middle - half_base, low.y),
        Point::new(middle + half_base, low.y),
        Point::new(middle, high.y + (high.y / 2.0 - low.y / 2.0)),
    ])
}

/// Returns a triangle, counter-clockwise, that strictly contains all points, for pictures.
///
/// Its base is some five times as long as the bounding box is wide or high, and it is moved apart until the exact
/// predicate finds the corners of the box inside. The algorithms do without: for them such corners are at infinity.
///
/// Returns `None` without points, or if such a triangle would reach beyond the range of `f64`.
///
/// ```
/// use delone::Point;
/// use delone::classic::bounding_triangle;
/// let points = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0)].map(Point::from);
/// let around = bounding_triangle(&points).expect("not that large");
/// assert_eq!(around, [(-2.0, -1.0), (3.0, -1.0), (0.5, 3.0)].map(Point::from));
/// assert_eq!(bounding_triangle(&[]), None);
/// ```
pub fn bounding_triangle(points: &[Point]) -> Option<[Point; 3]> {
    let [low, high] = bounding_box(points)?;
    let corners = [low, (high.x, low.y).into(), high, (low.x, high.y).into()];
    let middle = low.x / 2.0 + high.x / 2.0;
    let extent = (high.x - low.x).max(high.y - low.y);
    let mut room = extent.max(f64::MIN_POSITIVE);
    while room.is_finite() {
        let triangle = [
            Point::new(low.x - 2.0 * room, low.y - room),
            Point::new(high.x + 2.0 * room, low.y - room),
            Point::new(middle, high.y + 2.0 * room),
        ];
        if !triangle.iter().all(Point::is_finite) {
            return None;
        }
        if corners.iter().all(|&p| contains(triangle, p)) {
            return Some(triangle);
        }
        // So small that it was lost in rounding.
        room *= 2.0;
    }
    None
}

fn contains([a, b, c]: [Point; 3], p: Point) -> bool {
    let sides = [(a, b), (b, c), (c, a)];
    let is_left = |(from, to)| orient2d(from, to, p) == Orientation::Left;
    sides.into_iter().all(is_left)
}

/// Returns the lower left and the upper right corner of the bounding box.
fn bounding_box(points: &[Point]) -> Option<[Point; 2]> {
    let (first, rest) = points.split_first()?;
    Some(rest.iter().fold([*first; 2], |[low, high], p| {
        [
            Point::new(low.x.min(p.x), low.y.min(p.y)),
            Point::new(high.x.max(p.x), high.y.max(p.y)),
        ]
    }))
}
