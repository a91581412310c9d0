//! Options about how to refine, and how far.

use super::goals::{Goals, SAFE_ANGLE};
use crate::domain::Kept;
use crate::exit::Failure;
use crate::numbers::positive;
use crate::words::count;
use clap::ValueEnum;
use delone::{Budget, Encroachment, Locked, Refinement, Strategy};
use delone_io::DomainData;
use std::time::Duration;

/// How many vertices may be added if the angle asked for is known to end nowhere near.
const SAFE_VERTICES: usize = 5_000_000;

/// The options that may stop the work.
pub const LIMITS: &str = "--max-vertices or --max-time";

/// How to refine.
#[derive(clap::Args, Clone)]
#[command(next_help_heading = "Method")]
pub struct Method {
    /// Add no vertex on segments: on none, or on none with the domain on one side only
    #[arg(long, value_enum, value_name = "WHICH", num_args = 0..=1, require_equals = true,
          default_missing_value = "all")]
    keep_boundary: Option<Kept>,
    /// Make every triangle Delaunay, segments or not
    #[arg(long)]
    conforming: bool,
    /// Move free vertices to better places afterwards, in N passes
    #[arg(long, value_name = "N", default_value_t = 0, hide_default_value = true,
          allow_negative_numbers = true, value_parser = clap::value_parser!(u16).range(0..=1000))]
    smooth: u16,
    /// Algorithm that refines
    #[arg(long, value_enum, value_name = "NAME", default_value_t = Algorithm::Delaunay)]
    strategy: Algorithm,
}

/// Algorithms that refine.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Algorithm {
    /// ends for every input and angle
    Delaunay,
    /// as in the thesis that this program goes back to (Ulm, 2012); may give up
    Thesis,
}

impl Method {
    /// Requires that the algorithm knows what is asked for.
    pub fn require_sense(&self, goals: &Goals) -> Result<(), Failure> {
        let unknown = [
            ("--max-area", goals.max_area.is_some()),
            ("--area-per-region", goals.area_per_region),
            ("--sizing", goals.sizing.is_given()),
            ("--keep-boundary", self.keep_boundary.is_some()),
            ("--conforming", self.conforming),
            ("--smooth", self.smooth > 0),
        ];
        let given = unknown.iter().find(|(_, is_given)| *is_given);
        match given.filter(|_| self.strategy == Algorithm::Thesis) {
            Some((option, _)) => Err(Failure::Usage(format!(
                "--strategy thesis knows --min-angle and --max-edge, but not {option}; leave out one of them"
            ))),
            None => Ok(()),
        }
    }

    /// Returns the word for the segments that have to stay, if some have.
    pub fn kept(&self) -> Option<&'static str> {
        self.keep_boundary.map(|kept| match kept {
            Kept::Outer => "outer",
            Kept::All => "all",
        })
    }

    /// Tells whether every triangle is to be Delaunay.
    pub fn is_conforming(&self) -> bool {
        self.conforming
    }

    /// Lists the choices that a mesh does not show.
    pub fn options(&self) -> Vec<String> {
        let smooth = (self.smooth > 0).then(|| format!("smooth={}", self.smooth));
        let is_thesis = self.strategy == Algorithm::Thesis;
        let strategy = is_thesis.then(|| "strategy=thesis".to_owned());
        smooth.into_iter().chain(strategy).collect()
    }

    /// Passes the choices on.
    pub fn apply<'a>(&self, refinement: Refinement<'a>) -> Refinement<'a> {
        refinement
            .locked(self.keep_boundary.map_or(Locked::Nothing, Into::into))
            .encroachment(if self.conforming {
                Encroachment::Circle
            } else {
                Encroachment::Lens
            })
            .smoothing(self.smooth.into())
            .strategy(match self.strategy {
                Algorithm::Delaunay => Strategy::Delaunay,
                Algorithm::Thesis => Strategy::Thesis,
            })
    }
}

/// How far to go.
#[derive(clap::Args, Clone)]
#[command(next_help_heading = "Limits")]
pub struct Limits {
    /// Stop at so many vertices, those of the input included [default: none up to 33 degrees, above
    /// that five millions more than the input]
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    max_vertices: Option<usize>,
    /// Stop refining after so many seconds; the mesh then depends on the machine
    #[arg(long, value_name = "SECONDS", value_parser = positive, allow_negative_numbers = true)]
    max_time: Option<f64>,
}

impl Limits {
    /// Lists the limits that were asked for.
    pub fn options(&self) -> Vec<String> {
        let vertices = self.max_vertices.map(|n| format!("max_vertices={n}"));
        let time = self.max_time.map(|seconds| format!("max_time={seconds}"));
        vertices.into_iter().chain(time).collect()
    }

    /// Returns the limits for a domain.
    pub fn budget(&self, goals: &Goals, domain: &DomainData) -> Budget {
        Budget {
            vertices: self.max_vertices.or(self.protection(goals, domain)),
            time: self
                .max_time
                .and_then(|seconds| Duration::try_from_secs_f64(seconds).ok()),
        }
    }

    /// Warns where no theory and no experience says that the mesh stays small.
    pub fn note(&self, goals: &Goals, domain: &DomainData) -> Option<String> {
        let vertices = self.protection(goals, domain)?;
        Some(format!(
            "above {SAFE_ANGLE}° a mesh may grow until coordinates have no room for more: it stops at \
             {} vertices, unless --max-vertices says otherwise",
            count(vertices)
        ))
    }

    /// Returns the largest number of vertices if nobody has named one and the angle asks for it.
    fn protection(&self, goals: &Goals, domain: &DomainData) -> Option<usize> {
        let is_bold = goals.min_angle > SAFE_ANGLE && self.max_vertices.is_none();
        is_bold.then(|| domain.vertices.points.len() + SAFE_VERTICES)
    }
}
