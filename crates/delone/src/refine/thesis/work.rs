//! The two phases, and the steps that they are made of.

use super::flips::{Marks, edge_flip};
use super::limits::Limits;
use super::numbering::tables_of;
use super::opening::{Opening, opening};
use super::queues::{LongEdges, Skinny, smallest_of_all};
use super::shape::{area, circumcenter, middle};
use super::sight::{Place, sight};
use super::tables::{Side, Tables};
use crate::constrained::Steiner;
use crate::predicates::{Orientation, orient2d};
use crate::refine::handing::scale;
use crate::{Angle, ConstrainedTriangulation, Event, Observer, Outcome, Point, Stage, VertexId};

/// The share of the first smallest area below which opening stops.
const SHARE: f64 = 0.01;

/// A mesh under refinement.
pub(super) struct Work<'a, 'w, O> {
    pub tables: Tables,
    marks: Marks,
    /// For each number of a vertex its name in the result.
    names: Vec<VertexId>,
    /// The name of the next vertex.
    next: usize,
    /// Coordinates in the tables are those of the mesh times this power of two.
    scale: f64,
    steiner: &'a mut Steiner,
    limits: &'a mut Limits<'w>,
    observer: &'a mut O,
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
            names,
            next: mesh.triangulation().points().len(),
            scale,
            steiner,
            limits,
            observer,
        }
    }

    /// Phase 1: bisects the longest edge until none is longer than `bound`.
    ///
    /// # Errors
    /// Why it stopped before.
    pub fn shorten(&mut self, bound: f64) -> Result<(), Outcome> {
        let mut long = LongEdges::new(&mut self.tables, bound * self.scale);
        while let Some(row) = long.take(&self.tables) {
            self.bisect(row, long.len())?;
            long.update(&mut self.tables);
        }
        self.end(Stage::ShortenEdges);
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
        self.end(Stage::OpenTriangles);
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

    fn open_one(&mut self, t: u32, sine: f64) -> Result<(), Outcome> {
        let name = |work: &Self, t: u32| work.tables.triangles[t as usize].map(|v| work.name(v));
        let triangle = name(self, t);
        self.observer
            .tell(0, || Event::TriangleConsidered { triangle });
        match opening(&self.tables, t, sine) {
            Opening::Bisect(row) => {
                let edge = self.tables.row(row).ends.map(|v| self.name(v));
                self.observer
                    .tell(0, || Event::CircumcenterRejected { triangle, edge });
                self.bisect(row, 1)
            }
            Opening::Circumcenter(other) => {
                let triangle = name(self, other);
                let at = circumcenter(self.tables.corners(other));
                self.observer
                    .tell(0, || Event::CircumcenterProposed { triangle, at });
                self.insert_circumcenter(other)
            }
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
        let mut sides = [0, 1, 2].map(|k| Side::new(t, k)).into_iter();
        match sides.find_map(|side| sight(&self.tables, side, at)) {
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
        let edge = content.ends.map(|v| self.name(v));
        let (number, vertex, at) = self.add_vertex(at, content.is_constraint.then_some(edge));
        let suspects = self.tables.bisect(row, number);
        self.observer
            .tell(0, || Event::VertexCreated { vertex, at });
        self.observer
            .tell(0, || Event::SegmentSplit { edge, vertex });
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
        let triangle = self.tables.triangles[t as usize].map(|v| self.name(v));
        let (number, vertex, at) = self.add_vertex(at, None);
        let suspects = self.tables.insert(t, number);
        self.observer
            .tell(0, || Event::VertexCreated { vertex, at });
        self.observer
            .tell(0, || Event::TriangleVisited { triangle });
        self.flip(suspects);
        Ok(())
    }

    /// Adds a vertex; returns its number, its name, and where it lies in the mesh.
    fn add_vertex(&mut self, at: Point, halved: Option<[VertexId; 2]>) -> (u32, VertexId, Point) {
        let (number, vertex) = (self.names.len() as u32, VertexId::new(self.next));
        self.next += 1;
        self.names.push(vertex);
        self.tables.points.push(at);
        let at = Point::new(at.x / self.scale, at.y / self.scale);
        self.steiner.push(at, halved);
        (number, vertex, at)
    }

    fn flip(&mut self, suspects: Vec<u32>) {
        self.marks.add(suspects);
        let (names, observer) = (&self.names, &mut self.observer);
        let name = |edge: [u32; 2]| edge.map(|v| names[v as usize]);
        edge_flip(&mut self.tables, &mut self.marks, |edge, flipped| {
            observer.tell(0, || Event::EdgeExamined { edge: name(edge) });
            if let Some(to) = flipped {
                let [from, to] = [edge, to].map(name);
                observer.tell(0, || Event::EdgeFlipped { from, to });
            }
        });
    }

    fn end(&mut self, stage: Stage) {
        let skinniest = smallest_of_all(&self.tables);
        let cosine = skinniest.map(|t| self.tables.shape(t).cosine);
        let min_angle = cosine.map(|c| Angle::radians(libm::acos(c.min(1.0))));
        self.observer
            .tell(0, || Event::StageEnded { stage, min_angle });
    }

    fn name(&self, number: u32) -> VertexId {
        self.names[number as usize]
    }
}
