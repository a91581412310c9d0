//! Algorithm B: vertices on edges.

use super::cover::{random, require};
use delone::predicates::{Orientation, orient2d};
use delone::scattered::{Cover, DataTriangulation};
use delone::{Event, Log, Point};

/// Algorithms A and B without C.
fn without_c(least: usize) -> Cover<'static> {
    Cover::new(least).divides_triangles(false)
}

/// Runs B, watched and unwatched, on what A has made; returns what it was before, and is then.
fn divide(data: &[Point], options: &Cover) -> [DataTriangulation; 2] {
    let before = options
        .clone()
        .divides_edges(false)
        .cover(data.to_vec())
        .unwrap();
    let mut log = Log::new("edges", data.to_vec());
    let after = options.observe(data.iter().copied(), &mut log).unwrap();
    assert_eq!(
        after,
        options.cover(data.to_vec()).unwrap(),
        "observed and unobserved"
    );
    assert!(after.triangles().len() >= before.triangles().len());
    require_filled(&before);
    require_filled(&after);
    let scene = log.last_scene().unwrap();
    assert_eq!(scene.triangles().count(), after.triangles().len());
    let failed = |event: &Event| matches!(event, Event::DivisionFailed { .. });
    let considered = |event: &Event| matches!(event, Event::TriangleConsidered { .. });
    let count = |is: &dyn Fn(&Event) -> bool| log.steps.iter().filter(|s| is(&s.event)).count();
    let created = after.points().len() - before.points().len();
    assert_eq!(count(&considered), count(&failed) + created);
    [before, after]
}

/// As `require`, but nothing is promised of too many data.
fn require_filled(cover: &DataTriangulation) {
    for (&p, holder) in cover.data().iter().zip(cover.holders()) {
        let [a, b, c] = cover.triangles()[holder.index()].map(|v| cover.points()[v.index()]);
        for [from, to] in [[a, b], [b, c], [c, a]] {
            assert_eq!(orient2d(a, b, c), Orientation::Left);
            assert_ne!(orient2d(from, to, p), Orientation::Right, "{p:?}");
        }
    }
    assert!(cover.counts().into_iter().all(|n| n >= cover.least()));
}

fn most(cover: &DataTriangulation) -> usize {
    cover.counts().into_iter().max().unwrap()
}

/// Example 3.50: 150 random data, d = 6; Algorithm B alone comes to about 2d.
#[test]
fn example_3_50_falls_to_about_twice_the_least() {
    let mut maxima = Vec::new();
    for seed in 1..12 {
        let [before, after] = divide(&random(150, seed), &without_c(6));
        if most(&before) >= 24 {
            assert!(after.points().len() >= before.points().len() + 2);
        }
        maxima.push(most(&after));
    }
    maxima.sort_unstable();

    assert!(maxima[5] <= 15, "{maxima:?}");
    assert!(maxima[0] <= 12, "{maxima:?}");
}

#[test]
fn one_place_on_each_edge_is_enough_to_divide_even_data() {
    let data = random(300, 5);
    let vertices = |n| {
        let [_, after] = divide(&data, &without_c(6).bisections(n));
        after.points().len()
    };
    let counts = [0, 1, 2, 4, 25, 60, u32::MAX].map(vertices);
    assert_eq!(counts[0], counts[1], "there is no place");
    assert!(counts[1] < counts[2] && counts[2] < counts[4]);
}

#[test]
fn lattices_tracks_and_circles_are_divided() {
    let lattice = |i: u32| (f64::from(i % 15), f64::from(i / 15));
    let tracks = |i: u32| {
        (
            f64::from(i / 5),
            f64::from(i % 5) * 20.0 + f64::from(i / 5) * 0.5,
        )
    };
    let circle = |i: u32| {
        let t = f64::from(i) / 30.0 - 3.0;
        ((1.0 - t * t) / (1.0 + t * t), 2.0 * t / (1.0 + t * t))
    };
    for data in [lattice, tracks, circle] as [fn(u32) -> (f64, f64); 3] {
        let data: Vec<Point> = (0..180).map(|i| data(i).into()).collect();
        for least in [1, 3, 6] {
            for factor in [1.01, 1.1] {
                divide(&data, &without_c(least).factor(factor));
            }
        }
    }
}

