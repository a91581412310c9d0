//! What may stop the work: the budget, and the watch.

use crate::clock::Clock;
use crate::delaunay::check_number;
use crate::{Budget, Outcome, Phase, Watch};

/// Steps between two looks at the watch and the clock.
const STRIDE: usize = 1 << 8;

pub(super) struct Limits<'a> {
    budget: Budget,
    clock: Clock,
    watch: &'a dyn Watch,
    steps: usize,
}

impl<'a> Limits<'a> {
    pub fn new(budget: Budget, watch: &'a dyn Watch) -> Self {
        Self {
            budget,
            clock: Clock::start(),
            watch,
            steps: 0,
        }
    }

    /// Tells whether one more vertex may join the `vertices` that there are, while `waiting` steps are
    /// known to be needed.
    ///
    /// # Errors
    /// Why not.
    pub fn admit(&mut self, vertices: usize, waiting: usize) -> Result<(), Outcome> {
        let most = self.budget.vertices.unwrap_or(usize::MAX);
        if vertices >= most || check_number(vertices + 1).is_err() {
            return Err(Outcome::BudgetExhausted);
        }
        self.steps += 1;
        if self.steps % STRIDE != 1 {
            return Ok(());
        }
        let done = vertices as u64;
        self.watch
            .progress(Phase::Refine, done, done + waiting as u64);
        if self.watch.is_cancelled() {
            Err(Outcome::Cancelled)
        } else if self.budget.time.is_some_and(|t| self.clock.elapsed() >= t) {
            Err(Outcome::BudgetExhausted)
        } else {
            Ok(())
        }
    }
}
