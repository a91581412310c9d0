//! What the algorithms work on: points, a mesh, and someone who is told.
//!
//! A verb here is an edit of the [`Mesh`] or a predicate, and the events that tell of it. Ghosts are part
//! of the mesh and of no event: where an edit touches the vertex at infinity, edges and triangles appear or
//! disappear for whoever watches.
//!
//! This file has the state and the questions, `edits` what changes it, `domain` what lies outside.

mod domain;
mod edits;

use super::{Input, Output, Sites, ascending};
use crate::observe::{Item, Queue, Stage};
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
    /// For each vertex of the mesh a half-edge that starts there.
    spokes: Vec<HalfEdgeId>,
    /// Constrained edges, smaller end first.
    locked: BTreeSet<[VertexId; 2]>,
    /// Which faces lie outside of the domain, as far as it goes: they only close the sphere, and nobody is
    /// told of them.
    outside: Vec<bool>,
    duplicates: Vec<Duplicate>,
    /// The line of pseudocode that runs.
    line: u16,
    observer: &'r mut O,
    pace: Pace<'r>,
    /// What has been done since the watch was last asked, in predicates.
    work: usize,
}

/// Predicates between two questions to the watch: a few milliseconds, even if none takes its fast way.
const STRIDE: usize = 1 << 12;

impl<'r, O: Observer> Board<'r, O> {
    /// Begins with the points of an input, no mesh, and the distinct points in their order.
    pub fn new(input: &Input<'r>, observer: &'r mut O) -> Result<(Self, Vec<VertexId>), Error> {
        let sites = Sites::of(input)?;
        let board = Self {
            pace: Pace::new(input.watch, Phase::Triangulate, sites.order.len() as u64),
            spokes: vec![HalfEdgeId::new(0); sites.points.len()],
            points: sites.points,
            mesh: Mesh::default(),
            locked: BTreeSet::new(),
            outside: Vec::new(),
            duplicates: sites.duplicates,
            line: 0,
            observer,
            work: 0,
        };
        Ok((board, sites.order))
    }

    /// Begins with what another board has come to, and tells of it in steps of line 0.
    pub fn lay_out(from: Board<()>, input: &Input<'r>, observer: &'r mut O) -> Self {
        let mut board = Self {
            pace: Pace::new(input.watch, Phase::Triangulate, from.points.len() as u64),
            points: from.points,
            mesh: from.mesh,
            spokes: from.spokes,
            locked: from.locked,
            outside: from.outside,
            duplicates: from.duplicates,
            line: 0,
            observer,
            work: 0,
        };
        board.tell_all();
        board
    }

