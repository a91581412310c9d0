//! Polynomials fitted to the data of triangles: a first surface over a
//! [`DataTriangulation`].
//!
//! Each triangle has a polynomial of its own, which comes closest to the values of the data the triangle holds, by least
//! squares. Where they do not determine it well, those of neighbours help out, ring by ring; where that does not
//! do, the degree is lowered. All of that is reported.
//!
//! *When data determine a polynomial*: in Bernstein's basis no polynomial is larger in its triangle than the length of
//! its list of coefficients, and that is at most 1/σ times the length of the list of values, where σ is the least
//! singular value of the matrix of the basis at the data. So √m/σ for m data bounds by how much errors of values
//! are magnified, in corners without data too; σ never falls when data are added. Divided by what it is for infinitely
//! many data spread evenly, it is here called the *condition*. Davydov and Zeilfelder, *Scattered data fitting by
//! direct extension of local polynomials to bivariate splines* (2004), choose degrees by σ.
//!
//! *Exact*: which triangle a point lies in. Values are rounded; they depend on the triangulation, the values and
//! the point alone. *Cost*: O(T²) a datum and fit, T being the number of coefficients; a question in the same triangle
//! as the one before costs three signs and O(k³), any other a look into a tree besides.
//!
//! *Does not* join the polynomials: the surface jumps at edges, more where data are few. On an edge, it is that of the
//! triangle of lowest number. *Does not* weigh data by distance, nor go through their values.

mod around;
mod bernstein;
mod options;
mod place;
mod polynomial;
mod report;
mod scale;
mod singular;
mod solve;

pub use options::FitOptions;
pub use polynomial::Polynomial;
pub use report::{FitSummary, LocalFit};

use super::samples::{average, check_values};
use super::{Cursor, Interpolant, Jet};
use crate::parallel::{Workers, with_workers};
use crate::scattered::DataTriangulation;
use crate::{Error, Phase, Point, TriangleId, Watch};
use around::Around;
use place::{Places, has_within};
use scale::Scale;
use solve::{Solved, Task};
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

/// Triangles between two looks at the watch.
const RUN: usize = 128;

/// A polynomial for every triangle of a data triangulation.
///
/// Over triangles it is smooth, at edges it jumps. Outside of them there is none.
///
/// ```
/// use delone::scattered::DataTriangulation;
/// use delone::surface::{FitOptions, Interpolant, LocalFits};
/// use delone::{Point, TriangleId, VertexId};
/// let corners = [(0.0, 0.0), (9.0, 0.0), (0.0, 9.0)].map(Point::from).to_vec();
/// let data = [(1.0, 1.0), (4.0, 1.0), (7.0, 1.0), (1.0, 4.0), (1.0, 7.0), (4.0, 4.0)].map(Point::from).to_vec();
/// let triangle = [0, 1, 2].map(VertexId::new);
/// let values: Vec<f64> = data.iter().map(|p| p.x * p.y + 2.0).collect();
/// let t = DataTriangulation::from_parts(data, corners, vec![triangle], vec![TriangleId::new(0); 6], 6)?;
///
/// let surface = LocalFits::new(&t, values, FitOptions::degree(2), &())?;
/// let value = surface.value(Point::new(2.0, 5.0)).expect("inside");
/// assert!((value - 12.0).abs() < 1e-12);
/// assert_eq!(surface.value(Point::new(8.0, 5.0)), None);
/// assert_eq!(surface.summary().num_lowered(), 0);
/// # Ok::<(), delone::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct LocalFits<'t> {
    cover: &'t DataTriangulation,
    values: Vec<f64>,
    options: FitOptions,
    fits: Vec<LocalFit>,
    /// Of all triangles, one after the other.
    coefficients: Vec<f64>,
    /// Where those of each begin, and the end of the last.
    starts: Vec<usize>,
    places: Places,
}

impl<'t> LocalFits<'t> {
    /// Fits polynomials to one value for each datum.
    ///
    /// Runs on the threads of the surrounding pool (see [`on_threads`](crate::on_threads)).
    ///
    /// # Errors
    /// [`Error::ValuesMissing`] unless there is one for each; [`Error::ValueNotFinite`] names a datum whose value is NaN
    /// or infinite; [`Error::ValuesDiffer`] two equal data with different values ([`average_equal_data`] makes
    /// them agree); [`Error::BadChoice`] an option that makes no sense; [`Error::Cancelled`] if the watch says so.
    ///
    /// *Cost*: O(n T²) for n data and T coefficients, times the rings where data do not suffice.
    pub fn new(
        cover: &'t DataTriangulation,
        values: impl Into<Vec<f64>>,
        options: FitOptions,
        watch: &dyn Watch,
    ) -> Result<Self, Error> {
        options.check()?;
        let values = values.into();
        check_values(&values, cover.data().len(), cover.duplicates())?;
        let scale = Scale::of(&values);
        let scaled: Vec<f64> = values.iter().map(|&v| scale.there(v)).collect();
        let mut surface = Self {
            cover,
            values,
            options,
            fits: Vec::new(),
            coefficients: Vec::new(),
            starts: vec![0],
            places: Places::new(cover.points(), cover.triangles()),
        };
        let solved = with_workers(None, |workers| surface.solve(&scaled, workers, watch))??;
        for Solved { coefficients, fit } in solved.into_iter().flatten() {
            let back = coefficients.iter().map(|&c| scale.back(c));
            surface.coefficients.extend(back);
            surface.starts.push(surface.coefficients.len());
            let [rms, max] = [fit.rms, fit.max].map(|size| scale.size_back(size));
            surface.fits.push(LocalFit { rms, max, ..fit });
        }
        Ok(surface)
    }

