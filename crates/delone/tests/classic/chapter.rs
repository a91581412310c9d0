//! The chapter on Delaunay triangulations of the diploma thesis: its algorithms, and its facts.

use crate::suite::run;
use delone::classic::{Algorithm, Input};
use delone::predicates::{Orientation, circumcenter, in_circle, orient2d};
use delone::{Event, Point, VertexId, triangulate};
use delone_testkit::generate::Kind;
use delone_testkit::naive::{all_triangulations, compare_least_angles, distinct};
use std::collections::BTreeSet;

/// All distinct points on the boundary of the convex hull: those with all others on one side of some line
/// through them, or on it.
fn naive_hull(points: &[Point]) -> BTreeSet<VertexId> {
    let distinct = distinct(points);
    let is_on_hull = |&p: &usize| {
        let others = distinct.iter().filter(|&&q| q != p);
        distinct.len() < 3
            || others.into_iter().any(|&q| {
                let side = |&r: &usize| orient2d(points[p], points[q], points[r]);
                !distinct.iter().any(|r| side(r) == Orientation::Right)
                    || !distinct.iter().any(|r| side(r) == Orientation::Left)
            })
    };
    let hull = distinct.iter().copied().filter(is_on_hull);
    hull.map(VertexId::new).collect()
}

#[test]
fn the_hull_lists_every_point_on_it_counter_clockwise_from_the_rightmost() {
    for (i, kind) in Kind::ALL.into_iter().enumerate() {
        for n in [1, 2, 3, 4, 6, 10, 40] {
            let points = kind.points(n, (31 * i + n) as u64);
            let input = Input::from_points(points.iter().copied());
            let (output, log) = run(Algorithm::ConvexHull, &input);
            let hull = &output.hull;
            let as_set: BTreeSet<_> = hull.iter().copied().collect();
            assert_eq!(as_set.len(), hull.len(), "{kind:?} {n}: each once");
            assert_eq!(as_set, naive_hull(&points), "{kind:?} {n}");
            let edges = log
                .last_scene()
                .expect("it was played before")
                .edges()
                .count();
            assert_eq!(
                edges,
                if hull.len() < 3 {
                    hull.len() / 2
                } else {
                    hull.len()
                }
            );
            let Some(first) = hull.first() else { continue };
            let at = |v: &VertexId| points[v.index()];
            let last = hull.iter().all(|v| at(v).lex_cmp(&at(first)).is_le());
            assert!(
                last || hull.len() == 1,
                "{kind:?} {n}: begins with the rightmost"
            );
            let next = hull.iter().cycle().skip(1);
            for ((a, b), c) in hull.iter().zip(next.clone()).zip(next.skip(1)) {
                let turn = orient2d(at(a), at(b), at(c));
                assert_ne!(turn, Orientation::Right, "{kind:?} {n}");
            }
        }
    }
}

/// Example 3.18 names points of a picture without coordinates. These have its sets, its chains, its polygon and
/// its result.
#[test]
fn example_3_18() {
    let text = include_str!("../data/chapter/001-printed-traces.json");
    let example: serde_json::Value = serde_json::from_str(text).expect("JSON");
    let example = &example["ex3_18_hull"];
    let list = |name: &str| -> Vec<usize> {
        let numbers = example[name].as_array().expect("a list").iter();
        numbers
            .map(|n| n.as_u64().expect("a number") as usize)
            .collect()
    };
    let points = [
        (20.0, 0.0),
        (18.0, 2.0),
        (16.0, 9.0),
        (12.0, 5.0),
        (12.0, 11.0),
        (3.0, 8.0),
        (0.0, 0.0),
        (7.0, 6.0),
        (10.0, 0.0),
        (2.0, -6.0),
        (4.0, -6.5),
        (6.0, -10.0),
        (9.0, -7.0),
        (11.0, -11.0),
        (15.0, -9.0),
        (18.0, -5.0),
    ];
    let (output, log) = run(Algorithm::ConvexHull, &Input::from_points(points));
    let numbers: Vec<_> = output.hull.iter().map(|v| v.index() + 1).collect();
    let result = list("result");
    assert_eq!(numbers, result[..result.len() - 1]);
    let sides = |wanted| {
        let tested = log.steps.iter().filter_map(move |step| match step.event {
            Event::OrientationTested { point, answer, .. } if step.line == 2 => {
                (answer == wanted).then_some(point.index() + 1)
            }
            _ => None,
        });
        let mut side: Vec<_> = tested.chain([1, 7]).collect();
        side.sort();
        side
    };
    assert_eq!(sides(Orientation::Left), list("upper_set"));
    assert_eq!(sides(Orientation::Right), list("lower_set"));
    let polygon: Vec<_> = log
        .steps
        .iter()
        .filter_map(|step| match step.event {
            Event::EdgeCreated { edge } if step.line == 4 => Some(edge[0].index() + 1),
            _ => None,
        })
        .collect();
    let expected = list("polygon");
    assert_eq!(polygon, expected[..expected.len() - 1]);
}

