//! What a cover costs.

use delone::scattered::Cover;
use std::time::Instant;
fn main() {
    let mut args = std::env::args()
        .skip(1)
        .map(|a| a.parse::<usize>().unwrap());
    let n = args.next().unwrap_or(100_000);
    let d = args.next().unwrap_or(10);
    let mut state = 1u64;
    let mut next = || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1);
        (state >> 33) as f64 / (1u64 << 31) as f64
    };
    let data: Vec<(f64, f64)> = (0..n).map(|_| (next(), next())).collect();
    for (b, c) in [(false, false), (true, false), (true, true)] {
        let start = Instant::now();
        let cover = Cover::new(d)
            .divides_edges(b)
            .divides_triangles(c)
            .cover(data.iter().copied())
            .unwrap();
        let counts = cover.counts();
        println!(
            "b {b} c {c}: {:.3} s, {} triangles, min {:?} max {:?} special {}",
            start.elapsed().as_secs_f64(),
            counts.len(),
            counts.iter().min(),
            counts.iter().max(),
            cover.exceptions().len()
        );
    }
}
