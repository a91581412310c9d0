//! The straight walk through triangles, whatever they are: it needs neither a hull nor the Delaunay property.
//!
//! It goes from inside the first triangle along a segment to the goal. A vertex on the segment counts as lying to
//! its left, as if the segment were moved to the right by less than anything: so the walk always leaves a triangle
//! through one edge, and comes nearer to the goal with each step. It ends where the goal is, or where there is no
//! triangle beyond. (The walk of `delone::locate` needs a mesh that covers its convex hull.)
//!
//! O. Devillers, S. Pion and M. Teillaud, *Walking in a triangulation* (2002).

use super::holds;
use delone::predicates::{Orientation, orient2d};
use delone::{Point, VertexId};

/// Which triangle is beyond which edge.
pub(super) struct Ways {
    corners: Vec<[VertexId; 3]>,
    /// For each vertex where its triangles begin among `triangles`, and the end of the last.
    starts: Vec<u32>,
    triangles: Vec<u32>,
}

/// An edge of a triangle, which lies to its left: its ends, and where they are.
type Side = [(VertexId, Point); 2];

impl Ways {
    /// Lists the triangles around each vertex. *Cost*: linear; 12 bytes a triangle and 4 a vertex.
    pub fn of(vertices: usize, corners: Vec<[VertexId; 3]>) -> Self {
        let known = || {
            let numbered = (0..).zip(&corners);
            let named = numbered.flat_map(|(t, corners)| corners.map(|v| (t, v.index())));
            named.filter(move |&(_, v)| v < vertices)
        };
        let mut starts = vec![0; vertices + 2];
        known().for_each(|(_, v)| starts[v + 2] += 1);
        for v in 2..starts.len() {
            starts[v] += starts[v - 1];
        }
        let mut triangles = vec![0; starts[vertices + 1] as usize];
        for (t, v) in known() {
            // So the start of the next vertex comes to where it belongs.
            triangles[starts[v + 1] as usize] = t;
            starts[v + 1] += 1;
        }
        Self {
            corners,
            starts,
            triangles,
        }
    }

    /// Walks from the first triangle that has its centroid, as rounded, inside, and lists the triangles on the way.
    pub fn walk(&self, places: &[[Point; 3]], goal: Point) -> Vec<u32> {
        let inside = (0..).zip(places).find_map(|(t, &corners)| {
            let center = centroid(corners);
            is_strictly_inside(corners, center).then_some((t, center))
        });
        let Some((mut t, start)) = inside else {
            return Vec::new();
        };
        let mut way = vec![t];
        if holds(places[t as usize], goal) {
            return way;
        }
        let is_left = |p: Point| orient2d(start, goal, p) != Orientation::Right;
        let sides = sides(self.corners[t as usize], places[t as usize]);
        let mut exit = sides
            .into_iter()
            .find(|[u, v]| !is_left(u.1) && is_left(v.1));
        // Triangles that lie upon each other might lead in circles.
        while let Some([u, v]) = exit
            && way.len() < places.len()
            && orient2d(u.1, v.1, goal) == Orientation::Right
        {
            let Some((beyond, k)) = self.beyond([u.0, v.0]) else {
                break;
            };
            t = beyond;
            way.push(t);
            let w = (self.corners[t as usize][k], places[t as usize][k]);
            exit = Some(if is_left(w.1) { [u, w] } else { [w, v] });
        }
        way
    }

    /// Finds the triangle to the right of an edge, and which of its corners is opposite.
    fn beyond(&self, [u, v]: [VertexId; 2]) -> Option<(u32, usize)> {
        let [from, to] = [0, 1].map(|i| self.starts.get(v.index() + i));
        let around = &self.triangles[*from? as usize..*to? as usize];
        around.iter().find_map(|&t| {
            let corners = self.corners[t as usize];
            let opposite = |&k: &usize| corners[(k + 1) % 3] == v && corners[(k + 2) % 3] == u;
            (0..3).find(opposite).map(|k| (t, k))
        })
    }
}

fn sides([a, b, c]: [VertexId; 3], [p, q, r]: [Point; 3]) -> [Side; 3] {
    let [a, b, c] = [(a, p), (b, q), (c, r)];
    [[a, b], [b, c], [c, a]]
}

/// Returns the centroid, rounded; divided first, so that it is a number.
fn centroid(corners: [Point; 3]) -> Point {
    let mean = |c: fn(Point) -> f64| corners.iter().map(|&p| c(p) / 3.0).sum();
    Point::new(mean(|p| p.x), mean(|p| p.y))
}

fn is_strictly_inside([a, b, c]: [Point; 3], p: Point) -> bool {
    let sides = [[a, b], [b, c], [c, a]];
    sides
        .iter()
        .all(|&[a, b]| orient2d(a, b, p) == Orientation::Left)
}
