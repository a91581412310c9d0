//! What one child process is asked to do, and what it answers.

use crate::engines::Engine;
use crate::expected::Expected;
use crate::measure::Run;
use crate::subject::Subject;
use delone_samples::Drawing;
use serde::{Deserialize, Serialize};

/// The name of the subcommand that runs a job.
pub const SUBCOMMAND: &str = "job";

/// One engine on one kind of input, some times in a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::Args)]
pub struct Job {
    /// Who triangulates
    #[arg(long)]
    pub engine: Engine,
    /// Kind of points, or domain
    #[arg(long)]
    pub subject: Subject,
    /// How many points or segments
    #[arg(long)]
    pub size: usize,
    /// Seed of the first repeat; each further one takes the next
    #[arg(long)]
    pub seed: u64,
    /// How often, each time on new input
    #[arg(long)]
    pub repeats: usize,
    /// Checks the results and counts what they must have
    #[arg(long)]
    pub verify: bool,
}

/// What a job found.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Answer {
    /// One entry a repeat.
    pub runs: Vec<Run>,
    /// What the first repeat's result must have, if the job verifies and it is known.
    pub expected: Option<Expected>,
}

impl Job {
    /// Returns the command line that makes a child do this job.
    pub fn to_args(self) -> Vec<String> {
        let mut args = vec![SUBCOMMAND.to_owned()];
        let options = [
            ("--engine", self.engine.to_string()),
            ("--subject", self.subject.to_string()),
            ("--size", self.size.to_string()),
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
        let task = self.subject.task();
        let runs = (0..self.repeats as u64)
            .map(|i| self.engine.run(task, self.draw(i), self.verify))
            .collect::<Result<_, _>>()?;
        // Counted after the measurement, on input made anew: neither may weigh on it.
        let expected = self
            .verify
            .then(|| Expected::of(self.engine, self.subject, &self.draw(0)));
        Ok(Answer {
            runs,
            expected: expected.flatten(),
        })
    }

    fn draw(self, repeat: u64) -> Drawing {
        self.subject.make(self.size, self.seed.wrapping_add(repeat))
    }
}

#[cfg(test)]
mod tests {
    use super::{Job, SUBCOMMAND};
    use crate::engines::Engine;
    use crate::subject::Subject;
    use clap::Parser;
    use delone_samples::{Distribution, Domain};

    #[derive(clap::Parser)]
    struct CommandLine {
        #[command(flatten)]
        job: Job,
    }

    const JOB: Job = Job {
        engine: Engine::Spade,
        subject: Subject::Points(Distribution::Grid),
        size: 144,
        seed: 9,
        repeats: 3,
        verify: true,
    };

    #[test]
    fn command_line_carries_the_job() {
        let domain = Job {
            subject: Domain::Coast.into(),
            verify: false,
            ..JOB
        };
        for job in [JOB, domain] {
            let args = job.to_args();
            assert_eq!(args[0], SUBCOMMAND);
            assert_eq!(CommandLine::parse_from(args).job, job);
        }
    }

    #[test]
    fn repeats_are_measured_and_the_first_checked() {
        let answer = JOB.run().unwrap();
        assert_eq!(answer.runs.len(), 3);
        let expected = answer.expected.map(|expected| expected.triangles);
        assert_eq!(expected, Some(2 * 11 * 11));
        assert!(answer.runs.iter().all(|run| run.triangles == 2 * 11 * 11));
    }
}
