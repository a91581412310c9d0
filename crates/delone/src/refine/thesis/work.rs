//! The two phases, and the steps that they are made of.

use super::code;
use super::limits::Limits;
use super::opening::{Opening, opening};
use super::queues::{LongEdges, Skinny, smallest_of_all};
use super::sight::{Place, sight};
use crate::constrained::Steiner;
use crate::predicates::{Orientation, orient2d};
use crate::refine::handing::scale;
use crate::tables::{
    Marks, Side, Tables, Teller, area, circumcenter, edge_flip, middle, tables_of,
};
use crate::{Angle, ConstrainedTriangulation, Event, Observer, Outcome, Point, Stage, VertexId};

/// The share of the first smallest area below which opening stops.
const SHARE: f64 = 0.01;

/// A mesh under refinement.
pub(super) struct Work<'a, 'w, O> {
    pub tables: Tables,
    marks: Marks,
    /// Knows the names of vertices in the result.
    teller: Teller<'a, O>,
    /// The name of the next vertex.
    next: usize,
    /// Coordinates in the tables are those of the mesh times this power of two.
    scale: f64,
    steiner: &'a mut Steiner,
    limits: &'a mut Limits<'w>,
}

impl<'a, 'w, O: Observer> Work<'a, 'w, O> {
    /// Begins with a mesh that is constrained Delaunay: to examine all its edges would be in vain.
    pub fn new(
        mesh: &ConstrainedTriangulation,
        steiner: &'a mut Steiner,
        limits: &'a mut Limits<'w>,
        observer: &'a mut O,
    ) -> Self {
        let scale = scale(mesh.triangulation().points());
        let (tables, names) = tables_of(mesh, scale);
        Self {
            tables,
            marks: Marks::default(),
            teller: Teller::new(names, observer),
            next: mesh.triangulation().points().len(),
            scale,
            steiner,
            limits,
        }
    }

    /// Phase 1: bisects the longest edge until none is longer than `bound`.
    ///
    /// # Errors
    /// Why it stopped before.
    pub fn shorten(&mut self, bound: f64) -> Result<(), Outcome> {
        let mut long = LongEdges::new(&mut self.tables, bound * self.scale);
        while let Some(row) = long.take(&self.tables) {
            self.teller.at(code::SHORTEN);
            self.bisect(row, long.len())?;
            long.update(&mut self.tables);
        }
        self.end(code::SAVE, Stage::ShortenEdges);
        Ok(())
    }

    /// Phase 2: opens the skinniest triangle until none has an angle below `bound`, but for those
    /// whose angle is given by the domain.
    ///
    /// # Errors
    /// Why it stopped before; [`Outcome::FellBack`] if the smallest area has become too small.
    pub fn open(&mut self, bound: Angle) -> Result<(), Outcome> {
        let cosine = libm::cos(bound.to_radians());
        let sine = libm::sin(bound.to_radians());
        let mut skinny = Skinny::new(&mut self.tables, cosine);
        let area_of = |tables: &Tables, t: u32| area(tables.corners(t));
        let first = smallest_of_all(&self.tables).map_or(0.0, |t| area_of(&self.tables, t));
        while let (Some(t), Some(smallest)) = (skinny.skinniest(), skinny.smallest()) {
            // An area that is no number ends it, too.
            let goes_on = area_of(&self.tables, smallest) > SHARE * first;
            self.open_one(t, sine)?;
            skinny.update(&mut self.tables);
            if !goes_on && skinny.skinniest().is_some() {
                return Err(Outcome::FellBack);
            }
        }
        self.end(code::SKINNY, Stage::OpenTriangles);
        Ok(())
    }

    /// Tells whether no edge is longer than `bound`.
    pub fn keeps_to(&self, bound: f64) -> bool {
        let bound = bound * self.scale;
        self.tables.rows.iter().all(|row| row.length <= bound)
    }

    /// Counts the vertices added so far.
    pub fn num_steiner(&self) -> usize {
        self.steiner.points.len()
    }

