//! From data to a triangulation: Algorithms A, B and C, one after the other.

use super::data::Data;
use super::field::Field;
use super::{DataTriangulation, algorithm_a, algorithm_b, algorithm_c, result};
use crate::{Error, Observer, Point, Watch};

/// How to cover data with triangles that each hold at least d of them, and at most 3d − 1.
///
/// Every free choice of the chapter is one here, and its default is that of the chapter.
///
/// ```
/// use delone::scattered::Cover;
///
/// let lattice = (0..400).map(|i| (f64::from(i % 20), f64::from(i / 20)));
/// let cover = Cover::new(6).factor(1.05).cover(lattice)?;
/// assert!(cover.counts().into_iter().all(|n| n >= 6));
/// # Ok::<(), delone::Error>(())
/// ```
#[derive(Clone)]
pub struct Cover<'w> {
    pub(super) least: usize,
    pub(super) factor: f64,
    pub(super) domain: Option<Vec<Point>>,
    pub(super) misses: usize,
    pub(super) inner_points: bool,
    pub(super) divides_edges: bool,
    pub(super) bisections: u32,
    pub(super) divides_triangles: bool,
    pub(super) is_stepwise: bool,
    pub(super) optimizes: bool,
    pub(super) watch: &'w dyn Watch,
}

/// Covers data with triangles that hold at least `least` of them each, and at most 3 · `least` − 1; whatever holds
/// more is among the [exceptions](DataTriangulation::exceptions), with its cause.
///
/// ```
/// let data = (0..100).map(|i| (f64::from(i * 37 % 101), f64::from(i * 59 % 97)));
/// let cover = delone::scattered::cover(data, 5)?;
/// for (corners, count) in cover.triangles().iter().zip(cover.counts()) {
///     assert!((5..15).contains(&count), "{corners:?} holds {count}");
/// }
/// # Ok::<(), delone::Error>(())
/// ```
///
/// # Errors
/// As [`Cover::cover`].
///
/// *Cost*: O(l log l) in practice for l data.
pub fn cover<P: Into<Point>>(
    data: impl IntoIterator<Item = P>,
    least: usize,
) -> Result<DataTriangulation, Error> {
    Cover::new(least).cover(data)
}

impl<'w> Cover<'w> {
    /// At least `least` data in each triangle; all else as in the chapter.
    pub fn new(least: usize) -> Self {
        Self {
            least,
            factor: 1.1,
            domain: None,
            misses: 3,
            inner_points: true,
            divides_edges: true,
            bisections: 25,
            divides_triangles: true,
            is_stepwise: false,
            optimizes: true,
            watch: &(),
        }
    }

    /// Blows the convex hull of the data up by this factor, at least 1, to the outer polygon (3.27). The default is 1.1.
    pub fn factor(self, factor: f64) -> Self {
        Self { factor, ..self }
    }

    /// Covers this polygon, whose corners are listed one after the other, in place of the hull blown up; it need not
    /// be convex. Then its corners are never reduced, and if they are too many, there is an error.
    pub fn domain(self, corners: Vec<Point>) -> Self {
        let domain = Some(corners);
        Self { domain, ..self }
    }

    /// Lets Algorithm A give up after so many triangulations in a row that are no good. The default is 3.
    pub fn misses(self, misses: usize) -> Self {
        Self { misses, ..self }
    }

    /// Chooses whether Algorithm A adds centers of clusters to the outer polygon. By default it does.
    pub fn inner_points(self, inner_points: bool) -> Self {
        Self {
            inner_points,
            ..self
        }
    }

    /// Chooses whether Algorithm B runs. By default it does.
    pub fn divides_edges(self, divides_edges: bool) -> Self {
        Self {
            divides_edges,
            ..self
        }
    }

    /// Lets Algorithm B try fewer than so many places on a segment: N in 3.36, where the chapter names no number. The
    /// default is 25.
    pub fn bisections(self, bisections: u32) -> Self {
        Self { bisections, ..self }
    }

    /// Chooses whether Algorithm C runs. By default it does; without it triangles may hold any number of data.
    pub fn divides_triangles(self, divides_triangles: bool) -> Self {
        Self {
            divides_triangles,
            ..self
        }
    }

    /// Lets Algorithm C move its point step by step, exactly, as the text does (3.44): for study. By default it looks for
    /// a place that divides the data about evenly, which is faster and has more room around it.
    pub fn stepwise(self, is_stepwise: bool) -> Self {
        Self {
            is_stepwise,
            ..self
        }
    }

    /// Chooses whether edges are flipped for larger angles after each vertex of Algorithms B and C. By default they are.
    pub fn optimizes(self, optimizes: bool) -> Self {
        Self { optimizes, ..self }
    }

