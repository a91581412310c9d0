//! What queries cost: `cargo run --release --example query_cost [points] [queries]`.

use delone::Point;
use delone::locate::Locator;
use std::time::Instant;

/// A deterministic stream of numbers in [0, 1).
fn unit(state: &mut u64) -> f64 {
    *state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let z = (*state ^ (*state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    (z >> 11) as f64 / (1u64 << 53) as f64
}

fn uniform(count: usize, seed: u64) -> Vec<Point> {
    let state = &mut seed.clone();
    (0..count)
        .map(|_| Point::new(unit(state), unit(state)))
        .collect()
}

fn timed<T>(what: &str, count: usize, work: impl Fn() -> T) -> T {
    let mut best = f64::INFINITY;
    let mut last = None;
    for _ in 0..5 {
        let clock = Instant::now();
        last = Some(work());
        best = best.min(clock.elapsed().as_secs_f64());
    }
    println!("{what}: {:.1} ns", 1e9 * best / count as f64);
    last.expect("five rounds")
}

fn main() -> Result<(), delone::Error> {
    let mut sizes = std::env::args()
        .skip(1)
        .map(|s| s.parse().expect("a number"));
    let n = sizes.next().unwrap_or(1_000_000);
    let m = sizes.next().unwrap_or(n);
    let points = uniform(n, 1);
    let queries = uniform(m, 2);
    let t = timed("triangulate, per point", n, || {
        delone::Delaunay::new()
            .threads(1)
            .triangulate(points.iter().copied())
    })?;
    let locator = timed("build locator, per point", n, || Locator::new(&t)).threads(1);
    timed("locate_all, per query", m, || {
        locator.locate_all(&queries, &())
    })?;
    timed("locate, per query", m, || {
        queries
            .iter()
            .filter(|&&q| locator.locate(q).is_ok())
            .count()
    });
    Ok(())
}
