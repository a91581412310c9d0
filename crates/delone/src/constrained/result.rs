//! The result: a triangulation, what is constrained in it, and where everything comes from.

use super::lengthen::NO_SEGMENT;
use super::segments::undirected;
use crate::pslg::Chains;
use crate::{HalfEdgeId, Point, Region, TriangleId, Triangulation, VertexId};
use std::sync::OnceLock;

/// Where a vertex comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Origin {
    /// The point of this index in the input.
    Input(VertexId),
    /// Where these two input segments cross (the lexicographically first pair of indices, if more do).
    Crossing([usize; 2]),
    /// A Steiner point on this segment (the first one, if several run there).
    OnSegment(usize),
    /// A Steiner point on no segment.
    Free,
}

/// What is worth a word, though the result is right.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Warning {
    /// Rule and holes leave nothing of the convex hull.
    #[error(
        "nothing is left: the segments enclose no area, or holes take all of it; close the outline, or \
         keep the convex hull"
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

/// Where segments and added vertices come from.
#[derive(Clone, Debug, Default)]
pub(crate) struct Lineage {
    /// How many of the segments are the input's; behind them come edges of the convex hull that
    /// refinement made segments of.
    pub num_segments: usize,
    pub chains: Chains,
    /// For each vertex added at a crossing the segments that cross there.
    pub crossings: Vec<[u32; 2]>,
    /// For each vertex added behind those its segment, or [`NO_SEGMENT`].
    pub steiner: Vec<u32>,
}

/// A constrained Delaunay triangulation: triangles, constrained edges, regions, and the lineage of
/// vertices and segments.
///
/// Vertices `0..n` are the n points of the input, those after them are the crossings of segments,
/// sorted by x, then y, and then come those that refinement has added. In the [mesh](Triangulation::mesh) come first the triangles of the domain,
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
    pub(super) lineage: Lineage,
    pub(super) warnings: Vec<Warning>,
    /// The edges along segments with those segments, sorted; made when first asked for.
    pub(super) along: OnceLock<Vec<([VertexId; 2], u32)>>,
}

impl ConstrainedTriangulation {
    /// Returns points, triangles of the domain, and mesh.
    pub fn triangulation(&self) -> &Triangulation {
        &self.triangulation
    }

    /// Keeps the triangulation alone.
    pub fn into_triangulation(self) -> Triangulation {
        self.triangulation
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

    /// Returns the segments of the input; behind them, if the convex hull has been refined, its edges.
    pub fn segments(&self) -> &[[VertexId; 2]] {
        &self.segments
    }

    /// Counts the segments of the input.
    pub fn num_input_segments(&self) -> usize {
        self.lineage.num_segments
    }

    /// Returns the vertices along a segment of the input, from its first end to its second. Equal
    /// points are represented by the one of lowest index; a segment of no length has one vertex.
    ///
    /// # Panics
    /// If there is no such segment.
    pub fn chain(&self, segment: usize) -> &[VertexId] {
        self.lineage
            .chains
            .get(segment)
            .unwrap_or(&self.segments[segment])
    }

    /// Visits the segments of the input along the edge of `h`, ascending, each as often as it runs there.
    ///
    /// *Cost*: O(m log m) for m edges of segments at the first call, then logarithmic.
    pub fn segments_along(&self, h: HalfEdgeId) -> impl Iterator<Item = usize> + '_ {
        let mesh = self.triangulation.mesh();
        let edge = undirected([mesh.origin(h), mesh.dest(h)]);
        let table = self.along.get_or_init(|| self.edges_with_segments());
        let start = table.partition_point(|&(e, _)| e < edge);
        let of_edge = table[start..].iter().take_while(move |&&(e, _)| e == edge);
        of_edge.map(|&(_, segment)| segment as usize)
    }

    /// Lists the edges along all segments with those segments, sorted.
    fn edges_with_segments(&self) -> Vec<([VertexId; 2], u32)> {
        let of_segment = |segment: usize| {
            let edges = self.chain(segment).windows(2);
            edges.map(move |pair| (undirected([pair[0], pair[1]]), segment as u32))
        };
        let mut table: Vec<_> = (0..self.segments.len()).flat_map(of_segment).collect();
        table.sort_unstable();
        table
    }

    /// Returns where vertex `v` comes from.
    ///
    /// # Panics
    /// If `v` is no vertex of the result.
    pub fn origin(&self, v: VertexId) -> Origin {
        let Some(i) = v.index().checked_sub(self.num_input_points()) else {
            return Origin::Input(v);
        };
        let Lineage {
            crossings, steiner, ..
        } = &self.lineage;
        match crossings.get(i) {
            Some(pair) => Origin::Crossing(pair.map(|s| s as usize)),
            None => match steiner[i - crossings.len()] {
                NO_SEGMENT => Origin::Free,
                segment => Origin::OnSegment(segment as usize),
            },
        }
    }

    /// Counts the points of the input.
    pub fn num_input_points(&self) -> usize {
        self.triangulation.points().len() - self.num_crossings() - self.num_steiner()
    }

    /// Counts the vertices that were added where segments cross.
    pub fn num_crossings(&self) -> usize {
        self.lineage.crossings.len()
    }

    /// Counts the vertices that refinement has added, behind all others.
    pub fn num_steiner(&self) -> usize {
        self.lineage.steiner.len()
    }

    /// Counts those of them that lie on segments.
    pub fn num_on_segments(&self) -> usize {
        let steiner = self.lineage.steiner.iter();
        steiner.filter(|&&segment| segment != NO_SEGMENT).count()
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

#[cfg(test)]
mod tests {
    use crate::{ConstrainedDelaunay, Pslg, SegmentPolicy};

    /// A square crossed by both diagonals, with one side drawn twice.
    #[test]
    fn lineage_leads_both_ways() {
        let mut pslg = Pslg::from_points([(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)]);
        pslg.add_ring([0, 1, 2, 3]);
        for [a, b] in [[0, 2], [3, 1], [1, 0]] {
            pslg.add_segment(a, b);
        }
        let cutting = ConstrainedDelaunay::new().crossings(SegmentPolicy::Split);
        let t = cutting.triangulate(pslg).unwrap();
        assert_eq!((t.num_crossings(), t.chain(4).len()), (1, 3));
        let mesh = t.triangulation().mesh();
        for h in mesh.half_edges() {
            let along: Vec<usize> = t.segments_along(h).collect();
            assert_eq!(t.is_constrained(h), !along.is_empty());
            let ends = [mesh.origin(h), mesh.dest(h)];
            for segment in along {
                let mut steps = t.chain(segment).windows(2);
                assert!(steps.any(|s| s.contains(&ends[0]) && s.contains(&ends[1])));
            }
        }
        let h = mesh
            .half_edges()
            .find(|&h| [mesh.origin(h), mesh.dest(h)] == [0.into(), 1.into()]);
        assert!(t.segments_along(h.unwrap()).eq([0, 6]));
    }
}
