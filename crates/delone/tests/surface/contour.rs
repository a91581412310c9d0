//! Contour lines: every crossed edge once, no branches, higher to the left.

use crate::support::{domain, sampled, triangulated};
use delone::surface::{Contour, Interpolant, Linear, Samples, contours};
use delone::{Error, Point, VertexId};
use delone_testkit::generate::{Kind, Random};
use std::collections::{BTreeMap, BTreeSet};

type Key = (u64, u64);

fn key(p: Point) -> Key {
    (p.x.to_bits(), p.y.to_bits())
}

/// Edges of triangles, each once, with the number of triangles beside it.
fn edges(samples: &Samples<'_>) -> BTreeMap<[VertexId; 2], usize> {
    let mut sides = BTreeMap::new();
    for t in samples.ground().triangulation().triangles() {
        for k in 0..3 {
            let [a, b] = [t[k], t[(k + 1) % 3]];
            *sides.entry([a.min(b), a.max(b)]).or_insert(0) += 1;
        }
    }
    sides
}

/// The edges with one end at or above the level and one below.
fn crossed(samples: &Samples<'_>, level: f64) -> Vec<([VertexId; 2], bool)> {
    let is_above = |v: VertexId| samples.value(v) >= level;
    let crossed = edges(samples)
        .into_iter()
        .filter(|([a, b], _)| is_above(*a) != is_above(*b));
    crossed.map(|(edge, sides)| (edge, sides == 1)).collect()
}

/// Where an edge has the level, by the plain formula.
fn place(samples: &Samples<'_>, [a, b]: [VertexId; 2], level: f64) -> Point {
    let [f, g] = [a, b].map(|v| samples.value(v));
    let [p, q] = [a, b].map(|v| samples.ground().triangulation().point(v));
    let s = (level - f) / (g - f);
    Point::new(p.x + s * (q.x - p.x), p.y + s * (q.y - p.y))
}

fn distance(p: Point, q: Point) -> f64 {
    (p.x - q.x).hypot(p.y - q.y)
}

/// Finds each point of the lines on a crossed edge, and ends at borders.
fn check(samples: &Samples<'_>, lines: &[Contour], level: f64) {
    let crossed = crossed(samples, level);
    let places: Vec<_> = crossed
        .iter()
        .map(|&(edge, is_border)| (place(samples, edge, level), is_border))
        .collect();
    for line in lines {
        assert_eq!(line.value, level);
        assert!(line.points.windows(2).all(|w| w[0] != w[1]));
        assert!(!line.is_closed || line.points.first() != line.points.last());
        assert!(line.points.len() >= 2);
        for &p in &line.points {
            assert!(
                places.iter().any(|(q, _)| distance(p, *q) < 1e-9),
                "{p:?} on no edge"
            );
        }
        if !line.is_closed {
            for end in [line.points[0], line.points[line.points.len() - 1]] {
                let at_border =
                    |(q, is_border): &(Point, bool)| *is_border && distance(end, *q) < 1e-9;
                assert!(places.iter().any(at_border), "{end:?} not at the border");
            }
        }
    }
}

/// Levels between values: every crossed edge has a point of its own, and each comes exactly once.
fn check_between(samples: &Samples<'_>, lines: &[Contour], level: f64) {
    check(samples, lines, level);
    let crossed = crossed(samples, level);
    let found: Vec<Key> = lines
        .iter()
        .flat_map(|l| &l.points)
        .map(|&p| key(p))
        .collect();
    assert_eq!(found.len(), crossed.len(), "each crossed edge once");
    let distinct: BTreeSet<Key> = found.iter().copied().collect();
    assert_eq!(distinct.len(), found.len(), "no branch and no meeting");
    let open = lines.iter().filter(|l| !l.is_closed).count();
    let at_border = crossed.iter().filter(|(_, is_border)| *is_border).count();
    assert_eq!(2 * open, at_border, "every end at a border is an end");
    let surface = Linear::new(samples);
    for line in lines {
        let ring = line.is_closed.then(|| line.points[0]);
        let points: Vec<Point> = line.points.iter().copied().chain(ring).collect();
        for w in points.windows(2) {
            let middle = Point::new((w[0].x + w[1].x) / 2.0, (w[0].y + w[1].y) / 2.0);
            let aside = |side: f64| {
                let d = side * 1e-7;
                let p = Point::new(
                    middle.x - d * (w[1].y - w[0].y),
                    middle.y + d * (w[1].x - w[0].x),
                );
                surface.value(p)
            };
            assert!(
                aside(1.0).is_none_or(|v| v > level),
                "{w:?}: higher to the left"
            );
            assert!(
                aside(-1.0).is_none_or(|v| v < level),
                "{w:?}: lower to the right"
            );
        }
    }
}

#[test]
fn between_values_every_crossed_edge_is_used_once() {
    let kinds = [
        Kind::Lattice { side: 5 },
        Kind::Lattice { side: 20 },
        Kind::Uniform,
        Kind::CocircularRings,
    ];
    for kind in kinds {
        for seed in 0..10 {
            let t = triangulated(kind, 80, seed);
            let mut random = Random::new(seed);
            let mut values: Vec<f64> = t.points().iter().map(|_| random.below(4) as f64).collect();
            for d in t.duplicates() {
                values[d.dropped.index()] = values[d.kept.index()];
            }
            let samples = Samples::new(&t, values).expect("values");
            let levels = [0.5, 1.5, 2.5, 1.25];
            let lines = contours(&samples, &levels, &()).expect("lines");
            for (i, &level) in levels.iter().enumerate() {
                let own: Vec<_> = lines.iter().filter(|l| l.level == i).cloned().collect();
                check_between(&samples, &own, level);
            }
        }
    }
}