    /// Takes a whole mesh, with its constrained edges, smaller end first, and the faces outside of its
    /// domain; nobody is told.
    pub fn take(&mut self, mesh: Mesh, locked: BTreeSet<[VertexId; 2]>, outside: Vec<bool>) {
        (self.mesh, self.locked, self.outside) = (mesh, locked, outside);
        self.note_all();
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

    /// Tells that something begins to wait, or ends.
    pub fn tell_waiting(&mut self, queue: Queue, item: Item, is_pushed: bool) {
        self.tell(|| match is_pushed {
            true => Event::Pushed { queue, item },
            false => Event::Popped { queue, item },
        });
    }

    /// Tells that a part of the work is done.
    pub fn end(&mut self, stage: Stage) {
        self.tell(|| Event::StageEnded {
            stage,
            min_angle: None,
        });
    }

    /// Tells whether anybody listens.
    #[inline]
    pub fn is_watched(&self) -> bool {
        self.observer.is_watching()
    }

    /// Counts one step of the main loop. Predicates since the last one count, too: a step may be a search
    /// through everything.
    ///
    /// # Errors
    /// [`Error::Cancelled`].
    #[inline]
    pub fn step(&mut self) -> Result<(), Error> {
        self.pace.step()?;
        self.spend(0)
    }

    /// Counts work that takes as long as so many predicates.
    ///
    /// # Errors
    /// [`Error::Cancelled`].
    #[inline]
    pub fn spend(&mut self, work: usize) -> Result<(), Error> {
        self.work = self.work.saturating_add(work);
        if self.work < STRIDE {
            return Ok(());
        }
        self.work = 0;
        self.pace.poll()
    }

    /// Returns who is told.
    pub fn observer(&mut self) -> &mut O {
        self.observer
    }

    /// Returns the mesh.
    #[inline]
    pub fn mesh(&self) -> &Mesh {
        &self.mesh
    }

    /// Returns the mesh, for edits that nobody is told of: who makes them tells what is seen of them.
    #[inline]
    pub fn mesh_mut(&mut self) -> &mut Mesh {
        &mut self.mesh
    }

    /// Tells whether [conflicts](Event::ConflictsCounted) are to be counted.
    pub fn wants_conflicts(&self) -> bool {
        self.observer.wants_conflicts()
    }

    /// Returns where all vertices lie.
    pub fn points(&self) -> &[Point] {
        &self.points
    }

    /// Returns the vertex that stands for a point of the input: itself, or one that equals it.
    pub fn representative(&self, v: VertexId) -> VertexId {
        let found = self.duplicates.binary_search_by_key(&v, |d| d.dropped);
        found.map_or(v, |i| self.duplicates[i].kept)
    }

    /// Returns where a vertex lies.
    #[inline]
    pub fn point(&self, v: VertexId) -> Point {
        self.points[v.index()]
    }

    /// Returns a half-edge that starts at a vertex of the mesh.
    pub fn spoke(&self, v: VertexId) -> HalfEdgeId {
        self.spokes[v.index()]
    }

    /// Finds the half-edge from one vertex of the mesh to another.
    ///
    /// *Cost*: the degree of the first.
    pub fn edge(&self, [a, b]: [VertexId; 2]) -> Option<HalfEdgeId> {
        let mut star = self.mesh.star(self.spoke(a));
        star.find(|&h| self.mesh.dest(h) == b)
    }

    /// Notes where the half-edges of faces start that have been written.
    fn note(&mut self, faces: impl IntoIterator<Item = TriangleId>) {
        self.spokes.resize(self.points.len(), HalfEdgeId::new(0));
        for h in faces.into_iter().flat_map(TriangleId::half_edges) {
            let v = self.mesh.origin(h);
            if !v.is_infinite() {
                self.spokes[v.index()] = h;
            }
        }
    }

    /// Does so for all faces.
    fn note_all(&mut self) {
        self.note((0..self.mesh.num_faces()).map(TriangleId::new));
    }

    /// Returns the ends of a half-edge.
    #[inline]
    pub fn ends(&self, h: HalfEdgeId) -> [VertexId; 2] {
        [self.mesh.origin(h), self.mesh.dest(h)]
    }

    /// Tells on which side of the line from `a` to `b` vertex `c` lies.
    #[inline]
    pub fn orient(&mut self, a: VertexId, b: VertexId, c: VertexId) -> Orientation {
        self.work += 1;
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
        self.work += 1;
        let is_inside = in_circle_perturbed(a, b, c, p);
        self.tell(|| Event::CircleTested {
            triangle,
            point: d,
            answer: in_circle(a, b, c, p),
            is_inside,
        });
        is_inside
    }

    /// Tells whether `v`, on the line through `from` and `to`, lies on the side of `to`.
    pub fn is_towards(&self, from: VertexId, v: VertexId, to: VertexId) -> bool {
        let [from, v, to] = [from, v, to].map(|v| self.point(v));
        from.lex_cmp(&v) == from.lex_cmp(&to)
    }

    /// Tells whether the edge of `h` may stay: it is a constraint, or on the hull, or the apex beyond lies
    /// outside the circle of the triangle. What nobody sees may always.
    pub fn is_locally_delaunay(&mut self, h: HalfEdgeId) -> bool {
        if !self.is_visible(h) {
            return true;
        }
        let edge = self.ends(h);
        self.tell(|| Event::EdgeExamined { edge });
        let g = self.mesh.twin(h);
        if self.is_locked(h) || [h, g].iter().any(|s| !self.is_inside(s.triangle())) {
            return true;
        }
        let (triangle, beyond) = (self.mesh.corners(h.triangle()), self.mesh.apex(g));
        !self.in_circle(triangle, beyond)
    }

    /// Returns the constrained edges, smaller end first.
    pub fn locked(&self) -> &BTreeSet<[VertexId; 2]> {
        &self.locked
    }

    /// Tells whether the edge of `h` is a constraint.
    pub fn is_locked(&self, h: HalfEdgeId) -> bool {
        !self.locked.is_empty() && self.locked.contains(&ascending(self.ends(h)))
    }

    /// Hands out the triangles.
    pub fn finish(self) -> Output {
        Output {
            triangles: self.triangles().collect(),
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
