//! The predicates against rational arithmetic, fixtures and their own laws.
//!
//! `DELONE_CASES=n` makes n cases of each family (default 20,000); each case asks every predicate.

mod bottom;
mod crossing;
mod families;
mod fixtures;
mod laws;
mod oracle;
mod power;
mod radius;
mod random;
mod stages;

use delone::Point;
use delone::predicates::stage::{self, Stage};
use delone::predicates::{self, CircleSide, Orientation};
use families::{FAMILIES, Family};
use random::Random;
use std::cmp::Ordering;

/// How often each stage decided.
#[derive(Default, Debug, Clone, Copy)]
struct Tally([u64; 3]);

impl Tally {
    fn count(&mut self, stage: Stage) {
        self.0[stage as usize] += 1;
    }

    fn of(&self, stage: Stage) -> u64 {
        self.0[stage as usize]
    }

    fn add(&mut self, other: &Self) {
        self.0.iter_mut().zip(other.0).for_each(|(n, m)| *n += m);
    }
}

fn cases_per_family() -> u64 {
    std::env::var("DELONE_CASES").map_or(20_000, |n| n.parse().expect("DELONE_CASES: a number"))
}

fn orientation(sign: Ordering) -> Orientation {
    match sign {
        Ordering::Greater => Orientation::Left,
        Ordering::Less => Orientation::Right,
        Ordering::Equal => Orientation::Collinear,
    }
}

fn side(sign: Ordering) -> CircleSide {
    match sign {
        Ordering::Greater => CircleSide::Inside,
        Ordering::Less => CircleSide::Outside,
        Ordering::Equal => CircleSide::On,
    }
}

/// Asks about each case of a family, and counts which stage decided.
fn run(family: &Family, ask: impl Fn(&Family, [Point; 4]) -> Stage) -> Tally {
    let mut random = Random(family.name.bytes().map(u64::from).sum());
    let mut tally = Tally::default();
    for _ in 0..cases_per_family() {
        tally.count(ask(family, (family.make)(&mut random)));
    }
    tally
}

/// Runs all families, and demands that every stage decided something.
fn run_all(ask: impl Fn(&Family, [Point; 4]) -> Stage) -> Vec<Tally> {
    let tallies: Vec<Tally> = FAMILIES.iter().map(|f| run(f, &ask)).collect();
    let mut sum = Tally::default();
    for (family, tally) in FAMILIES.iter().zip(&tallies) {
        println!("{:28} {:?}", family.name, tally.0);
        sum.add(tally);
        for stage in [Stage::Filter, Stage::Integer, Stage::BigInteger] {
            let is_allowed = family.stays_in.contains(&stage);
            assert!(
                is_allowed || tally.of(stage) == 0,
                "{}: {stage:?}",
                family.name
            );
        }
    }
    println!("{:28} {:?}", "all", sum.0);
    assert!(
        sum.0.iter().all(|&n| n > 0),
        "a stage was never hit: {sum:?}"
    );
    tallies
}

#[test]
fn orient2d_is_exact() {
    run_all(|family, [a, b, c, _]| {
        let (found, stage) = stage::orient2d(a, b, c);
        let name = family.name;
        assert_eq!(
            found,
            orientation(oracle::orient2d([a, b, c])),
            "{name}: {a:?} {b:?} {c:?}"
        );
        assert_eq!(predicates::orient2d(a, b, c), found);
        stage
    });
}

#[test]
fn in_circle_is_exact() {
    let tallies = run_all(|family, [a, b, c, d]| {
        let expected = oracle::in_circle([a, b, c, d]);
        let (found, stage) = stage::in_circle(a, b, c, d);
        let case = format_args!("{}: {a:?} {b:?} {c:?} {d:?}", family.name).to_string();
        assert_eq!(found, side(expected.exact), "{case}");
        assert_eq!(predicates::in_circle(a, b, c, d), found);
        assert_perturbed([a, b, c, d], expected.perturbed);
        stage
    });
    for (family, tally) in FAMILIES.iter().zip(&tallies) {
        for &stage in family.uses {
            assert!(tally.of(stage) > 0, "{}: no {stage:?}", family.name);
        }
    }
}

/// Checks the perturbed test on `abc` turned counter-clockwise; `sign` is that of the determinant.
fn assert_perturbed([a, b, c, d]: [Point; 4], sign: Ordering) {
    let (a, b, sign) = match predicates::orient2d(a, b, c) {
        Orientation::Left => (a, b, sign),
        Orientation::Right => (b, a, sign.reverse()),
        Orientation::Collinear => return,
    };
    let is_inside = predicates::in_circle_perturbed(a, b, c, d);
    let is_corner = [a, b, c].contains(&d);
    assert_eq!(
        is_inside,
        !is_corner && sign.is_gt(),
        "{a:?} {b:?} {c:?} {d:?}"
    );
    assert!(is_corner || sign.is_ne(), "{a:?} {b:?} {c:?} {d:?}");
    assert_eq!(is_inside, stage::in_circle_perturbed(a, b, c, d).0);
}

#[test]
fn compare_distances_is_exact() {
    run_all(|family, [p, a, b, _]| {
        let (found, stage) = stage::compare_distances(p, a, b);
        let name = family.name;
        assert_eq!(
            found,
            oracle::compare_distances([p, a, b]),
            "{name}: {p:?} {a:?} {b:?}"
        );
        assert_eq!(predicates::compare_distances(p, a, b), found);
        stage
    });
}

#[test]
fn compare_lengths_is_exact() {
    run_all(|family, [a, b, c, d]| {
        let (found, stage) = stage::compare_lengths([a, b], [c, d]);
        let expected = oracle::compare_lengths([[a, b], [c, d]]);
        assert_eq!(found, expected, "{}: {a:?} {b:?} {c:?} {d:?}", family.name);
        assert_eq!(predicates::compare_lengths([a, b], [c, d]), found);
        stage
    });
}

#[test]
fn in_diametral_circle_is_exact() {
    run_all(|family, [a, b, p, _]| {
        let (found, stage) = stage::in_diametral_circle(a, b, p);
        let name = family.name;
        let expected = side(oracle::in_diametral_circle([a, b, p]).reverse());
        assert_eq!(found, expected, "{name}: {a:?} {b:?} {p:?}");
        assert_eq!(predicates::in_diametral_circle(a, b, p), found);
        stage
    });
}
