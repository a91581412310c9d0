//! The symbolic perturbation: which of four cocircular points lies inside.
//!
//! Lift each point to x² + y² + ε with infinitesimals ordered like the points, lexicographically:
//! the largest point's ε dominates (Devillers and Teillaud 2011). The in-circle determinant of four
//! cocircular points then has the sign of its cofactor of the largest point, which is an
//! orientation of the other three; cocircular points contain no collinear triple, so one step
//! decides. In pictures: of the two diagonals of a cocircular quadrilateral, the one that avoids
//! the largest corner is Delaunay.
//!
//! *Weights* change the heights, not the infinitesimals. Four points whose determinant vanishes may
//! then contain collinear triples. The cofactor of a point vanishes if the other three are collinear.
//! If four points in different places do not all lie on one line, at most three of them do, and then
//! only the cofactor of the fourth vanishes: one step more decides. On a line, the determinant of three
//! points has as cofactors the differences of two places, of which none vanishes.
//!
//! So under the perturbation no four lifted points that are not above one line are coplanar, and no
//! three above a line are collinear. In words of algebra: heights are numbers of the ordered field of
//! the rationals with the infinitesimals, where the lower convex hull of the lifted points has
//! triangles only, and over each line of the hull an edge between any two neighbours only. A convex
//! hull knows no order of insertion, and neither does its projection, the regular triangulation. A
//! ghost is a triangle with a point above all others, over the inside of the hull, so high that it
//! outweighs every height: hull edges obey the same theory.
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

/// Tells whether `d` is inside the power circle of the counter-clockwise `abc`, on which it is.
///
/// A corner of `abc` is not inside.
pub(super) fn is_inside_power_circle([a, b, c]: [Point; 3], d: Point) -> bool {
    let mut places = [
        (d, None),
        (a, Some([d, b, c])),
        (b, Some([a, d, c])),
        (c, Some([a, b, d])),
    ];
    // Stable: of equal points d comes first.
    places.sort_by(|(p, _), (q, _)| q.lex_cmp(p));
    for (_, others) in places {
        // Raising d takes it out, as abc turns counter-clockwise.
        let Some([p, q, r]) = others else {
            return false;
        };
        match orient2d(p, q, r) {
            Orientation::Left => return true,
            Orientation::Right => return false,
            Orientation::Collinear => {}
        }
    }
    false
}

/// Tells whether `p` is inside the power interval of `a` and `b` on its line, at the border of which
/// it is: raising the larger end takes in what lies before it, raising p takes it out.
pub(super) fn is_inside_power_segment(a: Point, b: Point, p: Point) -> bool {
    let (ap, pb) = (a.lex_cmp(&p), p.lex_cmp(&b));
    ap == pb && ap.is_ne()
}

#[inline]
fn larger(p: Point, q: Point) -> Point {
    if p.lex_cmp(&q).is_lt() { q } else { p }
}
