//! Which data are checked and timed, in which order: one after the other, each checked in a process of its own, then
//! timed in fresh ones.

use super::facts::Facts;
use super::job::{Answer, Job};
use super::subject::Subject;
use crate::effort::Effort;
use crate::process::Fault;
use crate::workshop::Worker;

/// What to measure, and how carefully.
#[derive(Clone, Debug)]
pub struct Plan {
    /// What is covered.
    pub subjects: Vec<Subject>,
    /// How many data each triangle shall hold at least.
    pub least: usize,
    /// By how much the hull of the data is blown up.
    pub factor: f64,
    /// How carefully.
    pub effort: Effort,
}

/// All about some data.
#[derive(Clone, Debug, PartialEq)]
pub struct Cell {
    /// What is covered.
    pub subject: Subject,
    /// What the cover is like.
    pub facts: Result<Facts, Fault>,
    /// The runs that count.
    pub runs: Vec<Answer>,
}

impl Plan {
    /// Carries the plan out; `tell` hears which data are next.
    pub fn run(&self, worker: &impl Worker<Job>, tell: &mut dyn FnMut(&str)) -> Vec<Cell> {
        let cells = self.subjects.iter().map(|subject| {
            tell(&subject.to_string());
            let mut cell = Cell {
                subject: subject.clone(),
                facts: self.facts(worker, subject),
                runs: Vec::new(),
            };
            self.time(worker, &mut cell);
            cell
        });
        cells.collect()
    }

    fn facts(&self, worker: &impl Worker<Job>, subject: &Subject) -> Result<Facts, Fault> {
        let answer = worker.run(&self.job(subject, true), self.effort.timeout)?;
        answer.facts.ok_or_else(Fault::silence)
    }

    fn time(&self, worker: &impl Worker<Job>, cell: &mut Cell) {
        let job = self.job(&cell.subject, false);
        self.effort
            .take_turns(std::slice::from_mut(cell), |cell, run| {
                if cell.facts.is_err() {
                    return;
                }
                match worker.run(&job, self.effort.timeout) {
                    Ok(answer) => cell.runs.extend(run.map(|_| answer)),
                    Err(fault) => cell.facts = Err(fault),
                }
            });
    }

    fn job(&self, subject: &Subject, check: bool) -> Job {
        Job {
            subject: subject.clone(),
            seed: self.effort.seed,
            least: self.least,
            factor: self.factor,
            check,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::report::tests::{answer, plan};
    use super::Fault;
    use crate::workshop::Actor;
    use std::cell::RefCell;

    #[test]
    fn checks_come_first_and_who_fails_is_not_timed() {
        let actor = Actor {
            answer: |job: &super::Job| match job.subject.kind() {
                "lattice" => Err(Fault::failed("error", "wrong")),
                _ => Ok(answer(1e-3, job.check)),
            },
            asked: RefCell::default(),
        };
        let mut told = 0;
        let cells = plan().run(&actor, &mut |_| told += 1);
        assert_eq!((cells.len(), told), (3, 3));
        let runs: Vec<_> = cells.iter().map(|cell| cell.runs.len()).collect();
        assert_eq!(runs, [2, 2, 0]);
        assert!(cells[2].facts.is_err());
        // Check, warm-up, two that count.
        let asked = actor.asked.into_inner();
        let checks: Vec<_> = asked.iter().map(|job| job.check).collect();
        let timed = [true, false, false, false];
        assert_eq!(checks, [&timed[..], &timed, &[true]].concat());
    }
}
