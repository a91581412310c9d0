//! The sweep circle and Fortune's sweep: what their fronts are, and in which order things happen.

use crate::suite::{run, sorted};
use delone::classic::{Algorithm, Input};
use delone::predicates::{
    CircleSide, Orientation, circumcenter, compare_bottom, compare_bottoms, compare_distances,
    compare_parabolas, orient2d,
};
use delone::voronoi::Voronoi;
use delone::{Event, Item, Log, Point, Queue, Scene, Stage, Sweep, Tally, VertexId, triangulate};
use delone_testkit::generate::Kind;
use proptest::prelude::*;
use std::cmp::Ordering;

/// Calls `check` with points of all kinds, and the log of an algorithm.
fn on_all_kinds(algorithm: Algorithm, mut check: impl FnMut(&[Point], &Log)) {
    for (i, kind) in Kind::ALL.into_iter().enumerate() {
        for n in [3, 6, 14, 40] {
            let points = kind.points(n, (n + 1000 * i) as u64);
            let (_, log) = run(algorithm, &Input::from_points(points.iter().copied()));
            check(&log.points, &log);
        }
    }
}

/// Plays a log, and shows the scene before each step.
fn play(log: &Log, mut look: impl FnMut(&Scene, Event)) -> Scene {
    let mut scene = log.first_scene();
    for step in &log.steps {
        look(&scene, step.event);
        scene
            .apply(step.event)
            .expect("a log that was played before");
    }
    scene
}

/// The convex hull, counter-clockwise, with all vertices on its edges; begins with `first`.
fn hull_from(points: &[Point], first: VertexId) -> Vec<VertexId> {
    let t = triangulate(points.iter().copied()).expect("finite points");
    let mut hull: Vec<_> = t.hull().collect();
    let at = hull.iter().position(|&v| v == first).expect("on the hull");
    hull.rotate_left(at);
    hull
}

fn is_degenerate(log: &Log) -> bool {
    let created = |e| matches!(e, Event::TriangleCreated { .. });
    !log.steps.iter().any(|step| created(step.event))
}

// ----- The sweep circle

#[test]
fn the_front_of_the_circle_is_the_hull() {
    on_all_kinds(Algorithm::SweepCircle, |points, log| {
        if is_degenerate(log) {
            return;
        }
        let scene = play(log, |scene, event| {
            if matches!(event, Event::PointConsidered { .. }) {
                check_convex(scene);
            }
        });
        let front: Vec<_> = scene.front().collect();
        assert_eq!(front, hull_from(points, front[0]));
    });
}

/// Vertices may lie on edges; no corner is reflex, and the angle turns once.
fn check_convex(scene: &Scene) {
    let front: Vec<_> = scene.front().filter_map(|v| scene.point(v)).collect();
    let n = front.len();
    for i in 0..n {
        let [a, b, c] = [0, 1, 2].map(|k| front[(i + k) % n]);
        assert_ne!(orient2d(a, b, c), Orientation::Right);
    }
    let is_turn = |i: usize| {
        let [a, b, c] = [0, 1, 2].map(|k| front[(i + k) % n]);
        a.lex_cmp(&b).is_lt() && b.lex_cmp(&c).is_gt()
    };
    assert!(n == 0 || (0..n).filter(|&i| is_turn(i)).count() == 1);
}

/// Points come as the circle does; each but those of the first row is a new corner of the hull.
#[test]
fn the_circle_grows() {
    on_all_kinds(Algorithm::SweepCircle, |points, log| {
        let considered = log.steps.iter().filter_map(|step| match step.event {
            Event::PointConsidered { vertex } => Some(points[vertex.index()]),
            _ => None,
        });
        let order: Vec<_> = considered.collect();
        for pair in order.windows(2) {
            let by_distance = compare_distances(order[0], pair[0], pair[1]);
            assert_eq!(by_distance.then(pair[0].lex_cmp(&pair[1])), Ordering::Less);
        }
        let entered = |e| matches!(e, Event::FrontEntered { .. });
        let entered = log.steps.iter().filter(|step| entered(step.event)).count();
        assert_eq!(entered, if is_degenerate(log) { 0 } else { order.len() });
        for step in &log.steps {
            if let Event::SweptTo { from, to } = step.event {
                assert!(from.is_none_or(|from| radius(from) < radius(to.expect("it goes on"))));
            }
        }
    });
}

