//! What a surface lies over: the triangles of a triangulation or of a domain; and where a point lies
//! on it.
//!
//! Location is that of [`locate`](crate::locate): it walks through the whole mesh, what was carved away
//! included, so holes and notches are no obstacle.

use crate::locate::{Location, locate};
use crate::mesh::Mesh;
use crate::{ConstrainedTriangulation, HalfEdgeId, Point, TriangleId, Triangulation, VertexId};

/// The triangles over which a surface lies; made of a reference to a [`Triangulation`] or to a
/// [`ConstrainedTriangulation`].
///
/// The surface has values within the triangles that were kept, borders included, and nowhere else.
#[derive(Clone, Copy, Debug)]
pub struct Ground<'t> {
    triangulation: &'t Triangulation,
    constraints: Option<&'t ConstrainedTriangulation>,
}

impl<'t> From<&'t Triangulation> for Ground<'t> {
    fn from(triangulation: &'t Triangulation) -> Self {
        Self {
            triangulation,
            constraints: None,
        }
    }
}

impl<'t> From<&'t ConstrainedTriangulation> for Ground<'t> {
    fn from(domain: &'t ConstrainedTriangulation) -> Self {
        Self {
            triangulation: domain.triangulation(),
            constraints: Some(domain),
        }
    }
}

/// Where a point lies on the ground.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Place {
    pub spot: Spot,
    /// Of the triangles of the ground that touch the point, the one of lowest number.
    pub triangle: TriangleId,
}

/// What of a triangulation a point lies on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Spot {
    Vertex(VertexId),
    /// In the open edge of a half-edge, whose face is the triangle of the place.
    Edge(HalfEdgeId),
    Face,
}

impl<'t> Ground<'t> {
    /// Returns the triangulation.
    pub fn triangulation(&self) -> &'t Triangulation {
        self.triangulation
    }

    pub(super) fn mesh(&self) -> &'t Mesh {
        self.triangulation.mesh()
    }

    /// Tells whether a face belongs to the ground.
    #[inline]
    pub(super) fn has(&self, t: TriangleId) -> bool {
        t.index() < self.triangulation.num_triangles()
    }

    /// Tells whether the ground ends at the edge of `h`, or a segment runs there.
    #[inline]
    pub(super) fn is_wall(&self, h: HalfEdgeId) -> bool {
        !self.has(self.mesh().twin(h).triangle())
            || self.constraints.is_some_and(|c| c.is_constrained(h))
    }

    /// Returns the positions of the corners of a finite face.
    #[inline]
    pub(super) fn corners(&self, t: TriangleId) -> [Point; 3] {
        self.mesh()
            .corners(t)
            .map(|v| self.triangulation.points()[v.index()])
    }

    /// Finds where a point lies, walking from `near`, or from anywhere if that is no face; then `near` is
    /// where the walk ended. `None` is outside. What is found does not depend on where the walk begins.
    ///
    /// *Cost*: one or two orientation tests for every triangle walked through; on a vertex also
    /// [`Triangulation::star`], whose first call is linear.
    pub(super) fn place(&self, goal: Point, near: &mut TriangleId) -> Option<Place> {
        if self.triangulation.num_triangles() == 0 || !goal.is_finite() {
            return None;
        }
        let mesh = self.mesh();
        if near.index() >= mesh.num_faces() {
            *near = TriangleId::new(0);
        }
        let [hint, ..] = near.half_edges();
        let location = locate(mesh, self.triangulation.points(), hint, goal);
        let triangle = location.triangle(self.triangulation);
        *near = match location {
            Location::Face(t) => t,
            Location::Edge(h) | Location::Outside(h) => h.triangle(),
            _ => triangle.unwrap_or(*near),
        };
        let triangle = triangle?;
        let spot = match location {
            Location::Vertex(v) => Spot::Vertex(v),
            Location::Edge(h) if h.triangle() == triangle => Spot::Edge(h),
            Location::Edge(h) => Spot::Edge(mesh.twin(h)),
            _ => Spot::Face,
        };
        Some(Place { spot, triangle })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{ConstrainedDelaunay, DomainRule, Pslg};

    fn v(i: usize) -> VertexId {
        VertexId::new(i)
    }

    /// A square ring around a square hole.
    fn frame() -> ConstrainedTriangulation {
        let corners = [(0., 0.), (6., 0.), (6., 6.), (0., 6.)];
        let hole = [(2., 2.), (4., 2.), (4., 4.), (2., 4.)];
        let mut pslg = Pslg::from_points(corners.into_iter().chain(hole));
        pslg.add_ring([0, 1, 2, 3]);
        pslg.add_ring([4, 5, 6, 7]);
        let rule = ConstrainedDelaunay::new().domain(DomainRule::EvenOdd);
        rule.triangulate(pslg).expect("a frame")
    }

    #[test]
    fn places_do_not_depend_on_where_the_walk_begins() {
        let t = frame();
        let ground = Ground::from(&t);
        let faces = t.triangulation().mesh().num_faces();
        for i in 0..169 {
            let goal = Point::new(f64::from(i % 13) * 0.5, f64::from(i / 13) * 0.5);
            let found = |from: usize| ground.place(goal, &mut TriangleId::new(from));
            let first = found(0);
            assert!((1..faces + 2).all(|from| found(from) == first), "{goal:?}");
            let in_hole = |c: f64| c > 2.0 && c < 4.0;
            assert_eq!(
                first.is_none(),
                in_hole(goal.x) && in_hole(goal.y),
                "{goal:?}"
            );
        }
    }

    #[test]
    fn vertices_and_borders_belong_to_the_ground() {
        let t = frame();
        let ground = Ground::from(&t);
        let place = |x, y| ground.place(Point::new(x, y), &mut TriangleId::new(0));
        assert_eq!(place(2.0, 2.0).map(|p| p.spot), Some(Spot::Vertex(v(4))));
        let side = place(3.0, 2.0).expect("on the border of the hole");
        let Spot::Edge(h) = side.spot else {
            panic!("{side:?}");
        };
        assert!(ground.is_wall(h) && ground.has(side.triangle));
        assert_eq!(place(6.5, 3.0), None);
        assert_eq!(place(f64::NAN, 3.0), None);
        assert_eq!(place(3.0, f64::INFINITY), None);
    }
}
