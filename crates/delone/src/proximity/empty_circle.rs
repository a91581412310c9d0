//! The largest circle with its centre in the convex hull and no point inside (Shamos and Hoey 1975;
//! Toussaint, *Computing largest empty circles with location constraints*, 1983): where to put a depot
//! that is to be far from everyone.
//!
//! The distance to the nearest vertex has its maxima in the interior of the hull at circumcentres that lie
//! in their own triangles, which are those without an obtuse angle, and on the edges of the hull where
//! edges of the Voronoi diagram cross them. The latter are found from outside to inside: of all points of
//! a hull edge ab the one as far from a as from b is such a crossing unless the apex beyond is nearer to
//! it; then the two other sides of that triangle take the place of ab.
//!
//! *Rounded*: which triangles have no obtuse angle is decided exactly and their radii are exact up to one
//! rounding, but crossings with the hull are computed in `f64`, and so is the choice between circles that
//! are equal but for roundings. The centre is rounded in any case, and the radius is the distance from
//! there to the nearest vertex, so that the circle is empty up to the rounding of the radius itself.

use super::Proximity;
use super::ruler::Ruler;
use crate::predicates::{
    CircleSide, circumcenter, circumradius_up, compare_distances, in_diametral_circle, length_up,
};
use crate::{Error, HalfEdgeId, Point, TriangleId, VertexId};

/// A circle with no vertex inside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EmptyCircle {
    /// Its centre, rounded; in the convex hull up to that.
    pub center: Point,
    /// The distance from the centre to the nearest vertex, rounded up.
    pub radius: f64,
    /// The vertex nearest to the centre; on an exactly computed circle there are two or three.
    pub nearest: VertexId,
}

impl Proximity<'_> {
    /// Finds the largest circle with its centre in the convex hull, border included, that has no vertex
    /// inside; of several the first one found. `None` for fewer than two vertices.
    ///
    /// # Errors
    /// [`Error::Cancelled`].
    ///
    /// *Cost*: O(n).
    ///
    /// ```
    /// use delone::proximity::Proximity;
    /// let t = delone::triangulate([(0.0, 0.0), (8.0, 0.0), (8.0, 6.0), (0.0, 6.0)])?;
    /// let circle = Proximity::new(&t, &())?.largest_empty_circle()?.unwrap();
    /// assert_eq!((circle.center, circle.radius), ((4.0, 3.0).into(), 5.0));
    /// # Ok::<(), delone::Error>(())
    /// ```
    pub fn largest_empty_circle(&self) -> Result<Option<EmptyCircle>, Error> {
        let inside = self.largest_inside()?;
        let mut border = Border::new(self);
        let mesh = self.triangulation.mesh();
        let mut pace = self.pace();
        for t in mesh.ghosts() {
            border.cross(mesh.twin(mesh.hull_edge_of(t)), &mut || pace.step())?;
        }
        pace.finish();
        let circles = [inside, border.largest].into_iter().flatten();
        Ok(circles.reduce(larger))
    }

    /// Finds the largest circle around a triangle without an obtuse angle.
    fn largest_inside(&self) -> Result<Option<EmptyCircle>, Error> {
        let mut pace = self.pace();
        let mut largest: Option<(f64, TriangleId)> = None;
        let mesh = self.triangulation.mesh();
        for t in mesh.triangles() {
            pace.step()?;
            let [a, b, c] = mesh.corners(t).map(|v| self.point(v));
            if is_obtuse([a, b, c]) {
                continue;
            }
            let radius = circumradius_up(a, b, c);
            if largest.is_none_or(|(largest, _)| radius > largest) {
                largest = Some((radius, t));
            }
        }
        Ok(largest.map(|(_, t)| {
            let corners = mesh.corners(t);
            let [a, b, c] = corners.map(|v| self.point(v));
            let center = circumcenter(a, b, c).expect("bug: a triangle without area");
            self.circle_at(center, corners[0])
        }))
    }

    /// Makes the empty circle about `center`; `start` is a vertex not far from it.
    fn circle_at(&self, center: Point, start: VertexId) -> EmptyCircle {
        let nearest = self.nearest_from(start, center);
        EmptyCircle {
            center,
            radius: length_up([center, self.point(nearest)]),
            nearest,
        }
    }

    /// Walks from `start` to ever nearer neighbours; in a Delaunay triangulation that leads to the vertex
    /// nearest to `goal`.
    fn nearest_from(&self, start: VertexId, goal: Point) -> VertexId {
        let mesh = self.triangulation.mesh();
        let mut nearest = start;
        loop {
            let star = self.triangulation.star(nearest).map(|h| mesh.dest(h));
            let nearer = star
                .filter(|v| !v.is_infinite())
                .find(|&v| compare_distances(goal, self.point(v), self.point(nearest)).is_lt());
            match nearer {
                Some(v) => nearest = v,
                None => return nearest,
            }
        }
    }
}

