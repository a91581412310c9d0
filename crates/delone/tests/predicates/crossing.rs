//! The crossing point against rational arithmetic: no `f64` is nearer, and ties go to the even one.

use crate::families::{FAMILIES, Family};
use crate::random::Random;
use crate::{Tally, cases_per_family};
use dashu_ratio::Relaxed;
use delone::Point;
use delone::predicates::Orientation;
use delone::predicates::stage::{self, Stage};
use delone::predicates::{cross_properly, crossing_point, is_between, orient2d};

fn rational(c: f64) -> Relaxed {
    Relaxed::try_from(c).expect("finite")
}

/// The exact crossing of two lines that are not parallel.
fn exact_crossing([a, b]: [Point; 2], [c, d]: [Point; 2]) -> [Relaxed; 2] {
    let [a, b, c, d] = [a, b, c, d].map(|p| [rational(p.x), rational(p.y)]);
    let minus = |p: &[Relaxed; 2], q: &[Relaxed; 2]| [&p[0] - &q[0], &p[1] - &q[1]];
    let cross = |p: &[Relaxed; 2], q: &[Relaxed; 2]| &p[0] * &q[1] - &p[1] * &q[0];
    let (along, other) = (minus(&b, &a), minus(&d, &c));
    let t = cross(&minus(&c, &a), &other) / cross(&along, &other);
    [0, 1].map(|k| &a[k] + &t * &along[k])
}

/// Whether `rounded` is the `f64` nearest to `exact`, the even one of two.
fn is_nearest(rounded: f64, exact: &Relaxed) -> bool {
    let distance = |c: f64| {
        let difference = &rational(c) - exact;
        if difference < Relaxed::ZERO {
            -difference
        } else {
            difference
        }
    };
    let own = distance(rounded);
    let neighbours = [rounded.next_down(), rounded.next_up()];
    let is_even = rounded.to_bits().is_multiple_of(2);
    neighbours.into_iter().filter(|c| c.is_finite()).all(|c| {
        let other = distance(c);
        own < other || (own == other && is_even)
    })
}

fn assert_nearest(s: [Point; 2], t: [Point; 2]) -> Stage {
    let (found, stage) = stage::crossing_point(s, t).expect("a crossing");
    let [x, y] = exact_crossing(s, t);
    assert!(is_nearest(found.x, &x), "{s:?} {t:?}: x of {found:?}");
    assert!(is_nearest(found.y, &y), "{s:?} {t:?}: y of {found:?}");
    let bits = |p: Point| [p.x.to_bits(), p.y.to_bits()];
    let [[a, b], [c, d]] = [s, t];
    for (s, t) in [(t, s), ([b, a], t), (s, [d, c])] {
        let other = crossing_point(s, t).expect("a crossing");
        assert_eq!(bits(other), bits(found), "{s:?} {t:?}");
    }
    stage
}

/// Pairs four points so that their segments cross, if some pairing does.
fn paired([a, b, c, d]: [Point; 4]) -> Option<[[Point; 2]; 2]> {
    let pairings = [[[a, b], [c, d]], [[a, c], [b, d]], [[a, d], [b, c]]];
    pairings.into_iter().find(|&[s, t]| cross_properly(s, t))
}

fn run(family: &Family) -> Tally {
    let mut random = Random(family.name.len() as u64);
    let mut tally = Tally::default();
    for _ in 0..cases_per_family() / 4 {
        if let Some([s, t]) = paired((family.make)(&mut random)) {
            tally.count(assert_nearest(s, t));
        }
    }
    tally
}

#[test]
fn crossings_are_correctly_rounded() {
    for family in FAMILIES {
        let tally = run(family);
        let [filter, exact] = [Stage::Filter, Stage::BigInteger].map(|s| tally.of(s));
        println!("{:28} {filter} {exact}", family.name);
        match family.name {
            "uniform" => assert!(filter > 20 && exact == 0, "{tally:?}"),
            "subnormal" => assert!(exact > 0, "{tally:?}"),
            name => assert!(filter + exact > 20, "{name}: {tally:?}"),
        }
    }
}

/// Segments that cross within one unit in the last place, far from the origin.
#[test]
fn crossings_within_one_ulp() {
    let mut random = Random(7);
    let mut found = 0;
    for _ in 0..cases_per_family() {
        let [x, y] = [5e5, 5e6].map(|c| c + random.unit());
        let [u, v] = [random.signed() * 10.0, random.signed() * 10.0];
        let ends = [Point::new(x, y), Point::new(x + u, y + v)];
        let near = ends.map(|p| Point::new(random.jitter(p.x), random.jitter(p.y)));
        if let Some([s, t]) = paired([ends[0], ends[1], near[0], near[1]]) {
            assert_nearest(s, t);
            found += 1;
        }
    }
    assert!(found > 100, "{found}");
}

