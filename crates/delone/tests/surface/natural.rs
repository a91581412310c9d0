//! Weights of natural neighbours.

use crate::oracle;
use crate::support::{domain, questions, triangulated};
use delone::surface::{Cursor, Interpolant, Linear, NaturalNeighbors, Samples, Weighing};
use delone::{Error, Point, Triangulation, VertexId};
use delone_testkit::generate::{Kind, Random, scaled};

const BOTH: [Weighing; 2] = [Weighing::Sibson, Weighing::Laplace];

fn distinct(t: &Triangulation) -> Vec<Point> {
    let all = (0..t.points().len()).map(VertexId::new);
    all.filter(|&v| t.representative(v) == v)
        .map(|v| t.point(v))
        .collect()
}

/// Compares with the definitions, on grids full of ties and scattered points alike.
#[test]
fn weights_are_those_of_the_definitions() {
    let kinds = [
        (Kind::Lattice { side: 5 }, 40),
        (Kind::CocircularRings, 40),
        (Kind::Uniform, 30),
        (Kind::Lattice { side: 9 }, 50),
    ];
    let mut compared = 0;
    for (kind, n) in kinds {
        for seed in 0..12 {
            let t = triangulated(kind, n, seed);
            let neighbors = NaturalNeighbors::new(&t).expect("Delaunay");
            let points = distinct(&t);
            for p in questions(&t, 60, seed) {
                let is_vertex = points.contains(&p);
                for weighing in BOTH {
                    let Some(found) = neighbors.weights(p, weighing) else {
                        continue;
                    };
                    let expected = match weighing {
                        _ if is_vertex => continue,
                        Weighing::Sibson => oracle::sibson(&points, p),
                        Weighing::Laplace => oracle::laplace(&points, p),
                    };
                    let Some(expected) = expected else {
                        continue;
                    };
                    compared += 1;
                    for (v, expected) in points.iter().zip(expected) {
                        let of_v = found.iter().filter(|(u, _)| t.point(*u) == *v);
                        let found: f64 = of_v.map(|(_, weight)| weight).sum();
                        let what = format!("{kind:?} {seed} {p:?} {v:?}: {found} {expected}");
                        assert!((found - expected).abs() < 1e-8, "{weighing:?} {what}");
                    }
                }
            }
        }
    }
    assert!(compared > 2000, "only {compared}");
}

/// Sums to 1, never negative, the point is the mean, relative to how far the neighbours are.
fn assert_laws(t: &Triangulation, p: Point, weights: &[(VertexId, f64)], what: &str) {
    let sum: f64 = weights.iter().map(|(_, w)| w).sum();
    assert!((sum - 1.0).abs() < 1e-12, "{what}: sum {sum}");
    // Relative to the longer axis: of the other one nothing may be left beside it.
    let (mut means, mut size, mut at) = ([0.0; 2], 0.0, 0.0_f64);
    for axis in 0..2 {
        let of = |p: Point| [p.x, p.y][axis];
        for &(v, w) in weights {
            let term = w * (of(t.point(v)) * 0.5 - of(p) * 0.5);
            means[axis] += term;
            size += term.abs();
        }
        at = at.max(of(p).abs());
    }
    // What the point itself is rounded to, too.
    let bound = 1e-9 * size + 1e-15 * at;
    let is_mean = means.iter().all(|mean| mean.abs() <= bound);
    assert!(is_mean, "{what}: {means:?} of {size:e}, {weights:?}");
}

#[test]
fn the_laws_hold_for_all_kinds_of_points() {
    let mut inside = 0;
    for kind in Kind::ALL {
        for seed in 0..8 {
            let t = triangulated(kind, 60, seed);
            let neighbors = NaturalNeighbors::new(&t).expect("Delaunay");
            let values: Vec<f64> = t.points().iter().map(|p| p.x).collect();
            let samples = Samples::new(&t, values).expect("values");
            let linear = Linear::new(&samples);
            let mut cursor = Cursor::default();
            for p in questions(&t, 80, seed + 100) {
                for weighing in BOTH {
                    let what = format!("{kind:?} {seed} {weighing:?} {:e} {:e}", p.x, p.y);
                    let found = neighbors.weights_near(p, weighing, &mut cursor);
                    assert_eq!(found, neighbors.weights(p, weighing), "{what}");
                    assert_eq!(found.is_some(), linear.value(p).is_some(), "{what}");
                    let Some(weights) = found else { continue };
                    inside += 1;
                    let least = weights.iter().fold(1.0, |m: f64, (_, w)| m.min(*w));
                    assert!(least >= -1e-11, "{what}: {least}");
                    assert_laws(&t, p, &weights, &what);
                }
            }
        }
    }
    assert!(inside > 5000, "only {inside}");
}

