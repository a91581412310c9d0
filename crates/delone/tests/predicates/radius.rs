//! Lengths and circumradii against rational arithmetic: no smaller `f64` would do.

use crate::families::{FAMILIES, Family};
use crate::oracle;
use crate::random::Random;
use crate::{Tally, run, run_all};
use dashu_ratio::Relaxed;
use delone::Point;
use delone::predicates::stage::{self, Stage};
use delone::predicates::{circumradius_up, length_up};

/// Whether `up` is the smallest `f64` whose square is at least `square`, `None` being infinite.
fn is_rounded_up(up: f64, square: Option<&Relaxed>) -> bool {
    let Some(square) = square else {
        return up == f64::INFINITY;
    };
    let squared = |c: f64| {
        let c = Relaxed::try_from(c).expect("finite");
        &c * &c
    };
    let suffices = up == f64::INFINITY || squared(up) >= *square;
    let is_needed = up == 0.0 || squared(up.next_down()) < *square;
    suffices && is_needed
}

#[test]
fn lengths_are_rounded_up() {
    run_all(|family, [a, b, _, _]| {
        let (found, stage) = stage::length_up([a, b]);
        let square = oracle::squared_length_of([a, b]);
        assert!(
            is_rounded_up(found, Some(&square)),
            "{}: {a:?} {b:?}: {found}",
            family.name
        );
        assert_eq!(length_up([b, a]), found);
        stage
    });
}

/// Stage 2 has fewer bits for a radius than for a sign, so that lattices may need big integers.
#[test]
fn circumradii_are_rounded_up() {
    let mut sum = Tally::default();
    for family in FAMILIES {
        let tally = run(family, ask_for_circumradius);
        let [filter, integer, exact] = tally.0;
        match family.name {
            "uniform" => assert_eq!(integer + exact, 0, "{tally:?}"),
            "small lattice" => assert_eq!(exact, 0, "{tally:?}"),
            "subnormal" => assert_eq!(filter, 0, "{tally:?}"),
            _ => {}
        }
        sum.add(&tally);
    }
    assert!(
        sum.0.iter().all(|&n| n > 0),
        "a stage was never hit: {sum:?}"
    );
}

fn ask_for_circumradius(family: &Family, [a, b, c, _]: [Point; 4]) -> Stage {
    let (found, stage) = stage::circumradius_up(a, b, c);
    let square = oracle::squared_circumradius([a, b, c]);
    assert!(
        is_rounded_up(found, square.as_ref()),
        "{}: {a:?} {b:?} {c:?}: {found}",
        family.name
    );
    for (a, b, c) in [(b, c, a), (b, a, c)] {
        assert_eq!(circumradius_up(a, b, c), found);
    }
    // As is the filtration of alpha shapes: no triangle before its edges.
    for [p, q] in [[a, b], [b, c], [c, a]] {
        assert!(length_up([p, q]) / 2.0 <= found);
    }
    stage
}

/// Numbers of few digits are their own rounding, and one unit more in the last place is seen.
#[test]
fn round_numbers_stay() {
    for exponent in [-300, -40, 0, 7, 300] {
        let scale = 2_f64.powi(exponent);
        let [a, b, c, d] = [
            (1.0, 1.0),
            (7.0, 1.0),
            (7.0, 9.0),
            (7.0, 1.0 + 8.0 * (1.0 + 4e-16)),
        ]
        .map(|(x, y)| Point::new(x * scale, y * scale));
        assert_eq!(stage::length_up([a, c]), (10.0 * scale, Stage::Integer));
        assert_eq!(
            stage::circumradius_up(a, b, c),
            (5.0 * scale, Stage::Integer)
        );
        assert!(length_up([a, d]) > 10.0 * scale);
        assert!(circumradius_up(a, b, d) > 5.0 * scale);
    }
}

#[test]
fn the_ends_of_the_range() {
    let m = f64::MAX;
    let at = |x: f64, y: f64| Point::new(x, y);
    assert_eq!(length_up([at(0.0, 0.0), at(0.0, m)]), m);
    assert_eq!(length_up([at(0.0, -m), at(0.0, m)]), f64::INFINITY);
    assert_eq!(circumradius_up(at(0.0, -m), at(0.0, m), at(m, 0.0)), m);
    let half = circumradius_up(at(0.0, 0.0), at(m, 5e-324), at(m, 0.0));
    assert_eq!(half, (m / 2.0).next_up());
    let flat = circumradius_up(at(0.0, 0.0), at(m, 5e-324), at(-m, 0.0));
    assert_eq!(flat, f64::INFINITY);
    let least = 5e-324;
    assert_eq!(length_up([at(0.0, 0.0), at(least, least)]), 2.0 * least);
    let r = circumradius_up(at(0.0, 0.0), at(least, 0.0), at(0.0, least));
    assert_eq!(r, least, "the square root of one half");
    assert_eq!(length_up([at(least, least); 2]), 0.0);
}

#[test]
fn random_lattice_triangles_need_no_big_integers() {
    let mut random = Random(11);
    for _ in 0..10_000 {
        let mut c = || random.within(-1000, 1000) as f64;
        let [a, b, c] = [0; 3].map(|_| Point::new(c(), c()));
        if oracle::squared_circumradius([a, b, c]).is_some() {
            assert!(stage::circumradius_up(a, b, c).1 <= Stage::Integer);
        }
    }
}
