//! Counts the flips of incremental construction: linear in random order, whatever the points; quadratic in the worst.
//!
//! `cargo run --release -p delone-io --example random_flips -- docs/algorithms/pictures/random-flips.svg` prints a table
//! and draws it; a number more replaces the largest number of points, 30,000.
//!
//! The flips of `incremental` depend on the order of the points and not on how each is found. So they are counted in
//! `segment-walk`, which deletes exactly the edges that `incremental` flips, and finds points faster: but for those on
//! the parabola, where a walk crosses a fan of all triangles. So there are fewer of these.

use delone::classic::{Algorithm, Input};
use delone::{Point, Tally};
use delone_io::{Curve, Error, Panel, Target, write_plot};

/// Orders for each set of points.
const ORDERS: usize = 20;
/// Most points on the parabola.
const MOST_ON_CURVE: usize = 10_000;
/// The quantile of Student's distribution for 19 degrees of freedom, 95 % on both sides.
const STUDENT: f64 = 2.093;

fn main() -> Result<(), Error> {
    let path = std::env::args().nth(1);
    let most = std::env::args()
        .nth(2)
        .map_or(30_000, |n| n.parse().expect("a number"));
    let sizes = [100, 300, 1000, 3000, 10_000, 30_000, 100_000];
    println!("flips a point in {ORDERS} random orders: mean, 95 % confidence; worst order");
    println!(
        "{:>8} {:>18} {:>18} {:>12}",
        "points", "uniform", "curve", "curve, worst"
    );
    let mut rows = Vec::new();
    for n in sizes.into_iter().filter(|&n| n <= most) {
        let row = Row::count(n);
        println!("{row}");
        rows.push(row);
    }
    path.map_or(Ok(()), |path| draw(&path, &rows))
}

/// What is counted for one number of points.
struct Row {
    n: usize,
    /// Evenly in a square.
    uniform: Mean,
    /// On a parabola; `None`: too many points.
    curve: Option<Mean>,
    /// The same from its flat end to its tip.
    worst: Option<f64>,
}

impl Row {
    fn count(n: usize) -> Self {
        let mut random = Random(n as u64);
        let uniform: Vec<_> = (0..n)
            .map(|_| Point::new(random.unit(), random.unit()))
            .collect();
        let curve = (1..=n).rev().map(|i| i as f64);
        let curve: Vec<_> = curve.map(|x| Point::new(x, x * x)).collect();
        Self {
            n,
            uniform: Mean::of_orders(&uniform),
            curve: (n <= MOST_ON_CURVE).then(|| Mean::of_orders(&curve)),
            worst: (n <= MOST_ON_CURVE).then(|| flips_a_point(curve)),
        }
    }
}

impl std::fmt::Display for Row {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        let none = || "–".to_owned();
        let curve = self.curve.map_or_else(none, |mean| mean.to_string());
        let worst = self.worst.map_or_else(none, |flips| format!("{flips:.1}"));
        let Self { n, uniform, .. } = self;
        write!(f, "{n:>8} {uniform:>18} {curve:>18} {worst:>12}")
    }
}

/// A mean, and half the width of its confidence interval.
#[derive(Clone, Copy)]
struct Mean {
    mean: f64,
    half: f64,
}

impl Mean {
    fn of_orders(points: &[Point]) -> Self {
        let samples: Vec<_> = (0..ORDERS)
            .map(|seed| {
                let mut order = points.to_vec();
                Random(seed as u64).shuffle(&mut order);
                flips_a_point(order)
            })
            .collect();
        let mean = samples.iter().sum::<f64>() / ORDERS as f64;
        let squares: f64 = samples.iter().map(|x| (x - mean) * (x - mean)).sum();
        let deviation = (squares / (ORDERS - 1) as f64).sqrt();
        let half = STUDENT * deviation / (ORDERS as f64).sqrt();
        Self { mean, half }
    }
}

impl std::fmt::Display for Mean {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        f.pad(&format!("{:.3} ± {:.3}", self.mean, self.half))
    }
}

/// Inserts points in their order.
fn flips_a_point(points: Vec<Point>) -> f64 {
    let n = points.len() as f64;
    let mut tally = Tally::default();
    let walk = Algorithm::SegmentWalk;
    let done = walk.observe(&Input::from_points(points), &mut tally);
    done.expect("finite points");
    tally.edges_deleted as f64 / n
}

/// Draws two panels: random orders, with bands; and the worst order beside them.
fn draw(path: &str, rows: &[Row]) -> Result<(), Error> {
    let random = [
        curve("points in a square", rows, |row| Some(row.uniform)),
        curve("points on a parabola", rows, |row| row.curve),
    ];
    let exactly = |mean| Mean { mean, half: 0.0 };
    let worst = curve("the parabola from its flat end to its tip", rows, |row| {
        row.worst.map(exactly)
    });
    let panel = |title: &str, curves| Panel {
        title: title.to_owned(),
        curves,
    };
    let beside = random.iter().cloned().chain([worst]).collect();
    let panels = [
        panel("random order: flips a point", random.into()),
        panel("the same, and the worst order", beside),
    ];
    let target = Target::from_arg(path, None);
    write_plot(&[target], &panels, "points", &())?;
    Ok(())
}

/// A line through the means, and the confidence around it.
fn curve(name: &str, rows: &[Row], value: impl Fn(&Row) -> Option<Mean>) -> Curve {
    let values = rows
        .iter()
        .filter_map(|row| Some((row.n as f64, value(row)?)));
    let (points, half_widths) = values.map(|(n, of)| ([n, of.mean], of.half)).unzip();
    Curve {
        name: name.to_owned(),
        points,
        half_widths,
    }
}

/// SplitMix64.
struct Random(u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 * 0.5f64.powi(53)
    }

    fn shuffle<T>(&mut self, items: &mut [T]) {
        for i in (1..items.len()).rev() {
            let j = ((u128::from(self.bits()) * (i as u128 + 1)) >> 64) as usize;
            items.swap(i, j);
        }
    }
}
