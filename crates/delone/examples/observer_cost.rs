//! What observing costs: every classical algorithm unobserved, counted, and logged.
//!
//! `cargo run --release -p delone --example observer_cost [POINTS]`
//!
//! The first rows are the proof that who does not observe pays nothing: divide and conquer with `()` is
//! the builder itself.

use delone::classic::{Algorithm, Input};
use delone::{Delaunay, Log, Observer, Point, Step, Tally};
use delone_testkit::generate::Kind;
use std::time::{Duration, Instant};

/// Runs that count; the fastest is printed.
const RUNS: usize = 5;

fn main() {
    let n = std::env::args()
        .nth(1)
        .map_or(2000, |n| n.parse().expect("a number of points"));
    let points = Kind::Uniform.points(n, 1);
    let input = Input::from_points(points.iter().copied());
    let builder = fastest(|| one_thread(&points));
    println!("{n} uniform points, one thread, nanoseconds a point; fastest of {RUNS}\n");
    println!("| algorithm | unobserved | counted | logged | steps a point | bytes a step |");
    println!("|---|---:|---:|---:|---:|---:|");
    println!(
        "| `Delaunay::triangulate` | {} | – | – | – | – |",
        per_point(builder, n)
    );
    for &algorithm in Algorithm::ALL {
        let about = algorithm.about();
        if algorithm.refines() {
            continue; // It needs a domain.
        }
        let steps = observe(algorithm, &input, Tally::default()).steps;
        let unobserved = fastest(|| algorithm.run(&input));
        let counted = fastest(|| observe(algorithm, &input, Tally::default()));
        let logged = fastest(|| observe(algorithm, &input, Log::default()));
        println!(
            "| {} | {} | {} | {} | {:.1} | {} |",
            about.name,
            per_point(unobserved, n),
            per_point(counted, n),
            per_point(logged, n),
            steps as f64 / n as f64,
            size_of::<Step>(),
        );
    }
}

fn one_thread(points: &[Point]) -> usize {
    let result = Delaunay::new()
        .threads(1)
        .triangulate(points.iter().copied());
    result.expect("finite points").num_triangles()
}

fn observe<O: Observer + Send>(algorithm: Algorithm, input: &Input, mut observer: O) -> O {
    algorithm
        .observe(input, &mut observer)
        .expect("finite points");
    observer
}

fn fastest<T>(mut run: impl FnMut() -> T) -> Duration {
    let time = |_| {
        let start = Instant::now();
        let _kept = run();
        start.elapsed()
    };
    (0..RUNS).map(time).min().expect("there are runs")
}

fn per_point(time: Duration, n: usize) -> u128 {
    time.as_nanos() / n as u128
}
