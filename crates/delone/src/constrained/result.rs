//! The result: a triangulation, what is constrained in it, and where everything comes from.

use crate::pslg::Chains;
use crate::{HalfEdgeId, Point, Region, TriangleId, Triangulation, VertexId};

/// Where a vertex comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Origin {
    /// The point of this index in the input.
    Input(VertexId),
    /// Where these two input segments cross (the lexicographically first pair of indices, if more do).
    Crossing([usize; 2]),
}

/// What is worth a word, though the result is right.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Warning {
    /// The rule leaves nothing of the domain.
    #[error(
        "nothing is left: the segments enclose no area; close the outline, or keep the convex hull"
    )]
    Empty,
    /// A hole seed lies where there is no domain to carve.
    #[error("hole {hole} at ({}, {}) lies outside the domain and carves nothing", at.x, at.y)]
    HoleOutside {
        /// Index of the hole.
        hole: usize,
        /// Where its point lies.
        at: Point,
    },
    /// A region seed lies outside the domain or in a hole.
    #[error("region {region} at ({}, {}) lies outside the domain", at.x, at.y)]
    RegionOutside {
        /// Index of the region.
        region: usize,
        /// Where its point lies.
        at: Point,
    },
    /// Two region seeds lie in one region; the first one counts.
    #[error("region {region} lies in the region of {first}, which counts")]
    RegionTwice {
        /// Index of the region that does not count.
        region: usize,
        /// Index of the one that does.
        first: usize,
    },
}

/// A constrained Delaunay triangulation: triangles, constrained edges, regions, and the lineage of
/// vertices and segments.
///
/// Vertices `0..n` are the n points of the input, those after them are the crossings of segments,
/// sorted by x, then y. In the [mesh](Triangulation::mesh) come first the triangles of the domain,
/// then those that were carved away, then the ghosts.
#[derive(Clone, Debug)]
pub struct ConstrainedTriangulation {
    pub(super) triangulation: Triangulation,
    /// Three bits a face: is its half-edge opposite corner k constrained?
    pub(super) constrained: Vec<u8>,
    /// For each triangle one more than its region, or 0; empty if there are no regions.
    pub(super) region_of: Vec<u32>,
    pub(super) regions: Vec<Region>,
    pub(super) segments: Vec<[VertexId; 2]>,
    pub(super) chains: Chains,
    /// For each vertex added at a crossing the segments that cross there.
    pub(super) crossings: Vec<[u32; 2]>,
    pub(super) warnings: Vec<Warning>,
}

impl ConstrainedTriangulation {
    /// Returns points, triangles of the domain, and mesh.
    pub fn triangulation(&self) -> &Triangulation {
        &self.triangulation
    }

    /// Tells whether the edge of `h` is part of a segment.
    #[inline]
    pub fn is_constrained(&self, h: HalfEdgeId) -> bool {
        self.constrained[h.triangle().index()] >> h.slot() & 1 == 1
    }

    /// Visits every constrained edge once, those outside the domain included.
    pub fn constrained_edges(&self) -> impl Iterator<Item = [VertexId; 2]> + '_ {
        let mesh = self.triangulation.mesh();
        mesh.half_edges()
            .filter(move |&h| self.is_constrained(h) && h < mesh.twin(h))
            .map(move |h| [mesh.origin(h), mesh.dest(h)])
    }

    /// Returns the segments of the input.
    pub fn segments(&self) -> &[[VertexId; 2]] {
        &self.segments
    }

    /// Returns the vertices along a segment of the input, from its first end to its second. Equal
    /// points are represented by the one of lowest index; a segment of no length has one vertex.
    pub fn chain(&self, segment: usize) -> &[VertexId] {
        self.chains.get(segment).unwrap_or(&self.segments[segment])
    }

    /// Returns where vertex `v` comes from.
    pub fn origin(&self, v: VertexId) -> Origin {
        match v.index().checked_sub(self.num_input_points()) {
            None => Origin::Input(v),
            Some(i) => Origin::Crossing(self.crossings[i].map(|s| s as usize)),
        }
    }

    /// Counts the points of the input.
    pub fn num_input_points(&self) -> usize {
        self.triangulation.points().len() - self.crossings.len()
    }

    /// Counts the vertices that were added where segments cross.
    pub fn num_crossings(&self) -> usize {
        self.crossings.len()
    }

    /// Returns the region of triangle `t`, as an index of [`regions`](Self::regions).
    pub fn region(&self, t: TriangleId) -> Option<usize> {
        let region = *self.region_of.get(t.index())?;
        (region as usize).checked_sub(1)
    }

    /// Returns the regions of the input.
    pub fn regions(&self) -> &[Region] {
        &self.regions
    }

    /// Returns what is worth a word.
    pub fn warnings(&self) -> &[Warning] {
        &self.warnings
    }
}
