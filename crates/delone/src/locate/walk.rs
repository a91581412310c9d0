//! The visibility walk: from triangle to triangle, always through an edge that separates the
//! triangle from the goal.
//!
//! In a Delaunay triangulation, and under the symbolic perturbation in a regular one, "lies in front
//! of, seen from the goal" has no cycle, so the walk terminates whichever separating edge it takes
//! (Edelsbrunner, *An acyclicity theorem for cell complexes in d dimensions*, 1990; Devillers, Pion
//! and Teillaud, *Walking in a triangulation*, 2002). It takes the first one counter-clockwise from
//! where it came in: no random numbers, so the same question has the same answer. In a
//! triangulation that is not Delaunay it may run in circles.
//!
//! Every sign is exact. Cost: O(√n) triangles for evenly spread points and an arbitrary hint, O(1)
//! for a hint nearby, O(n) at worst.

use crate::predicates::{Orientation, orient2d};
use crate::{HalfEdgeId, Mesh, Point, TriangleId, VertexId};

/// Where a point lies in a triangulation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Location {
    /// On a vertex.
    Vertex(VertexId),
    /// In the open segment of an edge; either of its half-edges.
    Edge(HalfEdgeId),
    /// In the open interior of a triangle.
    Face(TriangleId),
    /// Outside the hull: the point lies strictly left of this finite half-edge of a ghost.
    Outside(HalfEdgeId),
    /// All vertices lie on one line, the point too, but beyond the end: this half-edge runs from
    /// the last vertex to infinity.
    Beyond(HalfEdgeId),
}

/// Finds where `goal` lies, walking from the face of `hint`.
///
/// `points[v]` is the position of vertex `v`; the mesh must be their Delaunay triangulation, with
/// at least two vertices.
///
/// # Panics
/// If `hint` is no half-edge of the mesh.
///
/// *Cost*: one or two orientation tests for every triangle walked through: about √n of them for
/// evenly spread points and an arbitrary hint, a few for a hint nearby, n at worst.
pub fn locate(mesh: &Mesh, points: &[Point], hint: HalfEdgeId, goal: Point) -> Location {
    let walk = Walk { mesh, points, goal };
    let t = hint.triangle();
    if !mesh.is_ghost(t) {
        return walk.through_triangles(t);
    }
    let inner = mesh.twin(mesh.hull_edge_of(t));
    if mesh.is_ghost(inner.triangle()) {
        walk.beside_row(inner)
    } else {
        walk.through_triangles(inner.triangle())
    }
}

struct Walk<'a> {
    mesh: &'a Mesh,
    points: &'a [Point],
    goal: Point,
}

enum Step {
    Arrived(Location),
    Through(HalfEdgeId),
}

