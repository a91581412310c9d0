//! One algorithm on so many points: counted once, timed a few times.

use crate::progress::Progress;
use delone::classic::{Algorithm, Input};
use delone::{Error, Point, Tally, Watch};
use serde::Serialize;
use std::time::{Duration, Instant};

/// Most runs that are timed.
const RUNS: usize = 5;

/// What a lap has come to.
#[derive(Serialize)]
pub struct Lap {
    pub algorithm: &'static str,
    pub points: usize,
    pub orientation_tests: u64,
    pub circle_tests: u64,
    pub predicates: u64,
    pub flips: u64,
    pub walk_steps: u64,
    pub edges_deleted: u64,
    pub steps: u64,
    pub seconds: f64,
    pub runs: usize,
    pub hash: String,
}

impl Lap {
    /// Tells whether it claims the Delaunay triangulation.
    pub fn is_delaunay(&self) -> bool {
        let algorithm = Algorithm::named(self.algorithm);
        algorithm.is_some_and(|algorithm| algorithm.about().is_delaunay)
    }
}

/// An algorithm on more and more points.
pub struct Track {
    algorithm: Algorithm,
    seed: u64,
    budget: Duration,
    /// It has had enough: larger sizes would take too long.
    is_out: bool,
}

impl Track {
    pub fn new(algorithm: Algorithm, seed: u64, budget: Duration) -> Self {
        Self {
            algorithm,
            seed,
            budget,
            is_out: false,
        }
    }

    /// Runs on these points; `None`: that would take, or has taken, too long.
    pub fn run(&mut self, points: &[Point], progress: &Progress) -> Result<Option<Lap>, Error> {
        if self.is_out {
            return Ok(None);
        }
        let limit = Limit {
            progress,
            until: Instant::now() + self.budget,
        };
        let mut input = Input::from_points(points.iter().copied());
        input.seed = self.seed;
        input.watch = &limit;
        match self.laps(&input) {
            Err(Error::Cancelled) if !progress.is_cancelled() => {
                self.is_out = true;
                Ok(None)
            }
            other => other.map(Some),
        }
    }

    fn laps(&self, input: &Input) -> Result<Lap, Error> {
        let mut times = Vec::new();
        let begin = Instant::now();
        let mut hash = None;
        while times.is_empty() || times.len() < RUNS && begin.elapsed() < self.budget / 4 {
            let start = Instant::now();
            let output = self.algorithm.run(input)?;
            times.push(start.elapsed());
            hash.get_or_insert_with(|| output.hash());
        }
        let mut tally = Tally::default();
        self.algorithm.observe(input, &mut tally)?;
        times.sort();
        Ok(Lap {
            algorithm: self.algorithm.about().name,
            points: input.pslg.points.len(),
            orientation_tests: tally.orientation_tests,
            circle_tests: tally.circle_tests,
            predicates: tally.predicates(),
            flips: tally.flips,
            walk_steps: tally.walk_steps,
            edges_deleted: tally.edges_deleted,
            steps: tally.steps,
            seconds: times[times.len() / 2].as_secs_f64(),
            runs: times.len(),
            hash: hash.unwrap_or_default().to_string(),
        })
    }
}

/// Ends a run when its time is over, or somebody cancels all.
struct Limit<'p> {
    progress: &'p Progress,
    until: Instant,
}

impl Watch for Limit<'_> {
    fn is_cancelled(&self) -> bool {
        self.progress.is_cancelled() || Instant::now() > self.until
    }
}
