//! Graphs and figures that a Delaunay triangulation holds: whoever is near whom.
//!
//! [`Proximity`] takes a triangulation and reads off it
//! - `neighbors.rs`: the closest pair, and everyone's nearest neighbour;
//! - `tree.rs`: the Euclidean minimum spanning tree, and clusters by single linkage, which are what is
//!   left of it without its long edges;
//! - `gabriel.rs`, `relative.rs`: the Gabriel graph and the relative neighbourhood graph;
//! - `alpha/`: alpha shapes, for every radius;
//! - `empty_circle.rs`: the largest circle without a point in it;
//! - `tour/`: a short tour through all vertices.
//!
//! The convex hull is there already, see [`Triangulation::hull`]; [`Proximity::hull_corners`] leaves out
//! what lies inside its edges.
//!
//! Each of the graphs lies in the next one (Toussaint, *The relative neighbourhood graph of a finite
//! planar set*, 1980): nearest neighbours, spanning tree, relative neighbours, Gabriel graph, Delaunay
//! triangulation. So three edges a vertex hold all of them, and what would take n² comparisons takes a
//! few n.
//!
//! *Exact.* Membership is decided by exact comparison of lengths and exact signs. Equal lengths are told
//! apart by the indices of the ends, the lower one of each first, so nothing is left to chance: the
//! results depend on the points and their order alone. What is rounded says so.
//!
//! *Vertices* are the distinct points: of equal ones the first counts, the others are
//! [duplicates](Triangulation::duplicates) and no vertices of any graph.
//!
//! *Domains.* These graphs belong to points. Of a triangulation with segments or holes they are those of
//! all its vertices, segments and holes forgotten: [`Proximity::new`] triangulates anew if some edge is
//! not Delaunay.
//!
//! *Cost* stands at each function; all but the tour are linear in practice, but for the sorting of edges.

mod alpha;
mod edges;
mod empty_circle;
mod forest;
mod gabriel;
mod neighbors;
mod relative;
mod ruler;
mod tour;

mod tree;

pub use alpha::{AlphaShape, AlphaShapes};
pub use empty_circle::EmptyCircle;

pub use tour::{Route, Tour};
pub use tree::{Clusters, SpanningTree};

use crate::delaunay::of_vertices;
use crate::pace::Pace;
use crate::predicates::{Orientation, orient2d};
use crate::{Error, HalfEdgeId, Phase, Point, Triangulation, VertexId, Watch};
use std::borrow::Cow;

/// The Delaunay triangulation of some points, to be asked for what is near.
///
/// Every question can be cancelled by the watch and fails with [`Error::Cancelled`] then.
///
/// ```
/// use delone::proximity::Proximity;
/// let t = delone::triangulate([(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (1.0, 1.0)])?;
/// let proximity = Proximity::new(&t, &())?;
/// assert_eq!(proximity.closest_pair()?, Some([0.into(), 3.into()]));
/// let tree = proximity.spanning_tree()?;
/// assert_eq!(tree.edges(), [[0, 3], [1, 2], [1, 3]].map(|edge| edge.map(Into::into)));
/// # Ok::<(), delone::Error>(())
/// ```
#[derive(Clone)]
pub struct Proximity<'t> {
    triangulation: Cow<'t, Triangulation>,
    watch: &'t dyn Watch,
}

impl<'t> Proximity<'t> {
    /// Takes a triangulation; `watch` is told of all that is asked of it later.
    ///
    /// # Errors
    /// [`Error::Cancelled`].
    ///
    /// *Cost*: an in-circle test an edge, and a triangulation of the points if some edge is not Delaunay.
    pub fn new(triangulation: &'t Triangulation, watch: &'t dyn Watch) -> Result<Self, Error> {
        Ok(Self {
            triangulation: of_vertices(triangulation, watch)?,
            watch,
        })
    }

    /// Returns the Delaunay triangulation that is asked: the one given, or that of its points.
    pub fn triangulation(&self) -> &Triangulation {
        &self.triangulation
    }

    /// Lists the corners of the convex hull counter-clockwise: its vertices without those inside its
    /// edges, that of lowest index first. If all points lie on one line, the two ends.
    pub fn hull_corners(&self) -> Vec<VertexId> {
        let hull: Vec<VertexId> = self.triangulation.hull().collect();
        let n = hull.len();
        let is_corner = |&i: &usize| {
            let [a, b, c] = [(i + n - 1) % n, i, (i + 1) % n].map(|i| hull[i]);
            a == c || self.turn([a, b, c]) != Orientation::Collinear
        };
        let mut corners: Vec<VertexId> = (0..n).filter(is_corner).map(|i| hull[i]).collect();
        let lowest = (0..corners.len()).min_by_key(|&i| corners[i]);
        corners.rotate_left(lowest.unwrap_or(0));
        corners
    }

    fn turn(&self, corners: [VertexId; 3]) -> Orientation {
        let [a, b, c] = corners.map(|v| self.point(v));
        orient2d(a, b, c)
    }

    #[inline]
    fn point(&self, v: VertexId) -> Point {
        self.triangulation.point(v)
    }

    /// The ends of a half-edge.
    #[inline]
    fn ends(&self, h: HalfEdgeId) -> [VertexId; 2] {
        let mesh = self.triangulation.mesh();
        [mesh.origin(h), mesh.dest(h)]
    }

    #[inline]
    fn end_points(&self, h: HalfEdgeId) -> [Point; 2] {
        self.ends(h).map(|v| self.point(v))
    }

    /// Visits one half-edge of every edge between finite vertices.
    fn half_edges(&self) -> impl Iterator<Item = HalfEdgeId> + '_ {
        let mesh = self.triangulation.mesh();
        mesh.half_edges().filter(|&h| {
            h < mesh.twin(h) && !mesh.origin(h).is_infinite() && !mesh.dest(h).is_infinite()
        })
    }

    /// Counts the steps of a walk over all edges.
    fn pace(&self) -> Pace<'t> {
        let edges = 3 * self.triangulation.mesh().num_faces() / 2;
        Pace::new(self.watch, Phase::Proximity, edges as u64)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn corners_of_the_hull_are_strict() {
        let points = [(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)];
        let t = crate::triangulate(points).unwrap();
        let corners = Proximity::new(&t, &()).unwrap().hull_corners();
        assert_eq!(corners, [0, 2, 3, 4].map(VertexId::from));
        let t = crate::triangulate(points[..3].iter().copied()).unwrap();
        let corners = Proximity::new(&t, &()).unwrap().hull_corners();
        assert_eq!(corners, [0, 2].map(VertexId::from));
    }
}
