//! Which faces belong to the domain, and what is seen of the others: they close the sphere, as ghosts do, and no event
//! names them.

use super::{Board, is_finite};
use crate::{Event, HalfEdgeId, Observer, TriangleId, VertexId};

impl<O: Observer> Board<'_, O> {
    /// Visits the triangles of the domain.
    pub fn triangles(&self) -> impl Iterator<Item = [VertexId; 3]> + '_ {
        let inside = self.mesh.triangles().filter(|&t| !self.is_carved(t));
        inside.map(|t| self.mesh.corners(t))
    }

    /// Tells whether a face is a triangle of the domain: no ghost, and not carved away.
    pub fn is_inside(&self, t: TriangleId) -> bool {
        !self.mesh.is_ghost(t) && !self.is_carved(t)
    }

    /// Tells whether a face is a triangle outside of the domain.
    pub fn is_carved(&self, t: TriangleId) -> bool {
        self.outside.get(t.index()).is_some_and(|&carved| carved)
    }

    /// Tells whether the edge of `h` is there for who watches: all are that have no end at infinity, but
    /// for those amid carved faces.
    pub fn is_visible(&self, h: HalfEdgeId) -> bool {
        let sides = [h, self.mesh.twin(h)].map(HalfEdgeId::triangle);
        is_finite(&self.ends(h))
            && (!sides.iter().any(|&t| self.is_carved(t))
                || sides.iter().any(|&t| self.is_inside(t))
                || self.is_locked(h))
    }

    /// Lists the edges that are there for who watches, each as one of its half-edges.
    pub fn visible_edges(&self) -> Vec<HalfEdgeId> {
        let edges = self.mesh.half_edges().filter(|&h| h < self.mesh.twin(h));
        edges.filter(|&h| self.is_visible(h)).collect()
    }

    /// Tells of all that there is.
    pub(super) fn tell_all(&mut self) {
        if !self.is_watched() {
            return;
        }
        for h in self.visible_edges() {
            let edge = self.ends(h);
            self.tell(|| Event::EdgeCreated { edge });
        }
        for edge in self.locked().iter().copied().collect::<Vec<_>>() {
            self.tell(|| Event::EdgeLocked { edge });
        }
        for t in self
            .mesh()
            .triangles()
            .filter(|&t| self.is_inside(t))
            .collect::<Vec<_>>()
        {
            let triangle = self.mesh().corners(t);
            self.tell(|| Event::TriangleCreated { triangle });
        }
    }

    /// Carves faces out of the domain: they stay to close the sphere, but are part of nothing any more, nor
    /// are edges between them, unless they are constraints.
    pub fn carve(&mut self, outside: Vec<bool>) {
        debug_assert!(self.outside.is_empty(), "bug: carved before");
        let edges = match self.observer.is_watching() {
            true => self.visible_edges(),
            false => Vec::new(),
        };
        self.outside = outside;
        for t in self
            .mesh
            .triangles()
            .filter(|&t| self.is_carved(t))
            .collect::<Vec<_>>()
        {
            let triangle = self.mesh.corners(t);
            self.tell(|| Event::TriangleDeleted { triangle });
        }
        for h in edges {
            if !self.is_visible(h) {
                let edge = self.ends(h);
                self.tell(|| Event::EdgeDeleted { edge });
            }
        }
    }

    /// Returns the corners of a face as far as they are told: those of a carved one are all at infinity.
    pub(super) fn told_corners(&self, t: TriangleId) -> [VertexId; 3] {
        if self.is_carved(t) {
            return [VertexId::INFINITE; 3];
        }
        self.mesh.corners(t)
    }

    /// Lets the faces of some half-edges, new ones among them, be carved if `t` is.
    pub(super) fn inherit(&mut self, t: TriangleId, parts: &[HalfEdgeId]) {
        if self.outside.is_empty() {
            return;
        }
        self.outside.resize(self.mesh.num_faces(), false);
        for part in parts {
            self.outside[part.triangle().index()] = self.outside[t.index()];
        }
    }
}
