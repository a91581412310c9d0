//! Many points at once.

use super::{Cursor, Grid, Interpolant, Raster};
use crate::locate::Spread;
use crate::parallel::with_workers;
use crate::{Error, Phase, Point, Watch};
use std::ops::Range;
use std::sync::atomic::{AtomicU64, Ordering};

/// Cells evaluated between two looks at the watch.
const STRIP: usize = 1 << 10;

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
        if !points.iter().any(Point::is_finite) {
            return Ok(vec![None; points.len()]);
        }
        let spread = Spread::around(points.iter().filter(|p| p.is_finite()));
        let answer = |cursor: &mut Cursor, p| surface.value_near(p, cursor);
        spread.answer(
            points,
            self.threads,
            (self.watch, Phase::Interpolate),
            Cursor::default,
            answer,
        )
    }

    /// Samples a surface at the centres of the cells of a grid.
    ///
    /// # Errors
    /// [`Error::Cancelled`] if the watch says so; [`Error::Threads`] if they cannot be started.
    pub fn raster(self, surface: &dyn Interpolant, grid: Grid) -> Result<Raster, Error> {
        let (columns, rows) = (grid.columns(), grid.rows());
        let strips = there_and_back(columns, rows);
        let answer = |cursor: &mut Cursor, strip: &Strip| -> Vec<f64> {
            let mut value = |column| {
                let value = surface.value_near(grid.center(column, strip.row), cursor);
                value.unwrap_or(f64::NAN)
            };
            if strip.is_back() {
                let mut values: Vec<f64> = strip.columns.clone().rev().map(value).collect();
                values.reverse();
                return values;
            }
            strip.columns.clone().map(&mut value).collect()
        };
        let answers = self.each(&strips, columns * rows, answer)?;
        let mut values = vec![f64::NAN; columns * rows];
        for (strip, answer) in strips.iter().zip(answers) {
            let start = strip.row * columns + strip.columns.start;
            values[start..start + answer.len()].copy_from_slice(&answer);
        }
        Ok(Raster::new(grid, values))
    }

    /// Answers strips of `num_cells` altogether, in chunks with a cursor each.
    fn each(
        self,
        strips: &[Strip],
        num_cells: usize,
        answer: impl Fn(&mut Cursor, &Strip) -> Vec<f64> + Sync,
    ) -> Result<Vec<Vec<f64>>, Error> {
        let done = AtomicU64::new(0);
        let total = strips.len() as u64;
        let chunk = |strips: &[Strip]| {
            let mut cursor = Cursor::default();
            let mut answers = Vec::with_capacity(strips.len());
            for strip in strips {
                if self.watch.is_cancelled() {
                    return Err(Error::Cancelled);
                }
                answers.push(answer(&mut cursor, strip));
                let done = done.fetch_add(1, Ordering::Relaxed) + 1;
                self.watch.progress(Phase::Interpolate, done, total);
            }
            Ok(answers)
        };
        with_workers(self.threads, |workers| {
            let cells_per_chunk = workers.chunk_len(num_cells, 8);
            let length = (cells_per_chunk * strips.len()).div_ceil(num_cells.max(1));
            let chunks = strips.chunks(length.max(1)).collect();
            let answers: Result<Vec<Vec<Vec<f64>>>, Error> =
                workers.map(chunks, chunk).into_iter().collect();
            Ok(answers?.into_iter().flatten().collect())
        })?
    }
}

/// Cells of one row that follow each other.
struct Strip {
    row: usize,
    columns: Range<usize>,
}

impl Strip {
    /// Tells whether it is walked from right to left.
    fn is_back(&self) -> bool {
        !self.row.is_multiple_of(2)
    }
}

/// Cuts rows into strips, in the order in which each begins beside the end of the one before.
fn there_and_back(columns: usize, rows: usize) -> Vec<Strip> {
    let mut strips = Vec::new();
    for row in 0..rows {
        let first = strips.len();
        strips.extend((0..columns).step_by(STRIP).map(|start| Strip {
            row,
            columns: start..columns.min(start + STRIP),
        }));
        if strips[first].is_back() {
            strips[first..].reverse();
        }
    }
    strips
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn strips_lead_there_and_back_over_every_cell() {
        let columns = 2 * STRIP + 5;
        let mut last: Option<(usize, usize)> = None;
        let strips = there_and_back(columns, 3);
        for strip in &strips {
            let (first, end) = match strip.is_back() {
                true => (strip.columns.end - 1, strip.columns.start),
                false => (strip.columns.start, strip.columns.end - 1),
            };
            if let Some((column, row)) = last {
                assert_eq!(first.abs_diff(column) + strip.row.abs_diff(row), 1);
            }
            last = Some((end, strip.row));
        }
        let cells: usize = strips.iter().map(|strip| strip.columns.len()).sum();
        assert_eq!(cells, 3 * columns);
    }
}
