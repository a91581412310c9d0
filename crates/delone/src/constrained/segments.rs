//! The segments of the input while they are worked on: their chains, in the numbering of the draft.

use super::draft::Draft;
use crate::pslg::Chains;
use crate::{HalfEdgeId, VertexId};
use std::ops::Range;

/// All segments, as chains of vertices of a draft.
pub(super) struct Segments<'a> {
    /// The ends of each segment in the caller's numbering.
    pub ends: &'a [[VertexId; 2]],
    /// The chains of those that were cut, in the caller's numbering.
    pub chains: &'a Chains,
    pub polygons: &'a [Range<usize>],
    /// For each vertex of the caller its number in the draft.
    pub positions: &'a [VertexId],
}

impl Segments<'_> {
    /// Visits the edges along a segment, each with the lower number first.
    pub fn edges(&self, segment: usize) -> impl Iterator<Item = [VertexId; 2]> + '_ {
        let chain = self.chains.get(segment).unwrap_or(&self.ends[segment]);
        chain.windows(2).map(|pair| {
            let ends = [pair[0], pair[1]].map(|v| self.positions[v.index()]);
            undirected(ends)
        })
    }

    /// Tells whether the rule of parity takes all segments together.
    pub fn are_taken_together(&self) -> bool {
        match self.polygons {
            [] => true,
            [polygon] => *polygon == (0..self.ends.len()),
            _ => false,
        }
    }

    /// Finds the first segment along a constrained edge. *Cost*: linear; for errors only.
    pub fn first_along(&self, draft: &Draft, h: HalfEdgeId) -> usize {
        let edge = undirected([draft.mesh.origin(h), draft.mesh.dest(h)]);
        let mut all = 0..self.ends.len();
        all.find(|&segment| self.edges(segment).any(|e| e == edge))
            .expect("bug: a constrained edge belongs to a segment")
    }
}

/// Names an edge by its ends, the lower number first.
#[inline]
pub(super) fn undirected([a, b]: [VertexId; 2]) -> [VertexId; 2] {
    [a.min(b), a.max(b)]
}
