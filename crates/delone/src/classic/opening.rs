//! Triangulation around a new point as the slides do it: triangles in conflict are opened with a stack of edges.
//!
//! For the mesh this is a split and flips. For who watches, edges are deleted first, then spokes are drawn, and
//! at last there are triangles again.

use super::Board;
use crate::locate::Location;
use crate::predicates::Orientation;
use crate::{Event, HalfEdgeId, Observer, VertexId};

impl<O: Observer> Board<'_, O> {
    /// Opens all triangles in conflict with `p`, beginning where it lies, and joins `p` to the rim. Returns a
    /// half-edge that starts at `p`. Counts the lines of the pseudocode of
    /// [`segment_walk`](super::segment_walk).
    ///
    /// ```text
    ///          c                  The stack holds edges ab of the hole that have not been tested, a and b
    ///         / \                 counter-clockwise about p. If p lies in the circle of the face beyond, its
    ///        /   \                apex c enters the rim, and ac is tested next: so the rim comes out
    ///       a-----b  ← tested     counter-clockwise.
    ///        ╲ p ╱
    /// ```
    pub fn open_and_join(&mut self, at: Location, p: VertexId) -> HalfEdgeId {
        self.at(5);
        if let Location::Beyond(h) = at {
            self.at(10);
            return self.open_edge(h, p)[0].prev();
        }
        let mut stack = self.open(at, p);
        stack.reverse();
        for &h in &stack {
            self.tell_suspect(h, true);
        }
        let first = stack[0].prev();
        while let Some(h) = stack.pop() {
            self.at(6);
            self.tell_suspect(h, false);
            if self.is_in_conflict(h, p) {
                self.open_beyond(h, &mut stack);
            } else {
                self.at(10);
                self.tell_spoke(self.mesh().origin(h), p);
            }
        }
        self.tell_star(first);
        first
    }

    /// Opens the faces where `p` lies, and returns the edges around it.
    fn open(&mut self, at: Location, p: VertexId) -> Vec<HalfEdgeId> {
        match at {
            Location::Face(t) => {
                self.tell_deleted(t.half_edges()[0]);
                self.mesh_mut().split_face(t, p).to_vec()
            }
            Location::Outside(h) => self.mesh_mut().split_face(h.triangle(), p).to_vec(),
            Location::Edge(h) => {
                let (edge, twin) = (self.ends(h), self.mesh().twin(h));
                self.tell_deleted(h);
                self.tell_deleted(twin);
                self.tell(|| Event::EdgeDeleted { edge });
                self.mesh_mut().split_edge(h, p).to_vec()
            }
            _ => unreachable!("bug: the points are distinct, and nothing is carved"),
        }
    }

    /// Tells whether `p` lies in the circle of the face beyond `h`; that of a ghost is the half-plane beyond its
    /// hull edge.
    fn is_in_conflict(&mut self, h: HalfEdgeId, p: VertexId) -> bool {
        self.at(8);
        let beyond = self.mesh().twin(h).triangle();
        if self.mesh().is_ghost(beyond) {
            let [a, b] = self.ends(self.mesh().hull_edge_of(beyond));
            return a != p && b != p && self.orient(a, b, p) == Orientation::Left;
        }
        let triangle = self.mesh().corners(beyond);
        self.in_circle(triangle, p)
    }

    /// Opens the face beyond `h`, and lets its two other edges wait.
    fn open_beyond(&mut self, h: HalfEdgeId, stack: &mut Vec<HalfEdgeId>) {
        self.at(9);
        let (edge, twin) = (self.ends(h), self.mesh().twin(h));
        self.tell_deleted(twin);
        if !edge.iter().any(|v| v.is_infinite()) {
            self.tell(|| Event::EdgeDeleted { edge });
        }
        self.mesh_mut().flip(h);
        for next in [twin.prev(), h] {
            self.tell_suspect(next, true);
            stack.push(next);
        }
    }

    /// Tells that the face of `h` is no more, if it is a triangle.
    fn tell_deleted(&mut self, h: HalfEdgeId) {
        let triangle = self.mesh().corners(h.triangle());
        if !self.mesh().is_ghost(h.triangle()) {
            self.tell(|| Event::TriangleDeleted { triangle });
        }
    }

    fn tell_spoke(&mut self, a: VertexId, p: VertexId) {
        if !a.is_infinite() {
            self.tell(|| Event::EdgeCreated { edge: [a, p] });
        }
    }

    /// Tells of the triangles around the origin of `h`.
    fn tell_star(&mut self, h: HalfEdgeId) {
        if !self.is_watched() {
            return;
        }
        let star: Vec<_> = self.mesh().star(h).map(HalfEdgeId::triangle).collect();
        for t in star {
            let triangle = self.mesh().corners(t);
            if !self.mesh().is_ghost(t) {
                self.tell(|| Event::TriangleCreated { triangle });
            }
        }
    }
}
