//! Looking at all pairs of segments that are close to each other, on several threads.

use super::boxes::{BoxTree, Stack};
use super::meeting::Ends;
use super::vertices::Vertices;
use crate::parallel::Workers;
use crate::{Phase, Watch};
use std::ops::Range;
use std::sync::atomic::{AtomicU64, Ordering};

/// Packs segments into a tree.
pub(super) fn tree_of(
    vertices: &Vertices,
    segments: &[u32],
    ends: &[Ends],
    workers: Workers,
) -> BoxTree {
    let ends = |s: u32| ends[s as usize].map(|v| vertices.at(v));
    BoxTree::new(segments, ends, workers)
}

/// Packs vertices into a tree.
pub(super) fn tree_of_points(vertices: &Vertices, list: &[u32], workers: Workers) -> BoxTree {
    BoxTree::new(list, |v| [vertices.at(v); 2], workers)
}

/// A walk through the leaves of a tree, shared out over threads.
pub(super) struct Sweep<'a> {
    pub workers: Workers,
    pub watch: &'a dyn Watch,
    /// Units of progress made before.
    pub done: u64,
}

impl Sweep<'_> {
    /// Visits all leaves of a tree, with something to collect in that is made anew for each job, and
    /// returns what was collected, in the order of the leaves; `None` if the watch cancelled.
    pub fn leaves<T: Default + Send>(
        &self,
        tree: &BoxTree,
        visit: impl Fn(usize, &mut Query, &mut T) -> bool + Sync,
    ) -> Option<Vec<T>> {
        let total = self.done + tree.num_leaves() as u64;
        let done = AtomicU64::new(self.done);
        let collected = self.workers.map(jobs(tree.num_leaves()), |job| {
            let (mut found, length) = (T::default(), job.len() as u64);
            let mut query = Query::new(self.watch);
            for leaf in job {
                if self.watch.is_cancelled() || !visit(leaf, &mut query, &mut found) {
                    return None;
                }
            }
            let done = done.fetch_add(length, Ordering::Relaxed) + length;
            self.watch.progress(Phase::Node, done, total);
            Some(found)
        });
        collected.into_iter().collect()
    }
}

/// Cuts a number of leaves into jobs: many, because some leaves have far more to do than others.
fn jobs(leaves: usize) -> Vec<Range<usize>> {
    let length = (leaves / 256).clamp(1, 64);
    let starts = (0..leaves).step_by(length);
    starts
        .map(|start| start..(start + length).min(leaves))
        .collect()
}

/// What a query keeps at hand: its stack, and when to look at the watch.
pub(super) struct Query<'a> {
    pub stack: Stack,
    pub ticks: Ticks<'a>,
}

impl<'a> Query<'a> {
    fn new(watch: &'a dyn Watch) -> Self {
        Self {
            stack: Stack::default(),
            ticks: Ticks { watch, count: 0 },
        }
    }
}

/// Counts pairs, and looks at the watch once in a while.
pub(super) struct Ticks<'a> {
    watch: &'a dyn Watch,
    count: u32,
}

impl Ticks<'_> {
    /// Pairs between two looks at the watch: below 100 ms even if each takes 50 µs in big integers.
    const STRIDE: u32 = 1 << 10;

    /// Counts a pair; false if the watch cancelled.
    #[inline]
    pub fn step(&mut self) -> bool {
        self.count += 1;
        !self.count.is_multiple_of(Self::STRIDE) || !self.watch.is_cancelled()
    }
}
