//! What one child process is asked, and what it answers.

use super::engine::Engine;
use super::question::Question;
use super::{kiddo, ours, rstar, spade};
use crate::measure::Cost;
use delone_samples::Distribution;
use serde::{Deserialize, Serialize};

/// The name of the subcommand that runs a job.
pub const SUBCOMMAND: &str = "query-job";

/// One engine and one question about points of one kind.
#[derive(Clone, Copy, Debug, PartialEq, clap::Args)]
pub struct Job {
    /// Who is asked
    #[arg(long)]
    pub engine: Engine,
    /// What
    #[arg(long)]
    pub question: Question,
    /// Kind of the points, and of those that are asked about
    #[arg(long)]
    pub distribution: Distribution,
    /// How many there are, of either
    #[arg(long)]
    pub size: usize,
    /// Seed of the points; those that are asked about have the next
    #[arg(long)]
    pub seed: u64,
    /// Sums up the answers
    #[arg(long)]
    pub check: bool,
}

/// What a job found.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Answer {
    /// What it took to build.
    pub build: Cost,
    /// What all queries took.
    pub queries: Cost,
    /// If the job checks, what the answers come to: how many points lie in the convex hull, or the sum of
    /// all squared distances.
    pub sum: Option<f64>,
}

impl Job {
    /// Returns the command line that makes a child of this program do the job.
    pub fn to_args(self) -> Vec<String> {
        let options = [
            ("--engine", self.engine.to_string()),
            ("--question", self.question.to_string()),
            ("--distribution", self.distribution.to_string()),
            ("--size", self.size.to_string()),
            ("--seed", self.seed.to_string()),
        ];
        let options = options
            .into_iter()
            .flat_map(|(option, value)| [option.to_owned(), value]);
        let check = self.check.then(|| "--check".to_owned());
        [SUBCOMMAND.to_owned()]
            .into_iter()
            .chain(options)
            .chain(check)
            .collect()
    }

    /// Does the job in this process.
    ///
    /// # Errors
    /// What the engine says, or that it cannot be asked this.
    pub fn run(self) -> Result<Answer, String> {
        let Self {
            engine,
            question,
            check,
            ..
        } = self;
        if !engine.knows(question) {
            return Err(format!("{engine} cannot be asked `{question}`"));
        }
        let points = self.distribution.points(self.size, self.seed);
        let asked = self
            .distribution
            .points(self.size, self.seed.wrapping_add(1));
        match engine {
            Engine::Delone { threads } => {
                ours::answer(points, &asked, question, Some(threads), check)
            }
            Engine::Singly => ours::answer(points, &asked, question, None, check),
            Engine::Spade => spade::answer(points, &asked, question, check),
            Engine::Kiddo => kiddo::answer(&points, &asked, question, check),
            Engine::Rstar => rstar::answer(points, &asked, question, check),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Engine, Job, Question, SUBCOMMAND};
    use clap::Parser;
    use delone_samples::Distribution;

    #[derive(clap::Parser)]
    struct CommandLine {
        #[command(flatten)]
        job: Job,
    }

    const JOB: Job = Job {
        engine: Engine::Singly,
        question: Question::TenNearest,
        distribution: Distribution::LonLat,
        size: 3000,
        seed: 7,
        check: true,
    };

    #[test]
    fn command_line_carries_the_job() {
        for check in [false, true] {
            let job = Job { check, ..JOB };
            let args = job.to_args();
            assert_eq!(args[0], SUBCOMMAND);
            assert_eq!(CommandLine::parse_from(args).job, job);
        }
        let foreign = Job {
            engine: Engine::Spade,
            ..JOB
        };
        assert!(foreign.run().unwrap_err().contains("ten-nearest"));
    }

    /// All say the same, but for the rounding of distances and their sum.
    #[test]
    fn engines_agree() {
        for question in Question::ALL {
            for distribution in [Distribution::Uniform, Distribution::LonLat] {
                let engines = [Engine::Singly, Engine::Delone { threads: 2 }];
                let engines = engines.into_iter().chain(Engine::PEERS);
                let able: Vec<_> = engines.filter(|e| e.knows(question)).collect();
                assert!(able.len() > 2);
                let sums: Vec<f64> = able
                    .iter()
                    .map(|&engine| Job {
                        engine,
                        question,
                        distribution,
                        ..JOB
                    })
                    .map(|job| job.run().unwrap().sum.unwrap())
                    .collect();
                for (engine, sum) in able.iter().zip(&sums) {
                    assert!(
                        (sum - sums[0]).abs() <= 1e-12 * sums[0],
                        "{engine} {question}: {sums:?}"
                    );
                }
            }
        }
    }
}
