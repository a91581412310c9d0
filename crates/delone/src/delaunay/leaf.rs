//! The smallest triangulations, written from templates.

use super::knit::{HullVertex, NONE};
use super::sheet::Sheet;
use super::signs::{is_inside, turn};
use super::witness::{Witness, is_watching, tell_circle, tell_leaf, tell_turn};
use crate::predicates::Orientation;

/// The four extreme hull vertices; ties are broken as in the frame turned by the cut:
/// leftmost and rightmost by (x, y), lowest and topmost by (y, −x).
#[derive(Clone, Copy)]
pub(super) struct Hull {
    pub left: HullVertex,
    pub right: HullVertex,
    pub bottom: HullVertex,
    pub top: HullVertex,
}

impl Hull {
    /// The ghost of some hull edge; `None` if there is only one point.
    pub fn ghost(&self) -> Option<u32> {
        Some(self.left.ghost).filter(|&ghost| ghost != NONE)
    }

    /// The hull of one point.
    pub fn of_point(vertex: u32) -> Self {
        let v = HullVertex {
            vertex,
            ghost: NONE,
        };
        Self {
            left: v,
            right: v,
            bottom: v,
            top: v,
        }
    }

    /// The extremes among hull vertices.
    #[inline(always)]
    fn of<const N: usize>(sheet: Sheet, vertices: [HullVertex; N]) -> Self {
        let rest = || vertices[1..].iter().copied();
        let first = vertices[0];
        let by_x = |a: HullVertex, b: HullVertex| is_left_of(sheet, a.vertex, b.vertex);
        let by_y = |a: HullVertex, b: HullVertex| is_below(sheet, a.vertex, b.vertex);
        Self {
            left: rest().fold(first, |m, v| HullVertex::select(by_x(v, m), v, m)),
            right: rest().fold(first, |m, v| HullVertex::select(by_x(m, v), v, m)),
            bottom: rest().fold(first, |m, v| HullVertex::select(by_y(v, m), v, m)),
            top: rest().fold(first, |m, v| HullVertex::select(by_y(m, v), v, m)),
        }
    }
}

/// Whether `a` comes before `b` by (x, y). Without branches: they would be mispredicted.
#[inline(always)]
pub(super) fn is_left_of(sheet: Sheet, a: u32, b: u32) -> bool {
    let (a, b) = (sheet.point(a), sheet.point(b));
    (a.x < b.x) | ((a.x == b.x) & (a.y < b.y))
}

/// Whether `a` comes before `b` by (y, −x).
#[inline(always)]
pub(super) fn is_below(sheet: Sheet, a: u32, b: u32) -> bool {
    let (a, b) = (sheet.point(a), sheet.point(b));
    (a.y < b.y) | ((a.y == b.y) & (a.x > b.x))
}

/// Faces as corners (indices of local vertices; `INF` is infinity) and twins (face · 3 + corner).
struct Template<const HALF_EDGES: usize> {
    corners: [u8; HALF_EDGES],
    twins: [u8; HALF_EDGES],
}

const INF: u8 = 4;

/// An edge 0 1: its two ghosts.
const EDGE: Template<6> = Template {
    corners: [INF, 1, 0, INF, 0, 1],
    twins: [3, 5, 4, 0, 2, 1],
};

/// A counter-clockwise triangle 0 1 2, and the ghosts of 01, 12, 20.
const TRIANGLE: Template<12> = Template {
    corners: [0, 1, 2, INF, 1, 0, INF, 2, 1, INF, 0, 2],
    twins: [6, 9, 3, 2, 11, 7, 0, 5, 10, 1, 8, 4],
};

/// A counter-clockwise quadrilateral 0 1 2 3 with the diagonal 02: triangles 012, 023, then the
/// ghosts of 01, 12, 23, 30.
const QUADRILATERAL: Template<18> = Template {
    corners: [0, 1, 2, 0, 2, 3, INF, 1, 0, INF, 2, 1, INF, 3, 2, INF, 0, 3],
    twins: [9, 5, 6, 12, 15, 1, 2, 17, 10, 0, 8, 13, 3, 11, 16, 4, 14, 7],
};

/// A counter-clockwise triangle 0 1 2 with 3 inside: triangles 013, 123, 203, then the ghosts of
/// 01, 12, 20.
const FAN: Template<18> = Template {
    corners: [0, 1, 3, 1, 2, 3, 2, 0, 3, INF, 1, 0, INF, 2, 1, INF, 0, 2],
    twins: [4, 6, 9, 7, 0, 12, 1, 3, 15, 2, 17, 13, 5, 11, 16, 8, 14, 10],
};

impl<const HALF_EDGES: usize> Template<HALF_EDGES> {
    /// Writes the faces from handle `base` on.
    #[inline(always)]
    fn write(&self, sheet: Sheet, base: u32, [a, b, c, d]: [u32; 4]) {
        let vertices = [a, b, c, d, sheet.infinite()];
        for h in 0..HALF_EDGES {
            let (corner, twin) = (self.corners[h], self.twins[h]);
            sheet.set_half_edge(
                base + h as u32,
                vertices[corner as usize],
                base + u32::from(twin),
            );
        }
    }
}

