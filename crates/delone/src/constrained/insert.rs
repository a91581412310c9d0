//! All segments: found where they are edges already, inserted where they are not.

use super::corridor::Inserter;
use super::draft::Draft;
use super::witness::{Deed, Witness, tell_lock};
use crate::parallel::Workers;
use crate::{HalfEdgeId, Phase, VertexId, Watch};

/// Faces rebuilt between two looks at the watch.
const WORK: usize = 1 << 14;

/// What came of inserting segments.
pub(super) enum Outcome {
    /// All are in; those that run through vertices are listed with them, as ends in order, and the
    /// vertices between from the first end on.
    Done(Vec<Cut>),
    /// Two of them cross.
    Blocked,
    /// The watch cancelled.
    Cancelled,
}

/// Segments between two vertices of the draft, all together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Edge {
    /// The vertices, the lower number first.
    pub ends: [VertexId; 2],
    /// Whether their number is odd.
    pub is_odd: bool,
}

/// A segment that runs through vertices.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Cut {
    /// Its ends, the lower number first.
    pub ends: [VertexId; 2],
    /// The vertices inside it, from the first end to the second.
    pub inner: Vec<VertexId>,
}

/// Inserts segments, given as different edges in the order of the curve.
///
/// *Cost*: for a segment that is an edge the lesser degree of its ends, for others in practice a few
/// tests for each edge crossed.
pub(super) fn insert_all(
    draft: &mut Draft,
    edges: &[Edge],
    workers: Workers,
    watch: &dyn Watch,
    witness: impl Witness,
) -> Outcome {
    let total = edges.len() as u64;
    watch.progress(Phase::Constrain, 0, total);
    let Some(found) = find(draft, edges, workers, watch) else {
        return Outcome::Cancelled;
    };
    // Edges first: inserting the others gives half-edges new meanings.
    let mut missing = Vec::new();
    for (&edge, h) in edges.iter().zip(found) {
        match h {
            Some(h) => {
                witness.tell(Deed::Segment(edge.ends));
                tell_lock(witness, draft, h);
                draft.constrain(h, edge.is_odd);
            }
            None => missing.push(edge),
        }
    }
    let present = total - missing.len() as u64;
    let mut inserter = Inserter::before(witness);
    let (mut cuts, mut inner) = (Vec::new(), Vec::new());
    for (edge, done) in in_rounds(&missing).zip(present..) {
        if inserter.take_work(WORK) {
            if watch.is_cancelled() {
                return Outcome::Cancelled;
            }
            watch.progress(Phase::Constrain, done, total);
        }
        witness.tell(Deed::Segment(edge.ends));
        let Ok(()) = inserter.insert(draft, edge, &mut inner) else {
            return Outcome::Blocked;
        };
        if !inner.is_empty() {
            let (ends, inner) = (edge.ends, std::mem::take(&mut inner));
            cuts.push(Cut { ends, inner });
        }
    }
    watch.progress(Phase::Constrain, total, total);
    witness.tell(Deed::Inserted);
    Outcome::Done(cuts)
}

/// Visits edges in biased randomised rounds: each edge comes with probability ½ in the last round, ¼ in
/// the one before, and so on, every round in the order given (Amenta, Choi and Rote, *Incremental
/// constructions con BRIO*, 2003).
///
/// In the order of the curve alone, parallel lines would each clear what the one before has left
/// behind: a fan of edges across all of those still to come.
fn in_rounds(edges: &[Edge]) -> impl Iterator<Item = Edge> + '_ {
    /// Rounds smaller than this are not worth their loss of locality.
    const FEW: usize = 1 << 8;
    let last = (edges.len() / FEW).max(1).ilog2();
    // Any fixed hash will do: the result does not depend on the order.
    let round = move |i: usize| {
        let hash = (i as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ i as u64 >> 3;
        last - (hash >> 32).trailing_zeros().min(last)
    };
    (0..=last).flat_map(move |r| {
        let edges = edges.iter().enumerate();
        edges
            .filter(move |&(i, _)| round(i) == r)
            .map(|(_, &edge)| edge)
    })
}

/// Finds the segments that are edges. `None` if the watch cancelled.
fn find(
    draft: &Draft,
    edges: &[Edge],
    workers: Workers,
    watch: &dyn Watch,
) -> Option<Vec<Option<HalfEdgeId>>> {
    let chunk = workers.chunk_len(edges.len(), 8).min(1 << 14);
    let found = workers.map(edges.chunks(chunk).collect(), |edges: &[Edge]| {
        let find = |&Edge { ends: [a, b], .. }: &Edge| draft.find_edge(a, b).ok();
        let found = edges.iter().map(find).collect::<Vec<_>>();
        (!watch.is_cancelled()).then_some(found)
    });
    let found: Option<Vec<_>> = found.into_iter().collect();
    Some(found?.concat())
}
