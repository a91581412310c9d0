//! What one child process is asked to cover, and what it answers.

use super::facts::Facts;
use super::laps::{Laps, Stages};
use super::subject::Subject;
use crate::measure::{Cost, under_the_clock};
use crate::python::Files;
use crate::workshop::Errand;
use delone::scattered::Cover;
use serde::{Deserialize, Serialize};
use std::io;

/// The name of the subcommand that runs a job.
pub const SUBCOMMAND: &str = "cover-job";

/// Some data, once.
#[derive(Clone, Debug, PartialEq, clap::Args)]
pub struct Job {
    /// What is covered
    #[arg(long)]
    pub subject: Subject,
    /// Seed of the data
    #[arg(long)]
    pub seed: u64,
    /// How many data each triangle shall hold at least
    #[arg(long)]
    pub least: usize,
    /// By how much the hull of the data is blown up
    #[arg(long)]
    pub factor: f64,
    /// Checks the cover
    #[arg(long)]
    pub check: bool,
}

/// What a job found.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Answer {
    /// What the cover took.
    #[serde(flatten)]
    pub cost: Cost,
    /// How that is divided among the algorithms.
    pub stages: Stages,
    /// How many data were given.
    pub given: usize,
    /// What the cover is like, if the job checks.
    pub facts: Option<Facts>,
}

impl Errand for Job {
    type Answer = Answer;

    fn to_args(&self) -> Vec<String> {
        let options = [
            ("--subject", self.subject.to_string()),
            ("--seed", self.seed.to_string()),
            ("--least", self.least.to_string()),
            ("--factor", self.factor.to_string()),
        ];
        let options = options.map(|(option, value)| [option.to_owned(), value]);
        let check = self.check.then(|| "--check".to_owned());
        let options = options.into_iter().flatten().chain(check);
        [SUBCOMMAND.to_owned()].into_iter().chain(options).collect()
    }

    fn to_words(&self, _: &Files) -> Option<io::Result<Vec<String>>> {
        None
    }
}

impl Job {
    /// Does the job in this process.
    ///
    /// # Errors
    /// If there are no such data, no cover, or something is wrong with it.
    pub fn run(self) -> Result<Answer, String> {
        let data = self.subject.data(self.seed)?;
        let options = Cover::new(self.least).factor(self.factor);
        let ((cover, stages), cost) = under_the_clock(|| {
            let mut laps = Laps::new();
            let cover = options.observe(data.iter().copied(), &mut laps);
            (cover, laps.stop())
        });
        let cover = cover.map_err(|error| error.to_string())?;
        let facts = self.check.then(|| Facts::find(&cover)).transpose()?;
        Ok(Answer {
            cost,
            stages,
            given: data.len(),
            facts,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::{Errand, Job, SUBCOMMAND};
    use clap::Parser;

    #[derive(clap::Parser)]
    struct CommandLine {
        #[command(flatten)]
        job: Job,
    }

    fn job(check: bool) -> Job {
        Job {
            subject: "clusters:2k".parse().unwrap(),
            seed: 7,
            least: 6,
            factor: 1.25,
            check,
        }
    }

    #[test]
    fn command_line_carries_the_job() {
        for check in [false, true] {
            let args = job(check).to_args();
            assert_eq!(args[0], SUBCOMMAND);
            assert_eq!(CommandLine::parse_from(args).job, job(check));
        }
    }

    #[test]
    fn a_job_tells_what_it_took_and_found() {
        let answer = job(true).run().unwrap();
        let sum = answer.stages.a + answer.stages.b + answer.stages.c;
        assert!(sum > 0.0 && sum <= answer.cost.seconds);
        let facts = answer.facts.unwrap();
        assert!((answer.given, facts.data) == (2000, 2000) && facts.fewest >= 6);
        let least = 3000;
        let hopeless = Job { least, ..job(true) };
        assert!(hopeless.run().unwrap_err().contains("3000"));
    }
}
