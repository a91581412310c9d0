//! Values of surfaces.

use super::Asked;
use crate::measure::{Cost, under_the_clock};
use crate::queries::job::Answer;
use delone::Error;
use delone::surface::{
    CloughTocher, Estimate, Evaluation, Gradients, Interpolant, Linear, NaturalNeighbor, Samples,
    Weighing,
};

impl Asked<'_> {
    pub(super) fn linear(self) -> Result<Answer, Error> {
        let (t, build) = self.triangulate(self.threads())?;
        let samples = Samples::new(&t, self.input.values())?;
        self.values(build, &Linear::new(&samples))
    }

    pub(super) fn natural(self) -> Result<Answer, Error> {
        let (t, built) = self.triangulate(self.threads())?;
        let samples = Samples::new(&t, self.input.values())?;
        let surface = || NaturalNeighbor::new(&samples, Weighing::Sibson);
        let (surface, build) = under_the_clock(surface);
        self.values(built.and_then(build), &surface?)
    }

    pub(super) fn clough_tocher(self) -> Result<Answer, Error> {
        let (t, built) = self.triangulate(self.threads())?;
        let samples = Samples::new(&t, self.input.values())?;
        let estimate = || Gradients::estimate(&samples, Estimate::LeastBending, &());
        let (gradients, build) = under_the_clock(estimate);
        let gradients = gradients?;
        let surface = CloughTocher::new(&samples, &gradients)?;
        self.values(built.and_then(build), &surface)
    }

    fn values(&self, build: Cost, surface: &dyn Interpolant) -> Result<Answer, Error> {
        let (values, work) = under_the_clock(|| match self.threads {
            Some(threads) => Evaluation::new()
                .threads(threads)
                .values(surface, &self.asked),
            None => Ok(self.asked.iter().map(|&p| surface.value(p)).collect()),
        });
        let values = values?.into_iter().map(|value| value.unwrap_or(0.0));
        Ok(self.done(build, work, self.input.sum(1, values)))
    }
}
