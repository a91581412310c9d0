//! What the algorithms work on: points, a mesh, and someone who is told.
//!
//! A verb here is an edit of the [`Mesh`] or a predicate, and the events that tell of it. Ghosts are part
//! of the mesh and of no event: where an edit touches the vertex at infinity, edges and triangles appear or
//! disappear for whoever watches.

use super::{Input, Output, Sites};
use crate::pace::Pace;
use crate::predicates::{self, Orientation, in_circle, in_circle_perturbed};
use crate::{
    Duplicate, Error, Event, HalfEdgeId, Mesh, Observer, Phase, Point, TriangleId, VertexId,
};
use std::collections::BTreeSet;

/// Points and mesh, with an observer.
pub(super) struct Board<'r, O> {
    points: Vec<Point>,
    mesh: Mesh,
    /// Constrained edges, smaller end first.
    locked: BTreeSet<[VertexId; 2]>,
    duplicates: Vec<Duplicate>,
    /// The line of pseudocode that runs.
    line: u16,
    observer: &'r mut O,
    pace: Pace<'r>,
}

impl<'r, O: Observer> Board<'r, O> {
    /// Begins with the points of an input, no mesh, and the distinct points in their order.
    pub fn new(input: &Input<'r>, observer: &'r mut O) -> Result<(Self, Vec<VertexId>), Error> {
        let sites = Sites::of(input)?;
        let board = Self {
            pace: Pace::new(input.watch, Phase::Triangulate, sites.order.len() as u64),
            points: sites.points,
            mesh: Mesh::default(),
            locked: BTreeSet::new(),
            duplicates: sites.duplicates,
            line: 0,
            observer,
        };
        Ok((board, sites.order))
    }

    /// States which line of pseudocode runs from here on.
    #[inline]
    pub fn at(&mut self, line: u16) {
        self.line = line;
    }

    /// Tells of something, if anybody listens.
    #[inline]
    pub fn tell(&mut self, event: impl FnOnce() -> Event) {
        self.observer.tell(self.line, event);
    }

    /// Counts one step of the main loop.
    ///
    /// # Errors
    /// [`Error::Cancelled`].
    #[inline]
    pub fn step(&mut self) -> Result<(), Error> {
        self.pace.step()
    }

    /// Returns the mesh.
    #[inline]
    pub fn mesh(&self) -> &Mesh {
        &self.mesh
    }

    /// Replaces the mesh by one of which everything has been told.
    pub fn replace_mesh(&mut self, mesh: Mesh) {
        self.mesh = mesh;
    }

    /// Returns where all vertices lie.
    pub fn points(&self) -> &[Point] {
        &self.points
    }

    /// Returns where a vertex lies.
    #[inline]
    pub fn point(&self, v: VertexId) -> Point {
        self.points[v.index()]
    }

    /// Returns the ends of a half-edge.
    #[inline]
    pub fn ends(&self, h: HalfEdgeId) -> [VertexId; 2] {
        [self.mesh.origin(h), self.mesh.dest(h)]
    }

    /// Tells on which side of the line from `a` to `b` vertex `c` lies.
    #[inline]
    pub fn orient(&mut self, a: VertexId, b: VertexId, c: VertexId) -> Orientation {
        let answer = predicates::orient2d(self.point(a), self.point(b), self.point(c));
        self.tell(|| Event::OrientationTested {
            line: [a, b],
            point: c,
            answer,
        });
        answer
    }

    /// Tells whether `d` lies inside the circle through `a`, `b`, `c`, which turn counter-clockwise, once
    /// the perturbation has decided.
    #[inline]
    pub fn in_circle(&mut self, triangle: [VertexId; 3], d: VertexId) -> bool {
        let [a, b, c] = triangle.map(|v| self.point(v));
        let p = self.point(d);
        let is_inside = in_circle_perturbed(a, b, c, p);
        self.tell(|| Event::CircleTested {
            triangle,
            point: d,
            answer: in_circle(a, b, c, p),
            is_inside,
        });
        is_inside
    }

