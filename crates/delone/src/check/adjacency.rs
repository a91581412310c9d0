//! Which half-edges are twins, found from the corners alone.
//!
//! Half-edges are sorted by their two ends in two passes of a counting sort, so those of one edge
//! become neighbours: linear whatever the degrees, and no hash table.

use super::{Corner, Defect, Defects};
use crate::pace::Pace;
use crate::{Error, HalfEdgeId, Point, VertexId};

/// Steps that [`Adjacency::find`] takes for a triangle: three half-edges, each counted and moved
/// in two passes, then paired.
pub(super) const STEPS_PER_TRIANGLE: u64 = 3 * 5;

/// Triangles and the twins of their half-edges; `3t + k` lies opposite corner `k`.
pub(super) struct Adjacency<'a> {
    triangles: &'a [[VertexId; 3]],
    /// A half-edge without a twin is its own.
    twins: Vec<HalfEdgeId>,
    is_manifold: bool,
}

impl<'a> Adjacency<'a> {
    /// Pairs the half-edges, and reports the edges that have more than two or two alike.
    ///
    /// Corners must be indices of points, and half-edges must fit their ids.
    pub(super) fn find(
        points: &[Point],
        triangles: &'a [[VertexId; 3]],
        pace: &mut Pace,
        defects: &mut Defects,
    ) -> Result<Self, Error> {
        let all = (0..3 * triangles.len()).map(HalfEdgeId::new);
        let mut adjacency = Self {
            triangles,
            twins: all.clone().collect(),
            is_manifold: true,
        };
        let lower = |h| adjacency.ends(h)[0];
        let upper = |h| adjacency.ends(h)[1];
        let by_upper = bucket(all, points.len(), upper, pace)?;
        let by_edge = bucket(by_upper.iter().copied(), points.len(), lower, pace)?;
        let mut rest = &by_edge[..];
        while let Some(&first) = rest.first() {
            let edge = adjacency.ends(first);
            let same = rest.iter().take_while(|&&h| adjacency.ends(h) == edge);
            let (group, others) = rest.split_at(same.count());
            for _ in group {
                pace.step()?;
            }
            if let Some(defect) = adjacency.pair(group, points) {
                defects.push(defect);
            }
            rest = others;
        }
        Ok(adjacency)
    }

    /// Makes the half-edges of one edge twins, or says why that is impossible.
    fn pair(&mut self, group: &[HalfEdgeId], points: &[Point]) -> Option<Defect> {
        let (g, h) = match *group {
            [_] => return None,
            [g, h, ..] => (g, h),
            [] => unreachable!("bug: an edge without half-edges"),
        };
        if group.len() == 2 && self.origin(g) != self.origin(h) {
            self.twins[g.index()] = h;
            self.twins[h.index()] = g;
            return None;
        }
        self.is_manifold = false;
        let edge = [self.origin(g), self.dest(g)].map(|v| Corner::new(points, v));
        let triangles = [g, h].map(HalfEdgeId::triangle);
        Some(match group.len() {
            2 => Defect::SameSide { edge, triangles },
            count => Defect::CrowdedEdge {
                edge,
                triangles,
                count,
            },
        })
    }

    /// Tells whether every edge has one triangle, or two on different sides.
    pub(super) fn is_manifold(&self) -> bool {
        self.is_manifold
    }

    pub(super) fn num_half_edges(&self) -> usize {
        self.twins.len()
    }

    pub(super) fn half_edges(&self) -> impl Iterator<Item = HalfEdgeId> + use<> {
        (0..self.num_half_edges()).map(HalfEdgeId::new)
    }

    pub(super) fn apex(&self, h: HalfEdgeId) -> VertexId {
        self.triangles.as_flattened()[h.index()]
    }

    pub(super) fn origin(&self, h: HalfEdgeId) -> VertexId {
        self.apex(h.next())
    }

    pub(super) fn dest(&self, h: HalfEdgeId) -> VertexId {
        self.apex(h.prev())
    }

    /// Returns the same edge in the other direction, or `None` on the boundary.
    pub(super) fn twin(&self, h: HalfEdgeId) -> Option<HalfEdgeId> {
        let twin = self.twins[h.index()];
        (twin != h).then_some(twin)
    }

    /// Returns the next half-edge counter-clockwise about the origin of `h`, or `None` at the end
    /// of a fan.
    pub(super) fn onext(&self, h: HalfEdgeId) -> Option<HalfEdgeId> {
        self.twin(h.prev())
    }

    /// Returns the lower and the higher end of an edge.
    fn ends(&self, h: HalfEdgeId) -> [VertexId; 2] {
        let (a, b) = (self.origin(h), self.dest(h));
        [a.min(b), a.max(b)]
    }
}

/// Sorts half-edges by a vertex of theirs, stably.
fn bucket(
    half_edges: impl ExactSizeIterator<Item = HalfEdgeId> + Clone,
    num_vertices: usize,
    key: impl Fn(HalfEdgeId) -> VertexId,
    pace: &mut Pace,
) -> Result<Vec<HalfEdgeId>, Error> {
    let mut slots = vec![0u32; num_vertices + 1];
    for h in half_edges.clone() {
        pace.step()?;
        slots[key(h).index() + 1] += 1;
    }
    for v in 1..slots.len() {
        slots[v] += slots[v - 1];
    }
    let mut sorted = vec![HalfEdgeId::new(0); half_edges.len()];
    for h in half_edges {
        pace.step()?;
        let slot = &mut slots[key(h).index()];
        sorted[*slot as usize] = h;
        *slot += 1;
    }
    Ok(sorted)
}
