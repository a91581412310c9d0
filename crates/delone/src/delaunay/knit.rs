//! Merging two triangulations that a line separates: find the lower tangent, then knit upwards.
//!
//! This is the merge step of Guibas and Stolfi (*Primitives for the manipulation of general
//! subdivisions and the computation of Voronoi diagrams*, 1985) on triangles with ghosts, as in
//! Shewchuk's Triangle. A ghost whose infinite corner is moved to the opposite hull *is* the
//! knitted triangle, and deleting an edge is a flip that turns a triangle into a ghost; so a merge
//! needs exactly two new faces, one below the lower and one above the upper tangent.
//!
//! All signs of one step are taken relative to the left end of the base, so that differences,
//! lifts and cross products are shared between the tests.

use super::sheet::Sheet;
use crate::Point;
use crate::predicates::{self, IN_CIRCLE_BOUND, ORIENT2D_BOUND, Orientation};

/// No ghost: the handle of a triangulation that is a single point.
pub(super) const NONE: u32 = u32::MAX;

/// A hull vertex with the ghost of the hull edge that starts there ([`NONE`] for a lone point).
#[derive(Clone, Copy, Debug)]
pub(super) struct HullVertex {
    pub vertex: u32,
    pub ghost: u32,
}

/// Where two hulls were joined.
pub(super) struct Seam {
    /// The ends of the lower tangent, left and right.
    pub lower: [u32; 2],
    /// The ends of the upper tangent, left and right.
    pub upper: [u32; 2],
    /// The ghost below the lower tangent; its hull edge starts at the left end.
    pub bottom: u32,
    /// The ghost above the upper tangent; its hull edge starts at the right end.
    pub top: u32,
}

/// Merges two triangulations. `left` holds the rightmost vertex of the left one, `right` the
/// leftmost of the right one; `bottom` and `top` are the handles of two free slots.
///
/// With `FILTERED`, floating-point filters come first; they need coordinates of the ordinary class.
pub(super) fn merge<const FILTERED: bool>(
    sheet: Sheet,
    left: HullVertex,
    right: HullVertex,
    [bottom, top]: [u32; 2],
) -> Seam {
    let (left, right) = lower_tangent::<FILTERED>(sheet, left, right);
    let mut knit = Knit::<FILTERED>::start(sheet, left, right, bottom);
    knit.run();
    let upper = [knit.left, knit.right];
    knit.finish(bottom, top, left.ghost, right.ghost);
    Seam {
        lower: [left.vertex, right.vertex],
        upper,
        bottom,
        top,
    }
}

/// Walks both hulls downwards until no hull vertex lies below the line through both.
fn lower_tangent<const FILTERED: bool>(
    sheet: Sheet,
    mut left: HullVertex,
    mut right: HullVertex,
) -> (HullVertex, HullVertex) {
    loop {
        let mut moved = false;
        if right.ghost != NONE {
            let next = sheet.corner(right.ghost + 1);
            if is_left::<FILTERED>(sheet, right.vertex, left.vertex, next) {
                right = HullVertex {
                    vertex: next,
                    ghost: sheet.twin(right.ghost + 2) - 1,
                };
                moved = true;
            }
        }
        if left.ghost != NONE {
            let ghost = sheet.twin(left.ghost + 1) - 2;
            let before = sheet.corner(ghost + 2);
            if is_left::<FILTERED>(sheet, right.vertex, left.vertex, before) {
                left = HullVertex {
                    vertex: before,
                    ghost,
                };
                moved = true;
            }
        }
        if !moved {
            return (left, right);
        }
    }
}

/// Tells whether `c` lies strictly to the left of `a → b`.
#[inline(always)]
pub(super) fn is_left<const FILTERED: bool>(sheet: Sheet, a: u32, b: u32, c: u32) -> bool {
    let origin = sheet.point(a);
    let ab = Arm::new(sheet.point(b), origin);
    let ac = Arm::new(sheet.point(c), origin);
    ab.cross(ac)
        .is_positive::<FILTERED>(|| exact_is_left(sheet, a, b, c))
}

#[cold]
#[inline(never)]
fn exact_is_left(sheet: Sheet, a: u32, b: u32, c: u32) -> bool {
    let [a, b, c] = [a, b, c].map(|v| sheet.point(v));
    predicates::orient2d_exact(a, b, c) == Orientation::Left
}

/// Whether `d` lies inside the perturbed circle through `a`, `b`, `c`; infinity lies outside.
#[cold]
#[inline(never)]
fn exact_in_circle(sheet: Sheet, a: u32, b: u32, c: u32, d: u32) -> bool {
    if d == sheet.infinite() {
        return false;
    }
    let [a, b, c, d] = [a, b, c, d].map(|v| sheet.point(v));
    predicates::in_circle_perturbed_exact(a, b, c, d)
}

/// A vector from the left end of the base, rounded.
#[derive(Clone, Copy)]
struct Arm {
    x: f64,
    y: f64,
}

