//! The vertices of the diagram: circumcenters, one for all triangles on one circle; of sites with
//! weights power centers, one for all that have one power circle.

use super::diagram::{AT_INFINITY, Euclidean, Power};
use crate::pace::Pace;
use crate::predicates::{CircleSide, circumcenter, in_circle, in_power_circle, power_center};
use crate::{Error, HalfEdgeId, Mesh, Point, VertexId};

/// The vertices, and for each face the one that is its dual.
pub(super) struct Dual {
    pub vertices: Vec<Point>,
    pub of_face: Vec<u32>,
}

impl Dual {
    /// Finds them; `None` if some triangle's circle has a vertex inside, so that the mesh is not
    /// Delaunay.
    ///
    /// Triangles are taken in their order, and with each all that can be reached from it across edges
    /// whose four corners lie on one circle.
    pub fn of(mesh: &Mesh, circles: &impl Circles, pace: &mut Pace) -> Result<Option<Self>, Error> {
        let mut dual = Self {
            vertices: Vec::new(),
            of_face: vec![AT_INFINITY; mesh.num_faces()],
        };
        let sight = Sight { mesh, circles };
        let mut stack = Vec::new();
        for first in mesh.triangles() {
            if dual.of_face[first.index()] != AT_INFINITY {
                continue;
            }
            let number = dual.vertices.len() as u32;
            let center = circles.center(mesh.corners(first));
            dual.vertices
                .push(center.expect("bug: a triangle without area"));
            dual.of_face[first.index()] = number;
            stack.push(first);
            while let Some(t) = stack.pop() {
                pace.step()?;
                for h in t.half_edges() {
                    let beyond = mesh.twin(h).triangle();
                    match sight.across(h) {
                        Some(CircleSide::Inside) => return Ok(None),
                        Some(CircleSide::On) if dual.of_face[beyond.index()] == AT_INFINITY => {
                            dual.of_face[beyond.index()] = number;
                            stack.push(beyond);
                        }
                        _ => {}
                    }
                }
            }
        }
        Ok(Some(dual))
    }
}

/// What a triangulation is dual to a diagram by.
pub(super) trait Circles {
    /// Returns what is equally far from the three corners of a triangle; `None` if it has no area.
    fn center(&self, corners: [VertexId; 3]) -> Option<Point>;

    /// Tells where `d` lies relative to the circle of a triangle.
    fn side(&self, corners: [VertexId; 3], d: VertexId) -> CircleSide;
}

impl Circles for Euclidean<'_> {
    fn center(&self, corners: [VertexId; 3]) -> Option<Point> {
        let [a, b, c] = corners.map(|v| self.0[v.index()]);
        circumcenter(a, b, c)
    }

    #[inline]
    fn side(&self, corners: [VertexId; 3], d: VertexId) -> CircleSide {
        let [a, b, c] = corners.map(|v| self.0[v.index()]);
        in_circle(a, b, c, self.0[d.index()])
    }
}

impl Circles for Power<'_> {
    fn center(&self, corners: [VertexId; 3]) -> Option<Point> {
        let [a, b, c] = corners.map(|v| self.site(v));
        power_center(a, b, c)
    }

    #[inline]
    fn side(&self, corners: [VertexId; 3], d: VertexId) -> CircleSide {
        let [a, b, c] = corners.map(|v| self.site(v));
        in_power_circle(a, b, c, self.site(d))
    }
}

/// A mesh and the circles of its triangles.
struct Sight<'a, C> {
    mesh: &'a Mesh,
    circles: &'a C,
}

impl<C: Circles> Sight<'_, C> {
    /// Tells where the vertex beyond an edge lies relative to the circle of its triangle, if there is
    /// one.
    fn across(&self, h: HalfEdgeId) -> Option<CircleSide> {
        let apex = self.mesh.apex(self.mesh.twin(h));
        let corners = self.mesh.corners(h.triangle());
        (!apex.is_infinite()).then(|| self.circles.side(corners, apex))
    }
}
