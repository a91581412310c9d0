//! From a domain to its triangulation: the fast way for bare points, the other one for segments.

use crate::domain::{Crossings, Rule};
use crate::exit::Failure;
use crate::numbering::Numbering;
use crate::progress::Progress;
use crate::stopwatch::Stopwatch;
use delone::{ConstrainedDelaunay, ConstrainedTriangulation, Delaunay, Triangulation};
use delone_io::DomainData;
use std::time::{Duration, Instant};

/// Options about segments and what lies between them.
#[derive(clap::Args)]
pub struct Building {
    /// What to do where segments cross in a point that is no vertex [default: error]
    #[arg(long, value_enum, value_name = "HOW")]
    crossings: Option<Crossings>,
    /// Which triangles to keep; holes of the input are never kept [default: carve for the segments
    /// of a .poly, evenodd for polygons of GeoJSON and WKT, otherwise hull]
    #[arg(long, value_enum, value_name = "RULE")]
    domain: Option<Rule>,
    /// Number of threads; by default as many as the machine runs at once
    #[arg(short, long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
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
}

impl Building {
    /// Returns the number of threads.
    pub fn threads(&self) -> usize {
        match self.threads {
            Some(n) => n.into(),
            None => std::thread::available_parallelism().map_or(1, usize::from),
        }
    }

    /// Triangulates `domain`, whose points and segments go into the result; its attributes and
    /// markers stay.
    pub fn build(
        &self,
        domain: &mut DomainData,
        numbering: &Numbering,
        progress: &Progress,
    ) -> Result<(Built, Laps), Failure> {
        let start = Instant::now();
        let stopwatch = Stopwatch::new(progress);
        let built = if self.is_plain(domain) {
            let points = std::mem::take(&mut domain.vertices.points);
            let delaunay = Delaunay::new().threads(self.threads()).watch(&stopwatch);
            delaunay.triangulate(points).map(Built::Points)
        } else {
            let builder = self.builder(domain).watch(&stopwatch);
            let built = builder.triangulate(domain.take_pslg());
            built.map(|domain| Built::Domain(domain.into()))
        };
        let built = built.map_err(|error| numbering.failure(error))?;
        let [constrain, carve] = stopwatch.stop();
        let triangulate = start.elapsed().saturating_sub(constrain + carve);
        let laps = Laps {
            triangulate,
            constrain,
            carve,
        };
        Ok((built, laps))
    }

    /// Tells whether there are but points, and nothing else was asked for.
    fn is_plain(&self, domain: &DomainData) -> bool {
        let bare = domain.segments.is_empty() && domain.holes.is_empty();
        bare && domain.regions.is_empty() && self.domain.is_none()
    }

    fn builder(&self, domain: &DomainData) -> ConstrainedDelaunay<'static> {
        let rule = self.domain.map_or(domain.usual_rule, Into::into);
        ConstrainedDelaunay::new()
            .crossings(self.crossings.unwrap_or_default().into())
            .domain(rule)
            .threads(self.threads())
    }
}

impl Built {
    /// Returns the triangles that are kept.
    pub fn triangulation(&self) -> &Triangulation {
        match self {
            Self::Points(triangulation) => triangulation,
            Self::Domain(domain) => domain.triangulation(),
        }
    }

    /// Says in words what deserves one.
    pub fn notes(&self, numbering: &Numbering) -> Vec<String> {
        match self {
            Self::Points(_) => Vec::new(),
            Self::Domain(domain) => {
                let warnings = domain.warnings().iter();
                warnings.map(|warning| numbering.note(warning)).collect()
            }
        }
    }
}
