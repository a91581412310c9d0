//! Between the numbering of the caller and that of the draft.

use super::insert::{Cut, Edge};
use super::segments::undirected;
use crate::delaunay::{CurveParts, duplicates};
use crate::order::sort_by_high_half;
use crate::parallel::Workers;
use crate::pslg::Chains;
use crate::{Duplicate, VertexId, Watch};

/// Who is who.
#[derive(Default)]
pub(crate) struct Names {
    /// For each vertex of the draft the caller's number.
    pub callers: Vec<VertexId>,
    /// For each point of the caller its vertex in the draft; that of a merged point is the vertex
    /// that stands for it.
    pub positions: Vec<VertexId>,
    pub duplicates: Vec<Duplicate>,
}

impl Names {
    pub fn of(curve: &CurveParts) -> Self {
        let callers: Vec<_> = curve
            .keys
            .iter()
            .map(|&key| VertexId::from(key as u32))
            .collect();
        let mut positions = vec![VertexId::INFINITE; callers.len()];
        for (i, v) in callers.iter().enumerate() {
            positions[v.index()] = VertexId::new(i);
        }
        let duplicates = duplicates(&curve.points, &curve.keys);
        for duplicate in &duplicates {
            positions[duplicate.dropped.index()] = positions[duplicate.kept.index()];
        }
        Self {
            callers,
            positions,
            duplicates,
        }
    }

    /// Returns the point that stands for the caller's point `v`.
    #[inline]
    pub fn representative(&self, v: VertexId) -> VertexId {
        self.callers[self.positions[v.index()].index()]
    }

    /// Turns edges of the caller into edges of the draft, in the order of the curve; those of no length
    /// are left out, equal ones are one. `None` if the watch cancelled.
    pub fn edges(
        &self,
        edges: impl Iterator<Item = [VertexId; 2]>,
        workers: Workers,
        watch: &dyn Watch,
    ) -> Option<Vec<Edge>> {
        let keys = edges.map(|edge| {
            let [a, b] = undirected(edge.map(|v| self.positions[v.index()]));
            u64::from(a.raw()) << 32 | u64::from(b.raw())
        });
        let keys = keys.filter(|&key| key >> 32 != key & 0xffff_ffff).collect();
        let bits = usize::BITS - self.positions.len().leading_zeros();
        let mut sorted = sort_by_high_half(keys, bits, workers, watch)?;
        for fan in sorted.chunk_by_mut(|a, b| a >> 32 == b >> 32) {
            fan.sort_unstable();
        }
        let runs = sorted.chunk_by(|a, b| a == b);
        let edge = |run: &[u64]| Edge {
            ends: [(run[0] >> 32) as u32, run[0] as u32].map(VertexId::from),
            is_odd: run.len() % 2 == 1,
        };
        Some(runs.map(edge).collect())
    }

    /// Lists the vertices in the caller's numbering, ascending.
    pub fn vertices(&self) -> Vec<VertexId> {
        let points = (0..self.positions.len()).map(VertexId::new);
        points.filter(|&v| self.representative(v) == v).collect()
    }

    /// Lists the chains of the segments that are not just their two ends; `inner` returns the vertices
    /// inside of a segment, given its index and its two ends as representatives.
    pub fn chains(
        &self,
        segments: &[[VertexId; 2]],
        mut inner: impl FnMut(usize, [VertexId; 2]) -> Vec<VertexId>,
    ) -> Chains {
        let mut chains = Chains::default();
        for (i, &ends) in segments.iter().enumerate() {
            let [a, b] = ends.map(|v| self.representative(v));
            if a == b {
                chains.push(i, [a]);
                continue;
            }
            let inner = inner(i, [a, b]);
            if !inner.is_empty() || [a, b] != ends {
                chains.push(i, std::iter::once(a).chain(inner).chain([b]));
            }
        }
        chains
    }

    /// Lists the chains of segments that run through vertices.
    pub fn chains_of_cuts(&self, segments: &[[VertexId; 2]], mut cuts: Vec<Cut>) -> Chains {
        cuts.sort_unstable();
        self.chains(segments, |_, ends| {
            if cuts.is_empty() {
                return Vec::new();
            }
            let [a, b] = ends.map(|v| self.positions[v.index()]);
            let edge = undirected([a, b]);
            let Ok(i) = cuts.binary_search_by_key(&edge, |cut| cut.ends) else {
                return Vec::new();
            };
            let inner = cuts[i].inner.iter().map(|v| self.callers[v.index()]);
            if a < b {
                inner.collect()
            } else {
                inner.rev().collect()
            }
        })
    }
}
