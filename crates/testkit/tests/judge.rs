//! The judge of refined meshes lets right ones pass, and finds each way of lying about one.

use delone::{
    Angle, Broken, DomainRule, Encroachment, Locked, Outcome, Point, Pslg, Quality, Reason,
    RefinedMesh, SegmentPolicy, TriangleId, Unmet,
};
use delone_testkit::domains::Domain;
use delone_testkit::refined::{Cone, Job, Shape, judge};

/// A slim right triangle: 10° at its first corner.
fn wedge() -> Pslg {
    let height = 4.0 * 10f64.to_radians().tan();
    let mut pslg = Pslg::from_points([(0.0, 0.0), (4.0, 0.0), (4.0, height)]);
    pslg.add_ring([0u32, 1, 2]);
    pslg
}

fn job(pslg: Pslg) -> Job {
    Job {
        domain: Domain {
            pslg,
            crossings: SegmentPolicy::Split,
            rule: DomainRule::Carve,
        },
        ..Job::default()
    }
}

fn asking(degrees: f64) -> Quality {
    Quality {
        min_angle: Some(Angle::degrees(degrees)),
        ..Quality::default()
    }
}

/// Triangulates only: nothing is asked for, so that nothing is refined.
fn unrefined(job: &Job) -> RefinedMesh {
    job.mesh(1, &()).expect("a mesh")
}

/// The one triangle of the wedge, as if it had been left so for a reason although 20° were asked for.
fn left(reason: Reason) -> (Job, RefinedMesh) {
    let mut job = job(wedge());
    let mut refined = unrefined(&job);
    assert_eq!(refined.mesh.triangulation().num_triangles(), 1);
    job.quality = asking(20.0);
    refined.report.asked = job.quality;
    refined.report.unmet = vec![Unmet {
        triangle: TriangleId::new(0),
        broken: Broken {
            angle: true,
            ..Broken::default()
        },
        min_angle: Angle::degrees(10.0),
        reason,
    }];
    (job, refined)
}

fn small_input_angle() -> Reason {
    Reason::SmallInputAngle {
        vertex: 0.into(),
        segments: [0, 2],
        angle: Angle::degrees(10.0),
    }
}

#[track_caller]
fn assert_found(job: &Job, refined: &RefinedMesh, culprit: &str) {
    let why = judge(job, refined).expect_err("something is wrong");
    assert!(why.contains(culprit), "{why}");
}

#[test]
fn right_meshes_pass() {
    let job = job(wedge());
    assert_eq!(judge(&job, &unrefined(&job)), Ok(()));
    let (job, refined) = left(small_input_angle());
    assert_eq!(judge(&job, &refined), Ok(()));
}

#[test]
fn other_inputs_are_found() {
    let right = job(wedge());
    let refined = unrefined(&right);
    let mut moved = right.clone();
    moved.domain.pslg.points[2].y += 1.0;
    assert_found(&moved, &refined, "input points moved");
    let mut turned = right.clone();
    turned.domain.pslg.segments[1].reverse();
    assert_found(&turned, &refined, "other input");
    let mut hollow = right.clone();
    hollow.domain.pslg.holes.push(Point::new(3.0, 0.1));
    assert_found(&hollow, &refined, "another domain");
}

#[test]
fn triangles_that_are_not_reported_are_found() {
    let (job, mut refined) = left(small_input_angle());
    refined.report.unmet.clear();
    assert_found(&job, &refined, "breaks");
    let (mut job, mut refined) = left(small_input_angle());
    job.quality.max_edge = Some(2.0);
    refined.report.asked = job.quality;
    assert_found(&job, &refined, "breaks");
    (job, refined) = left(small_input_angle());
    job.quality.max_area = Some(1.0);
    refined.report.asked = job.quality;
    assert_found(&job, &refined, "breaks");
    (job, refined) = left(small_input_angle());
    job.sizing = Some(Cone {
        tip: Point::new(0.0, 0.0),
        least: 1.0,
        growth: 0.1,
    });
    assert_found(&job, &refined, "breaks");
}

#[test]
fn triangles_that_are_reported_wrongly_are_found() {
    let (job, mut refined) = left(small_input_angle());
    refined.report.unmet[0].min_angle = Angle::degrees(11.0);
    assert_found(&job, &refined, "is said to have 11");
    let (job, mut refined) = left(small_input_angle());
    refined.report.unmet[0].broken.edge = true;
    assert_found(&job, &refined, "breaks");
    let (job, mut refined) = left(small_input_angle());
    let again = refined.report.unmet[0];
    refined.report.unmet.push(again);
    assert_found(&job, &refined, "do not ascend");
    refined.report.unmet[1].triangle = TriangleId::new(1);
    assert_found(&job, &refined, "does not exist");
}