#[test]
fn a_vertex_is_its_own_neighbour_and_a_border_has_two() {
    let t = triangulated(Kind::Lattice { side: 4 }, 60, 1);
    let neighbors = NaturalNeighbors::new(&t).expect("Delaunay");
    for weighing in BOTH {
        for v in (0..t.points().len()).map(VertexId::new) {
            let own = vec![(t.representative(v), 1.0)];
            assert_eq!(neighbors.weights(t.point(v), weighing), Some(own));
        }
        let side = neighbors.weights(Point::new(0.0, 1.25), weighing);
        let mut side = side.expect("on the border");
        side.sort_by_key(|&(v, _)| t.point(v).y.to_bits());
        let ends: Vec<_> = side.iter().map(|&(v, w)| (t.point(v), w)).collect();
        let [a, b] = [1.0, 2.0].map(|y| Point::new(0.0, y));
        assert_eq!(ends, [(a, 0.75), (b, 0.25)]);
        assert_eq!(neighbors.weights(Point::new(-1e-300, 1.0), weighing), None);
    }
}

/// Points on a slightly bent line above a distant one: flat triangles whose circles are huge.
#[test]
fn flat_hulls_do_not_spoil_weights() {
    for bend in [1e-6, 1e-9, 1e-12, 1e-15] {
        let top = (0..9).map(|i| {
            let x = f64::from(i) - 4.0;
            Point::new(x, 1.0 - bend * x * x)
        });
        let below = [(-5.0, -1.0), (0.3, -2.0), (5.0, -1.2)].map(Point::from);
        let t = delone::triangulate(top.chain(below)).expect("points");
        let neighbors = NaturalNeighbors::new(&t).expect("Delaunay");
        for i in 0..40 {
            let x = f64::from(i) / 5.0 - 3.9;
            for depth in [0.5, 1e-3, 1e-7, 1e-11, 2e-15] {
                let p = Point::new(x, 1.0 - bend * x * x - depth);
                for weighing in BOTH {
                    if let Some(weights) = neighbors.weights(p, weighing) {
                        let what = format!("{bend} {x} {depth} {weighing:?}");
                        assert_laws(&t, p, &weights, &what);
                        assert!(
                            weights.iter().all(|(_, w)| *w > -1e-11),
                            "{what}: {weights:?}"
                        );
                    }
                }
            }
        }
    }
}

#[test]
fn scaling_by_a_power_of_two_changes_nothing() {
    let points = Kind::Uniform.points(80, 5);
    let [a, b] = [0, 600].map(|e| {
        let scaled = |p: &Point| Point::new(scaled(p.x, e), scaled(p.y, e));
        delone::triangulate(points.iter().map(scaled)).expect("points")
    });
    let [na, nb] = [&a, &b].map(|t| NaturalNeighbors::new(t).expect("Delaunay"));
    for p in questions(&a, 100, 7) {
        let q = Point::new(scaled(p.x, 600), scaled(p.y, 600));
        for weighing in BOTH {
            assert_eq!(na.weights(p, weighing), nb.weights(q, weighing));
        }
    }
}

/// The square's centre is on a common circle of all; a step aside another triangle is dug out.
#[test]
fn weights_are_continuous_where_neighbours_change() {
    for seed in 0..10 {
        let t = triangulated(Kind::Lattice { side: 6 }, 60, seed);
        let neighbors = NaturalNeighbors::new(&t).expect("Delaunay");
        let mut random = Random::new(seed);
        for _ in 0..200 {
            let mut draw = || random.below(21) as f64 / 4.0;
            let p = Point::new(draw(), draw());
            let moved = Point::new(p.x + 1e-9, p.y - 0.7e-9);
            for weighing in BOTH {
                let pair = [p, moved].map(|p| neighbors.weights(p, weighing));
                let [Some(here), Some(there)] = pair else {
                    continue;
                };
                for &(v, _) in here.iter().chain(&there) {
                    let [f, g] = [&here, &there].map(|weights| {
                        let own = weights.iter().filter(|(u, _)| *u == v);
                        own.map(|(_, w)| w).sum::<f64>()
                    });
                    assert!((f - g).abs() < 1e-6, "{weighing:?} {p:?}: {f} {g}");
                }
            }
        }
    }
}

#[test]
fn nobody_is_a_neighbour_through_a_wall() {
    let t = domain(60, 3);
    let neighbors = NaturalNeighbors::new(&t).expect("Delaunay");
    let points = t.triangulation().points();
    let mut inside = 0;
    for p in questions(t.triangulation(), 2000, 9) {
        for weighing in BOTH {
            let Some(weights) = neighbors.weights(p, weighing) else {
                continue;
            };
            inside += 1;
            let what = format!("{weighing:?} {p:?}");
            assert_laws(t.triangulation(), p, &weights, &what);
            let least = weights.iter().fold(1.0, |m: f64, (_, w)| m.min(*w));
            assert!(
                weighing == Weighing::Sibson || least > -1e-11,
                "{what}: {least}"
            );
            for (v, _) in weights {
                let sight = [p, points[v.index()]];
                let walls = t.constrained_edges().map(|e| e.map(|v| points[v.index()]));
                for wall in walls {
                    assert!(!delone::predicates::cross_properly(sight, wall), "{what}");
                }
            }
        }
    }
    assert!(inside > 1000, "only {inside}");
}

#[test]
fn triangles_of_a_domain_need_its_constraints() {
    let t = domain(200, 4);
    let error = NaturalNeighbors::new(t.triangulation()).expect_err("walls are not Delaunay");
    assert!(matches!(error, Error::NotDelaunay { .. }), "{error}");
    assert!(NaturalNeighbors::new(&t).is_ok());
}
