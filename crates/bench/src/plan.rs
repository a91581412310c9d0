//! Which cells are checked and timed, in which order.
//!
//! For every subject and size: each engine's result is checked in a process of its own, then
//! the engines that did not fail are timed in turns (warm-up rounds, then rounds that count), then
//! each runs its repeats in one process. An engine that took too long at one size is not tried at
//! a larger one of the same subject. Engines that cannot
//! take a subject have no cell there.

use crate::engines::Engine;
use crate::expected::Expected;
use crate::job::{Answer, Job};
use crate::measure::Run;
use crate::process::{Fault, Launcher};
use crate::subject::{Subject, Task};
use std::time::Duration;

/// What to measure, and how carefully.
#[derive(Clone, Debug)]
pub struct Plan {
    /// Who takes part.
    pub engines: Vec<Engine>,
    /// What is done; all subjects are for this.
    pub task: Task,
    /// On which points or domains.
    pub subjects: Vec<Subject>,
    /// How many points or segments, ascending.
    pub sizes: Vec<usize>,
    /// Seed of the input of all fresh processes, and of the first repeat.
    pub seed: u64,
    /// Rounds of fresh processes that are discarded.
    pub warmups: usize,
    /// Rounds of fresh processes that count.
    pub runs: usize,
    /// Triangulations in one process; 0 leaves that mode out.
    pub repeats: usize,
    /// Longest time for one triangulation, with the making of its input.
    pub timeout: Duration,
}

/// Is the result right, as far as was checked?
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// The numbers of triangles and constrained edges are right where they are known, and what the
    /// engine checks itself holds.
    Right,
    /// The number of triangles is wrong. The times stand, with a mark.
    Wrong {
        /// Triangles in the result.
        triangles: usize,
        /// Triangles that there must be.
        expected: usize,
    },
    /// There is no result, or none that counts.
    Faulty(Fault),
}

/// All about one engine on one input.
#[derive(Clone, Debug, PartialEq)]
pub struct Cell {
    /// Kind of points, or domain.
    pub subject: Subject,
    /// How many points or segments.
    pub size: usize,
    /// Who triangulates.
    pub engine: Engine,
    /// What the check found.
    pub verdict: Verdict,
    /// The runs in fresh processes that count.
    pub fresh: Vec<Run>,
    /// The runs in one process.
    pub repeated: Vec<Run>,
}

impl Cell {
    /// Tells whether the engine produced something that can be timed.
    pub fn is_timed(&self) -> bool {
        matches!(self.verdict, Verdict::Right | Verdict::Wrong { .. })
    }
}

/// Does a job, wherever and however.
pub trait Worker {
    /// Runs `job`, for no longer than `timeout`.
    ///
    /// # Errors
    /// What became of it, if it does not answer.
    fn run(&self, job: Job, timeout: Duration) -> Result<Answer, Fault>;
}

impl Worker for Launcher {
    fn run(&self, job: Job, timeout: Duration) -> Result<Answer, Fault> {
        self.answer(&job.to_args(), timeout)
    }
}

impl Plan {
    /// Carries the plan out; `tell` hears which group of cells is next.
    pub fn run(&self, worker: &impl Worker, tell: &mut dyn FnMut(&str)) -> Vec<Cell> {
        let mut cells: Vec<Cell> = Vec::new();
        for &subject in &self.subjects {
            for &size in &self.sizes {
                tell(&format!("{subject}, {size} {}s", self.task.unit()));
                let mut group = self.check_group(worker, subject, size, &cells);
                self.time_fresh(worker, &mut group);
                self.time_repeated(worker, &mut group);
                cells.append(&mut group);
            }
        }
        cells
    }

    fn check_group(
        &self,
        worker: &impl Worker,
        subject: Subject,
        size: usize,
        before: &[Cell],
    ) -> Vec<Cell> {
        let mut our_hash = None;
        let cell = |engine: Engine| {
            let mut cell = Cell {
                subject,
                size,
                engine,
                verdict: Verdict::Right,
                fresh: Vec::new(),
                repeated: Vec::new(),
            };
            cell.verdict = timed_out_before(&cell, before)
                .unwrap_or_else(|| self.check(worker, &cell, &mut our_hash));
            cell
        };
        let engines = self.engines.iter().copied();
        engines.filter(|e| e.takes(subject)).map(cell).collect()
    }

    fn check(&self, worker: &impl Worker, cell: &Cell, our_hash: &mut Option<String>) -> Verdict {
        let job = Job {
            verify: true,
            ..self.job(cell)
        };
        let answer = worker.run(job, self.timeout);
        let verdict = answer.and_then(|answer| judge(&answer, our_hash));
        verdict.unwrap_or_else(Verdict::Faulty)
    }

