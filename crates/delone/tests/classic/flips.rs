//! What the lecture proves of flips and conflicts, on logs and on all triangulations of small sets.

use super::small::{self, Small};
use super::suite;
use delone::classic::{Algorithm, Input};
use delone::predicates::{CircleSide, in_circle};
use delone::{ConstrainedDelaunay, Event, Log, Point, Tally, VertexId, triangulate};
use delone_testkit::generate::Kind;

const BOTH: [Algorithm; 2] = [Algorithm::GreedyFlips, Algorithm::FlipList];

fn log_of(algorithm: Algorithm, points: &[Point]) -> Log {
    suite::run(algorithm, &Input::from_points(points.iter().copied())).1
}

/// The flips of a log: from which diagonal to which.
fn flips(log: &Log) -> Vec<[[VertexId; 2]; 2]> {
    let flip = |event| match event {
        Event::EdgeFlipped { from, to } => Some([from, to]),
        _ => None,
    };
    log.steps.iter().filter_map(|s| flip(s.event)).collect()
}

/// Φ at the beginning and after each flip.
fn conflicts(log: &Log) -> Vec<u64> {
    let count = |event| match event {
        Event::ConflictsCounted { conflicts } => Some(conflicts),
        _ => None,
    };
    log.steps.iter().filter_map(|s| count(s.event)).collect()
}

fn samples() -> impl Iterator<Item = Vec<Point>> {
    let kinds = Kind::ALL.into_iter().enumerate();
    kinds.map(|(i, kind)| kind.points(25, i as u64 + 30))
}

#[test]
fn conflicts_fall_by_two_a_flip_down_to_none() {
    for points in samples() {
        for algorithm in BOTH {
            let log = log_of(algorithm, &points);
            let conflicts = conflicts(&log);
            assert_eq!(conflicts.len(), flips(&log).len() + 1);
            assert!(conflicts.windows(2).all(|pair| pair[1] + 2 <= pair[0]));
            assert_eq!(conflicts.last(), Some(&0));
        }
    }
}

#[test]
fn conflicts_are_those_that_one_counts_anew() {
    for points in samples() {
        let log = log_of(Algorithm::FlipList, &points);
        let mut scene = log.first_scene();
        for step in &log.steps {
            scene.apply(step.event).expect("fits");
            if let Event::ConflictsCounted { conflicts } = step.event {
                let t = Small::new(&points, scene.triangles());
                assert_eq!(conflicts, t.conflicts());
            }
        }
    }
}

#[test]
fn flips_are_bounded_by_conflicts_and_by_pairs_of_points() {
    for points in samples() {
        for algorithm in BOTH {
            let input = Input::from_points(points.iter().copied());
            let log = log_of(algorithm, &points);
            let output = algorithm.run(&input).expect("finite");
            let n = (points.len() - output.duplicates.len()) as u64;
            let (flips, most) = (flips(&log).len() as u64, conflicts(&log)[0]);
            assert!(2 * flips <= most && flips <= n * (n - 1) / 2);
            assert!(most <= output.triangles.len() as u64 * n.saturating_sub(3));
        }
    }
}

#[test]
fn an_edge_that_was_flipped_away_never_returns() {
    for points in samples() {
        for algorithm in BOTH {
            let flips = flips(&log_of(algorithm, &points));
            let sorted = |[a, b]: [VertexId; 2]| [a.min(b), a.max(b)];
            let gone: Vec<_> = flips.iter().map(|&[from, _]| sorted(from)).collect();
            for (i, &[_, to]) in flips.iter().enumerate() {
                assert!(!gone[..=i].contains(&sorted(to)));
            }
        }
    }
}

#[test]
fn new_circles_cover_no_more_and_share_no_more_than_the_old() {
    // Lemma 6.11, at all points of a lattice finer than that of the vertices, and at the vertices.
    let fine = |i: usize| Point::new((i % 40) as f64 / 4.0 - 2.0, (i / 40) as f64 / 4.0 - 2.0);
    let mut samples: Vec<_> = (0..1600).map(fine).collect();
    let points = Kind::Lattice { side: 6 }.points(14, 5);
    samples.extend(Kind::Uniform.points(14, 6));
    for points in [points, samples[1600..].to_vec()] {
        for [[a, c], [d, b]] in flips(&log_of(Algorithm::GreedyFlips, &points)) {
            let at = |t: [VertexId; 3]| t.map(|v| points[v.index()]);
            // The new apexes are told counter-clockwise: d left of ac, b right of it.
            let [old, new] = [[[a, b, c], [a, c, d]], [[a, b, d], [b, c, d]]];
            for &q in &samples {
                for closed in [false, true] {
                    let holds = |t| match in_circle_of(at(t), q) {
                        CircleSide::Inside => true,
                        CircleSide::On => closed,
                        CircleSide::Outside => false,
                    };
                    let [old, new] = [old.map(holds), new.map(holds)];
                    let [union_old, union_new] = [old, new].map(|[s, t]| s || t);
                    let [shared_old, shared_new] = [old, new].map(|[s, t]| s && t);
                    assert!(union_old >= union_new && shared_old >= shared_new, "{q:?}");
                }
            }
        }
    }
}

