//! Runs cases on several threads for as long or as often as asked, and reports the first failure.
//!
//! Case `i` of a seed is the same on every machine and for any number of threads. A failure is
//! shrunk, printed as source code, and ends the program with exit code 1.

use super::{Case, shrink};
use crate::generate::Random;
use std::process::ExitCode;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering::Relaxed};
use std::time::{Duration, Instant};

/// Cases that a thread takes at once.
const BATCH: u64 = 1024;

/// What is fuzzed.
pub trait Subject: Sync {
    /// What it is tried with.
    type Case: Case;

    /// Replaces `case` by the one that `seed` names.
    fn fill(&self, seed: u64, case: &mut Self::Case);

    /// Checks a case; how deeply depends on the number of the run.
    ///
    /// # Errors
    /// What went wrong.
    fn check(&self, run: u64, seed: u64, case: &Self::Case) -> Result<(), String>;
}

/// What every program may be asked for.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    runs: u64,
    seconds: u64,
    seed: u64,
    threads: u64,
}

impl Options {
    /// Reads options that are followed by a whole number each, those of the program among them.
    ///
    /// # Errors
    /// An unknown option, or one without a number.
    pub fn parse(
        mut arguments: impl Iterator<Item = String>,
        own: &mut [(&str, &mut u64)],
    ) -> Result<Self, String> {
        let mut options = Self {
            runs: u64::MAX,
            seconds: u64::MAX,
            seed: 0,
            threads: 1,
        };
        while let Some(name) = arguments.next() {
            let value = arguments.next().unwrap_or_default();
            let field = match name.as_str() {
                "--runs" => &mut options.runs,
                "--seconds" => &mut options.seconds,
                "--seed" => &mut options.seed,
                "--threads" => &mut options.threads,
                _ => match own.iter_mut().find(|(own, _)| *own == name) {
                    Some((_, field)) => field,
                    None => return Err(format!("unknown option {name}")),
                },
            };
            *field = value
                .parse()
                .map_err(|_| format!("{name} needs a whole number, not {value:?}"))?;
        }
        if options.runs.min(options.seconds) == u64::MAX {
            options.runs = 1_000_000;
        }
        Ok(options)
    }
}

/// A fuzzing of `subject`.
pub struct Campaign<S> {
    subject: S,
    options: Options,
    start: Instant,
    next: AtomicU64,
    done: AtomicU64,
    failed: AtomicBool,
}

impl<S: Subject> Campaign<S> {
    /// Prepares a fuzzing.
    pub fn new(subject: S, options: Options) -> Self {
        Self {
            subject,
            options,
            start: Instant::now(),
            next: AtomicU64::new(0),
            done: AtomicU64::new(0),
            failed: AtomicBool::new(false),
        }
    }

    /// Runs it to its end, and prints the rate.
    pub fn run(self) -> ExitCode {
        std::thread::scope(|scope| {
            let threads: Vec<_> = (0..self.options.threads.max(1))
                .map(|_| scope.spawn(|| self.work()))
                .collect();
            self.watch(&threads);
        });
        println!("seed {}: {}", self.options.seed, self.rate());
        ExitCode::from(u8::from(self.failed.into_inner()))
    }

    fn is_over(&self) -> bool {
        self.failed.load(Relaxed) || self.start.elapsed().as_secs() >= self.options.seconds
    }

    /// Takes batches of cases until there are no more.
    fn work(&self) {
        let mut case = S::Case::default();
        while !self.is_over() {
            let first = self.next.fetch_add(BATCH, Relaxed);
            let batch = first..self.options.runs.min(first.saturating_add(BATCH));
            if batch.is_empty() {
                return;
            }
            for run in batch.clone() {
                self.try_case(run, &mut case);
            }
            self.done.fetch_add(batch.end - batch.start, Relaxed);
        }
    }

    fn try_case(&self, run: u64, case: &mut S::Case) {
        let seed = Random::new(self.options.seed ^ run.rotate_left(32)).bits();
        self.subject.fill(seed, case);
        let check = |case: &S::Case| self.subject.check(run, seed, case);
        if check(case).is_err() && !self.failed.swap(true, Relaxed) {
            let small = shrink(case, |case| check(case).is_err());
            let reason = check(&small).err();
            println!(
                "run {run} failed: {}\n{}",
                reason.unwrap_or_else(|| "only before shrinking".to_owned()),
                small.as_source()
            );
        }
    }

    /// Prints the rate now and then until the threads are done.
    fn watch(&self, threads: &[std::thread::ScopedJoinHandle<'_, ()>]) {
        let mut told = 0;
        while !threads.iter().all(|thread| thread.is_finished()) {
            std::thread::sleep(Duration::from_millis(20));
            let period = self.start.elapsed().as_secs() / 10;
            if period > told {
                told = period;
                eprintln!("{}", self.rate());
            }
        }
    }

    fn rate(&self) -> String {
        let (runs, seconds) = (self.done.load(Relaxed), self.start.elapsed().as_secs_f64());
        let per_minute = runs as f64 / seconds * 60.0 / 1e6;
        format!("{runs} runs in {seconds:.1} s, {per_minute:.2} million a minute")
    }
}
