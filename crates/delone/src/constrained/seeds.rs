//! Where the seeds of holes and regions lie.

use super::draft::Draft;
use crate::locate::{Location, locate};
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

/// Locates seeds: jumps to the nearest of a sample of vertices, and walks from there (Mücke, Saias and Zhu,
/// *Fast randomized point location without preprocessing*, 1999). The walk ends in any triangulation of the
/// convex hull, which this is until it is carved.
///
/// *Cost*: O(n^⅓) for the jump, and in practice as many triangles. Seeds are few, so no index is built.
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

    /// Walks from a vertex; no answer depends on which one.
    fn walk(&self, from: VertexId, p: Point) -> Place {
        let Some(hint) = self.draft.star(from).next() else {
            return Place::Outside;
        };
        match locate(&self.draft.mesh, &self.draft.points, hint, p) {
            Location::Face(t) | Location::Carved(t) => Place::In(t),
            Location::Edge(h) => self.on_edge(h),
            Location::Vertex(v) => self.at_vertex(v),
            Location::Outside(_) | Location::Beyond(_) | Location::Apart => Place::Outside,
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
