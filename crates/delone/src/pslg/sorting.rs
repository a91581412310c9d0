//! Sorting millions without keeping the watch waiting.
//!
//! Quickselect halves what is to be sorted until a piece is short enough for the sort of the standard
//! library; between pieces the watch is asked. The halves are shared out over threads.
//!
//! *Cost*: O(n log n), in place.

use crate::Watch;
use crate::parallel::Workers;
use std::cmp::Ordering;

/// What is sorted in one go: some 20 ms.
const PIECE: usize = 1 << 18;

/// Sorts, equal elements in any order; `None` if the watch cancelled.
pub(super) fn sort<T: Send>(
    list: &mut [T],
    compare: impl Fn(&T, &T) -> Ordering + Copy + Send + Sync,
    workers: Workers,
    watch: &dyn Watch,
) -> Option<()> {
    if watch.is_cancelled() {
        return None;
    }
    if list.len() <= PIECE {
        list.sort_unstable_by(compare);
        return Some(());
    }
    let middle = list.len() / 2;
    list.select_nth_unstable_by(middle, compare);
    let (low, high) = list.split_at_mut(middle);
    let (low, high) = workers.join(
        || sort(low, compare, workers, watch),
        || sort(high, compare, workers, watch),
    );
    low.and(high)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Cancels at the second look.
    #[derive(Default)]
    struct Impatient(std::sync::atomic::AtomicUsize);

    impl Watch for Impatient {
        fn is_cancelled(&self) -> bool {
            self.0.fetch_add(1, std::sync::atomic::Ordering::Relaxed) > 0
        }
    }

    #[test]
    fn long_lists_are_sorted_and_can_be_cancelled() {
        let n = 5 * PIECE as u64 / 2;
        let shuffled: Vec<u64> = (0..n).map(|i| i * 1_000_003 % n).collect();
        let mut list = shuffled.clone();
        assert_eq!(sort(&mut list, Ord::cmp, Workers::ONE, &()), Some(()));
        assert!(list.into_iter().eq(0..n));
        let mut list = shuffled;
        let watch = Impatient::default();
        assert_eq!(sort(&mut list, Ord::cmp, Workers::ONE, &watch), None);
    }
}