    /// Reports progress to `watch`, which may cancel.
    pub fn watch(self, watch: &'w dyn Watch) -> Self {
        Self { watch, ..self }
    }

    /// Covers data.
    ///
    /// # Errors
    /// [`Error::NotFinite`] names a datum that is not, [`Error::TooManyPoints`]; [`Error::TooFewData`],
    /// [`Error::CollinearData`] if no triangle can hold what it is to hold; [`Error::DatumOutside`],
    /// [`Error::DomainTooEmpty`], [`Error::BadDomain`] if the domain that was given is not good; [`Error::BadChoice`]
    /// names a number that makes no sense; [`Error::Cancelled`].
    pub fn cover<P: Into<Point>>(
        &self,
        data: impl IntoIterator<Item = P>,
    ) -> Result<DataTriangulation, Error> {
        self.observe(data, &mut ())
    }

    /// Covers data, and tells `observer` of each step: vertex i is datum i, and the vertices of triangles come after
    /// the data.
    ///
    /// # Errors
    /// As [`cover`](Self::cover).
    pub fn observe<P: Into<Point>>(
        &self,
        data: impl IntoIterator<Item = P>,
        observer: &mut impl Observer,
    ) -> Result<DataTriangulation, Error> {
        self.require()?;
        let data = Data::new(data)?;
        self.require_data(&data)?;
        let mut field = Field::new(
            &data,
            data.points.len() / (2 * self.least),
            self.watch,
            observer,
        );
        algorithm_a::run(&mut field, self)?;
        self.divide(&mut field)
    }

    /// Algorithms B and C on a triangulation whose triangles hold enough data already, as far as they are to run.
    ///
    /// # Errors
    /// As [`cover`](Self::cover); [`Error::DomainTooEmpty`] names a triangle that holds too few.
    pub fn refine(
        &self,
        given: &DataTriangulation,
        observer: &mut impl Observer,
    ) -> Result<DataTriangulation, Error> {
        self.on(given, observer, |field| self.divide(field))
    }

    /// Flips edges of a triangulation, anywhere, as long as that makes the smallest angle of two triangles larger and
    /// leaves at least d data in both: until it is locally optimal by the extended max-min-angle criterion (3.7).
    ///
    /// # Errors
    /// As [`refine`](Self::refine).
    ///
    /// *Ends*: each flip makes the triangulation more Delaunay, and there are finitely many.
    pub fn flip(
        &self,
        given: &DataTriangulation,
        observer: &mut impl Observer,
    ) -> Result<DataTriangulation, Error> {
        self.on(given, observer, |field| {
            field.optimize_all(self.least)?;
            let exceptions = algorithm_c::untried(field, self.least);
            Ok(result::hand_out(field, self.least, exceptions))
        })
    }

    /// Works on a triangulation that is there already.
    fn on<O: Observer>(
        &self,
        given: &DataTriangulation,
        observer: &mut O,
        work: impl FnOnce(&mut Field<O>) -> Result<DataTriangulation, Error>,
    ) -> Result<DataTriangulation, Error> {
        self.require()?;
        let data = Data::new(given.data.iter().copied())?;
        self.require_data(&data)?;
        let expected = data.points.len() / (2 * self.least);
        let mut field = Field::new(&data, expected, self.watch, observer);
        field.lay_out(given.points.clone(), &given.triangles)?;
        algorithm_a::require_filled(&mut field, self.least)?;
        work(&mut field)
    }

    fn divide(&self, field: &mut Field<impl Observer>) -> Result<DataTriangulation, Error> {
        if self.divides_edges {
            algorithm_b::run(field, self)?;
        }
        let exceptions = match self.divides_triangles {
            true => algorithm_c::run(field, self)?,
            false => algorithm_c::untried(field, self.least),
        };
        Ok(result::hand_out(field, self.least, exceptions))
    }

    fn require(&self) -> Result<(), Error> {
        let (what, given, must) = if self.least == 0 {
            (
                "the number of data that a triangle holds",
                0.0,
                "it must be at least 1",
            )
        } else if !(1.0..f64::INFINITY).contains(&self.factor) {
            (
                "the factor of the outer polygon",
                self.factor,
                "it must be at least 1, and finite",
            )
        } else {
            return Ok(());
        };
        Err(Error::BadChoice { what, given, must })
    }

    fn require_data(&self, data: &Data) -> Result<(), Error> {
        let (distinct, least) = (data.points.len(), self.least);
        if distinct < least {
            return Err(Error::TooFewData { distinct, least });
        }
        if data.are_collinear() {
            return Err(Error::CollinearData { distinct });
        }
        Ok(())
    }
}
