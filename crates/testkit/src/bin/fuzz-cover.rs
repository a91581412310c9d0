//! Fuzzes covers of scattered data in one process, for as long or as often as asked.

use delone_testkit::fuzz::cover::{Covering, case, check};
use delone_testkit::fuzz::{Campaign, Options, Subject};
use std::process::ExitCode;

const USAGE: &str = "\
Usage: fuzz-cover [--runs N] [--seconds S] [--seed X] [--threads T]
                  [--max-data P] [--deep-every K]

Stops after N runs or S seconds, without either after 1000000 runs. A case has 1 to P data (default 60) of every kind,
any d, and random options. Every K-th case (default 16, 0 means never) is covered in another order, too, and watched,
and what was told is played forwards and backwards.";

struct Covers {
    max_data: u64,
    deep_every: u64,
}

impl Subject for Covers {
    type Case = Covering;

    fn fill(&self, seed: u64, covering: &mut Covering) {
        case(seed, self.max_data.max(1) as usize, covering);
    }

    fn check(&self, run: u64, _: u64, covering: &Covering) -> Result<(), String> {
        check(
            covering,
            self.deep_every > 0 && run.is_multiple_of(self.deep_every),
        )
    }
}

fn main() -> ExitCode {
    let mut covers = Covers {
        max_data: 60,
        deep_every: 16,
    };
    let own = &mut [
        ("--max-data", &mut covers.max_data),
        ("--deep-every", &mut covers.deep_every),
    ];
    match Options::parse(std::env::args().skip(1), own) {
        Ok(options) => Campaign::new(covers, options).run(),
        Err(message) => {
            eprintln!("{message}\n\n{USAGE}");
            ExitCode::from(2)
        }
    }
}
