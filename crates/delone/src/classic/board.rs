//! What the algorithms work on: points, a mesh, and someone who is told.
//!
//! A verb here is an edit of the [`Mesh`] or a predicate, and the events that tell of it. Ghosts are part
//! of the mesh and of no event: where an edit touches the vertex at infinity, edges and triangles appear or
//! disappear for whoever watches.

use super::{Input, Output, Sites};
use crate::delaunay::check_number;
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

    /// Visits the triangles of the domain.
    pub fn triangles(&self) -> impl Iterator<Item = [VertexId; 3]> + '_ {
        let inside = self.mesh.triangles().filter(|&t| !self.is_carved(t));
        inside.map(|t| self.mesh.corners(t))
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

    /// Tells whether the edge of `h` may stay: it is a constraint, or on the hull, or the apex beyond lies
    /// outside the circle of the triangle.
    pub fn is_locally_delaunay(&mut self, h: HalfEdgeId) -> bool {
        let edge = self.ends(h);
        self.tell(|| Event::EdgeExamined { edge });
        let g = self.mesh.twin(h);
        if self.is_locked(h) || [h, g].iter().any(|s| !self.is_inside(s.triangle())) {
            return true;
        }
        let (triangle, beyond) = (self.mesh.corners(h.triangle()), self.mesh.apex(g));
        !self.in_circle(triangle, beyond)
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

    /// Returns the constrained edges, smaller end first.
    pub fn locked(&self) -> &BTreeSet<[VertexId; 2]> {
        &self.locked
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

    /// Returns the corners of a face as far as they are told: those of a carved one are all at infinity.
    fn told_corners(&self, t: TriangleId) -> [VertexId; 3] {
        if self.is_carved(t) {
            return [VertexId::INFINITE; 3];
        }
        self.mesh.corners(t)
    }

    /// Lets the faces of some half-edges, new ones among them, be carved if `t` is.
    fn inherit(&mut self, t: TriangleId, parts: &[HalfEdgeId]) {
        if self.outside.is_empty() {
            return;
        }
        self.outside.resize(self.mesh.num_faces(), false);
        for part in parts {
            self.outside[part.triangle().index()] = self.outside[t.index()];
        }
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

/// Names an edge by its ends, the smaller one first.
pub(super) fn ascending([a, b]: [VertexId; 2]) -> [VertexId; 2] {
    [a.min(b), a.max(b)]
}
