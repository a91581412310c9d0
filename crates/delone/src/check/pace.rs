//! Progress and cancellation, polled once in a few thousand steps.

use crate::{Error, Phase, Watch};

/// Steps between two polls: below 100 ms even if every step takes an exact predicate of 20 µs.
const STRIDE: u64 = 1 << 12;

/// Counts the steps of one verification and tells the watch.
pub(super) struct Pace<'a> {
    watch: &'a dyn Watch,
    done: u64,
    total: u64,
}

impl<'a> Pace<'a> {
    pub(super) fn new(watch: &'a dyn Watch, total: u64) -> Self {
        Self {
            watch,
            done: 0,
            total,
        }
    }

    /// Counts one step.
    #[inline]
    pub(super) fn step(&mut self) -> Result<(), Error> {
        self.done += 1;
        if self.done.is_multiple_of(STRIDE) {
            self.poll()
        } else {
            Ok(())
        }
    }

    #[cold]
    fn poll(&self) -> Result<(), Error> {
        if self.watch.is_cancelled() {
            return Err(Error::Cancelled);
        }
        // The passes that explain a defect are not part of the estimate.
        let done = self.done.min(self.total);
        self.watch.progress(Phase::Check, done, self.total);
        Ok(())
    }

    /// Reports the end.
    pub(super) fn finish(&mut self) {
        self.watch.progress(Phase::Check, self.total, self.total);
    }
}
