//! The ways to interpolate, by name.

use clap::ValueEnum;
use delone::surface::{
    CloughTocher, Estimate, Gradients, Interpolant, Linear, NaturalNeighbor, Samples,
    SmoothNaturalNeighbor, Weighing,
};
use delone::{Error, Watch};

/// How values between vertices come about.
#[derive(Clone, Copy, Debug, Default, ValueEnum)]
pub enum Method {
    /// flat triangles
    #[default]
    Linear,
    /// natural neighbours, weighed by areas (Sibson); smooth but for tips at the points
    Natural,
    /// natural neighbours, weighed by distances; continuous
    Laplace,
    /// natural neighbours and slopes (Sibson); smooth at the points too, may overshoot
    Smooth,
    /// cubics on triangles; smooth everywhere, may overshoot
    CloughTocher,
}

impl Method {
    /// Returns the name that the command line has for it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Linear => "linear",
            Self::Natural => "natural",
            Self::Laplace => "laplace",
            Self::Smooth => "smooth",
            Self::CloughTocher => "clough-tocher",
        }
    }

    /// Estimates the gradients at the vertices; zero where they do not matter.
    pub fn gradients(self, samples: &Samples<'_>, watch: &dyn Watch) -> Result<Gradients, Error> {
        match self {
            Self::Smooth | Self::CloughTocher => {
                Gradients::estimate(samples, Estimate::Quadratic, watch)
            }
            _ => Gradients::given(samples, vec![[0.0; 2]; samples.values().len()]),
        }
    }

    /// Makes the surface.
    pub fn surface<'a>(
        self,
        samples: &'a Samples<'a>,
        gradients: &'a Gradients,
    ) -> Result<Box<dyn Interpolant + 'a>, Error> {
        Ok(match self {
            Self::Linear => Box::new(Linear::new(samples)),
            Self::Natural => Box::new(NaturalNeighbor::new(samples, Weighing::Sibson)?),
            Self::Laplace => Box::new(NaturalNeighbor::new(samples, Weighing::Laplace)?),
            Self::Smooth => Box::new(SmoothNaturalNeighbor::new(samples, gradients)?),
            Self::CloughTocher => Box::new(CloughTocher::new(samples, gradients)?),
        })
    }
}
