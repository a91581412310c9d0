//! A side of a corridor with many vertices, triangulated in bulk.
//!
//! All vertices of a side lie on one side of the segment, so the segment is a hull edge of their
//! Delaunay triangulation. The edges of the rim are edges of it too, unless a segment on the rim hides
//! a vertex from another; such edges are inserted. What then lies between rim and segment is the
//! side's constrained Delaunay triangulation, which is unique.
//!
//! So is that of any other simple polygon; [holes](super::hole) use this, too, with one of their edges
//! in the part of the segment.
//!
//! *Cost*: O(k log k) in practice for k vertices.

use super::carve::flood;
use super::corridor::Inserter;
use super::draft::Draft;
use super::insert::Edge;
use super::names::Names;
use super::side::{Beyond, Side};
use crate::delaunay::Curve;
use crate::pace::Pace;
use crate::parallel::Workers;
use crate::{HalfEdgeId, Phase, TriangleId, VertexId};

/// Fills a side with triangles, in the next of `faces`, and returns the half-edge of the segment in
/// them, whose twin is still to be bonded. The rim begins at vertex `start`.
pub(super) fn fill(
    side: &Side,
    start: VertexId,
    draft: &mut Draft,
    faces: &mut impl Iterator<Item = TriangleId>,
    mut inserter: Inserter,
) -> HalfEdgeId {
    let mut model = Model::of(side, start, draft);
    model.constrain_rim(&mut inserter);
    let interior = model.interior();
    // Where each face of the model is built.
    let mut places: Vec<Option<TriangleId>> = vec![None; model.draft.mesh.num_faces()];
    for &t in &interior {
        let face = faces.next().expect("bug: more triangles than were cleared");
        let corners = model.draft.mesh.corners(t);
        draft.set_triangle(face, corners.map(|v| model.originals[v.index()]));
        places[t.index()] = Some(face);
    }
    let place = |h: HalfEdgeId| {
        let face = places[h.triangle().index()]?;
        Some(face.half_edges()[h.slot()])
    };
    for h in interior.iter().flat_map(|t| t.half_edges()) {
        if let [Some(h), Some(twin)] = [h, model.draft.mesh.twin(h)].map(place) {
            draft.mesh.bond(h, twin);
        }
    }
    for (edge, &[from, to]) in side.rim.iter().zip(&model.rim) {
        let h = place(model.edge(from, to)).expect("bug: the rim bounds the side");
        draft.marks.set(h, edge.mark);
        if let Beyond::Stays(beyond) = edge.beyond {
            draft.mesh.bond(h, beyond);
        }
    }
    place(model.base()).expect("bug: the segment bounds the side")
}

/// The vertices of a side, triangulated by themselves.
struct Model {
    draft: Draft,
    /// For each of its vertices the one in the real draft.
    originals: Vec<VertexId>,
    /// The edges of the rim, in the order in which they go round the side.
    rim: Vec<[VertexId; 2]>,
}

impl Model {
    fn of(side: &Side, start: VertexId, real: &Draft) -> Self {
        let path = || std::iter::once(start).chain(side.rim.iter().map(|edge| edge.to));
        let mut vertices: Vec<VertexId> = path().collect();
        vertices.sort_unstable();
        vertices.dedup();
        let points: Vec<_> = vertices.iter().map(|&v| real.point(v)).collect();
        let curve = Curve::build(&points, Workers::ONE, &());
        let curve = curve.expect("bug: finite points, fewer than before, unwatched");
        let parts = curve.into_parts();
        let names = Names::of(&parts);
        let model = |v: VertexId| {
            let place = vertices.binary_search(&v).expect("bug: all are listed");
            names.positions[place]
        };
        let ends = path().zip(path().skip(1));
        let rim = ends.map(|(from, to)| [model(from), model(to)]).collect();
        let callers = names.callers.iter();
        Self {
            rim,
            originals: callers.map(|v| vertices[v.index()]).collect(),
            draft: Draft::new(parts.points, parts.mesh),
        }
    }

    /// Makes the edges around the side constrained, inserting those of the rim that are missing.
    fn constrain_rim(&mut self, inserter: &mut Inserter) {
        let mut missing = Vec::new();
        for &[from, to] in self.rim.iter().chain([&self.base_ends()]) {
            match self.draft.find_edge(from, to) {
                Ok(h) => self.draft.constrain(h, true),
                Err(ends) => missing.push(Edge { ends, is_odd: true }),
            }
        }
        let mut through = Vec::new();
        for edge in missing {
            let inserted = inserter.insert(&mut self.draft, edge, &mut through);
            inserted.expect("bug: edges do not cross");
        }
        debug_assert!(through.is_empty(), "bug: a vertex lies inside of an edge");
    }

    /// Lists the triangles between rim and segment.
    fn interior(&self) -> Vec<TriangleId> {
        let mut seen = vec![false; self.draft.mesh.num_faces()];
        let mut list = Vec::new();
        let mut unwatched = Pace::new(&(), Phase::Carve, 0);
        let flooded = flood(&self.draft, self.base().triangle(), &mut unwatched, |t| {
            let is_new = !std::mem::replace(&mut seen[t.index()], true);
            if is_new {
                list.push(t);
            }
            is_new
        });
        flooded.expect("bug: nobody cancels");
        list
    }

    /// The half-edge of the segment, towards the side.
    fn base(&self) -> HalfEdgeId {
        let [from, to] = self.base_ends();
        self.edge(from, to)
    }

    fn base_ends(&self) -> [VertexId; 2] {
        let [start, end] = [self.rim.first(), self.rim.last()].map(|e| *e.expect("bug: no rim"));
        [end[1], start[0]]
    }

    fn edge(&self, from: VertexId, to: VertexId) -> HalfEdgeId {
        let h = self.draft.find_edge(from, to);
        let h = h.expect("bug: segment and rim are edges");
        if self.draft.mesh.origin(h) == from {
            h
        } else {
            self.draft.mesh.twin(h)
        }
    }
}
