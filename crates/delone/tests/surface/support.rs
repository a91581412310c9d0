//! Points, values and small tools.

use delone::surface::Samples;
use delone::{
    ConstrainedDelaunay, ConstrainedTriangulation, DomainRule, Point, Pslg, Triangulation,
};
use delone_testkit::generate::{Kind, Random};

/// Triangulates points of a kind.
pub fn triangulated(kind: Kind, n: usize, seed: u64) -> Triangulation {
    delone::triangulate(kind.points(n, seed)).expect("finite points")
}

/// Gives every point the value of a function there.
pub fn sampled(t: &Triangulation, f: impl Fn(Point) -> f64) -> Samples<'_> {
    let values: Vec<f64> = t.points().iter().map(|&p| f(p)).collect();
    Samples::new(t, values).expect("finite values")
}

/// A linear function.
pub fn plane(p: Point) -> f64 {
    3.0 + 2.0 * p.x - 0.5 * p.y
}

/// Points in the box of the triangulation, some of them on its edges and vertices.
pub fn questions(t: &Triangulation, n: usize, seed: u64) -> Vec<Point> {
    let mut random = Random::new(seed);
    let points = t.points();
    let at = |r: &mut Random| points[r.below(points.len())];
    let middle = |a: f64, b: f64| a * 0.5 + b * 0.5;
    let mut question = |i: usize| {
        let (a, b, c) = (at(&mut random), at(&mut random), at(&mut random));
        let ab = Point::new(middle(a.x, b.x), middle(a.y, b.y));
        match i % 4 {
            0 => a,
            1 => ab,
            2 => Point::new(middle(ab.x, c.x), middle(ab.y, c.y)),
            _ => {
                let s = random.unit();
                let along = |a: f64, b: f64| a * (1.0 - s) + b * s;
                Point::new(along(ab.x, c.x), along(ab.y, c.y))
            }
        }
    };
    (0..n).map(&mut question).collect()
}

/// Scattered points within a square with a hole and two walls, one of which ends in the middle.
pub fn domain(n: usize, seed: u64) -> ConstrainedTriangulation {
    let mut random = Random::new(seed);
    let corners = [(0., 0.), (12., 0.), (12., 12.), (0., 12.)];
    let hole = [(3., 3.), (5., 3.), (5., 5.), (3., 5.)];
    let walls = [(0., 8.), (7., 8.5), (8., 1.), (8., 6.)];
    let mut points: Vec<(f64, f64)> = corners.into_iter().chain(hole).chain(walls).collect();
    points.extend((0..n).map(|_| (random.unit() * 12.0, random.unit() * 12.0)));
    let mut pslg = Pslg::from_points(points);
    pslg.add_ring([0, 1, 2, 3]);
    pslg.add_ring([4, 5, 6, 7]);
    pslg.add_segment(8, 9);
    pslg.add_segment(10, 11);
    pslg.holes.push(Point::new(4.0, 4.0));
    let rule = ConstrainedDelaunay::new().domain(DomainRule::Carve);
    rule.triangulate(pslg).expect("a domain")
}

/// Franke's function.
pub fn franke(p: Point) -> f64 {
    let (x, y) = (9.0 * p.x, 9.0 * p.y);
    let sq = |v: f64| v * v;
    0.75 * (-(sq(x - 2.0) + sq(y - 2.0)) / 4.0).exp()
        + 0.75 * (-sq(x + 1.0) / 49.0 - (y + 1.0) / 10.0).exp()
        + 0.5 * (-(sq(x - 7.0) + sq(y - 3.0)) / 4.0).exp()
        - 0.2 * (-sq(x - 4.0) - sq(y - 7.0)).exp()
}
