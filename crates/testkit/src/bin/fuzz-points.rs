//! Fuzzes the triangulation of points in one process, for as long or as often as asked.

use delone::Point;
use delone_testkit::fuzz::points::{Depth, case, check};
use delone_testkit::fuzz::{Campaign, Options, Subject};
use std::process::ExitCode;

const USAGE: &str = "\
Usage: fuzz-points [--runs N] [--seconds S] [--seed X] [--threads T]
                   [--max-points P] [--incremental-every K] [--naive-every M]

Stops after N runs or S seconds, without either after 1000000 runs. A case has 1 to P points
(default 14). Every K-th case (default 1) is built incrementally too, every M-th (default 256) from
the definition, which takes O(P⁴). 0 means never.";

struct Points {
    max_points: u64,
    incremental_every: u64,
    naive_every: u64,
}

impl Points {
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

impl Subject for Points {
    type Case = Vec<Point>;

    fn fill(&self, seed: u64, points: &mut Vec<Point>) {
        case(seed, self.max_points.max(1) as usize, points);
    }

    fn check(&self, run: u64, seed: u64, points: &Vec<Point>) -> Result<(), String> {
        check(points, self.depth(run, seed))
    }
}

fn main() -> ExitCode {
    let mut points = Points {
        max_points: 14,
        incremental_every: 1,
        naive_every: 256,
    };
    let own = &mut [
        ("--max-points", &mut points.max_points),
        ("--incremental-every", &mut points.incremental_every),
        ("--naive-every", &mut points.naive_every),
    ];
    match Options::parse(std::env::args().skip(1), own) {
        Ok(options) => Campaign::new(points, options).run(),
        Err(message) => {
            eprintln!("{message}\n\n{USAGE}");
            ExitCode::from(2)
        }
    }
}
