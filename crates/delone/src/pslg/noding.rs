//! Canonical noding: segments are cut where they cross, in rounds that depend on the set alone.
//!
//! A crossing is rounded to the nearest `f64`, which moves the pieces by up to half a unit in the
//! last place, so that they may cross again, or run through vertices. Rounds repeat until nothing
//! does (`rounds.rs`). Because a round looks at the whole set before it cuts anything, the result
//! does not depend on any order. After the idea of snap rounding (Hobby, *Practical segment
//! intersection with finite precision output*, 1999), on the grid of all `f64`.
//!
//! *Terminates*: rounding is monotone, so a rounded crossing lies in the bounding boxes of both
//! segments, chains stay weakly monotone in x and in y, and every round refines them on a finite
//! grid. In practice there are two or three rounds; where many would be needed, snap rounding ends them
//! (`rounds.rs`). *Drift*: at most half a unit in the last place and axis a round; input points never
//! move.
//!
//! *Cost*: in practice O((n + k) log n) for k crossings, memory O(n + k). Collinear segments that
//! overlap are cut at all vertices on them, which can be quadratic, as is their lineage.

use super::Chains;
use super::meeting::{Ends, Meeting, meet};
use super::rounds::Rounds;
use super::search::{Sweep, tree_of};
use super::vertices::{Index, Vertices};
use crate::parallel::Workers;
use crate::predicates::{construct_crossing, is_between};
use crate::{Point, VertexId, Watch};
use std::sync::OnceLock;
use std::sync::atomic::{AtomicU64, Ordering};

/// Into what segments have been cut.
pub(crate) struct Noding {
    /// The points added where segments cross, sorted by x, then y; none equals an input point.
    pub points: Vec<Point>,
    /// For each of them the lexicographically first pair of segments that were cut there.
    pub crossings: Vec<[u32; 2]>,
    /// The segments that were cut, as chains of vertices; added point `i` is vertex
    /// `points.len() + i` of the input.
    pub chains: Chains,
}

/// Cuts `segments` until they meet only at shared ends.
///
/// `vertices` lists the distinct points; the ends of segments are among them, the two of one
/// segment differ, and segments may repeat. `None` if the watch cancelled.
pub(crate) fn node(
    points: &[Point],
    vertices: &[VertexId],
    segments: &[[VertexId; 2]],
    workers: Workers,
    watch: &dyn Watch,
) -> Option<Noding> {
    let mut rounds = Rounds::new(points, vertices, segments, workers, watch)?;
    while rounds.step()? {}
    rounds.finish()
}

/// Two segments that cross in a point that is no vertex, and that point, rounded.
pub(crate) type Crossing = ([usize; 2], Point);

/// Finds the lexicographically first pair of segments that cross in a point that is no vertex.
///
/// Arguments as for [`node`]. The outer `None` says that the watch cancelled.
///
/// *Cost*: as [`node`] without its memory; pairs behind one that has been found are not looked at.
pub(crate) fn first_crossing(
    points: &[Point],
    vertices: &[VertexId],
    segments: &[[VertexId; 2]],
    workers: Workers,
    watch: &dyn Watch,
) -> Option<Option<Crossing>> {
    let vertices_at = Vertices::new(points);
    let ends: Vec<Ends> = segments
        .iter()
        .map(|ends| vertices_at.sorted(ends.map(VertexId::raw)))
        .collect();
    let first = First {
        vertices: vertices_at,
        list: vertices,
        ends: &ends,
        index: OnceLock::new(),
        best: AtomicU64::new(u64::MAX),
        watch,
    };
    let all: Vec<u32> = (0..segments.len() as u32).collect();
    let tree = tree_of(&first.vertices, &all, &ends, workers);
    let done = 0;
    let sweep = Sweep {
        workers,
        watch,
        done,
    };
    sweep.leaves(&tree, |leaf, query, _: &mut ()| {
        tree.pairs(leaf, &mut query.stack, |i, j| {
            first.look([i.min(j), i.max(j)]) && query.ticks.step()
        })
    })?;
    Some(first.crossing())
}

/// The search for the first crossing.
struct First<'a> {
    vertices: Vertices<'a>,
    list: &'a [VertexId],
    ends: &'a [Ends],
    /// Made when the first crossing has been found; `None` if the watch cancelled meanwhile.
    index: OnceLock<Option<Index>>,
    /// The first pair so far, its smaller number in the high half.
    best: AtomicU64,
    watch: &'a dyn Watch,
}

impl First<'_> {
    /// Looks at a pair, the smaller number first; false if the watch cancelled.
    fn look(&self, pair: [u32; 2]) -> bool {
        let rank = u64::from(pair[0]) << 32 | u64::from(pair[1]);
        if rank >= self.best.load(Ordering::Relaxed) {
            return true;
        }
        let [s, t] = pair.map(|i| self.ends[i as usize]);
        let mut is_crossing = false;
        if s != t {
            meet(&self.vertices, s, t, |m| {
                is_crossing |= m == Meeting::Crossing
            });
        }
        if !is_crossing {
            return true;
        }
        let list = self.list.iter().map(|v| v.raw());
        let index = self
            .index
            .get_or_init(|| Index::new(&self.vertices, list, self.watch));
        let Some(index) = index else { return false };
        if !self.is_at_vertex(index, s, t) {
            self.best.fetch_min(rank, Ordering::Relaxed);
        }
        true
    }

    /// Tells whether two segments cross exactly in a vertex. If they do, that is also where the
    /// rounded crossing lies.
    fn is_at_vertex(&self, index: &Index, s: Ends, t: Ends) -> bool {
        let [s, t] = [s, t].map(|ends| ends.map(|v| self.vertices.at(v)));
        let rounded = construct_crossing(s, t);
        index.get(rounded).is_some()
            && is_between(s[0], s[1], rounded)
            && is_between(t[0], t[1], rounded)
    }

    fn crossing(self) -> Option<Crossing> {
        let best = Some(self.best.into_inner()).filter(|&best| best != u64::MAX)?;
        let pair = [(best >> 32) as u32, best as u32];
        let [s, t] = pair.map(|i| self.ends[i as usize].map(|v| self.vertices.at(v)));
        Some((pair.map(|i| i as usize), construct_crossing(s, t)))
    }
}

#[cfg(test)]
mod tests;
