//! The thesis' refinement: its log plays forwards to the mesh and backwards to the points, whatever it comes
//! to; and its own domain comes out as worked there.

use super::suite::run;
use delone::classic::{Algorithm, Input};
use delone::{Angle, DomainRule, Error, Event, Point, Pslg, Quality, Stage, VertexId, Watch};
use delone_testkit::generate::{Kind, Random};
use proptest::prelude::*;

fn input(pslg: Pslg, degrees: f64, max_edge: f64) -> Input<'static> {
    let quality = Quality {
        min_angle: Some(Angle::degrees(degrees)),
        max_edge: Some(max_edge),
        ..Quality::default()
    };
    Input {
        domain: DomainRule::EvenOdd,
        quality,
        ..Input::from_pslg(pslg)
    }
}

/// The domain of example 1.16.
fn thesis_domain() -> Pslg {
    let mut pslg = Pslg::from_points([
        (1.0, 0.0),
        (3.0, 1.0),
        (2.5, 3.0),
        (3.0, 4.0),
        (0.0, 3.0),
        (0.0, 1.0),
        (2.0, 1.0),
        (2.0, 2.0),
        (1.0, 2.0),
    ]);
    pslg.add_ring([0, 1, 2, 3, 4, 5]);
    pslg.add_ring([6, 7, 8]);
    pslg
}

#[test]
fn the_thesis_own_domain_comes_out_as_worked() {
    let (output, log) = run(Algorithm::Thesis, &input(thesis_domain(), 20.0, 3.0));
    assert_eq!((output.points.len(), output.triangles.len()), (12, 13));
    assert_eq!(output.constrained.len(), 11);
    let added = [(1.5, 3.5), (2.0, 0.5), (1.0, 1.0)].map(Point::from);
    assert_eq!(output.points[9..], added);
    let ends = log.steps.iter().filter_map(|step| match step.event {
        Event::StageEnded { stage, min_angle } => {
            let thousandths = min_angle.map(|a| (1000.0 * a.to_degrees()).round());
            Some((stage, thousandths, step.line))
        }
        _ => None,
    });
    let expected = [
        (Stage::SplitEdges, None, 1),
        (Stage::ShortenEdges, Some(18435.0), 6),
        (Stage::OpenTriangles, Some(26565.0), 7),
    ];
    assert!(ends.eq(expected));
    // The triangle that holds a circumcenter is bisected, both times.
    let opened = log.steps.iter().filter_map(|step| match step.event {
        Event::CircumcenterRejected { edge, .. } => Some((step.line, edge.map(VertexId::index))),
        _ => None,
    });
    let opened: Vec<_> = opened.collect();
    assert_eq!(opened.len(), 2, "{opened:?}");
}

#[test]
fn every_line_tells_something() {
    let mut told = vec![0; Algorithm::Thesis.about().code.len() + 1];
    for (degrees, max_edge) in [(20.0, 3.0), (40.0, 1.0), (25.0, 0.5), (30.0, 0.7)] {
        let (_, log) = run(
            Algorithm::Thesis,
            &input(thesis_domain(), degrees, max_edge),
        );
        for step in &log.steps {
            told[usize::from(step.line)] += 1;
        }
    }
    let silent: Vec<_> = (0..told.len()).filter(|&line| told[line] == 0).collect();
    // Heads of loops and what only computes: 4, 14, 15, 17.
    assert_eq!(silent, [4, 14, 15, 17]);
}

#[test]
fn nothing_asked_for_gives_the_constrained_delaunay_triangulation() {
    for (i, kind) in Kind::ALL.into_iter().enumerate() {
        let points = kind.points(20, i as u64);
        let (output, _) = run(
            Algorithm::Thesis,
            &Input::from_points(points.iter().copied()),
        );
        let expected = delone::triangulate(points).expect("finite points");
        assert_eq!(output.hash(), expected.hash(), "{kind:?}");
        assert_eq!(output.duplicates, expected.duplicates());
    }
}

/// Asks to stop.
struct Stop;

impl Watch for Stop {
    fn is_cancelled(&self) -> bool {
        true
    }
}

#[test]
fn whoever_cancels_gets_no_mesh() {
    let mut input = input(thesis_domain(), 20.0, 0.1);
    input.watch = &Stop;
    assert_eq!(Algorithm::Thesis.run(&input), Err(Error::Cancelled));
}

/// A polygon around the origin, with corners of a lattice in angular order: simple, and often with angles
/// that are sharp.
fn star(n: usize, size: usize, random: &mut Random) -> Pslg {
    let coordinate = |random: &mut Random| random.below(2 * size + 1) as f64 - size as f64;
    let mut corners: Vec<_> = (0..n)
        .map(|_| Point::new(coordinate(random), coordinate(random)))
        .filter(|p| (p.x, p.y) != (0.0, 0.0))
        .collect();
    corners.extend(
        [(9, 1), (-8, 9), (-9, -8)]
            .map(|(x, y)| Point::new(f64::from(x) * size as f64, f64::from(y) * size as f64)),
    );
    let angle = |p: &Point| p.y.atan2(p.x);
    corners.sort_by(|p, q| angle(p).total_cmp(&angle(q)));
    // Integers so small differ in their angles, or not at all.
    corners.dedup_by(|p, q| p.x * q.y == p.y * q.x && p.x * q.x + p.y * q.y > 0.0);
    let mut pslg = Pslg::from_points(corners);
    pslg.add_ring((0..pslg.points.len()).map(VertexId::new));
    pslg
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn random_polygons_are_played_forwards_and_backwards(
        seed in any::<u64>(),
        n in 0..14_usize,
        degrees in 1.0..42.0,
        share in 0.08..1.5,
    ) {
        let mut random = Random::new(seed);
        let pslg = star(n, 6, &mut random);
        let (output, log) = run(Algorithm::Thesis, &input(pslg, degrees, 60.0 * share));
        // What is handed out is the constrained Delaunay triangulation of its points and segments.
        let mut again = Pslg::from_points(output.points.iter().copied());
        again.segments = output.constrained.clone();
        again.polygons.push(0..again.segments.len());
        let builder = delone::ConstrainedDelaunay::new().domain(DomainRule::EvenOdd);
        let again = builder.triangulate(again).expect("planar");
        prop_assert_eq!(output.hash(), again.triangulation().hash());
        // Unless the mesh saved is returned, each step was told by itself.
        let is_back = log.steps.iter().any(|step| matches!(step.event, Event::TakenBack { .. }));
        prop_assert!(is_back || log.steps.iter().all(|step| step.line != 16));
        let scene = log.last_scene().expect("played before");
        prop_assert!(output.constrained.iter().all(|&edge| scene.is_locked(edge)));
        prop_assert!(scene.queue(delone::Queue::Suspects).next().is_none());
    }
}

#[test]
fn runs_that_fall_back_are_played_to_the_mesh_saved() {
    let mut fallen = 0;
    for seed in 0..60 {
        let pslg = star(8, 6, &mut Random::new(seed));
        let asked = input(pslg, 38.0, 30.0);
        let (output, log) = run(Algorithm::Thesis, &asked);
        let back = |event: &Event| matches!(event, Event::TakenBack { .. });
        if log.steps.iter().any(|step| back(&step.event)) {
            let mut only_edges = asked.clone();
            only_edges.quality.min_angle = None;
            let (saved, _) = run(Algorithm::Thesis, &only_edges);
            assert_eq!(output, saved, "case {seed}");
            fallen += 1;
        }
    }
    assert!(fallen > 10, "{fallen}");
}
