//! The symbolic perturbation: which of four cocircular points lies inside.
//!
//! Lift each point to x² + y² + ε with infinitesimals ordered like the points, lexicographically:
//! the largest point's ε dominates (Devillers and Teillaud 2011). The in-circle determinant of four
//! cocircular points then has the sign of its cofactor of the largest point, which is an
//! orientation of the other three; cocircular points contain no collinear triple, so one step
//! decides. In pictures: of the two diagonals of a cocircular quadrilateral, the one that avoids
//! the largest corner is Delaunay.
//!
//! The answer depends on coordinates alone, never on ids or input order: that is what makes the
//! triangulation canonical.

use super::{Orientation, orient2d};
use crate::Point;

/// Tells whether `d` lies inside the circle through the counter-clockwise `abc`, on which it is.
///
/// A corner of `abc` is not inside.
#[inline]
pub(super) fn is_inside(a: Point, b: Point, c: Point, d: Point) -> bool {
    let [ab, cd] = [larger(a, b), larger(c, d)];
    let largest = larger(ab, cd);
    if largest == d {
        return false;
    }
    let cofactor = if largest == c {
        orient2d(a, b, d)
    } else if largest == b {
        orient2d(a, d, c)
    } else {
        orient2d(d, b, c)
    };
    cofactor == Orientation::Left
}

#[inline]
fn larger(p: Point, q: Point) -> Point {
    if p.lex_cmp(&q).is_lt() { q } else { p }
}
