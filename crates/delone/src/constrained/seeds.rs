//! Where the seeds of holes and regions lie.

use super::draft::{Ahead, Draft};
use crate::predicates::{Orientation, orient2d};
use crate::{HalfEdgeId, Point, TriangleId, VertexId};

/// What a seed stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Place {
    /// This triangle and all that no segment separates from it.
    In(TriangleId),
    /// Nothing: it lies on this constrained edge.
    On(HalfEdgeId),
    /// Nothing: it lies outside the convex hull.
    Outside,
}

/// Locates seeds: jumps to the nearest of a sample of vertices, and walks straight from there
/// (Mücke, Saias and Zhu, *Fast randomized point location without preprocessing*, 1999).
///
/// A straight walk ends in any triangulation, constrained or not. *Cost*: O(n^⅓) for the jump, and in
/// practice as many triangles.
pub(super) struct Locator<'a> {
    draft: &'a Draft,
    sample: Vec<VertexId>,
}

impl<'a> Locator<'a> {
    pub fn new(draft: &'a Draft) -> Self {
        let vertices = (0..draft.points.len()).map(VertexId::new);
        let step = (draft.points.len() as f64).powf(2.0 / 3.0) as usize;
        let sample = vertices
            .step_by(step.max(1))
            .filter(|&v| draft.star(v).next().is_some())
            .collect();
        Self { draft, sample }
    }

    /// Finds what the seed at `p` stands for.
    pub fn place(&self, p: Point) -> Place {
        let distance = |&v: &VertexId| {
            let q = self.draft.point(v);
            (q.x - p.x).hypot(q.y - p.y)
        };
        let nearest = self
            .sample
            .iter()
            .min_by(|v, w| distance(v).total_cmp(&distance(w)));
        nearest.map_or(Place::Outside, |&v| self.walk(v, p))
    }

    fn walk(&self, mut from: VertexId, p: Point) -> Place {
        let draft = self.draft;
        while draft.point(from) != p {
            let next = match draft.ahead(from, p) {
                Ahead::Outside => return Place::Outside,
                Ahead::Along(h) => self.along(h, p),
                Ahead::Across(h) => self.across(from, h, p),
            };
            match next {
                Ok(place) => return place,
                Err(vertex) => from = vertex,
            }
        }
        self.at_vertex(from)
    }

    /// Goes along an edge: the place of `p`, or the vertex at its end.
    fn along(&self, h: HalfEdgeId, p: Point) -> Result<Place, VertexId> {
        let mesh = &self.draft.mesh;
        let [a, b] = [mesh.origin(h), mesh.dest(h)].map(|v| self.draft.point(v));
        if a.lex_cmp(&p) == p.lex_cmp(&b) {
            Ok(self.on_edge(h))
        } else {
            Err(mesh.dest(h))
        }
    }

    /// Goes through triangles, first through the one of `exit` towards that half-edge: the place of
    /// `p`, or a vertex on the way.
    fn across(&self, from: VertexId, mut exit: HalfEdgeId, p: Point) -> Result<Place, VertexId> {
        let (draft, mesh) = (self.draft, &self.draft.mesh);
        loop {
            match draft.side_of(exit, p) {
                Orientation::Left => return Ok(Place::In(exit.triangle())),
                Orientation::Collinear => return Ok(self.on_edge(exit)),
                Orientation::Right => {}
            }
            let entry = mesh.twin(exit);
            let w = mesh.apex(entry);
            if w.is_infinite() {
                return Ok(Place::Outside);
            }
            let [start, turn] = [from, w].map(|v| draft.point(v));
            exit = match orient2d(start, p, turn) {
                Orientation::Left => entry.next(),
                Orientation::Right => entry.prev(),
                Orientation::Collinear if start.lex_cmp(&p) == p.lex_cmp(&turn) => {
                    return Ok(Place::In(entry.triangle()));
                }
                Orientation::Collinear => return Err(w),
            };
        }
    }

    fn on_edge(&self, h: HalfEdgeId) -> Place {
        if self.draft.marks.is_constrained(h) {
            return Place::On(h);
        }
        let sides = [h, self.draft.mesh.twin(h)].map(HalfEdgeId::triangle);
        let triangle = sides.into_iter().find(|&t| !self.draft.mesh.is_ghost(t));
        triangle.map_or(Place::Outside, Place::In)
    }

    fn at_vertex(&self, v: VertexId) -> Place {
        let mut constrained = self.draft.star(v);
        if let Some(h) = constrained.find(|&h| self.draft.marks.is_constrained(h)) {
            return Place::On(h);
        }
        let mut around = self.draft.star(v).map(HalfEdgeId::triangle);
        let triangle = around.find(|&t| !self.draft.mesh.is_ghost(t));
        triangle.map_or(Place::Outside, Place::In)
    }
}
