//! The half-edge structure and its traversal.

use super::{HalfEdgeId, TriangleId, VertexId};

/// A closed triangulated sphere: triangles, and ghosts around the vertex at infinity.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Mesh {
    /// Corners of each face, counter-clockwise.
    pub(super) corners: Vec<[VertexId; 3]>,
    /// Twins of each face's half-edges.
    pub(super) twins: Vec<[HalfEdgeId; 3]>,
}

impl Mesh {
    /// Takes over the rows of corners and twins that a builder has filled.
    pub(crate) fn from_rows(corners: Vec<[VertexId; 3]>, twins: Vec<[HalfEdgeId; 3]>) -> Self {
        debug_assert_eq!(corners.len(), twins.len());
        Self { corners, twins }
    }

    /// Hands out the rows of corners and twins.
    pub(crate) fn into_rows(self) -> (Vec<[VertexId; 3]>, Vec<[HalfEdgeId; 3]>) {
        (self.corners, self.twins)
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

    /// Visits the faces that do not touch the vertex at infinity.
    pub fn triangles(&self) -> impl Iterator<Item = TriangleId> + '_ {
        let faces = (0..self.num_faces()).map(TriangleId::new);
        faces.filter(|&t| !self.is_ghost(t))
    }

    /// Visits the faces that touch the vertex at infinity.
    pub fn ghosts(&self) -> impl Iterator<Item = TriangleId> + '_ {
        let faces = (0..self.num_faces()).map(TriangleId::new);
        faces.filter(|&t| self.is_ghost(t))
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
        cycle(h, |h| self.onext(h))
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
    ///
    /// # Panics
    /// If `t` is no ghost.
    pub fn hull_edge_of(&self, t: TriangleId) -> HalfEdgeId {
        let k = self.corners(t).iter().position(|v| v.is_infinite());
        t.half_edges()[k.expect("bug: not a ghost")]
    }

    /// Returns the finite half-edge of the ghost that follows counter-clockwise around the hull,
    /// given the finite half-edge of a ghost.
    ///
    /// ```text
    ///         c            .
    ///          \    next    .
    ///           \  ghost   ∞      h runs b → a in its ghost; the next ghost lies beyond b∞,
    ///   inside   b ------- .      its finite half-edge runs c → b.
    ///           /  ghost   ∞
    ///          /    of h   .
    ///         a            .
    /// ```
    #[inline]
    pub fn next_hull_edge(&self, h: HalfEdgeId) -> HalfEdgeId {
        debug_assert!(self.apex(h).is_infinite());
        self.twin(h.prev()).prev()
    }

    /// Visits the finite half-edges of the ghosts, counter-clockwise around the hull, beginning at
    /// `h`, which must be one. Each runs clockwise, having the hull to its right.
    pub fn hull(&self, h: HalfEdgeId) -> impl Iterator<Item = HalfEdgeId> + '_ {
        cycle(h, |h| self.next_hull_edge(h))
    }
}

/// Visits `first`, its successor and so on until `first` would come again.
fn cycle(
    first: HalfEdgeId,
    successor: impl Fn(HalfEdgeId) -> HalfEdgeId,
) -> impl Iterator<Item = HalfEdgeId> {
    std::iter::successors(Some(first), move |&h| {
        Some(successor(h)).filter(|&next| next != first)
    })
}
