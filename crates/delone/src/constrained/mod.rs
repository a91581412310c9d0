//! The canonical constrained Delaunay triangulation of a domain.
//!
//! ```text
//! Pslg ── Curve ──> draft ── find, insert ──> segments in ── carve ──> domain ── export ──> result
//!                     └── two segments cross: refuse, or node all of them and begin again
//! ```
//!
//! The points are triangulated first; everything after that works in their numbering along the curve,
//! where neighbours in the plane are neighbours in memory, and with one half-edge at each vertex nothing
//! is ever searched for. Segments that are edges already are recognised (on all threads), for the
//! others the corridor is cleared and its two sides are triangulated anew. A triangulation in which every
//! edge is a segment or locally Delaunay, under the symbolic perturbation, is the only one (Lee and Lin,
//! *Generalized Delaunay triangulation for planar graphs*, 1986), so order and threads play no part.
//!
//! *Cost*: in practice a fifth to a half more than the Delaunay triangulation of the points, if segments
//! are short; two of those, and the noding, if segments cross.

mod build;
mod bulk;
mod carve;
mod corridor;
mod draft;
mod enrich;
mod export;
mod extend;
mod grow;
mod hole;
mod holes;
mod insert;
mod lengthen;
mod names;
mod polygons;
mod result;
mod seeds;
mod segments;
mod side;
mod witness;

pub(crate) use build::{Context, Faces, Prepared, prepare};
pub(crate) use corridor::Inserter;
pub(crate) use draft::{Ahead, Draft};
pub(crate) use enrich::{Additions, enrich};
pub(crate) use export::hand_out_draft;
pub(crate) use extend::{Steiner, extend};
pub(crate) use hole::refill;
pub(crate) use insert::Edge;
pub(crate) use lengthen::{Cuts, NO_SEGMENT};
pub use result::{ConstrainedTriangulation, Origin, Warning};
pub(crate) use witness::{Deed, Witness};

use crate::parallel::Workers;
use crate::{DomainRule, Error, Pslg, SegmentPolicy, Watch, parallel};
use build::prepare_before;

/// How to triangulate a domain.
#[derive(Clone, Copy)]
pub struct ConstrainedDelaunay<'w> {
    options: Options,
    threads: Option<usize>,
    watch: &'w dyn Watch,
}

/// What decides about the result.
#[derive(Clone, Copy, Default)]
pub(crate) struct Options {
    pub crossings: SegmentPolicy,
    pub domain: DomainRule,
}

impl Default for ConstrainedDelaunay<'_> {
    fn default() -> Self {
        Self::new()
    }
}

impl<'w> ConstrainedDelaunay<'w> {
    /// Refuses crossings, keeps the convex hull, uses every thread of the machine, unwatched.
    pub fn new() -> Self {
        Self {
            options: Options::default(),
            threads: None,
            watch: &(),
        }
    }

    /// Chooses what to do where segments cross.
    pub fn crossings(mut self, policy: SegmentPolicy) -> Self {
        self.options.crossings = policy;
        self
    }

    /// Chooses which triangles belong to the domain.
    pub fn domain(mut self, rule: DomainRule) -> Self {
        self.options.domain = rule;
        self
    }

    /// Uses `threads` threads (0 means 1, and at most 1024); the result is the same for any number.
    ///
    /// Without the feature `rayon` there is only the caller's thread.
    pub fn threads(self, threads: usize) -> Self {
        Self {
            threads: Some(threads),
            ..self
        }
    }

    /// Reports progress to `watch`, which may cancel.
    pub fn watch(self, watch: &'w dyn Watch) -> Self {
        Self { watch, ..self }
    }

    /// Triangulates a domain.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::SeedNotFinite`], [`Error::BadSegment`], [`Error::BadPolygon`] and
    /// [`Error::OpenPolygon`] name what is wrong with the input; [`Error::Crossing`] two segments that
    /// cross, unless they are to be split; [`Error::SeedOnSegment`] a hole or region whose seed does not
    /// say on which side it is. [`Error::TooManyPoints`] (crossings included) and
    /// [`Error::TooManySegments`] if ids would not fit 32 bits; [`Error::Cancelled`] if the watch says
    /// so; [`Error::Threads`] if they cannot be started.
    pub fn triangulate(self, pslg: Pslg) -> Result<ConstrainedTriangulation, Error> {
        let Self {
            options,
            threads,
            watch,
        } = self;
        parallel::with_workers(threads, |workers| {
            prepare(pslg, options, workers, watch)?.hand_out(workers, watch)
        })?
    }
}

/// Triangulates a domain on one thread before a witness, and refuses crossings.
///
/// # Errors
/// Those of [`ConstrainedDelaunay::triangulate`].
pub(crate) fn triangulate_before(
    pslg: Pslg,
    domain: DomainRule,
    watch: &dyn Watch,
    witness: impl Witness,
) -> Result<ConstrainedTriangulation, Error> {
    let options = Options {
        domain,
        crossings: SegmentPolicy::Error,
    };
    let prepared = prepare_before(pslg, options, Workers::ONE, watch, witness)?;
    prepared.hand_out(Workers::ONE, watch)
}
