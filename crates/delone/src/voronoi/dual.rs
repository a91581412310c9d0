//! The vertices of the diagram: circumcenters, one for all triangles on one circle.

use super::diagram::AT_INFINITY;
use crate::pace::Pace;
use crate::predicates::{CircleSide, circumcenter, in_circle};
use crate::{Error, HalfEdgeId, Mesh, Point, TriangleId};

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
    pub fn of(mesh: &Mesh, points: &[Point], pace: &mut Pace) -> Result<Option<Self>, Error> {
        let mut dual = Self {
            vertices: Vec::new(),
            of_face: vec![AT_INFINITY; mesh.num_faces()],
        };
        let sight = Sight { mesh, points };
        let mut stack = Vec::new();
        for first in mesh.triangles() {
            if dual.of_face[first.index()] != AT_INFINITY {
                continue;
            }
            let number = dual.vertices.len() as u32;
            let [a, b, c] = sight.corners(first);
            let center = circumcenter(a, b, c).expect("bug: a triangle without area");
            dual.vertices.push(center);
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

/// A mesh and where its vertices lie.
struct Sight<'a> {
    mesh: &'a Mesh,
    points: &'a [Point],
}

impl Sight<'_> {
    fn corners(&self, t: TriangleId) -> [Point; 3] {
        self.mesh.corners(t).map(|v| self.points[v.index()])
    }

    /// Tells where the vertex beyond an edge lies relative to the circle of its triangle, if there is
    /// one.
    fn across(&self, h: HalfEdgeId) -> Option<CircleSide> {
        let apex = self.mesh.apex(self.mesh.twin(h));
        let [a, b, c] = self.corners(h.triangle());
        (!apex.is_infinite()).then(|| in_circle(a, b, c, self.points[apex.index()]))
    }
}
