//! Paths of longest edges, from a triangle to the edge that it hangs on.
//!
//! The path of a triangle leads across its longest edge, of equally long ones that opposite the
//! lexicographically smallest corner, into the triangle beyond, and on from there as long as edges get
//! longer; it ends where the triangle beyond has no longer one, or where nothing of the domain is beyond, or
//! at a locked edge. Lengths are compared exactly.

use super::super::super::adjacency::Adjacency;
use super::Found;
use crate::pace::Pace;
use crate::predicates::compare_distances;
use crate::{Error, HalfEdgeId, Point, TriangleId, VertexId};
use std::cmp::Ordering;
use std::collections::HashMap;

/// Follows paths, and remembers where they end.
pub(super) struct Paths<'p> {
    points: &'p [Point],
    adjacency: &'p Adjacency<'p>,
    /// Whether the path of a triangle ends at a locked edge; only asked, never listed.
    known: HashMap<TriangleId, bool>,
}

impl<'p> Paths<'p> {
    pub fn new(found: &'p Found<'p>) -> Self {
        Self {
            points: found.points,
            adjacency: found.adjacency,
            known: HashMap::new(),
        }
    }

    /// Tells whether the path of a triangle ends at a locked edge.
    ///
    /// *Cost*: for all calls together linear in the triangles on their paths.
    pub fn ends_at_locked(
        &mut self,
        triangle: TriangleId,
        is_locked: impl Fn([VertexId; 2]) -> bool,
        pace: &mut Pace,
    ) -> Result<bool, Error> {
        let mut path = Vec::new();
        let mut t = triangle;
        let is_found = loop {
            pace.step()?;
            if let Some(&known) = self.known.get(&t) {
                break known;
            }
            path.push(t);
            let way = self.longest(t);
            if is_locked([self.adjacency.origin(way), self.adjacency.dest(way)]) {
                break true;
            }
            let beyond = self.adjacency.twin(way);
            let Some(beyond) = beyond.filter(|&beyond| self.is_exceeded(beyond)) else {
                break false;
            };
            t = beyond.triangle();
        };
        self.known.extend(path.into_iter().map(|t| (t, is_found)));
        Ok(is_found)
    }

    fn longest(&self, t: TriangleId) -> HalfEdgeId {
        let longer = |g: HalfEdgeId, h: HalfEdgeId| {
            let by_apex = || self.apex(h).lex_cmp(&self.apex(g));
            match self.compare(g, h).then_with(by_apex) {
                Ordering::Less => h,
                _ => g,
            }
        };
        let [a, b, c] = t.half_edges();
        longer(longer(a, b), c)
    }

    /// Tells whether the triangle has a longer edge.
    fn is_exceeded(&self, h: HalfEdgeId) -> bool {
        let mut others = [h.next(), h.prev()].into_iter();
        others.any(|other| self.compare(other, h).is_gt())
    }

    /// Compares the lengths of two edges of a triangle, which meet in the corner opposite the third.
    fn compare(&self, g: HalfEdgeId, h: HalfEdgeId) -> Ordering {
        let third = if g.next() == h { h.next() } else { g.next() };
        let [p, at_g, at_h] = [third, g, h].map(|h| self.apex(h));
        compare_distances(p, at_h, at_g)
    }

    fn apex(&self, h: HalfEdgeId) -> Point {
        self.points[self.adjacency.apex(h).index()]
    }
}
