//! Values at the vertices of a triangulation.

use super::Ground;
use crate::{Duplicate, Error, Triangulation, VertexId};

/// A value at every vertex: what all surfaces interpolate.
#[derive(Clone, Debug)]
pub struct Samples<'t> {
    ground: Ground<'t>,
    values: Vec<f64>,
}

impl<'t> Samples<'t> {
    /// Takes one value for each point, those included that were merged, carved away or added.
    ///
    /// # Errors
    /// [`Error::ValuesMissing`] unless there is one for each; [`Error::ValueNotFinite`] names a point
    /// whose value is NaN or infinite; [`Error::ValuesDiffer`] two equal points with different values
    /// ([`average_duplicates`] makes them agree).
    pub fn new(ground: impl Into<Ground<'t>>, values: impl Into<Vec<f64>>) -> Result<Self, Error> {
        let (ground, values) = (ground.into(), values.into());
        let triangulation = ground.triangulation();
        let expected = triangulation.points().len();
        check_values(&values, expected, triangulation.duplicates())?;
        Ok(Self { ground, values })
    }

    /// Returns what the surface lies over.
    pub fn ground(&self) -> Ground<'t> {
        self.ground
    }

    /// Returns the value of each point.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// Returns the value at a vertex.
    ///
    /// # Panics
    /// If there is no such vertex.
    #[inline]
    pub fn value(&self, v: VertexId) -> f64 {
        self.values[v.index()]
    }

    /// Returns the least and the largest value at the corners of triangles; `None` without triangles.
    ///
    /// *Cost*: O(n).
    pub fn range(&self) -> Option<[f64; 2]> {
        let corners = self.ground.triangulation().triangles().as_flattened();
        let values = corners.iter().map(|&v| [self.value(v); 2]);
        values.reduce(|[low, high], [value, _]| [low.min(value), high.max(value)])
    }
}

/// Fails unless there is a finite value for each of so many points, and the same for equal ones.
pub(super) fn check_values(
    values: &[f64],
    expected: usize,
    duplicates: &[Duplicate],
) -> Result<(), Error> {
    require_count(values.len(), expected, "values")?;
    if let Some(i) = values.iter().position(|value| !value.is_finite()) {
        return Err(Error::ValueNotFinite {
            vertex: VertexId::new(i),
            given: values[i],
            what: "value",
        });
    }
    for duplicate in duplicates {
        let vertices = [duplicate.kept, duplicate.dropped];
        let [kept, dropped] = vertices.map(|v| values[v.index()]);
        if kept != dropped {
            let values = [kept, dropped];
            return Err(Error::ValuesDiffer { vertices, values });
        }
    }
    Ok(())
}

/// Fails unless there is one of `what` for each point.
pub(super) fn require_number(
    given: usize,
    triangulation: &Triangulation,
    what: &'static str,
) -> Result<(), Error> {
    require_count(given, triangulation.points().len(), what)
}

/// Fails unless there are as many of `what` as expected.
pub(super) fn require_count(
    given: usize,
    expected: usize,
    what: &'static str,
) -> Result<(), Error> {
    if given == expected {
        return Ok(());
    }
    Err(Error::ValuesMissing {
        given,
        expected,
        what,
    })
}

/// Gives equal points, of which only one has become a vertex, the mean of their values, rounded.
///
/// # Errors
/// [`Error::ValuesMissing`] unless there is one value for each point.
///
/// ```
/// let t = delone::triangulate([(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 0.0)])?;
/// let mut values = [5.0, 6.0, 7.0, 8.0];
/// delone::surface::average_duplicates(&t, &mut values)?;
/// assert_eq!(values, [5.0, 7.0, 7.0, 7.0]);
/// # Ok::<(), delone::Error>(())
/// ```
pub fn average_duplicates(triangulation: &Triangulation, values: &mut [f64]) -> Result<(), Error> {
    require_number(values.len(), triangulation, "values")?;
    average(triangulation.duplicates(), values);
    Ok(())
}

/// Gives equal points the mean of their values.
pub(super) fn average(duplicates: &[Duplicate], values: &mut [f64]) {
    let mut groups: Vec<_> = duplicates.iter().map(|d| [d.kept, d.dropped]).collect();
    groups.sort_unstable();
    for group in groups.chunk_by(|a, b| a[0] == b[0]) {
        let count = (group.len() + 1) as f64;
        let kept = group[0][0].index();
        // Divided first, so that the sum cannot overflow.
        let others = group.iter().map(|[_, v]| values[v.index()] / count);
        let mean = others.fold(values[kept] / count, |sum, share| sum + share);
        values[kept] = mean;
        group.iter().for_each(|[_, v]| values[v.index()] = mean);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const POINTS: [(f64, f64); 4] = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 0.0)];

    #[test]
    fn what_makes_no_sense_is_refused() {
        let t = crate::triangulate(POINTS).expect("a triangle");
        let error = |values: &[f64]| Samples::new(&t, values).expect_err("refused");
        let what = "values";
        let (given, expected) = (3, 4);
        assert_eq!(
            error(&[1.0; 3]),
            Error::ValuesMissing {
                given,
                expected,
                what
            }
        );
        let nan = error(&[1.0, 2.0, f64::NAN, 2.0]);
        assert!(nan.to_string().contains("point 2 is NaN"), "{nan}");
        let vertices = [1, 3].map(VertexId::new);
        let values = [2.0, 4.0];
        assert_eq!(
            error(&[1.0, 2.0, 3.0, 4.0]),
            Error::ValuesDiffer { vertices, values }
        );
        assert!(Samples::new(&t, [1.0, 2.0, 3.0, 2.0]).is_ok());
    }

    #[test]
    fn the_range_is_that_of_triangles() {
        let t = crate::triangulate(POINTS).expect("a triangle");
        let samples = Samples::new(&t, [1.0, 2.0, -3.0, 2.0]).expect("values");
        assert_eq!(samples.range(), Some([-3.0, 2.0]));
        let row = crate::triangulate([(0.0, 0.0), (1.0, 1.0)]).expect("a row");
        let samples = Samples::new(&row, [1.0, 2.0]).expect("values");
        assert_eq!(samples.range(), None);
    }
}