impl Arm {
    #[inline(always)]
    fn new(p: Point, origin: Point) -> Self {
        Self {
            x: p.x - origin.x,
            y: p.y - origin.y,
        }
    }

    #[inline(always)]
    fn lift(self) -> f64 {
        self.x * self.x + self.y * self.y
    }

    #[inline(always)]
    fn cross(self, other: Self) -> Cross {
        Cross {
            plus: self.x * other.y,
            minus: self.y * other.x,
        }
    }
}

/// The two products of a cross product, from which its sign may be certain.
#[derive(Clone, Copy)]
struct Cross {
    plus: f64,
    minus: f64,
}

impl Cross {
    #[inline(always)]
    fn value(self) -> f64 {
        self.plus - self.minus
    }

    #[inline(always)]
    fn is_positive<const FILTERED: bool>(self, exact: impl FnOnce() -> bool) -> bool {
        let bound = ORIENT2D_BOUND * (self.plus.abs() + self.minus.abs());
        if FILTERED && self.value() > bound {
            true
        } else if FILTERED && self.value() < -bound {
            false
        } else {
            exact()
        }
    }
}

/// The state of a merge: the base runs from `left` to `right`, everything below is knitted.
struct Knit<const FILTERED: bool> {
    sheet: Sheet,
    left: u32,
    right: u32,
    /// Ghost of the left hull's edge that starts at `left` and goes up, or [`NONE`].
    left_ghost: u32,
    /// Ghost of the right hull's edge that comes down to `right`, or [`NONE`].
    right_ghost: u32,
    /// The upper side of the face below the base: the twin-to-be of the next triangle's base.
    base: u32,
}

/// A vertex that may become the apex of the next triangle, relative to the left end of the base.
#[derive(Clone, Copy)]
struct Candidate {
    vertex: u32,
    arm: Arm,
    lift: f64,
    /// Cross product with the base.
    cross: f64,
}

impl<const FILTERED: bool> Knit<FILTERED> {
    fn start(sheet: Sheet, left: HullVertex, right: HullVertex, bottom: u32) -> Self {
        sheet.set_ghost(bottom, left.vertex, right.vertex);
        if left.ghost != NONE {
            sheet.bond(bottom + 1, sheet.twin(left.ghost + 1));
        }
        let mut right_ghost = NONE;
        if right.ghost != NONE {
            right_ghost = sheet.twin(right.ghost + 1) - 2;
            sheet.bond(bottom + 2, right.ghost + 1);
        }
        Self {
            sheet,
            left: left.vertex,
            right: right.vertex,
            left_ghost: left.ghost,
            right_ghost,
            base: bottom,
        }
    }

    /// Closes the seam with the ghost above the upper tangent.
    fn finish(self, bottom: u32, top: u32, first_left: u32, first_right: u32) {
        let Self { sheet, .. } = self;
        sheet.set_ghost(top, self.right, self.left);
        sheet.bond(top, self.base);
        if first_left == NONE {
            sheet.link_ghosts(top, bottom);
        } else {
            sheet.link_ghosts(top, self.left_ghost);
        }
        if first_right == NONE {
            sheet.link_ghosts(bottom, top);
        } else {
            sheet.link_ghosts(self.right_ghost, top);
        }
    }

    /// Raises the base until neither side has a vertex above it.
    #[inline(always)]
    fn run(&mut self) {
        loop {
            let origin = self.sheet.point(self.left);
            let base = Arm::new(self.sheet.point(self.right), origin);
            let base_lift = base.lift();
            let left = self.left_candidate(origin, base, base_lift);
            let right = self.right_candidate(origin, base, base_lift);
            match (left, right) {
                (None, None) => return,
                (Some(left), None) => self.advance_left(left.vertex),
                (None, Some(right)) => self.advance_right(right.vertex),
                (Some(left), Some(right)) => {
                    if self.is_inside(
                        base,
                        base_lift,
                        left,
                        right.vertex,
                        right.arm,
                        right.lift,
                        right.cross,
                    ) {
                        self.advance_right(right.vertex);
                    } else {
                        self.advance_left(left.vertex);
                    }
                }
            }
        }
    }

    /// Whether `vertex` lies inside the circle through the base and `apex`.
    #[inline(always)]
    #[allow(clippy::too_many_arguments)]
    fn is_inside(
        &self,
        base: Arm,
        base_lift: f64,
        apex: Candidate,
        vertex: u32,
        arm: Arm,
        lift: f64,
        cross: f64,
    ) -> bool {
        let _ = base;
        let det = lift * apex.cross - apex.lift * cross + base_lift * apex.arm.cross(arm).value();
        let bound = IN_CIRCLE_BOUND * (lift * apex.lift + apex.lift * base_lift + base_lift * lift);
        if FILTERED && det > bound {
            false
        } else if FILTERED && det < -bound {
            // The sentinel of infinity is a far, but finite point.
            vertex != self.sheet.infinite()
        } else {
            exact_in_circle(self.sheet, self.left, self.right, apex.vertex, vertex)
        }
    }

