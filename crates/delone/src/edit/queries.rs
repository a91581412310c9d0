//! What a live triangulation can be asked.

use super::primitive::half_edges_along;
use super::{ConstraintId, LiveTriangulation};
use crate::locate::{Location, locate};
use crate::{HalfEdgeId, Mesh, Point, TriangleId, TriangulationHash, VertexId, hash_triangles};

impl LiveTriangulation {
    /// Counts the vertices.
    pub fn num_vertices(&self) -> usize {
        self.vertices.count()
    }

    /// Visits the vertices, ascending. *Cost*: linear in the largest number of vertices that there were.
    pub fn vertices(&self) -> impl Iterator<Item = VertexId> + '_ {
        self.vertices.ids().map(VertexId::from)
    }

    /// Returns where a vertex lies; `None` if there is no such vertex, or none any more.
    #[inline]
    pub fn point(&self, v: VertexId) -> Option<Point> {
        let is_used = !v.is_infinite() && self.vertices.is_used(v.raw());
        is_used.then(|| self.draft.point(v))
    }

    /// Returns the half-edge structure, ghosts included; triangles and ghosts come in no particular
    /// order. Empty for fewer than two vertices.
    pub fn mesh(&self) -> &Mesh {
        &self.draft.mesh
    }

    /// Visits the triangles, corners counter-clockwise. *Cost*: linear.
    pub fn triangles(&self) -> impl Iterator<Item = [VertexId; 3]> + '_ {
        let mesh = self.mesh();
        mesh.triangles().map(|t| mesh.corners(t))
    }

    /// Returns the neighbours of triangle `t`; neighbour `i` lies opposite corner `i`, `None` is
    /// outside.
    ///
    /// # Panics
    /// If there is no such face.
    pub fn neighbors(&self, t: TriangleId) -> [Option<TriangleId>; 3] {
        let mesh = self.mesh();
        t.half_edges().map(|h| {
            let beyond = mesh.twin(h).triangle();
            (!mesh.is_ghost(beyond)).then_some(beyond)
        })
    }

    /// Visits the half-edges that start at `v`, counter-clockwise; some may end at the infinite vertex.
    /// There are none if `v` is no vertex, or the only one.
    pub fn star(&self, v: VertexId) -> impl Iterator<Item = HalfEdgeId> + '_ {
        let v = self.point(v).map(|_| v);
        v.into_iter().flat_map(|v| self.draft.star(v))
    }

    /// Finds where a point lies; `None` if it is no vertex and there are fewer than two, or if it is not
    /// finite.
    ///
    /// *Cost*: O(log n) in practice, O(n) at worst.
    pub fn locate(&self, point: impl Into<Point>) -> Option<Location> {
        let point = Some(point.into()).filter(Point::is_finite)?;
        let near = self.places.near(point, |v| self.draft.point(v))?;
        if self.num_vertices() == 1 {
            let is_there = self.draft.point(near) == point;
            return is_there.then_some(Location::Vertex(near));
        }
        let hint = self.draft.star(near).next().expect("bug: it has no edge");
        Some(locate(&self.draft.mesh, &self.draft.points, hint, point))
    }

    /// Returns the name of the set of triangles: that of the triangulation made from scratch.
    ///
    /// *Cost*: linear, about 20 ns a triangle.
    pub fn hash(&self) -> TriangulationHash {
        hash_triangles(self.triangles().map(|t| t.map(|v| self.draft.point(v))))
    }

    /// Counts the constraints.
    pub fn num_constraints(&self) -> usize {
        self.constraints.count()
    }

    /// Visits the constraints, ascending. *Cost*: linear in the largest number of constraints that there
    /// were.
    pub fn constraints(&self) -> impl Iterator<Item = ConstraintId> + '_ {
        self.constraints.ids()
    }

    /// Returns the ends of a constraint, in the order in which they were given; `None` if there is no
    /// such constraint, or none any more.
    pub fn constraint(&self, id: ConstraintId) -> Option<[VertexId; 2]> {
        self.constraints.ends(id)
    }

    /// Returns the vertices along a constraint, from its first end to its second.
    ///
    /// *Cost*: the degrees of these vertices.
    pub fn chain(&self, id: ConstraintId) -> Option<Vec<VertexId>> {
        let ends = self.constraints.ends(id)?;
        let mesh = self.mesh();
        let others = half_edges_along(&self.draft, ends).map(|h| mesh.dest(h));
        Some(std::iter::once(ends[0]).chain(others).collect())
    }

    /// Tells whether a constraint runs along the edge of `h`.
    ///
    /// # Panics
    /// If `h` is no half-edge of the mesh.
    #[inline]
    pub fn is_constrained(&self, h: HalfEdgeId) -> bool {
        self.draft.marks.is_constrained(h)
    }

    /// Visits the constraints along the edge of `h`, ascending. *Cost*: logarithmic.
    ///
    /// # Panics
    /// If `h` is no half-edge of the mesh.
    pub fn constraints_along(&self, h: HalfEdgeId) -> impl Iterator<Item = ConstraintId> + '_ {
        self.constraints.along(self.ends(h))
    }

    /// Lists the constraints that end in a vertex, ascending. *Cost*: its degree.
    pub fn constraints_ending_at(&self, v: VertexId) -> Vec<ConstraintId> {
        if self.point(v).is_none() {
            return Vec::new();
        }
        let neighbors = self.constrained_neighbors(v).into_iter();
        let along = neighbors.flat_map(|w| self.constraints.along([v, w]));
        let ends_here = |&id: &ConstraintId| {
            let ends = self.constraints.ends(id);
            ends.is_some_and(|ends| ends.contains(&v))
        };
        let mut ending: Vec<_> = along.filter(ends_here).collect();
        ending.sort_unstable();
        ending
    }
}
