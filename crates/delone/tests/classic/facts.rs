//! What the lecture says of triangulations and of Delaunay triangulations, counted and compared exactly.

use super::small::{self, Small};
use super::suite;
use delone::classic::{Algorithm, Input};
use delone::predicates::{CircleSide, Orientation, cross_properly, in_circle, in_circle_perturbed};
use delone::predicates::{is_between, orient2d};
use delone::{Point, VertexId, triangulate};
use delone_testkit::generate::Kind;
use delone_testkit::naive::distinct;
use std::cmp::Ordering;
use std::collections::BTreeSet;

fn samples() -> impl Iterator<Item = Vec<Point>> {
    let kinds = Kind::ALL.into_iter().enumerate();
    kinds.flat_map(|(i, kind)| [5, 30].map(|n| kind.points(n, i as u64 + 50)))
}

/// The triangles and the edges that an algorithm has drawn in the end.
fn drawn(points: &[Point]) -> (usize, BTreeSet<[VertexId; 2]>) {
    let input = Input::from_points(points.iter().copied());
    let (output, log) = suite::run(Algorithm::Incremental, &input);
    let scene = log.last_scene().expect("can be played");
    (output.triangles.len(), scene.edges().collect())
}

#[test]
fn euler_counts_vertices_edges_and_faces() {
    for points in samples() {
        let (triangles, edges) = drawn(&points);
        let (v, e, f) = (distinct(&points).len(), edges.len(), triangles + 1);
        let c = usize::from(v > 0);
        assert_eq!(v + f, e + c + 1);
        if v >= 3 {
            assert!(e <= 3 * v - 6 || triangles == 0 && e == v - 1);
            assert!(f <= 2 * v - 4 || triangles <= 1);
        }
        let t = triangulate(points.iter().copied()).expect("finite");
        if triangles > 0 {
            // h counts all vertices on the boundary, those amid its straight parts, too.
            let h = t.mesh().ghosts().count();
            assert_eq!((triangles, e), (2 * v - 2 - h, 3 * v - 3 - h));
        }
    }
}

#[test]
fn edges_are_those_with_an_empty_circle_and_never_cross() {
    for points in samples() {
        let (_, edges) = drawn(&points);
        let vertices = distinct(&points);
        let mut expected = BTreeSet::new();
        for (i, &u) in vertices.iter().enumerate() {
            for &v in &vertices[i + 1..] {
                if has_empty_circle(&points, &vertices, [u, v]) {
                    expected.insert([u, v].map(VertexId::new));
                }
            }
        }
        assert_eq!(edges, expected, "{points:?}");
        let edges: Vec<_> = edges.iter().map(|e| e.map(|v| points[v.index()])).collect();
        for (i, &s) in edges.iter().enumerate() {
            assert!(!edges[..i].iter().any(|&t| cross_properly(s, t)));
        }
    }
}

/// Tells whether some circle through both ends is empty, ties decided by the perturbation.
///
/// The circles through u and v are a family in one parameter: a point on the left bounds it from one side, one on
/// the right from the other. So there is a circle for all if there is one for each pair of them.
fn has_empty_circle(points: &[Point], vertices: &[usize], ends: [usize; 2]) -> bool {
    let [u, v] = ends.map(|i| points[i]);
    let mut sides = [Vec::new(), Vec::new()];
    for &i in vertices.iter().filter(|i| !ends.contains(i)) {
        match orient2d(u, v, points[i]) {
            Orientation::Left => sides[0].push(points[i]),
            Orientation::Right => sides[1].push(points[i]),
            Orientation::Collinear if is_between(u, v, points[i]) => return false,
            Orientation::Collinear => {}
        }
    }
    let [left, right] = sides;
    let mut pairs = left
        .iter()
        .flat_map(|&l| right.iter().map(move |&r| (l, r)));
    pairs.all(|(l, r)| !in_circle_perturbed(u, v, l, r))
}

/// The angle between two vectors, of small integers, for exact comparisons: its cotangent is `dot / cross`.
#[derive(Clone, Copy, Debug)]
struct ExactAngle {
    dot: i128,
    cross: i128,
}

impl ExactAngle {
    fn at([p, q, r]: [Point; 3]) -> Self {
        let vector = |to: Point| [(to.x - p.x) as i128, (to.y - p.y) as i128];
        let [[a, b], [c, d]] = [vector(q), vector(r)];
        Self {
            dot: a * c + b * d,
            cross: a * d - b * c,
        }
    }
}

impl Ord for ExactAngle {
    fn cmp(&self, other: &Self) -> Ordering {
        (other.dot * self.cross).cmp(&(self.dot * other.cross))
    }
}

impl PartialOrd for ExactAngle {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for ExactAngle {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for ExactAngle {}

/// All angles of a triangulation, ascending.
fn angles(t: &Small) -> Vec<ExactAngle> {
    let corners = t
        .triangles()
        .flat_map(|[a, b, c]| [[a, b, c], [b, c, a], [c, a, b]]);
    let mut angles: Vec<_> = corners
        .map(|corner| ExactAngle::at(corner.map(|v| t.points[v])))
        .collect();
    angles.sort();
    angles
}

/// Tells whether no point lies strictly inside a circle, ties on circles allowed.
fn is_delaunay(t: &Small) -> bool {
    t.triangles().all(|corners| {
        let [a, b, c] = corners.map(|v| t.points[v]);
        let mut others = t.points.iter();
        others.all(|&p| in_circle(a, b, c, p) != CircleSide::Inside)
    })
}

#[test]
fn the_angles_of_delaunay_triangulations_are_the_largest() {
    for points in small::sets() {
        let all = small::all_triangulations(&points);
        let delaunay = angles(&Small::delaunay(&points));
        let best = all.iter().max_by_key(|t| angles(t)).expect("one at least");
        assert!(is_delaunay(best), "{points:?}");
        // Cocircular points leave a choice, which changes the vector, but not the smallest angle.
        assert_eq!(angles(best).first(), delaunay.first());
        if all.iter().filter(|t| is_delaunay(t)).count() == 1 {
            assert_eq!(angles(best), delaunay);
        }
    }
}
