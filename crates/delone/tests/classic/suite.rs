//! One suite for all: whatever is observed can be played forwards and backwards, whoever observes changes
//! nothing, and all that claim a Delaunay triangulation end in the canonical one.

use super::named::named;
use delone::classic::{Algorithm, Input, Output, Takes};
use delone::{Log, Point, Scene, VertexId, triangulate};
use delone_testkit::corpus;
use delone_testkit::generate::{Kind, Random};
use proptest::prelude::*;
use std::path::Path;

/// The files that are part of the repository.
const FIXTURES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data");

/// Files of up to so many points are run with every log played forwards and backwards.
const WATCHED: usize = 40;

/// Files of up to so many points are run.
const FEW: usize = 1000;

/// Runs an algorithm unobserved and observed, plays its log, and compares everything.
pub fn run(algorithm: Algorithm, input: &Input) -> (Output, Log) {
    let name = algorithm.about().name;
    let output = algorithm
        .run(input)
        .unwrap_or_else(|e| panic!("{name}: {e}"));
    let mut log = Log::new(name, input.pslg.points.clone());
    let observed = algorithm.observe(input, &mut log).expect("ran before");
    assert_eq!(output, observed, "{name} differs when it is observed");
    check_lines(algorithm, &log);
    let last = check_replay(&log);
    if !output.triangles.is_empty() || last.triangles().next().is_some() {
        assert_eq!(
            sorted(last.triangles()),
            sorted(output.triangles.iter().copied()),
            "{name}"
        );
    }
    (output, log)
}

/// Every step has a line of the pseudocode, or none.
fn check_lines(algorithm: Algorithm, log: &Log) {
    let lines = algorithm.about().code.len();
    let beyond = log.steps.iter().find(|step| usize::from(step.line) > lines);
    assert!(beyond.is_none(), "there are {lines} lines: {beyond:?}");
}

/// Plays a log forwards and backwards, comparing the scene at every hundredth step, and returns the last. No event
/// names a vertex that is there neither before nor after it; least of all the one at infinity.
fn check_replay(log: &Log) -> Scene {
    let mut scene = log.first_scene();
    let mut kept = Vec::new();
    for (i, step) in log.steps.iter().enumerate() {
        if i % 100 == 0 {
            kept.push((i, scene.clone()));
        }
        let mut named = named(step.event);
        named.retain(|&v| scene.point(v).is_none());
        let fits = scene.apply(step.event);
        fits.unwrap_or_else(|e| panic!("{}, step {i}: {e}", log.algorithm));
        named.retain(|&v| scene.point(v).is_none());
        let name = &log.algorithm;
        assert!(named.is_empty(), "{name}, step {i}: {:?}", step.event);
    }
    let last = scene.clone();
    for (i, step) in log.steps.iter().enumerate().rev() {
        let fits = scene.revert(step.event);
        fits.unwrap_or_else(|e| panic!("{}, step {i} backwards: {e}", log.algorithm));
        if kept.last().is_some_and(|&(at, _)| at == i) {
            let (_, before) = kept.pop().expect("just seen");
            assert!(scene == before, "{}, step {i} is not undone", log.algorithm);
        }
    }
    last
}

/// Triangles, smallest corner first, sorted.
pub fn sorted(triangles: impl Iterator<Item = [VertexId; 3]>) -> Vec<[VertexId; 3]> {
    let mut triangles: Vec<_> = triangles.collect();
    for t in &mut triangles {
        let smallest = (0..3).min_by_key(|&k| t[k]).expect("three corners");
        t.rotate_left(smallest);
    }
    triangles.sort();
    triangles
}

/// Points alone say too little to it: its own tests know what it is to be asked.
fn wants_more(algorithm: Algorithm) -> bool {
    algorithm.about().takes == Takes::Data || algorithm.refines()
}

/// Runs all algorithms that take points, and compares them with the engine.
fn check_all(points: &[Point]) {
    let expected = triangulate(points.iter().copied()).expect("finite points");
    for &algorithm in Algorithm::ALL {
        let about = algorithm.about();
        if wants_more(algorithm) {
            continue;
        }
        let (output, _) = run(algorithm, &Input::from_points(points.iter().copied()));
        if about.is_delaunay {
            assert_eq!(
                output.hash(),
                expected.hash(),
                "{} on {points:?}",
                about.name
            );
            assert_eq!(output.duplicates, expected.duplicates(), "{}", about.name);
        }
    }
}