    /// Lists the triangles, by the names of their corners.
    pub fn triangles(&self) -> impl Iterator<Item = [VertexId; 3]> + '_ {
        let triangles = self.tables.triangles.iter();
        triangles.map(|&corners| self.teller.names().of(corners))
    }

    fn open_one(&mut self, t: u32, sine: f64) -> Result<(), Outcome> {
        self.teller.at(code::SKINNIEST);
        let corners = self.tables.triangles[t as usize];
        self.teller.tell(|names| Event::TriangleConsidered {
            triangle: names.of(corners),
        });
        match opening(&self.tables, t, sine, &mut self.teller) {
            Opening::Bisect(row) => self.bisect(row, 1),
            Opening::Circumcenter(other) => self.insert_circumcenter(other),
        }
    }

    fn bisect(&mut self, row: u32, waiting: usize) -> Result<(), Outcome> {
        let [a, b] = self.tables.row(row).ends.map(|v| self.tables.point(v));
        self.split_edge(row, middle(a, b), waiting)
    }

    /// Inserts the circumcenter of a triangle, located anew once it is rounded.
    fn insert_circumcenter(&mut self, t: u32) -> Result<(), Outcome> {
        let at = circumcenter(self.tables.corners(t));
        if !at.is_finite() {
            return Err(Outcome::PrecisionLimit);
        }
        let (corners, center) = (self.tables.triangles[t as usize], self.unscaled(at));
        self.teller.tell(|names| Event::CircumcenterProposed {
            triangle: names.of(corners),
            at: center,
        });
        let mut sides = [0, 1, 2].map(|k| Side::new(t, k)).into_iter();
        match sides.find_map(|side| sight(&self.tables, side, at, &mut self.teller)) {
            Some(Place::Triangle(t)) => self.split_triangle(t, at),
            Some(Place::Edge(side)) => self.split_edge(self.tables.row_of(side), at, 1),
            Some(Place::Vertex(_)) | None => Err(Outcome::PrecisionLimit),
        }
    }

    /// Divides an edge, and flips until all is Delaunay again.
    fn split_edge(&mut self, row: u32, at: Point, waiting: usize) -> Result<(), Outcome> {
        self.limits.admit(self.next, waiting)?;
        let content = *self.tables.row(row);
        let mut sides = [Some(content.first), content.second].into_iter().flatten();
        if !sides.all(|side| self.has_room(side, at)) {
            return Err(Outcome::PrecisionLimit);
        }
        let edge = self.teller.names().of(content.ends);
        let halved = content.is_constraint.then_some(edge);
        let (number, vertex) = self.add_vertex(at, halved);
        self.teller.tell(|_| Event::SegmentSplit { edge, vertex });
        let suspects = self.teller.bisect(&mut self.tables, row, number);
        self.flip(suspects);
        Ok(())
    }

    /// Tells whether a point on an edge, or beside it by rounding, makes two triangles that are not
    /// inverted of the one on this side.
    fn has_room(&self, side: Side, at: Point) -> bool {
        let [a, b] = self.tables.ends(side).map(|v| self.tables.point(v));
        let apex = self.tables.point(self.tables.apex(side));
        orient2d(a, at, apex) == Orientation::Left && orient2d(at, b, apex) == Orientation::Left
    }

    /// Joins a vertex in a triangle to its corners, and flips until all is Delaunay again.
    fn split_triangle(&mut self, t: u32, at: Point) -> Result<(), Outcome> {
        self.limits.admit(self.next, 1)?;
        let (number, _) = self.add_vertex(at, None);
        let suspects = self.teller.insert(&mut self.tables, t, number);
        self.flip(suspects);
        Ok(())
    }

    /// Adds a vertex; returns its number and its name.
    fn add_vertex(&mut self, at: Point, halved: Option<[VertexId; 2]>) -> (u32, VertexId) {
        let vertex = VertexId::new(self.next);
        self.next += 1;
        let number = self.teller.add_name(vertex);
        self.tables.points.push(at);
        let at = self.unscaled(at);
        self.steiner.push(at, halved);
        self.teller.tell(|_| Event::VertexCreated { vertex, at });
        (number, vertex)
    }

    /// Where a point of the tables lies in the mesh.
    fn unscaled(&self, p: Point) -> Point {
        Point::new(p.x / self.scale, p.y / self.scale)
    }

    fn flip(&mut self, suspects: Vec<u32>) {
        let Self {
            tables,
            marks,
            teller,
            ..
        } = self;
        marks.add(suspects, tables, teller);
        edge_flip(tables, marks, teller, code::FLIP);
    }

    fn end(&mut self, line: u16, stage: Stage) {
        let skinniest = smallest_of_all(&self.tables);
        let cosine = skinniest.map(|t| self.tables.shape(t).cosine);
        let min_angle = cosine.map(|c| Angle::radians(libm::acos(c.min(1.0))));
        self.teller.at(line);
        self.teller.tell(|_| Event::StageEnded { stage, min_angle });
    }
}
