//! Measures what graphs and figures of evenly spread points cost, in nanoseconds a point.
//!
//! `cargo run --release -p delone --example proximity_cost [points] [tour]`

use delone::proximity::{Proximity, Tour};
use delone::{Error, Point};
use std::time::Instant;

fn main() -> Result<(), Error> {
    let mut arguments = std::env::args().skip(1);
    let n = arguments
        .next()
        .and_then(|n| n.parse().ok())
        .unwrap_or(1_000_000);
    let mut random = Random(1);
    let points = (0..n).map(|_| Point::new(random.unit(), random.unit()));
    let t = timed(n, "triangulation", || delone::triangulate(points))?;
    let p = timed(n, "is it Delaunay?", || Proximity::new(&t, &()))?;
    timed(n, "closest pair", || p.closest_pair())?;
    timed(n, "nearest neighbours", || p.nearest_neighbors())?;
    let tree = timed(n, "spanning tree", || p.spanning_tree())?;
    timed(n, "clusters", || Ok(tree.clusters(n / 100)))?;
    let gabriel = timed(n, "Gabriel graph", || p.gabriel_graph())?;
    let relative = timed(n, "relative neighbours", || p.relative_neighborhood_graph())?;
    timed(n, "largest empty circle", || p.largest_empty_circle())?;
    let shapes = timed(n, "alpha shapes", || p.alpha_shapes())?;
    let radius = timed(n, "solid radius", || shapes.solid_radius())?;
    timed(n, "one shape", || shapes.shape(radius.unwrap_or(0.0)))?;
    timed(n, "critical radii", || Ok(shapes.critical_radii()))?;
    let edges = [
        tree.edges().len(),
        relative.len(),
        gabriel.len(),
        t.num_edges(),
    ];
    println!("edges of tree, relative neighbours, Gabriel, Delaunay: {edges:?}");
    if arguments.next().is_some() {
        let first = timed(n, "first tour", || Tour::new().moves(0).plan(&p))?;
        let route = timed(n, "tour", || Tour::new().plan(&p))?;
        let bound = timed(n, "its bound", || Tour::new().lower_bound(&p))?;
        println!(
            "tour: {:.4} √(nA) at first, {:.4} after {} moves; bound {:.4}, tree {:.4}; ratio {:.4}",
            first.length / (n as f64).sqrt(),
            route.length / (n as f64).sqrt(),
            route.moves,
            bound / (n as f64).sqrt(),
            tree.length() / (n as f64).sqrt(),
            route.ratio(bound)
        );
    }
    Ok(())
}

fn timed<R>(n: usize, what: &str, work: impl FnOnce() -> Result<R, Error>) -> Result<R, Error> {
    let start = Instant::now();
    let result = work();
    println!(
        "{what:24} {:9.1}",
        start.elapsed().as_nanos() as f64 / n as f64
    );
    result
}

/// A small generator (splitmix64), so that runs repeat.
struct Random(u64);

impl Random {
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 * 0.5_f64.powi(53)
    }
}
