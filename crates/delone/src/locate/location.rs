//! The answer: where a point lies.

use crate::{HalfEdgeId, TriangleId, Triangulation, VertexId};

/// Where a point lies in a triangulation.
///
/// ```text
///    carved │ Face        Vertex, Edge: of the mesh, whatever lies around them
///      ─────●─────●       Face: within a triangle of the domain
///    Carved │ Edge \      Carved: within the convex hull, but not in the domain
///           ●───────●
///         Outside
/// ```
///
/// What [`Locator`](super::Locator) answers depends on the triangulation and the point alone; the function
/// [`locate`](super::locate) may name either half-edge of an edge, any hull edge that sees the point, and
/// does not know of domains.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Location {
    /// On a vertex; it may be one that the domain does not touch.
    Vertex(VertexId),
    /// In the open segment of an edge. [`Locator`](super::Locator) names the half-edge in the face of
    /// lower number: if the domain touches the edge, that is one of its triangles.
    Edge(HalfEdgeId),
    /// In the open interior of a triangle.
    Face(TriangleId),
    /// In the open interior of a face that was carved away: within the convex hull, but outside the domain.
    Carved(TriangleId),
    /// Outside the convex hull: the point lies strictly left of this finite half-edge of a ghost.
    /// [`Locator`](super::Locator) names an edge where the segment from the point to the lexicographically
    /// smallest vertex enters the hull.
    Outside(HalfEdgeId),
    /// All vertices lie on one line, the point too, but beyond the end: this half-edge runs from
    /// the last vertex to infinity.
    Beyond(HalfEdgeId),
    /// There are fewer than two vertices, hence no edge to name, and the point lies on none.
    Apart,
}

impl Location {
    /// Returns a triangle of the domain that contains the point, corners and edges included; of several the
    /// one of lowest number. `None`: the point does not belong to the domain.
    ///
    /// `t` must be the triangulation in which the point was located.
    ///
    /// *Cost*: constant, but for a vertex [`Triangulation::star`], whose first call is linear.
    pub fn triangle(self, t: &Triangulation) -> Option<TriangleId> {
        let first = match self {
            Self::Face(t) => Some(t),
            Self::Edge(h) => [h, t.mesh().twin(h)]
                .map(HalfEdgeId::triangle)
                .into_iter()
                .min(),
            Self::Vertex(v) => t.star(v).map(HalfEdgeId::triangle).min(),
            Self::Carved(_) | Self::Outside(_) | Self::Beyond(_) | Self::Apart => None,
        };
        first.filter(|first| first.index() < t.num_triangles())
    }
}
