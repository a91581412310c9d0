//! Lowest points of circles, and parabolas, against rational arithmetic, and their laws.

use crate::families::FAMILIES;
use crate::oracle;
use crate::random::Random;
use crate::{Tally, cases_per_family};
use delone::Point;
use delone::predicates::stage::{self, Stage};
use delone::predicates::{compare_bottom, compare_bottoms, compare_distances, compare_parabolas};
use std::cmp::Ordering;

/// Calls `ask` with cases of all families, some of them moved to where one of their points is; returns how
/// often each stage decided, and how many were ties.
fn on_cases(mut ask: impl FnMut([Point; 4]) -> Option<(Ordering, Stage)>) -> (Tally, usize) {
    let (mut sum, mut ties) = (Tally::default(), 0);
    for family in FAMILIES {
        let mut random = Random(family.name.bytes().map(u64::from).sum());
        for _ in 0..cases_per_family() / 10 {
            if let Some((order, stage)) = ask((family.make)(&mut random)) {
                sum.count(stage);
                ties += usize::from(order.is_eq());
            }
        }
    }
    println!("{:?}, {ties} ties", sum.0);
    let is_hit = [Stage::Filter, Stage::BigInteger].map(|stage| sum.of(stage) > 0);
    assert_eq!(is_hit, [true; 2], "a stage was never hit: {sum:?}");
    (sum, ties)
}

#[test]
fn compare_bottoms_is_exact() {
    let (_, ties) = on_cases(|[a, b, c, d]| {
        let (t, u) = ([a, b, c], [d, c, a]);
        let (t_circle, u_circle) = (oracle::circle(t)?, oracle::circle(u)?);
        let expected = oracle::compare_bottoms([&t_circle, &u_circle]);
        let (found, stage) = stage::compare_bottoms(t, u);
        assert_eq!(found, expected, "{t:?} {u:?}");
        assert_eq!(compare_bottoms([c, a, b], u), found);
        assert_eq!(compare_bottoms(u, [b, a, c]), found.reverse());
        assert_eq!(compare_bottoms(t, [b, c, a]), Ordering::Equal);
        Some((found, stage))
    });
    assert!(ties > 1000, "{ties}");
}

#[test]
fn compare_bottom_is_exact() {
    let (_, ties) = on_cases(|[a, b, c, d]| {
        let t = [a, b, c];
        let circle = oracle::circle(t)?;
        let expected = oracle::compare_bottoms([&circle, &oracle::point_circle(d)]);
        let (found, stage) = stage::compare_bottom(t, d);
        assert_eq!(found, expected, "{t:?} {d:?}");
        assert_eq!(compare_bottom([c, b, a], d), found);
        assert!(found.is_lt() || t.iter().all(|p| p.y >= d.y));
        Some((found, stage))
    });
    assert!(ties > 10, "{ties}");
}

#[test]
fn compare_parabolas_is_exact() {
    let (_, ties) = on_cases(|mut points| {
        points.sort_by(|p, q| p.y.total_cmp(&q.y));
        let [p, a, b, _] = points;
        if a.y == p.y {
            assert!(a == p || b.y == p.y || compare_parabolas(p, a, b).is_gt());
            return None;
        }
        let expected = oracle::compare_parabolas([p, a, b]);
        let (found, stage) = stage::compare_parabolas(p, a, b);
        assert_eq!(found, expected, "{p:?} {a:?} {b:?}");
        assert_eq!(compare_parabolas(p, b, a), found.reverse());
        if a.y == b.y {
            assert_eq!(found, compare_distances(p, a, b));
        } else if found.is_eq() && oracle::circle([p, a, b]).is_some() {
            assert_eq!(compare_bottom([p, a, b], p), Ordering::Equal);
        }
        Some((found, stage))
    });
    assert!(ties > 100, "{ties}");
}

/// One unit in the last place is seen, at any scale.
#[test]
fn a_circle_touches_a_line() {
    for exponent in [-1000, -300, 0, 300, 1000] {
        let scale = f64::powi(2.0, exponent / 2) * f64::powi(2.0, exponent / 2);
        let at = |x: f64, y: f64| Point::new(x * scale, y * scale);
        let t = [at(5.0, 0.0), at(3.0, 4.0), at(-4.0, 3.0)];
        let level = at(7.0, -5.0);
        assert_eq!(compare_bottom(t, level), Ordering::Equal);
        let [above, below] = [level.y.next_up(), level.y.next_down()].map(|y| Point::new(0.0, y));
        assert_eq!(compare_bottom(t, above), Ordering::Less);
        assert_eq!(compare_bottom(t, below), Ordering::Greater);
        let small = [at(8.0, -5.0), at(9.0, -4.0), at(8.0, -3.0)];
        assert_eq!(compare_bottoms(t, small), Ordering::Equal);
        let moved = [
            small[0],
            small[1],
            Point::new(small[2].x, small[2].y.next_up()),
        ];
        // The circle grows to both sides of its two other points.
        assert_eq!(compare_bottoms(t, moved), Ordering::Greater);
    }
}
