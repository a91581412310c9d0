//! Graphs and figures of points, against their definitions: all pairs, all triples, all orders.

mod alpha;
mod circle;
mod graphs;
mod naive;
mod tour;

use delone::proximity::Proximity;
use delone::{
    ConstrainedDelaunay, Error, Point, Pslg, SegmentPolicy, Triangulation, VertexId, Watch,
};
use delone_testkit::generate::{Kind, Random};
use std::sync::atomic::{AtomicI64, Ordering};

fn triangulated(points: &[Point]) -> Triangulation {
    delone::triangulate(points.iter().copied()).expect("finite points")
}

/// Calls `test` with small point sets of every kind; `DELONE_CASES=n` takes n seeds for each.
fn on_small_sets(most: usize, test: impl Fn(&[Point], &Proximity)) {
    let seeds = std::env::var("DELONE_CASES").map_or(12, |n| n.parse().expect("a number"));
    for kind in Kind::ALL {
        for seed in 0..seeds {
            let n = Random::new(seed).below(most + 1);
            let points = kind.points(n, seed);
            let t = triangulated(&points);
            let run = || test(&points, &Proximity::new(&t, &()).expect("not cancelled"));
            if let Err(panic) = std::panic::catch_unwind(std::panic::AssertUnwindSafe(run)) {
                eprintln!("{kind:?}, seed {seed}: {points:?}");
                std::panic::resume_unwind(panic);
            }
        }
    }
}

/// Segments that force edges which are not Delaunay, and a hole: the graphs are those of the vertices.
#[test]
fn segments_and_holes_are_forgotten() {
    let mut rebuilt = 0;
    for seed in 0..20 {
        let points = Kind::Lattice { side: 20 }.points(30, seed);
        let mut pslg = Pslg::from_points(points);
        let mut random = Random::new(seed);
        for _ in 0..6 {
            let ends = [0; 2].map(|_| VertexId::new(random.below(30)));
            pslg.add_segment(ends[0], ends[1]);
        }
        pslg.add_ring([0, 1, 2]);
        pslg.holes.push(Point::new(0.1, 0.2));
        let cutting = ConstrainedDelaunay::new().crossings(SegmentPolicy::Split);
        let Ok(constrained) = cutting.triangulate(pslg) else {
            continue;
        };
        let t = constrained.triangulation();
        let free = triangulated(t.points());
        let [given, free] = [t, &free].map(|t| Proximity::new(t, &()).unwrap());
        rebuilt += usize::from(!std::ptr::eq(given.triangulation(), t));
        assert_eq!(given.triangulation().hash(), free.triangulation().hash());
        let tree = given.spanning_tree().unwrap();
        assert_eq!(tree.edges(), free.spanning_tree().unwrap().edges());
        assert_eq!(given.gabriel_graph(), free.gabriel_graph());
        assert_eq!(given.largest_empty_circle(), free.largest_empty_circle());
    }
    assert!(rebuilt > 0);
}

/// Lets so much pass, and then cancels.
struct Impatient {
    patience: AtomicI64,
}

impl Watch for Impatient {
    fn is_cancelled(&self) -> bool {
        self.patience.fetch_sub(1, Ordering::Relaxed) <= 0
    }
}

#[test]
fn every_question_can_be_cancelled() {
    let t = triangulated(&Kind::Uniform.points(30_000, 1));
    let impatient = Impatient {
        patience: i64::MAX.into(),
    };
    let proximity = Proximity::new(&t, &impatient).unwrap();
    type Question<'a> = (&'a str, &'a dyn Fn(&Proximity) -> Result<(), Error>);
    let questions: [Question; 9] = [
        ("pair", &|p| p.closest_pair().map(drop)),
        ("nearest", &|p| p.nearest_neighbors().map(drop)),
        ("tree", &|p| p.spanning_tree().map(drop)),
        ("gabriel", &|p| p.gabriel_graph().map(drop)),
        ("relative", &|p| p.relative_neighborhood_graph().map(drop)),
        ("alpha", &|p| p.alpha_shapes().map(drop)),
        ("shape", &|p| p.alpha_shapes()?.shape(0.01).map(drop)),
        ("circle", &|p| p.largest_empty_circle().map(drop)),
        ("tour", &|p| {
            delone::proximity::Tour::new().plan(p).map(drop)
        }),
    ];
    for (name, question) in questions {
        for patience in [0, 3] {
            impatient.patience.store(patience, Ordering::Relaxed);
            assert_eq!(question(&proximity), Err(Error::Cancelled), "{name}");
        }
    }
    impatient.patience.store(0, Ordering::Relaxed);
    assert!(matches!(
        Proximity::new(&t, &impatient),
        Err(Error::Cancelled)
    ));
}
