//! A live triangulation from one that was built in bulk.

use super::constraints::Constraints;
use super::slots::Slots;
use super::{LiveTriangulation, is_straight};
use crate::constrained::Draft;
use crate::{ConstrainedTriangulation, Triangulation, VertexId};
use std::ops::Range;

impl LiveTriangulation {
    /// Takes over the points of a triangulation, which keep their numbers; those that were merged into
    /// others are not there, and their numbers are free.
    ///
    /// What was constrained in it, or carved away, is forgotten: the result is the Delaunay
    /// triangulation of the vertices. [`from_constrained`](Self::from_constrained) keeps constraints.
    ///
    /// *Cost*: O(n log n), about a microsecond for each vertex of a million.
    pub fn from_triangulation(t: &Triangulation) -> Self {
        let mut draft = draft_of(t);
        let mut suspects: Vec<_> = draft.mesh.half_edges().collect();
        suspects.retain(|&h| h < draft.mesh.twin(h));
        // Nothing happens if nothing was constrained.
        draft.settle(&mut suspects);
        Self::of(draft, slots_of(t), Constraints::default())
    }

    /// Takes over points and segments of a domain, or of a refined mesh. Vertices keep their numbers.
    ///
    /// Also returns the [numbers](super::ConstraintId::new) of the constraints of each segment: one with the segment's ends, if all vertices along
    /// it lie exactly upon it; else, as where segments cross or were refined and coordinates had to be
    /// rounded, one for each edge along it; none if it has no length. What was carved away comes back.
    ///
    /// *Cost*: O(n log n), about a microsecond for each vertex and segment of a million.
    pub fn from_constrained(t: &ConstrainedTriangulation) -> (Self, Vec<Range<usize>>) {
        let triangulation = t.triangulation();
        let mut chains = Vec::new();
        let mut of_segments = Vec::with_capacity(t.segments().len());
        for segment in 0..t.segments().len() {
            let first = chains.len();
            let chain = t.chain(segment);
            if chain.len() > 1 && is_straight(chain, |v| triangulation.point(v)) {
                chains.push(chain.to_vec());
            } else {
                chains.extend(chain.windows(2).map(<[VertexId]>::to_vec));
            }
            of_segments.push(first..chains.len());
        }
        let mut draft = draft_of(triangulation);
        for h in draft.mesh.half_edges() {
            if t.is_constrained(h) && h < draft.mesh.twin(h) {
                draft.constrain(h, false);
            }
        }
        let live = Self::of(draft, slots_of(triangulation), Constraints::new(&chains));
        (live, of_segments)
    }
}

impl From<&Triangulation> for LiveTriangulation {
    fn from(t: &Triangulation) -> Self {
        Self::from_triangulation(t)
    }
}

fn draft_of(t: &Triangulation) -> Draft {
    Draft::new(t.points().to_vec(), t.mesh().clone())
}

fn slots_of(t: &Triangulation) -> Slots {
    let mut is_used = vec![true; t.points().len()];
    for duplicate in t.duplicates() {
        is_used[duplicate.dropped.index()] = false;
    }
    Slots::new(is_used)
}
