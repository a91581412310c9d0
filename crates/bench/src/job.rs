//! What one child process is asked to do, and what it answers.

use crate::distributions::Distribution;
use crate::engines::Engine;
use crate::expected;
use crate::measure::Run;
use serde::{Deserialize, Serialize};

/// The name of the subcommand that runs a job.
pub const SUBCOMMAND: &str = "job";

/// One engine on one kind of points, some times in a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::Args)]
pub struct Job {
    /// Who triangulates
    #[arg(long)]
    pub engine: Engine,
    /// How the points are spread
    #[arg(long)]
    pub distribution: Distribution,
    /// How many points
    #[arg(long)]
    pub points: usize,
    /// Seed of the first repeat; each further one takes the next
    #[arg(long)]
    pub seed: u64,
    /// How often, each time on new points
    #[arg(long)]
    pub repeats: usize,
    /// Checks the results and counts the triangles they must have
    #[arg(long)]
    pub verify: bool,
}

/// What a job found.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Answer {
    /// One entry a repeat.
    pub runs: Vec<Run>,
    /// Number of triangles that the first repeat's points must have, if the job verifies.
    pub expected: Option<usize>,
}

impl Job {
    /// Returns the command line that makes a child do this job.
    pub fn to_args(self) -> Vec<String> {
        let mut args = vec![SUBCOMMAND.to_owned()];
        let options = [
            ("--engine", self.engine.to_string()),
            ("--distribution", self.distribution.to_string()),
            ("--points", self.points.to_string()),
            ("--seed", self.seed.to_string()),
            ("--repeats", self.repeats.to_string()),
        ];
        args.extend(options.into_iter().flat_map(|(k, v)| [k.to_owned(), v]));
        args.extend(self.verify.then(|| "--verify".to_owned()));
        args
    }

    /// Does the job in this process.
    ///
    /// # Errors
    /// What the engine, or its verification, says.
    pub fn run(self) -> Result<Answer, String> {
        let runs = (0..self.repeats as u64)
            .map(|i| self.engine.run(self.make_points(i), self.verify))
            .collect::<Result<_, _>>()?;
        Ok(Answer {
            runs,
            // Counted after the measurement, on points made anew: neither may weigh on it.
            expected: self
                .verify
                .then(|| expected::num_triangles(&self.make_points(0))),
        })
    }

    fn make_points(self, repeat: u64) -> Vec<[f64; 2]> {
        self.distribution
            .points(self.points, self.seed.wrapping_add(repeat))
    }
}

#[cfg(test)]
mod tests {
    use super::{Job, SUBCOMMAND};
    use crate::distributions::Distribution;
    use crate::engines::Engine;
    use clap::Parser;

    #[derive(clap::Parser)]
    struct CommandLine {
        #[command(flatten)]
        job: Job,
    }

    const JOB: Job = Job {
        engine: Engine::Spade,
        distribution: Distribution::Grid,
        points: 144,
        seed: 9,
        repeats: 3,
        verify: true,
    };

    #[test]
    fn command_line_carries_the_job() {
        for job in [
            JOB,
            Job {
                verify: false,
                ..JOB
            },
        ] {
            let args = job.to_args();
            assert_eq!(args[0], SUBCOMMAND);
            assert_eq!(CommandLine::parse_from(args).job, job);
        }
    }

    #[test]
    fn repeats_are_measured_and_the_first_checked() {
        let answer = JOB.run().unwrap();
        assert_eq!(answer.runs.len(), 3);
        assert_eq!(answer.expected, Some(2 * 11 * 11));
        assert!(answer.runs.iter().all(|run| run.triangles == 2 * 11 * 11));
    }
}
