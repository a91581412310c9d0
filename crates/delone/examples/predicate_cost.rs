//! Measures what a predicate costs, by kind of input and by the stage that decides.
//!
//! `cargo run --release --example predicate_cost`

use delone::Point;
use delone::predicates::stage::{self, Stage};
use delone::predicates::{in_circle_perturbed, orient2d};
use std::hint::black_box;
use std::time::Instant;

const CASES: usize = 4096;

fn main() {
    println!("nanoseconds a call; share of calls that each stage decides");
    report("uniform", |random| [(); 4].map(|()| random.point()));
    report("integer grid", |random| {
        on_square(random.below(1000), random.below(1000), 1.0)
    });
    report("grid of 0.1", |random| {
        on_square(random.below(1000), random.below(1000), 0.1)
    });
    report("circle, far apart", |random| {
        [(); 4].map(|()| on_circle(random.unit()))
    });
    report("circle, neighbours", |random| {
        let start = random.unit();
        [0.0, 1.0, 2.0, 3.0].map(|k| on_circle(start + k * 1e-6))
    });
    report("near one line, 1e±5", |random| {
        let at = |t: f64| Point::new(1e-5 * t, 1e5 * t);
        [(); 4].map(|()| at(random.unit()))
    });
    report("near one line, 1e±20", |random| {
        let at = |t: f64| Point::new(1e-20 * t, 1e20 * t);
        [(); 4].map(|()| at(random.unit()))
    });
}

/// Times both predicates on `CASES` quadruples.
fn report(name: &str, mut make: impl FnMut(&mut Random) -> [Point; 4]) {
    let mut random = Random(1);
    let cases: Vec<[Point; 4]> = (0..CASES).map(|_| make(&mut random)).collect();
    let orient = time(&cases, |[a, b, c, _]| black_box(orient2d(a, b, c)) as usize);
    let circle = time(&cases, |[a, b, c, d]| {
        usize::from(in_circle_perturbed(a, b, c, d))
    });
    println!(
        "{name:22} orient2d {orient:7.1} {}   in_circle_perturbed {circle:7.1} {}",
        shares(&cases, |[a, b, c, _]| stage::orient2d(a, b, c).1),
        shares(&cases, |[a, b, c, d]| stage::in_circle(a, b, c, d).1),
    );
}

/// Returns the best mean time of several rounds, in nanoseconds a call.
fn time(cases: &[[Point; 4]], predicate: impl Fn([Point; 4]) -> usize) -> f64 {
    let round = || {
        let start = Instant::now();
        let sum: usize = cases.iter().map(|&case| predicate(black_box(case))).sum();
        black_box(sum);
        start.elapsed().as_nanos() as f64 / cases.len() as f64
    };
    (0..20).map(|_| round()).fold(f64::INFINITY, f64::min)
}

fn shares(cases: &[[Point; 4]], stage: impl Fn([Point; 4]) -> Stage) -> String {
    let share = |wanted| cases.iter().filter(|&&c| stage(c) == wanted).count() as f64;
    let percent = [Stage::Filter, Stage::Integer, Stage::BigInteger]
        .map(|s| format!("{:3.0}", 100.0 * share(s) / cases.len() as f64));
    percent.join("/") + " %"
}

fn on_square(x: u64, y: u64, step: f64) -> [Point; 4] {
    [(0, 0), (1, 0), (1, 1), (0, 1)]
        .map(|(dx, dy)| Point::new((x + dx) as f64 * step, (y + dy) as f64 * step))
}

fn on_circle(turn: f64) -> Point {
    let (y, x) = (turn * std::f64::consts::TAU).sin_cos();
    Point::new(x, y)
}

/// A small generator (splitmix64), so that runs repeat.
struct Random(u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn below(&mut self, limit: u64) -> u64 {
        self.bits() % limit
    }

    fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn point(&mut self) -> Point {
        Point::new(self.unit(), self.unit())
    }
}
