//! The result that every builder hands out: points, mesh, hull and duplicates in the caller's
//! numbering.

use crate::{HalfEdgeId, Mesh, Point, TriangleId, TriangulationHash, VertexId, hash_triangles};
use std::sync::OnceLock;

/// A point that was merged into an equal one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Duplicate {
    /// The point that has no vertex of its own.
    pub dropped: VertexId,
    /// The equal point of lowest index, which stands for it.
    pub kept: VertexId,
}

/// A triangulation of a point set: vertex `i` is point `i` of the input.
///
/// Faces `0..num_triangles()` of the [mesh](Self::mesh) are the triangles. Behind them come, for a
/// domain, those that were carved away, and then the ghosts.
#[derive(Clone, Debug)]
pub struct Triangulation {
    points: Vec<Point>,
    mesh: Mesh,
    num_triangles: usize,
    /// Triangles, and finite faces that do not belong to the domain.
    num_finite: usize,
    duplicates: Vec<Duplicate>,
    /// Points that have no vertex, other than duplicates.
    num_hidden: usize,
    outgoing: OnceLock<Vec<Option<HalfEdgeId>>>,
}

impl Triangulation {
    /// Puts a result together. `mesh` holds `num_triangles` triangles first and ghosts after them;
    /// `duplicates` is sorted by `dropped`.
    pub(crate) fn from_parts(
        points: Vec<Point>,
        mesh: Mesh,
        num_triangles: usize,
        duplicates: Vec<Duplicate>,
    ) -> Self {
        Self::of_domain(points, mesh, num_triangles, num_triangles, duplicates)
    }

    /// As [`from_parts`](Self::from_parts), with faces `num_triangles..num_finite` carved away.
    pub(crate) fn of_domain(
        points: Vec<Point>,
        mesh: Mesh,
        num_triangles: usize,
        num_finite: usize,
        duplicates: Vec<Duplicate>,
    ) -> Self {
        debug_assert!(num_triangles <= num_finite && num_finite <= mesh.num_faces());
        debug_assert!(duplicates.is_sorted_by_key(|d| d.dropped));
        Self {
            points,
            mesh,
            num_triangles,
            num_finite,
            duplicates,
            num_hidden: 0,
            outgoing: OnceLock::new(),
        }
    }

    /// States that so many points are no vertices, without being listed as duplicates.
    pub(crate) fn with_hidden(self, num_hidden: usize) -> Self {
        Self { num_hidden, ..self }
    }

    /// Returns the points as the caller gave them, duplicates included.
    pub fn points(&self) -> &[Point] {
        &self.points
    }

    /// Returns the position of a vertex.
    ///
    /// # Panics
    /// If `v` is the infinite vertex or no vertex of this triangulation.
    #[inline]
    pub fn point(&self, v: VertexId) -> Point {
        self.points[v.index()]
    }

    /// Returns the half-edge structure, ghosts included.
    pub fn mesh(&self) -> &Mesh {
        &self.mesh
    }

    /// Counts the distinct points; of a [regular triangulation](crate::regular), those not hidden.
    pub fn num_vertices(&self) -> usize {
        self.points.len() - self.duplicates.len() - self.num_hidden
    }

    /// Counts the triangles.
    pub fn num_triangles(&self) -> usize {
        self.num_triangles
    }

    /// Counts the edges between finite vertices; if something was carved away, those of triangles.
    ///
    /// *Cost*: O(n) if something was carved away, else constant.
    pub fn num_edges(&self) -> usize {
        match self.num_vertices() {
            0 => 0,
            _ if self.is_carved() => (3 * self.num_triangles + self.num_boundary_edges()) / 2,
            n => n - 1 + self.num_triangles,
        }
    }

    /// Counts the edges with a triangle on one side only; if all points lie on one line, all edges.
    ///
    /// *Cost*: O(n) if something was carved away, else constant.
    pub fn num_boundary_edges(&self) -> usize {
        if !self.is_carved() {
            return self.num_hull_edges();
        }
        let triangles = (0..self.num_triangles).map(TriangleId::new);
        let half_edges = triangles.flat_map(TriangleId::half_edges);
        half_edges
            .filter(|&h| !self.is_inside(self.mesh.twin(h)))
            .count()
    }

