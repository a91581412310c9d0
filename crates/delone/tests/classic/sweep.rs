//! The mended sweep: its hull, its segments, its inside.

use crate::polygons::{doubled_area, doubled_areas, ring, simple_polygon};
use crate::suite::run;
use delone::classic::{Algorithm, Input, Output};
use delone::{
    ConstrainedDelaunay, DomainRule, Error, Event, Point, Pslg, Stage, VertexId, check, triangulate,
};
use delone_testkit::domains::Domain;
use delone_testkit::fuzz::segments::case;
use delone_testkit::generate::{Kind, Random};
use proptest::prelude::*;
use serde_json::Value;
use std::collections::BTreeSet;

fn domain(pslg: Pslg, rule: DomainRule) -> Input<'static> {
    Input {
        domain: rule,
        ..Input::from_pslg(pslg)
    }
}

/// All sides of all triangles, smaller end first.
fn sides(output: &Output) -> BTreeSet<[VertexId; 2]> {
    let sides = output
        .triangles
        .iter()
        .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    sides.map(|[a, b]| [a.min(b), a.max(b)]).collect()
}

/// The verifier finds nothing wrong with the triangles but that they are not Delaunay.
fn check_covers_hull(output: &Output) {
    let verdict = check::verify(&output.points, &output.triangles, &()).expect("finite points");
    if let check::Verdict::Wrong(defects) = verdict {
        let other = defects
            .listed()
            .iter()
            .find(|d| !matches!(d, check::Defect::NotLocallyDelaunay { .. }));
        assert!(other.is_none(), "{other:?}");
    }
}

#[test]
fn after_stripping_the_hull_is_covered() {
    let mut random = Random::new(26);
    for _ in 0..300 {
        let n = 3 + random.below(40);
        let integer = |random: &mut Random| random.below(1000) as f64;
        let points: Vec<_> = (0..n)
            .map(|_| Point::new(integer(&mut random), integer(&mut random)))
            .collect();
        let output = Algorithm::Sweep
            .run(&Input::from_points(points.iter().copied()))
            .expect("points");
        let hull: Vec<_> = triangulate(points.iter().copied())
            .expect("points")
            .hull()
            .map(|v| points[v.index()])
            .collect();
        assert_eq!(
            doubled_areas(&points, &output.triangles),
            doubled_area(&hull)
        );
        check_covers_hull(&output);
    }
}

#[test]
fn every_kind_of_points_is_covered() {
    for (i, kind) in Kind::ALL.into_iter().enumerate() {
        for n in [2, 3, 4, 6, 10, 40, 150] {
            let points = kind.points(n, (7 * i + n) as u64);
            let (output, _) = run(Algorithm::Sweep, &Input::from_points(points));
            check_covers_hull(&output);
        }
    }
}

#[test]
fn the_front_is_convex_and_holds_every_point_for_a_while() {
    let points = Kind::Lattice { side: 20 }.points(60, 5);
    let (_, log) = run(Algorithm::Sweep, &Input::from_points(points));
    let mut scene = log.first_scene();
    for step in &log.steps {
        scene.apply(step.event).expect("it fits");
        if matches!(step.event, Event::FrontEntered { .. }) && step.line == 7 {
            let front: Vec<_> = scene.front().filter_map(|v| scene.point(v)).collect();
            for (i, &a) in front.iter().enumerate() {
                let [b, c] = [1, 2].map(|k| front[(i + k) % front.len()]);
                let turn = delone::predicates::orient2d(a, b, c);
                assert_ne!(turn, delone::predicates::Orientation::Right);
            }
        }
    }
    assert_eq!((scene.front().count(), scene.sweep()), (0, None));
}

#[test]
fn points_at_the_end_of_the_numbers_are_swept_without_helpers() {
    let end = f64::MAX;
    let points = [
        (-end, 0.0),
        (-end, 1.0),
        (end, end),
        (0.0, -end),
        (-end, 0.5),
    ];
    let (output, log) = run(Algorithm::Sweep, &Input::from_points(points));
    check_covers_hull(&output);
    let is_helper = |step: &delone::Step| matches!(step.event, Event::VertexCreated { .. });
    assert!(!log.steps.iter().any(is_helper));
}

