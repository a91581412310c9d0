//! Which cells are checked and timed, in which order.
//!
//! For every question and kind of points: each engine's answers are summed up in a process of its own and
//! compared with the first's, then all are timed in turns (warm-up rounds, then rounds that count).

use super::engine::Engine;
use super::job::{Answer, Job};
use super::question::Question;
use crate::process::{Fault, Launcher};
use delone_samples::Distribution;
use std::time::Duration;

/// Sums of rounded distances may differ by this part.
const SLACK: f64 = 1e-9;

/// What to measure, and how carefully.
#[derive(Clone, Debug)]
pub struct Plan {
    /// Who takes part.
    pub engines: Vec<Engine>,
    /// What is asked.
    pub questions: Vec<Question>,
    /// Of points of which kinds.
    pub distributions: Vec<Distribution>,
    /// How many points, and how many queries.
    pub size: usize,
    /// Seed of the points.
    pub seed: u64,
    /// Rounds that are discarded.
    pub warmups: usize,
    /// Rounds that count.
    pub runs: usize,
    /// Longest time for one process.
    pub timeout: Duration,
}

/// All about one engine and one question about points of one kind.
#[derive(Clone, Debug, PartialEq)]
pub struct Cell {
    /// What was asked.
    pub question: Question,
    /// About which points.
    pub distribution: Distribution,
    /// Who was asked.
    pub engine: Engine,
    /// The runs that count, or why there are none.
    pub runs: Result<Vec<Answer>, String>,
}

impl Plan {
    /// Carries the plan out; `tell` hears which group of cells is next.
    pub fn run(&self, launcher: &Launcher, tell: &mut dyn FnMut(&str)) -> Vec<Cell> {
        let mut cells = Vec::new();
        for &question in &self.questions {
            for &distribution in &self.distributions {
                tell(&format!("{question}, {distribution}"));
                let mut group = self.checked(launcher, question, distribution);
                for round in 0..self.warmups + self.runs {
                    for cell in &mut group {
                        self.time(launcher, cell, round >= self.warmups);
                    }
                }
                cells.append(&mut group);
            }
        }
        cells
    }

    /// Sums up everybody's answers.
    fn checked(
        &self,
        launcher: &Launcher,
        question: Question,
        distribution: Distribution,
    ) -> Vec<Cell> {
        let mut expected = None;
        let able = self.engines.iter().filter(|engine| engine.knows(question));
        able.map(|&engine| {
            let job = self.job(engine, question, distribution, true);
            let sum = self
                .ask(launcher, job)
                .map(|answer| answer.sum.unwrap_or(f64::NAN));
            let runs = sum.and_then(|sum| agrees(sum, *expected.get_or_insert(sum)));
            Cell {
                question,
                distribution,
                engine,
                runs: runs.map(|()| Vec::new()),
            }
        })
        .collect()
    }

    fn time(&self, launcher: &Launcher, cell: &mut Cell, counts: bool) {
        let Ok(runs) = &mut cell.runs else { return };
        let job = self.job(cell.engine, cell.question, cell.distribution, false);
        match self.ask(launcher, job) {
            Ok(answer) if counts => runs.push(answer),
            Ok(_) => {}
            Err(why) => cell.runs = Err(why),
        }
    }

    fn job(
        &self,
        engine: Engine,
        question: Question,
        distribution: Distribution,
        check: bool,
    ) -> Job {
        Job {
            engine,
            question,
            distribution,
            size: self.size,
            seed: self.seed,
            check,
        }
    }

    fn ask(&self, launcher: &Launcher, job: Job) -> Result<Answer, String> {
        match launcher.answer(&job.to_args(), self.timeout) {
            Ok(answer) => Ok(answer),
            Err(Fault::Failed { how, message }) => Err(format!("{how}: {message}")),
            Err(Fault::TimedOut(limit)) => Err(format!("> {:.0} s", limit.as_secs_f64())),
        }
    }
}

/// Compares what answers come to with what they should.
fn agrees(sum: f64, expected: f64) -> Result<(), String> {
    if (sum - expected).abs() <= SLACK * expected.abs() {
        Ok(())
    } else {
        Err(format!("wrong: answers come to {sum}, not {expected}"))
    }
}

#[cfg(test)]
mod tests {
    use super::agrees;

    #[test]
    fn sums_may_differ_by_rounding_only() {
        assert!(agrees(1.0 + 1e-12, 1.0).is_ok() && agrees(0.0, 0.0).is_ok());
        assert!(agrees(1.0 + 1e-6, 1.0).is_err() && agrees(f64::NAN, 1.0).is_err());
    }
}
