//! The engine's refinement, watched: the log plays to the mesh that it makes unwatched, vertex by vertex where that
//! has them, and says of each vertex why it came.

use super::suite::{run, sorted};
use delone::classic::{Algorithm, Input};
use delone::{
    Angle, Budget, DomainRule, Event, Log, Point, Pslg, Quality, RefinedMesh, Refinement, Stage,
    Step, VertexId,
};
use delone_testkit::fuzz::refine::case;
use delone_testkit::generate::Kind;
use delone_testkit::refined::Job;

/// A job's refinement, as [`Job::mesh`] has it.
fn refinement(job: &Job) -> Refinement<'_> {
    let refinement = Refinement::new(job.quality)
        .domain(job.domain.rule)
        .crossings(job.domain.crossings)
        .locked(job.locked)
        .encroachment(job.encroachment)
        .smoothing(job.smoothing)
        .budget(Budget {
            vertices: job.vertices,
            ..Budget::default()
        });
    match &job.sizing {
        Some(field) => refinement.sizing(field),
        None => refinement,
    }
}

/// Refines watched and unwatched, and compares the mesh with what its log plays to.
fn check(job: &Job) -> Option<(RefinedMesh, Log)> {
    let pslg = &job.domain.pslg;
    let mut log = Log::new("refinement", pslg.points.clone());
    let watched = refinement(job).observe(pslg.clone(), &mut log);
    let unwatched = job.mesh(2, &());
    let (watched, unwatched) = match (watched, unwatched) {
        (Ok(watched), Ok(unwatched)) => (watched, unwatched),
        (watched, unwatched) => {
            assert_eq!(watched.err(), unwatched.err());
            return None;
        }
    };
    assert_eq!(watched.report, unwatched.report);
    let [t, u] = [&watched, &unwatched].map(|refined| refined.mesh.triangulation());
    assert_eq!((t.points(), t.triangles()), (u.points(), u.triangles()));
    let scene = log
        .last_scene()
        .unwrap_or_else(|e| panic!("{e} in {job:?}"));
    let shown: Vec<Point> = scene.vertices().map(|(_, at)| at).collect();
    assert_eq!(shown, t.points());
    let expected = sorted(t.triangles().iter().copied());
    assert_eq!(sorted(scene.triangles()), expected);
    let locked: Vec<_> = scene
        .edges()
        .filter(|&edge| scene.is_locked(edge))
        .collect();
    let constrained = watched.mesh.constrained_edges();
    let mut constrained: Vec<_> = constrained.map(|[a, b]| [a.min(b), a.max(b)]).collect();
    constrained.sort_unstable();
    assert_eq!(locked, constrained);
    check_causes(&log);
    Some((watched, log))
}

/// Each vertex has its cause right before it, or is of the lattice, or of the input's crossings.
fn check_causes(log: &Log) {
    let stage = |wanted: Stage| {
        let is_end =
            |s: &Step| matches!(s.event, Event::StageEnded { stage, .. } if stage == wanted);
        log.steps.iter().position(is_end)
    };
    let first = stage(Stage::Lattice).or(stage(Stage::InsideTest));
    let first = first.expect("there has been a domain");
    let events: Vec<_> = log.steps.iter().map(|step| step.event).collect();
    for i in first + 1..events.len() {
        let Event::VertexCreated { vertex, at } = events[i] else {
            continue;
        };
        match events[i - 1] {
            Event::CircumcenterProposed { at: proposed, .. } => assert_eq!(proposed, at),
            Event::SegmentSplit { edge, vertex: new } => {
                assert_eq!(new, vertex);
                check_split(&events[..i - 1], edge);
            }
            other => panic!("{vertex:?} comes after {other:?}"),
        }
    }
}

/// Before a segment is split there is told why.
fn check_split(before: &[Event], edge: [VertexId; 2]) {
    match before[before.len() - 1] {
        Event::Encroached { segment, .. } => assert_eq!(segment, edge),
        Event::TriangleConsidered { triangle } => {
            assert!(edge.iter().all(|v| triangle.contains(v)));
        }
        Event::CircumcenterRejected {
            triangle,
            edge: blocking,
        } => {
            assert_eq!(blocking, edge);
            let proposed = before[before.len() - 2];
            let is_same = |of| of == triangle;
            assert!(
                matches!(proposed, Event::CircumcenterProposed { triangle, .. } if is_same(triangle))
            );
        }
        other => panic!("{edge:?} is split after {other:?}"),
    }
}

