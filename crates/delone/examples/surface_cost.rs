//! Measures what a value of each surface costs: `cargo run --release --example surface_cost -- 1000000`.

use delone::surface::{
    CloughTocher, Estimate, Evaluation, Gradients, Interpolant, Linear, NaturalNeighbor, Samples,
    SmoothNaturalNeighbor, Weighing, contours, round_levels,
};
use delone::{Error, Point};
use std::time::Instant;

/// Draws points from the unit square.
fn scattered(n: usize, mut state: u64) -> Vec<Point> {
    let mut unit = move || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    (0..n).map(|_| Point::new(unit(), unit())).collect()
}

/// Prints the time since `start`, by item.
fn report(what: &str, start: Instant, items: usize) {
    let nanoseconds = start.elapsed().as_nanos() as f64 / items as f64;
    println!("{what:28} {nanoseconds:8.0} ns each");
}

/// Evaluates a surface at all points, on one thread.
fn ask(what: &str, surface: &dyn Interpolant, points: &[Point]) -> Result<(), Error> {
    let start = Instant::now();
    let values = Evaluation::new().threads(1).values(surface, points)?;
    report(what, start, points.len());
    assert!(values.iter().flatten().count() * 10 > 9 * values.len());
    Ok(())
}

fn main() -> Result<(), Error> {
    let argument = std::env::args().nth(1);
    let n = argument.and_then(|n| n.parse().ok()).unwrap_or(100_000);
    let triangulation = delone::triangulate(scattered(n, 1))?;
    let height = |p: &Point| (9.0 * p.x).sin() * (7.0 * p.y).cos();
    let values: Vec<f64> = triangulation.points().iter().map(height).collect();
    let samples = Samples::new(&triangulation, values)?;
    let points = scattered(n, 2);
    ask("linear", &Linear::new(&samples), &points)?;
    for weighing in [Weighing::Laplace, Weighing::Sibson] {
        let surface = NaturalNeighbor::new(&samples, weighing)?;
        ask(&format!("{weighing:?}"), &surface, &points)?;
    }
    for estimate in [Estimate::Mean, Estimate::Quadratic, Estimate::LeastBending] {
        let start = Instant::now();
        let gradients = Gradients::estimate(&samples, estimate, &())?;
        report(&format!("gradients, {estimate:?}"), start, n);
        if estimate == Estimate::LeastBending {
            ask(
                "Clough-Tocher",
                &CloughTocher::new(&samples, &gradients)?,
                &points,
            )?;
            let smooth = SmoothNaturalNeighbor::new(&samples, &gradients)?;
            ask("smooth natural neighbours", &smooth, &points)?;
        }
    }
    let levels = round_levels(20, [-1.0, 1.0])?;
    let start = Instant::now();
    let lines = contours(&samples, &levels, &())?;
    let crossings = lines.iter().map(|line| line.points.len()).sum();
    report("contours, by crossing", start, crossings);
    Ok(())
}