    /// Solves for all triangles, run by run.
    fn solve(
        &self,
        values: &[f64],
        workers: Workers,
        watch: &dyn Watch,
    ) -> Result<Vec<Vec<Solved>>, Error> {
        let around = Around::new(self.cover);
        let total = self.cover.triangles().len();
        let done = AtomicU64::new(0);
        let run = |start: usize| {
            if watch.is_cancelled() {
                return Err(Error::Cancelled);
            }
            let run = start..total.min(start + RUN);
            let length = run.len() as u64;
            let solved = run.map(TriangleId::new).map(|t| {
                let task = Task {
                    corners: self.corners(t),
                    data: self.cover.data(),
                    values,
                    max_condition: self.options.max_condition,
                    max_rings: self.options.max_rings,
                };
                task.solve(&around.rings(t), self.options.degree)
            });
            let solved = solved.collect();
            let done = done.fetch_add(length, Relaxed) + length;
            watch.progress(Phase::Interpolate, done, total as u64);
            Ok(solved)
        };
        let starts = (0..total).step_by(RUN).collect();
        workers.map(starts, run).into_iter().collect()
    }

    /// Returns the triangulation.
    pub fn triangulation(&self) -> &'t DataTriangulation {
        self.cover
    }

    /// Returns the value of each datum.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// Returns what was asked for.
    pub fn options(&self) -> FitOptions {
        self.options
    }

    /// Tells of each triangle how its polynomial was found.
    pub fn fits(&self) -> &[LocalFit] {
        &self.fits
    }

    /// Returns the polynomial of a triangle.
    ///
    /// # Panics
    /// If there is no such triangle.
    pub fn polynomial(&self, t: TriangleId) -> Polynomial<'_> {
        let [start, end] = [0, 1].map(|k| self.starts[t.index() + k]);
        Polynomial {
            corners: self.corners(t),
            degree: self.fits[t.index()].degree,
            coefficients: &self.coefficients[start..end],
        }
    }

    /// Returns the triangle that a point lies in; of several, on an edge or a corner, the one of lowest number.
    /// `None` outside.
    ///
    /// *Cost*: O(log n), unless many triangles are long and thin.
    pub fn triangle_of(&self, p: Point) -> Option<TriangleId> {
        self.places.find(p, |t| self.corners(t))
    }

    /// Returns what is left of each value when the polynomial of the triangle that holds the datum is subtracted.
    pub fn residuals(&self) -> Vec<f64> {
        let data = self.cover.data().iter().zip(self.cover.holders());
        let residual =
            |((p, &t), v): ((&Point, &TriangleId), &f64)| v - self.polynomial(t).value(*p);
        data.zip(&self.values).map(residual).collect()
    }

    /// Sums up how all were found.
    ///
    /// *Cost*: O(n).
    pub fn summary(&self) -> FitSummary {
        let mut residuals = self.residuals();
        // The last first: what takes the place of one is behind all that are still to go.
        for duplicate in self.cover.duplicates().iter().rev() {
            residuals.swap_remove(duplicate.dropped.index());
        }
        FitSummary::of(&self.fits, self.options.degree, &residuals)
    }

    fn corners(&self, t: TriangleId) -> [Point; 3] {
        let points = self.cover.points();
        self.cover.triangles()[t.index()].map(|v| points[v.index()])
    }

    /// Finds the polynomial of a point, at first where the cursor is.
    fn at(&self, p: Point, cursor: &mut Cursor) -> Option<Polynomial<'_>> {
        let near = cursor.near;
        let stays = near.index() < self.fits.len() && has_within(self.corners(near), p);
        let t = if stays { near } else { self.triangle_of(p)? };
        cursor.near = t;
        Some(self.polynomial(t))
    }
}

impl Interpolant for LocalFits<'_> {
    fn value_near(&self, p: Point, cursor: &mut Cursor) -> Option<f64> {
        p.is_finite()
            .then(|| self.at(p, cursor))?
            .map(|polynomial| polynomial.value(p))
    }

    fn jet_near(&self, p: Point, cursor: &mut Cursor) -> Option<Jet> {
        p.is_finite()
            .then(|| self.at(p, cursor))?
            .map(|polynomial| polynomial.jet(p))
    }
}

/// Gives equal data the mean of their values, rounded.
///
/// # Errors
/// [`Error::ValuesMissing`] unless there is one value for each datum.
pub fn average_equal_data(cover: &DataTriangulation, values: &mut [f64]) -> Result<(), Error> {
    super::samples::require_count(values.len(), cover.data().len(), "values")?;
    average(cover.duplicates(), values);
    Ok(())
}