/// Levels that are values: plateaus, ridges, pits and summits of all sorts.
#[test]
fn levels_that_are_values_are_decided_as_if_a_little_lower() {
    for seed in 0..40 {
        let t = triangulated(Kind::Lattice { side: 6 }, 90, seed);
        let mut random = Random::new(seed);
        let mut values: Vec<f64> = t.points().iter().map(|_| random.below(3) as f64).collect();
        for d in t.duplicates() {
            values[d.dropped.index()] = values[d.kept.index()];
        }
        let samples = Samples::new(&t, values).expect("values");
        for level in [0.0, 1.0, 2.0, 3.0] {
            let exact = contours(&samples, &[level], &()).expect("lines");
            check(&samples, &exact, level);
            // Just below, topology is the same, and no two points coincide; summits collapse.
            let near = level - 1e-4;
            let lower = contours(&samples, &[near], &()).expect("lines");
            check_between(&samples, &lower, near);
            let collapsed: Vec<_> = lower.iter().filter_map(|l| collapse(&samples, l)).collect();
            assert_eq!(exact.len(), collapsed.len(), "{seed} {level}");
            for (line, expected) in exact.iter().zip(collapsed) {
                assert_eq!(line.is_closed, expected.is_closed);
                assert_eq!(line.points.len(), expected.points.len(), "{seed} {level}");
                let mut pairs = line.points.iter().zip(&expected.points);
                assert!(pairs.all(|(p, q)| distance(*p, *q) < 1e-3));
            }
        }
    }
}

/// Moves points near a vertex onto it; `None` if all become one.
fn collapse(samples: &Samples<'_>, line: &Contour) -> Option<Contour> {
    let vertices = samples.ground().triangulation().points();
    let snap = |p: &Point| {
        let near = vertices.iter().find(|v| distance(**v, *p) < 1e-3);
        *near.unwrap_or(p)
    };
    let mut points: Vec<Point> = line.points.iter().map(snap).collect();
    points.dedup();
    while line.is_closed && points.len() > 1 && points.first() == points.last() {
        points.pop();
    }
    let line = line.clone();
    (points.len() > 1).then_some(Contour { points, ..line })
}

#[test]
fn lines_stay_in_their_domain() {
    for seed in 0..5 {
        let t = domain(150, seed);
        let mut random = Random::new(seed);
        let points = t.triangulation().points();
        let values: Vec<f64> = points.iter().map(|_| random.below(10) as f64).collect();
        let samples = Samples::new(&t, values).expect("values");
        let levels = [2.5, 4.5, 6.5];
        let lines = contours(&samples, &levels, &()).expect("lines");
        for (i, &level) in levels.iter().enumerate() {
            let own: Vec<_> = lines.iter().filter(|l| l.level == i).cloned().collect();
            check_between(&samples, &own, level);
        }
    }
}

#[test]
fn flat_surfaces_and_levels_beyond_have_no_lines() {
    let t = triangulated(Kind::Lattice { side: 4 }, 40, 3);
    let samples = sampled(&t, |_| 2.0);
    for level in [1.0, 2.0, 3.0] {
        assert_eq!(contours(&samples, &[level], &()), Ok(vec![]));
    }
    let row = delone::triangulate([(0.0, 0.0), (1.0, 0.0), (3.0, 0.0)]).expect("a row");
    let samples = sampled(&row, |p| p.x);
    assert_eq!(contours(&samples, &[1.5], &()), Ok(vec![]));
    let error = contours(&samples, &[1.0, f64::NAN], &()).expect_err("NaN");
    assert!(matches!(error, Error::BadLevel { .. }));
}

#[test]
fn extreme_values_and_coordinates_keep_lines_within_their_triangles() {
    for kind in Kind::ALL {
        let t = triangulated(kind, 50, 5);
        let mut random = Random::new(6);
        let mut values: Vec<f64> = t.points().iter().map(|_| random.finite()).collect();
        for d in t.duplicates() {
            values[d.dropped.index()] = values[d.kept.index()];
        }
        let samples = Samples::new(&t, values).expect("values");
        let levels = [-1e300, -1.0, 0.0, 1e-300, 1e300];
        let lines = contours(&samples, &levels, &()).expect("lines");
        let total: usize = levels
            .iter()
            .map(|&level| crossed(&samples, level).len())
            .sum();
        let found: usize = lines.iter().map(|line| line.points.len()).sum();
        assert!(found <= total, "{kind:?}");
        assert!(t.num_triangles() == 0 || found > 0, "{kind:?}");
        assert!(lines.iter().flat_map(|l| &l.points).all(Point::is_finite));
    }
}

#[test]
fn lines_come_level_by_level_and_open_ones_first() {
    let t = triangulated(Kind::Uniform, 500, 7);
    let samples = sampled(&t, |p| (9.0 * p.x).sin() + (11.0 * p.y).cos());
    let lines = contours(&samples, &[0.9, -0.3, 0.2], &()).expect("lines");
    assert!(lines.is_sorted_by_key(|l| (l.level, l.is_closed)));
    assert!(lines.iter().any(|l| l.is_closed) && lines.iter().any(|l| !l.is_closed));
}
