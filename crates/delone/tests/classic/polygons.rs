//! Random simple polygons with integer corners, and areas without rounding.

use delone::{Point, Pslg, VertexId};
use delone_testkit::generate::Random;
use delone_testkit::naive::distinct;

use delone::predicates::{cross_properly, is_between};

/// Makes a simple polygon with `n` distinct corners in {0, …, `size` − 1}².
pub fn simple_polygon(n: usize, size: usize, random: &mut Random) -> Vec<Point> {
    loop {
        let mut coordinate = || random.below(size) as f64;
        let corners: Vec<_> = (0..n)
            .map(|_| Point::new(coordinate(), coordinate()))
            .collect();
        if distinct(&corners).len() == n
            && let Some(polygon) = untangled(corners)
        {
            return polygon;
        }
    }
}

/// Turns parts of the polygon round until no two edges cross, which shortens it each time; none if an edge then
/// runs through a corner.
fn untangled(mut corners: Vec<Point>) -> Option<Vec<Point>> {
    let n = corners.len();
    while let Some((i, j)) = first_crossing(&corners) {
        corners[i + 1..=j].reverse();
    }
    let touches = |i: usize| {
        let [a, b] = edge(&corners, i);
        corners.iter().any(|&p| is_between(a, b, p))
    };
    (!(0..n).any(touches)).then_some(corners)
}

fn first_crossing(corners: &[Point]) -> Option<(usize, usize)> {
    let n = corners.len();
    let pairs = (0..n).flat_map(|i| (i + 1..n).map(move |j| (i, j)));
    let mut crossing = pairs.filter(|&(i, j)| cross_properly(edge(corners, i), edge(corners, j)));
    crossing.next()
}

fn edge(corners: &[Point], i: usize) -> [Point; 2] {
    [corners[i], corners[(i + 1) % corners.len()]]
}

/// A domain bounded by one ring.
pub fn ring(corners: &[Point]) -> Pslg {
    let mut pslg = Pslg::from_points(corners.iter().copied());
    pslg.add_ring((0..corners.len()).map(VertexId::new));
    pslg
}

/// Twice the area of a polygon with integer corners, positive whichever way it turns.
pub fn doubled_area(corners: &[Point]) -> i64 {
    let cross = |[a, b]: [Point; 2]| a.x as i64 * b.y as i64 - a.y as i64 * b.x as i64;
    (0..corners.len())
        .map(|i| cross(edge(corners, i)))
        .sum::<i64>()
        .abs()
}

/// Twice the sum of the areas of triangles with integer corners, each of which must turn counter-clockwise.
pub fn doubled_areas(points: &[Point], triangles: &[[VertexId; 3]]) -> i64 {
    let doubled = triangles.iter().map(|t| {
        let [a, b, c] = t.map(|v| points[v.index()]);
        let [ux, uy] = [(b.x - a.x) as i64, (b.y - a.y) as i64];
        let [vx, vy] = [(c.x - a.x) as i64, (c.y - a.y) as i64];
        let area = ux * vy - uy * vx;
        assert!(area > 0, "triangle {t:?} does not turn counter-clockwise");
        area
    });
    doubled.sum()
}
