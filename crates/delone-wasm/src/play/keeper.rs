//! Who writes down the steps of a run while it goes on: as many as there is room for, with their times, until
//! somebody says stop.

use super::clock::{Stopwatch, Times};
use crate::Trouble;
use delone::{Log, Observer, Point, Step, Watch};
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};

/// Steps that fit into the memory of a page: some 70 bytes each.
const MOST_STEPS: usize = 5_000_000;

/// Steps between two reports: a few milliseconds.
const STRIDE: usize = 1 << 14;

/// Points beyond which conflicts are not counted: each count takes linear time.
const MOST_CONFLICTS: usize = 500;

/// Is told how many steps there are, and says whether to go on.
pub(super) type Listener<'l> = dyn Fn(usize) -> bool + Sync + 'l;

/// What stops a run; an algorithm asks now and then.
#[derive(Default)]
pub(super) struct Brake {
    is_cancelled: AtomicBool,
    is_full: AtomicBool,
}

impl Watch for Brake {
    fn is_cancelled(&self) -> bool {
        self.is_cancelled.load(Relaxed) || self.is_full.load(Relaxed)
    }
}

/// Keeps steps as long as there is room.
pub(super) struct Keeper<'k> {
    log: Log,
    stopwatch: Stopwatch,
    brake: &'k Brake,
    listener: &'k Listener<'k>,
    counts_conflicts: bool,
}

impl<'k> Keeper<'k> {
    /// Begins before the first step.
    pub fn new(name: &str, points: &[Point], brake: &'k Brake, listener: &'k Listener<'k>) -> Self {
        Self {
            log: Log::new(name, points),
            stopwatch: Stopwatch::start(),
            brake,
            listener,
            counts_conflicts: points.len() <= MOST_CONFLICTS,
        }
    }

    /// Hands out what has been kept, of a run that ended so.
    ///
    /// # Errors
    /// Those of the run; or that it was stopped, even if it had come to its end before it asked.
    pub fn finish<T>(self, run: Result<T, Trouble>) -> Result<(Log, Times), Trouble> {
        if self.brake.is_full.load(Relaxed) {
            let message = format!("more than {MOST_STEPS} steps: take fewer points");
            return Err(Trouble::asked(message));
        }
        if self.brake.is_cancelled.load(Relaxed) {
            return Err(delone::Error::Cancelled.into());
        }
        run?;
        let steps = self.log.steps.len();
        Ok((self.log, self.stopwatch.stop(steps)))
    }
}

impl Observer for Keeper<'_> {
    fn observe(&mut self, step: Step) {
        if self.brake.is_cancelled() {
            return;
        }
        if self.log.steps.len() == MOST_STEPS {
            self.brake.is_full.store(true, Relaxed);
            return;
        }
        self.log.observe(step);
        let steps = self.log.steps.len();
        self.stopwatch.step(steps);
        if steps.is_multiple_of(STRIDE) && !(self.listener)(steps) {
            self.brake.is_cancelled.store(true, Relaxed);
        }
    }

    fn wants_conflicts(&self) -> bool {
        self.counts_conflicts
    }
}
