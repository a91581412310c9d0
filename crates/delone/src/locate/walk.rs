//! Walks from face to face towards a goal.
//!
//! First the visibility walk: through an edge that separates the triangle from the goal. It remembers
//! where it came in, so each triangle costs one new vertex and one or two signs. In a Delaunay
//! triangulation, and under the symbolic perturbation in a regular one, "lies in front of, seen from the
//! goal" has no cycle, so the walk ends whichever separating edge it takes (Edelsbrunner, *An acyclicity
//! theorem for cell complexes in d dimensions*, 1990; Devillers, Pion and Teillaud, *Walking in a
//! triangulation*, 2002). It takes the first one counter-clockwise from where it came in: no random
//! numbers, so the same question has the same answer.
//!
//! In a triangulation that is not Delaunay it may run in circles. So after [`PATIENCE`] triangles the
//! straight walk takes over, along the segment from a corner of the triangle to the goal, which comes
//! nearer to its end with each step in any triangulation of the convex hull.
//!
//! Every sign is exact.

use super::Location;
use crate::predicates::{Orientation, orient2d};
use crate::{HalfEdgeId, Mesh, Point, VertexId};

/// Triangles that the visibility walk may take: more than any walk from a hint nearby needs.
const PATIENCE: usize = 256;

/// Finds where `goal` lies, walking from the face of `hint`.
///
/// `points[v]` is the position of vertex `v`; the mesh must triangulate their convex hull, and have at
/// least two vertices. Faces carved out of it are like all others. [`Locator`](super::Locator) knows them,
/// and needs no hint.
///
/// # Panics
/// If `hint` is no half-edge of the mesh.
///
/// *Cost*: one or two orientation tests for every triangle walked through: about √n of them for
/// evenly spread points and an arbitrary hint, a few for a hint nearby, n at worst.
pub fn locate(mesh: &Mesh, points: &[Point], hint: HalfEdgeId, goal: Point) -> Location {
    let walk = Walk { mesh, points, goal };
    match inner(mesh, hint) {
        Some(start) => walk.through_triangles(start).0,
        None => walk.beside_row(mesh.hull_edge_of(hint.triangle())),
    }
}

/// Returns `h`, or for a ghost a half-edge of the triangle at its finite edge; `None` in a row.
pub(super) fn inner(mesh: &Mesh, h: HalfEdgeId) -> Option<HalfEdgeId> {
    if !mesh.is_ghost(h.triangle()) {
        return Some(h);
    }
    let inner = mesh.twin(mesh.hull_edge_of(h.triangle()));
    (!mesh.is_ghost(inner.triangle())).then_some(inner)
}

/// A walk towards one goal.
pub(super) struct Walk<'a> {
    pub mesh: &'a Mesh,
    pub points: &'a [Point],
    pub goal: Point,
}

/// Where a walk ended, and a half-edge of the last finite face on its way.
type Arrival = (Location, HalfEdgeId);

