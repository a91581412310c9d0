//! Fuzzes live editing in one process, for as long or as often as asked.

use delone_testkit::fuzz::edit::{Script, case, check};
use delone_testkit::fuzz::{Campaign, Options, Subject};
use std::process::ExitCode;

const USAGE: &str = "\
Usage: fuzz-edit [--runs N] [--seconds S] [--seed X] [--threads T]
                 [--max-points P] [--max-edits E]

Stops after N runs or S seconds, without either after 1000000 runs. A case begins with up to P points
(default 12) and does 1 to E edits (default 30): vertices come, go and move, constraints too, alone or
in transactions. After every edit the result is compared with one made from scratch.";

struct Edits {
    max_points: u64,
    max_edits: u64,
}

impl Subject for Edits {
    type Case = Script;

    fn fill(&self, seed: u64, script: &mut Script) {
        let [points, edits] = [self.max_points, self.max_edits].map(|n| n as usize);
        case(seed, points, edits.max(1), script);
    }

    fn check(&self, _: u64, _: u64, script: &Script) -> Result<(), String> {
        check(script)
    }
}

fn main() -> ExitCode {
    let mut edits = Edits {
        max_points: 12,
        max_edits: 30,
    };
    let own = &mut [
        ("--max-points", &mut edits.max_points),
        ("--max-edits", &mut edits.max_edits),
    ];
    match Options::parse(std::env::args().skip(1), own) {
        Ok(options) => Campaign::new(edits, options).run(),
        Err(message) => {
            eprintln!("{message}\n\n{USAGE}");
            ExitCode::from(2)
        }
    }
}
