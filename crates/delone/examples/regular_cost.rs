//! Measures what a regular triangulation costs, by kind of weights.
//!
//! `cargo run --release --example regular_cost -- 1000000`; a word more takes the cases with that word.

use delone::{Point, regular};
use std::time::Instant;

fn main() {
    let n = std::env::args()
        .nth(1)
        .map_or(1_000_000, |n| n.parse().expect("a number"));
    let mut random = Random(1);
    let points: Vec<Point> = (0..n)
        .map(|_| Point::new(random.unit(), random.unit()))
        .collect();
    let spacing = 1.0 / n as f64;
    println!("{n} uniform points, nanoseconds a point; vertices");
    report("no weights", &points, |_, _| 0.0);
    report("radii of half the spacing", &points, |_, r| {
        0.25 * spacing * r
    });
    report("radii of up to ten spacings", &points, |_, r| {
        100.0 * spacing * r
    });
    report("up to a tenth of the square", &points, |_, r| 0.01 * r);
    report("on a plane when lifted", &points, |p, _| {
        p.x * p.x + p.y * p.y
    });
    let grid = |i: usize| Point::new((i % 1000) as f64, (i / 1000) as f64);
    let lattice: Vec<Point> = (0..n).map(grid).collect();
    report("lattice, no weights", &lattice, |_, _| 0.0);
    report("lattice, weights 0 to 3", &lattice, |_, r| {
        (4.0 * r).floor()
    });
    report("lattice, on a plane when lifted", &lattice, |p, _| {
        p.x * p.x + p.y * p.y
    });
    let row: Vec<Point> = points.iter().map(|p| Point::new(p.x, 0.5)).collect();
    report("on one line, radii as above", &row, |_, r| {
        spacing * spacing * r
    });
}

fn report(name: &str, points: &[Point], weight: impl Fn(Point, f64) -> f64) {
    let mut random = Random(2);
    let sites: Vec<_> = points
        .iter()
        .map(|&p| (p, weight(p, random.unit())))
        .collect();
    if !name.contains(&std::env::args().nth(2).unwrap_or_default()) {
        return;
    }
    let start = Instant::now();
    let t = regular::triangulate(sites).expect("finite");
    let each = start.elapsed().as_nanos() as f64 / points.len() as f64;
    let start = Instant::now();
    let triangles = t.triangulation().mesh().triangles();
    let sum: f64 = triangles.take(100_000).map(|t_| t.power_center(t_).x).sum();
    let dual = start.elapsed().as_nanos() as f64 / 1e5;
    println!(
        "{name:34} {each:7.0} {:9} {dual:6.0} {sum:e}",
        t.triangulation().num_vertices()
    );
}

/// SplitMix64.
struct Random(u64);

impl Random {
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }
}