#[test]
fn stages_end_in_their_order() {
    let (_, log) = run(
        Algorithm::Sweep,
        &Input::from_points(Kind::Uniform.points(9, 1)),
    );
    let ended = log.steps.iter().filter_map(|step| match step.event {
        Event::StageEnded { stage, .. } => Some(stage),
        _ => None,
    });
    let expected = [
        Stage::Sweep,
        Stage::StripHelpers,
        Stage::InsertSegments,
        Stage::InsideTest,
    ];
    assert_eq!(ended.collect::<Vec<_>>(), expected);
}

#[test]
fn random_polygons_keep_their_segments_and_their_area() {
    let mut random = Random::new(29);
    for _ in 0..300 {
        let n = 4 + random.below(30);
        let corners = simple_polygon(n, 60, &mut random);
        let input = domain(ring(&corners), DomainRule::EvenOdd);
        let (output, log) = run(Algorithm::Sweep, &input);
        assert_eq!(
            doubled_areas(&corners, &output.triangles),
            doubled_area(&corners),
            "{corners:?}"
        );
        assert_eq!(output.triangles.len(), n - 2);
        let sides = sides(&output);
        assert!(output.constrained.iter().all(|edge| sides.contains(edge)));
        assert_eq!(output.constrained.len(), n);
        for step in &log.steps {
            if let Event::InsideTested {
                crossings,
                is_inside,
                ..
            } = step.event
            {
                assert_eq!(crossings % 2 == 1, is_inside, "{corners:?}");
            }
        }
    }
}

/// Of the same domain as much belongs to it, and the same edges are constraints; or the same is wrong with it,
/// then the answer is no.
fn check_like_engine(pslg: &Pslg, rule: DomainRule) -> bool {
    let engine = ConstrainedDelaunay::new()
        .domain(rule)
        .triangulate(pslg.clone());
    let input = domain(pslg.clone(), rule);
    let ours = Algorithm::Sweep.run(&input);
    let (engine, ours) = match (engine, ours) {
        (Ok(engine), Ok(ours)) => (engine, ours),
        // A vertex may be on several segments.
        (Err(Error::SeedOnSegment { at: expected, .. }), Err(Error::SeedOnSegment { at, .. })) => {
            assert_eq!(expected, at);
            return false;
        }
        (Err(expected), Err(found)) => {
            assert_eq!(expected, found);
            return false;
        }
        (engine, ours) => panic!("{engine:?} {ours:?}"),
    };
    let (output, _) = run(Algorithm::Sweep, &input);
    assert_eq!(output, ours);
    let mut constrained: Vec<_> = engine
        .constrained_edges()
        .map(|[a, b]| [a.min(b), a.max(b)])
        .collect();
    constrained.sort();
    assert_eq!(ours.constrained, constrained);
    let engine = engine.triangulation();
    assert_eq!(ours.triangles.len(), engine.num_triangles(), "{rule:?}");
    assert_eq!(ours.duplicates, engine.duplicates());
    // The same edges bound both.
    let boundary = |triangles: &[[VertexId; 3]]| {
        let mut directed = BTreeSet::new();
        for &[a, b, c] in triangles {
            for [a, b] in [[a, b], [b, c], [c, a]] {
                if !directed.remove(&[b, a]) {
                    assert!(directed.insert([a, b]));
                }
            }
        }
        directed
    };
    assert_eq!(boundary(&ours.triangles), boundary(engine.triangles()));
    true
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(256))]

    #[test]
    fn small_domains_are_those_of_the_engine(
        lattice in prop::collection::vec((0..5i8, 0..5i8), 2..12),
        segments in prop::collection::vec((0..12usize, 0..12usize), 0..6),
        hole in prop::option::of((0..9i8, 0..9i8)),
        ring in 0..6usize,
    ) {
        let points = lattice.iter().map(|&(x, y)| Point::new(x.into(), y.into()));
        let n = lattice.len();
        let mut pslg = Pslg::from_points(points);
        pslg.add_ring((0..ring.min(n)).map(VertexId::new));
        for (a, b) in segments {
            pslg.add_segment(VertexId::new(a % n), VertexId::new(b % n));
        }
        pslg.holes.extend(hole.map(|(x, y)| Point::new(f64::from(x) / 2.0, f64::from(y) / 2.0)));
        for rule in RULES {
            check_like_engine(&pslg, rule);
        }
    }
}

