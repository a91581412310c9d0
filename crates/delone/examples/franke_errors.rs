//! Prints, as a table in Markdown, how well surfaces over scattered nodes reproduce Franke's function:
//! `cargo run --release --example franke_errors`.
//!
//! Nodes are the sets of 25, 33, 100 and 100 on which methods are usually compared, and 300 of Halton's sequence.
//! Errors are taken on a lattice of 33 × 33 points over the unit square, where there is a surface. Polynomials are
//! fitted over data triangulations of the square from −0.1 to 1.1, in which every triangle holds as many data
//! as a polynomial has coefficients.

use delone::scattered::{Cover, DataTriangulation};
use delone::surface::{
    CloughTocher, Estimate, Evaluation, FitOptions, FitSummary, Gradients, Interpolant, Linear,
    LocalFits, Samples,
};
use delone::{Error, Point};

/// Points along a side of the lattice of errors.
const SIDE: usize = 33;

/// What is to be filled with data triangles.
const DOMAIN: [Point; 2] = [Point::new(-0.1, -0.1), Point::new(1.1, 1.1)];

/// Nodes with a name.
pub struct Nodes {
    /// As in the file of known errors.
    pub name: &'static str,
    /// What people call them.
    pub title: &'static str,
    /// Where they are.
    pub points: Vec<Point>,
}

/// Errors at the points of the lattice where there is a surface.
#[derive(Clone, Copy, Debug)]
pub struct Errors {
    /// The largest magnitude.
    pub max: f64,
    /// Root of the mean square.
    pub rms: f64,
    /// At how many points.
    pub points: usize,
}

/// Returns Franke's function.
pub fn franke(p: Point) -> f64 {
    let (x, y) = (9.0 * p.x, 9.0 * p.y);
    let hill = |a: f64, b: f64| (-(a + b)).exp();
    let square = |v: f64| v * v;
    0.75 * hill(square(x - 2.0) / 4.0, square(y - 2.0) / 4.0)
        + 0.75 * hill(square(x + 1.0) / 49.0, (y + 1.0) / 10.0)
        + 0.5 * hill(square(x - 7.0) / 4.0, square(y - 3.0) / 4.0)
        - 0.2 * hill(square(x - 4.0), square(y - 7.0))
}

/// Returns all sets of nodes.
pub fn all_nodes() -> Vec<Nodes> {
    let text = include_str!("../tests/data/franke/nodes.json");
    let sets: serde_json::Value = serde_json::from_str(text).expect("nodes");
    let read = |name: &'static str, title| {
        let points = serde_json::from_value::<Vec<[f64; 2]>>(sets[name].clone());
        let points = points.expect("pairs").into_iter().map(Point::from);
        Nodes {
            name,
            title,
            points: points.collect(),
        }
    };
    vec![
        read("lawson25", "25, Lawson"),
        read("franke33", "33, Franke"),
        read("franke100", "100, Franke"),
        read("random100", "100, random"),
        Nodes {
            name: "halton300",
            title: "300, Halton",
            points: delone_testkit::cover::halton(300),
        },
    ]
}

/// Measures a surface.
pub fn errors(surface: &dyn Interpolant) -> Result<Errors, Error> {
    let share = |i: usize| i as f64 / (SIDE - 1) as f64;
    let lattice = (0..SIDE * SIDE).map(|i| Point::new(share(i % SIDE), share(i / SIDE)));
    let lattice: Vec<Point> = lattice.collect();
    let values = Evaluation::new().values(surface, &lattice)?;
    let differences = lattice.iter().zip(values);
    let differences = differences.filter_map(|(&p, value)| Some(value? - franke(p)));
    let differences: Vec<f64> = differences.collect();
    let squares: f64 = differences.iter().map(|d| d * d).sum();
    Ok(Errors {
        max: differences.iter().fold(0.0, |max, d| d.abs().max(max)),
        rms: (squares / differences.len() as f64).sqrt(),
        points: differences.len(),
    })
}

/// Measures the surface that is flat over every triangle of the nodes, and the smooth one of Clough and Tocher.
pub fn errors_between(nodes: &[Point]) -> Result<[Errors; 2], Error> {
    let t = delone::triangulate(nodes.iter().copied())?;
    let samples = Samples::new(&t, values_at(nodes))?;
    let gradients = Gradients::estimate(&samples, Estimate::LeastBending, &())?;
    Ok([
        errors(&Linear::new(&samples))?,
        errors(&CloughTocher::new(&samples, &gradients)?)?,
    ])
}

/// Measures polynomials of a degree fitted over a data triangulation of the nodes.
pub fn errors_of_fits(
    t: &DataTriangulation,
    options: FitOptions,
) -> Result<(Errors, FitSummary), Error> {
    let surface = LocalFits::new(t, values_at(t.data()), options, &())?;
    Ok((errors(&surface)?, surface.summary()))
}

fn values_at(nodes: &[Point]) -> Vec<f64> {
    nodes.iter().map(|&p| franke(p)).collect()
}

/// Makes data triangulations: of nodes, in the domain, with so many in every triangle at least, if it can.
type Maker<'c> = &'c dyn Fn(&[Point], [Point; 2], usize) -> Option<DataTriangulation>;

/// Covers nodes with triangles that fill a box.
fn cover(nodes: &[Point], [low, high]: [Point; 2], least: usize) -> Option<DataTriangulation> {
    let corners = [
        low,
        Point::new(high.x, low.y),
        high,
        Point::new(low.x, high.y),
    ];
    let builder = Cover::new(least).domain(corners.to_vec());
    builder.cover(nodes.iter().copied()).ok()
}

/// Returns one row of the table.
fn row(nodes: &Nodes, make: Maker<'_>) -> Result<String, Error> {
    let mut cells = vec![nodes.title.to_owned()];
    let cell = |errors: Errors| format!("{:.4} / {:.4}", errors.max, errors.rms);
    cells.extend(errors_between(&nodes.points)?.map(cell));
    for degree in 1..=3 {
        let options = FitOptions::degree(degree);
        let Some(t) = make(&nodes.points, DOMAIN, options.least_data()) else {
            let is_enough = nodes.points.len() >= options.least_data();
            cells.push(if is_enough { "none" } else { "too few" }.to_owned());
            continue;
        };
        let (errors, summary) = errors_of_fits(&t, options)?;
        let triangles = t.triangles().len();
        let [widened, lowered] = [summary.num_widened(), summary.num_lowered()];
        cells.push(format!(
            "{} ({triangles}, {widened}, {lowered})",
            cell(errors)
        ));
    }
    Ok(format!("| {} |", cells.join(" | ")))
}

/// Returns the table.
pub fn table(make: Maker<'_>) -> Result<String, Error> {
    let mut lines = vec![
        "| nodes | linear | Clough–Tocher | planes, d = 3 | quadratics, d = 6 | cubics, d = 10 |"
            .to_owned(),
        "|---|---|---|---|---|---|".to_owned(),
    ];
    for nodes in all_nodes() {
        lines.push(row(&nodes, make)?);
    }
    Ok(lines.join("\n"))
}

/// Prints the table.
pub fn main() -> Result<(), Error> {
    println!(
        "Largest error / root of the mean square (triangles; with data of neighbours; of lower degree)\n"
    );
    println!("{}", table(&cover)?);
    Ok(())
}
