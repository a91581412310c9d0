//! The engine's insertion of segments, watched: it ends in what the engine makes, by steps that can be played.

use super::suite::run;
use delone::classic::{Algorithm, Input};
use delone::{ConstrainedDelaunay, DomainRule, Error, Event, Log, Point, Pslg, Stage, VertexId};
use delone_testkit::domains::Domain;
use delone_testkit::fuzz::segments::case;
use delone_testkit::generate::Kind;
use proptest::prelude::*;

const RULES: [DomainRule; 3] = [DomainRule::Hull, DomainRule::Carve, DomainRule::EvenOdd];

/// Runs it watched, and compares with the engine: the same triangles, constraints and duplicates, or the same error.
fn check(pslg: &Pslg, rule: DomainRule) -> Option<Log> {
    let input = Input {
        domain: rule,
        ..Input::from_pslg(pslg.clone())
    };
    let engine = ConstrainedDelaunay::new().domain(rule);
    let engine = match engine.triangulate(pslg.clone()) {
        Ok(engine) => engine,
        Err(expected) => {
            let mut log = Log::new("constrained", pslg.points.clone());
            let refused = Algorithm::Constrained.observe(&input, &mut log);
            assert_eq!(refused, Err(expected));
            log.last_scene().expect("what has been told can be played");
            return None;
        }
    };
    let (output, log) = run(Algorithm::Constrained, &input);
    let t = engine.triangulation();
    assert_eq!(output.hash(), t.hash());
    assert_eq!(output.triangles, t.triangles());
    assert_eq!(output.duplicates, t.duplicates());
    let mut constrained: Vec<_> = engine
        .constrained_edges()
        .map(|[a, b]| [a.min(b), a.max(b)])
        .collect();
    constrained.sort_unstable();
    let scene = log.last_scene().expect("played before");
    let locked: Vec<_> = scene
        .edges()
        .filter(|&edge| scene.is_locked(edge))
        .collect();
    assert_eq!(locked, constrained);
    assert_eq!(output.constrained, constrained);
    Some(log)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(256))]

    #[test]
    fn small_domains_are_those_of_the_engine(
        lattice in prop::collection::vec((0..5i8, 0..5i8), 0..12),
        segments in prop::collection::vec((0..12usize, 0..12usize), 0..6),
        hole in prop::option::of((0..9i8, 0..9i8)),
        ring in 0..6usize,
    ) {
        let points = lattice.iter().map(|&(x, y)| Point::new(x.into(), y.into()));
        let n = lattice.len();
        let mut pslg = Pslg::from_points(points);
        pslg.add_ring((0..ring.min(n)).map(VertexId::new));
        for (a, b) in segments.into_iter().filter(|_| n > 0) {
            pslg.add_segment(VertexId::new(a % n), VertexId::new(b % n));
        }
        pslg.holes.extend(hole.map(|(x, y)| Point::new(f64::from(x) / 2.0, f64::from(y) / 2.0)));
        for rule in RULES {
            check(&pslg, rule);
        }
    }
}

#[test]
fn fuzzed_domains_are_those_of_the_engine() {
    let mut domain = Domain::default();
    let mut taken = 0;
    for seed in 0..800 {
        case(seed, 24, 12, &mut domain);
        for rule in RULES {
            taken += usize::from(check(&domain.pslg, rule).is_some());
        }
    }
    assert!(taken > 400, "{taken} of 2400 domains are taken");
}

#[test]
fn crossings_are_refused() {
    let mut pslg = Pslg::from_points([(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)]);
    pslg.add_segment(0, 2);
    pslg.add_segment(1, 3);
    let refused = Algorithm::Constrained.run(&Input::from_pslg(pslg));
    assert!(matches!(
        refused,
        Err(Error::Crossing {
            segments: [0, 1],
            ..
        })
    ));
}

/// A hub with segments to all points of a lattice: through vertices, along each other, across many edges.
#[test]
fn long_segments_through_many_triangles_are_inserted() {
    for hub in 0..3 {
        let mut pslg = Pslg::from_points(Kind::Lattice { side: 60 }.points(200, hub as u64));
        for v in 0..200 {
            pslg.add_segment(VertexId::new(hub), VertexId::new(v));
        }
        let log = check(&pslg, DomainRule::Hull).expect("a star does not cross itself");
        let told = |kind: fn(Event) -> bool| log.steps.iter().filter(|s| kind(s.event)).count();
        assert!(told(|e| matches!(e, Event::WalkStepped { .. })) > 100);
        assert!(told(|e| matches!(e, Event::EdgeFlipped { .. })) > 10);
    }
}

#[test]
fn every_line_tells_something() {
    let mut told = [0; 13];
    let mut domain = Domain::default();
    for seed in 0..200 {
        case(seed, 24, 12, &mut domain);
        if let Some(log) = check(&domain.pslg, DomainRule::Carve) {
            for step in log.steps {
                told[usize::from(step.line)] += 1;
            }
        }
    }
    let silent: Vec<_> = (0..told.len()).filter(|&line| told[line] == 0).collect();
    // Heads of loops, and what only long curves lead to: 3, 6, 10.
    assert_eq!(silent, [3, 6, 10]);
}

#[test]
fn stages_end_in_their_order() {
    let mut pslg = Pslg::from_points(Kind::Uniform.points(9, 1));
    pslg.add_segment(0, 5);
    let log = check(&pslg, DomainRule::Hull).expect("one segment");
    let ended = log.steps.iter().filter_map(|step| match step.event {
        Event::StageEnded { stage, .. } => Some(stage),
        _ => None,
    });
    let expected = [
        Stage::Triangulation,
        Stage::InsertSegments,
        Stage::InsideTest,
    ];
    assert!(ended.eq(expected));
}