fn in_circle_of([a, b, c]: [Point; 3], q: Point) -> CircleSide {
    in_circle(a, b, c, q)
}

#[test]
fn on_all_triangulations_flips_lower_conflicts_and_only_the_last_has_none() {
    for points in small::sets() {
        let all = small::all_triangulations(&points);
        let mut without = 0;
        for t in &all {
            let (before, failing) = (t.conflicts(), t.failing_edges());
            // Φ > 0 if and only if a Delaunay flip exists.
            assert_eq!(before > 0, !failing.is_empty());
            without += usize::from(before == 0);
            for edge in failing {
                let after = t.flipped(edge).expect("a failing edge can be flipped");
                assert!(after.conflicts() + 2 <= before);
            }
        }
        assert_eq!(without, 1, "{points:?}");
    }
}

#[test]
fn the_list_takes_a_constant_number_of_tests_for_a_flip() {
    let points = Kind::Uniform.points(200, 4);
    let input = Input::from_points(points);
    let mut tallies = BOTH.map(|algorithm| {
        let mut tally = Tally::default();
        algorithm.observe(&input, &mut tally).expect("finite");
        tally
    });
    let [greedy, list] = &mut tallies;
    assert!(list.circle_tests <= 3 * 200 + 4 * list.flips);
    assert!(greedy.circle_tests > 10 * list.circle_tests);
}

/// The triangles of a triangulation, to begin with.
fn start(t: &Small) -> Vec<[VertexId; 3]> {
    t.triangles().map(|t| t.map(VertexId::new)).collect()
}

#[test]
fn from_every_triangulation_flips_lead_to_the_same() {
    for points in small::sets().into_iter().step_by(5) {
        let expected = triangulate(points.iter().copied()).expect("finite").hash();
        for t in small::all_triangulations(&points).iter().step_by(7) {
            for algorithm in BOTH {
                let mut input = Input::from_points(points.iter().copied());
                input.start = start(t);
                let (output, log) = suite::run(algorithm, &input);
                assert_eq!(output.hash(), expected);
                assert_eq!(conflicts(&log)[0], t.conflicts());
            }
        }
    }
}

#[test]
fn segments_are_not_flipped_and_the_end_is_the_constrained_triangulation() {
    for points in small::sets().into_iter().step_by(3) {
        for t in small::all_triangulations(&points).iter().step_by(11) {
            let mut input = Input::from_points(points.iter().copied());
            input.start = start(t);
            for [a, b] in t.edges().into_iter().step_by(2) {
                input.pslg.add_segment(VertexId::new(a), VertexId::new(b));
            }
            let expected = ConstrainedDelaunay::new().triangulate(input.pslg.clone());
            let expected = expected
                .expect("segments do not cross")
                .triangulation()
                .hash();
            for algorithm in BOTH {
                let (output, log) = suite::run(algorithm, &input);
                assert_eq!(output.hash(), expected);
                assert!(conflicts(&log).is_empty());
            }
        }
    }
}

#[test]
fn a_start_with_a_notch_keeps_its_outline() {
    // The square (0,0)–(4,4) without the triangle above (2,1), once with its diagonals turned.
    let points = [(0, 0), (4, 0), (4, 4), (2, 1), (0, 4), (1, 1)];
    let points = points.map(|(x, y)| Point::new(f64::from(x), f64::from(y)));
    let start = [[0, 1, 3], [1, 2, 3], [0, 3, 5], [0, 5, 4], [5, 3, 4]];
    for algorithm in BOTH {
        let mut input = Input::from_points(points);
        input.start = start.iter().map(|t| t.map(VertexId::new)).collect();
        let (output, log) = suite::run(algorithm, &input);
        assert_eq!(output.triangles.len(), 5);
        let scene = log.last_scene().expect("can be played");
        assert!(scene.edges().all(|edge| edge != [2, 4].map(VertexId::new)));
    }
}
