//! Delone at queries.

use super::job::Answer;
use super::question::{Question, TEN, square};
use crate::measure::under_the_clock;
use delone::locate::{Location, Locator};
use delone::nearest::Nearest;
use delone::{Delaunay, Error, Point, VertexId};

/// Asks about all points at once on so many threads, or about one after the other if `threads` is `None`.
///
/// # Errors
/// Those of the library.
pub fn answer(
    points: Vec<[f64; 2]>,
    asked: &[[f64; 2]],
    question: Question,
    threads: Option<usize>,
    check: bool,
) -> Result<Answer, String> {
    let asked: Vec<Point> = asked.iter().map(|&p| p.into()).collect();
    let job = Asked {
        points,
        asked,
        threads,
        check,
    };
    match question {
        Question::Locate => job.locate(),
        Question::Nearest => job.nearest(|nearest, asked, threads| match threads {
            Some(_) => nearest
                .nearest_all(asked, &())
                .map(|found| found.into_iter().map(lone).collect()),
            None => asked
                .iter()
                .map(|&p| nearest.nearest(p).map(lone))
                .collect(),
        }),
        Question::TenNearest => job.nearest(|nearest, asked, threads| match threads {
            Some(_) => nearest.k_nearest_all(asked, TEN, &()),
            None => asked.iter().map(|&p| nearest.k_nearest(p, TEN)).collect(),
        }),
    }
    .map_err(|error| error.to_string())
}

struct Asked {
    points: Vec<[f64; 2]>,
    asked: Vec<Point>,
    threads: Option<usize>,
    check: bool,
}

impl Asked {
    fn locate(self) -> Result<Answer, Error> {
        let Self {
            points,
            asked,
            threads,
            check,
        } = self;
        let (t, built) = under_the_clock(|| Delaunay::new().threads(1).triangulate(points));
        let t = t?;
        let (locator, mut build) =
            under_the_clock(|| Locator::new(&t).threads(threads.unwrap_or(1)));
        build.seconds += built.seconds;
        build.user += built.user;
        build.system += built.system;
        if let (Some(memory), Some(first)) = (&mut build.memory, built.memory) {
            memory.before = first.before;
            memory.peak = memory.peak.max(first.peak);
        }
        let (found, queries) = under_the_clock(|| match threads {
            Some(_) => locator.locate_all(&asked, &()),
            None => asked.iter().map(|&p| locator.locate(p)).collect(),
        });
        let found = found?;
        let is_inside = |&&location: &&Location| location.triangle(&t).is_some();
        let sum = check.then(|| found.iter().filter(is_inside).count() as f64);
        Ok(Answer {
            build,
            queries,
            sum,
        })
    }

    fn nearest<V: AsVertices>(
        self,
        ask: impl Fn(&Nearest, &[Point], Option<usize>) -> Result<Vec<V>, Error>,
    ) -> Result<Answer, Error> {
        let Self {
            points,
            asked,
            threads,
            check,
        } = self;
        let kept = check.then(|| points.clone());
        let (nearest, build) = under_the_clock(|| Nearest::of_points(points, &()));
        let nearest = nearest?.threads(threads.unwrap_or(1));
        let (found, queries) = under_the_clock(|| ask(&nearest, &asked, threads));
        let found = found?;
        let sum = kept.map(|points| {
            let pairs = asked.iter().zip(&found);
            let squares = pairs.flat_map(|(&p, found)| {
                let points = &points;
                found
                    .vertices()
                    .iter()
                    .map(move |v| square(p.into(), points[v.index()]))
            });
            squares.sum()
        });
        Ok(Answer {
            build,
            queries,
            sum,
        })
    }
}

/// One vertex, or several.
trait AsVertices {
    fn vertices(&self) -> &[VertexId];
}

impl AsVertices for Vec<VertexId> {
    fn vertices(&self) -> &[VertexId] {
        self
    }
}

impl AsVertices for [VertexId; 1] {
    fn vertices(&self) -> &[VertexId] {
        self
    }
}

fn lone(found: Option<VertexId>) -> [VertexId; 1] {
    [found.expect("there are points")]
}