impl Walk<'_> {
    /// Walks from the triangle of `start`.
    #[inline]
    pub fn through_triangles(&self, start: HalfEdgeId) -> Arrival {
        let [a, b] = self.ends(start);
        match orient2d(a, b, self.goal) {
            Orientation::Left => self.visibly(start, a, b),
            Orientation::Right => self.visibly(self.mesh.twin(start), b, a),
            Orientation::Collinear => self.beginning_on_line(start),
        }
    }

    /// The visibility walk from the face of `h`, which runs from `a` to `b` and has the goal strictly left.
    ///
    /// ```text
    ///          w          If the goal lies beyond bw, the next h is its twin, which runs w → b;
    ///         / \         if it lies beyond wa, the next h runs a → w.
    ///        /   \
    ///       a --h→ b
    /// ```
    #[inline]
    fn visibly(&self, mut h: HalfEdgeId, mut a: Point, mut b: Point) -> Arrival {
        use Orientation::{Collinear, Left, Right};
        for _ in 0..PATIENCE {
            let w = self.mesh.apex(h);
            if w.is_infinite() {
                return (Location::Outside(h), self.mesh.twin(h));
            }
            let apex = self.points[w.index()];
            let over_next = orient2d(b, apex, self.goal);
            if over_next == Right {
                h = self.mesh.twin(h.next());
                a = apex;
                continue;
            }
            let over_prev = orient2d(apex, a, self.goal);
            if over_prev == Right {
                h = self.mesh.twin(h.prev());
                b = apex;
                continue;
            }
            let location = match [over_next, over_prev] {
                [Collinear, Collinear] => Location::Vertex(w),
                [Collinear, _] => Location::Edge(h.next()),
                [_, Collinear] => Location::Edge(h.prev()),
                [Left | Right, _] => Location::Face(h.triangle()),
            };
            return (location, h);
        }
        match inner(self.mesh, h) {
            Some(h) => self.straight(h),
            None => unreachable!("bug: a row has no triangles to walk through"),
        }
    }

    /// As [`through_triangles`](Self::through_triangles), for a goal on the line of `start`.
    #[cold]
    fn beginning_on_line(&self, start: HalfEdgeId) -> Arrival {
        let others = [start.next(), start.prev()];
        for h in others {
            let [a, b] = self.ends(h);
            if orient2d(a, b, self.goal) == Orientation::Right {
                return self.visibly(self.mesh.twin(h), b, a);
            }
        }
        (self.on_edge(start), start)
    }

    /// The straight walk from the origin of `h`, a finite vertex.
    #[cold]
    fn straight(&self, h: HalfEdgeId) -> Arrival {
        let (location, last) = self.straight_through(h);
        // The walk may have gone along the hull, on its outer side.
        (location, inner(self.mesh, last).unwrap_or(last))
    }

    fn straight_through(&self, mut h: HalfEdgeId) -> Arrival {
        loop {
            if self.ends_at(self.mesh.origin(h)) {
                return (Location::Vertex(self.mesh.origin(h)), h);
            }
            h = match self.ahead(h) {
                Ahead::Outside(ghost) => {
                    return (Location::Outside(ghost), ghost);
                }
                Ahead::Along(g) => match self.is_within(g) {
                    true => return (Location::Edge(g), g),
                    false => g.next(),
                },
                Ahead::Across(exit) => match self.across(h, exit) {
                    Ok(arrival) => return arrival,
                    Err(beyond) => beyond,
                },
            };
        }
    }

    /// Looks from the origin of `h` towards the goal, which lies elsewhere.
    fn ahead(&self, h: HalfEdgeId) -> Ahead {
        let mesh = self.mesh;
        let from = self.point(mesh.origin(h));
        let mut ghost = None;
        for g in mesh.star(h) {
            if mesh.dest(g).is_infinite() {
                continue;
            }
            let side = |v| orient2d(from, self.point(v), self.goal);
            let right = side(mesh.dest(g));
            if right == Orientation::Collinear {
                let to = self.point(mesh.dest(g));
                if from.lex_cmp(&to) == from.lex_cmp(&self.goal) {
                    return Ahead::Along(g);
                }
            }
            let mut sides = [g, mesh.twin(g)].into_iter();
            ghost = ghost.or(sides.find(|&g| self.is_hull_edge_in_sight(g)));
            let apex = mesh.apex(g);
            if !apex.is_infinite() && right == Orientation::Left && side(apex) == Orientation::Right
            {
                return Ahead::Across(g.next());
            }
        }
        // A point outside the convex hull that no triangle here leads to sees an edge of the hull here.
        Ahead::Outside(ghost.expect("bug: the mesh does not cover its convex hull"))
    }

    /// Tells whether `h` is the finite half-edge of a ghost and sees the goal.
    fn is_hull_edge_in_sight(&self, h: HalfEdgeId) -> bool {
        self.mesh.apex(h).is_infinite() && self.side(h) == Orientation::Left
    }

    /// Goes straight from the origin of `from` through the face of `exit` towards that half-edge, and on: the
    /// end of the walk, or a half-edge that starts at a vertex on the way.
    fn across(&self, from: HalfEdgeId, mut exit: HalfEdgeId) -> Result<Arrival, HalfEdgeId> {
        let start = self.point(self.mesh.origin(from));
        loop {
            match self.side(exit) {
                Orientation::Left => return Ok((Location::Face(exit.triangle()), exit)),
                Orientation::Collinear => return Ok((Location::Edge(exit), exit)),
                Orientation::Right => {}
            }
            let entry = self.mesh.twin(exit);
            let w = self.mesh.apex(entry);
            if w.is_infinite() {
                return Ok((Location::Outside(entry), exit));
            }
            let turn = self.point(w);
            exit = match orient2d(start, self.goal, turn) {
                Orientation::Left => entry.next(),
                Orientation::Right => entry.prev(),
                Orientation::Collinear if start.lex_cmp(&self.goal) == self.goal.lex_cmp(&turn) => {
                    return Ok((Location::Face(entry.triangle()), entry));
                }
                Orientation::Collinear => return Err(entry.prev()),
            };
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
        let ends = [self.mesh.origin(h), self.mesh.dest(h)];
        let vertex = ends.into_iter().find(|&v| self.ends_at(v));
        vertex.map_or(Location::Edge(h), Location::Vertex)
    }

    /// Tells whether the goal, on the line of `h` and not at its origin, lies in its open segment.
    fn is_within(&self, h: HalfEdgeId) -> bool {
        let [a, b] = self.ends(h);
        a.lex_cmp(&self.goal) == self.goal.lex_cmp(&b)
    }

    fn ends_at(&self, v: VertexId) -> bool {
        self.point(v) == self.goal
    }

    fn side(&self, h: HalfEdgeId) -> Orientation {
        let [a, b] = self.ends(h);
        orient2d(a, b, self.goal)
    }

    fn ends(&self, h: HalfEdgeId) -> [Point; 2] {
        [self.mesh.origin(h), self.mesh.dest(h)].map(|v| self.point(v))
    }

    fn point(&self, v: VertexId) -> Point {
        self.points[v.index()]
    }
}

