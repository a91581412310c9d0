//! Where points lie, and what is near.

use super::Asked;
use crate::measure::under_the_clock;
use crate::queries::job::Answer;
use crate::queries::question::{TEN, square};
use delone::locate::{Location, Locator};
use delone::nearest::Nearest;
use delone::{Error, Point, VertexId};

impl Asked<'_> {
    pub(super) fn locate(self) -> Result<Answer, Error> {
        let (t, built) = self.triangulate(1)?;
        let (locator, build) = under_the_clock(|| Locator::new(&t).threads(self.threads()));
        let (found, work) = under_the_clock(|| match self.threads {
            Some(_) => locator.locate_all(&self.asked, &()),
            None => self.asked.iter().map(|&p| locator.locate(p)).collect(),
        });
        let found = found?;
        let is_inside = |location: &Location| f64::from(u8::from(location.triangle(&t).is_some()));
        let sum = self.input.sum(1, found.iter().map(is_inside));
        Ok(self.done(built.and_then(build), work, sum))
    }

    pub(super) fn nearest(self) -> Result<Answer, Error> {
        self.near(|nearest, asked, threads| match threads {
            Some(_) => nearest
                .nearest_all(asked, &())
                .map(|found| found.into_iter().map(lone).collect()),
            None => asked
                .iter()
                .map(|&p| nearest.nearest(p).map(lone))
                .collect(),
        })
    }

    pub(super) fn ten_nearest(self) -> Result<Answer, Error> {
        self.near(|nearest, asked, threads| match threads {
            Some(_) => nearest.k_nearest_all(asked, TEN, &()),
            None => asked.iter().map(|&p| nearest.k_nearest(p, TEN)).collect(),
        })
    }

    fn near<V: AsRef<[VertexId]>>(
        self,
        ask: impl Fn(&Nearest, &[Point], Option<usize>) -> Result<Vec<V>, Error>,
    ) -> Result<Answer, Error> {
        let points = self.input.points.clone();
        let (nearest, build) = under_the_clock(|| Nearest::of_points(points, &()));
        let nearest = nearest?.threads(self.threads());
        let (found, work) = under_the_clock(|| ask(&nearest, &self.asked, self.threads));
        let found = found?;
        let each = found.first().map_or(0, |found| found.as_ref().len());
        let points = &self.input.points;
        let pairs = self.input.asked.iter().zip(&found);
        let squares = pairs.flat_map(|(&p, found)| {
            let found = found.as_ref().iter();
            found.map(move |v| square(p, points[v.index()]))
        });
        let sum = self.input.sum(each, squares);
        Ok(self.done(build, work, sum))
    }
}

fn lone(found: Option<VertexId>) -> [VertexId; 1] {
    [found.expect("there are points")]
}
