//! What Algorithms A, B and C work on: a mesh, the data that its triangles hold, and someone who is told.
//!
//! Every edit keeps this: each datum is held by one triangle, and lies in it, boundary included. So after any edit
//! the data of the triangles that have changed, and no others, are dealt out anew.
//!
//! Edges of the outline are constrained in the draft, so that nothing flips them.
//!
//! This file has the state and the questions, `edits` what changes the mesh, `deal` and `around` who gets the data then, `raise`
//! how data on edges pass from one triangle to another, `telling` what an observer hears.

mod around;
mod deal;
mod edits;
mod raise;
mod telling;

use super::data::Data;
use super::edges::{Rim, is_free};
use super::sheet::mesh_of;
use super::stock::Stock;
use crate::constrained::Draft;
use crate::edit::Room;
use crate::pace::Pace;
use crate::{Error, Event, HalfEdgeId, Observer, Phase, Point, TriangleId, VertexId, Watch};
use telling::Told;

/// Mesh, data, and who holds them.
pub(super) struct Field<'a, O> {
    pub draft: Draft,
    pub stock: Stock,
    pub data: &'a Data,
    /// The line of pseudocode that runs.
    line: u16,
    observer: &'a mut O,
    told: Told,
    pace: Pace<'a>,
    /// Work since the watch was last asked, in predicates.
    work: usize,
    room: Room,
    /// The outline, since somebody asked about it.
    rim: Option<Rim>,
}

/// Predicates between two questions to the watch: a few milliseconds, even if none takes its fast way.
const STRIDE: usize = 1 << 12;

impl<'a, O: Observer> Field<'a, O> {
    /// Begins with data, and no triangle. About so many are expected.
    pub fn new(data: &'a Data, expected: usize, watch: &'a dyn Watch, observer: &'a mut O) -> Self {
        Self {
            draft: Draft::new(Vec::new(), Default::default()),
            stock: Stock::default(),
            data,
            line: 0,
            told: Told::default(),
            observer,
            pace: Pace::new(watch, Phase::Cover, expected as u64),
            work: 0,
            room: Room::default(),
            rim: None,
        }
    }

    /// Drops all vertices and triangles, and begins anew with these, which must cover all data.
    ///
    /// # Errors
    /// [`Error::DatumOutside`] names a datum that they do not cover, [`Error::SameSide`] and [`Error::BadStart`]
    /// triangles that cover no polygon; [`Error::Cancelled`].
    ///
    /// *Cost*: a walk for each datum, along the curve.
    pub fn lay_out(
        &mut self,
        points: Vec<Point>,
        triangles: &[[VertexId; 3]],
    ) -> Result<(), Error> {
        let mesh = mesh_of(triangles)?;
        self.tell_end();
        self.draft = Draft::new(points, mesh);
        self.rim = None;
        self.stock = Stock::default();
        self.stock.set_number(self.draft.mesh.num_faces());
        let ghosts: Vec<_> = self.draft.mesh.ghosts().collect();
        for ghost in ghosts {
            let h = self.draft.mesh.hull_edge_of(ghost);
            self.draft.constrain(h, true);
        }
        self.deal_all()?;
        self.tell_begin();
        Ok(())
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

    /// Returns what an observer calls a vertex: data come first.
    #[inline]
    pub fn name(&self, v: VertexId) -> VertexId {
        VertexId::new(self.data.given.len() + v.index())
    }

    /// Returns what an observer calls the corners of a triangle.
    pub fn names(&self, t: TriangleId) -> [VertexId; 3] {
        self.draft.mesh.corners(t).map(|v| self.name(v))
    }

    /// Counts work that takes as long as so many predicates.
    ///
    /// # Errors
    /// [`Error::Cancelled`].
    #[inline]
    pub fn spend(&mut self, work: usize) -> Result<(), Error> {
        self.work += work;
        if self.work < STRIDE {
            return Ok(());
        }
        self.work = 0;
        self.pace.poll()
    }

    /// Counts a triangle more towards those that are expected.
    ///
    /// # Errors
    /// [`Error::Cancelled`].
    pub fn advance(&mut self) -> Result<(), Error> {
        self.pace.step()
    }

    /// Returns where the corners of a triangle lie.
    #[inline]
    pub fn corners(&self, t: TriangleId) -> [Point; 3] {
        self.draft.mesh.corners(t).map(|v| self.draft.point(v))
    }

    /// Returns where an edge starts and ends, and what its triangle has opposite to it.
    #[inline]
    pub fn edge(&self, h: HalfEdgeId) -> [Point; 3] {
        let mesh = &self.draft.mesh;
        [mesh.origin(h), mesh.dest(h), mesh.apex(h)].map(|v| self.draft.point(v))
    }

    /// Tells whether there is a triangle on one side of an edge only.
    #[inline]
    pub fn is_outer(&self, h: HalfEdgeId) -> bool {
        let mesh = &self.draft.mesh;
        mesh.is_ghost(mesh.twin(h).triangle())
    }

    /// Tells whether an outer edge may go by way of `t`, on its line or outside, without meeting the outline elsewhere.
    pub fn is_free(&mut self, h: HalfEdgeId, t: Point) -> bool {
        let [a, b, _] = self.edge(h);
        let (start, draft) = (self.draft.mesh.origin(h), &self.draft);
        let look = || Rim::new(&draft.mesh, |v| draft.point(v));
        is_free(self.rim.get_or_insert_with(look), start, [a, b], t)
    }

    /// Lists the positions of the data that a triangle holds.
    pub fn data_of(&self, t: TriangleId) -> impl Iterator<Item = Point> + '_ {
        self.stock
            .held(t)
            .iter()
            .map(|held| self.data.points[held.datum()])
    }
}