/// How the segment from a vertex to the goal begins.
enum Ahead {
    /// Outside the convex hull; this half-edge of a ghost sees the goal.
    Outside(HalfEdgeId),
    /// Along this edge.
    Along(HalfEdgeId),
    /// Through the triangle of this half-edge, which lies opposite the vertex.
    Across(HalfEdgeId),
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

    /// The straight walk says what the visibility walk says, from every corner.
    #[test]
    fn walks_straight_from_every_corner() {
        let mut points = vec![Point::new(0.0, 0.0)];
        points
            .extend([(6.0, 0.0), (6.0, 6.0), (0.0, 6.0), (3.0, 3.0), (2.0, 2.0)].map(Point::from));
        points.extend([(3.0, 0.0), (1.0, 4.0), (5.0, 2.0)].map(Point::from));
        let t = crate::triangulate(points.iter().copied()).unwrap();
        let mesh = t.mesh();
        let goals = (-2..=16).flat_map(|x| {
            (-2..=16).map(move |y| Point::new(f64::from(x) / 2.0, f64::from(y) / 2.0))
        });
        for goal in goals {
            let walk = Walk {
                mesh,
                points: &points,
                goal,
            };
            let finite = |&h: &HalfEdgeId| !mesh.is_ghost(h.triangle());
            for h in mesh.half_edges().filter(finite) {
                let same = |h: HalfEdgeId| h.min(mesh.twin(h));
                match (walk.straight(h).0, walk.through_triangles(h).0) {
                    (Location::Edge(g), Location::Edge(h)) => assert_eq!(same(g), same(h)),
                    (Location::Outside(g), Location::Outside(_)) => {
                        assert!(walk.is_hull_edge_in_sight(g))
                    }
                    (straight, visibly) => assert_eq!(straight, visibly, "{goal:?} from {h:?}"),
                }
            }
        }
    }

    /// Follows the rule of the visibility walk for so many steps; tells whether it arrives.
    fn arrives(mesh: &Mesh, points: &[Point], mut h: HalfEdgeId, goal: Point) -> bool {
        let walk = Walk { mesh, points, goal };
        for _ in 0..10_000 {
            let crossed = [h.next(), h.prev()]
                .into_iter()
                .find(|&h| walk.side(h) == Orientation::Right);
            match crossed {
                Some(crossed) => h = mesh.twin(crossed),
                None => return true,
            }
            if mesh.apex(h).is_infinite() {
                return true;
            }
        }
        false
    }

    /// Two squares, the outer one turned so far that every spoke between them, seen inwards, passes the
    /// centre on its left: a visibility walk goes round and round. The spokes are segments, or they would
    /// be flipped.
    #[test]
    fn ends_where_the_visibility_walk_goes_round_in_circles() {
        let inner = [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)];
        let outer = inner.map(|(x, y)| (-x - 4.0 * y, 4.0 * x - y));
        let mut pslg = crate::Pslg::from_points(inner.into_iter().chain(outer));
        for i in 0..4 {
            pslg.add_segment(i, i + 4);
            pslg.add_segment((i + 1) % 4, i + 4);
        }
        let t = crate::ConstrainedDelaunay::new().triangulate(pslg).unwrap();
        let t = t.into_triangulation();
        let (mesh, points) = (t.mesh(), t.points());
        let goal = Point::new(0.125, 0.0625);
        let is_finite = |h: &HalfEdgeId| !mesh.is_ghost(h.triangle());
        let mut inside = mesh.half_edges().filter(is_finite);
        assert!(
            inside.any(|h| !arrives(mesh, points, h, goal)),
            "it proves nothing"
        );
        let answers = mesh.half_edges().map(|h| locate(mesh, points, h, goal));
        let answers: std::collections::HashSet<_> = answers.collect();
        assert_eq!(answers.len(), 1);
        assert!(matches!(answers.iter().next(), Some(Location::Face(_))));
    }
}
