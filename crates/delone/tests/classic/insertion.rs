//! What holds of every insertion: the star lemma, and how many flips it takes.

use super::suite;
use delone::classic::{Algorithm, Input};
use delone::predicates::{Orientation, in_circle_perturbed, orient2d};
use delone::{Event, Item, Log, Point, Scene, Step, Tally, VertexId};
use delone_testkit::generate::{Kind, Random};
use std::collections::BTreeSet;

fn log_of(algorithm: Algorithm, points: &[Point], seed: u64) -> Log {
    let mut input = Input::from_points(points.iter().copied());
    input.seed = seed;
    suite::run(algorithm, &input).1
}

/// Cuts a log into what comes before the first insertion, and the insertions.
fn insertions(log: &Log) -> Vec<&[Step]> {
    let is_next = |_: &Step, next: &Step| !matches!(next.event, Event::PointConsidered { .. });
    log.steps.chunk_by(is_next).collect()
}

fn play(scene: &mut Scene, steps: &[Step]) {
    for step in steps {
        scene.apply(step.event).expect("fits");
    }
}

fn count(steps: &[Step], what: impl Fn(&Event) -> bool) -> usize {
    steps.iter().filter(|step| what(&step.event)).count()
}

fn degree(scene: &Scene, v: VertexId) -> usize {
    scene.edges().filter(|edge| edge.contains(&v)).count()
}

/// Sets of points of every kind, and a number for each.
fn samples() -> impl Iterator<Item = Vec<Point>> {
    let kinds = Kind::ALL.into_iter().enumerate();
    kinds.map(|(i, kind)| kind.points(30, i as u64 + 70))
}

#[test]
fn new_triangles_have_the_point_as_corner_and_others_stay_unless_in_conflict() {
    for points in samples() {
        for algorithm in [Algorithm::Incremental, Algorithm::SegmentWalk] {
            check_star_lemma(&log_of(algorithm, &points, 0));
        }
    }
}

fn check_star_lemma(log: &Log) {
    let mut scene = log.first_scene();
    for steps in insertions(log) {
        let before: BTreeSet<_> = scene.triangles().collect();
        play(&mut scene, steps);
        let Event::PointConsidered { vertex: p } = steps[0].event else {
            continue;
        };
        let after: BTreeSet<_> = scene.triangles().collect();
        assert!(after.difference(&before).all(|t| t.contains(&p)));
        for t in &before {
            let [a, b, c] = t.map(|v| scene.point(v).expect("a corner"));
            let at = scene.point(p).expect("inserted");
            assert_eq!(after.contains(t), !in_circle_perturbed(a, b, c, at));
        }
    }
}

/// How many edges a point has before the first flip: that many fewer flips than its degree.
fn edges_without_flips(scene: &Scene, steps: &[Step], p: VertexId) -> usize {
    let located = steps.iter().find_map(|step| match step.event {
        Event::PointLocated { at, .. } => Some(at),
        _ => None,
    });
    match located.expect("every point is located") {
        Some(Item::Triangle(_)) => 3,
        Some(Item::Edge([a, b])) => {
            let sides = [[a, b], [b, a]].map(|edge| scene.apex(edge));
            2 + sides.iter().flatten().count()
        }
        Some(Item::Vertex(v)) => panic!("{v:?} twice"),
        None => 1 + hull_edges_seen(scene, p),
    }
}

fn hull_edges_seen(scene: &Scene, p: VertexId) -> usize {
    let sides = scene.edges().flat_map(|[a, b]| [[a, b], [b, a]]);
    let outer = sides.filter(|&side| scene.apex(side).is_none());
    let is_left = |side: &[VertexId; 2]| {
        let [a, b] = side.map(|v| scene.point(v).expect("an end"));
        orient2d(a, b, scene.point(p).expect("a point")) == Orientation::Left
    };
    outer.filter(is_left).count()
}