impl Walk<'_> {
    fn through_triangles(&self, start: TriangleId) -> Location {
        let mut step = self.step(&start.half_edges());
        loop {
            match step {
                Step::Arrived(location) => return location,
                Step::Through(h) => {
                    let entered = self.mesh.twin(h);
                    if self.mesh.apex(entered).is_infinite() {
                        return Location::Outside(entered);
                    }
                    step = self.step(&[entered.next(), entered.prev()]);
                }
            }
        }
    }

    /// Decides by some half-edges of one triangle; the goal is strictly left of those left out.
    fn step(&self, half_edges: &[HalfEdgeId]) -> Step {
        let mut touched = [None; 2];
        for &h in half_edges {
            match self.side(h) {
                Orientation::Right => return Step::Through(h),
                Orientation::Collinear => touched = [Some(h), touched[0]],
                Orientation::Left => {}
            }
        }
        Step::Arrived(match touched {
            [Some(g), Some(h)] => Location::Vertex(self.common_vertex(h, g)),
            [Some(h), None] => Location::Edge(h),
            [None, _] => Location::Face(half_edges[0].triangle()),
        })
    }

    /// The vertex shared by two half-edges of one triangle.
    fn common_vertex(&self, h: HalfEdgeId, g: HalfEdgeId) -> VertexId {
        if h.next() == g {
            self.mesh.origin(g)
        } else {
            self.mesh.origin(h)
        }
    }

    /// Walks along vertices that all lie on one line, starting at the finite edge of `h`.
    fn beside_row(&self, h: HalfEdgeId) -> Location {
        match self.side(h) {
            Orientation::Left => Location::Outside(h),
            Orientation::Right => Location::Outside(self.mesh.twin(h)),
            Orientation::Collinear => self.along_row(h),
        }
    }

    /// As [`beside_row`](Self::beside_row), knowing that the goal lies on the line.
    fn along_row(&self, h: HalfEdgeId) -> Location {
        let ahead = |h| {
            let [a, b] = self.ends(h);
            a.lex_cmp(&b) == b.lex_cmp(&self.goal)
        };
        let mut h = if ahead(h) { h } else { self.mesh.twin(h) };
        while ahead(h) {
            let end = h.next();
            let beyond = self.mesh.twin(end).next();
            if beyond == self.mesh.twin(h) {
                return Location::Beyond(end);
            }
            h = beyond;
        }
        self.on_edge(h)
    }

    /// Says where on the edge of `h` the goal lies, knowing that it does.
    fn on_edge(&self, h: HalfEdgeId) -> Location {
        let [a, b] = self.ends(h);
        if a == self.goal {
            Location::Vertex(self.mesh.origin(h))
        } else if b == self.goal {
            Location::Vertex(self.mesh.dest(h))
        } else {
            Location::Edge(h)
        }
    }

    fn side(&self, h: HalfEdgeId) -> Orientation {
        let [a, b] = self.ends(h);
        orient2d(a, b, self.goal)
    }

    fn ends(&self, h: HalfEdgeId) -> [Point; 2] {
        [self.mesh.origin(h), self.mesh.dest(h)].map(|v| self.points[v.index()])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const A: Point = Point::new(0.0, 0.0);
    const B: Point = Point::new(4.0, 0.0);
    const C: Point = Point::new(0.0, 4.0);
    const D: Point = Point::new(4.0, 4.0);

    fn v(i: usize) -> VertexId {
        VertexId::new(i)
    }

    /// The square abdc with the diagonal bc.
    fn square() -> (Mesh, [Point; 4]) {
        let mut mesh = Mesh::default();
        let ab = mesh.seed(v(0), v(1));
        let [ab, ..] = mesh.split_face(ab.triangle(), v(2));
        let ghost_beyond_bc = mesh.twin(ab.next()).triangle();
        mesh.split_face(ghost_beyond_bc, v(3));
        mesh.validate().expect("a square");
        (mesh, [A, B, C, D])
    }

    /// Three collinear vertices a, b, c at 0, 1 and 3 on the line y = x.
    fn row() -> (Mesh, [Point; 3]) {
        let mut mesh = Mesh::default();
        let ab = mesh.seed(v(0), v(1));
        mesh.open_edge(ab.next(), v(2));
        (mesh, [0.0, 1.0, 3.0].map(|x| Point::new(x, x)))
    }

    /// Asks from every half-edge as hint, and checks what is named by its ends.
    fn everywhere(
        mesh: &Mesh,
        points: &[Point],
        goal: (f64, f64),
        holds: impl Fn(Location) -> bool,
    ) {
        for hint in mesh.half_edges() {
            let found = locate(mesh, points, hint, goal.into());
            assert!(holds(found), "{goal:?} from {hint:?}: {found:?}");
        }
    }

    fn joins(mesh: &Mesh, h: HalfEdgeId, a: usize, b: usize) -> bool {
        let ends = [mesh.origin(h), mesh.dest(h)];
        ends == [v(a), v(b)] || ends == [v(b), v(a)]
    }

    #[test]
    fn finds_triangles_edges_and_vertices_from_every_hint() {
        let (mesh, points) = square();
        for (i, p) in points.iter().enumerate() {
            everywhere(&mesh, &points, (*p).into(), |l| l == Location::Vertex(v(i)));
        }
        let on = |a, b| {
            let mesh = &mesh;
            move |l| matches!(l, Location::Edge(h) if joins(mesh, h, a, b))
        };
        everywhere(&mesh, &points, (2.0, 2.0), on(1, 2));
        everywhere(&mesh, &points, (1.0, 0.0), on(0, 1));
        everywhere(&mesh, &points, (4.0, 3.0), on(1, 3));
        let within = |apex| {
            let mesh = &mesh;
            move |l| matches!(l, Location::Face(t) if mesh.corners(t).contains(&v(apex)))
        };
        everywhere(&mesh, &points, (1.0, 1.0), within(0));
        everywhere(&mesh, &points, (3.0, 3.0), within(3));
    }

    #[test]
    fn finds_the_hull_edge_that_sees_the_goal() {
        let (mesh, points) = square();
        let beyond = |a, b| {
            let mesh = &mesh;
            move |l| {
                matches!(l, Location::Outside(h)
                    if mesh.origin(h) == v(a) && mesh.dest(h) == v(b) && mesh.apex(h).is_infinite())
            }
        };
        everywhere(&mesh, &points, (2.0, -1.0), beyond(1, 0));
        everywhere(&mesh, &points, (5.0, 2.0), beyond(3, 1));
        everywhere(&mesh, &points, (2.0, 5.0), beyond(2, 3));
        everywhere(&mesh, &points, (-1.0, 2.0), beyond(0, 2));
        // On the line of the hull edge ab, past b: only bd sees it.
        everywhere(&mesh, &points, (9.0, 0.0), beyond(3, 1));
    }

    #[test]
    fn walks_along_a_row() {
        let (mesh, points) = row();
        for (i, p) in points.iter().enumerate() {
            everywhere(&mesh, &points, (*p).into(), |l| l == Location::Vertex(v(i)));
        }
        let on = |a, b| {
            let mesh = &mesh;
            move |l| matches!(l, Location::Edge(h) if joins(mesh, h, a, b))
        };
        everywhere(&mesh, &points, (0.5, 0.5), on(0, 1));
        everywhere(&mesh, &points, (2.0, 2.0), on(1, 2));
        let past = |end| {
            let mesh = &mesh;
            move |l| {
                matches!(l, Location::Beyond(h)
                    if mesh.origin(h) == v(end) && mesh.dest(h).is_infinite())
            }
        };
        everywhere(&mesh, &points, (-1.0, -1.0), past(0));
        everywhere(&mesh, &points, (7.0, 7.0), past(2));
        let left = |forward: bool| {
            let mesh = &mesh;
            move |l| {
                matches!(l, Location::Outside(h)
                    if (mesh.origin(h) < mesh.dest(h)) == forward)
            }
        };
        everywhere(&mesh, &points, (0.0, 9.0), left(true));
        everywhere(&mesh, &points, (9.0, 0.0), left(false));
    }
}
