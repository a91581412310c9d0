//! Clusters of points with weights, by splitting the worst one over and over.
//!
//! The first center is the weighted mean of all points. The cluster of largest error, the weighted mean of the
//! squares of the distances from its center, is cut in two by a plane through its center, normal to the axis of
//! largest weighted deviation; the means of both parts take the place of the center. Then each point goes to the
//! nearest center, and each center whose points have changed to their mean; and so on.
//!
//! *Source*: Schreiber (1991), as the thesis has it (Algorithm 3.23), in any dimension. As the deviation along an
//! axis the thesis prints Σ w (d − t), which is always 0; here it is Σ w (d − t)².
//!
//! *Numbers are rounded*: unlike a triangulation, clusters are a matter of measures. What is nearest is decided by
//! rounded squares of distances, ties by the lowest number; means are rounded, too. Still the result is
//! deterministic, multiplied with a power of two if the points are, and does not depend on what is left out to be
//! quick ([`partition`]).
//!
//! *Cost*: O(dim · n) to read; then for each split distances of the centers that moved last from all centers, and of
//! the points of these, and of those near them, from the centers around: in the plane about ten. 100,000 points make
//! 1,000 clusters in about a second in the plane, in three in space. In high dimensions hardly any center is far
//! enough to be left out: O(dim · n · k) a split.
//!
//! *Not done*: no optimum is looked for. [`Clustering::relax`] improves clusters further.

mod cell;
mod partition;
mod rows;
#[cfg(test)]
mod tests;

use crate::observe::Observer;
use crate::{Error, Point, Watch};
use partition::{Partition, Teller};
use rows::Rows;

/// How to find clusters.
///
/// ```
/// use delone::scattered::Clustering;
///
/// let line = [0.0, 1.0, 2.0, 10.0, 11.0, 30.0]; // six points of dimension one
/// let clusters = Clustering::new().clusters(3).run(&line, 1, None)?;
/// assert_eq!(clusters.assignment(), [0, 0, 0, 1, 1, 2]);
/// assert_eq!(clusters.centers(), [1.0, 10.5, 30.0]);
/// # Ok::<(), delone::Error>(())
/// ```
#[derive(Clone, Copy)]
pub struct Clustering<'w> {
    clusters: Option<usize>,
    max_error: f64,
    relax: usize,
    watch: &'w dyn Watch,
}

/// Clusters of points.
///
/// Each center is the mean of the points of its cluster. Those are the points to which it was nearest before it
/// last moved; so a few may now be nearer to another one, unless clusters were [relaxed](Clustering::relax) till
/// nothing moved.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Clusters {
    dim: usize,
    centers: Vec<f64>,
    assignment: Vec<u32>,
    clusters: Vec<Cluster>,
    history: Vec<Errors>,
}

/// What is known of a cluster besides its center.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Cluster {
    /// Number of its points. Rarely there are none, if all went to other centers.
    pub points: usize,
    /// The sum of their weights.
    pub weight: f64,
    /// The weighted mean of the squares of their distances from the center; 0 without points.
    pub error: f64,
}

/// How far points are from the centers, in squares of distances.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Errors {
    /// The largest error of a cluster.
    pub worst: f64,
    /// The weighted mean of all points.
    pub mean: f64,
}

impl Default for Clustering<'_> {
    fn default() -> Self {
        Self::new()
    }
}

impl<'w> Clustering<'w> {
    /// Splits until each cluster is a single point, or equal ones, unwatched.
    pub fn new() -> Self {
        Self {
            clusters: None,
            max_error: 0.0,
            relax: 0,
            watch: &(),
        }
    }

    /// Ends with at most so many clusters; with fewer if there are not as many different points.
    pub fn clusters(self, clusters: usize) -> Self {
        let clusters = Some(clusters);
        Self { clusters, ..self }
    }

    /// Ends once no cluster has an error above this: the weighted mean of the squares of the distances of its points
    /// from its center.
    pub fn max_error(self, max_error: f64) -> Self {
        Self { max_error, ..self }
    }

    /// After each split reassigns points and moves centers up to so many times more, which the original does not;
    /// less often if nothing changes.
    pub fn relax(self, rounds: usize) -> Self {
        let relax = rounds;
        Self { relax, ..self }
    }

    /// Reports progress to `watch`, which may cancel.
    pub fn watch(self, watch: &'w dyn Watch) -> Self {
        Self { watch, ..self }
    }

    /// Finds clusters of points of any dimension, given one after the other, `dim` coordinates each; without
    /// `weights` each weighs 1.
    ///
    /// # Errors
    /// [`Error::BadChoice`] for no clusters, an error that is negative or NaN, no dimension, and coordinates that are
    /// no whole number of points; [`Error::ValueNotFinite`] for coordinates;
    /// [`Error::ValuesMissing`] and [`Error::WeightNotPositive`] for weights; [`Error::TooManyPoints`] beyond 2³² − 1;
    /// [`Error::Cancelled`] if the watch says so.
    pub fn run(
        self,
        coordinates: &[f64],
        dim: usize,
        weights: Option<&[f64]>,
    ) -> Result<Clusters, Error> {
        match dim {
            1 => self.find::<_, 1>(coordinates, dim, weights, ()),
            2 => self.find::<_, 2>(coordinates, dim, weights, ()),
            3 => self.find::<_, 3>(coordinates, dim, weights, ()),
            _ => self.find::<_, 0>(coordinates, dim, weights, ()),
        }
    }