#[test]
fn fuzzed_domains_are_those_of_the_engine() {
    let mut domain = Domain::default();
    let mut refused = 0;
    for seed in 0..1500 {
        case(seed, 24, 12, &mut domain);
        domain.pslg.regions.clear();
        for rule in RULES {
            refused += usize::from(!check_like_engine(&domain.pslg, rule));
        }
    }
    assert!(refused < 3600, "{refused} of 4500 domains are refused");
}

#[test]
fn long_segments_through_many_triangles_are_inserted() {
    for hub in 0..3 {
        let points = Kind::Lattice { side: 200 }.points(400, hub as u64);
        let mut pslg = Pslg::from_points(points);
        for v in 0..400 {
            pslg.add_segment(VertexId::new(hub), VertexId::new(v));
        }
        assert!(check_like_engine(&pslg, DomainRule::Hull));
    }
}

const RULES: [DomainRule; 3] = [DomainRule::Hull, DomainRule::Carve, DomainRule::EvenOdd];

/// The domain of examples 1.26 and 1.29, its vertices sorted.
fn example() -> (Pslg, Value) {
    let text = include_str!("../data/thesis/000-ex1.26-1.29-strip-inside.json");
    let value: Value = serde_json::from_str(text).expect("a fixture");
    let points: Vec<[f64; 2]> = serde_json::from_value(value["points"].clone()).expect("points");
    let edges: Vec<[u32; 2]> =
        serde_json::from_value(value["constraint_edges"].clone()).expect("edges");
    let mut pslg = Pslg::from_points(points);
    for [a, b] in edges {
        pslg.add_segment(a - 1, b - 1);
    }
    (pslg, value)
}

fn area(output: &Output) -> f64 {
    let halves = output.triangles.iter().map(|t| {
        let [a, b, c] = t.map(|v| output.points[v.index()]);
        ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2.0
    });
    halves.sum()
}

#[test]
fn the_thesis_domain_has_its_areas() {
    let (pslg, value) = example();
    let (hull, _) = run(Algorithm::Sweep, &domain(pslg.clone(), DomainRule::Hull));
    let (inside, log) = run(Algorithm::Sweep, &domain(pslg, DomainRule::EvenOdd));
    assert_eq!(Some(area(&inside)), value["area_inside"].as_f64());
    assert_eq!(Some(area(&hull)), value["area_hull_of_triangles"].as_f64());
    assert_eq!(inside.triangles.len(), 10);
    let helpers = log.steps.iter().filter_map(|step| match step.event {
        Event::VertexCreated { at, .. } => Some((at.x, at.y)),
        _ => None,
    });
    assert_eq!(helpers.collect::<Vec<_>>(), [(-1.0, -4.0), (-1.0, 8.0)]);
}

#[test]
fn points_are_taken_in_the_order_of_example_1_23() {
    let text = include_str!("../data/thesis/000-ex1.23-sort.json");
    let value: Value = serde_json::from_str(text).expect("a fixture");
    let (pslg, _) = example();
    let mut shuffled = pslg.clone();
    Random::new(3).shuffle(&mut shuffled.points);
    shuffled.segments.clear();
    let (_, log) = run(Algorithm::Sweep, &domain(shuffled, DomainRule::Hull));
    let scene = log.first_scene();
    let taken = log.steps.iter().filter_map(|step| match step.event {
        Event::PointConsidered { vertex } => scene.point(vertex).map(|p| [p.x, p.y]),
        _ => None,
    });
    let variant = &value["variants"][1]["expected_points"];
    let expected: Vec<[f64; 2]> = serde_json::from_value(variant.clone()).expect("points");
    assert_eq!(taken.collect::<Vec<_>>(), expected[2..]);
}
