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
//! Delaunay (Lee and Lin, 1986); nothing outside the corridor changes. A vertex may stand on a side
//! more than once, with an edge that only the corridor touched between.
//!
//! *Cost*: linear in the edges crossed for the scan; for the flips quadratic at worst, a few for each
//! edge crossed in practice.

use super::draft::{Ahead, Draft};
use super::side::Side;
use crate::predicates::{Orientation, orient2d};
use crate::{HalfEdgeId, TriangleId, VertexId};

/// A segment cannot be inserted: it crosses one that has been.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Blocked;

/// Inserts segments; keeps the lists that it needs from one to the next.
#[derive(Default)]
pub(super) struct Inserter {
    /// The triangles of the corridor.
    faces: Vec<TriangleId>,
    left: Side,
    right: Side,
    suspects: Vec<HalfEdgeId>,
}

impl Inserter {
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
        self.suspects.clear();
        // Counter-clockwise the right side runs from a to the end, the left side back to a.
        let right = self
            .right
            .fill::<false>(a, draft, &mut self.faces, &mut self.suspects);
        let left = self
            .left
            .fill::<true>(end, draft, &mut self.faces, &mut self.suspects);
        debug_assert!(
            self.faces.is_empty(),
            "bug: a corridor keeps its number of triangles"
        );
        draft.mesh.bond(left, right);
        draft.constrain(left);
        draft.legalise(&mut self.suspects);
        Ok(end)
    }

    /// Lists the triangles of the corridor and the edges along its sides; changes nothing.
    ///
    /// ```text
    ///            w                  crossing: r → l in the triangle behind, and its twin ahead, whose
    ///          /   \                apex w continues one of the sides, or is the end
    ///        l ----- r
    ///         \ ab↑ /
    /// ```
    fn collect(
        &mut self,
        draft: &Draft,
        [a, b]: [VertexId; 2],
        first: HalfEdgeId,
    ) -> Result<VertexId, Blocked> {
        self.faces.clear();
        self.left.clear();
        self.right.clear();
        self.faces.push(first.triangle());
        self.left.push(draft, first.next());
        self.right.push(draft, first.prev());
        let [from, to] = [a, b].map(|v| draft.point(v));
        let mut crossing = first;
        loop {
            if draft.marks.is_constrained(crossing) {
                return Err(Blocked);
            }
            let ahead = draft.mesh.twin(crossing);
            self.faces.push(ahead.triangle());
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
                    return Ok(w);
                }
            }
        }
    }
}