    /// Lets the engines take turns, so that a slow minute of the machine hits all of them.
    fn time_fresh(&self, worker: &impl Worker, group: &mut [Cell]) {
        for round in 0..self.warmups + self.runs {
            for cell in group.iter_mut().filter(|cell| cell.is_timed()) {
                match worker.run(self.job(cell), self.timeout) {
                    Ok(answer) if round >= self.warmups => cell.fresh.extend(answer.runs),
                    Ok(_) => (),
                    Err(fault) => cell.verdict = Verdict::Faulty(fault),
                }
            }
        }
    }

    fn time_repeated(&self, worker: &impl Worker, group: &mut [Cell]) {
        if self.repeats == 0 {
            return;
        }
        for cell in group.iter_mut().filter(|cell| cell.is_timed()) {
            let job = Job {
                repeats: self.repeats,
                ..self.job(cell)
            };
            match worker.run(job, self.timeout * self.repeats as u32) {
                Ok(answer) => cell.repeated = answer.runs,
                Err(fault) => cell.verdict = Verdict::Faulty(fault),
            }
        }
    }

    fn job(&self, cell: &Cell) -> Job {
        Job {
            engine: cell.engine,
            subject: cell.subject,
            size: cell.size,
            seed: self.seed,
            repeats: 1,
            verify: false,
        }
    }
}

fn timed_out_before(cell: &Cell, before: &[Cell]) -> Option<Verdict> {
    let hung = before.iter().find(|other| {
        other.engine == cell.engine
            && other.subject == cell.subject
            && other.size <= cell.size
            && matches!(other.verdict, Verdict::Faulty(Fault::TimedOut(_)))
    });
    hung.map(|other| other.verdict.clone())
}

/// Judges a verified answer.
fn judge(answer: &Answer, our_hash: &mut Option<String>) -> Result<Verdict, Fault> {
    let run = answer.runs.first().ok_or_else(Fault::silence)?;
    if let Some(expected) = answer.expected {
        if run.triangles != expected.triangles {
            return Ok(Verdict::Wrong {
                triangles: run.triangles,
                expected: expected.triangles,
            });
        }
        require_segments(run, expected)?;
    }
    agree(run.hash.as_deref(), our_hash)?;
    Ok(Verdict::Right)
}

fn require_segments(run: &Run, expected: Expected) -> Result<(), Fault> {
    let wanted = expected.constrained;
    match run.constrained {
        Some(found) if found != wanted => {
            let message = format!("{found} constrained edges instead of {wanted}");
            Err(Fault::failed("segments", message))
        }
        _ => Ok(()),
    }
}

