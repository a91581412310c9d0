//! Progress and cancellation, polled once in a few thousand steps.

use crate::{Error, Phase, Watch};
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

/// Steps between two polls: below 100 ms even if every step takes an exact predicate of 20 µs.
const STRIDE: u64 = 1 << 12;

/// Counts the steps of one phase and tells the watch.
pub(crate) struct Pace<'a> {
    watch: &'a dyn Watch,
    phase: Phase,
    /// Changed at once by several [`Strides`] only.
    done: AtomicU64,
    total: u64,
}

impl<'a> Pace<'a> {
    pub(crate) fn new(watch: &'a dyn Watch, phase: Phase, total: u64) -> Self {
        Self {
            watch,
            phase,
            done: AtomicU64::new(0),
            total,
        }
    }

    /// Counts one step.
    #[inline]
    pub(crate) fn step(&mut self) -> Result<(), Error> {
        let done = self.done.get_mut();
        *done += 1;
        if done.is_multiple_of(STRIDE) {
            self.poll()
        } else {
            Ok(())
        }
    }

    /// Counts the steps of one of several tasks, which may run at once.
    pub(crate) fn strides(&self) -> Strides<'_> {
        Strides {
            pace: self,
            steps: 0,
        }
    }

    /// Asks at once, and tells how far it has come.
    #[cold]
    pub(crate) fn poll(&self) -> Result<(), Error> {
        if self.watch.is_cancelled() {
            return Err(Error::Cancelled);
        }
        // The estimate may fall short: it does not know of passes that explain a defect.
        let done = self.done.load(Relaxed).min(self.total);
        self.watch.progress(self.phase, done, self.total);
        Ok(())
    }

    /// Reports the end.
    pub(crate) fn finish(&mut self) {
        self.watch.progress(self.phase, self.total, self.total);
    }
}

/// Counts the steps of one task of a phase; the watch is told of those of all.
pub(crate) struct Strides<'p> {
    pace: &'p Pace<'p>,
    /// Not yet added to those of the others.
    steps: u64,
}

impl Strides<'_> {
    /// Counts one step.
    #[inline]
    pub(crate) fn step(&mut self) -> Result<(), Error> {
        self.steps += 1;
        if self.steps == STRIDE {
            self.hand_in();
            self.pace.poll()
        } else {
            Ok(())
        }
    }

    #[cold]
    fn hand_in(&mut self) {
        let steps = std::mem::take(&mut self.steps);
        self.pace.done.fetch_add(steps, Relaxed);
    }
}

/// What is left over counts, too.
impl Drop for Strides<'_> {
    fn drop(&mut self) {
        self.hand_in();
    }
}
