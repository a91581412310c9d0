//! The predicates of points with weights against rational arithmetic, and their laws.

use crate::families::FAMILIES;
use crate::oracle::Lifted;
use crate::random::Random;
use crate::{Tally, cases_per_family, side};
use delone::Point;
use delone::predicates::stage::{self, Stage};
use delone::predicates::{
    CircleSide, Orientation, Weighted, compare_distances, compare_powers, in_circle,
    in_circle_perturbed, in_power_circle, in_power_circle_perturbed, in_power_segment,
    in_power_segment_perturbed, orient2d, power_center,
};
use std::cmp::Ordering;

/// Gives each point a weight such that ties, near ties and clear cases all occur.
fn with_weights(points: [Point; 4], random: &mut Random) -> [Weighted; 4] {
    let size = points
        .iter()
        .fold(0.0, |m: f64, p| m.max(p.x.abs()).max(p.y.abs()));
    let finite = |w: f64| w.clamp(-f64::MAX, f64::MAX);
    let kind = random.within(0, 6);
    let power = random.power(-1000, 1000);
    points.map(|p| {
        let lift = p.x * p.x + p.y * p.y;
        let weight = match kind {
            0 => power,
            1 => lift,
            2 => finite(lift) + finite(random.within(-2, 2) as f64 * size),
            3 => random.jitter(finite(lift)),
            4 => random.within(-3, 3) as f64 * finite(size * size),
            5 => random.signed() * finite(size * size),
            _ => random.finite(),
        };
        Weighted::new(p, finite(weight))
    })
}

/// Calls `ask` with weighted cases of all families; every stage of `needed` must have decided some.
fn on_cases(needed: &[Stage], mut ask: impl FnMut([Weighted; 4], &mut Random) -> Option<Stage>) {
    let mut sum = Tally::default();
    for family in FAMILIES {
        let mut random = Random(family.name.bytes().map(u64::from).sum());
        for _ in 0..cases_per_family() / 4 {
            let points = (family.make)(&mut random);
            let sites = with_weights(points, &mut random);
            if let Some(stage) = ask(sites, &mut random) {
                sum.count(stage);
            }
        }
    }
    println!("{:?}", sum.0);
    assert!(needed.iter().all(|&s| sum.of(s) > 0), "{:?}", sum.0);
}

#[test]
fn in_power_circle_is_exact() {
    let all = [Stage::Filter, Stage::Integer, Stage::BigInteger];
    let (mut ties, mut second) = (0, 0);
    on_cases(&all, |sites, _| {
        let expected = Lifted::determinant(sites);
        let [a, b, c, d] = sites;
        let (found, stage) = stage::in_power_circle(a, b, c, d);
        assert_eq!(found, side(expected.exact), "{sites:?}");
        assert_eq!(in_power_circle(a, b, c, d), found);
        let (a, b, sign) = match orient2d(a.point, b.point, c.point) {
            Orientation::Left => (a, b, expected.perturbed),
            Orientation::Right => (b, a, expected.perturbed.reverse()),
            Orientation::Collinear => return Some(stage),
        };
        let is_corner = [a, b, c].contains(&d);
        let is_inside = in_power_circle_perturbed(a, b, c, d);
        assert_eq!(is_inside, !is_corner && sign.is_gt(), "{sites:?}");
        assert!(is_corner || sign.is_ne(), "{sites:?}");
        ties += u32::from(expected.exact.is_eq() && !is_corner);
        second += u32::from(expected.steps > 1 && !is_corner);
        Some(stage)
    });
    println!("{ties} ties, {second} with two steps");
    assert!(ties > 0 && second > 0, "{ties} {second}");
}

/// Three points of one line, exactly: two of the family, and one of them, a copy or a multiple.
fn on_a_line([a, b, p, q]: [Weighted; 4], random: &mut Random) -> Option<[Weighted; 3]> {
    let k = random.within(-3, 4) as f64;
    let at = |c: f64, d: f64| c + k * (d - c);
    let axis = random.within(0, 2);
    let [a, b, p] = match axis {
        0 => [
            a,
            Weighted {
                point: Point::new(b.point.x, a.point.y),
                ..b
            },
            Weighted {
                point: Point::new(p.point.x, a.point.y),
                ..p
            },
        ],
        1 => [
            a,
            Weighted {
                point: Point::new(a.point.x, b.point.y),
                ..b
            },
            Weighted {
                point: Point::new(a.point.x, p.point.y),
                ..p
            },
        ],
        _ => {
            let place = [at(a.point.x, b.point.x), at(a.point.y, b.point.y)];
            [a, b, Weighted::new(place, q.weight)]
        }
    };
    let is_row =
        p.point.is_finite() && orient2d(a.point, b.point, p.point) == Orientation::Collinear;
    (is_row && a.point != b.point).then_some([a, b, p])
}