    /// The candidate `vertex`, unless it does not lie above the base.
    #[inline(always)]
    fn above(&self, vertex: u32, origin: Point, base: Arm) -> Option<Candidate> {
        let arm = Arm::new(self.sheet.point(vertex), origin);
        let cross = base.cross(arm);
        cross
            .is_positive::<FILTERED>(|| exact_is_left(self.sheet, self.left, self.right, vertex))
            .then(|| Candidate {
                vertex,
                arm,
                lift: arm.lift(),
                cross: cross.value(),
            })
    }

    #[inline(always)]
    fn candidate(&self, vertex: u32, origin: Point, base: Arm) -> Candidate {
        let arm = Arm::new(self.sheet.point(vertex), origin);
        Candidate {
            vertex,
            arm,
            lift: arm.lift(),
            cross: base.cross(arm).value(),
        }
    }

    /// The next vertex up the left hull, after deleting the edges that its circle forbids.
    #[inline(always)]
    fn left_candidate(&self, origin: Point, base: Arm, base_lift: f64) -> Option<Candidate> {
        if self.left_ghost == NONE {
            return None;
        }
        let (sheet, ghost) = (self.sheet, self.left_ghost);
        let mut apex = self.above(sheet.corner(ghost + 1), origin, base)?;
        loop {
            let inner = sheet.twin(ghost);
            let behind = self.candidate(sheet.corner(inner), origin, base);
            if !self.is_inside(
                base,
                base_lift,
                apex,
                behind.vertex,
                behind.arm,
                behind.lift,
                behind.cross,
            ) {
                return Some(apex);
            }
            // left → apex is deleted; its triangle becomes the ghost of behind → apex.
            let (face, next, prev) = around(inner);
            let (outer, deeper, after) =
                (sheet.twin(next), sheet.twin(prev), sheet.twin(ghost + 2));
            sheet.set_ghost(face, behind.vertex, apex.vertex);
            sheet.bond(face, outer);
            sheet.bond(face + 2, after);
            sheet.bond(face + 1, ghost + 2);
            sheet.set_corner(ghost + 1, behind.vertex);
            sheet.bond(ghost, deeper);
            apex = behind;
        }
    }

    /// The next vertex up the right hull, after deleting the edges that its circle forbids.
    #[inline(always)]
    fn right_candidate(&self, origin: Point, base: Arm, base_lift: f64) -> Option<Candidate> {
        if self.right_ghost == NONE {
            return None;
        }
        let (sheet, ghost) = (self.sheet, self.right_ghost);
        let mut apex = self.above(sheet.corner(ghost + 2), origin, base)?;
        loop {
            let inner = sheet.twin(ghost);
            let behind = self.candidate(sheet.corner(inner), origin, base);
            if !self.is_inside(
                base,
                base_lift,
                apex,
                behind.vertex,
                behind.arm,
                behind.lift,
                behind.cross,
            ) {
                return Some(apex);
            }
            // apex → right is deleted; its triangle becomes the ghost of apex → behind.
            let (face, next, prev) = around(inner);
            let (deeper, outer, before) =
                (sheet.twin(next), sheet.twin(prev), sheet.twin(ghost + 1));
            sheet.set_ghost(face, apex.vertex, behind.vertex);
            sheet.bond(face, outer);
            sheet.bond(face + 1, before);
            sheet.bond(face + 2, ghost + 1);
            sheet.set_corner(ghost + 2, behind.vertex);
            sheet.bond(ghost, deeper);
            apex = behind;
        }
    }

    /// Turns the left ghost into the triangle (right, apex, left).
    #[inline(always)]
    fn advance_left(&mut self, apex: u32) {
        let (sheet, ghost) = (self.sheet, self.left_ghost);
        sheet.set_corner(ghost, self.right);
        sheet.bond(ghost + 1, self.base);
        self.base = ghost + 2;
        self.left_ghost = sheet.twin(ghost + 2) - 1;
        self.left = apex;
    }

    /// Turns the right ghost into the triangle (left, right, apex).
    #[inline(always)]
    fn advance_right(&mut self, apex: u32) {
        let (sheet, ghost) = (self.sheet, self.right_ghost);
        sheet.set_corner(ghost, self.left);
        sheet.bond(ghost + 2, self.base);
        self.base = ghost + 1;
        self.right_ghost = sheet.twin(ghost + 1) - 2;
        self.right = apex;
    }
}

/// The handle of the face that owns half-edge `h`, and the half-edges after and before `h`.
#[inline(always)]
fn around(h: u32) -> (u32, u32, u32) {
    let k = h % 3;
    let face = h - k;
    let next = if k == 2 { face } else { h + 1 };
    let prev = if k == 0 { face + 2 } else { h - 1 };
    (face, next, prev)
}