/// Data on the outline, on edges, and on vertices.
#[test]
fn lattices_up_to_the_outline_are_divided() {
    let data: Vec<Point> = (0..225)
        .map(|i| (f64::from(i % 15), f64::from(i / 15)).into())
        .collect();
    let corners = [(0.0, 0.0), (14.0, 0.0), (14.0, 14.0), (0.0, 14.0)].map(Point::from);
    // Not convex: most of a corner is cut off.
    let notched = [(0.0, 0.0), (14.0, 0.0), (3.0, 3.0), (0.0, 14.0)].map(Point::from);
    let inside: Vec<Point> = data
        .iter()
        .copied()
        .filter(|p| p.x + p.y <= 5.0 || p.x < 1.0 || p.y < 1.0)
        .collect();
    for least in [1, 2, 3, 5, 8] {
        divide(&data, &without_c(least).domain(corners.to_vec()));
        divide(&inside, &without_c(least).domain(notched.to_vec()));
    }
}

#[test]
fn data_on_the_outline_alone_are_divided() {
    let side = |i: u32| f64::from(i) / 16.0;
    let square = (0..16).flat_map(|i| {
        [
            (side(i), 0.0),
            (1.0, side(i)),
            (1.0 - side(i), 1.0),
            (0.0, 1.0 - side(i)),
        ]
    });
    let data: Vec<Point> = square.map(Point::from).collect();
    let corners = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(Point::from);
    for least in [2, 4, 8] {
        let options = without_c(least).domain(corners.to_vec());
        let [before, after] = divide(&data, &options);
        assert!(after.points().len() > before.points().len());
        // Along the axes vertices lie on the outline itself.
        let on = |p: &&Point| [p.x, p.y].iter().any(|&c| c == 0.0 || c == 1.0);
        assert!(after.points().iter().filter(on).count() > 4);
        assert!(
            after
                .points()
                .iter()
                .all(|p| (0.0..=1.0).contains(&p.x) && (0.0..=1.0).contains(&p.y))
        );
    }
}

#[test]
fn offsets_and_scales_do_not_matter() {
    let data = random(150, 3);
    let moved = |scale: f64, x: f64, y: f64| -> Vec<Point> {
        data.iter()
            .map(|p| Point::new(scale * p.x + x, scale * p.y + y))
            .collect()
    };
    for data in [
        moved(1.0, 1e6, -1e6),
        moved(1e200, 0.0, 0.0),
        moved(1e-200, 0.0, 0.0),
        moved(1e-10, 1.0, 1.0),
    ] {
        let [before, after] = divide(&data, &without_c(6));
        assert!(after.points().len() > before.points().len());
    }
}

#[test]
fn without_optimization_nothing_is_flipped() {
    let data = random(200, 4);
    let mut log = Log::new("edges", data.clone());
    let start = without_c(6).divides_edges(false).cover(data).unwrap();
    let options = without_c(6).optimizes(false);
    let plain = options.refine(&start, &mut log).unwrap();
    require_filled(&plain);
    assert!(plain.points().len() > start.points().len());
    let flips = |log: &Log| {
        let is_flip = |event: &Event| matches!(event, Event::EdgeFlipped { .. });
        log.steps.iter().filter(|s| is_flip(&s.event)).count()
    };
    assert_eq!(flips(&log), 0);
    let mut log = Log::new("edges", start.data().to_vec());
    require_filled(&without_c(6).refine(&start, &mut log).unwrap());
    assert!(flips(&log) > 0);
}

#[test]
fn algorithm_c_finishes_what_b_leaves() {
    for seed in 1..4 {
        require(&Cover::new(6).cover(random(400, seed)).unwrap());
    }
}

/// Algorithm 3.37, step 0: an edge at the new vertex itself is flipped, and brings back one that was there before.
#[test]
fn vertices_on_diagonals_may_bring_the_old_edge_back() {
    let mut brought_back = 0;
    for seed in 1..8 {
        let data = random(200, seed);
        let mut log = Log::new("edges", data.clone());
        without_c(6).observe(data, &mut log).unwrap();
        let mut newest = None;
        let mut gone = Vec::new();
        for step in log.steps {
            match step.event {
                Event::VertexCreated { vertex, .. } => {
                    newest = Some(vertex);
                    gone.clear();
                }
                Event::EdgeDeleted { edge } => gone.push(edge),
                Event::EdgeFlipped { from, mut to }
                    if newest.is_some_and(|v| from.contains(&v)) =>
                {
                    to.sort_unstable();
                    assert_eq!(gone, [to]);
                    brought_back += 1;
                }
                _ => {}
            }
        }
    }
    assert!(brought_back > 0);
}
