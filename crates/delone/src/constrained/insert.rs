//! All segments: put into the order of the curve, found where they are edges already, inserted where
//! they are not.

use super::corridor::Inserter;
use super::draft::Draft;
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

/// A segment that runs through vertices.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Cut {
    /// Its ends, the lower number first.
    pub ends: [VertexId; 2],
    /// The vertices inside it, from the first end to the second.
    pub inner: Vec<VertexId>,
}

/// Inserts segments, each as its two different ends in the numbering of `draft`, the lower number
/// first, best in the order of the curve.
///
/// *Cost*: for a segment that is an edge the degree of a vertex, for others in practice a few tests
/// for each edge crossed.
pub(super) fn insert_all(
    draft: &mut Draft,
    segments: &[[VertexId; 2]],
    workers: Workers,
    watch: &dyn Watch,
) -> Outcome {
    let total = segments.len() as u64;
    watch.progress(Phase::Constrain, 0, total);
    let Some(found) = find(draft, segments, workers, watch) else {
        return Outcome::Cancelled;
    };
    // Edges first: inserting the others gives half-edges new meanings.
    for &h in found.iter().flatten() {
        draft.constrain(h);
    }
    let missing = segments.iter().zip(&found).filter(|(_, h)| h.is_none());
    let missing: Vec<_> = missing.map(|(&ends, _)| ends).collect();
    drop(found);
    let present = total - missing.len() as u64;
    let mut inserter = Inserter::default();
    let (mut cuts, mut inner) = (Vec::new(), Vec::new());
    for (&ends, done) in missing.iter().zip(present..) {
        if inserter.take_work(WORK) {
            if watch.is_cancelled() {
                return Outcome::Cancelled;
            }
            watch.progress(Phase::Constrain, done, total);
        }
        let Ok(()) = inserter.insert(draft, ends, &mut inner) else {
            return Outcome::Blocked;
        };
        if !inner.is_empty() {
            let inner = std::mem::take(&mut inner);
            cuts.push(Cut { ends, inner });
        }
    }
    watch.progress(Phase::Constrain, total, total);
    Outcome::Done(cuts)
}

/// Finds the segments that are edges. `None` if the watch cancelled.
fn find(
    draft: &Draft,
    segments: &[[VertexId; 2]],
    workers: Workers,
    watch: &dyn Watch,
) -> Option<Vec<Option<HalfEdgeId>>> {
    let chunk = workers.chunk_len(segments.len(), 8).min(1 << 16);
    let found = workers.map(segments.chunks(chunk).collect(), |segments: &[_]| {
        let find = |&[a, b]: &[VertexId; 2]| draft.find_edge(a, b).ok();
        let found = segments.iter().map(find).collect::<Vec<_>>();
        (!watch.is_cancelled()).then_some(found)
    });
    let found: Option<Vec<_>> = found.into_iter().collect();
    Some(found?.concat())
}
