//! Delone at queries: all at once on so many threads, or one after the other.

mod edits;
mod places;
mod surfaces;
mod voronoi;

pub use edits::edit;

use super::input::Input;
use super::job::Answer;
use super::question::Question;
use crate::measure::{Cost, under_the_clock};
use delone::{Delaunay, Error, Point, Triangulation};

/// Asks about all points at once on so many threads, or about one after the other if `threads` is `None`.
///
/// # Errors
/// Those of the library, and that edits are no queries.
pub fn answer(input: &Input, threads: Option<usize>) -> Result<Answer, String> {
    let asked: Vec<Point> = input.asked.iter().map(|&p| p.into()).collect();
    let job = Asked {
        input,
        asked,
        threads,
    };
    let answer = match input.question {
        Question::Locate => job.locate(),
        Question::Nearest => job.nearest(),
        Question::TenNearest => job.ten_nearest(),
        Question::Voronoi => return job.voronoi(),
        Question::Linear => job.linear(),
        Question::Natural => job.natural(),
        Question::CloughTocher => job.clough_tocher(),
        other => return Err(format!("`{other}` is no query")),
    };
    answer.map_err(|error| error.to_string())
}

struct Asked<'i> {
    input: &'i Input,
    asked: Vec<Point>,
    threads: Option<usize>,
}

impl Asked<'_> {
    fn threads(&self) -> usize {
        self.threads.unwrap_or(1)
    }

    fn triangulate(&self, threads: usize) -> Result<(Triangulation, Cost), Error> {
        let points = self.input.points.clone();
        let builder = Delaunay::new().threads(threads);
        let (t, cost) = under_the_clock(|| builder.triangulate(points));
        Ok((t?, cost))
    }

    fn done(&self, build: Cost, work: Cost, sum: Option<f64>) -> Answer {
        Answer {
            build: Some(build),
            work,
            number: self.asked.len(),
            sum,
        }
    }
}
