//! The same domain elsewhere, and in other sizes.

use crate::support::{assert_complete, job, mesh, ring};
use delone::{Outcome, Point, Pslg};
use delone_testkit::fuzz::refine::is_same;
use delone_testkit::refined::Job;

/// An outline with a notch and a line in it, small whole numbers.
fn notch() -> Pslg {
    let mut pslg = ring([(0.0, 0.0), (8.0, 0.0), (8.0, 8.0), (4.0, 1.0), (0.0, 8.0)]);
    pslg.points
        .extend([(1.0, 1.0), (3.0, 2.0)].map(Point::from));
    pslg.add_segment(5, 6);
    pslg
}

fn moved(pslg: &Pslg, to: impl Fn(Point) -> Point) -> Pslg {
    let mut pslg = pslg.clone();
    pslg.points.iter_mut().for_each(|p| *p = to(*p));
    pslg
}

#[test]
fn powers_of_two_scale_the_mesh() {
    let mut bounded = job(notch(), 30.0);
    bounded.quality.max_edge = Some(1.0);
    bounded.quality.max_area = Some(0.375);
    for job in [job(notch(), 20.0), job(notch(), 33.0), bounded] {
        let original = mesh(&job);
        for exponent in [-900, -300, -40, 1, 60, 300, 900] {
            let job = job.scaled(exponent);
            // Squared lengths leave the range: such an area cannot be asked for.
            if job
                .quality
                .max_area
                .is_some_and(|a| a == 0.0 || a.is_infinite())
            {
                continue;
            }
            let scaled = mesh(&job);
            assert!(
                is_same(&original, &scaled, exponent),
                "2^{exponent}: {:?}",
                job.quality
            );
        }
    }
}

#[test]
fn subnormal_and_enormous_coordinates_end() {
    for exponent in [-1074, -1070, -1060, -1040, 1000, 1020] {
        let mut job = job(notch(), 30.0).scaled(exponent);
        job.vertices = Some(20_000);
        let refined = mesh(&job);
        assert_ne!(
            refined.report.outcome,
            Outcome::BudgetExhausted,
            "2^{exponent}"
        );
    }
    let decimal = moved(&notch(), |p| Point::new(p.x * 1e300, p.y * 1e300));
    assert_complete(&job(decimal, 30.0));
}

#[test]
fn domains_with_wide_exponents_end() {
    // A speck beside the origin, in a domain that is 10²⁰⁰ times as large.
    for speck in [1e-3, 1e-30, 1e-200, 5e-324] {
        let mut pslg = ring([(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]);
        pslg.points
            .extend([(0.0, 0.0), (speck, 0.0), (0.0, speck)].map(Point::from));
        pslg.add_ring([4u32, 5, 6]);
        let mut job = job(pslg, 20.0);
        job.vertices = Some(60_000);
        let refined = mesh(&job);
        assert_ne!(refined.report.outcome, Outcome::BudgetExhausted, "{speck}");
    }
}

#[test]
fn domains_far_away_end() {
    for offset in [1e6, -1e9, 1e12] {
        let far = moved(&notch(), |p| Point::new(p.x + offset, p.y - offset));
        assert_complete(&job(far.clone(), 20.0));
        assert_complete(&job(far, 30.0));
    }
    // Here lattice points are 1/8 apart: precision ends it, and says so.
    let far = moved(&notch(), |p| Point::new(p.x + 1e15, p.y - 1e15));
    for degrees in [20.0, 33.0, 59.0] {
        let mut job = job(far.clone(), degrees);
        job.vertices = Some(20_000);
        let refined = mesh(&job);
        assert_ne!(refined.report.outcome, Outcome::BudgetExhausted);
    }
}

#[test]
fn quarter_turns_and_mirrors_stay_right() {
    let turns: [fn(Point) -> Point; 4] = [
        |p| Point::new(-p.y, p.x),
        |p| Point::new(-p.x, -p.y),
        |p| Point::new(-p.x, p.y),
        |p| Point::new(p.y, p.x),
    ];
    for turn in turns {
        assert_complete(&job(moved(&notch(), turn), 30.0));
    }
}

#[test]
fn the_same_input_has_the_same_mesh_on_any_number_of_threads() {
    let mut pslg = notch();
    let loose = delone_testkit::generate::Kind::Uniform.points(300, 1);
    pslg.points.extend(loose);
    let job = Job {
        vertices: Some(20_000),
        ..job(pslg, 30.0)
    };
    let one = job.mesh(1, &()).unwrap();
    for threads in [1, 2, 4] {
        let other = job.mesh(threads, &()).unwrap();
        assert!(is_same(&one, &other, 0), "{threads} threads");
    }
}

#[test]
fn unmet_triangles_are_the_same_on_any_number_of_threads() {
    let mut pslg = notch();
    let loose = delone_testkit::generate::Kind::Uniform.points(30_000, 1);
    pslg.points.extend(loose);
    let job = Job {
        vertices: Some(31_000),
        ..job(pslg, 30.0)
    };
    let judged = mesh(&job);
    assert!(judged.report.unmet.len() > 10_000);
    for threads in [1, 4] {
        let other = job.mesh(threads, &()).unwrap();
        assert!(is_same(&judged, &other, 0), "{threads} threads");
    }
}

#[test]
fn the_order_of_the_input_changes_nothing_that_matters() {
    // Queues run in the order of the curve, but ties may go by number: only the judgement is the same.
    let original = job(notch(), 30.0);
    let mut random = delone_testkit::generate::Random::new(1);
    for _ in 0..5 {
        let mut other = original.clone();
        other.domain = original.domain.permuted(&mut random);
        assert_complete(&other);
    }
}