    /// Tells whether the edge of `h` may stay: it is a constraint, or on the hull, or the apex beyond lies
    /// outside the circle of the triangle.
    pub fn is_locally_delaunay(&mut self, h: HalfEdgeId) -> bool {
        let edge = self.ends(h);
        self.tell(|| Event::EdgeExamined { edge });
        let g = self.mesh.twin(h);
        if self.is_locked(h) || [h, g].iter().any(|s| self.mesh.is_ghost(s.triangle())) {
            return true;
        }
        let (triangle, beyond) = (self.mesh.corners(h.triangle()), self.mesh.apex(g));
        !self.in_circle(triangle, beyond)
    }

    /// Tells whether the edge of `h` is a constraint.
    pub fn is_locked(&self, h: HalfEdgeId) -> bool {
        !self.locked.is_empty() && self.locked.contains(&ascending(self.ends(h)))
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
        self.tell_change(&[], None, &[[a, b]], &[]);
        h
    }

    /// [`Mesh::split_face`]: joins a vertex to the corners of a face; of a ghost it makes a triangle.
    pub fn split_face(&mut self, t: TriangleId, v: VertexId) -> [HalfEdgeId; 3] {
        let old = self.mesh.corners(t);
        let link = self.mesh.split_face(t, v);
        let new = link.map(|h| self.mesh.corners(h.triangle()));
        self.tell_change(&[old], None, &old.map(|w| [v, w]), &new);
        link
    }

    /// [`Mesh::split_edge`]: joins a vertex on an edge to the corners of its two faces. Halves of a
    /// constraint are constraints.
    pub fn split_edge(&mut self, h: HalfEdgeId, v: VertexId) -> [HalfEdgeId; 4] {
        let [a, b] = self.ends(h);
        let g = self.mesh.twin(h);
        let old = [h, g].map(|s| self.mesh.corners(s.triangle()));
        let around = [a, b, self.mesh.apex(h), self.mesh.apex(g)];
        let was_locked = self.locked.remove(&ascending([a, b]));
        if was_locked {
            self.tell(|| Event::EdgeUnlocked { edge: [a, b] });
        }
        let link = self.mesh.split_edge(h, v);
        let new = link.map(|h| self.mesh.corners(h.triangle()));
        self.tell_change(&old, Some([a, b]), &around.map(|w| [v, w]), &new);
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
        self.tell_change(&[], None, &ends.map(|w| [v, w]), &[]);
        link
    }

    /// [`Mesh::flip`]: the other diagonal takes the place of an edge.
    pub fn flip(&mut self, h: HalfEdgeId) {
        let g = self.mesh.twin(h);
        let from = self.ends(h);
        let to = [self.mesh.apex(h), self.mesh.apex(g)];
        let old = [h, g].map(|s| self.mesh.corners(s.triangle()));
        self.mesh.flip(h);
        if !from.iter().chain(&to).any(|v| v.is_infinite()) {
            self.tell(|| Event::EdgeFlipped { from, to });
            return;
        }
        let new = [h, g].map(|s| self.mesh.corners(s.triangle()));
        self.tell_change(&old, Some(from), &[to], &new);
    }

    /// Tells of faces and edges that go and come, as far as they are finite.
    fn tell_change(
        &mut self,
        old: &[[VertexId; 3]],
        gone: Option<[VertexId; 2]>,
        edges: &[[VertexId; 2]],
        new: &[[VertexId; 3]],
    ) {
        if !self.observer.is_watching() {
            return;
        }
        for triangle in old.iter().copied().filter(is_finite) {
            self.tell(|| Event::TriangleDeleted { triangle });
        }
        for edge in gone.into_iter().filter(is_finite) {
            self.tell(|| Event::EdgeDeleted { edge });
        }
        for edge in edges.iter().copied().filter(is_finite) {
            self.tell(|| Event::EdgeCreated { edge });
        }
        for triangle in new.iter().copied().filter(is_finite) {
            self.tell(|| Event::TriangleCreated { triangle });
        }
    }

    /// Hands out the triangles.
    pub fn finish(self) -> Output {
        let triangles = self.mesh.faces().iter().copied().filter(is_finite);
        Output {
            triangles: triangles.collect(),
            points: self.points,
            constrained: self.locked.into_iter().collect(),
            duplicates: self.duplicates,
            ..Output::default()
        }
    }
}

fn is_finite<const N: usize>(corners: &[VertexId; N]) -> bool {
    !corners.iter().any(|v| v.is_infinite())
}

fn ascending([a, b]: [VertexId; 2]) -> [VertexId; 2] {
    [a.min(b), a.max(b)]
}