#[test]
fn the_number_of_flips_is_the_degree_less_what_was_joined() {
    // In general position as on lattices: it depends on where the point lies, not on ties.
    for (seed, points) in samples().enumerate() {
        for algorithm in [Algorithm::Incremental, Algorithm::RandomIncremental] {
            let log = log_of(algorithm, &points, seed as u64);
            let mut scene = log.first_scene();
            for steps in insertions(&log) {
                if let Event::PointConsidered { vertex: p } = steps[0].event {
                    let joined = edges_without_flips(&scene, steps, p);
                    play(&mut scene, steps);
                    let flips = count(steps, |e| matches!(e, Event::EdgeFlipped { .. }));
                    assert_eq!(flips, degree(&scene, p) - joined, "{p:?}");
                } else {
                    play(&mut scene, steps);
                    assert_eq!(count(steps, |e| matches!(e, Event::EdgeFlipped { .. })), 0);
                }
            }
        }
    }
}

fn tally(algorithm: Algorithm, points: &[Point], seed: u64) -> Tally {
    let mut input = Input::from_points(points.iter().copied());
    input.seed = seed;
    let mut tally = Tally::default();
    algorithm.observe(&input, &mut tally).expect("finite");
    tally
}

#[test]
fn the_walk_deletes_the_edges_that_the_lecture_flips() {
    for points in samples() {
        let flipping = log_of(Algorithm::Incremental, &points, 0).steps;
        let opening = log_of(Algorithm::SegmentWalk, &points, 0).steps;
        let flips = count(&flipping, |e| matches!(e, Event::EdgeFlipped { .. }));
        let deleted = count(&opening, |e| matches!(e, Event::EdgeDeleted { .. }));
        // An edge goes, too, if a point lies on it.
        let divided = count(&opening, |e| {
            matches!(
                e,
                Event::PointLocated {
                    at: Some(Item::Edge(_)),
                    ..
                }
            )
        });
        assert_eq!(flips, deleted - divided);
    }
}

#[test]
fn a_seed_names_an_order() {
    let points = Kind::Uniform.points(60, 1);
    let steps = |seed| log_of(Algorithm::RandomIncremental, &points, seed).steps;
    assert_eq!(steps(1), steps(1));
    assert_ne!(steps(1), steps(2));
}

/// Points on a parabola from the flat end to the tip, on which each new one is joined to all.
fn curve(n: u32) -> Vec<Point> {
    let abscissas = (1..=n).rev().map(f64::from);
    abscissas.map(|x| Point::new(x, x * x)).collect()
}

#[test]
fn the_worst_order_takes_a_quadratic_number_of_flips() {
    for n in [3, 4, 50, 200] {
        let tally = tally(Algorithm::Incremental, &curve(n), 0);
        assert_eq!(tally.flips, u64::from((n - 2) * (n - 3) / 2));
    }
}

#[test]
fn random_order_takes_fewer_than_three_flips_a_point() {
    for points in [Kind::Uniform.points(400, 2), curve(400)] {
        let seeds = 0..8;
        let flips = seeds.map(|seed| tally(Algorithm::RandomIncremental, &points, seed).flips);
        let mean = flips.sum::<u64>() as f64 / 8.0;
        assert!(mean < 3.0 * points.len() as f64, "{mean}");
    }
}

#[test]
fn the_walk_passes_vertices_and_runs_along_edges() {
    // From (0, 0) to points beyond others, on their line, on edges, and outside along the hull.
    let mut points: Vec<_> = [(4, 0), (8, 0), (4, 4), (0, 4), (2, 2), (0, 0)].to_vec();
    points.extend([
        (3, 3),
        (0, 1),
        (0, 2),
        (6, 0),
        (9, 0),
        (-1, 0),
        (10, 10),
        (-3, -3),
    ]);
    points.extend([
        (20, 20),
        (1, 1),
        (-2, -2),
        (15, 15),
        (5, 5),
        (0, 9),
        (0, -9),
        (0, 3),
    ]);
    for seed in 0..50 {
        let points: Vec<_> = points
            .iter()
            .map(|&(x, y)| Point::from((x as f64, y as f64)))
            .collect();
        let mut order = points.clone();
        if seed > 0 {
            Random::new(seed).shuffle(&mut order);
        }
        check_star_lemma(&log_of(Algorithm::SegmentWalk, &order, 0));
    }
}
