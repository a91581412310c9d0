//! The edges in order: by exact length, equal ones by their ends.
//!
//! Sorted by rounded squared lengths first; only runs of lengths that the filter of the predicate cannot
//! tell apart are sorted once more, exactly. On a lattice such runs are long, elsewhere they are rare.

use super::Proximity;
use crate::parallel::{Workers, with_workers};
use crate::predicates::{compare_lengths, compare_squared, compare_squares, squared_length};
use crate::{Error, HalfEdgeId, Point, VertexId};
use std::cmp::Ordering;

/// Elements that are sorted without asking the watch.
const CHUNK: usize = 1 << 18;

/// An edge by the bits of its rounded squared length, which are ordered as the number itself.
type Keyed = (u64, HalfEdgeId);

impl Proximity<'_> {
    /// Lists one half-edge of every edge, shortest first.
    pub(super) fn sorted_edges(&self) -> Result<Vec<HalfEdgeId>, Error> {
        let mut pace = self.pace();
        let mut keyed: Vec<Keyed> = Vec::new();
        for h in self.half_edges() {
            pace.step()?;
            keyed.push((squared_length(self.end_points(h)).to_bits(), h));
        }
        self.sort_by_key(&mut keyed)?;
        for run in keyed.chunk_by_mut(|a, b| !is_certain(a.0, b.0)) {
            if run.len() > 1 {
                self.sort_exactly(run)?;
            }
        }
        pace.finish();
        Ok(keyed.into_iter().map(|(_, h)| h).collect())
    }

    /// Sorts pieces on all threads, and merges them: a stable sort finds the sorted runs by itself.
    fn sort_by_key(&self, keyed: &mut [Keyed]) -> Result<(), Error> {
        let sort = |workers: Workers| {
            workers.map(
                keyed.chunks_mut(CHUNK).collect(),
                |chunk: &mut [Keyed]| {
                    chunk.sort_unstable();
                    self.watch.is_cancelled()
                },
            )
        };
        if with_workers(None, sort)?.contains(&true) {
            return Err(Error::Cancelled);
        }
        keyed.sort();
        Ok(())
    }

    /// Sorts edges whose lengths are equal up to rounding.
    fn sort_exactly(&self, run: &mut [Keyed]) -> Result<(), Error> {
        let order = |a: &Keyed, b: &Keyed| self.compare_edges(a.1, b.1);
        for chunk in run.chunks_mut(CHUNK / 16) {
            if self.watch.is_cancelled() {
                return Err(Error::Cancelled);
            }
            chunk.sort_by(order);
        }
        run.sort_by(order);
        Ok(())
    }

    /// Compares edges by exact length, then by their ends, the lower one first.
    pub(super) fn compare_edges(&self, g: HalfEdgeId, h: HalfEdgeId) -> Ordering {
        compare_lengths(self.end_points(g), self.end_points(h))
            .then_with(|| self.undirected(g).cmp(&self.undirected(h)))
    }

    /// The ends of an edge, the lower one first.
    pub(super) fn undirected(&self, h: HalfEdgeId) -> [VertexId; 2] {
        let mut ends = self.ends(h);
        ends.sort();
        ends
    }
}

/// Tells whether the shorter of two edges is certainly shorter, and with it all that were sorted before
/// it than all behind.
fn is_certain(shorter: u64, longer: u64) -> bool {
    let [shorter, longer] = [shorter, longer].map(f64::from_bits);
    compare_squares(shorter, longer).is_some()
}

/// An edge with its rounded squared length, to find the shortest of many.
#[derive(Clone, Copy)]
pub(super) struct Candidate {
    pub to: VertexId,
    pub square: f64,
}

impl Candidate {
    /// Tells whether this one is nearer to `from` than `other`; of equally near ones the lower index is.
    #[inline]
    pub fn is_nearer(self, from: VertexId, other: Self, point: impl Fn(VertexId) -> Point) -> bool {
        let [p, a, b] = [from, self.to, other.to].map(point);
        compare_squared(p, [a, b], [self.square, other.square])
            .then(self.to.cmp(&other.to))
            .is_lt()
    }
}