    /// Finds clusters of points of the plane, and tells `observer` how they are
    /// [split](crate::Event::ClusterSplit) and how their centers [move](crate::Event::ClusterMoved).
    ///
    /// # Errors
    /// As [`run`](Self::run).
    pub fn observe<O: Observer>(
        self,
        points: &[Point],
        weights: Option<&[f64]>,
        observer: O,
    ) -> Result<Clusters, Error> {
        let coordinates: Vec<f64> = points.iter().flat_map(|p| [p.x, p.y]).collect();
        self.find::<_, 2>(&coordinates, 2, weights, observer)
    }

    fn find<O: Observer, const D: usize>(
        self,
        coordinates: &[f64],
        dim: usize,
        weights: Option<&[f64]>,
        observer: O,
    ) -> Result<Clusters, Error> {
        self.check()?;
        let rows = Rows::<D>::new(coordinates, dim, weights)?;
        let most = self.clusters.unwrap_or(rows.len()).min(rows.len());
        if most == 0 {
            return Ok(Clusters::none(dim));
        }
        let teller = Teller {
            watch: self.watch,
            total: most as u64,
            observer,
            steps: 0,
        };
        let mut partition = Partition::new(&rows, teller);
        let mut history = vec![Errors::of(&partition, &rows)];
        while partition.cells.len() < most {
            let worst = partition.worst();
            let error = partition.cells[worst].error;
            // An error may vanish, or overflow, at the size at which points are given only.
            let is_enough = || self.max_error > 0.0 && rows.given_square(error) <= self.max_error;
            if error == 0.0 || is_enough() {
                break;
            }
            partition.split(worst)?;
            let mut rounds = 0..=self.relax;
            while rounds.next().is_some() && partition.relax()? {}
            history.push(Errors::of(&partition, &rows));
        }
        Ok(Clusters::of(&partition, &rows, history))
    }

    fn check(self) -> Result<(), Error> {
        if self.clusters == Some(0) {
            return Err(Error::BadChoice {
                what: "the number of clusters",
                given: 0.0,
                must: "it must be at least 1",
            });
        }
        if self.max_error.is_nan() || self.max_error < 0.0 {
            return Err(Error::BadChoice {
                what: "the largest error of a cluster",
                given: self.max_error,
                must: "it must not be negative",
            });
        }
        Ok(())
    }
}

impl Errors {
    fn of<O: Observer, const D: usize>(
        partition: &Partition<'_, O, D>,
        rows: &Rows<'_, D>,
    ) -> Self {
        let cells = &partition.cells;
        let weight: f64 = cells.iter().map(|cell| cell.weight).sum();
        let shares = cells.iter().map(|cell| cell.weight / weight * cell.error);
        Self {
            worst: rows.given_square(cells[partition.worst()].error),
            mean: rows.given_square(shares.sum()),
        }
    }
}

impl Clusters {
    fn none(dim: usize) -> Self {
        Self {
            dim,
            centers: Vec::new(),
            assignment: Vec::new(),
            clusters: Vec::new(),
            history: Vec::new(),
        }
    }

    fn of<O: Observer, const D: usize>(
        partition: &Partition<'_, O, D>,
        rows: &Rows<'_, D>,
        history: Vec<Errors>,
    ) -> Self {
        let mut assignment = vec![0; rows.len()];
        for (i, cell) in partition.cells.iter().enumerate() {
            for &point in &cell.members {
                assignment[point as usize] = i as u32;
            }
        }
        let cluster = |cell: &cell::Cell| Cluster {
            points: cell.members.len(),
            weight: rows.given_weight(cell.weight),
            error: rows.given_square(cell.error),
        };
        Self {
            dim: rows.dim(),
            centers: rows.given(partition.centers()),
            assignment,
            clusters: partition.cells.iter().map(cluster).collect(),
            history,
        }
    }

    /// Returns the number of clusters.
    pub fn len(&self) -> usize {
        self.clusters.len()
    }

    /// Tells whether there are none, for there were no points.
    pub fn is_empty(&self) -> bool {
        self.clusters.is_empty()
    }

    /// Returns the number of coordinates of a point.
    pub fn dim(&self) -> usize {
        self.dim
    }

    /// Returns the center of a cluster.
    pub fn center(&self, cluster: usize) -> &[f64] {
        &self.centers[cluster * self.dim..(cluster + 1) * self.dim]
    }

    /// Returns the centers, one after the other.
    pub fn centers(&self) -> &[f64] {
        &self.centers
    }

    /// Returns the cluster of each point.
    pub fn assignment(&self) -> &[u32] {
        &self.assignment
    }

    /// Returns what is known of each cluster; weights and errors beyond the range of numbers are infinite, or 0.
    pub fn clusters(&self) -> &[Cluster] {
        &self.clusters
    }

    /// Returns the errors that there were with one cluster, with two, and so on.
    pub fn history(&self) -> &[Errors] {
        &self.history
    }
}
