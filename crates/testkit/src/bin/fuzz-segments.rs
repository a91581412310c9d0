//! Fuzzes the triangulation of domains in one process, for as long or as often as asked.

use delone_testkit::domains::Domain;
use delone_testkit::fuzz::segments::{case, check};
use delone_testkit::fuzz::{Campaign, Options, Subject};
use std::process::ExitCode;

const USAGE: &str = "\
Usage: fuzz-segments [--runs N] [--seconds S] [--seed X] [--threads T]
                     [--max-points P] [--max-segments M] [--naive-every K]

Stops after N runs or S seconds, without either after 1000000 runs. A case has 1 to P points
(default 10) and up to M segments and a few more (default 8). Every K-th case (default 128, 0 means
never) is compared with the definitions, which takes O(P⁴ M), and built on three threads.";

struct Segments {
    max_points: u64,
    max_segments: u64,
    naive_every: u64,
}

impl Subject for Segments {
    type Case = Domain;

    fn fill(&self, seed: u64, domain: &mut Domain) {
        let [points, segments] = [self.max_points, self.max_segments].map(|n| n as usize);
        case(seed, points.max(1), segments, domain);
    }

    fn check(&self, run: u64, seed: u64, domain: &Domain) -> Result<(), String> {
        let is_deep = self.naive_every > 0 && run.is_multiple_of(self.naive_every);
        check(domain, is_deep, seed)
    }
}

fn main() -> ExitCode {
    let mut segments = Segments {
        max_points: 10,
        max_segments: 8,
        naive_every: 128,
    };
    let own = &mut [
        ("--max-points", &mut segments.max_points),
        ("--max-segments", &mut segments.max_segments),
        ("--naive-every", &mut segments.naive_every),
    ];
    match Options::parse(std::env::args().skip(1), own) {
        Ok(options) => Campaign::new(segments, options).run(),
        Err(message) => {
            eprintln!("{message}\n\n{USAGE}");
            ExitCode::from(2)
        }
    }
}
