//! Jobs, and how they must end.

use delone::{Angle, DomainRule, Outcome, Point, Pslg, Quality, RefinedMesh, SegmentPolicy};
use delone_testkit::domains::Domain;
use delone_testkit::refined::{Job, judge};
use std::fmt::Write as _;

/// Angles that refinement ends with in practice.
pub const USUAL: [f64; 3] = [20.0, 30.0, 33.0];

/// Angles beyond that: floors and budget must end it.
pub const BEYOND: [f64; 2] = [45.0, 59.0];

/// Vertices that no small domain needs.
pub const PLENTY: usize = 60_000;

pub fn asking(degrees: f64) -> Quality {
    Quality {
        min_angle: Some(Angle::degrees(degrees)),
        ..Quality::default()
    }
}

/// A domain without budget, carved, crossings split.
pub fn job(pslg: Pslg, degrees: f64) -> Job {
    Job {
        domain: Domain {
            pslg,
            crossings: SegmentPolicy::Split,
            rule: DomainRule::Carve,
        },
        quality: asking(degrees),
        ..Job::default()
    }
}

/// A closed outline through points.
pub fn ring<P: Into<Point>>(points: impl IntoIterator<Item = P>) -> Pslg {
    let mut pslg = Pslg::from_points(points);
    pslg.add_ring(0..pslg.points.len() as u32);
    pslg
}

pub fn square(side: f64) -> Pslg {
    ring([(0.0, 0.0), (side, 0.0), (side, side), (0.0, side)])
}

/// Refines and judges.
#[track_caller]
pub fn mesh(job: &Job) -> RefinedMesh {
    let refined = job.mesh(2, &()).unwrap_or_else(|e| panic!("{e}"));
    judge(job, &refined).unwrap_or_else(|why| panic!("{why}\n{:?}", job.quality));
    refined
}

/// Everything is reached but what has an excuse.
#[track_caller]
pub fn assert_complete(job: &Job) -> RefinedMesh {
    let job = Job {
        vertices: Some(PLENTY),
        ..job.clone()
    };
    let refined = mesh(&job);
    assert_eq!(
        refined.report.outcome,
        Outcome::Complete,
        "{:?}{}",
        job.quality,
        unexcused(&refined)
    );
    refined
}

/// Lists some of the triangles that nothing excuses.
fn unexcused(refined: &RefinedMesh) -> String {
    let unmet = refined.report.unmet.iter();
    let mut list = String::new();
    for unmet in unmet.filter(|u| !u.reason.is_excused()).take(4) {
        let triangulation = refined.mesh.triangulation();
        let corners = triangulation.mesh().corners(unmet.triangle);
        let points = corners.map(|v| triangulation.point(v));
        let _ = write!(list, "\n{unmet:?} {points:?}");
    }
    list
}

/// A domain is finished at 20 and 30 degrees, ends at 33 by itself, and beyond by whatever ends it.
#[track_caller]
pub fn assert_ends(pslg: &Pslg) {
    for degrees in USUAL {
        let mut job = job(pslg.clone(), degrees);
        if degrees <= 30.0 {
            assert_complete(&job);
        } else {
            job.vertices = Some(PLENTY);
            assert_ne!(mesh(&job).report.outcome, Outcome::BudgetExhausted);
        }
    }
    assert_ends_beyond(pslg);
}

/// A domain stays valid and truly reported whatever angle is asked for.
#[track_caller]
pub fn assert_ends_beyond(pslg: &Pslg) {
    for degrees in BEYOND {
        let mut job = job(pslg.clone(), degrees);
        job.vertices = Some(3000);
        mesh(&job);
    }
}
