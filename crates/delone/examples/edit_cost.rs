//! What edits cost in a large triangulation: `cargo run --release --example edit_cost [vertices]`.
//!
//! Nanoseconds an edit, mean of many: at random places, and near the place of the edit before.

use delone::edit::LiveTriangulation;
use delone::{Point, VertexId, triangulate};
use std::time::Instant;

/// How many edits are timed together.
const EDITS: usize = 100_000;

/// SplitMix64.
struct Random(u64);

impl Random {
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ self.0 >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ z >> 31) >> 11) as f64 / (1u64 << 53) as f64
    }

    fn point(&mut self) -> Point {
        Point::new(self.unit(), self.unit())
    }

    /// A point in a small square that drifts across the unit square.
    fn drifting(&mut self, i: usize) -> Point {
        let at = i as f64 / EDITS as f64;
        let side = 1e-2;
        Point::new(at + side * self.unit(), at + side * self.unit())
    }
}

fn timed(what: &str, edit: impl FnOnce()) {
    let start = Instant::now();
    edit();
    let each = start.elapsed().as_nanos() as f64 / EDITS as f64;
    println!("{what:<28} {each:>8.0} ns");
}

fn main() {
    let n = std::env::args().nth(1);
    let n = n.map_or(1_000_000, |n| n.parse().expect("a number of vertices"));
    let mut r = Random(1);
    let points: Vec<Point> = (0..n).map(|_| r.point()).collect();
    let t = triangulate(points).expect("finite points");
    let start = Instant::now();
    let mut live = LiveTriangulation::from_triangulation(&t);
    let each = start.elapsed().as_nanos() as f64 / n as f64;
    println!("{:<28} {each:>8.0} ns a vertex", "from a triangulation");
    drop(t);

    let mut added: Vec<VertexId> = Vec::with_capacity(EDITS);
    let insert =
        |live: &mut LiveTriangulation, p: Point| live.insert(p).expect("a finite point").vertex();
    timed("insert, random", || {
        added.extend((0..EDITS).map(|_| insert(&mut live, r.point())));
    });
    timed("move far, random", || {
        for &v in &added {
            live.move_to(v, r.point()).expect("a vacant place");
        }
    });
    let step = 0.1 / (n as f64).sqrt();
    timed("move a tenth of an edge", || {
        for &v in &added {
            let p = live.point(v).expect("a vertex");
            let q = Point::new(p.x + step * (r.unit() - 0.5), p.y + step * (r.unit() - 0.5));
            live.move_to(v, q).expect("a vacant place");
        }
    });
    timed("remove, random", || {
        for v in added.drain(..) {
            live.remove(v).expect("a vertex");
        }
    });
    timed("insert, local", || {
        added.extend((0..EDITS).map(|i| insert(&mut live, r.drifting(i))));
    });
    timed("remove, local", || {
        for v in added.drain(..) {
            live.remove(v).expect("a vertex");
        }
    });
    timed("transaction, undone", || {
        let outcome: Result<(), ()> = live.transaction(|live| {
            for i in 0..EDITS {
                let _ = insert(live, r.drifting(i));
            }
            Err(())
        });
        assert_eq!(outcome, Err(()));
    });
}
