//! The half-edge structure and its traversal.

use super::{HalfEdgeId, TriangleId, VertexId};

/// A closed triangulated sphere: triangles, and ghosts around the vertex at infinity.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Mesh {
    /// Corners of each face, counter-clockwise.
    corners: Vec<[VertexId; 3]>,
    /// Twins of each face's half-edges.
    twins: Vec<[HalfEdgeId; 3]>,
}

impl Mesh {
    /// Takes over the rows of corners and twins that a builder has filled.
    pub(crate) fn from_rows(corners: Vec<[VertexId; 3]>, twins: Vec<[HalfEdgeId; 3]>) -> Self {
        debug_assert_eq!(corners.len(), twins.len());
        Self { corners, twins }
    }

    /// Counts the faces, ghosts included.
    #[inline]
    pub fn num_faces(&self) -> usize {
        self.corners.len()
    }

    /// Returns the corners of every face, counter-clockwise, ghosts included.
    #[inline]
    pub fn faces(&self) -> &[[VertexId; 3]] {
        &self.corners
    }

    /// Visits all half-edges.
    pub fn half_edges(&self) -> impl Iterator<Item = HalfEdgeId> + use<> {
        (0..3 * self.num_faces()).map(HalfEdgeId::new)
    }

    /// Returns the corner that `h` lies opposite to.
    #[inline]
    pub fn apex(&self, h: HalfEdgeId) -> VertexId {
        self.corners.as_flattened()[h.index()]
    }

    /// Returns the vertex where `h` starts.
    #[inline]
    pub fn origin(&self, h: HalfEdgeId) -> VertexId {
        self.apex(h.next())
    }

    /// Returns the vertex where `h` ends.
    #[inline]
    pub fn dest(&self, h: HalfEdgeId) -> VertexId {
        self.apex(h.prev())
    }

    /// Returns the same edge in the other direction, in the triangle beyond.
    #[inline]
    pub fn twin(&self, h: HalfEdgeId) -> HalfEdgeId {
        self.twins.as_flattened()[h.index()]
    }

    /// Returns the next half-edge counter-clockwise about the origin of `h`.
    #[inline]
    pub fn onext(&self, h: HalfEdgeId) -> HalfEdgeId {
        self.twin(h.prev())
    }

    /// Returns the next half-edge clockwise about the origin of `h`.
    #[inline]
    pub fn oprev(&self, h: HalfEdgeId) -> HalfEdgeId {
        self.twin(h).next()
    }

    /// Visits the half-edges that share the origin of `h`, counter-clockwise, `h` first.
    pub fn star(&self, h: HalfEdgeId) -> impl Iterator<Item = HalfEdgeId> + '_ {
        let mut current = Some(h);
        std::iter::from_fn(move || {
            let this = current?;
            let next = self.onext(this);
            current = (next != h).then_some(next);
            Some(this)
        })
    }

    /// Returns the corners of face `t`, counter-clockwise.
    #[inline]
    pub fn corners(&self, t: TriangleId) -> [VertexId; 3] {
        self.corners[t.index()]
    }

    /// Tells whether face `t` touches the vertex at infinity.
    #[inline]
    pub fn is_ghost(&self, t: TriangleId) -> bool {
        self.corners(t).iter().any(|v| v.is_infinite())
    }

    /// Returns the finite half-edge of ghost `t`; it runs clockwise around the hull.
    pub(crate) fn hull_edge_of(&self, t: TriangleId) -> HalfEdgeId {
        let k = self.corners(t).iter().position(|v| v.is_infinite());
        t.half_edges()[k.expect("bug: not a ghost")]
    }

    /// Returns the finite half-edge of the ghost that follows counter-clockwise around the hull.
    pub(crate) fn next_hull_edge(&self, h: HalfEdgeId) -> HalfEdgeId {
        debug_assert!(self.apex(h).is_infinite());
        // h runs dest ← origin against the hull's direction; the next ghost lies beyond the edge
        // from infinity to h's origin.
        let beyond = self.twin(h.prev());
        beyond.prev()
    }
}
