//! Many points at once.

use super::{Cursor, Interpolant};
use crate::parallel::with_workers;
use crate::surface::raster::{Grid, Raster};
use crate::{Error, Phase, Point, Watch};
use std::sync::atomic::{AtomicU64, Ordering};

/// Points evaluated between two looks at the watch.
const STRIDE: usize = 1 << 10;

/// How to evaluate a surface at many points.
///
/// ```
/// use delone::surface::{Evaluation, Linear, Samples};
/// let t = delone::triangulate([(0.0, 0.0), (4.0, 0.0), (0.0, 4.0)])?;
/// let samples = Samples::new(&t, [1.0, 3.0, 5.0])?;
/// let points = [(1.0, 2.0), (9.0, 9.0), (0.0, 4.0)].map(Into::into);
/// let values = Evaluation::new().values(&Linear::new(&samples), &points)?;
/// assert_eq!(values, [Some(3.5), None, Some(5.0)]);
/// # Ok::<(), delone::Error>(())
/// ```
#[derive(Clone, Copy)]
pub struct Evaluation<'w> {
    threads: Option<usize>,
    watch: &'w dyn Watch,
}

impl Default for Evaluation<'_> {
    fn default() -> Self {
        Self::new()
    }
}

impl<'w> Evaluation<'w> {
    /// Uses every thread of the machine, unwatched.
    pub fn new() -> Self {
        Self {
            threads: None,
            watch: &(),
        }
    }

    /// Uses `threads` threads (0 means 1, and at most 1024); the result is the same for any number.
    pub fn threads(self, threads: usize) -> Self {
        let threads = Some(threads);
        Self { threads, ..self }
    }

    /// Reports progress to `watch`, which may cancel.
    pub fn watch(self, watch: &'w dyn Watch) -> Self {
        Self { watch, ..self }
    }

    /// Returns the value at each point; `None` outside.
    ///
    /// The points are visited along a space-filling curve, so that each is near the one before.
    ///
    /// # Errors
    /// [`Error::Cancelled`] if the watch says so; [`Error::Threads`] if they cannot be started.
    pub fn values(
        self,
        surface: &dyn Interpolant,
        points: &[Point],
    ) -> Result<Vec<Option<f64>>, Error> {
        let order = along_curve(points);
        let answer = |cursor: &mut Cursor, &i: &u32| {
            let value = surface.value_near(points[i as usize], cursor);
            (i, value)
        };
        let mut values = vec![None; points.len()];
        for (i, value) in self.each(&order, answer)?.into_iter().flatten() {
            values[i as usize] = value;
        }
        Ok(values)
    }

    /// Samples a surface at the centres of the cells of a grid.
    ///
    /// # Errors
    /// [`Error::Cancelled`] if the watch says so; [`Error::Threads`] if they cannot be started.
    pub fn raster(self, surface: &dyn Interpolant, grid: Grid) -> Result<Raster, Error> {
        let cells: Vec<usize> = (0..grid.columns() * grid.rows()).collect();
        let answer = |cursor: &mut Cursor, &cell: &usize| {
            let (row, along) = (cell / grid.columns(), cell % grid.columns());
            // There and back, row by row.
            let column = match row % 2 {
                0 => along,
                _ => grid.columns() - 1 - along,
            };
            let value = surface.value_near(grid.center(column, row), cursor);
            (row * grid.columns() + column, value)
        };
        let mut values = vec![f64::NAN; cells.len()];
        for (cell, value) in self.each(&cells, answer)?.into_iter().flatten() {
            values[cell] = value.unwrap_or(f64::NAN);
        }
        Ok(Raster::new(grid, values))
    }

    /// Answers all questions, each chunk with a cursor of its own.
    fn each<Q: Sync, A: Send>(
        self,
        questions: &[Q],
        answer: impl Fn(&mut Cursor, &Q) -> A + Sync,
    ) -> Result<Vec<Vec<A>>, Error> {
        let done = AtomicU64::new(0);
        let total = questions.len() as u64;
        let chunk = |questions: &[Q]| {
            let mut cursor = Cursor::default();
            let mut answers = Vec::with_capacity(questions.len());
            for stride in questions.chunks(STRIDE) {
                if self.watch.is_cancelled() {
                    return Err(Error::Cancelled);
                }
                answers.extend(stride.iter().map(|question| answer(&mut cursor, question)));
                let before = done.fetch_add(stride.len() as u64, Ordering::Relaxed);
                let done = before + stride.len() as u64;
                self.watch.progress(Phase::Interpolate, done, total);
            }
            Ok(answers)
        };
        with_workers(self.threads, |workers| {
            let length = workers.chunk_len(questions.len(), 8);
            let chunks = workers.map(questions.chunks(length).collect(), chunk);
            chunks.into_iter().collect()
        })?
    }
}

/// Returns the points' numbers in Morton order of a lattice of 2¹⁶ × 2¹⁶ cells over their box; those
/// that are not finite last.
fn along_curve(points: &[Point]) -> Vec<u32> {
    let finite = || points.iter().filter(|p| p.is_finite());
    let cell = |coordinate: fn(&Point) -> f64| {
        let (low, high) = finite()
            .map(coordinate)
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), c| {
                (low.min(c), high.max(c))
            });
        let half = high * 0.5 - low * 0.5;
        move |p: &Point| ((coordinate(p) * 0.5 - low * 0.5) / half * 65535.0) as u32 as u16
    };
    let (across, up) = (cell(|p| p.x), cell(|p| p.y));
    let key = |p: &Point| match p.is_finite() {
        true => u64::from(spread(across(p)) | spread(up(p)) << 1),
        false => u64::MAX,
    };
    let keys = points.iter().map(key);
    let mut order: Vec<(u64, u32)> = keys.zip(0..).collect();
    order.sort_unstable();
    order.into_iter().map(|(_, i)| i).collect()
}

/// Puts a zero before every bit.
fn spread(bits: u16) -> u32 {
    let mut x = u32::from(bits);
    for (shift, mask) in [
        (8, 0x00ff_00ff),
        (4, 0x0f0f_0f0f),
        (2, 0x3333_3333),
        (1, 0x5555_5555),
    ] {
        x = (x | x << shift) & mask;
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_curve_visits_every_point_and_goes_quarter_by_quarter() {
        let mut points: Vec<Point> = (0..64)
            .map(|i| Point::new(f64::from(i % 8), f64::from(i / 8)))
            .collect();
        points.push(Point::new(f64::NAN, 0.0));
        let order = along_curve(&points);
        assert_eq!(order[64], 64);
        for (quarter, indices) in order[..64].chunks(16).enumerate() {
            for &i in indices {
                let (right, above) = (i % 8 >= 4, i / 8 >= 4);
                assert_eq!(quarter, usize::from(right) + 2 * usize::from(above));
            }
        }
        let mut sorted = order;
        sorted.sort_unstable();
        assert!(sorted.into_iter().eq(0..65));
        assert!(along_curve(&[]).is_empty());
        assert_eq!(along_curve(&[Point::new(1e308, -1e308); 2]), [0, 1]);
    }
}
