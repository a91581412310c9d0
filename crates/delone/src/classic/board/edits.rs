//! What the algorithms do: edits of the mesh, and the events that tell of them.

use super::{Board, is_finite};
use crate::classic::ascending;
use crate::delaunay::check_number;
use crate::{Error, Event, HalfEdgeId, Observer, Point, TriangleId, VertexId};
use std::collections::BTreeSet;

impl<O: Observer> Board<'_, O> {
    /// Adds a vertex that nothing hangs on yet.
    ///
    /// # Errors
    /// [`Error::TooManyPoints`].
    pub fn create_vertex(&mut self, at: Point) -> Result<VertexId, Error> {
        check_number(self.points.len() + 1)?;
        let vertex = VertexId::new(self.points.len());
        self.points.push(at);
        self.tell(|| Event::VertexCreated { vertex, at });
        Ok(vertex)
    }

    /// Deletes the last vertex, which nothing hangs on any more.
    pub fn delete_last_vertex(&mut self) {
        let at = self.points.pop().expect("bug: there is no vertex");
        let vertex = VertexId::new(self.points.len());
        self.tell(|| Event::VertexDeleted { vertex, at });
    }

    /// Makes the edge of `h` a constraint.
    pub fn lock(&mut self, h: HalfEdgeId) {
        let edge = ascending(self.ends(h));
        if self.locked.insert(edge) {
            self.tell(|| Event::EdgeLocked { edge });
        }
    }

    /// [`Mesh::seed`]: the mesh of two vertices.
    pub fn seed(&mut self, a: VertexId, b: VertexId) -> HalfEdgeId {
        let h = self.mesh.seed(a, b);
        self.note([h, self.mesh.twin(h)].map(HalfEdgeId::triangle));
        self.tell_change(&[], &[], &[[a, b]], &[]);
        h
    }

    /// [`Mesh::split_face`]: joins a vertex to the corners of a face; of a ghost it makes a triangle.
    pub fn split_face(&mut self, t: TriangleId, v: VertexId) -> [HalfEdgeId; 3] {
        let old = self.told_corners(t);
        let link = self.mesh.split_face(t, v);
        self.note(link.map(HalfEdgeId::triangle));
        self.inherit(t, &link);
        let new = link.map(|h| self.told_corners(h.triangle()));
        self.tell_change(&[old], &[], &old.map(|w| [v, w]), &new);
        link
    }

    /// [`Mesh::split_edge`]: joins a vertex on an edge to the corners of its two faces. Halves of a
    /// constraint are constraints.
    pub fn split_edge(&mut self, h: HalfEdgeId, v: VertexId) -> [HalfEdgeId; 4] {
        let [a, b] = self.ends(h);
        let g = self.mesh.twin(h);
        let old = [h, g].map(|s| self.told_corners(s.triangle()));
        let [c, d] = [h, g].map(|s| self.told_corners(s.triangle())[s.slot()]);
        let gone = self.is_visible(h).then_some([a, b]);
        let around: &[_] = if gone.is_some() { &[a, b, c, d] } else { &[] };
        let edges: Vec<_> = around.iter().map(|&w| [v, w]).collect();
        let was_locked = self.locked.remove(&ascending([a, b]));
        if was_locked {
            self.tell(|| Event::EdgeUnlocked { edge: [a, b] });
        }
        let link = self.mesh.split_edge(h, v);
        self.note(link.map(HalfEdgeId::triangle));
        self.inherit(h.triangle(), &[link[0], link[3]]);
        self.inherit(g.triangle(), &[link[1], link[2]]);
        let new = link.map(|h| self.told_corners(h.triangle()));
        self.tell_change(&old, gone.as_slice(), &edges, &new);
        for end in [a, b].into_iter().filter(|_| was_locked) {
            let edge = ascending([end, v]);
            self.locked.insert(edge);
            self.tell(|| Event::EdgeLocked { edge });
        }
        link
    }

    /// [`Mesh::open_edge`]: with the destination of `h` at infinity, lengthens a row of vertices.
    pub fn open_edge(&mut self, h: HalfEdgeId, v: VertexId) -> [HalfEdgeId; 2] {
        let ends = self.ends(h);
        let link = self.mesh.open_edge(h, v);
        self.note(link.map(HalfEdgeId::triangle));
        self.tell_change(&[], &[], &ends.map(|w| [v, w]), &[]);
        link
    }

    /// [`Mesh::contract`]: removes the hull vertex from which `spoke` runs to infinity. Its other neighbours,
    /// which must form a convex chain, become part of the hull.
    ///
    /// *Ids invalidated*: all but those of vertices.
    pub fn uncover(&mut self, spoke: HalfEdgeId) {
        debug_assert!(self.outside.is_empty() && self.ends(spoke)[1].is_infinite());
        if self.observer.is_watching() {
            let star: Vec<_> = self.mesh.star(spoke).collect();
            let old: Vec<_> = star
                .iter()
                .map(|h| self.mesh.corners(h.triangle()))
                .collect();
            self.tell_change(&old, &[], &[], &[]);
            for h in star {
                self.tell_change(&[], &[self.ends(h)], &[], &[]);
            }
        }
        let _ = self.mesh.contract(spoke);
        self.note_all();
    }

    /// [`Mesh::flip`]: the other diagonal takes the place of an edge.
    pub fn flip(&mut self, h: HalfEdgeId) {
        let g = self.mesh.twin(h);
        let from = self.ends(h);
        let to = [self.mesh.apex(h), self.mesh.apex(g)];
        let old = [h, g].map(|s| self.mesh.corners(s.triangle()));
        self.mesh.flip(h);
        self.note([h, g].map(HalfEdgeId::triangle));
        if !from.iter().chain(&to).any(|v| v.is_infinite()) {
            self.tell(|| Event::EdgeFlipped { from, to });
            return;
        }
        let new = [h, g].map(|s| self.mesh.corners(s.triangle()));
        self.tell_change(&old, &[from], &[to], &new);
    }

    /// [`Mesh::fill`]: joins `v` to the rim of a disc of faces, instead of what was in it.
    pub fn fill(&mut self, mut faces: Vec<TriangleId>, rim: &[HalfEdgeId], v: VertexId) {
        let old: Vec<_> = faces.iter().map(|&t| self.mesh.corners(t)).collect();
        let inner = self.inner_edges(&faces);
        self.mesh.fill(&mut faces, rim, &mut Vec::new(), v);
        self.note(faces.iter().copied());
        let new: Vec<_> = faces.iter().map(|&t| self.mesh.corners(t)).collect();
        let spokes: Vec<_> = rim.iter().map(|&h| [v, self.mesh.origin(h)]).collect();
        self.tell_change(&old, &inner, &spokes, &new);
    }

    /// Returns the edges between faces of a disc, if anybody listens.
    fn inner_edges(&self, faces: &[TriangleId]) -> Vec<[VertexId; 2]> {
        if !self.observer.is_watching() {
            return Vec::new();
        }
        let disc: BTreeSet<_> = faces.iter().copied().collect();
        let half_edges = faces.iter().flat_map(|t| t.half_edges());
        let inner = half_edges.filter(|&h| {
            let g = self.mesh.twin(h);
            h < g && disc.contains(&g.triangle())
        });
        inner.map(|h| self.ends(h)).collect()
    }

    /// Tells of faces and edges that go and come, as far as they are finite.
    fn tell_change(
        &mut self,
        old: &[[VertexId; 3]],
        gone: &[[VertexId; 2]],
        edges: &[[VertexId; 2]],
        new: &[[VertexId; 3]],
    ) {
        if !self.observer.is_watching() {
            return;
        }
        for triangle in old.iter().copied().filter(is_finite) {
            self.tell(|| Event::TriangleDeleted { triangle });
        }
        for edge in gone.iter().copied().filter(is_finite) {
            self.tell(|| Event::EdgeDeleted { edge });
        }
        for edge in edges.iter().copied().filter(is_finite) {
            self.tell(|| Event::EdgeCreated { edge });
        }
        for triangle in new.iter().copied().filter(is_finite) {
            self.tell(|| Event::TriangleCreated { triangle });
        }
    }
}