#[test]
fn in_power_segment_is_exact() {
    let (mut ties, mut inside) = (0, [0, 0]);
    on_cases(&[Stage::Integer, Stage::BigInteger], |sites, random| {
        let [a, b, p] = on_a_line(sites, random)?;
        let expected = Lifted::determinant_on_line([a, b, p]);
        let (found, stage) = stage::in_power_segment(a, b, p);
        assert_eq!(found, side(expected.exact), "{a:?} {b:?} {p:?}");
        assert_eq!(in_power_segment(a, b, p), found);
        assert_eq!(in_power_segment(b, a, p), found);
        let is_end = [a, b].contains(&p);
        let is_inside = in_power_segment_perturbed(a, b, p);
        assert_eq!(
            is_inside,
            !is_end && expected.perturbed.is_gt(),
            "{a:?} {b:?} {p:?}"
        );
        assert_eq!(in_power_segment_perturbed(b, a, p), is_inside);
        ties += u32::from(expected.exact.is_eq() && !is_end);
        inside[usize::from(is_inside)] += 1;
        Some(stage)
    });
    assert!(
        ties > 0 && inside.iter().all(|&n| n > 0),
        "{ties} {inside:?}"
    );
}

#[test]
fn compare_powers_is_exact() {
    let mut found = [0; 3];
    on_cases(&[], |[a, b, twin, p], _| {
        let exact = Lifted::power(p.point, a).cmp(&Lifted::power(p.point, b));
        assert_eq!(compare_powers(p.point, a, b), exact, "{p:?} {a:?} {b:?}");
        assert_eq!(compare_powers(p.point, b, a), exact.reverse());
        let [a, b] = [a, b].map(|s| Weighted {
            weight: twin.weight,
            ..s
        });
        let distances = compare_distances(p.point, a.point, b.point);
        assert_eq!(compare_powers(p.point, a, b), distances);
        found[(exact as i8 + 1) as usize] += 1;
        None
    });
    assert!(found.iter().all(|&n| n > 100), "{found:?}");
}

#[test]
fn power_laws() {
    for family in FAMILIES {
        let mut random = Random(11);
        for _ in 0..500 {
            let points = (family.make)(&mut random);
            let sites = with_weights(points, &mut random);
            antisymmetric(sites);
            agrees_without_weights(points, random.finite());
            orders_equal_places(sites);
        }
    }
}

fn antisymmetric([a, b, c, d]: [Weighted; 4]) {
    let found = in_power_circle(a, b, c, d);
    assert_eq!(in_power_circle(b, c, a, d), found);
    for swapped in [[b, a, c, d], [d, b, c, a], [a, b, d, c]] {
        let [a, b, c, d] = swapped;
        assert_eq!(in_power_circle(a, b, c, d), found.reversed());
    }
    let turns = |a: Weighted, b: Weighted, c: Weighted| {
        orient2d(a.point, b.point, c.point) == Orientation::Left
    };
    if turns(a, b, c) {
        let found = in_power_circle_perturbed(a, b, c, d);
        assert_eq!(in_power_circle_perturbed(b, c, a, d), found);
        if turns(b, a, d) {
            assert_eq!(in_power_circle_perturbed(b, a, d, c), found);
        }
    }
}

fn agrees_without_weights([a, b, c, d]: [Point; 4], weight: f64) {
    let [wa, wb, wc, wd] = [a, b, c, d].map(|p| Weighted::new(p, weight));
    assert_eq!(in_power_circle(wa, wb, wc, wd), in_circle(a, b, c, d));
    if orient2d(a, b, c) == Orientation::Left {
        let found = in_power_circle_perturbed(wa, wb, wc, wd);
        assert_eq!(found, in_circle_perturbed(a, b, c, d));
    }
}

fn orders_equal_places([a, b, c, d]: [Weighted; 4]) {
    if orient2d(a.point, b.point, c.point) != Orientation::Left {
        return;
    }
    let twin = Weighted {
        weight: d.weight,
        ..b
    };
    let expected = match twin.weight.partial_cmp(&b.weight).expect("finite") {
        Ordering::Greater => CircleSide::Inside,
        Ordering::Equal => CircleSide::On,
        Ordering::Less => CircleSide::Outside,
    };
    assert_eq!(in_power_circle(a, b, c, twin), expected);
    assert_eq!(
        in_power_circle_perturbed(a, b, c, twin),
        expected == CircleSide::Inside
    );
}

#[test]
fn power_centers_are_correctly_rounded() {
    let mut beyond = 0;
    on_cases(&[], |[a, b, c, _], _| {
        let found = power_center(a, b, c);
        let exact = Lifted::center([a, b, c]);
        assert_eq!(found.is_none(), exact.is_none());
        let (found, exact) = (found?, exact?);
        for (found, exact) in [(found.x, &exact[0]), (found.y, &exact[1])] {
            assert!(
                Lifted::is_nearest(found, exact),
                "{found} {a:?} {b:?} {c:?}"
            );
            beyond += u32::from(found.abs() == f64::MAX);
        }
        for other in [[b, c, a], [b, a, c]] {
            let [a, b, c] = other;
            assert_eq!(power_center(a, b, c), Some(found));
        }
        None
    });
    assert!(beyond > 0, "{beyond}");
}
