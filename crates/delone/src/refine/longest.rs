//! Paths of longest edges: where bisection of a triangle would have to begin.
//!
//! A path goes on from a triangle across its longest edge, as long as the one beyond has a still longer
//! one. At its end lies an edge that is the longest around, the only one that may be halved without
//! making smaller angles than there are (Rivara, *New longest-edge algorithms for the refinement and/or
//! improvement of unstructured triangulations*, 1997). If that edge is locked, so is all on the path.
//!
//! Lengths are compared exactly. Edges grow along a path, so it ends, and paths that meet stay together:
//! whatever was found out about one triangle holds for all before it.

use crate::predicates::compare_distances;
use crate::{ConstrainedTriangulation, HalfEdgeId, Point, TriangleId};
use std::cmp::Ordering;
use std::collections::HashMap;

/// Follows paths, and remembers how they end.
pub(super) struct Paths<'a> {
    mesh: &'a ConstrainedTriangulation,
    /// Whether the path of a triangle ends at a locked edge; only asked, never listed.
    known: HashMap<TriangleId, bool>,
}

impl<'a> Paths<'a> {
    pub fn of(mesh: &'a ConstrainedTriangulation) -> Self {
        Self {
            mesh,
            known: HashMap::new(),
        }
    }

    /// Tells whether the path of longest edges from `t` ends at a locked one.
    ///
    /// *Cost*: linear in the triangles on the path, which are looked at once for all calls.
    pub fn ends_at(&mut self, t: TriangleId, is_locked: impl Fn(HalfEdgeId) -> bool) -> bool {
        let mesh = self.mesh.triangulation().mesh();
        let mut path = vec![t];
        let mut h = self.longest(t);
        let found = loop {
            if let Some(&known) = self.known.get(&h.triangle()) {
                break known;
            }
            if is_locked(h) {
                break true;
            }
            let beyond = mesh.twin(h);
            if beyond.triangle().index() >= self.mesh.triangulation().num_triangles() {
                break false;
            }
            h = self.longest(beyond.triangle());
            if self.compare(h, beyond).is_eq() {
                break false;
            }
            path.push(h.triangle());
        };
        self.known.extend(path.into_iter().map(|t| (t, found)));
        found
    }

    /// Returns the longest edge of a triangle; of equally long ones that with the smallest apex.
    fn longest(&self, t: TriangleId) -> HalfEdgeId {
        let [a, b, c] = t.half_edges();
        [b, c].into_iter().fold(a, |best, h| {
            let [apex, other] = [h, best].map(|h| self.apex(h));
            let order = self.compare(h, best);
            match order.then_with(|| other.lex_cmp(&apex)) {
                Ordering::Greater => h,
                _ => best,
            }
        })
    }

    /// Compares the lengths of two edges of one triangle.
    fn compare(&self, g: HalfEdgeId, h: HalfEdgeId) -> Ordering {
        if g == h {
            return Ordering::Equal;
        }
        // They meet in the third corner; each goes to the apex of the other.
        let shared = 3 - g.slot() - h.slot();
        let shared = self.apex(g.triangle().half_edges()[shared]);
        compare_distances(shared, self.apex(h), self.apex(g))
    }

    fn apex(&self, h: HalfEdgeId) -> Point {
        let triangulation = self.mesh.triangulation();
        triangulation.point(triangulation.mesh().apex(h))
    }
}
