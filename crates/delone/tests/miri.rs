//! Every room with `unsafe` in it, by cases small enough for Miri, which watches memory, aliasing and races. Under it
//! work is handed to other threads from a few points on; `docs/hardening.md` has the command.

use delone::locate::Locator;
use delone::nearest::Nearest;
use delone::{ConstrainedDelaunay, Delaunay, DomainRule, Error, Phase, Pslg, SegmentPolicy};
use delone::{VertexId, Watch, on_threads};
use delone_testkit::generate::Kind;
use std::sync::atomic::{AtomicU32, Ordering};

/// Cancels after so many looks.
struct Patience(AtomicU32);

impl Watch for Patience {
    fn progress(&self, _: Phase, _: u64, _: u64) {}

    fn is_cancelled(&self) -> bool {
        let left = |left: u32| left.checked_sub(1);
        let (set, fetch) = (Ordering::Relaxed, Ordering::Relaxed);
        self.0.fetch_update(set, fetch, left).is_err()
    }
}

/// Runs `work` with more and more patience until it is done in time.
fn cancelled_everywhere<T>(work: impl Fn(&dyn Watch) -> Result<T, Error>) {
    for looks in 0.. {
        match work(&Patience(looks.into())) {
            Err(error) => assert_eq!(error, Error::Cancelled),
            Ok(_) => break,
        }
    }
}

/// Runs a test on one thread and on three.
fn alone_and_on_threads(test: impl Fn() + Sync) {
    for threads in [1, 3] {
        on_threads(threads, &test).expect("few threads");
    }
}

/// Triangulates points of some kinds on one thread and on three.
fn triangulate(kinds: impl Iterator<Item = Kind> + Send, n: usize) {
    on_threads(3, || {
        for kind in kinds {
            let points = kind.points(n, 1);
            let [alone, together] = [1, 3].map(|threads| {
                let t = Delaunay::new().threads(threads);
                t.triangulate(points.iter().copied()).expect("finite")
            });
            alone.mesh().validate().expect("a closed sphere");
            assert_eq!(alone.mesh(), together.mesh(), "{kind:?}");
            assert_eq!(alone.duplicates(), together.duplicates(), "{kind:?}");
        }
    })
    .expect("three threads");
}

/// Kinds whose signs take large integers, which take Miri long.
const WIDE: [Kind; 3] = [Kind::WideExponents, Kind::Borders, Kind::RawBits];

#[test]
fn points_are_triangulated() {
    triangulate(
        Kind::ALL.into_iter().filter(|kind| !WIDE.contains(kind)),
        40,
    );
}

#[test]
fn points_far_and_near_are_triangulated() {
    triangulate(WIDE.into_iter(), 12);
}

#[test]
fn few_and_equal_points_are_triangulated() {
    let points = Kind::Lattice { side: 2 }.points(7, 3);
    for n in 0..=points.len() {
        let t = Delaunay::new().threads(1).triangulate(points[..n].to_vec());
        t.expect("finite").mesh().validate().expect("a sphere");
    }
    alone_and_on_threads(|| {
        let t = delone::triangulate([(1.0, 2.0); 40]).expect("finite");
        assert_eq!(t.duplicates().len(), 39);
    });
}

#[test]
fn segments_are_inserted() {
    let points = Kind::Lattice { side: 5 }.points(40, 2);
    let ends = Kind::Lattice { side: 40 }.points(45, 5);
    let segments = ends
        .iter()
        .map(|p| [p.x, p.y].map(|v| VertexId::new(v as usize)));
    let pslg = Pslg {
        segments: segments.collect(),
        points,
        ..Pslg::default()
    };
    alone_and_on_threads(|| {
        let t = ConstrainedDelaunay::new()
            .domain(DomainRule::Hull)
            .crossings(SegmentPolicy::Split)
            .triangulate(pslg.clone());
        let t = t.expect("crossings are cut").into_triangulation();
        t.mesh().validate().expect("a closed sphere");
    });
}

#[test]
fn many_questions_are_answered() {
    let t = delone::triangulate(Kind::Uniform.points(40, 1)).expect("finite");
    let asked = Kind::Uniform.points(50, 2);
    alone_and_on_threads(|| {
        let locator = Locator::new(&t);
        let found = locator.locate_all(&asked, &()).expect("finite");
        let alone = asked.iter().map(|&p| locator.locate(p).expect("finite"));
        assert!(found.into_iter().eq(alone));
        let index = Nearest::new(&t, &()).expect("not cancelled");
        let found = index.k_nearest_all(&asked, 3, &()).expect("finite");
        let alone = asked
            .iter()
            .map(|&p| index.k_nearest(p, 3).expect("finite"));
        assert!(found.into_iter().eq(alone));
    });
}

#[test]
fn whoever_cancels_leaves_nothing_behind() {
    let points = Kind::Uniform.points(50, 4);
    let t = delone::triangulate(points.iter().copied()).expect("finite");
    let index = Nearest::new(&t, &()).expect("not cancelled");
    let run = |watch: &dyn Watch| {
        Delaunay::new()
            .watch(watch)
            .triangulate(points.iter().copied())
    };
    alone_and_on_threads(|| {
        cancelled_everywhere(run);
        cancelled_everywhere(|watch| index.k_nearest_all(&points, 3, watch));
    });
}
