//! Budgets and cancellation: wherever it stops, the mesh is valid and the report true.

use crate::support::{asking, job, mesh, square};
use delone::{Budget, DomainRule, Error, Outcome, Phase, Reason, Refinement, Watch};
use delone_testkit::refined::{Job, judge};
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};
use std::time::{Duration, Instant};

/// A square with a short segment, to be cut into about ten thousand triangles.
fn fine() -> Job {
    let mut pslg = square(1.0);
    pslg.points
        .extend([(0.3, 0.4), (0.3001, 0.4)].map(delone::Point::from));
    pslg.add_segment(4, 5);
    let mut job = job(pslg, 25.0);
    job.quality.max_edge = Some(0.02);
    job
}

#[test]
fn budgets_of_vertices_are_kept_exactly() {
    let all = mesh(&fine()).mesh.triangulation().num_vertices();
    assert!(all > 2000, "{all}");
    for most in [0, 4, 6, 7, 8, 10, 50, 100, 500, 1000, all - 1] {
        let mut job = fine();
        job.vertices = Some(most);
        let refined = mesh(&job);
        assert_eq!(refined.report.outcome, Outcome::BudgetExhausted, "{most}");
        let vertices = refined.mesh.triangulation().num_vertices();
        // Splits with a lens delete vertices first, so a few may be left over.
        assert!(
            vertices <= most.max(6) && vertices + 8 >= most,
            "{vertices} of {most}"
        );
        let mut reasons = refined.report.unmet.iter().map(|u| u.reason);
        assert!(reasons.any(|r| r == Reason::Stopped));
    }
    let mut job = fine();
    job.vertices = Some(all + 1);
    assert_eq!(mesh(&job).report.outcome, Outcome::Complete);
}

#[test]
fn budgets_of_time_are_kept() {
    let mut job = fine();
    job.quality.max_edge = Some(1e-4);
    let start = Instant::now();
    let refined = Refinement::new(job.quality)
        .domain(DomainRule::Carve)
        .budget(Budget {
            time: Some(Duration::from_millis(100)),
            ..Budget::default()
        })
        .mesh(job.domain.pslg.clone());
    let elapsed = start.elapsed();
    let refined = refined.unwrap();
    assert_eq!(refined.report.outcome, Outcome::BudgetExhausted);
    assert!(refined.mesh.num_steiner() > 0);
    assert!(elapsed < Duration::from_secs(20), "{elapsed:?}");
    // The judge knows of no time: any number of vertices is a budget, too.
    job.vertices = Some(usize::MAX);
    judge(&job, &refined).unwrap_or_else(|why| panic!("{why}"));
}

/// Cancels when asked for the n-th time, from some phase on.
struct CancelAt {
    left: AtomicU64,
    is_refining: std::sync::atomic::AtomicBool,
}

impl CancelAt {
    fn call(n: u64) -> Self {
        Self {
            left: AtomicU64::new(n),
            is_refining: false.into(),
        }
    }
}

impl Watch for CancelAt {
    fn progress(&self, phase: Phase, _: u64, _: u64) {
        if phase == Phase::Refine {
            self.is_refining.store(true, Relaxed);
        }
    }

    fn is_cancelled(&self) -> bool {
        let take = |left: u64| left.checked_sub(1);
        self.left.fetch_update(Relaxed, Relaxed, take).is_err()
    }
}

#[test]
fn cancelled_refinement_leaves_a_valid_mesh_or_an_error() {
    let (mut errors, mut meshes, mut ended) = (0, 0, 0);
    for calls in 0..60 {
        let job = fine();
        let watch = CancelAt::call(calls);
        match job.mesh(2, &watch) {
            Ok(refined) => {
                judge(&job, &refined).unwrap_or_else(|why| panic!("{calls}: {why}"));
                match refined.report.outcome {
                    Outcome::Cancelled => meshes += 1,
                    Outcome::Complete => ended += 1,
                    other => panic!("{other:?}"),
                }
            }
            Err(error) => {
                assert_eq!(error, Error::Cancelled);
                let is_refining = watch.is_refining.load(Relaxed);
                assert!(
                    !is_refining,
                    "cancelled after {calls} calls, without the mesh so far"
                );
                errors += 1;
            }
        }
    }
    assert!(
        errors > 0 && meshes > 0,
        "{errors} errors, {meshes} meshes, {ended} ended"
    );
}

/// Cancels some time after refinement began, and remembers when.
struct CancelAfter {
    start: std::sync::OnceLock<Instant>,
    delay: Duration,
}

impl Watch for CancelAfter {
    fn progress(&self, phase: Phase, _: u64, _: u64) {
        if phase == Phase::Refine {
            self.start.get_or_init(Instant::now);
        }
    }

    fn is_cancelled(&self) -> bool {
        self.start
            .get()
            .is_some_and(|start| start.elapsed() > self.delay)
    }
}

#[test]
fn cancellation_is_answered_soon() {
    let mut job = fine();
    job.quality.max_edge = Some(1e-4);
    let watch = CancelAfter {
        start: Default::default(),
        delay: Duration::from_millis(50),
    };
    let refined = job.mesh(2, &watch).unwrap();
    let elapsed = watch.start.get().expect("progress is reported").elapsed();
    assert_eq!(refined.report.outcome, Outcome::Cancelled);
    judge(&job, &refined).unwrap_or_else(|why| panic!("{why}"));
    // 100 ms are promised; handing out the mesh and a busy machine need some more.
    assert!(elapsed < Duration::from_secs(5), "{elapsed:?}");
}

/// Sums up what is reported.
#[derive(Default)]
struct Progress {
    calls: AtomicU64,
    most: AtomicU64,
}

impl Watch for Progress {
    fn progress(&self, phase: Phase, done: u64, total: u64) {
        if phase == Phase::Refine {
            assert!(done <= total.max(done));
            self.calls.fetch_add(1, Relaxed);
            self.most.fetch_max(done, Relaxed);
        }
    }
}

#[test]
fn progress_is_reported_in_vertices() {
    let watch = Progress::default();
    let refined = fine().mesh(1, &watch).unwrap();
    let vertices = refined.mesh.triangulation().num_vertices() as u64;
    assert!(watch.calls.load(Relaxed) > 0);
    let most = watch.most.load(Relaxed);
    assert!(most > 0 && most <= vertices, "{most} of {vertices}");
}

#[test]
fn a_budget_below_the_input_still_triangulates() {
    let refined = Refinement::new(asking(30.0))
        .budget(Budget {
            vertices: Some(1),
            ..Budget::default()
        })
        .mesh(fine().domain.pslg);
    let refined = refined.unwrap();
    assert_eq!(refined.mesh.num_steiner(), 0);
    assert!(refined.mesh.triangulation().num_triangles() > 0);
}