/// The radius of a sweep circle.
fn radius(sweep: Sweep) -> f64 {
    match sweep {
        Sweep::Circle { radius, .. } => radius,
        line => panic!("no circle: {line:?}"),
    }
}

/// The table of directions makes the search short: a bounded number of tests for each point.
#[test]
fn the_search_along_the_hull_is_short() {
    let points = Kind::Uniform.points(3000, 5);
    let mut tally = Tally::default();
    let input = Input::from_points(points);
    Algorithm::SweepCircle
        .observe(&input, &mut tally)
        .expect("finite points");
    assert!(tally.orientation_tests < 7 * 3000, "{tally:?}");
    assert!(tally.flips < 4 * 3000, "{tally:?}");
}

// ----- Fortune's sweep

/// What happens in the sweep, in its order: points that are met, circles that end.
fn events(log: &Log) -> Vec<Item> {
    let taken = log.steps.iter().filter_map(|step| match step.event {
        Event::Popped {
            queue: Queue::Events,
            item,
        } if step.line == 3 => Some(item),
        _ => None,
    });
    taken.collect()
}

/// Circles end in the order of their lowest points, before sites of the same height.
#[test]
fn events_come_from_above() {
    on_all_kinds(Algorithm::Fortune, |points, log| {
        let at = |v: VertexId| points[v.index()];
        for pair in events(log).windows(2) {
            match [pair[0], pair[1]] {
                [Item::Vertex(v), Item::Vertex(w)] => {
                    let [p, q] = [at(v), at(w)];
                    assert!(p.y > q.y || (p.y == q.y && p.x < q.x));
                }
                [Item::Triangle(t), Item::Triangle(u)] => {
                    assert!(compare_bottoms(t.map(at), u.map(at)).is_ge());
                }
                // What ends at the same time ends because of the site, or it would have come before.
                [Item::Vertex(v), Item::Triangle(t)] => {
                    let order = compare_bottom(t.map(at), at(v));
                    assert!(order.is_lt() || (order.is_eq() && t.contains(&v)));
                }
                [Item::Triangle(t), Item::Vertex(v)] => {
                    assert!(compare_bottom(t.map(at), at(v)).is_ge());
                }
                other => panic!("an edge is no event: {other:?}"),
            }
        }
        for step in &log.steps {
            if let Event::SweptTo {
                from: Some(Sweep::Horizontal(from)),
                to,
            } = step.event
            {
                assert!(matches!(to, Some(Sweep::Horizontal(to)) if to < from));
            }
        }
    });
}

/// The arc above a site is that of the lowest parabola.
#[test]
fn the_right_arc_is_divided() {
    on_all_kinds(Algorithm::Fortune, |points, log| {
        play(log, |scene, event| {
            let Event::PointLocated {
                vertex,
                at: Some(Item::Vertex(found)),
            } = event
            else {
                return;
            };
            let p = points[vertex.index()];
            let front: Vec<_> = scene.front().map(|v| points[v.index()]).collect();
            assert!(front.contains(&points[found.index()]));
            let above = points.iter().filter(|q| q.y > p.y);
            for &q in above {
                assert!(compare_parabolas(p, points[found.index()], q).is_le());
            }
        });
    });
}

/// There is one circle for each triangle; their centers are the vertices of the Voronoi diagram.
#[test]
fn circles_end_in_voronoi_vertices() {
    on_all_kinds(Algorithm::Fortune, |points, log| {
        let t = triangulate(points.iter().copied()).expect("finite points");
        let circles: Vec<_> = events(log)
            .into_iter()
            .filter_map(|item| match item {
                Item::Triangle(t) => Some(t.map(|v| points[v.index()])),
                _ => None,
            })
            .collect();
        assert_eq!(circles.len(), t.num_triangles());
        let centers = circles.into_iter().map(|[a, b, c]| circumcenter(a, b, c));
        let voronoi = Voronoi::new(&t, &()).expect("not cancelled");
        assert_eq!(
            without_repetition(centers.map(|o| o.expect("a triangle")).collect()),
            without_repetition(voronoi.vertices().to_vec())
        );
    });
}

fn without_repetition(mut points: Vec<Point>) -> Vec<Point> {
    points.sort_by(Point::lex_cmp);
    points.dedup();
    points
}

