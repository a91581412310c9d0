//! The largest empty circle against all triples and all pairs on all edges of the hull.

use crate::{on_small_sets, triangulated};
use delone::predicates::{Orientation, compare_distances, orient2d};
use delone::proximity::Proximity;
use delone::{Point, Triangulation};
use delone_testkit::generate::Kind;

fn distance(p: Point, q: Point) -> f64 {
    (p.x - q.x).hypot(p.y - q.y)
}

/// The radius of the empty circle about `p`, if that lies in the hull.
fn radius(t: &Triangulation, p: Point) -> Option<f64> {
    let hull: Vec<Point> = t.hull().map(|v| t.point(v)).collect();
    let n = hull.len();
    let is_inside = (0..n).all(|i| orient2d(hull[i], hull[(i + 1) % n], p) != Orientation::Right);
    let radii = t.points().iter().map(|&q| distance(p, q));
    is_inside.then(|| radii.fold(f64::INFINITY, f64::min))
}

fn circumcenter([a, b, c]: [Point; 3]) -> Point {
    let [ux, uy, vx, vy] = [b.x - a.x, b.y - a.y, c.x - a.x, c.y - a.y];
    let (u, v, d) = (
        ux * ux + uy * uy,
        vx * vx + vy * vy,
        2.0 * (ux * vy - uy * vx),
    );
    Point::new(a.x + (vy * u - uy * v) / d, a.y + (ux * v - vx * u) / d)
}

/// All centres that there can be, rounded.
fn candidates(t: &Triangulation) -> Vec<Point> {
    let p = t.points();
    let n = p.len();
    let mut centers = Vec::new();
    let hull: Vec<Point> = t.hull().map(|v| t.point(v)).collect();
    for (i, j) in (0..n).flat_map(|i| (0..i).map(move |j| (i, j))) {
        centers.extend((0..j).map(|k| circumcenter([p[i], p[j], p[k]])));
        for (k, a) in hull.iter().enumerate() {
            let b = hull[(k + 1) % hull.len()];
            // a + s(b − a) is as far from p[i] as from p[j].
            let [dx, dy] = [p[j].x - p[i].x, p[j].y - p[i].y];
            let [mx, my] = [(p[i].x + p[j].x) / 2.0 - a.x, (p[i].y + p[j].y) / 2.0 - a.y];
            let s = (mx * dx + my * dy) / ((b.x - a.x) * dx + (b.y - a.y) * dy);
            if (0.0..=1.0).contains(&s) {
                centers.push(Point::new(a.x + s * (b.x - a.x), a.y + s * (b.y - a.y)));
            }
        }
    }
    centers
}

#[test]
fn no_candidate_is_larger() {
    for kind in [
        Kind::Uniform,
        Kind::Lattice { side: 5 },
        Kind::Lattice { side: 20 },
        Kind::CocircularRings,
        Kind::Circle,
        Kind::Cross,
    ] {
        for seed in 0..20 {
            let points = kind.points(3 + seed as usize % 12, seed);
            let t = triangulated(&points);
            let found = Proximity::new(&t, &())
                .unwrap()
                .largest_empty_circle()
                .unwrap();
            if t.num_triangles() == 0 {
                continue;
            }
            let found = found.expect("a triangle");
            let radii = candidates(&t).into_iter().filter_map(|c| radius(&t, c));
            let best = radii.fold(0.0, f64::max);
            // Candidates on the hull may be lost by rounding, ours is no worse.
            assert!(
                found.radius >= best * (1.0 - 1e-12),
                "{kind:?} {seed}: {found:?} {best}"
            );
            let own = radius(&t, nudged_inside(&t, found.center));
            let own = own.expect("in the hull");
            assert!(
                (own - found.radius).abs() <= 1e-9 * own,
                "{kind:?} {seed}: {found:?} {own}"
            );
        }
    }
}

/// Moves a point a billionth of the way to the middle of all.
fn nudged_inside(t: &Triangulation, p: Point) -> Point {
    let n = t.points().len() as f64;
    let sum = |c: fn(&Point) -> f64| t.points().iter().map(c).sum::<f64>() / n;
    let middle = Point::new(sum(|p| p.x), sum(|p| p.y));
    let part = |a: f64, b: f64| a + (b - a) * 1e-10;
    Point::new(part(p.x, middle.x), part(p.y, middle.y))
}

/// Whatever the input: the circle is empty, to the last bit.
#[test]
fn circles_are_empty() {
    on_small_sets(40, |points, proximity| {
        let found = proximity.largest_empty_circle().unwrap();
        assert_eq!(
            found.is_some(),
            proximity.triangulation().num_vertices() > 1
        );
        if let Some(circle) = found {
            let nearest = proximity.triangulation().point(circle.nearest);
            let is_nearer = |p: &&Point| compare_distances(circle.center, **p, nearest).is_lt();
            assert_eq!(points.iter().find(is_nearer), None, "{circle:?}");
            assert!(circle.center.is_finite());
        }
    });
}

/// Long obtuse triangles along the hull: the crossings lie behind several of them.
#[test]
fn centers_on_the_hull() {
    let mut points = vec![(0.0, 0.0), (8.0, 0.0), (4.0, 100.0)];
    points.extend([1.0, 2.0, 3.0, 5.0, 6.0, 7.0].map(|x| (x, 0.25)));
    let points: Vec<Point> = points.into_iter().map(Point::from).collect();
    let t = triangulated(&points);
    let best = candidates(&t)
        .into_iter()
        .filter_map(|c| radius(&t, c))
        .fold(0.0, f64::max);
    let found = Proximity::new(&t, &())
        .unwrap()
        .largest_empty_circle()
        .unwrap()
        .unwrap();
    assert!(
        (found.radius - best).abs() < 1e-12 * best,
        "{found:?} {best}"
    );
    // Points on a line: the middle of the largest gap.
    let row: Vec<Point> = [0.0, 1.0, 4.0, 9.0, 11.0]
        .map(|x| Point::new(x, 3.0 * x))
        .to_vec();
    let t = triangulated(&row);
    let found = Proximity::new(&t, &())
        .unwrap()
        .largest_empty_circle()
        .unwrap()
        .unwrap();
    assert_eq!(found.center, Point::new(6.5, 19.5));
}
