//! What a surface lies over: the triangles of a triangulation or of a domain; and where a point lies
//! on it.
//!
//! Location walks through the whole mesh, what was carved away included, so holes and notches are no
//! obstacle. A constrained triangulation may lead a walk that always takes the first separating edge
//! in circles; here a pseudo-random bit decides which edge is looked at first, and the walk ends
//! (Devillers, Pion and Teillaud, *Walking in a triangulation*, 2002: the remembering stochastic
//! walk). What is found does not depend on the bits, nor on where the walk begins.

use crate::mesh::Mesh;
use crate::predicates::{Orientation, orient2d};
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

    /// Finds where a point lies, walking from `near`, or from anywhere if that is no triangle; then
    /// `near` is where the walk ended. `None` is outside.
    ///
    /// *Cost*: a few orientation tests for every triangle walked through.
    pub(super) fn place(&self, goal: Point, near: &mut TriangleId) -> Option<Place> {
        if self.triangulation.num_triangles() == 0 || !goal.is_finite() {
            return None;
        }
        let mesh = self.mesh();
        if near.index() >= mesh.num_faces() || mesh.is_ghost(*near) {
            *near = TriangleId::new(0);
        }
        let touched = self.walk(goal, near)?;
        self.on_ground(*near, touched)
    }

    /// Walks to a face that holds `goal`; returns those of its edges that touch it.
    fn walk(&self, goal: Point, near: &mut TriangleId) -> Option<[Option<HalfEdgeId>; 2]> {
        let mut step = self.step(&near.half_edges(), goal);
        let mut dice = 1_u32;
        loop {
            let h = match step {
                Step::Arrived(touched) => return Some(touched),
                Step::Through(h) => h,
            };
            let entered = self.mesh().twin(h);
            if self.mesh().apex(entered).is_infinite() {
                return None;
            }
            *near = entered.triangle();
            // The constants of a well-known linear congruential generator; its high bit is good.
            dice = dice.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
            step = match dice >> 31 {
                0 => self.step(&[entered.next(), entered.prev()], goal),
                _ => self.step(&[entered.prev(), entered.next()], goal),
            };
        }
    }

    /// Decides by some edges of one face; `goal` is strictly left of those left out.
    #[inline]
    fn step(&self, half_edges: &[HalfEdgeId], goal: Point) -> Step {
        let points = self.triangulation.points();
        let mut touched = [None; 2];
        for &h in half_edges {
            let [a, b] = [self.mesh().origin(h), self.mesh().dest(h)].map(|v| points[v.index()]);
            match orient2d(a, b, goal) {
                Orientation::Right => return Step::Through(h),
                Orientation::Collinear => touched = [Some(h), touched[0]],
                Orientation::Left => {}
            }
        }
        Step::Arrived(touched)
    }

    /// Names the place in face `t` on the edges `touched`, the same from whichever face it was found.
    fn on_ground(&self, t: TriangleId, touched: [Option<HalfEdgeId>; 2]) -> Option<Place> {
        match touched {
            [None, _] => self.has(t).then_some(Place {
                spot: Spot::Face,
                triangle: t,
            }),
            [Some(h), None] => {
                let sides = [h, self.mesh().twin(h)];
                let inside = sides.into_iter().filter(|h| self.has(h.triangle()));
                let h = inside.min()?;
                Some(Place {
                    spot: Spot::Edge(h),
                    triangle: h.triangle(),
                })
            }
            [Some(g), Some(h)] => {
                let from = if h.next() == g { g } else { h };
                let around = self.mesh().star(from).map(HalfEdgeId::triangle);
                Some(Place {
                    spot: Spot::Vertex(self.mesh().origin(from)),
                    triangle: around.filter(|&t| self.has(t)).min()?,
                })
            }
        }
    }
}

enum Step {
    /// In this face, on these of its edges.
    Arrived([Option<HalfEdgeId>; 2]),
    Through(HalfEdgeId),
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
