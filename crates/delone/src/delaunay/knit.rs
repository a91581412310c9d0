//! Merging two triangulations that a line separates: find the lower tangent, then knit upwards.
//!
//! This is the merge step of Guibas and Stolfi (*Primitives for the manipulation of general
//! subdivisions and the computation of Voronoi diagrams*, 1985) on triangles with ghosts, as in
//! Shewchuk's Triangle. A ghost whose infinite corner is moved to the opposite hull *is* the
//! knitted triangle, and deleting an edge is a flip that turns a triangle into a ghost; so a merge
//! needs exactly two new faces, one below the lower and one above the upper tangent.
//!
//! All signs of one step are taken relative to the left end of the base, so that differences,
//! lifts and cross products are shared between the tests. Half of the branches here cannot be
//! predicted, so what a step costs is mostly its chain from load to branch; arrays of floats are
//! avoided in it, since a compiler that keeps them in memory makes that chain longer.

use super::pair::{Mask, Pair};
use super::sheet::Sheet;
use super::signs::{exact_in_circle, is_left, settle};
use super::witness::{Deed, Witness, names, tell_circle, tell_turn};
use crate::Point;
use crate::predicates::{IN_CIRCLE_BOUND, ORIENT2D_BOUND};

/// No ghost: the handle of a triangulation that is a single point.
pub(super) const NONE: u32 = u32::MAX;

/// A hull vertex with the ghost of the hull edge that starts there ([`NONE`] for a lone point).
#[derive(Clone, Copy, Debug)]
pub(super) struct HullVertex {
    pub vertex: u32,
    pub ghost: u32,
}

