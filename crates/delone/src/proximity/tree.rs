//! The Euclidean minimum spanning tree, and the clusters that are left when its long edges go.
//!
//! The tree lies in the Delaunay triangulation, however ties are broken: an edge of it has no other point
//! in or on the circle of which it is a diameter (Shamos and Hoey 1975). Kruskal's algorithm on the
//! sorted edges (Kruskal, *On the shortest spanning subtree of a graph*, 1956).

use super::Proximity;
use super::forest::Forest;
use crate::predicates::length_up;
use crate::{Error, HalfEdgeId, Triangulation, VertexId};

/// The Euclidean minimum spanning tree of the vertices.
///
/// Of several the one whose edges come first in the order of (length, lower end, higher end).
#[derive(Clone, Debug)]
pub struct SpanningTree<'p> {
    triangulation: &'p Triangulation,
    edges: Vec<[VertexId; 2]>,
    half_edges: Vec<HalfEdgeId>,
    lengths: Vec<f64>,
}

/// Points in groups.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Clusters {
    /// The group of each point, duplicates included. Groups are numbered as their lowest points come.
    pub of: Vec<usize>,
    /// How many groups there are.
    pub count: usize,
}

impl Proximity<'_> {
    /// Finds the minimum spanning tree.
    ///
    /// # Errors
    /// [`Error::Cancelled`].
    ///
    /// *Cost*: O(n log n), for sorting.
    pub fn spanning_tree(&self) -> Result<SpanningTree<'_>, Error> {
        let half_edges = self.tree_of(&self.sorted_edges()?)?;
        Ok(SpanningTree {
            triangulation: &self.triangulation,
            edges: half_edges.iter().map(|&h| self.undirected(h)).collect(),
            lengths: half_edges
                .iter()
                .map(|&h| length_up(self.end_points(h)))
                .collect(),
            half_edges,
        })
    }

    /// Takes from all edges, shortest first, those of the minimum spanning tree.
    pub(super) fn tree_of(&self, sorted: &[HalfEdgeId]) -> Result<Vec<HalfEdgeId>, Error> {
        let mut forest = Forest::new(self.triangulation.points().len());
        let mut pace = self.pace();
        let mut tree = Vec::with_capacity(self.triangulation.num_vertices());
        for &h in sorted {
            pace.step()?;
            let [a, b] = self.ends(h);
            if forest.join(a.index(), b.index()) {
                tree.push(h);
            }
        }
        pace.finish();
        Ok(tree)
    }
}

impl SpanningTree<'_> {
    /// Returns the edges, shortest first, equal ones by their ends; lower end first. One less than there
    /// are vertices.
    ///
    /// Read in this order they are the dendrogram of single linkage: each joins two clusters.
    pub fn edges(&self) -> &[[VertexId; 2]] {
        &self.edges
    }

    /// Returns the lengths of the [edges](Self::edges), [rounded up](length_up).
    pub fn lengths(&self) -> &[f64] {
        &self.lengths
    }

    /// Returns the sum of all lengths, rounded.
    pub fn length(&self) -> f64 {
        self.lengths.iter().fold(0.0, |sum, length| sum + length)
    }

    /// The edges as half-edges of the triangulation.
    pub(super) fn half_edges(&self) -> &[HalfEdgeId] {
        &self.half_edges
    }

    /// Groups points that are joined by steps of at most `distance`, which is single linkage.
    ///
    /// Exact: a step of that length counts. Duplicates are in the group of their vertex.
    ///
    /// # Errors
    /// [`Error::BadRadius`] if `distance` is negative or NaN.
    ///
    /// *Cost*: O(n α(n)).
    ///
    /// ```
    /// use delone::proximity::Proximity;
    /// let t = delone::triangulate([(0.0, 0.0), (9.0, 9.0), (1.0, 0.0), (9.0, 7.0)])?;
    /// let proximity = Proximity::new(&t, &())?;
    /// let clusters = proximity.spanning_tree()?.clusters_within(2.0)?;
    /// assert_eq!((clusters.count, clusters.of), (2, vec![0, 1, 0, 1]));
    /// # Ok::<(), delone::Error>(())
    /// ```
    pub fn clusters_within(&self, distance: f64) -> Result<Clusters, Error> {
        if distance.is_nan() || distance < 0.0 {
            return Err(Error::BadRadius { given: distance });
        }
        Ok(self.clusters_by(self.lengths.partition_point(|&length| length <= distance)))
    }

    /// Groups points into `count` clusters: the longest edges go, the last ones of equal length first.
    /// `count` is taken as 1 if it is 0, and as the number of vertices if it is more.
    ///
    /// *Cost*: O(n α(n)).
    pub fn clusters(&self, count: usize) -> Clusters {
        self.clusters_by(self.edges.len().saturating_sub(count.max(1) - 1))
    }

    /// Groups points by the `kept` shortest edges.
    fn clusters_by(&self, kept: usize) -> Clusters {
        let n = self.triangulation.points().len();
        let mut forest = Forest::new(n);
        for [a, b] in &self.edges[..kept] {
            forest.join(a.index(), b.index());
        }
        for d in self.triangulation.duplicates() {
            forest.join(d.dropped.index(), d.kept.index());
        }
        let mut numbers = vec![usize::MAX; n];
        let mut count = 0;
        let number = |i| {
            let number = &mut numbers[forest.find(i)];
            if *number == usize::MAX {
                *number = count;
                count += 1;
            }
            *number
        };
        let of = (0..n).map(number).collect();
        Clusters { of, count }
    }
}
