//! Which cells are checked and timed, in which order.
//!
//! For every question and kind of points: each engine's answers are summed up in a process of its own and
//! compared with the first's, then all are timed in turns (warm-up rounds, then rounds that count). Whoever is
//! slow when checked is timed once.

use super::engine::Engine;
use super::job::{Answer, Job};
use super::question::{Question, Room};
use crate::effort::Effort;
use crate::process::Fault;
use crate::workshop::Worker;
use delone_samples::Distribution;

/// Whoever takes more seconds is slow.
pub const SLOW: f64 = 5.0;

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
    /// How carefully.
    pub effort: Effort,
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
    /// Is it timed only once?
    pub is_slow: bool,
    /// The runs that count, or why there are none.
    pub runs: Result<Vec<Answer>, Fault>,
}

impl Plan {
    /// Carries the plan out, room by room; `tell` hears which group of cells is next, `show` gets those of a
    /// room when they are done.
    pub fn run(
        &self,
        worker: &impl Worker<Job>,
        tell: &mut dyn FnMut(&str),
        show: &mut dyn FnMut(Room, &[Cell]),
    ) -> Vec<Cell> {
        let mut cells = Vec::new();
        for room in Room::ALL {
            let start = cells.len();
            for &question in self.questions.iter().filter(|q| q.room() == room) {
                for &distribution in &self.distributions {
                    tell(&format!("{question}, {distribution}"));
                    let mut group = self.checked(worker, question, distribution);
                    self.time(worker, &mut group);
                    cells.append(&mut group);
                }
            }
            if cells.len() > start {
                show(room, &cells[start..]);
            }
        }
        cells
    }

    /// Sums up everybody's answers.
    fn checked(
        &self,
        worker: &impl Worker<Job>,
        question: Question,
        distribution: Distribution,
    ) -> Vec<Cell> {
        let mut expected = None;
        let able = self.engines.iter().filter(|engine| engine.knows(question));
        able.map(|&engine| {
            let mut cell = Cell {
                question,
                distribution,
                engine,
                is_slow: false,
                runs: Ok(Vec::new()),
            };
            match worker.run(&self.job(&cell, true), self.effort.timeout) {
                Ok(answer) => {
                    cell.is_slow = answer.seconds() > SLOW;
                    let agreed = agree(answer.sum, &mut expected, question.slack());
                    cell.runs = agreed.map(|()| Vec::new());
                }
                Err(fault) => cell.runs = Err(fault),
            }
            cell
        })
        .collect()
    }

    fn time(&self, worker: &impl Worker<Job>, group: &mut [Cell]) {
        self.effort.take_turns(group, |cell, run| {
            let job = self.job(cell, false);
            let Ok(runs) = &mut cell.runs else { return };
            if cell.is_slow && run != Some(0) {
                return;
            }
            match worker.run(&job, self.effort.timeout) {
                Ok(answer) => runs.extend(run.map(|_| answer)),
                Err(fault) => cell.runs = Err(fault),
            }
        });
    }

    fn job(&self, cell: &Cell, check: bool) -> Job {
        Job {
            engine: cell.engine,
            question: cell.question,
            distribution: cell.distribution,
            size: self.size,
            seed: self.effort.seed,
            check,
        }
    }
}

/// Compares what answers come to with what the first ones did, up to the part `slack`.
fn agree(sum: Option<f64>, first: &mut Option<f64>, slack: f64) -> Result<(), Fault> {
    let sum = sum.ok_or_else(Fault::silence)?;
    let expected = *first.get_or_insert(sum);
    if (sum - expected).abs() <= slack * expected.abs() {
        return Ok(());
    }
    let message = format!("answers come to {sum}, not {expected}");
    Err(Fault::failed("wrong", message))
}

#[cfg(test)]
mod tests {
    use super::{Answer, Cell, Effort, Engine, Fault, Job, Plan, Question, Room, agree};
    use crate::measure::Cost;
    use crate::workshop::Actor;
    use delone_samples::Distribution;
    use std::cell::RefCell;
    use std::time::Duration;

