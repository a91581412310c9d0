//! One segment: the triangles that it passes through are cleared, and the two sides of this corridor
//! triangulated anew.
//!
//! ```text
//!            l1 ----- l2 --- l3                    l1 ----- l2 --- l3
//!           /  \     /  \   /  \                  /    .----'  ..-'  \
//!          a ==============> end        →        a ================== end
//!           \    \ /     \ /   /                  \ `----.._     _.-' /
//!            `---- r1 --- r2 -'                    `---- r1 --- r2 --'
//! ```
//!
//! Each side is weakly visible from the segment, so a scan in the manner of Graham, which cuts ears as
//! it meets them, triangulates it in linear time (Toussaint and Avis, *On a convex hull algorithm for
//! polygons and its application to triangulation problems*, 1982). Flips then make it constrained
//! Delaunay (Lee and Lin, *Generalized Delaunay triangulation for planar graphs*, 1986); nothing
//! outside the corridor changes. A vertex may stand on a side more than once.
//!
//! Along smooth curves the number of flips is quadratic. When there have been more than a few for each
//! edge, the sides are triangulated [in bulk](super::bulk) instead.
//!
//! *Cost*: in practice linear in the edges crossed; O(k log k) for k of them along curves.

use super::bulk;
use super::draft::{Ahead, Draft};
use super::side::Side;
use crate::predicates::{Orientation, orient2d};
use crate::{HalfEdgeId, TriangleId, VertexId};

/// A segment cannot be inserted: it crosses one that has been.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Blocked;

/// Flips for each face of a corridor after which a side is triangulated in bulk: where flips get by at
/// all, two or three are enough.
const FLIPS_PER_FACE: usize = 32;

/// How deep bulk triangulations of sides may nest; each has fewer vertices than the one around it.
const MAX_DEPTH: u32 = 8;

/// Inserts segments; keeps the lists that it needs from one to the next.
#[derive(Default)]
pub(super) struct Inserter {
    /// The triangles of the corridor.
    faces: Vec<TriangleId>,
    left: Side,
    right: Side,
    suspects: Vec<HalfEdgeId>,
    /// How many bulk triangulations this one is part of.
    depth: u32,
}

impl Inserter {
    /// Makes an inserter for the side of a corridor of this one.
    pub fn nested(&self) -> Self {
        Self {
            depth: self.depth + 1,
            ..Self::default()
        }
    }

    /// Inserts the segment from `a` to `b`, which differ, and tells `through` of each vertex that it
    /// runs through. When it is blocked, the part before is in.
    pub fn insert(
        &mut self,
        draft: &mut Draft,
        a: VertexId,
        b: VertexId,
        mut through: impl FnMut(VertexId),
    ) -> Result<(), Blocked> {
        let mut from = a;
        loop {
            from = match draft.ahead(from, draft.point(b)) {
                Ahead::Along(h) => {
                    draft.constrain(h);
                    draft.mesh.dest(h)
                }
                Ahead::Across(h) => self.insert_across(draft, from, b, h)?,
                Ahead::Outside => unreachable!("bug: a segment leaves the hull"),
            };
            if from == b {
                return Ok(());
            }
            through(from);
        }
    }

    /// Inserts the part of the segment `ab` up to the first vertex on it, which is returned; `first`
    /// is the edge through which it leaves the triangles of `a`.
    fn insert_across(
        &mut self,
        draft: &mut Draft,
        a: VertexId,
        b: VertexId,
        first: HalfEdgeId,
    ) -> Result<VertexId, Blocked> {
        let end = self.collect(draft, [a, b], first)?;
        if !self.fill(draft, a, end) {
            self.fill_in_bulk(draft, a, end);
        }
        for &face in &self.faces {
            draft.marks.leave_corridor(face);
        }
        Ok(end)
    }

    /// Fills both sides by scanning and flipping; false if that takes too many flips.
    fn fill(&mut self, draft: &mut Draft, a: VertexId, end: VertexId) -> bool {
        self.suspects.clear();
        let mut faces = self.faces.iter().copied();
        // Counter-clockwise the right side runs from a to the end, the left side back to a.
        let right = self.right.fill(a, draft, &mut faces, &mut self.suspects);
        let left = self.left.fill(end, draft, &mut faces, &mut self.suspects);
        draft.mesh.bond(left, right);
        draft.constrain(left);
        let budget = self.budget();
        draft.legalise(&mut self.suspects, budget)
    }

    /// Returns how many flips are allowed.
    fn budget(&self) -> usize {
        match self.faces.len() {
            _ if self.depth == MAX_DEPTH => usize::MAX,
            // Both ways lead to the same triangles. Debug builds take the rare one often, for the tests.
            n if cfg!(debug_assertions) && n % 2 == 0 => 0,
            n => FLIPS_PER_FACE * n,
        }
    }

    /// Fills both sides anew, after flips have not got by.
    #[cold]
    fn fill_in_bulk(&mut self, draft: &mut Draft, a: VertexId, end: VertexId) {
        let mut faces = self.faces.iter().copied();
        let right = bulk::fill(&self.right, a, draft, &mut faces, self.nested());
        let left = bulk::fill(&self.left, end, draft, &mut faces, self.nested());
        draft.mesh.bond(left, right);
        draft.constrain(left);
    }

    /// Lists the triangles of the corridor and the edges along its sides; of the draft it marks the
    /// faces only.
    ///
    /// ```text
    ///            w                  crossing: r → l in the triangle behind, and its twin ahead, whose
    ///          /   \                apex w continues one of the sides, or is the end
    ///        l ----- r
    ///         \ ab↑ /
    /// ```
    fn collect(
        &mut self,
        draft: &mut Draft,
        [a, b]: [VertexId; 2],
        first: HalfEdgeId,
    ) -> Result<VertexId, Blocked> {
        self.faces.clear();
        self.left.clear();
        self.right.clear();
        self.enter(draft, first.triangle());
        self.left.push(draft, first.next());
        self.right.push(draft, first.prev());
        let [from, to] = [a, b].map(|v| draft.point(v));
        let mut crossing = first;
        let end = loop {
            if draft.marks.is_constrained(crossing) {
                return Err(Blocked);
            }
            let ahead = draft.mesh.twin(crossing);
            self.enter(draft, ahead.triangle());
            let [rw, wl] = [ahead.next(), ahead.prev()];
            let w = draft.mesh.apex(ahead);
            let side = if w == b {
                Orientation::Collinear
            } else {
                orient2d(from, to, draft.point(w))
            };
            match side {
                Orientation::Left => {
                    self.left.push(draft, wl);
                    crossing = rw;
                }
                Orientation::Right => {
                    self.right.push(draft, rw);
                    crossing = wl;
                }
                Orientation::Collinear => {
                    self.left.push(draft, wl);
                    self.right.push(draft, rw);
                    break w;
                }
            }
        };
        self.left.reverse();
        Ok(end)
    }

    fn enter(&mut self, draft: &mut Draft, face: TriangleId) {
        draft.marks.enter_corridor(face);
        self.faces.push(face);
    }
}
