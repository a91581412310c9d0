//! Many points at once.

use super::{Cursor, Grid, Interpolant, Raster};
use crate::parallel::with_workers;
use crate::{Error, Phase, Point, Watch};
use std::ops::Range;
use std::sync::atomic::{AtomicU64, Ordering};

/// Points evaluated between two looks at the watch.
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
        let order = along_curve(points);
        let answer = |cursor: &mut Cursor, strip: &&[u32]| -> Vec<Option<f64>> {
            let points = strip.iter().map(|&i| points[i as usize]);
            points.map(|p| surface.value_near(p, cursor)).collect()
        };
        let strips: Vec<&[u32]> = order.chunks(STRIP).collect();
        let answers = self.each(&strips, points.len(), answer)?;
        let mut values = vec![None; points.len()];
        for (&i, value) in order.iter().zip(answers.into_iter().flatten()) {
            values[i as usize] = value;
        }
        Ok(values)
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

    /// Answers strips of questions, `num_points` altogether, in chunks with a cursor each.
    fn each<S: Sync, A: Send>(
        self,
        strips: &[S],
        num_points: usize,
        answer: impl Fn(&mut Cursor, &S) -> A + Sync,
    ) -> Result<Vec<A>, Error> {
        let done = AtomicU64::new(0);
        let total = strips.len() as u64;
        let chunk = |strips: &[S]| {
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
            let points_per_chunk = workers.chunk_len(num_points, 8);
            let length = (points_per_chunk * strips.len()).div_ceil(num_points.max(1));
            let chunks = strips.chunks(length.max(1)).collect();
            let answers: Result<Vec<Vec<A>>, Error> =
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
