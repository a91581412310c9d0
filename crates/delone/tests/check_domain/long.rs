//! Long work: it reports, and can be cancelled.

use delone::check::{self, DomainMesh};
use delone::{DomainRule, Error, Phase, Pslg, VertexId, Watch};
use delone_testkit::generate::Kind;
use std::sync::atomic::{AtomicU64, Ordering};

/// Cancels when asked for the `limit`-th time.
struct Impatient {
    asked: AtomicU64,
    limit: u64,
    last: AtomicU64,
}

impl Watch for Impatient {
    fn progress(&self, phase: Phase, done: u64, total: u64) {
        assert_eq!(phase, Phase::Check);
        assert!(done <= total);
        self.last.store(total - done, Ordering::Relaxed);
    }

    fn is_cancelled(&self) -> bool {
        self.asked.fetch_add(1, Ordering::Relaxed) >= self.limit
    }
}

/// A square with many points in it, without segments: what the bare builder makes is right.
fn large() -> (Pslg, Vec<[VertexId; 3]>) {
    let input = Pslg::from_points(Kind::Uniform.points(20_000, 4));
    let t = delone::triangulate(input.points.iter().copied()).expect("finite");
    (input, t.triangles().to_vec())
}

#[test]
fn long_work_reports_and_can_be_cancelled_anywhere() {
    let (input, triangles) = large();
    let verify = |limit| {
        let watch = Impatient {
            asked: AtomicU64::new(0),
            limit,
            last: AtomicU64::new(1),
        };
        let mesh = DomainMesh::new(&input.points, &triangles, &[]);
        let verdict = check::verify_domain(&input, DomainRule::Hull, &mesh, &watch);
        (verdict, watch.asked.into_inner(), watch.last.into_inner())
    };
    let (verdict, polls, left) = verify(u64::MAX);
    let certificate = verdict
        .expect("not cancelled")
        .into_result()
        .expect("right");
    assert_eq!((certificate.points, left), (20_000, 0));
    assert!(polls > 100, "only {polls}");
    for limit in (0..polls).step_by(7) {
        assert_eq!(verify(limit).0, Err(Error::Cancelled), "{limit}");
    }
}
