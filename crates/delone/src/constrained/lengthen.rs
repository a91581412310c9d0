//! Chains of segments that grow by the vertices that their edges have been cut at.

use super::segments::undirected;
use crate::VertexId;
use crate::pslg::Chains;

/// Stands for the segment of a vertex that is on none.
pub(crate) const NO_SEGMENT: u32 = u32::MAX;

/// Edges that have been cut, found by their ends.
pub(crate) struct Cuts {
    by_ends: Vec<([VertexId; 2], u32)>,
    /// Whether a vertex is the end of one: most segments need no search then.
    is_end: Vec<bool>,
}

impl Cuts {
    /// Takes the ends of edges between `vertices` vertices.
    pub fn new(vertices: usize, edges: impl Iterator<Item = [VertexId; 2]>) -> Self {
        let mut by_ends: Vec<_> = edges.map(undirected).zip(0..).collect();
        by_ends.sort_unstable();
        let mut is_end = vec![false; vertices];
        for v in by_ends.iter().flat_map(|(ends, _)| ends) {
            is_end[v.index()] = true;
        }
        Self { by_ends, is_end }
    }

    /// Returns the number of the edge between two vertices.
    pub fn find(&self, ends: [VertexId; 2]) -> Option<u32> {
        if !ends.iter().all(|v| self.is_end[v.index()]) {
            return None;
        }
        let ends = undirected(ends);
        let found = self.by_ends.binary_search_by_key(&ends, |&(ends, _)| ends);
        found.ok().map(|i| self.by_ends[i].1)
    }

    /// Lengthens the chains of `segments`, of which `position` gives the number that cuts know a vertex by;
    /// `inside` appends to a chain the vertices inside a cut edge, seen from its first end, given its number
    /// and ends. Returns the chains, and for each edge the first segment along it.
    pub fn lengthen(
        &self,
        segments: &[[VertexId; 2]],
        chains: &Chains,
        position: impl Fn(VertexId) -> VertexId,
        inside: impl Fn(u32, [VertexId; 2], &mut Vec<VertexId>),
    ) -> (Chains, Vec<u32>) {
        let mut segment_of = vec![NO_SEGMENT; self.by_ends.len()];
        let mut lengthened = Chains::default();
        for (segment, ends) in segments.iter().enumerate() {
            let old = chains.get(segment);
            let chain = old.unwrap_or(ends);
            // Most segments have not been cut, and nothing is written down about them.
            let mut longer = Vec::new();
            for (i, pair) in chain.windows(2).enumerate() {
                let ends = [pair[0], pair[1]].map(&position);
                if let Some(edge) = self.find(ends) {
                    if longer.is_empty() {
                        longer.extend(&chain[..=i]);
                    }
                    let first = &mut segment_of[edge as usize];
                    *first = (*first).min(segment as u32);
                    inside(edge, ends, &mut longer);
                }
                if !longer.is_empty() {
                    longer.push(pair[1]);
                }
            }
            if !longer.is_empty() {
                lengthened.push(segment, longer);
            } else if old.is_some() {
                lengthened.push(segment, chain.iter().copied());
            }
        }
        (lengthened, segment_of)
    }
}