    /// Tells whether some of the convex hull has been carved away.
    pub fn is_carved(&self) -> bool {
        self.num_triangles < self.num_finite
    }

    /// Counts the finite faces, carved ones included; behind them come the ghosts.
    pub(crate) fn num_finite(&self) -> usize {
        self.num_finite
    }

    /// Tells whether the face of `h` is one of the triangles.
    fn is_inside(&self, h: HalfEdgeId) -> bool {
        h.triangle().index() < self.num_triangles
    }

    /// Counts the edges on the boundary of the convex hull.
    ///
    /// If all points lie on one line, every edge counts, once.
    pub fn num_hull_edges(&self) -> usize {
        let ghosts = self.mesh.num_faces() - self.num_finite;
        if self.num_finite == 0 {
            ghosts / 2
        } else {
            ghosts
        }
    }

    /// Returns the triangles, corners counter-clockwise.
    pub fn triangles(&self) -> &[[VertexId; 3]] {
        &self.mesh.faces()[..self.num_triangles]
    }

    /// Returns the neighbours of triangle `t`; neighbour `i` lies opposite corner `i`, `None` is
    /// outside.
    pub fn neighbors(&self, t: TriangleId) -> [Option<TriangleId>; 3] {
        t.half_edges().map(|h| {
            let twin = self.mesh.twin(h);
            self.is_inside(twin).then(|| twin.triangle())
        })
    }

    /// Visits every edge once, as origin and destination; if something was carved away, those of
    /// triangles.
    pub fn edges(&self) -> impl Iterator<Item = [VertexId; 2]> + '_ {
        self.mesh.half_edges().filter_map(|h| {
            let [a, b] = [self.mesh.origin(h), self.mesh.dest(h)];
            let twin = self.mesh.twin(h);
            let is_kept = !self.is_carved() || self.is_inside(h) || self.is_inside(twin);
            (h < twin && is_kept && !a.is_infinite() && !b.is_infinite()).then_some([a, b])
        })
    }

    /// Visits the vertices of the convex hull counter-clockwise, those inside its edges included.
    ///
    /// If all points lie on one line, the walk goes along it and back. Empty for fewer than two
    /// distinct points.
    pub fn hull(&self) -> impl Iterator<Item = VertexId> + '_ {
        let first = (self.num_finite < self.mesh.num_faces())
            .then(|| self.mesh.hull_edge_of(TriangleId::new(self.num_finite)));
        first
            .into_iter()
            .flat_map(|h| self.mesh.hull(h))
            .map(|h| self.mesh.dest(h))
    }

    /// Returns the merged points, sorted by the dropped one.
    pub fn duplicates(&self) -> &[Duplicate] {
        &self.duplicates
    }

    /// Returns the vertex that stands for point `v`: `v` itself unless it is a duplicate.
    ///
    /// *Cost*: O(log d) for d duplicates.
    pub fn representative(&self, v: VertexId) -> VertexId {
        match self.duplicates.binary_search_by_key(&v, |d| d.dropped) {
            Ok(i) => self.duplicates[i].kept,
            Err(_) => v,
        }
    }

    /// Returns a half-edge that starts at `v`, or `None` if `v` is a duplicate, hidden or the only
    /// vertex.
    ///
    /// *Cost*: O(n) at the first call, then constant.
    pub fn outgoing(&self, v: VertexId) -> Option<HalfEdgeId> {
        self.outgoing.get_or_init(|| {
            let mut table = vec![None; self.points.len()];
            for h in self.mesh.half_edges() {
                let origin = self.mesh.origin(h);
                if !origin.is_infinite() {
                    table[origin.index()] = Some(h);
                }
            }
            table
        })[v.index()]
    }

    /// Visits the half-edges that start at `v`, counter-clockwise; some may end at the infinite
    /// vertex.
    pub fn star(&self, v: VertexId) -> impl Iterator<Item = HalfEdgeId> + '_ {
        self.outgoing(v).into_iter().flat_map(|h| self.mesh.star(h))
    }

    /// Returns the name of this set of triangles, the same whatever order, numbering or builder.
    pub fn hash(&self) -> TriangulationHash {
        hash_triangles(
            self.triangles()
                .iter()
                .map(|t| t.map(|v| self.points[v.index()])),
        )
    }
}
