//! From a domain to its triangulation, the fast way for bare points, the other one for segments; or
//! to a refined mesh.

use crate::domain::{Crossings, Rule};
use crate::exit::Failure;
use crate::numbering::Numbering;
use crate::progress::Progress;
use crate::stopwatch::Stopwatch;
use crate::words::{counted, duration};
use delone::{
    ConstrainedDelaunay, ConstrainedTriangulation, Delaunay, DomainRule, Outcome, Pslg,
    RefinedMesh, Refinement, Triangulation,
};
use delone_io::DomainData;
use std::time::{Duration, Instant};

/// Options about segments and what lies between them.
#[derive(clap::Args, Clone)]
#[command(next_help_heading = "Domain")]
pub struct Building {
    /// What to do where segments cross in a point that is no vertex [default: error]
    #[arg(long, value_enum, value_name = "HOW")]
    crossings: Option<Crossings>,
    /// Which triangles to keep; holes of the input are never kept [default: carve for the segments
    /// of a .poly, evenodd for polygons of GeoJSON and WKT, otherwise hull]
    #[arg(long, value_enum, value_name = "RULE")]
    domain: Option<Rule>,
}

/// What has been built.
pub enum Built {
    /// Of bare points.
    Points(Triangulation),
    /// Of points and segments.
    Domain(Box<ConstrainedTriangulation>),
}

/// How long the phases took.
pub struct Laps {
    /// From the points to triangles and neighbours in the order of the input.
    pub triangulate: Duration,
    /// Inserting segments, crossings included.
    pub constrain: Duration,
    /// Finding domain, holes and regions.
    pub carve: Duration,
    /// Refining and smoothing, if that was asked for.
    pub refine: Option<[Duration; 2]>,
}

impl Laps {
    /// Says how long it took so many threads: `triangulated in 2.1 ms, refined in 41 ms (2 threads)`.
    pub fn in_words(&self, threads: usize) -> String {
        let build = duration(self.triangulate + self.constrain + self.carve);
        let threads = counted(threads, "thread", "threads");
        let refine = self
            .refine
            .map(|[refine, smooth]| duration(refine + smooth));
        let refine = refine.map(|took| format!(", refined in {took}"));
        format!(
            "triangulated in {build}{} ({threads})",
            refine.unwrap_or_default()
        )
    }
}

impl Building {
    /// Triangulates `domain`, whose points and segments go into the result; its attributes and
    /// markers stay.
    pub fn build(
        &self,
        domain: &mut DomainData,
        threads: usize,
        numbering: &Numbering,
        progress: &Progress,
    ) -> Result<(Built, Laps), Failure> {
        let start = Instant::now();
        let stopwatch = Stopwatch::new(progress);
        let built = if self.is_plain(domain) {
            let points = std::mem::take(&mut domain.vertices.points);
            let delaunay = Delaunay::new().threads(threads).watch(&stopwatch);
            delaunay.triangulate(points).map(Built::Points)
        } else {
            let builder = ConstrainedDelaunay::new()
                .crossings(self.crossings.unwrap_or_default().into())
                .domain(self.rule(domain))
                .threads(threads)
                .watch(&stopwatch);
            let built = builder.triangulate(domain.take_pslg());
            built.map(|domain| Built::Domain(domain.into()))
        };
        let built = built.map_err(|error| numbering.failure(error))?;
        let [constrain, carve, ..] = stopwatch.stop();
        let triangulate = start.elapsed().saturating_sub(constrain + carve);
        let laps = Laps {
            triangulate,
            constrain,
            carve,
            refine: None,
        };
        Ok((built, laps))
    }

    /// Triangulates `domain` as [`build`](Self::build) does, and refines it as `refinement` says.
    pub fn refine(
        &self,
        refinement: Refinement<'_>,
        domain: &mut DomainData,
        threads: usize,
        numbering: &Numbering,
        progress: &Progress,
    ) -> Result<(RefinedMesh, Laps), Failure> {
        let start = Instant::now();
        let stopwatch = Stopwatch::new(progress);
        let refinement = refinement
            .crossings(self.crossings.unwrap_or_default().into())
            .domain(self.rule(domain))
            .threads(threads)
            .watch(&stopwatch);
        let refined = refine(refinement, domain.take_pslg(), numbering)?;
        let [constrain, carve, refine, smooth] = stopwatch.stop();
        let others = constrain + carve + refine + smooth;
        let laps = Laps {
            triangulate: start.elapsed().saturating_sub(others),
            constrain,
            carve,
            refine: Some([refine, smooth]),
        };
        Ok((refined, laps))
    }

    /// Lists the options that the mesh does not show.
    pub(super) fn options(&self) -> Vec<String> {
        let is_split = matches!(self.crossings, Some(Crossings::Split));
        Vec::from_iter(is_split.then(|| "crossings=split".to_owned()))
    }

    /// Tells whether there are but points, and nothing else was asked for.
    pub(super) fn is_plain(&self, domain: &DomainData) -> bool {
        let bare = domain.segments.is_empty() && domain.holes.is_empty();
        bare && domain.regions.is_empty() && self.domain.is_none()
    }

    /// Returns which triangles are kept.
    pub(super) fn rule(&self, domain: &DomainData) -> DomainRule {
        self.domain.map_or(domain.usual_rule, Into::into)
    }
}

/// Refines a domain, if nobody cancels.
pub fn refine(
    refinement: Refinement<'_>,
    domain: Pslg,
    numbering: &Numbering,
) -> Result<RefinedMesh, Failure> {
    let refined = refinement.mesh(domain);
    let refined = refined.map_err(|error| numbering.failure(error))?;
    // A mesh that is half refined is valid, but nobody who cancels wants it.
    match refined.report.outcome {
        Outcome::Cancelled => Err(Failure::Cancelled),
        _ => Ok(refined),
    }
}

impl Built {
    /// Says in words what deserves one.
    pub fn notes(&self, numbering: &Numbering) -> Vec<String> {
        match self {
            Self::Points(_) => Vec::new(),
            Self::Domain(domain) => numbering.notes(domain),
        }
    }
}
