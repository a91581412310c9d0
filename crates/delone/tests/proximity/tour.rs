//! Tours: every vertex once, no worse than twice the tree, never below the bound; the best of few.

use crate::{on_small_sets, triangulated};
use delone::proximity::{Proximity, Route, Tour};
use delone::{Error, Point, Triangulation, VertexId};
use delone_testkit::generate::Kind;
use delone_testkit::naive::distinct;
use std::time::Duration;

fn distance(t: &Triangulation, a: VertexId, b: VertexId) -> f64 {
    let [p, q] = [a, b].map(|v| t.point(v));
    // Halves, lest the difference overflow.
    2.0 * (q.x / 2.0 - p.x / 2.0).hypot(q.y / 2.0 - p.y / 2.0)
}

fn length(t: &Triangulation, order: &[VertexId], is_closed: bool) -> f64 {
    let steps: f64 = order.windows(2).map(|w| distance(t, w[0], w[1])).sum();
    match order {
        [first, .., last] if is_closed => steps + distance(t, *last, *first),
        _ => steps,
    }
}

/// What must hold for every tour, `slack` being what rounding may do.
fn assert_route(proximity: &Proximity, route: &Route, tour: Tour, is_closed: bool) {
    let t = proximity.triangulation();
    let mut visited = route.order.clone();
    visited.sort();
    let vertices = distinct(t.points()).into_iter().map(VertexId::new);
    assert!(visited.into_iter().eq(vertices));
    let tree = proximity.spanning_tree().unwrap().length();
    let bound = tour.lower_bound(proximity).unwrap();
    let measured = length(t, &route.order, is_closed);
    if measured.is_finite() {
        let slack = 1e-11 * measured + 5e-321;
        assert!(
            (route.length - measured).abs() <= slack,
            "{route:?} {measured}"
        );
        assert!(route.length <= 2.0 * tree + slack, "{route:?} {tree}");
        assert!(bound <= route.length + slack, "{route:?} {bound}");
        assert!(bound >= tree - slack, "{bound} {tree}");
    }
}

#[test]
fn tours_are_tours() {
    on_small_sets(60, |points, proximity| {
        let closed = Tour::new().plan(proximity).unwrap();
        assert_route(proximity, &closed, Tour::new(), true);
        assert_eq!(
            closed.order.first(),
            (!points.is_empty()).then_some(&0.into())
        );
        let free = Tour::new().open().plan(proximity).unwrap();
        assert_route(proximity, &free, Tour::new().open(), false);
        for v in (0..points.len().min(3)).map(VertexId::new) {
            let start = proximity.triangulation().representative(v);
            for tour in [Tour::new(), Tour::new().open()] {
                let route = tour.start(v).plan(proximity).unwrap();
                assert_eq!(route.order[0], start);
                assert!(route.is_settled);
            }
            let tour = Tour::new().open().start(v);
            let route = tour.plan(proximity).unwrap();
            assert_route(proximity, &route, tour, false);
        }
    });
}

/// The shortest tours by dynamic programming over all sets (Held and Karp): closed, from the first point,
/// and free.
fn shortest(t: &Triangulation) -> [f64; 3] {
    let n = t.points().len();
    let d = |a: usize, b: usize| distance(t, VertexId::new(a), VertexId::new(b));
    // best[set][last], from each first vertex.
    let paths = |first: usize| {
        let mut best = vec![vec![f64::INFINITY; n]; 1 << n];
        best[1 << first][first] = 0.0;
        for set in 0..1_usize << n {
            for last in (0..n).filter(|v| set >> v & 1 == 1) {
                for next in (0..n).filter(|v| set >> v & 1 == 0) {
                    let length = best[set][last] + d(last, next);
                    let entry = &mut best[set | 1 << next][next];
                    *entry = entry.min(length);
                }
            }
        }
        best.pop().expect("the full set")
    };
    let least = |lengths: Vec<f64>| lengths.into_iter().fold(f64::INFINITY, f64::min);
    let first = paths(0);
    let closed = (1..n).map(|last| first[last] + d(last, 0)).collect();
    let free = (0..n).map(|v| least(paths(v))).collect();
    [least(closed), least(first), least(free)]
}

#[test]
fn few_sites_are_visited_in_the_best_order() {
    for kind in [
        Kind::Uniform,
        Kind::Lattice { side: 20 },
        Kind::Circle,
        Kind::WideExponents,
    ] {
        for seed in 0..10 {
            for n in 2..10 {
                let points = kind.points(n, seed);
                let t = triangulated(&points);
                if t.num_vertices() < n {
                    continue;
                }
                let proximity = Proximity::new(&t, &()).unwrap();
                let tours = [Tour::new(), Tour::new().open().start(0), Tour::new().open()];
                for (k, (tour, best)) in tours.into_iter().zip(shortest(&t)).enumerate() {
                    let route = tour.plan(&proximity).unwrap();
                    let case = format!("{kind:?} {seed} {n} {k}: {route:?} {best}");
                    assert!(route.length >= best * (1.0 - 1e-12), "{case}");
                    let bound = tour.lower_bound(&proximity).unwrap();
                    assert!(bound <= best * (1.0 + 1e-12), "{bound} {case}");
                    let is_best = route.length <= best * (1.0 + 1e-12);
                    assert!(is_best || n + usize::from(k > 0) > 7, "{case}");
                }
            }
        }
    }
}

#[test]
fn budgets_are_kept() {
    let t = triangulated(&Kind::Uniform.points(2000, 5));
    let proximity = Proximity::new(&t, &()).unwrap();
    let full = Tour::new().plan(&proximity).unwrap();
    assert!(full.is_settled && full.moves > 500);
    let mut last = f64::INFINITY;
    for moves in [0, 1, 10, 100] {
        let route = Tour::new().moves(moves).plan(&proximity).unwrap();
        assert_eq!((route.moves, route.is_settled), (moves, false));
        assert!(route.length < last);
        last = route.length;
        assert_route(&proximity, &route, Tour::new(), true);
    }
    let hurried = Tour::new().time(Duration::ZERO).plan(&proximity).unwrap();
    assert!(!hurried.is_settled);
    assert_route(&proximity, &hurried, Tour::new(), true);
}

#[test]
fn starts_must_exist() {
    let t = triangulated(&[Point::new(0.0, 0.0)]);
    let proximity = Proximity::new(&t, &()).unwrap();
    let found = Tour::new().start(1).plan(&proximity);
    let expected = Error::NoSuchVertex {
        vertex: 1.into(),
        points: 1,
    };
    assert_eq!(found.as_ref(), Err(&expected));
    let route = Tour::new().start(0).plan(&proximity).unwrap();
    assert_eq!((route.order, route.length), (vec![0.into()], 0.0));
    assert_eq!(Tour::new().lower_bound(&proximity), Ok(0.0));
    assert_eq!(Tour::new().start(1).lower_bound(&proximity), Err(expected));
}
