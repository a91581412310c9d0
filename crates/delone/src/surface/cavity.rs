//! The cavity of a point that is not inserted: the triangles that it would destroy, and their rim.

use super::Ground;
use crate::predicates::in_circle_perturbed;
use crate::{HalfEdgeId, Point, TriangleId, VertexId};

/// The triangles whose circles hold a point that sees them, and what bounds them.
///
/// ```text
///       v2 ───────── v1      rim: v0 v1 v2 v3, counter-clockwise; of edge i, from v(i) to v(i + 1),
///        │ \   T0   │       triangle `inner` is the one inside of it: T0, T0, T1, T1
///        │    \  p  │       link: the edge within, between v0 and v2, T0 to one side and T1 to
///        │  T1   \  │       the other
///       v3 ───────── v0
/// ```
#[derive(Clone, Debug, Default)]
pub(super) struct Cavity {
    pub triangles: Vec<TriangleId>,
    pub rim: Vec<Rim>,
    pub links: Vec<Link>,
    tasks: Vec<Task>,
}

/// A vertex of the rim and the edge that leaves it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rim {
    pub vertex: VertexId,
    /// The triangle inside of the edge, as an index of the cavity's.
    pub inner: usize,
}

/// An edge within the cavity.
#[derive(Clone, Copy, Debug)]
pub(super) struct Link {
    /// Its ends, as indices of the rim.
    pub ends: [usize; 2],
    /// The triangles to its left and right, as indices of the cavity's.
    pub sides: [usize; 2],
}

#[derive(Clone, Copy, Debug)]
enum Task {
    /// Look beyond this edge of the cavity's triangle.
    Cross(HalfEdgeId, usize),
    /// All beyond this link has been walked around.
    Close(usize),
}

impl Cavity {
    /// Digs for `p`, which lies in the interior of triangle `first` or of an edge of it that is no wall.
    ///
    /// A depth-first search that goes counter-clockwise around the cavity meets its rim in order; no
    /// triangle is met twice, since a cavity holds no vertex. Walls are not crossed.
    ///
    /// *Cost*: one in-circle test for each edge of the cavity.
    pub fn dig(&mut self, ground: &Ground<'_>, p: Point, first: TriangleId) {
        self.triangles.clear();
        self.rim.clear();
        self.links.clear();
        self.triangles.push(first);
        let [a, b, c] = first.half_edges().map(|h| Task::Cross(h, 0));
        self.tasks.extend([c, b, a]);
        while let Some(task) = self.tasks.pop() {
            match task {
                Task::Cross(h, inner) => self.look(ground, p, h, inner),
                Task::Close(link) => self.links[link].ends[1] = self.rim.len(),
            }
        }
        let n = self.rim.len();
        for link in &mut self.links {
            link.ends[1] %= n;
        }
    }

    /// Takes the triangle beyond `h` in, or makes `h` part of the rim.
    #[inline]
    fn look(&mut self, ground: &Ground<'_>, p: Point, h: HalfEdgeId, inner: usize) {
        let beyond = ground.mesh().twin(h);
        if ground.is_wall(h) || !is_in_circle(ground, beyond.triangle(), p) {
            self.rim.push(Rim {
                vertex: ground.mesh().origin(h),
                inner,
            });
            return;
        }
        let outer = self.triangles.len();
        self.triangles.push(beyond.triangle());
        self.tasks.extend([
            Task::Close(self.links.len()),
            Task::Cross(beyond.prev(), outer),
            Task::Cross(beyond.next(), outer),
        ]);
        self.links.push(Link {
            ends: [self.rim.len(); 2],
            sides: [inner, outer],
        });
    }
}

#[inline]
fn is_in_circle(ground: &Ground<'_>, t: TriangleId, p: Point) -> bool {
    let [a, b, c] = ground.corners(t);
    in_circle_perturbed(a, b, c, p)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Delaunay;

    #[test]
    fn the_rim_goes_around_counter_clockwise_and_links_join_its_vertices() {
        let points = [
            (0., 0.),
            (4., -1.),
            (7., 2.),
            (5., 5.),
            (1., 4.),
            (-2., 2.),
            (3., 9.),
        ];
        let t = Delaunay::new()
            .triangulate(points.map(Point::from))
            .expect("a triangulation");
        let ground = Ground::from(&t);
        let p = Point::new(2.5, 2.0);
        let place = ground.place(p, &mut TriangleId::new(0)).expect("inside");
        let mut cavity = Cavity::default();
        cavity.dig(&ground, p, place.triangle);
        let n = cavity.rim.len();
        assert_eq!(n, cavity.triangles.len() + 2);
        assert_eq!(n, cavity.links.len() + 3);
        for i in 0..n {
            let [a, b] = [i, (i + 1) % n].map(|i| t.point(cavity.rim[i].vertex));
            let side = crate::predicates::orient2d(a, b, p);
            assert_eq!(side, crate::predicates::Orientation::Left);
        }
        for link in &cavity.links {
            for side in link.sides {
                let corners = t.mesh().corners(cavity.triangles[side]);
                let holds = |i: usize| corners.contains(&cavity.rim[i].vertex);
                assert!(link.ends.into_iter().all(holds));
            }
        }
    }
}