/// In the end the beach line is the hull, from the highest point around to it, or to the end of the
/// highest row.
#[test]
fn the_last_beach_line_is_the_hull() {
    on_all_kinds(Algorithm::Fortune, |points, log| {
        let scene = play(log, |_, _| ());
        let mut front: Vec<_> = scene.front().collect();
        assert_eq!(scene.queue(Queue::Events).count(), 0);
        if is_degenerate(log) {
            return;
        }
        let hull = hull_from(points, front[0]);
        if front.last() == front.first() {
            front.pop();
            assert_eq!(front, hull);
        } else {
            // The row goes back along the top.
            assert_eq!(front, hull[..front.len()]);
            let top = points[front[0].index()].y;
            assert!(
                hull[front.len()..]
                    .iter()
                    .all(|v| points[v.index()].y == top)
            );
        }
    });
}

/// Flips come after the sweep, and only where four points are on a circle.
#[test]
fn only_ties_are_repaired() {
    let mut flips = 0;
    on_all_kinds(Algorithm::Fortune, |_, log| {
        let is_end = |e| {
            matches!(
                e,
                Event::StageEnded {
                    stage: Stage::Sweep,
                    ..
                }
            )
        };
        let end = log.steps.iter().position(|step| is_end(step.event));
        let (sweep, repair) = log.steps.split_at(end.expect("it ends"));
        let is_flip = |e| matches!(e, Event::EdgeFlipped { .. });
        assert!(!sweep.iter().any(|step| is_flip(step.event)));
        let mut last_answer = None;
        for step in repair {
            match step.event {
                Event::CircleTested { answer, .. } => last_answer = Some(answer),
                Event::EdgeFlipped { .. } => {
                    assert_eq!(last_answer, Some(CircleSide::On));
                    flips += 1;
                }
                _ => {}
            }
        }
    });
    assert!(flips > 10, "{flips}");
}

/// Where no four points are on a circle, what the sweep finds is final.
#[test]
fn nothing_is_repaired_in_general_position() {
    for n in [10, 100, 1000] {
        let input = Input::from_points(Kind::Uniform.points(n, n as u64));
        let (output, log) = run(Algorithm::Fortune, &input);
        let created = log.steps.iter().filter_map(|step| match step.event {
            Event::TriangleCreated { triangle } => Some(triangle),
            _ => None,
        });
        assert_eq!(sorted(created), sorted(output.triangles.into_iter()));
    }
}

/// Where an arc of `a` ends and one of `b` begins, as well as floating point can tell: with heights above the
/// line da and db, w = b.x − a.x and X = x − a.x, (X² + da²)/da = ((X − w)² + db²)/db.
fn breakpoint(a: Point, b: Point, line: f64) -> f64 {
    let [da, db, w] = [a.y - line, b.y - line, b.x - a.x];
    let [p, q, r] = [db - da, 2.0 * w * da, da * (db * (da - db) - w * w)];
    let root = (q * q - 4.0 * p * r).max(0.0).sqrt();
    let way = if q > 0.0 {
        -2.0 * r / (q + root)
    } else {
        (root - q) / (2.0 * p)
    };
    a.x + way
}

#[test]
fn arcs_are_in_order() {
    let points = Kind::Uniform.points(200, 11);
    let (_, log) = run(Algorithm::Fortune, &Input::from_points(points));
    let mut looks = 0;
    play(&log, |scene, event| {
        let (Event::SweptTo { .. }, Some(Sweep::Horizontal(line))) = (event, scene.sweep()) else {
            return;
        };
        let front: Vec<_> = scene.front().filter_map(|v| scene.point(v)).collect();
        let ends = front
            .windows(2)
            .map(|pair| breakpoint(pair[0], pair[1], line));
        let ends: Vec<_> = ends.map(|x| x.clamp(-4.0, 5.0)).collect();
        assert!(ends.windows(2).all(|x| x[0] <= x[1] + 1e-5), "{ends:?}");
        looks += ends.len();
    });
    assert!(looks > 1000, "{looks}");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// Sites below breakpoints, circles that end at sites and with each other.
    #[test]
    fn fortune_on_small_lattices(
        lattice in prop::collection::vec((0..9i8, 0..6i8), 3..30),
        shear in -2..3i8
    ) {
        let place = |&(x, y): &(i8, i8)| Point::new((x + shear * y).into(), (2 * y + x % 2).into());
        let points: Vec<_> = lattice.iter().map(place).collect();
        let expected = triangulate(points.iter().copied()).expect("finite points");
        for algorithm in [Algorithm::Fortune, Algorithm::SweepCircle] {
            let (output, _) = run(algorithm, &Input::from_points(points.iter().copied()));
            prop_assert_eq!(output.hash(), expected.hash());
        }
    }
}
