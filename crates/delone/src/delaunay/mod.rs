//! The canonical Delaunay triangulation of a point set, fast.
//!
//! ```text
//! points ── input ──> extent, class ── order ──> curve order ── divide, knit ──> slots ── export ──> Triangulation
//! ```
//!
//! Divide and conquer after Guibas and Stolfi (1985) and Shewchuk (1996), along a space-filling
//! order. *Cost*: in practice linear, O(n²) at worst (cuts halve the plane, not the number of
//! points); 24 bytes a point beside input and result.
//!
//! Beside it lives [`Incremental`], which inserts single points; it yields the identical
//! triangulation.

mod bulk;
mod divide;
mod export;
mod gather;
mod group;
mod incremental;
mod input;
mod insertion;
mod knit;
mod leaf;
mod pair;
mod sheet;
mod signs;
mod vertices;
mod witness;

pub(crate) use bulk::{Curve, CurveParts, check_number};
pub(crate) use export::{duplicates, rename};
pub use incremental::{Incremental, Inserted};
pub(crate) use insertion::{Growing, insert};
pub(crate) use vertices::of_vertices;
pub(crate) use witness::{Deed, Witness};

use crate::{Error, Point, Triangulation, Watch, parallel};

/// Triangulates points with all defaults: every thread of the machine, unwatched.
///
/// # Errors
/// [`Error::NotFinite`] names the first point with a coordinate that is NaN or infinite;
/// [`Error::TooManyPoints`] if ids would not fit 32 bits.
pub fn triangulate<P: Into<Point>>(
    points: impl IntoIterator<Item = P>,
) -> Result<Triangulation, Error> {
    Delaunay::new().triangulate(points)
}

/// How to triangulate: threads, and who watches.
#[derive(Clone, Copy)]
pub struct Delaunay<'w> {
    threads: Option<usize>,
    watch: &'w dyn Watch,
}

impl Default for Delaunay<'_> {
    fn default() -> Self {
        Self::new()
    }
}

impl<'w> Delaunay<'w> {
    /// Uses every thread of the machine, unwatched.
    pub fn new() -> Self {
        Self {
            threads: None,
            watch: &(),
        }
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

    /// Triangulates `points`.
    ///
    /// # Errors
    /// [`Error::NotFinite`] names the first point with a coordinate that is NaN or infinite;
    /// [`Error::TooManyPoints`] if ids would not fit 32 bits; [`Error::Cancelled`] if the watch says
    /// so; [`Error::Threads`] if they cannot be started.
    pub fn triangulate<P: Into<Point>>(
        self,
        points: impl IntoIterator<Item = P>,
    ) -> Result<Triangulation, Error> {
        let points: Vec<Point> = points.into_iter().map(Into::into).collect();
        check_number(points.len())?;
        let watch = self.watch;
        parallel::with_workers(self.threads, |workers| {
            bulk::build(points, workers, watch, ())
        })?
    }
}

/// Triangulates on the current thread, before a witness.
pub(crate) fn triangulate_before(
    points: Vec<Point>,
    watch: &dyn Watch,
    witness: impl Witness,
) -> Result<Triangulation, Error> {
    check_number(points.len())?;
    bulk::build(points, parallel::Workers::ONE, watch, witness)
}
