//! The vertices of the diagram: circumcenters, one for all triangles on one circle; of sites with
//! weights power centers, one for all that have one power circle.

use super::diagram::{AT_INFINITY, Diagram, Euclidean, Power};
use crate::pace::{Pace, Strides};
use crate::parallel::{Workers, joined};
use crate::predicates::{CircleSide, circumcenter, in_circle, in_power_circle, power_center};
use crate::{Error, HalfEdgeId, Mesh, Phase, Point, TriangleId, VertexId, Watch};
use std::ops::Range;

/// Makes the diagram that a mesh is dual to; `None` if some triangle's circle has a vertex inside, so that the
/// mesh is not Delaunay.
pub(super) fn dual(
    mesh: &Mesh,
    num_sites: usize,
    circles: &impl Circles,
    watch: &dyn Watch,
) -> Result<Option<Diagram>, Error> {
    let mut pace = Pace::new(watch, Phase::Voronoi, 5 * mesh.num_faces() as u64);
    let workers = Workers::around();
    let Some(dual) = Dual::of(mesh, circles, workers, &mut pace)? else {
        return Ok(None);
    };
    let Dual { vertices, of_face } = dual;
    let diagram = Diagram::new(mesh, num_sites, vertices, &of_face, workers, &pace)?;
    pace.finish();
    Ok(Some(diagram))
}

/// The vertices, and for each face the one that is its dual.
struct Dual {
    vertices: Vec<Point>,
    of_face: Vec<u32>,
}

impl Dual {
    /// Finds them; `None` if the mesh is not Delaunay. They are numbered by the first triangle of each.
    fn of(
        mesh: &Mesh,
        circles: &impl Circles,
        workers: Workers,
        pace: &mut Pace,
    ) -> Result<Option<Self>, Error> {
        let sight = Sight { mesh, circles };
        let n = mesh.num_faces();
        let joints = workers.ranges(n, |faces| sight.joints(faces, pace.strides()))?;
        let Some(joints) = joints.into_iter().collect::<Option<Vec<_>>>() else {
            return Ok(None);
        };
        let (of_face, firsts) = number(mesh, &joints, pace)?;
        let vertices = workers.ranges(firsts.len(), |range| {
            let mut strides = pace.strides();
            let center = |&t: &TriangleId| {
                strides.step()?;
                let center = circles.center(mesh.corners(t));
                Ok(center.expect("bug: a triangle without area"))
            };
            firsts[range].iter().map(center).collect::<Result<_, _>>()
        })?;
        Ok(Some(Self {
            vertices: joined(vertices),
            of_face,
        }))
    }
}

/// Numbers the vertices, given the edges inside one circle, and returns the number of each face and the
/// first triangle of each number: triangles are taken in their order, and with each all that can be reached
/// from it across such edges.
fn number(
    mesh: &Mesh,
    joints: &[Vec<HalfEdgeId>],
    pace: &mut Pace,
) -> Result<(Vec<u32>, Vec<TriangleId>), Error> {
    let mut is_joint = vec![[false; 3]; mesh.num_faces()];
    for &h in joints.iter().flatten() {
        for h in [h, mesh.twin(h)] {
            is_joint[h.triangle().index()][h.index() % 3] = true;
        }
    }
    let mut of_face = vec![AT_INFINITY; mesh.num_faces()];
    let mut firsts = Vec::with_capacity(mesh.num_faces());
    let mut stack = Vec::new();
    for first in mesh.triangles() {
        pace.step()?;
        if of_face[first.index()] != AT_INFINITY {
            continue;
        }
        let number = firsts.len() as u32;
        firsts.push(first);
        of_face[first.index()] = number;
        if is_joint[first.index()].contains(&true) {
            stack.push(first);
        }
        while let Some(t) = stack.pop() {
            for (h, is_joint) in t.half_edges().into_iter().zip(is_joint[t.index()]) {
                let beyond = mesh.twin(h).triangle();
                if is_joint && of_face[beyond.index()] == AT_INFINITY {
                    of_face[beyond.index()] = number;
                    stack.push(beyond);
                }
            }
        }
    }
    Ok((of_face, firsts))
}

/// What a triangulation is dual to a diagram by.
pub(super) trait Circles: Sync {
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
    /// Lists the edges of some faces whose four corners lie on one circle; `None` if there is an edge whose
    /// corner beyond lies inside. Each edge is looked at from one side, as both say the same.
    fn joints(
        &self,
        faces: Range<usize>,
        mut strides: Strides,
    ) -> Result<Option<Vec<HalfEdgeId>>, Error> {
        let mut joints = Vec::new();
        for t in faces.map(TriangleId::new) {
            strides.step()?;
            if self.mesh.is_ghost(t) {
                continue;
            }
            for h in t.half_edges() {
                match self.across(h) {
                    Some(CircleSide::Inside) => return Ok(None),
                    Some(CircleSide::On) => joints.push(h),
                    _ => {}
                }
            }
        }
        Ok(Some(joints))
    }

    /// Tells where the vertex beyond an edge lies relative to the circle of its triangle, if there is
    /// one, and the edge is not looked at from beyond.
    fn across(&self, h: HalfEdgeId) -> Option<CircleSide> {
        let twin = self.mesh.twin(h);
        let apex = self.mesh.apex(twin);
        let corners = self.mesh.corners(h.triangle());
        (h < twin && !apex.is_infinite()).then(|| self.circles.side(corners, apex))
    }
}
