//! The beginnings of Algorithm A, each alone.

use super::centers::Centers;
use super::data::Data;
use super::outline::Outline;
use crate::{Error, Point};

/// Lays a polygon around data, strictly convex, counter-clockwise: their hull, blown up by `factor` about the mean of its
/// points, without corners that are not needed (3.27).
///
/// ```
/// let square = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0), (1.0, 2.0)];
/// let polygon = delone::scattered::outer_polygon(square, 1.5)?;
/// assert_eq!(polygon, [(5.0, 5.0), (-1.0, 5.0), (-1.0, -1.0), (5.0, -1.0)].map(Into::into));
/// # Ok::<(), delone::Error>(())
/// ```
///
/// # Errors
/// [`Error::NotFinite`], [`Error::TooManyPoints`]; [`Error::TooFewData`] if there are none; [`Error::BadChoice`] if the
/// factor is below 1 or not finite, or the data are too large.
///
/// *Cost*: O(l log l).
pub fn outer_polygon<P: Into<Point>>(
    data: impl IntoIterator<Item = P>,
    factor: f64,
) -> Result<Vec<Point>, Error> {
    let data = Data::new(data)?;
    Ok(Outline::around(&data.points, factor)?.points())
}

/// Finds so many centers of clusters, or fewer if there are fewer different data: the one that has most data falls in
/// two at the midpoint of the longer side of their box, and data go to the nearest (3.30).
///
/// [`Clustering`](super::Clustering) moves its centers, weighs, and knows more dimensions.
///
/// # Errors
/// [`Error::NotFinite`], [`Error::TooManyPoints`].
///
/// *Cost*: O(l log l) in practice.
pub fn cluster_centers<P: Into<Point>>(
    data: impl IntoIterator<Item = P>,
    number: usize,
) -> Result<Vec<Point>, Error> {
    let data = Data::new(data)?;
    let mut centers = Centers::new(&data.points);
    while centers.positions().len() < number && centers.split().is_some() {}
    Ok(centers.positions()[..number.min(centers.positions().len())].to_vec())
}
