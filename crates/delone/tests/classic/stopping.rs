//! Steps that are long by themselves: who watches is asked within them, and work without end is refused.

use delone::classic::{Algorithm, Input};
use delone::{DomainRule, Error, Pslg, Quality, Watch};
use delone_testkit::generate::Kind;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Counts how often it is asked, and says yes once it has been asked often enough.
struct Asked {
    times: AtomicUsize,
    enough: usize,
}

impl Watch for Asked {
    fn is_cancelled(&self) -> bool {
        self.times.fetch_add(1, Ordering::Relaxed) + 1 >= self.enough
    }
}

/// Runs on few points, so that steps alone would never ask.
fn cancelled(algorithm: Algorithm, input: Input) -> usize {
    let watch = Asked {
        times: AtomicUsize::new(0),
        enough: 20,
    };
    let input = Input {
        watch: &watch,
        ..input
    };
    assert_eq!(algorithm.run(&input), Err(Error::Cancelled));
    watch.times.into_inner()
}

#[test]
fn searches_and_tests_of_sight_count() {
    let points = Kind::Uniform.points(600, 1);
    for algorithm in [
        Algorithm::GreedyFlips,
        Algorithm::PrintedSweep,
        Algorithm::Incremental,
        Algorithm::RandomIncremental,
    ] {
        let input = Input::from_points(points.iter().copied());
        assert_eq!(cancelled(algorithm, input), 20, "{algorithm:?}");
    }
}

#[test]
fn rays_to_all_sides_count() {
    // A ring of many sides: few flips, but every triangle is tested against every side.
    let sides = 1500;
    let angle = |i: u32| std::f64::consts::TAU * f64::from(i) / f64::from(sides);
    let points = (0..sides).map(|i| (angle(i).cos(), angle(i).sin()));
    let mut pslg = Pslg::from_points(points);
    pslg.add_ring(0..sides);
    let mut input = Input::from_pslg(pslg);
    input.domain = DomainRule::Carve;
    let watch = Asked {
        times: AtomicUsize::new(0),
        enough: usize::MAX,
    };
    input.watch = &watch;
    let unseen = Algorithm::Sweep.run(&input).expect("a domain");
    let before = watch.times.swap(0, Ordering::Relaxed);
    let mut log = delone::Log::new("sweep", input.pslg.points.clone());
    let seen = Algorithm::Sweep
        .observe(&input, &mut log)
        .expect("a domain");
    assert_eq!(seen, unseen);
    assert!(
        watch.times.into_inner() > before + 400,
        "asked {before} times unseen"
    );
}

#[test]
fn a_bound_that_has_lost_its_digits_is_refused() {
    let mut pslg = Pslg::from_points([(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)]);
    pslg.add_ring(0..3);
    let mut input = Input::from_pslg(pslg);
    input.quality = Quality {
        max_edge: Some(1e-9),
        ..Quality::default()
    };
    let refused = Algorithm::Thesis.run(&input);
    let is_right = matches!(
        refused,
        Err(Error::TooManyVertices {
            algorithm: "thesis",
            ..
        })
    );
    assert!(is_right, "{refused:?}");
}
