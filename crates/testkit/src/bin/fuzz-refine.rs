//! Fuzzes refinement in one process, for as long or as often as asked.

use delone_testkit::fuzz::refine::{case, check};
use delone_testkit::fuzz::{Campaign, Options, Subject};
use delone_testkit::refined::Job;
use std::process::ExitCode;

const USAGE: &str = "\
Usage: fuzz-refine [--runs N] [--seconds S] [--seed X] [--threads T]
                   [--max-points P] [--max-segments M] [--deep-every K]

Stops after N runs or S seconds, without either after 1000000 runs. A case has 1 to P points
(default 8) and up to M segments and a few more (default 6), random bounds, and at most 4000 vertices
when refined. Every K-th case (default 64, 0 means never) is refined on three threads, too, and again
at other scales.";

struct Refinements {
    max_points: u64,
    max_segments: u64,
    deep_every: u64,
}

impl Subject for Refinements {
    type Case = Job;

    fn fill(&self, seed: u64, job: &mut Job) {
        let [points, segments] = [self.max_points, self.max_segments].map(|n| n as usize);
        case(seed, points.max(1), segments, job);
    }

    fn check(&self, run: u64, _: u64, job: &Job) -> Result<(), String> {
        check(
            job,
            self.deep_every > 0 && run.is_multiple_of(self.deep_every),
        )
    }
}

fn main() -> ExitCode {
    let mut refinements = Refinements {
        max_points: 8,
        max_segments: 6,
        deep_every: 64,
    };
    let own = &mut [
        ("--max-points", &mut refinements.max_points),
        ("--max-segments", &mut refinements.max_segments),
        ("--deep-every", &mut refinements.deep_every),
    ];
    match Options::parse(std::env::args().skip(1), own) {
        Ok(options) => Campaign::new(refinements, options).run(),
        Err(message) => {
            eprintln!("{message}\n\n{USAGE}");
            ExitCode::from(2)
        }
    }
}
