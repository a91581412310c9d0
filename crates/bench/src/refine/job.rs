//! What one child process is asked to mesh, and what it answers.

use super::goal::{Goal, Outline};
use super::mesher::Mesher;
use super::quality::Quality;
use super::{ours, spade};
use crate::measure::Cost;
use crate::peer::Peer;
use crate::python::Files;
use crate::workshop::Errand;
use serde::{Deserialize, Serialize};
use serde_json::json;
use std::io;

/// The name of the subcommand that runs a job.
pub const SUBCOMMAND: &str = "mesh-job";

/// One mesher at one goal on one outline.
#[derive(Clone, Copy, Debug, PartialEq, clap::Args)]
pub struct Job {
    /// Who refines
    #[arg(long)]
    pub mesher: Mesher,
    /// What
    #[arg(long)]
    pub outline: Outline,
    /// Seed of the outline
    #[arg(long)]
    pub seed: u64,
    /// What is asked of the mesh
    #[command(flatten)]
    pub goal: Goal,
    /// Checks and measures the mesh
    #[arg(long)]
    pub check: bool,
}

/// What a job found.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Answer {
    /// What the mesh took.
    #[serde(flatten)]
    pub cost: Cost,
    /// What it is like, if the job checks.
    pub quality: Option<Quality>,
}

impl Errand for Job {
    type Answer = Answer;

    fn to_args(&self) -> Vec<String> {
        let options = [
            ("--mesher", Some(self.mesher.to_string())),
            ("--outline", Some(self.outline.to_string())),
            ("--seed", Some(self.seed.to_string())),
            ("--angle", Some(self.goal.angle.to_string())),
            ("--area", self.goal.area.map(|area| area.to_string())),
        ];
        let mut args = vec![SUBCOMMAND.to_owned()];
        for (option, value) in options {
            args.extend(value.into_iter().flat_map(|v| [option.to_owned(), v]));
        }
        args.extend(self.check.then(|| "--check".to_owned()));
        args
    }

    fn to_words(&self, files: &Files) -> Option<io::Result<Vec<String>>> {
        self.mesher.python_package()?;
        let words = |domain| {
            vec![
                self.mesher.to_string(),
                domain,
                self.goal.angle.to_string(),
                self.goal.area.unwrap_or(0.0).to_string(),
                if self.check { "check" } else { "time" }.to_owned(),
            ]
        };
        Some(self.keep_domain(files).map(words))
    }
}

impl Job {
    /// Writes the outline, unless it is there already. Shortest decimals read back as the same bits.
    fn keep_domain(&self, files: &Files) -> io::Result<String> {
        let Outline { domain, size } = self.outline;
        files.keep(&format!("{domain}-{size}-{}.json", self.seed), || {
            let drawing = self.outline.draw(self.seed);
            let domain = json!({
                "points": drawing.points,
                "segments": drawing.segments,
                "holes": drawing.holes,
            });
            domain.to_string().into_bytes()
        })
    }

    /// Does the job in this process.
    ///
    /// # Errors
    /// What the mesher says, or what is wrong with its mesh; or that it needs Python.
    pub fn run(self) -> Result<Answer, String> {
        let drawing = self.outline.draw(self.seed);
        match self.mesher {
            Mesher::Delone { threads } => ours::mesh(drawing, self.goal, threads, self.check),
            Mesher::Spade => spade::mesh(drawing, self.goal, self.check),
            other => Err(format!("{other} is called from Python")),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Errand, Goal, Job, Mesher, SUBCOMMAND};
    use clap::Parser;

    #[derive(clap::Parser)]
    struct CommandLine {
        #[command(flatten)]
        job: Job,
    }

    #[test]
    fn command_line_carries_the_job() {
        let job = Job {
            mesher: Mesher::Spade,
            outline: "gear:60".parse().unwrap(),
            seed: 7,
            goal: Goal {
                angle: 27.5,
                area: Some(1.55e-6),
            },
            check: true,
        };
        let plain = Job {
            mesher: Mesher::Delone { threads: 2 },
            goal: Goal {
                angle: 20.0,
                area: None,
            },
            check: false,
            ..job
        };
        for job in [job, plain] {
            let args = job.to_args();
            assert_eq!(args[0], SUBCOMMAND);
            assert_eq!(CommandLine::parse_from(args).job, job);
        }
        let foreign = Job {
            mesher: Mesher::Gmsh,
            ..job
        };
        assert!(foreign.run().unwrap_err().contains("Python"));
    }
}
