//! Straight walks: from a vertex towards a point, and what lies on the way.
//!
//! Where edges are constrained, the visibility walk of [`locate`](crate::locate) may run in circles; a
//! straight walk ends in every triangulation (Devillers, Pion and Teillaud, *Walking in a
//! triangulation*, 2002). Every sign is exact.
//!
//! *Cost*: one or two orientation tests for each edge crossed, and the degree of each vertex passed.

use crate::constrained::{Ahead, Draft};
use crate::locate::Location;
use crate::predicates::{Orientation, orient2d};
use crate::{HalfEdgeId, Point, VertexId};

/// Finds where `goal` lies, walking from vertex `from`; there are at least two vertices.
pub(super) fn locate(draft: &Draft, from: VertexId, goal: Point) -> Location {
    let sight = Sight::new(draft, from, goal);
    let mut next = sight.leave(from);
    loop {
        next = match next {
            Next::Vertex(v) => sight.leave(v),
            Next::Across(h) => sight.cross(h),
            Next::Arrived(location) => return location,
        }
    }
}

/// Finds the first constrained edge that the open segment between two vertices crosses.
pub(super) fn first_in_the_way(draft: &Draft, [a, b]: [VertexId; 2]) -> Option<HalfEdgeId> {
    let sight = Sight::new(draft, a, draft.point(b));
    let mut next = sight.leave(a);
    loop {
        next = match next {
            Next::Vertex(v) => sight.leave(v),
            Next::Across(h) if draft.marks.is_constrained(h) => return Some(h),
            Next::Across(h) => sight.cross(h),
            Next::Arrived(_) => return None,
        }
    }
}

/// A line of sight.
struct Sight<'a> {
    draft: &'a Draft,
    from: Point,
    goal: Point,
}

/// What comes next on the way to the goal.
enum Next {
    /// A vertex, which the line passes.
    Vertex(VertexId),
    /// An edge, which it crosses. The half-edge belongs to the triangle before.
    Across(HalfEdgeId),
    /// The goal.
    Arrived(Location),
}

impl<'a> Sight<'a> {
    fn new(draft: &'a Draft, from: VertexId, goal: Point) -> Self {
        Self {
            draft,
            from: draft.point(from),
            goal,
        }
    }

    /// Goes on from a vertex.
    fn leave(&self, v: VertexId) -> Next {
        let place = self.draft.point(v);
        if place == self.goal {
            return Next::Arrived(Location::Vertex(v));
        }
        match self.draft.ahead(v, self.goal) {
            Ahead::Along(h) => {
                let w = self.draft.mesh.dest(h);
                self.stop_before(w, Location::Edge(h))
            }
            Ahead::Across(h) => self.reach(h),
            Ahead::Outside => Next::Arrived(self.outside(v)),
        }
    }

    /// Goes on from the open edge of `h`, through the face beyond.
    ///
    /// ```text
    ///            w                  h runs from r to l; w lies to the left of the line of sight, which
    ///          /   \                then leaves by rw, to its right, or upon it
    ///        l ----- r
    ///         \ h→  /
    /// ```
    fn cross(&self, h: HalfEdgeId) -> Next {
        let mesh = &self.draft.mesh;
        let beyond = mesh.twin(h);
        let w = mesh.apex(beyond);
        if w.is_infinite() {
            return Next::Arrived(Location::Outside(beyond));
        }
        match orient2d(self.from, self.goal, self.draft.point(w)) {
            Orientation::Left => self.reach(beyond.next()),
            Orientation::Right => self.reach(beyond.prev()),
            Orientation::Collinear => self.stop_before(w, Location::Face(beyond.triangle())),
        }
    }

    /// Looks at an edge that the line would cross: the goal may lie upon it, or before.
    fn reach(&self, h: HalfEdgeId) -> Next {
        match self.draft.side_of(h, self.goal) {
            Orientation::Left => Next::Arrived(Location::Face(h.triangle())),
            Orientation::Collinear => Next::Arrived(Location::Edge(h)),
            Orientation::Right => Next::Across(h),
        }
    }

    /// Stops at a vertex on the line, or at the goal, if that comes first and lies at `location`.
    fn stop_before(&self, w: VertexId, location: Location) -> Next {
        let place = self.draft.point(w);
        if place == self.goal {
            Next::Arrived(Location::Vertex(w))
        } else if self.from.lex_cmp(&self.goal) == self.goal.lex_cmp(&place) {
            Next::Arrived(location)
        } else {
            Next::Vertex(w)
        }
    }

    /// Says where the goal lies, which is not seen from `v` through any triangle.
    fn outside(&self, v: VertexId) -> Location {
        let mesh = &self.draft.mesh;
        let to_infinity = || self.draft.star(v).filter(|&h| mesh.dest(h).is_infinite());
        // Of the two ghosts beside an edge to infinity each has one edge of the hull.
        let hull_edges = to_infinity().flat_map(|h| [h.prev(), mesh.twin(h).next()]);
        let sees = |&h: &HalfEdgeId| self.draft.side_of(h, self.goal) == Orientation::Left;
        match { hull_edges }.find(sees) {
            Some(h) => Location::Outside(h),
            None => Location::Beyond(to_infinity().next().expect("bug: v is not on the hull")),
        }
    }
}
