//! The point search of the chapter: its traces, its statistics, and what unique counting adds.

use delone::scattered::{Counting, Move, Next, PointSearch, SearchStep, Steps};
use delone::{Error, Point};
use delone_testkit::generate::Random;
use serde_json::Value;

const BASE: [(f64, f64); 3] = [(0.0, 0.0), (60.0, 0.0), (20.0, 50.0)];

fn steps(data: &[Point], least: usize, counting: Counting, steps: Steps) -> Vec<SearchStep> {
    let search = PointSearch::new(BASE.map(Point::from), data, least, counting);
    search.expect("a triangle").with_steps(steps).collect()
}

fn end(steps: &[SearchStep]) -> Next {
    steps.last().expect("a step").next
}

fn examples() -> Value {
    let text = include_str!("data/chapter/001-alg3.44-pointsearch.json");
    serde_json::from_str(text).expect("an example")
}

fn numbers(value: &Value) -> Vec<f64> {
    let all = value.as_array().expect("a list").iter();
    all.map(|n| n.as_f64().expect("a number")).collect()
}

fn places(value: &Value) -> Vec<Point> {
    let all = value.as_array().expect("a list").iter().map(numbers);
    all.map(|c| Point::new(c[0], c[1])).collect()
}

#[test]
fn traces_are_as_recomputed() {
    let examples = examples();
    assert_eq!(places(&examples["triangle"]), BASE.map(Point::from));
    let cases = examples["cases"].as_array().expect("cases");
    assert_eq!(cases.len(), 2);
    for case in cases {
        let data = places(&case["data"]);
        let least = case["d"].as_u64().expect("d") as usize;
        let found = steps(&data, least, Counting::Closed, Steps::Corrected);
        let expected = case["expected_trace"].as_array().expect("a trace");
        assert_eq!(found.len(), expected.len());
        for (step, expected) in found.iter().zip(expected) {
            assert_eq!(serde_json::json!(step.place.fractions()), expected["t"]);
            assert_eq!(serde_json::json!(step.counts), expected["counts"]);
            let quotient = |text: &str| match text.split_once('/') {
                Some((n, d)) => n.parse::<f64>().expect("n") / d.parse::<f64>().expect("d"),
                None => text.parse().expect("an integer"),
            };
            let [x, y] = step.place.fractions().map(|text| quotient(&text));
            assert_eq!(step.at, Point::new(x, y));
        }
        assert_eq!(end(&found), Next::Found);
        // As printed, both fail.
        let printed = steps(&data, least, Counting::Closed, Steps::Printed);
        assert!(matches!(end(&printed), Next::Stuck(_) | Next::Endless));
    }
}

/// As many different points strictly inside the triangle, on an integer lattice.
fn lattice_data(random: &mut Random, n: usize) -> Vec<Point> {
    let mut data: Vec<Point> = Vec::new();
    while data.len() < n {
        let p = Point::new(random.below(60) as f64, random.below(50) as f64);
        let is_inside = p.y > 0.0 && 5.0 * p.x > 2.0 * p.y && 5.0 * (60.0 - p.x) > 4.0 * p.y;
        if is_inside && !data.contains(&p) {
            data.push(p);
        }
    }
    data
}

#[test]
fn the_corrected_search_always_succeeds() {
    let mut random = Random::new(344);
    let [mut printed_fails, mut most] = [0; 2];
    for round in 0..3000 {
        let least = 1 + round % 6;
        let data = lattice_data(&mut random, 3 * least);
        let closed = steps(&data, least, Counting::Closed, Steps::Corrected);
        assert_eq!(end(&closed), Next::Found, "{data:?}");
        assert!(closed.len() <= 2 * least + 1, "{data:?}");
        assert!(
            closed
                .last()
                .expect("a step")
                .counts
                .iter()
                .all(|&n| n >= least)
        );
        most = most.max(closed.len() - 1);
        let printed = steps(&data, least, Counting::Closed, Steps::Printed);
        printed_fails += usize::from(end(&printed) != Next::Found);
        let unique = steps(&data, least, Counting::Unique, Steps::Corrected);
        assert_eq!(end(&unique), Next::Found, "{data:?}");
        // It goes on where the other ends.
        assert!(unique.len() >= closed.len());
        let is_same = |(a, b): (&SearchStep, &SearchStep)| a.place == b.place;
        assert!(closed.iter().zip(&unique).all(is_same));
    }
    assert!((30..150).contains(&printed_fails), "{printed_fails}");
    assert!((6..=12).contains(&most), "{most}");
}

