//! Triangulations that are made for data: between d and 3d − 1 of them in every triangle.
//!
//! Who fits a polynomial of degree k in each triangle needs enough data there to determine it (d = 3, 6, 10 for
//! k = 1, 2, 3), few enough to resolve detail, and no needles. [`cover`] makes such a triangulation, its vertices
//! being wherever that is best; [`Cover`] has every free choice:
//!
//! 1. Algorithm A lays an outer polygon around the data, and adds centers of clusters as long as every triangle
//!    of the Delaunay triangulation holds at least d data.
//! 2. Algorithm B goes through the triangles, the fullest first, and puts a vertex on an edge, or on the other
//!    diagonal, where that makes triangles that hold at least d each.
//! 3. Algorithm C opens triangles that still hold 3d or more with a vertex inside, or on an edge that alone holds 2d.
//!
//! After each vertex of B and C edges are flipped for larger angles, as far as that leaves d data on both sides.
//! Whatever then holds 3d or more, because too many data lie on edges, is an [exception](Exception), with its cause.
//!
//! *Who holds what*: data are a set, equal ones count once. Each datum is *held* by exactly one triangle; one that
//! lies on an edge or a vertex by any of those there, and where a bound can be met by choosing, it is.
//!
//! *Exact*: in which triangles a datum may be, and whether a vertex goes where it must, is decided by the exact
//! signs, on the vertices as they are handed out, rounded.
//!
//! *Cost*: O(n log n) in practice.
//!
//! *Does not* promise angles: data far from all others make thin triangles. Results are not Delaunay in general.
//!
//! [`Clustering`] is of its own: clusters in any dimension, by distances. What comes out here is proven by
//! [`verify_cover`](crate::check::verify_cover), and fitted by [`LocalFits`](crate::surface::LocalFits);
//! `docs/scattered.md` shows what for.
//!
//! *Source*: diploma thesis, Duisburg, about 1998, chapter 3.

mod algorithm_a;
mod algorithm_b;
mod algorithm_c;
mod centers;
mod cover;
mod data;
mod edges;
mod extent;
mod field;
mod given;
mod open;
mod optimize;
mod outline;
mod pieces;
mod ranking;
mod result;
mod schreiber;
mod share;
mod sheet;
mod stock;
mod trial;
mod witness;

pub(crate) use algorithm_a::CODE_A;
pub(crate) use algorithm_b::CODE_B;
pub(crate) use algorithm_c::CODE_C;
pub use cover::{Cover, cover};
pub use open::{Counting, Move, Next, PointSearch, SearchStep, Steps};
pub use pieces::{cluster_centers, outer_polygon};
pub use result::{Cause, DataTriangulation, Exception};
pub use schreiber::{Cluster, Clustering, Clusters, Errors};

/// Points of one of the kit's kinds.
#[cfg(test)]
fn samples(kind: delone_testkit::generate::Kind, n: usize, seed: u64) -> Vec<crate::Point> {
    // The kit knows the library as it is without tests: another type.
    let points = kind.points(n, seed).into_iter();
    points.map(|p| crate::Point::new(p.x, p.y)).collect()
}
