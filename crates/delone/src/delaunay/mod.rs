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

mod divide;
mod export;
mod frame;
mod group;
mod incremental;
mod input;
mod knit;
mod leaf;
mod memory;
mod order;
mod pair;
mod parallel;
mod sheet;
mod signs;

pub use incremental::{Incremental, Inserted};

use crate::{Error, Mesh, Phase, Point, Triangulation, Watch};
use divide::Divide;
use frame::Frame;
use input::{Class, Extent};
use order::{Ordered, Radix};
use parallel::Workers;
use sheet::Sheet;

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

    /// Uses `threads` threads (0 means 1); the result is the same for any number.
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
        parallel::with_workers(self.threads, |workers| build(points, workers, watch))?
    }
}

/// The largest number of points whose half-edges 32 bits can number, one of them reserved.
const MAX_POINTS: usize = (u32::MAX / 6) as usize;
const _: () = assert!(6 * MAX_POINTS < u32::MAX as usize);

fn check_number(given: usize) -> Result<(), Error> {
    let limit = MAX_POINTS;
    if given > limit {
        return Err(Error::TooManyPoints { given, limit });
    }
    Ok(())
}

fn build(points: Vec<Point>, workers: Workers, watch: &dyn Watch) -> Result<Triangulation, Error> {
    let chunk = workers.chunk_len(points.len(), 1);
    let extent = workers
        .map(points.chunks(chunk).collect(), Extent::of)
        .into_iter()
        .fold(Extent::EMPTY, Extent::union);
    if !extent.is_finite() {
        return Err(input::first_not_finite(&points).expect("bug: all points are finite"));
    }
    if points.is_empty() {
        return Ok(Triangulation::from_parts(
            points,
            Mesh::default(),
            0,
            Vec::new(),
        ));
    }
    match extent.class() {
        Class::Ordinary { scale } => conquer::<true>(points, extent, scale, workers, watch),
        Class::Wide => conquer::<false>(points, extent, 0, workers, watch),
    }
}

/// Triangulates at least one point; with `FILTERED` their coordinates, times 2^`scale`, are ordinary.
fn conquer<const FILTERED: bool>(
    points: Vec<Point>,
    extent: Extent,
    scale: i32,
    workers: Workers,
    watch: &dyn Watch,
) -> Result<Triangulation, Error> {
    let n = points.len();
    let radix = Radix::for_points(n);
    let frame = Frame::new(extent.min, extent.max, radix.bits);
    let Ordered {
        points: mut ordered,
        mut keys,
    } = order::order(&points, &frame, radix, scale, workers, watch).ok_or(Error::Cancelled)?;

    let mut corners = memory::reserve(2 * n);
    let mut twins = memory::reserve(2 * n);
    // SAFETY: the arrays live to the end of this function and are not touched while the sheet is.
    let sheet = unsafe {
        Sheet::new(
            &mut ordered,
            &mut keys,
            corners.spare_capacity_mut(),
            twins.spare_capacity_mut(),
        )
    };
    let divide = Divide::<FILTERED> {
        sheet,
        watch,
        workers,
        done: 0.into(),
        has_merged: false.into(),
    };
    let hull = divide.run(0, n, &frame).ok_or(Error::Cancelled)?;
    let merged = divide.has_merged.into_inner();
    let [triangles, ghosts] = export::compact(sheet, 2 * n - 2, hull.ghost(), merged);

    watch.progress(Phase::Export, 0, 1);
    // SAFETY: 2n slots are reserved, and every face that is left has been written.
    unsafe {
        corners.set_len(triangles + ghosts);
        twins.set_len(triangles + ghosts);
    }
    export::renumber(&mut corners, &keys, workers, watch).ok_or(Error::Cancelled)?;
    let duplicates = if merged {
        export::duplicates(&ordered[..n], &keys)
    } else {
        Vec::new()
    };
    watch.progress(Phase::Export, 1, 1);
    Ok(Triangulation::from_parts(
        points,
        Mesh::from_rows(corners, twins),
        triangles,
        duplicates,
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn more_points_than_ids_are_refused() {
        assert_eq!(check_number(MAX_POINTS), Ok(()));
        let (given, limit) = (MAX_POINTS + 1, MAX_POINTS);
        assert_eq!(
            check_number(given),
            Err(Error::TooManyPoints { given, limit })
        );
    }
}