#[test]
fn outcomes_that_do_not_fit_are_found() {
    let (job, mut refined) = left(Reason::Gradation);
    assert_found(&job, &refined, "Complete with 1 unmet");
    refined.report.outcome = Outcome::PrecisionLimit;
    assert_eq!(judge(&job, &refined), Ok(()));
    refined.report.outcome = Outcome::BudgetExhausted;
    assert_found(&job, &refined, "BudgetExhausted");
    let (job, mut refined) = left(small_input_angle());
    refined.report.outcome = Outcome::PrecisionLimit;
    assert_found(&job, &refined, "PrecisionLimit with 0");
    refined.report.outcome = Outcome::Complete;
    refined.report.asked = asking(21.0);
    assert_found(&job, &refined, "was not asked for");
}

#[test]
fn counts_that_are_wrong_are_found() {
    let (job, mut refined) = left(small_input_angle());
    refined.report.free = 1;
    assert_found(&job, &refined, "Steiner points are not");
    // Measured of another mesh.
    let (job, refined) = left(small_input_angle());
    let mut other = unrefined(&self::job(Pslg::default()));
    assert_eq!(other.statistics().triangles, 0);
    (other.mesh, other.report) = (refined.mesh, refined.report);
    assert_found(&job, &other, "statistics");
}

#[test]
fn false_excuses_are_found() {
    let small = |vertex: u32, segments, degrees| Reason::SmallInputAngle {
        vertex: vertex.into(),
        segments,
        angle: Angle::degrees(degrees),
    };
    let no_meeting = [
        small(0, [0, 2], 12.0),
        small(0, [0, 0], 10.0),
        small(0, [0, 1], 10.0),
        small(1, [0, 1], 90.0),
        small(1, [0, 2], 10.0),
    ];
    for reason in no_meeting {
        let (job, refined) = left(reason);
        assert_found(&job, &refined, "the segments meet there at");
    }
    let (job, refined) = left(Reason::LockedBoundary);
    assert_found(&job, &refined, "it does not hang on a locked edge");
    let (job, refined) = left(Reason::Precision);
    assert_found(&job, &refined, "its shortest edge");
    let (mut job, mut refined) = left(Reason::Stopped);
    job.vertices = Some(3);
    refined.report.outcome = Outcome::PrecisionLimit;
    assert_found(&job, &refined, "nothing stopped");
    refined.report.outcome = Outcome::BudgetExhausted;
    assert_eq!(judge(&job, &refined), Ok(()));
}

#[test]
fn a_small_angle_excuses_only_what_touches_it() {
    // The wedge, and far from it a needle of its own that no segment has made.
    let mut job = job(wedge());
    let far = [(9.0, 0.0), (13.0, 0.0), (13.0, 0.5), (9.0, 0.5)];
    job.domain.pslg.points.extend(far.map(Point::from));
    job.domain.pslg.add_ring(3..7u32);
    let mut refined = unrefined(&job);
    job.quality = asking(20.0);
    refined.report.asked = job.quality;
    let triangulation = refined.mesh.triangulation();
    let shapes = triangulation.triangles().iter().map(|t| {
        let corners = t.map(|v| triangulation.point(v));
        Shape::of(corners).min_angle()
    });
    let unmet = shapes.enumerate().map(|(t, angle)| Unmet {
        triangle: TriangleId::new(t),
        broken: Broken {
            angle: true,
            ..Broken::default()
        },
        min_angle: Angle::degrees(angle),
        reason: small_input_angle(),
    });
    let unmet: Vec<_> = unmet.collect();
    assert_eq!(unmet.len(), 3);
    refined.report.unmet = unmet;
    assert_found(&job, &refined, "neither has it the corner");
}

#[test]
fn locked_edges_are_an_excuse_where_they_are_locked() {
    let (mut job, refined) = left(Reason::LockedBoundary);
    for locked in [Locked::Boundary, Locked::Segments] {
        job.locked = locked;
        assert_eq!(judge(&job, &refined), Ok(()));
    }
}

#[test]
fn encroached_segments_are_found_if_circles_were_asked_for() {
    let mut pslg = Pslg::from_points([(0.0, 0.0), (4.0, 0.0), (2.0, 1.0)]);
    pslg.add_ring([0u32, 1, 2]);
    let job = Job {
        encroachment: Encroachment::Circle,
        ..job(pslg)
    };
    let lens = Job {
        encroachment: Encroachment::Lens,
        ..job.clone()
    };
    assert_found(&job, &unrefined(&lens), "diametral circle");
}