#[test]
fn few_points_are_defined() {
    check_all(&[]);
    for n in 1..5 {
        check_all(&vec![Point::new(3.0, 4.0); n]);
        check_all(
            &(0..n)
                .map(|i| Point::new(i as f64, 0.0))
                .collect::<Vec<_>>(),
        );
        check_all(
            &(0..n)
                .map(|i| Point::new(0.0, i as f64))
                .collect::<Vec<_>>(),
        );
        check_all(
            &(0..n)
                .map(|i| Point::new((i * i) as f64, -(i as f64)))
                .collect::<Vec<_>>(),
        );
    }
}

#[test]
fn every_kind_of_points_ends_in_the_one_triangulation() {
    for (i, kind) in Kind::ALL.into_iter().enumerate() {
        for n in [3, 4, 5, 7, 12, 30, 60] {
            check_all(&kind.points(n, (100 * i + n) as u64));
        }
    }
}

#[test]
fn every_order_ends_in_the_one_triangulation() {
    for seed in 0..5 {
        let lattice = (0..25).map(|i| Point::new(f64::from(i % 5), f64::from(i / 5)));
        let mut points: Vec<_> = lattice.collect();
        Random::new(seed).shuffle(&mut points);
        check_all(&points);
    }
}

/// Compares the hashes of all algorithms that take points with the engine's, unobserved: so on more points.
fn check_hashes(name: &str, points: &[Point]) {
    let expected = triangulate(points.iter().copied()).expect("finite points");
    let input = Input::from_points(points.iter().copied());
    let all = Algorithm::ALL.iter().filter(|a| a.about().is_delaunay);
    for algorithm in all.filter(|&&algorithm| !wants_more(algorithm)) {
        let output = algorithm.run(&input).expect("finite points");
        let about = algorithm.about();
        assert_eq!(output.hash(), expected.hash(), "{} on {name}", about.name);
    }
}

#[test]
fn the_points_of_files_end_in_the_one_triangulation() {
    let mut checked = [0; 2];
    for entry in corpus::read_all(Path::new(FIXTURES)) {
        let points = &entry.pslg.points;
        if points.len() <= WATCHED {
            check_all(points);
            checked[0] += 1;
        } else if points.len() <= FEW {
            check_hashes(&entry.name, points);
            checked[1] += 1;
        }
    }
    assert!(checked[0] > 20 && checked[1] > 2, "{checked:?}");
}

#[test]
fn what_is_wrong_is_refused() {
    for &algorithm in Algorithm::ALL {
        let bad = Input::from_points([(0.0, 0.0), (f64::NAN, 0.0), (1.0, 1.0)]);
        let error = algorithm.run(&bad).expect_err("not a number");
        assert!(error.to_string().contains("point 1"), "{error}");
    }
}

#[test]
fn every_line_of_pseudocode_runs() {
    let points = Kind::ALL.into_iter().flat_map(|kind| kind.points(8, 3));
    let inputs = [points.collect::<Vec<_>>(), Kind::ALL[0].points(40, 1)];
    let all = Algorithm::ALL.iter().copied();
    // Without segments the insertion of segments has nothing to do.
    let has_enough = |&a: &Algorithm| !wants_more(a) && a != Algorithm::Constrained;
    for algorithm in all.filter(has_enough) {
        let about = algorithm.about();
        let mut ran = vec![false; about.code.len() + 1];
        for points in &inputs {
            let (_, log) = run(algorithm, &Input::from_points(points.iter().copied()));
            for step in &log.steps {
                ran[usize::from(step.line)] = true;
            }
        }
        // Lines that only rule what follows have no step of their own; the first of a body has.
        let count = ran[1..].iter().filter(|&&ran| ran).count();
        assert!(2 * count >= about.code.len(), "{}: {ran:?}", about.name);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn small_lattices_are_full_of_ties(
        lattice in prop::collection::vec((0..5i8, 0..5i8), 0..14)
    ) {
        let points = lattice.iter().map(|&(x, y)| Point::new(x.into(), y.into()));
        check_all(&points.collect::<Vec<_>>());
    }
}