/// Joins the two different points at positions `lo` and `lo + 1`.
#[inline]
pub(super) fn edge(sheet: Sheet, lo: u32, witness: impl Witness) -> Hull {
    let base = 6 * lo;
    EDGE.write(sheet, base, [lo, lo + 1, lo, lo]);
    if is_watching(witness) {
        tell_leaf(witness, sheet, base, 2);
    }
    Hull::of(sheet, ghosts(base, [lo, lo + 1], 0))
}

/// Triangulates the three points from `lo` on; `None` if they lie on a line.
#[inline]
pub(super) fn triangle<const FILTERED: bool>(
    sheet: Sheet,
    lo: u32,
    witness: impl Witness,
) -> Option<Hull> {
    let base = 6 * lo;
    let [a, b, c] = counter_clockwise::<FILTERED>(sheet, lo, witness)?;
    TRIANGLE.write(sheet, base, [a, b, c, a]);
    if is_watching(witness) {
        tell_leaf(witness, sheet, base, 4);
    }
    Some(Hull::of(sheet, ghosts(base, [a, b, c], 1)))
}

/// Triangulates the four points from `lo` on; `None` if three of them may lie on a line.
#[inline]
pub(super) fn quadruple<const FILTERED: bool>(
    sheet: Sheet,
    lo: u32,
    witness: impl Witness,
) -> Option<Hull> {
    let [a, b, c] = counter_clockwise::<FILTERED>(sheet, lo, witness)?;
    let d = lo + 3;
    let beyond = |p: u32, q: u32| {
        tell_turn(witness, sheet, [p, q, d]);
        match turn::<FILTERED>(sheet, p, q, d) {
            Orientation::Left => Some(0),
            Orientation::Right => Some(1),
            Orientation::Collinear => None,
        }
    };
    let base = 6 * lo;
    let index = beyond(a, b)? | beyond(b, c)? << 1 | beyond(c, a)? << 2;
    let fan = |p, q, r, inside| {
        FAN.write(sheet, base, [p, q, r, inside]);
        Hull::of(sheet, ghosts(base, [p, q, r], 3))
    };
    // d lies beyond the edge pq of the triangle pqr.
    let quadrilateral = |p, q, r| {
        tell_circle(witness, sheet, [p, q, r, d]);
        let [p, q, r, s] = if is_inside::<FILTERED>(sheet, p, q, r, d) {
            [d, q, r, p]
        } else {
            [p, d, q, r]
        };
        QUADRILATERAL.write(sheet, base, [p, q, r, s]);
        Hull::of(sheet, ghosts(base, [p, q, r, s], 2))
    };
    let hull = match index {
        0b000 => fan(a, b, c, d),
        0b001 => quadrilateral(a, b, c),
        0b010 => quadrilateral(b, c, a),
        0b100 => quadrilateral(c, a, b),
        // Beyond two edges: their common vertex lies inside.
        0b011 => fan(a, d, c, b),
        0b110 => fan(b, d, a, c),
        _ => fan(c, d, b, a),
    };
    if is_watching(witness) {
        tell_leaf(witness, sheet, base, 6);
    }
    Some(hull)
}

/// The first three points from `lo` on, counter-clockwise; `None` if they lie on a line.
#[inline(always)]
fn counter_clockwise<const FILTERED: bool>(
    sheet: Sheet,
    lo: u32,
    witness: impl Witness,
) -> Option<[u32; 3]> {
    tell_turn(witness, sheet, [lo, lo + 1, lo + 2]);
    match turn::<FILTERED>(sheet, lo, lo + 1, lo + 2) {
        Orientation::Left => Some([lo, lo + 1, lo + 2]),
        Orientation::Right => Some([lo, lo + 2, lo + 1]),
        Orientation::Collinear => None,
    }
}

/// Hull vertices in the order of their ghosts, of which the first is face `first` of the template.
#[inline(always)]
fn ghosts<const N: usize>(base: u32, vertices: [u32; N], first: u32) -> [HullVertex; N] {
    std::array::from_fn(|k| HullVertex {
        vertex: vertices[k],
        ghost: base + 3 * (first + k as u32),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check<const HALF_EDGES: usize>(template: &Template<HALF_EDGES>) {
        let corner = |h: usize| template.corners[h];
        let next = |h: usize| h / 3 * 3 + (h + 1) % 3;
        for h in 0..HALF_EDGES {
            let twin = template.twins[h] as usize;
            assert_eq!(template.twins[twin] as usize, h);
            assert_eq!(corner(next(h)), corner(next(next(twin))), "origin of {h}");
            assert_eq!(corner(next(next(h))), corner(next(twin)), "dest of {h}");
        }
    }

    #[test]
    fn templates_are_closed_spheres() {
        check(&EDGE);
        check(&TRIANGLE);
        check(&QUADRILATERAL);
        check(&FAN);
    }
}
