//! Canonical noding: segments are cut where they cross, in rounds that depend on the set alone.

use super::Chains;
use crate::parallel::Workers;
use crate::{Point, VertexId, Watch};

/// Into what segments have been cut.
pub(crate) struct Noding {
    /// The points added where segments cross, sorted by x, then y; none equals an input point.
    pub points: Vec<Point>,
    /// For each of them the lexicographically first pair of segments that were cut there.
    pub crossings: Vec<[u32; 2]>,
    /// The segments that were cut, as chains of vertices; added point `i` is vertex
    /// `points.len() + i` of the input.
    pub chains: Chains,
}

/// Cuts `segments` until they meet only at shared ends.
///
/// `vertices` lists the distinct points; the ends of segments are among them, the two of one
/// segment differ, and segments may repeat. `None` if the watch cancelled.
pub(crate) fn node(
    points: &[Point],
    vertices: &[VertexId],
    segments: &[[VertexId; 2]],
    workers: Workers,
    watch: &dyn Watch,
) -> Option<Noding> {
    let _ = (points, vertices, segments, workers, watch);
    todo!()
}

/// Two segments that cross in a point that is no vertex, and that point, rounded.
pub(crate) type Crossing = ([usize; 2], Point);

/// Finds the lexicographically first pair of segments that cross in a point that is no vertex.
///
/// Arguments as for [`node`]. The outer `None` says that the watch cancelled.
pub(crate) fn first_crossing(
    points: &[Point],
    vertices: &[VertexId],
    segments: &[[VertexId; 2]],
    workers: Workers,
    watch: &dyn Watch,
) -> Option<Option<Crossing>> {
    let _ = (points, vertices, segments, workers, watch);
    todo!()
}
