//! The edits of the mesh that change how many faces there are, done on a draft: marks and outgoing
//! half-edges go with them.

use super::draft::{Draft, Mark, NOWHERE};
use crate::delaunay::Growing;
use crate::mesh::Moved;
use crate::{HalfEdgeId, Mesh, Point, TriangleId, VertexId};

impl Draft {
    /// Puts vertex `v` at `point`; vertices have places of their own, used or not.
    pub fn set_point(&mut self, v: VertexId, point: Point) {
        if v.index() == self.points.len() {
            self.points.push(point);
            self.outgoing.push(NOWHERE);
        } else {
            self.points[v.index()] = point;
        }
    }

    /// As [`Mesh::seed`].
    pub fn seed(&mut self, a: VertexId, b: VertexId) {
        let ab = self.mesh.seed(a, b);
        self.marks.set_number(0);
        self.marks.set_number(2);
        self.note(ab);
        self.note(self.mesh.twin(ab));
    }

    /// Drops all faces, of the only vertices `a` and `b`.
    pub fn clear(&mut self, [a, b]: [VertexId; 2]) {
        self.mesh.clear();
        self.marks.set_number(0);
        for v in [a, b] {
            self.outgoing[v.index()] = NOWHERE;
        }
    }

    /// As [`Mesh::contract`]; of the edges that become one, those of the other vertex decide whether it
    /// is constrained.
    pub fn contract(&mut self, h: HalfEdgeId) -> [Moved; 2] {
        let g = self.mesh.twin(h);
        let v = self.mesh.origin(h);
        let [ca, vc, dv, ad] =
            [h.next(), h.prev(), g.next(), g.prev()].map(|edge| self.mesh.twin(edge));
        self.marks.set(vc, self.marks.get(ca));
        self.marks.set(dv, self.marks.get(ad));
        let gone = [h.triangle(), g.triangle()];
        // One of them starts at each of a, c and d, unless that is at infinity.
        let stay = [ca, vc, vc.next(), dv, ad, ad.next()];
        let stay = stay.map(|edge| (!gone.contains(&edge.triangle())).then_some(edge));
        let moved = self.mesh.contract(h);
        for moved in moved {
            self.marks.swap_remove(moved.to);
        }
        for edge in stay.into_iter().flatten() {
            self.note(moved.iter().fold(edge, |edge, moved| moved.half_edge(edge)));
        }
        for moved in moved {
            // The second one may have moved the first one again.
            if moved.to.index() < self.mesh.num_faces() {
                for edge in moved.to.half_edges() {
                    self.note(edge);
                }
            }
        }
        self.outgoing[v.index()] = NOWHERE;
        moved
    }

    /// Takes note of faces that have been appended, and of one half-edge.
    fn note_grown(&mut self, h: HalfEdgeId) {
        self.marks.set_number(self.mesh.num_faces());
        self.note(h);
    }
}

impl Growing for Draft {
    fn mesh(&self) -> &Mesh {
        &self.mesh
    }

    #[inline]
    fn point(&self, v: VertexId) -> Point {
        self.points[v.index()]
    }

    #[inline]
    fn is_locked(&self, h: HalfEdgeId) -> bool {
        self.marks.is_constrained(h)
    }

    fn split_face(&mut self, t: TriangleId, v: VertexId) -> [HalfEdgeId; 3] {
        let before = t.half_edges();
        let marks = before.map(|h| self.marks.get(h));
        let link = self.mesh.split_face(t, v);
        self.note_grown(before[1]);
        let [of_bc, of_ca, of_ab] = marks;
        for h in before {
            self.marks.set(h, Mark::FREE);
        }
        for (h, mark) in link.into_iter().zip([of_ab, of_bc, of_ca]) {
            self.marks.set(h, mark);
            self.note(h);
        }
        link
    }

    fn split_edge(&mut self, h: HalfEdgeId, v: VertexId) -> [HalfEdgeId; 4] {
        let g = self.mesh.twin(h);
        let [of_ab, of_bc, of_db] = [h, h.next(), g.prev()].map(|edge| self.marks.get(edge));
        let link = self.mesh.split_edge(h, v);
        self.note_grown(g);
        let [ca, ad, db, bc] = link;
        self.marks.set(h.next(), Mark::FREE);
        self.marks.set(g.prev(), Mark::FREE);
        let bv = self.mesh.twin(bc.prev());
        for (edge, mark) in [(bc, of_bc), (db, of_db), (bc.prev(), of_ab), (bv, of_ab)] {
            self.marks.set(edge, mark);
        }
        for edge in [ca, ad, db, bc] {
            self.note(edge);
        }
        link
    }

    fn open_edge(&mut self, h: HalfEdgeId, v: VertexId) -> [HalfEdgeId; 2] {
        let link = self.mesh.open_edge(h, v);
        let [ba, _] = link;
        self.note_grown(ba.prev());
        link
    }

    fn flip(&mut self, h: HalfEdgeId) {
        Draft::flip(self, h);
    }
}
