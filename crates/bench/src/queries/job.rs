//! What one child process is asked, and what it answers.

use super::bounds::Bounds;
use super::edits::Edits;
use super::engine::Engine;
use super::input::{Input, Shape, values};
use super::question::{Question, Room};
use super::{kiddo, ours, rstar, spade, voronator, voronoice};
use crate::measure::Cost;
use crate::peer::Peer;
use crate::python::Files;
use crate::workshop::Errand;
use delone_samples::Distribution;
use serde::{Deserialize, Serialize};
use std::io;

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
    /// What it took to build, if that is timed apart.
    pub build: Option<Cost>,
    /// What all queries, cells or edits took.
    pub work: Cost,
    /// How many there were.
    pub number: usize,
    /// If the job checks, what the answers come to: how many points lie in the convex hull; the sum of all
    /// squared distances, of all values, of the areas of cells amid; or what the triangulation comes to
    /// after the edits.
    pub sum: Option<f64>,
}

impl Answer {
    /// Returns how long all took.
    pub fn seconds(&self) -> f64 {
        let build = self.build.as_ref().map_or(0.0, |build| build.seconds);
        build + self.work.seconds
    }

    /// Answers with cells that are not clipped.
    pub fn of_cells<P: AsRef<[[f64; 2]]>>(
        input: &Input,
        work: Cost,
        bounds: &Bounds,
        cells: impl Iterator<Item = P>,
    ) -> Self {
        Self {
            build: None,
            work,
            number: input.points.len(),
            sum: input.check.then(|| bounds.sum_amid(cells)),
        }
    }

    /// Answers with clipped cells.
    ///
    /// # Errors
    /// If that is checked, and they do not cover the bounds.
    pub fn of_clipped<P: AsRef<[[f64; 2]]>>(
        input: &Input,
        work: Cost,
        bounds: &Bounds,
        cells: impl Iterator<Item = P> + Clone,
    ) -> Result<Self, String> {
        if input.check {
            bounds.require_cover(cells.clone())?;
        }
        Ok(Self::of_cells(input, work, bounds, cells))
    }
}

impl Errand for Job {
    type Answer = Answer;

    fn to_args(&self) -> Vec<String> {
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

    fn to_words(&self, files: &Files) -> Option<io::Result<Vec<String>>> {
        self.engine.python_package()?;
        let words = |[points, asked, values]: [String; 3]| {
            let mode = if self.check { "check" } else { "time" };
            let question = self.question.to_string();
            let most = self.engine.most_queries(self.question).min(self.size);
            [
                question,
                points,
                asked,
                values,
                most.to_string(),
                mode.to_owned(),
            ]
            .to_vec()
        };
        Some(self.keep_input(files).map(words))
    }
}

impl Job {
    /// Does the job in this process.
    ///
    /// # Errors
    /// What the engine says, or that it cannot be asked this.
    pub fn run(self) -> Result<Answer, String> {
        let Self {
            engine, question, ..
        } = self;
        if !engine.knows(question) {
            return Err(format!("{engine} cannot be asked `{question}`"));
        }
        if question.room() == Room::Edits {
            return self.edit();
        }
        let input = self.input();
        match engine {
            Engine::Delone { threads } => ours::answer(&input, Some(threads)),
            Engine::Singly => ours::answer(&input, None),
            Engine::Spade => spade::answer(&input),
            Engine::Kiddo => kiddo::answer(&input),
            Engine::Rstar => Ok(rstar::answer(&input)),
            Engine::Voronoice => voronoice::answer(&input),
            Engine::Voronator => voronator::answer(&input),
            Engine::Scipy => Err(format!("{engine} is called from Python")),
        }
    }

    fn input(&self) -> Input {
        let mut asked = self.points(1);
        asked.truncate(self.engine.most_queries(self.question));
        Input {
            question: self.question,
            points: self.points(0),
            asked,
            check: self.check,
        }
    }

    fn points(&self, stream: u64) -> Vec<[f64; 2]> {
        let seed = self.seed.wrapping_add(stream);
        self.distribution.points(self.size, seed)
    }

    fn edit(self) -> Result<Answer, String> {
        let Self {
            question,
            distribution,
            size,
            seed,
            check,
            ..
        } = self;
        let edits = Edits::draw(question, distribution, size, seed)?;
        match self.engine {
            Engine::Spade => spade::edit(question, edits, check),
            _ => ours::edit(edits, check),
        }
    }

    /// Writes points, what is asked about, and values, each as its bits, unless they are there already.
    fn keep_input(&self, files: &Files) -> io::Result<[String; 3]> {
        let Self {
            distribution,
            size,
            seed,
            ..
        } = self;
        let name = |what: &str| format!("{distribution}-{size}-{seed}-{what}.f64");
        let shape = self.shape();
        let numbers = || values(&self.points(0), shape);
        Ok([
            files.keep(&name("points"), || bytes(self.points(0).as_flattened()))?,
            files.keep(&name("asked"), || bytes(self.points(1).as_flattened()))?,
            files.keep(&name(&format!("{shape:?}")), || bytes(&numbers()))?,
        ])
    }

    fn shape(&self) -> Shape {
        Shape::of(self.question, self.check)
    }
}

fn bytes(numbers: &[f64]) -> Vec<u8> {
    numbers.iter().flat_map(|x| x.to_le_bytes()).collect()
}

#[cfg(test)]
mod tests {
    use super::{Engine, Errand, Job, Question, Room, SUBCOMMAND};
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

    /// All say the same, but for rounding.
    #[test]
    fn engines_agree() {
        for question in Question::ALL {
            for distribution in [
                Distribution::Uniform,
                Distribution::Grid,
                Distribution::LonLat,
                Distribution::F32Duplicates,
            ] {
                // Of equal points we name one, others each.
                if (question, distribution) == (Question::TenNearest, Distribution::F32Duplicates) {
                    continue;
                }
                let ours = [Engine::Delone { threads: 1 }, Engine::Delone { threads: 2 }];
                let engines = ours
                    .into_iter()
                    .chain([Engine::Singly])
                    .chain(Engine::PEERS);
                let able = engines.filter(|e| e.knows(question) && *e != Engine::Scipy);
                // It panics where points coincide.
                let has_twins = distribution == Distribution::F32Duplicates;
                let able = able.filter(|e| *e != Engine::Voronoice || !has_twins);
                let job = |engine| Job {
                    engine,
                    question,
                    distribution,
                    ..JOB
                };
                let sums = able.map(|engine| (engine, job(engine).run().unwrap().sum.unwrap()));
                let sums: Vec<_> = sums.collect();
                assert!(sums.len() > 1 || question == Question::Undo);
                assert!(question.room() != Room::Edits || sums[0].1 > 0.0);
                for &(engine, sum) in &sums {
                    assert!(
                        (sum - sums[0].1).abs() <= 1e-11 * sums[0].1,
                        "{engine} {question} {distribution}: {sums:?}"
                    );
                }
            }
        }
    }
}