impl HullVertex {
    /// Returns `a` if `condition` holds, else `b`, by arithmetic: a branch would be mispredicted.
    #[inline(always)]
    pub fn select(condition: bool, a: Self, b: Self) -> Self {
        let mask = u32::from(condition).wrapping_neg();
        Self {
            vertex: b.vertex ^ (a.vertex ^ b.vertex) & mask,
            ghost: b.ghost ^ (a.ghost ^ b.ghost) & mask,
        }
    }
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
pub(super) fn merge<W: Witness, const FILTERED: bool>(
    sheet: Sheet,
    left: HullVertex,
    right: HullVertex,
    [bottom, top]: [u32; 2],
    witness: W,
) -> Seam {
    let (left, right) = lower_tangent::<W, FILTERED>(sheet, left, right, witness);
    let mut knit = Knit::<W, FILTERED>::start(sheet, left, right, bottom, witness);
    knit.run();
    let upper = [knit.left, knit.right];
    knit.finish(bottom, top);
    Seam {
        lower: [left.vertex, right.vertex],
        upper,
        bottom,
        top,
    }
}

/// Walks both hulls downwards until no hull vertex lies below the line through both.
fn lower_tangent<W: Witness, const FILTERED: bool>(
    sheet: Sheet,
    mut left: HullVertex,
    mut right: HullVertex,
    witness: W,
) -> (HullVertex, HullVertex) {
    witness.tell(Deed::Tangent);
    loop {
        let mut moved = false;
        if right.ghost != NONE {
            let next = sheet.corner(right.ghost + 1);
            tell_turn(witness, sheet, [right.vertex, left.vertex, next]);
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
            tell_turn(witness, sheet, [right.vertex, left.vertex, before]);
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

/// The bit of the left lane.
const LEFT: u32 = 1;
/// The bit of the right lane.
const RIGHT: u32 = 2;

/// The state of a merge: the base runs from `left` to `right`, everything below is knitted.
struct Knit<W, const FILTERED: bool> {
    sheet: Sheet,
    witness: W,
    left: u32,
    right: u32,
    /// Ghost of the left hull's edge that starts at `left` and goes up.
    left_ghost: u32,
    /// Ghost of the right hull's edge that comes down to `right`.
    right_ghost: u32,
    /// Which sides have a ghost at all: a lone point has none, and its lane sees the other's.
    sides: u32,
    /// The upper side of the face below the base: the twin-to-be of the next triangle's base.
    base: u32,
}

/// The base of the next triangle, seen from its left end.
struct Base {
    origin: Point,
    /// The vector from the left end to the right one, and the square of its length.
    x: f64,
    y: f64,
    lift: f64,
}

/// The candidates for the next apex, one in each lane, relative to the left end of the base.
struct Candidates {
    vertices: [u32; 2],
    x: Pair,
    y: Pair,
    lift: Pair,
    /// Cross products with the base.
    cross: Pair,
    /// Which of them lie above the base.
    above: u32,
}

impl<W: Witness, const FILTERED: bool> Knit<W, FILTERED> {
    fn start(sheet: Sheet, left: HullVertex, right: HullVertex, bottom: u32, witness: W) -> Self {
        if W::IS_WATCHING {
            let base = names(sheet, [left.vertex, right.vertex]);
            witness.tell(Deed::Base(base));
            witness.tell(Deed::EdgeCreated(base));
        }
        sheet.set_ghost(bottom, left.vertex, right.vertex);
        let mut sides = 0;
        let (mut left_ghost, mut right_ghost) = (left.ghost, NONE);
        if left.ghost != NONE {
            sheet.bond(bottom + 1, sheet.twin(left.ghost + 1));
            sides |= LEFT;
        }
        if right.ghost != NONE {
            right_ghost = sheet.twin(right.ghost + 1) - 2;
            sheet.bond(bottom + 2, right.ghost + 1);
            sides |= RIGHT;
        }
        if left_ghost == NONE {
            left_ghost = right_ghost;
        }
        if right_ghost == NONE {
            right_ghost = left_ghost;
        }
        Self {
            sheet,
            witness,
            left: left.vertex,
            right: right.vertex,
            left_ghost,
            right_ghost,
            sides,
            base: bottom,
        }
    }

    /// Closes the seam with the ghost above the upper tangent.
    fn finish(self, bottom: u32, top: u32) {
        let Self { sheet, .. } = self;
        sheet.set_ghost(top, self.right, self.left);
        sheet.bond(top, self.base);
        if self.sides & LEFT == 0 {
            sheet.link_ghosts(top, bottom);
        } else {
            sheet.link_ghosts(top, self.left_ghost);
        }
        if self.sides & RIGHT == 0 {
            sheet.link_ghosts(bottom, top);
        } else {
            sheet.link_ghosts(self.right_ghost, top);
        }
    }

    /// Raises the base until neither side has a vertex above it.
    #[inline(always)]
    fn run(&mut self) {
        if self.sides == 0 {
            return;
        }
        loop {
            let origin = self.sheet.point(self.left);
            let end = self.sheet.point(self.right);
            let (x, y) = (end.x - origin.x, end.y - origin.y);
            let lift = x * x + y * y;
            let base = Base { origin, x, y, lift };
            let sheet = self.sheet;
            let inner = [sheet.twin(self.left_ghost), sheet.twin(self.right_ghost)];
            let behind = inner.map(|h| sheet.corner(h));
            let (apex, inside) = self.test(&base, behind);
            self.tell_tests(&apex, behind);
            if inside != 0 && self.delete(inside, inner, &apex, behind) {
                continue;
            }
            match apex.above {
                0 => return,
                LEFT => self.advance_left(apex.vertices[0]),
                RIGHT => self.advance_right(apex.vertices[1]),
                _ => {
                    let [l, r] = apex.vertices;
                    tell_circle(self.witness, sheet, [self.left, self.right, l, r]);
                    if self.is_right_inside(&base, &apex) {
                        self.advance_right(apex.vertices[1]);
                    } else {
                        self.advance_left(apex.vertices[0]);
                    }
                }
            }
        }
    }

    /// Tells which of the next vertices up both hulls lie above the base, and which of those have a
    /// vertex `behind` them inside the circle through the base.
    #[inline(always)]
    fn test(&self, base: &Base, behind: [u32; 2]) -> (Candidates, u32) {
        let vertices = [
            self.sheet.corner(self.left_ghost + 1),
            self.sheet.corner(self.right_ghost + 2),
        ];
        let (x, y) = self.arms(base, vertices);
        let (qx, qy) = self.arms(base, behind);
        let (bx, by, bl) = (
            Pair::both(base.x),
            Pair::both(base.y),
            Pair::both(base.lift),
        );
        let (orient, circle) = (Pair::both(ORIENT2D_BOUND), Pair::both(IN_CIRCLE_BOUND));

        let (plus, minus) = (bx * y, by * x);
        let cross = plus - minus;
        let cross_bound = orient * (plus.abs() + minus.abs());
        let lift = x * x + y * y;
        let q_lift = qx * qx + qy * qy;
        // Linear in what is behind, so that little is left to do when that arrives from memory. The
        // bound holds for this form too: up to the last subtraction the terms with qx and qy take
        // ten roundings, relative to |q|·(bl·|p| + lift·|b|), and the third nine, relative to
        // q_lift·|b|·|p|; the means of `IN_CIRCLE_BOUND` apply as they stand.
        let det = qx * (bl * y - by * lift) + qy * (bx * lift - bl * x) - q_lift * cross;
        let det_bound = q_lift * (circle * (lift + bl)) + circle * (lift * bl);

        let is_above = cross.exceeds(cross_bound);
        let is_inside = det.exceeds(det_bound);
        let cross_sure = cross.abs().exceeds(cross_bound);
        let det_sure = det.abs().exceeds(det_bound);
        // Behind what lies below the base, anything may lie, even the base's end.
        let sure = cross_sure.except(is_above.except(det_sure)).bits();
        let [above, inside] = if FILTERED && !sure & self.sides == 0 {
            [is_above.bits(), (is_above & is_inside).bits()]
        } else {
            let sure = [cross_sure, det_sure].map(|mask| if FILTERED { mask.bits() } else { 0 });
            let found = [is_above, is_inside].map(Mask::bits);
            let ends = [self.left, self.right];
            settle::<FILTERED>(self.sheet, ends, vertices, behind, sure, found)
        };
        let above = above & self.sides;
        let inside = inside & self.sides;
        let apex = Candidates {
            vertices,
            x,
            y,
            lift,
            cross,
            above,
        };
        (apex, inside)
    }

    /// The vectors from the base's left end to two vertices, one in each lane.
    #[inline(always)]
    fn arms(&self, base: &Base, vertices: [u32; 2]) -> (Pair, Pair) {
        let (l, r) = (self.sheet.point(vertices[0]), self.sheet.point(vertices[1]));
        (
            Pair::new(l.x, r.x) - Pair::both(base.origin.x),
            Pair::new(l.y, r.y) - Pair::both(base.origin.y),
        )
    }

    /// Whether the right candidate lies inside the circle through the base and the left one.
    #[inline(always)]
    fn is_right_inside(&self, base: &Base, apex: &Candidates) -> bool {
        let (l, r) = (apex.lift.left(), apex.lift.right());
        let mixed = apex.x.left() * apex.y.right() - apex.y.left() * apex.x.right();
        let det = r * apex.cross.left() - l * apex.cross.right() + base.lift * mixed;
        let bound = IN_CIRCLE_BOUND * (l * r + (l + r) * base.lift);
        if FILTERED && det > bound {
            false
        } else if FILTERED && det < -bound {
            true
        } else {
            let [l, r] = apex.vertices;
            exact_in_circle::<FILTERED>(self.sheet, self.left, self.right, l, r)
        }
    }

    /// Deletes the edges to the candidates whose bits are set; returns whether there was one.
    #[inline(always)]
    fn delete(&self, inside: u32, inner: [u32; 2], apex: &Candidates, behind: [u32; 2]) -> bool {
        // The sentinel of infinity, a far but finite point, may pass the filter.
        let left = inside & LEFT != 0 && behind[0] != self.sheet.infinite();
        let right = inside & RIGHT != 0 && behind[1] != self.sheet.infinite();
        if left {
            self.tell_deletion([self.left, apex.vertices[0], behind[0]]);
            self.delete_left(inner[0], apex.vertices[0], behind[0]);
        }
        if right {
            self.tell_deletion([apex.vertices[1], self.right, behind[1]]);
            self.delete_right(inner[1], apex.vertices[1], behind[1]);
        }
        left | right
    }

    /// Deletes the edge left → apex: its triangle becomes the ghost of behind → apex.
    #[inline(always)]
    fn delete_left(&self, inner: u32, apex: u32, behind: u32) {
        let (sheet, ghost) = (self.sheet, self.left_ghost);
        let (face, next, prev) = around(inner);
        let (outer, deeper, after) = (sheet.twin(next), sheet.twin(prev), sheet.twin(ghost + 2));
        sheet.set_ghost(face, behind, apex);
        sheet.bond(face, outer);
        sheet.bond(face + 2, after);
        sheet.bond(face + 1, ghost + 2);
        sheet.set_corner(ghost + 1, behind);
        sheet.bond(ghost, deeper);
    }

    /// Deletes the edge apex → right: its triangle becomes the ghost of apex → behind.
    #[inline(always)]
    fn delete_right(&self, inner: u32, apex: u32, behind: u32) {
        let (sheet, ghost) = (self.sheet, self.right_ghost);
        let (face, next, prev) = around(inner);
        let (deeper, outer, before) = (sheet.twin(next), sheet.twin(prev), sheet.twin(ghost + 1));
        sheet.set_ghost(face, apex, behind);
        sheet.bond(face, outer);
        sheet.bond(face + 1, before);
        sheet.bond(face + 2, ghost + 1);
        sheet.set_corner(ghost + 2, behind);
        sheet.bond(ghost, deeper);
    }

    /// Tells what [`test`](Self::test) has asked.
    #[inline(always)]
    fn tell_tests(&self, apex: &Candidates, behind: [u32; 2]) {
        if !W::IS_WATCHING {
            return;
        }
        let (sheet, ends) = (self.sheet, [self.left, self.right]);
        self.witness.tell(Deed::Raise(names(sheet, ends)));
        for side in [0, 1] {
            let [l, r, v] = [ends[0], ends[1], apex.vertices[side]];
            if self.sides >> side & 1 == 1 {
                tell_turn(self.witness, sheet, [l, r, v]);
            }
            if apex.above >> side & 1 == 1 {
                tell_circle(self.witness, sheet, [l, r, v, behind[side]]);
            }
        }
    }

    /// Tells that a triangle goes, and its edge between the first two corners.
    #[inline(always)]
    fn tell_deletion(&self, triangle: [u32; 3]) {
        if W::IS_WATCHING {
            let triangle = names(self.sheet, triangle);
            self.witness.tell(Deed::Delete);
            self.witness.tell(Deed::TriangleDeleted(triangle));
            self.witness
                .tell(Deed::EdgeDeleted([triangle[0], triangle[1]]));
        }
    }

    /// Tells that the base is joined to an apex.
    #[inline(always)]
    fn tell_join(&self, edge: [u32; 2], triangle: [u32; 3]) {
        if W::IS_WATCHING {
            self.witness.tell(Deed::Join);
            self.witness
                .tell(Deed::EdgeCreated(names(self.sheet, edge)));
            self.witness
                .tell(Deed::TriangleCreated(names(self.sheet, triangle)));
        }
    }

    /// Turns the left ghost into the triangle (right, apex, left).
    #[inline(always)]
    fn advance_left(&mut self, apex: u32) {
        self.tell_join([self.right, apex], [self.right, apex, self.left]);
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
        self.tell_join([self.left, apex], [self.left, self.right, apex]);
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
