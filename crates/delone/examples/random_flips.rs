//! Counts the flips of incremental construction: linear in random order, whatever the points; quadratic in the worst.
//!
//! `cargo run --release -p delone --example random_flips -- docs/algorithms/pictures/random-flips.svg` prints a table
//! and draws it; a number more replaces the largest number of points, 100,000.
//!
//! The flips of `incremental` depend on the order of the points and not on how each is found. So they are counted in
//! `segment-walk`, which deletes exactly the edges that `incremental` flips, and finds points faster: but for those on
//! the parabola, where a walk crosses a fan of all triangles. So there are fewer of these.

use delone::classic::{Algorithm, Input};
use delone::{Point, Tally};
use std::fmt::Write;

/// Orders for each set of points.
const ORDERS: usize = 20;
/// Most points on the parabola.
const MOST_ON_CURVE: usize = 10_000;
/// The quantile of Student's distribution for 19 degrees of freedom, 95 % on both sides.
const STUDENT: f64 = 2.093;

fn main() {
    let path = std::env::args().nth(1);
    let most = std::env::args()
        .nth(2)
        .map_or(100_000, |n| n.parse().expect("a number"));
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
    if let Some(path) = path {
        std::fs::write(&path, draw(&rows)).expect("can be written");
    }
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
fn draw(rows: &[Row]) -> String {
    let mut svg = String::from(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 960 400\" font-family=\"sans-serif\" \
         font-size=\"13\" fill=\"#222\">\n<rect width=\"960\" height=\"400\" fill=\"#fff\"/>\n",
    );
    let bands = Panel {
        left: 60.0,
        title: "random order: flips a point, mean and 95 % confidence",
        low: 0.0,
        high: 4.0,
        is_logarithmic: false,
    };
    bands.draw_axes(&mut svg, &[0.0, 1.0, 2.0, 3.0, 4.0]);
    bands.draw_band(&mut svg, UNIFORM, rows, |row| Some(row.uniform));
    bands.draw_band(&mut svg, CURVE, rows, |row| row.curve);
    let orders = Panel {
        left: 540.0,
        title: "the same, beside the worst order (logarithmic)",
        low: 0.0,
        high: 4.0,
        is_logarithmic: true,
    };
    orders.draw_axes(&mut svg, &[1.0, 10.0, 100.0, 1000.0, 10_000.0]);
    let exactly = |mean| Mean { mean, half: 0.0 };
    orders.draw_band(&mut svg, UNIFORM, rows, |row| Some(row.uniform));
    orders.draw_band(&mut svg, CURVE, rows, |row| row.curve);
    orders.draw_band(&mut svg, WORST, rows, |row| row.worst.map(exactly));
    let legend = [
        (80.0, UNIFORM, "points in a square"),
        (260.0, CURVE, "points on a parabola"),
        (
            450.0,
            WORST,
            "the parabola from its flat end to its tip: (n−2)(n−3)/2 flips",
        ),
    ];
    for (x, color, text) in legend {
        let end = x + 24.0;
        let _ = writeln!(
            svg,
            "<path d=\"M{x} 388H{end}\" stroke=\"{color}\" stroke-width=\"3\"/><text x=\"{}\" y=\"392\">{text}</text>",
            end + 6.0
        );
    }
    svg.push_str("</svg>\n");
    svg
}

const UNIFORM: &str = "#2a6f97";
const CURVE: &str = "#c1666b";
const WORST: &str = "#444";

/// A plot over the number of points, from 100 to 100,000.
struct Panel {
    left: f64,
    title: &'static str,
    /// The ends of the upright axis, as logarithms if it is logarithmic.
    low: f64,
    high: f64,
    is_logarithmic: bool,
}

impl Panel {
    fn across(&self, n: f64) -> f64 {
        self.left + 380.0 * (n.log10() - 2.0) / 3.0
    }

    fn up(&self, value: f64) -> f64 {
        let value = match self.is_logarithmic {
            true => value.log10(),
            false => value,
        };
        340.0 - 290.0 * (value - self.low) / (self.high - self.low)
    }

    fn draw_axes(&self, svg: &mut String, heights: &[f64]) {
        let _ = writeln!(
            svg,
            "<text x=\"{}\" y=\"24\" font-size=\"15\">{}</text>",
            self.left, self.title
        );
        for &height in heights {
            let (x, y) = (self.left, self.up(height));
            let _ = writeln!(
                svg,
                "<path d=\"M{x} {y:.1}h380\" stroke=\"#222\" opacity=\"0.2\"/>\
                 <text x=\"{}\" y=\"{:.1}\" text-anchor=\"end\">{height}</text>",
                x - 6.0,
                y + 4.0
            );
        }
        for n in [100.0, 1000.0, 10_000.0, 100_000.0] {
            let _ = writeln!(
                svg,
                "<text x=\"{:.1}\" y=\"360\" text-anchor=\"middle\">{n}</text>",
                self.across(n)
            );
        }
    }

    /// Draws a line through the means, and the confidence around it.
    fn draw_band(
        &self,
        svg: &mut String,
        color: &str,
        rows: &[Row],
        value: impl Fn(&Row) -> Option<Mean>,
    ) {
        let values = rows
            .iter()
            .filter_map(|row| Some((row.n as f64, value(row)?)));
        let values: Vec<_> = values.collect();
        let place = |&(n, Mean { mean, half }): &(f64, Mean), side: f64| {
            format!("{:.1} {:.1}", self.across(n), self.up(mean + side * half))
        };
        let upper = values.iter().map(|value| place(value, 1.0));
        let lower = values.iter().rev().map(|value| place(value, -1.0));
        let rim: Vec<_> = upper.chain(lower).collect();
        let line: Vec<_> = values.iter().map(|value| place(value, 0.0)).collect();
        let _ = writeln!(
            svg,
            "<path d=\"M{}Z\" fill=\"{color}\" opacity=\"0.25\"/>\
             <path d=\"M{}\" fill=\"none\" stroke=\"{color}\" stroke-width=\"2\"/>",
            rim.join("L"),
            line.join("L")
        );
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
