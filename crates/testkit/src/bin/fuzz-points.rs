//! Fuzzes the triangulation of points in one process, for as long or as often as asked.
//!
//! Case `i` of seed `s` is the same on every machine and for any number of threads. The first
//! failure is shrunk, printed as source code, and ends the program with exit code 1.

use delone::Point;
use delone_testkit::fuzz::{Depth, as_source, case, check, shrink};
use delone_testkit::generate::Random;
use std::process::ExitCode;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering::Relaxed};
use std::time::{Duration, Instant};

const USAGE: &str = "\
Usage: fuzz-points [--runs N] [--seconds S] [--seed X] [--threads T]
                   [--max-points P] [--incremental-every K] [--naive-every M]

Stops after N runs or S seconds, without either after 1000000 runs. A case has 1 to P points
(default 14). Every K-th case (default 1) is built incrementally too, every M-th (default 256) from
the definition, which takes O(P⁴). 0 means never.";

/// Cases that a thread takes at once.
const BATCH: u64 = 1024;

#[derive(Clone, Copy)]
struct Options {
    runs: u64,
    seconds: u64,
    seed: u64,
    threads: u64,
    max_points: u64,
    incremental_every: u64,
    naive_every: u64,
}

impl Options {
    fn parse(mut arguments: impl Iterator<Item = String>) -> Result<Self, String> {
        let mut options = Self {
            runs: u64::MAX,
            seconds: u64::MAX,
            seed: 0,
            threads: 1,
            max_points: 14,
            incremental_every: 1,
            naive_every: 256,
        };
        while let Some(name) = arguments.next() {
            let value = arguments.next().unwrap_or_default();
            let field = match name.as_str() {
                "--runs" => &mut options.runs,
                "--seconds" => &mut options.seconds,
                "--seed" => &mut options.seed,
                "--threads" => &mut options.threads,
                "--max-points" => &mut options.max_points,
                "--incremental-every" => &mut options.incremental_every,
                "--naive-every" => &mut options.naive_every,
                _ => return Err(format!("unknown option {name}")),
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

    fn depth(&self, run: u64, seed: u64) -> Depth {
        let due = |every: u64| every > 0 && run.is_multiple_of(every);
        if due(self.naive_every) {
            Depth::Naive(seed)
        } else if due(self.incremental_every) {
            Depth::Incremental(seed)
        } else {
            Depth::Topology
        }
    }
}

/// What the threads share.
struct Campaign {
    options: Options,
    start: Instant,
    next: AtomicU64,
    done: AtomicU64,
    failed: AtomicBool,
}

impl Campaign {
    fn is_over(&self) -> bool {
        self.failed.load(Relaxed) || self.start.elapsed().as_secs() >= self.options.seconds
    }

    /// Takes batches of cases until there are no more.
    fn work(&self) {
        let mut points = Vec::new();
        while !self.is_over() {
            let first = self.next.fetch_add(BATCH, Relaxed);
            let batch = first..self.options.runs.min(first.saturating_add(BATCH));
            if batch.is_empty() {
                return;
            }
            for run in batch.clone() {
                self.run(run, &mut points);
            }
            self.done.fetch_add(batch.end - batch.start, Relaxed);
        }
    }

    fn run(&self, run: u64, points: &mut Vec<Point>) {
        let seed = Random::new(self.options.seed ^ run.rotate_left(32)).bits();
        case(seed, self.options.max_points.max(1) as usize, points);
        let depth = self.options.depth(run, seed);
        if check(points, depth).is_err() && !self.failed.swap(true, Relaxed) {
            report(run, depth, points);
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

/// Prints the smallest failing subset of `points`.
fn report(run: u64, depth: Depth, points: &[Point]) {
    let small = shrink(points, |points| check(points, depth).is_err());
    let reason = check(&small, depth).err();
    println!(
        "run {run} failed: {}\nlet points = {};",
        reason.unwrap_or_else(|| "only before shrinking".to_owned()),
        as_source(&small)
    );
}

fn main() -> ExitCode {
    let options = match Options::parse(std::env::args().skip(1)) {
        Ok(options) => options,
        Err(message) => {
            eprintln!("{message}\n\n{USAGE}");
            return ExitCode::from(2);
        }
    };
    let campaign = Campaign {
        options,
        start: Instant::now(),
        next: AtomicU64::new(0),
        done: AtomicU64::new(0),
        failed: AtomicBool::new(false),
    };
    std::thread::scope(|scope| {
        let threads: Vec<_> = (0..options.threads.max(1))
            .map(|_| scope.spawn(|| campaign.work()))
            .collect();
        campaign.watch(&threads);
    });
    println!("seed {}: {}", options.seed, campaign.rate());
    ExitCode::from(u8::from(campaign.failed.into_inner()))
}