/// Coordinates exactly between two numbers: the even one is taken, up and down.
#[test]
fn ties_go_to_the_even_number() {
    let unit = f64::EPSILON;
    for (k, expected) in [(0.0, 1.0), (1.0, 1.0 + 2.0 * unit), (2.0, 1.0 + 2.0 * unit)] {
        let [low, high] = [1.0 + k * unit, 1.0 + (k + 1.0) * unit];
        // The diagonals of a square meet in its centre.
        let s = [Point::new(low, low), Point::new(high, high)];
        let t = [Point::new(low, high), Point::new(high, low)];
        let (found, stage) = stage::crossing_point(s, t).expect("a crossing");
        assert_eq!((found.x, found.y), (expected, expected));
        assert_eq!(stage, Stage::BigInteger);
    }
    let least = 5e-324;
    for (size, expected) in [(1.0, 0.0), (2.0, 1.0), (3.0, 2.0), (5.0, 2.0), (7.0, 4.0)] {
        let c = size * least;
        let s = [Point::new(0.0, 0.0), Point::new(c, -c)];
        let t = [Point::new(0.0, -c), Point::new(c, 0.0)];
        let found = crossing_point(s, t).expect("a crossing");
        assert_eq!((found.x, found.y), (expected * least, -expected * least));
    }
}

#[test]
fn a_crossing_at_zero_is_positive_zero() {
    let at = |x: f64, y: f64| Point::new(x, y);
    for s in [
        [at(-1.0, -0.0), at(1.0, -0.0)],
        [at(-1.0, 1.0), at(1.0, -1.0)],
    ] {
        let t = [at(-0.0, -1.0), at(-0.0, 1.0)];
        let found = crossing_point(s, t).expect("a crossing");
        assert!(found.x.is_sign_positive() && found.y.is_sign_positive());
    }
    // Rounded to zero from below.
    let c = 5e-324;
    let found = crossing_point([at(-c, -c), at(0.0, 0.0)], [at(-c, 0.0), at(0.0, -c)]);
    let found = found.expect("a crossing");
    assert!(found.x.is_sign_positive() && found.y.is_sign_positive());
}

#[test]
fn the_largest_numbers_do_not_overflow() {
    let m = f64::MAX;
    let at = |x: f64, y: f64| Point::new(x, y);
    let found = crossing_point([at(-m, -m), at(m, m)], [at(-m, m), at(m, -m)]);
    assert_eq!(found, Some(at(0.0, 0.0)));
    let below = m.next_down();
    let found = crossing_point([at(below, -1.0), at(m, 1.0)], [at(below, 1.0), at(m, -1.0)]);
    assert_eq!(found, Some(at(below, 0.0)), "a tie: the even one");
}

#[test]
fn touching_is_not_crossing() {
    let at = |x: f64, y: f64| Point::new(x, y);
    let s = [at(0.0, 0.0), at(4.0, 2.0)];
    for t in [
        [at(2.0, 1.0), at(3.0, 5.0)],
        [at(0.0, 0.0), at(1.0, 5.0)],
        [at(2.0, 1.0), at(6.0, 3.0)],
        [at(0.0, 1.0), at(4.0, 3.0)],
        [at(6.0, 0.0), at(5.0, 3.0)],
    ] {
        assert_eq!(crossing_point(s, t), None);
        assert_eq!(crossing_point(t, s), None);
    }
    assert!(is_between(s[0], s[1], at(2.0, 1.0)));
    for p in [
        s[0],
        s[1],
        at(6.0, 3.0),
        at(-2.0, -1.0),
        at(2.0, 1.0_f64.next_up()),
    ] {
        assert!(!is_between(s[0], s[1], p) && !is_between(s[1], s[0], p));
    }
    assert!(!is_between(s[0], s[0], s[0]));
}

#[test]
fn between_means_collinear_and_in_order() {
    let mut random = Random(3);
    for _ in 0..cases_per_family() {
        let mut c = || random.within(-3, 3) as f64;
        let [a, b, p] = [0; 3].map(|_| Point::new(c(), c()));
        let dot = (p.x - a.x) * (p.x - b.x) + (p.y - a.y) * (p.y - b.y);
        let expected = orient2d(a, b, p) == Orientation::Collinear && dot < 0.0;
        assert_eq!(is_between(a, b, p), expected, "{a:?} {b:?} {p:?}");
    }
}