/// Fact 3.4: n points, n_a of them on the hull's boundary, have 2n − n_a − 2 triangles.
#[test]
fn the_number_of_triangles_is_given() {
    for (i, kind) in Kind::ALL.into_iter().enumerate() {
        let points = kind.points(50, i as u64);
        let t = triangulate(points.iter().copied()).expect("finite");
        let (n, on_hull) = (t.num_vertices(), naive_hull(&points).len());
        let expected = if t.num_triangles() == 0 {
            0
        } else {
            2 * n - on_hull - 2
        };
        assert_eq!(t.num_triangles(), expected, "{kind:?}");
    }
}

/// Fact 3.15: sites whose cells share more than a point are joined by a Delaunay edge.
#[test]
fn strong_voronoi_neighbours_are_joined() {
    for (i, kind) in Kind::ALL.into_iter().enumerate() {
        let points = kind.points(30, i as u64);
        let t = triangulate(points.iter().copied()).expect("finite");
        let edges: BTreeSet<_> = t.edges().map(|[a, b]| [a.min(b), a.max(b)]).collect();
        for &a in &distinct(&points) {
            for &b in distinct(&points).iter().filter(|&&b| a < b) {
                if is_strong_pair(&points, a, b) {
                    let edge = [a, b].map(VertexId::new);
                    assert!(edges.contains(&edge), "{kind:?}: {edge:?}");
                }
            }
        }
    }
}

/// Tells whether the border between two cells is more than a point: some open interval of the bisector is
/// closer to both than to any other site. The circles through both with c on them bound that interval.
fn is_strong_pair(points: &[Point], a: usize, b: usize) -> bool {
    // c on the left bounds from one side, c on the right from the other; circles through a, b grow with
    // their left part. Strong: every left c lies strictly outside the circle through every right one.
    let others = distinct(points).into_iter().filter(|&c| c != a && c != b);
    let (mut left, mut right) = (Vec::new(), Vec::new());
    let [pa, pb] = [points[a], points[b]];
    for c in others {
        match orient2d(pa, pb, points[c]) {
            Orientation::Left => left.push(points[c]),
            Orientation::Right => right.push(points[c]),
            Orientation::Collinear => {
                let p = points[c];
                if pa.lex_cmp(&p) == p.lex_cmp(&pb) {
                    return false; // Between both.
                }
            }
        }
    }
    use delone::predicates::CircleSide::Outside;
    let is_out = |l: &Point| right.iter().all(|&r| in_circle(pa, pb, *l, r) == Outside);
    left.iter().all(is_out)
}

/// Fact 3.11: of all triangulations of a point set, none has a larger least angle than Delaunay's.
#[test]
fn delaunay_is_globally_max_min_optimal() {
    for (i, kind) in Kind::ALL.into_iter().enumerate() {
        for n in [4, 5, 6, 7] {
            let points = kind.points(n, (7 * i + n) as u64);
            let t = triangulate(points.iter().copied()).expect("finite");
            let ours = t.triangles().to_vec();
            for other in all_triangulations(&points) {
                let order = compare_least_angles(&points, &ours, &other);
                assert!(order.is_ge(), "{kind:?} {points:?}: {other:?} is better");
            }
        }
    }
}

/// The swap test of 3.21, stated with angles: strictly convex, and the least of the six angles becomes
/// strictly larger. It is the test of the circle.
#[test]
fn the_swap_test_is_the_circle_test() {
    for (i, kind) in Kind::ALL.into_iter().enumerate() {
        for seed in 0..20 {
            let points = kind.points(4, 100 * i as u64 + seed);
            let [a, b, c, d] = points[..] else {
                unreachable!("four points")
            };
            let turn = |p, q, r| orient2d(p, q, r) == Orientation::Left;
            let is_convex = turn(a, b, c) && turn(b, c, d) && turn(c, d, a) && turn(d, a, b);
            if !is_convex || circumcenter(a, b, c).is_none() {
                continue;
            }
            let v = [0, 1, 2, 3].map(VertexId::new);
            let before = [[v[0], v[1], v[2]], [v[0], v[2], v[3]]];
            let after = [[v[0], v[1], v[3]], [v[1], v[2], v[3]]];
            let angles = compare_least_angles(&points, &after, &before);
            let circle = in_circle(a, b, c, d);
            use delone::predicates::CircleSide::{Inside, On, Outside};
            match circle {
                Inside => assert!(angles.is_gt(), "{points:?}"),
                On => assert!(angles.is_eq(), "{points:?}"),
                Outside => assert!(angles.is_lt(), "{points:?}"),
            }
        }
    }
}