#[test]
fn fuzzed_meshes_are_those_of_the_log() {
    let mut job = Job::default();
    let mut told = [0; 6];
    for seed in 0..400 {
        case(seed, 24, 12, &mut job);
        let few = job.vertices.unwrap_or(usize::MAX).min(400);
        job.vertices = Some(few);
        let Some((_, log)) = check(&job) else {
            continue;
        };
        for step in log.steps {
            let kind = match step.event {
                Event::Encroached { .. } => 0,
                Event::CircumcenterRejected { .. } => 1,
                Event::TriangleConsidered { .. } => 2,
                Event::DivisionFailed { .. } => 3,
                Event::VertexMoved { .. } => 4,
                Event::StageEnded {
                    stage: Stage::Lattice,
                    ..
                } => 5,
                _ => continue,
            };
            told[kind] += 1;
        }
    }
    assert!(told.iter().all(|&n| n > 0), "{told:?}");
}

#[test]
fn scaled_meshes_are_told_where_they_are() {
    let mut job = Job::default();
    for seed in 0..40 {
        case(seed, 12, 8, &mut job);
        job.vertices = Some(job.vertices.unwrap_or(usize::MAX).min(100));
        for exponent in [-300, 300] {
            check(&job.scaled(exponent));
        }
    }
}

fn input(pslg: Pslg, quality: Quality) -> Input<'static> {
    Input {
        domain: DomainRule::Carve,
        quality,
        ..Input::from_pslg(pslg)
    }
}

fn angle(degrees: f64) -> Quality {
    Quality {
        min_angle: Some(Angle::degrees(degrees)),
        ..Quality::default()
    }
}

/// A plate with a slit that ends close to its rim, and an acute corner.
fn plate() -> Pslg {
    let mut pslg = Pslg::from_points([
        (0.0, 0.0),
        (9.0, 0.0),
        (12.0, 5.0),
        (0.0, 6.0),
        (1.0, 0.3),
        (8.0, 0.5),
        (7.0, 3.0),
    ]);
    pslg.add_ring([0, 1, 2, 3]);
    pslg.add_segment(4, 5);
    pslg.add_segment(4, 6);
    pslg
}

#[test]
fn every_line_tells_something() {
    let mut told = vec![0; Algorithm::Refinement.about().code.len() + 1];
    let sized = |max_edge| Quality {
        max_edge: Some(max_edge),
        ..angle(33.0)
    };
    for quality in [angle(20.0), angle(33.0), sized(3.0), sized(0.5)] {
        let (_, log) = run(Algorithm::Refinement, &input(plate(), quality));
        check_causes(&log);
        for step in log.steps {
            told[usize::from(step.line)] += 1;
        }
    }
    let silent: Vec<_> = (0..told.len()).filter(|&line| told[line] == 0).collect();
    // Where places are tried, and smoothing, for which an input does not ask.
    assert_eq!(silent, [10, 14]);
}

#[test]
fn smoothing_moves_vertices() {
    let mut job = Job {
        quality: Quality {
            max_edge: Some(1.0),
            ..angle(28.0)
        },
        smoothing: 3,
        ..Job::default()
    };
    job.domain.pslg = plate();
    job.domain.rule = DomainRule::Carve;
    let (_, log) = check(&job).expect("a domain");
    let is_move = |s: &&Step| matches!(s.event, Event::VertexMoved { .. });
    let smoothed = log.steps.iter().filter(is_move).filter(|s| s.line == 14);
    assert!(smoothed.count() > 10);
}

#[test]
fn points_alone_are_refined_within_their_hull() {
    for (i, kind) in Kind::ALL.into_iter().enumerate() {
        let points = kind.points(20, i as u64);
        let input = Input::from_points(points.iter().copied());
        let (output, log) = run(Algorithm::Refinement, &input);
        check_causes(&log);
        let expected = Refinement::new(Quality::default()).mesh(Pslg::from_points(points));
        let expected = expected.expect("finite points").mesh;
        assert_eq!(output.hash(), expected.triangulation().hash(), "{kind:?}");
        assert_eq!(output.duplicates, expected.triangulation().duplicates());
    }
}
