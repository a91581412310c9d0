//! Fits a quadratic polynomial in each triangle to depths with errors; the example of `docs/scattered.md`.

use delone::Point;
use delone::scattered::cover;
use delone::surface::{FitOptions, Interpolant, LocalFits};

/// Compares measured and fitted depths with the true ones.
pub fn main() -> Result<(), delone::Error> {
    let share = |i: u32, of: f64| (f64::from(i) * of).fract();
    let depth = |p: &Point| (4.0 * p.x).sin() + p.y * p.y;
    let error = |i: u32| 0.2 * (share(i, 0.618_034) - 0.5);
    let data: Vec<Point> = (0..2000)
        .map(|i| Point::new(share(i, 0.754_878), share(i, 0.569_840)))
        .collect();
    let measured: Vec<f64> = (0..).zip(&data).map(|(i, p)| depth(p) + error(i)).collect();

    let cover = cover(data.iter().copied(), 60)?;
    let fits = LocalFits::new(&cover, measured.clone(), FitOptions::degree(2), &())?;
    let off = |values: &[f64]| {
        let squares = data.iter().zip(values).map(|(p, v)| (v - depth(p)).powi(2));
        (squares.sum::<f64>() / data.len() as f64).sqrt()
    };
    let fitted: Vec<f64> = data.iter().filter_map(|&p| fits.value(p)).collect();
    println!("{} triangles", cover.triangles().len());
    println!("measured values are off by {:.4}", off(&measured));
    println!("those of the fits by {:.4}", off(&fitted));
    Ok(())
}
