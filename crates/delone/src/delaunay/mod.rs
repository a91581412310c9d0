//! The canonical Delaunay triangulation of a point set, fast.

use crate::{Error, Point, Triangulation, Watch};

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

    /// Uses `threads` threads; the result is the same for any number.
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
    pub fn triangulate<P: Into<Point>>(
        self,
        points: impl IntoIterator<Item = P>,
    ) -> Result<Triangulation, Error> {
        let points: Vec<Point> = points.into_iter().map(Into::into).collect();
        let _ = (self.threads, self.watch, points);
        todo!()
    }
}