/// Requires that whoever names its set of triangles names the same one on any number of threads; the
/// first one is kept.
pub(crate) fn agree(hash: Option<&str>, first: &mut Option<String>) -> Result<(), Fault> {
    let Some(hash) = hash else { return Ok(()) };
    match first.get_or_insert_with(|| hash.to_owned()) {
        first if first == hash => Ok(()),
        first => {
            let message = format!("hash {hash}, but with other threads {first}");
            Err(Fault::failed("differs", message))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Cell, Plan, Verdict, Worker};
    use crate::engines::Engine;
    use crate::expected::Expected;
    use crate::job::{Answer, Job};
    use crate::measure::{Cost, Run};
    use crate::process::Fault;
    use crate::subject::{Subject, Task};
    use delone_samples::{Distribution, Domain};
    use std::cell::RefCell;
    use std::time::Duration;

    /// Answers from thin air and remembers what it was asked.
    struct Script<F: Fn(Job) -> Result<Answer, Fault>> {
        answer: F,
        asked: RefCell<Vec<Job>>,
    }

    impl<F: Fn(Job) -> Result<Answer, Fault>> Worker for Script<F> {
        fn run(&self, job: Job, _: Duration) -> Result<Answer, Fault> {
            self.asked.borrow_mut().push(job);
            (self.answer)(job)
        }
    }

    fn done(job: Job, triangles: usize, hash: &str) -> Result<Answer, Fault> {
        let run = Run {
            cost: Cost {
                seconds: 1.0,
                user: 1.0,
                system: 0.0,
                memory: None,
            },
            triangles,
            constrained: None,
            hash: (job.verify && job.engine.is_ours()).then(|| hash.to_owned()),
        };
        Ok(Answer {
            runs: vec![run; job.repeats],
            expected: job.verify.then_some(Expected {
                triangles: 7,
                constrained: 3,
            }),
        })
    }

    fn carry_out(
        engines: &[Engine],
        answer: impl Fn(Job) -> Result<Answer, Fault>,
    ) -> (Vec<Cell>, Vec<Job>) {
        carry_out_on(Distribution::Uniform.into(), engines, answer)
    }

    fn carry_out_on(
        subject: Subject,
        engines: &[Engine],
        answer: impl Fn(Job) -> Result<Answer, Fault>,
    ) -> (Vec<Cell>, Vec<Job>) {
        let plan = Plan {
            engines: engines.to_vec(),
            task: subject.task(),
            subjects: vec![subject],
            sizes: vec![10, 20],
            seed: 3,
            warmups: 2,
            runs: 4,
            repeats: 5,
            timeout: Duration::from_secs(1),
        };
        let script = Script {
            answer,
            asked: RefCell::default(),
        };
        let cells = plan.run(&script, &mut |_| {});
        (cells, script.asked.into_inner())
    }

    const ONE: Engine = Engine::Delone { threads: 1 };
    const TWO: Engine = Engine::Delone { threads: 2 };

    #[test]
    fn warmups_are_discarded_and_engines_take_turns() {
        let (cells, asked) = carry_out(&[ONE, Engine::Spade], |job| done(job, 7, "h"));
        assert_eq!(cells.len(), 4);
        for cell in &cells {
            assert_eq!(cell.verdict, Verdict::Right);
            assert_eq!((cell.fresh.len(), cell.repeated.len()), (4, 5));
        }
        let first_group = &asked[..2 + 2 * 6 + 2];
        let engines: Vec<Engine> = first_group.iter().map(|job| job.engine).collect();
        assert_eq!(engines, [ONE, Engine::Spade].repeat(8));
        let verified = first_group.iter().map(|job| job.verify).take(3);
        assert!(verified.eq([true, true, false]));
    }

    #[test]
    fn whoever_hangs_is_not_asked_again() {
        let limit = Duration::from_secs(1);
        let (cells, asked) = carry_out(&[Engine::Delaunator], |_| Err(Fault::TimedOut(limit)));
        assert_eq!(asked.len(), 1);
        assert_eq!(cells.len(), 2);
        for cell in cells {
            assert_eq!(cell.verdict, Verdict::Faulty(Fault::TimedOut(limit)));
        }
    }

    #[test]
    fn wrong_counts_are_timed_and_crashes_are_not() {
        let (cells, _) = carry_out(&[Engine::Delaunator, Engine::Cdt], |job| {
            if job.engine == Engine::Delaunator {
                return done(job, 6, "");
            }
            Err(Fault::failed("panic", "index"))
        });
        let wrong = Verdict::Wrong {
            triangles: 6,
            expected: 7,
        };
        assert_eq!((&cells[0].verdict, cells[0].fresh.len()), (&wrong, 4));
        assert!(
            matches!(&cells[1].verdict, Verdict::Faulty(Fault::Failed { how, .. }) if how == "panic")
        );
        assert!(cells[1].fresh.is_empty() && cells[1].repeated.is_empty());
    }

    #[test]
    fn a_crash_under_the_clock_revokes_the_verdict() {
        let (cells, _) = carry_out(&[Engine::Spade], |job| {
            if job.repeats > 1 {
                return Err(Fault::TimedOut(Duration::from_secs(5)));
            }
            done(job, 7, "")
        });
        assert!(matches!(
            cells[0].verdict,
            Verdict::Faulty(Fault::TimedOut(_))
        ));
    }

    #[test]
    fn our_hash_must_not_depend_on_threads() {
        let (cells, _) = carry_out(&[ONE, TWO], |job| done(job, 7, &job.engine.to_string()));
        assert_eq!(cells[0].verdict, Verdict::Right);
        assert!(
            matches!(&cells[1].verdict, Verdict::Faulty(Fault::Failed { how, .. }) if how == "differs")
        );
    }
    #[test]
    fn lost_segments_are_a_failure() {
        let (cells, _) = carry_out_on(Domain::Coast.into(), &[ONE, Engine::Cdt], |job| {
            let Ok(mut answer) = done(job, 7, "h") else {
                unreachable!("done is done")
            };
            answer.runs[0].constrained = job.engine.is_ours().then_some(2);
            Ok(answer)
        });
        assert!(
            matches!(&cells[0].verdict, Verdict::Faulty(Fault::Failed { how, .. }) if how == "segments")
        );
        assert_eq!(cells[1].verdict, Verdict::Right);
    }

    #[test]
    fn engines_have_cells_only_where_they_can_work() {
        let everyone = [ONE, Engine::Spade, Engine::Cdt, Engine::Delaunator];
        for (domain, expected) in [
            (Domain::Coast, &everyone[..3]),
            (Domain::Segments, &everyone[..2]),
        ] {
            let (cells, _) = carry_out_on(domain.into(), &everyone, |job| done(job, 7, "h"));
            let engines = cells[..cells.len() / 2].iter().map(|cell| cell.engine);
            assert!(engines.eq(expected.iter().copied()), "{domain}");
        }
        assert_eq!(Subject::from(Domain::Tangle).task(), Task::Crossings);
    }
}