    fn answer(job: &Job, seconds: f64, sum: f64) -> Result<Answer, Fault> {
        let work = Cost {
            seconds,
            user: seconds,
            system: 0.0,
            memory: None,
        };
        Ok(Answer {
            build: None,
            work,
            number: job.size,
            sum: job.check.then_some(sum),
        })
    }

    fn carry_out(
        questions: &[Question],
        answer: impl Fn(&Job) -> Result<Answer, Fault>,
    ) -> (Vec<Cell>, Vec<Job>, Vec<(Room, usize)>) {
        let plan = Plan {
            engines: vec![Engine::Delone { threads: 1 }, Engine::Spade, Engine::Kiddo],
            questions: questions.to_vec(),
            distributions: vec![Distribution::Uniform, Distribution::Grid],
            size: 10,
            effort: Effort {
                runs: 2,
                warmups: 1,
                seed: 1,
                timeout: Duration::from_secs(1),
            },
        };
        let actor = Actor {
            answer,
            asked: RefCell::default(),
        };
        let mut shown = Vec::new();
        let cells = plan.run(&actor, &mut |_| {}, &mut |room, cells| {
            shown.push((room, cells.len()));
        });
        (cells, actor.asked.into_inner(), shown)
    }

    #[test]
    fn sums_may_differ_by_rounding_only() {
        let agrees = |sum, first| agree(sum, &mut Some(first), 1e-9).is_ok();
        assert!(agrees(Some(1.0 + 1e-12), 1.0) && agrees(Some(0.0), 0.0));
        assert!(!agrees(Some(1.0 + 1e-6), 1.0) && !agrees(Some(f64::NAN), 1.0));
        assert!(!agrees(None, 1.0) && agree(Some(7.0), &mut None, 0.0).is_ok());
    }

    #[test]
    fn rooms_are_shown_one_after_the_other() {
        let questions = [Question::Voronoi, Question::Locate, Question::Nearest];
        let (cells, asked, shown) = carry_out(&questions, |job| answer(job, 0.1, 1.0));
        // Two know where points lie and make cells, all three what is near.
        assert_eq!(shown, [(Room::Places, 2 * (2 + 3)), (Room::Cells, 2 * 2)]);
        assert_eq!(asked.len(), 4 * cells.len());
        for cell in cells {
            assert_eq!(cell.runs.map(|runs| runs.len()), Ok(2));
        }
    }

    #[test]
    fn the_slow_are_timed_once() {
        let (cells, asked, _) = carry_out(&[Question::Nearest], |job| {
            answer(
                job,
                if job.engine == Engine::Spade {
                    6.0
                } else {
                    1.0
                },
                1.0,
            )
        });
        for cell in cells {
            let is_spade = cell.engine == Engine::Spade;
            assert_eq!(cell.is_slow, is_spade);
            assert_eq!(cell.runs.unwrap().len(), if is_spade { 1 } else { 2 });
        }
        let spade = asked.iter().filter(|job| job.engine == Engine::Spade);
        assert_eq!(spade.count(), 2 * 2);
    }

    #[test]
    fn who_is_wrong_or_fails_is_not_timed() {
        let (cells, asked, _) = carry_out(&[Question::Nearest], |job| match job.engine {
            Engine::Spade => answer(job, 1.0, 2.0),
            Engine::Kiddo => Err(Fault::TimedOut(Duration::from_secs(1))),
            _ => answer(job, 1.0, 1.0),
        });
        assert_eq!(asked.len(), 2 * (4 + 1 + 1));
        let shorts: Vec<_> = cells.iter().filter_map(|c| c.runs.as_ref().err()).collect();
        let shorts: Vec<_> = shorts.into_iter().map(Fault::in_short).collect();
        assert_eq!(shorts, ["wrong", "> 1 s", "wrong", "> 1 s"]);
    }
}