/// The counts of example 3.45 on one instance that has them; its own figures give no coordinates.
#[test]
fn unique_counting_needs_a_fourth_point() {
    let data = EXAMPLE.map(Point::from);
    let found = steps(&data, 6, Counting::Unique, Steps::Corrected);
    let text = include_str!("data/chapter/001-printed-traces.json");
    let printed: Value = serde_json::from_str(text).expect("traces");
    // The text counts [t1, t2, t] first.
    let counts: Vec<_> = found
        .iter()
        .map(|s| [s.counts[2], s.counts[1], s.counts[0]])
        .collect();
    assert_eq!(
        serde_json::json!(counts),
        printed["ex3_45"]["counts_12t_1t3_t23"]
    );
    let moves = [Move::Away(0), Move::Towards(2), Move::Away(0)].map(Next::Moves);
    assert!(
        found
            .iter()
            .map(|s| s.next)
            .eq(moves.into_iter().chain([Next::Found]))
    );
    let closed = steps(&data, 6, Counting::Closed, Steps::Corrected);
    assert_eq!((closed.len(), end(&closed)), (3, Next::Found));
}

/// Found by trying.
const EXAMPLE: [(f64, f64); 20] = [
    (19.0, 39.0),
    (39.0, 22.0),
    (24.0, 33.0),
    (43.0, 20.0),
    (35.0, 22.0),
    (49.0, 10.0),
    (32.0, 24.0),
    (16.0, 8.0),
    (34.0, 4.0),
    (29.0, 29.0),
    (55.0, 5.0),
    (21.0, 6.0),
    (17.0, 1.0),
    (26.0, 18.0),
    (20.0, 30.0),
    (30.0, 1.0),
    (31.0, 28.0),
    (18.0, 16.0),
    (32.0, 28.0),
    (25.0, 18.0),
];

#[test]
fn bad_input_is_named() {
    let new = |corners: [(f64, f64); 3], data: &[(f64, f64)]| {
        let data: Vec<Point> = data.iter().map(|&p| p.into()).collect();
        PointSearch::new(corners.map(Point::from), &data, 1, Counting::Unique).map(|_| ())
    };
    let nan = new(BASE, &[(1.0, 1.0), (2.0, f64::NAN)]);
    assert!(matches!(nan, Err(Error::NotFinite { index: 4, .. })));
    let outside = new(BASE, &[(1.0, 1.0), (2.0, -1.0)]);
    assert!(matches!(outside, Err(Error::DatumOutside { datum: 1, .. })));
    let flat = new([(0.0, 0.0), (1.0, 1.0), (2.0, 2.0)], &[]);
    assert!(matches!(flat, Err(Error::BadDomain { .. })));
    assert_eq!(new([BASE[0], BASE[2], BASE[1]], &[(20.0, 20.0)]), Ok(()));
    let few = steps(
        &[(10.0, 10.0).into()],
        1,
        Counting::Closed,
        Steps::Corrected,
    );
    assert_eq!(few.len(), 1);
    assert_eq!(end(&few), Next::TooFew);
}

#[test]
fn data_on_an_edge_leave_nothing_to_stop_at() {
    let edge = [(10.0, 0.0), (20.0, 0.0), (30.0, 0.0)].map(Point::from);
    let found = steps(&edge, 1, Counting::Closed, Steps::Corrected);
    assert_eq!(end(&found), Next::Stuck(Move::Away(2)));
}
