//! Progress and cancellation, polled once in a few thousand steps.

use crate::{Error, Phase, Watch};

/// Steps between two polls: below 100 ms even if every step takes an exact predicate of 20 µs.
const STRIDE: u64 = 1 << 12;

/// Counts the steps of one phase and tells the watch.
pub(crate) struct Pace<'a> {
    watch: &'a dyn Watch,
    phase: Phase,
    done: u64,
    total: u64,
}

impl<'a> Pace<'a> {
    pub(crate) fn new(watch: &'a dyn Watch, phase: Phase, total: u64) -> Self {
        Self {
            watch,
            phase,
            done: 0,
            total,
        }
    }

    /// Counts one step.
    #[inline]
    pub(crate) fn step(&mut self) -> Result<(), Error> {
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
        // The estimate may fall short: it does not know of passes that explain a defect.
        let done = self.done.min(self.total);
        self.watch.progress(self.phase, done, self.total);
        Ok(())
    }

    /// Reports the end.
    pub(crate) fn finish(&mut self) {
        self.watch.progress(self.phase, self.total, self.total);
    }
}
