//! Signs of vertices on the sheet: a filter inline, the exact predicates out of line.
//!
//! With `FILTERED` the coordinates are of the ordinary class, where the filters need no guard
//! against underflow.

use super::sheet::Sheet;
use crate::Point;
use crate::predicates::{self, IN_CIRCLE_BOUND, ORIENT2D_BOUND, Orientation};

/// Tells where `c` lies relative to the line from `a` to `b`.
#[inline(always)]
pub(super) fn turn<const FILTERED: bool>(sheet: Sheet, a: u32, b: u32, c: u32) -> Orientation {
    let origin = sheet.point(a);
    let [bx, by] = arm(sheet.point(b), origin);
    let [cx, cy] = arm(sheet.point(c), origin);
    let (plus, minus) = (bx * cy, by * cx);
    let bound = ORIENT2D_BOUND * (plus.abs() + minus.abs());
    if FILTERED && plus - minus > bound {
        Orientation::Left
    } else if FILTERED && plus - minus < -bound {
        Orientation::Right
    } else {
        exact_turn::<FILTERED>(sheet, a, b, c)
    }
}

/// Tells whether `c` lies strictly to the left of `a → b`.
#[inline(always)]
pub(super) fn is_left<const FILTERED: bool>(sheet: Sheet, a: u32, b: u32, c: u32) -> bool {
    turn::<FILTERED>(sheet, a, b, c) == Orientation::Left
}

/// Tells whether `d` lies inside the perturbed circle through `a`, `b`, `c`, counter-clockwise.
#[inline(always)]
pub(super) fn is_inside<const FILTERED: bool>(
    sheet: Sheet,
    a: u32,
    b: u32,
    c: u32,
    d: u32,
) -> bool {
    let origin = sheet.point(a);
    let [b_arm, c_arm, d_arm] = [b, c, d].map(|v| arm(sheet.point(v), origin));
    let cross = |p: [f64; 2], q: [f64; 2]| p[0] * q[1] - p[1] * q[0];
    let [bl, cl, dl] = [b_arm, c_arm, d_arm].map(|p| p[0] * p[0] + p[1] * p[1]);
    let det = cl * cross(b_arm, d_arm) - dl * cross(b_arm, c_arm) - bl * cross(c_arm, d_arm);
    let bound = IN_CIRCLE_BOUND * (dl * cl + (dl + cl) * bl);
    if FILTERED && det > bound {
        true
    } else if FILTERED && det < -bound {
        false
    } else {
        exact_in_circle::<FILTERED>(sheet, a, b, c, d)
    }
}

/// The sign that the filter here left open. Coordinates of the wide class have not been filtered at
/// all: the public predicates guard their own filter.
#[cold]
#[inline(never)]
fn exact_turn<const FILTERED: bool>(sheet: Sheet, a: u32, b: u32, c: u32) -> Orientation {
    let [a, b, c] = [a, b, c].map(|v| sheet.point(v));
    if FILTERED {
        predicates::orient2d_exact(a, b, c)
    } else {
        predicates::orient2d(a, b, c)
    }
}

/// Whether `d` lies inside the perturbed circle through `a`, `b`, `c`; infinity lies outside.
#[cold]
#[inline(never)]
pub(super) fn exact_in_circle<const FILTERED: bool>(
    sheet: Sheet,
    a: u32,
    b: u32,
    c: u32,
    d: u32,
) -> bool {
    if d == sheet.infinite() {
        return false;
    }
    let [a, b, c, d] = [a, b, c, d].map(|v| sheet.point(v));
    if FILTERED {
        predicates::in_circle_perturbed_exact(a, b, c, d)
    } else {
        predicates::in_circle_perturbed(a, b, c, d)
    }
}

/// The vector from `origin` to `p`, rounded.
#[inline(always)]
fn arm(p: Point, origin: Point) -> [f64; 2] {
    [p.x - origin.x, p.y - origin.y]
}

/// Decides exactly what the filter left open: which `vertices` lie above the base, and which of
/// those have a vertex `behind` them inside the circle. `sure` and `found` hold the filter's two
/// answers, a bit a side.
#[cold]
#[inline(never)]
pub(super) fn settle<const FILTERED: bool>(
    sheet: Sheet,
    [left, right]: [u32; 2],
    vertices: [u32; 2],
    behind: [u32; 2],
    sure: [u32; 2],
    found: [u32; 2],
) -> [u32; 2] {
    let mut settled = [0; 2];
    for side in 0..2 {
        let known = |k: usize| (sure[k] >> side & 1 == 1).then_some(found[k] >> side & 1 == 1);
        let (vertex, behind) = (vertices[side], behind[side]);
        let above = known(0).unwrap_or_else(|| {
            exact_turn::<FILTERED>(sheet, left, right, vertex) == Orientation::Left
        });
        let inside = above
            && known(1)
                .unwrap_or_else(|| exact_in_circle::<FILTERED>(sheet, left, right, vertex, behind));
        settled[0] |= u32::from(above) << side;
        settled[1] |= u32::from(inside) << side;
    }
    settled
}