fn is_obtuse([a, b, c]: [Point; 3]) -> bool {
    [[a, b, c], [b, c, a], [c, a, b]]
        .iter()
        .any(|&[a, b, c]| in_diametral_circle(a, b, c) == CircleSide::Inside)
}

/// The larger one of two circles, the first if they are equal.
fn larger(a: EmptyCircle, b: EmptyCircle) -> EmptyCircle {
    if b.radius > a.radius { b } else { a }
}

/// Finds where the Voronoi diagram crosses the hull.
struct Border<'p, 't> {
    proximity: &'p Proximity<'t>,
    ruler: Ruler,
    /// Triangles whose circumcentre lies beyond the hull: beyond one edge of it only.
    is_crossed: Vec<bool>,
    waiting: Vec<HalfEdgeId>,
    largest: Option<EmptyCircle>,
}

impl<'p, 't> Border<'p, 't> {
    fn new(proximity: &'p Proximity<'t>) -> Self {
        let t = &proximity.triangulation;
        Self {
            proximity,
            ruler: Ruler::new(t.points().iter().copied()),
            is_crossed: vec![false; t.mesh().num_faces()],
            waiting: Vec::new(),
            largest: None,
        }
    }

    /// Looks at the crossings with the edge of `hull`, which has the hull to its left.
    fn cross(
        &mut self,
        hull: HalfEdgeId,
        step: &mut dyn FnMut() -> Result<(), Error>,
    ) -> Result<(), Error> {
        let proximity = self.proximity;
        let line = proximity.end_points(hull);
        self.waiting.push(hull);
        while let Some(h) = self.waiting.pop() {
            step()?;
            let [p, q] = proximity.ends(h);
            let Some(crossing) = self.crossing(line, [p, q]) else {
                continue;
            };
            if self.is_cut_off(h, crossing) {
                self.is_crossed[h.triangle().index()] = true;
                let others = [h.next(), h.prev()];
                let mesh = proximity.triangulation.mesh();
                self.waiting.extend(others.map(|side| mesh.twin(side)));
            } else {
                let circle = proximity.circle_at(crossing, p);
                self.largest = Some(self.largest.map_or(circle, |old| larger(old, circle)));
            }
        }
        Ok(())
    }

    /// Tells whether the apex of `h` is nearer to the crossing of its Voronoi edge with the hull than its
    /// ends are, for the first time.
    fn is_cut_off(&self, h: HalfEdgeId, crossing: Point) -> bool {
        let proximity = self.proximity;
        let mesh = proximity.triangulation.mesh();
        let apex = mesh.apex(h);
        if apex.is_infinite() || self.is_crossed[h.triangle().index()] {
            return false;
        }
        let [apex, p] = [apex, mesh.origin(h)].map(|v| proximity.point(v));
        compare_distances(crossing, apex, p).is_lt()
    }

    /// Finds the point of the hull edge `ab` that is as far from `p` as from `q`, rounded; `None` if there
    /// is none, which happens only by rounding.
    fn crossing(&self, [a, b]: [Point; 2], ends: [VertexId; 2]) -> Option<Point> {
        let along = self.ruler.vector(a, b);
        let [p, q] = ends.map(|v| self.ruler.vector(a, self.proximity.point(v)));
        let dot = |u: [f64; 2], v: [f64; 2]| u[0] * v[0] + u[1] * v[1];
        let between = [q[0] - p[0], q[1] - p[1]];
        let sum = [q[0] + p[0], q[1] + p[1]];
        // |q|² − |p|² as a product, which loses less.
        let t = 0.5 * dot(sum, between) / dot(between, along);
        let is_on_edge = (0.0..=1.0).contains(&t);
        is_on_edge.then(|| self.ruler.moved(a, along.map(|c| t * c)))
    }
}
