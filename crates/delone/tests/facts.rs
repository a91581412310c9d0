//! Facts about drawings, against brute force.

use delone::predicates::{Orientation, cross_properly, crossing_point, is_between, orient2d};
use delone::{Error, Facts, Point, Pslg, VertexId, Watch};
use delone_testkit::corpus;
use delone_testkit::generate::Random;
use std::collections::BTreeSet;

const ALL: usize = 1 << 20;

fn facts(pslg: &Pslg) -> Facts {
    pslg.facts(ALL, &()).expect("a graph without mistakes")
}

fn lattice(random: &mut Random, size: usize, points: usize, segments: usize) -> Pslg {
    let mut c = || random.below(size) as f64;
    let points = Pslg::from_points((0..points).map(|_| (c(), c())));
    let n = points.points.len();
    let mut pslg = points;
    for _ in 0..segments {
        let [a, b] = [0; 2].map(|_| random.below(n) as u32);
        pslg.add_segment(a, b);
    }
    pslg
}

/// Distinct segments by their ends, each with its first index.
fn merged(pslg: &Pslg) -> Vec<([Point; 2], usize)> {
    let mut all: Vec<([Point; 2], usize)> = Vec::new();
    for (i, ends) in pslg.segments.iter().enumerate() {
        let [a, b] = ends.map(|v| pslg.points[v.index()]);
        let is_known = all.iter().any(|(s, _)| *s == [a, b] || *s == [b, a]);
        if a != b && !is_known {
            all.push(([a, b], i));
        }
    }
    all
}

fn share_more_than_a_point([a, b]: [Point; 2], [c, d]: [Point; 2]) -> bool {
    let on_line = |p| orient2d(a, b, p) == Orientation::Collinear;
    let [[a, b], [c, d]] = [[a, b], [c, d]].map(|[p, q]| {
        if p.lex_cmp(&q).is_lt() {
            [p, q]
        } else {
            [q, p]
        }
    });
    on_line(c) && on_line(d) && a.lex_cmp(&d).is_lt() && c.lex_cmp(&b).is_lt()
}

fn assert_as_by_brute_force(pslg: &Pslg) {
    let facts = facts(pslg);
    let segments = merged(pslg);
    let (mut crossings, mut overlaps, mut on) = (Vec::new(), Vec::new(), Vec::new());
    for (k, &(s, i)) in segments.iter().enumerate() {
        for &(t, j) in &segments[k + 1..] {
            if cross_properly(s, t) {
                crossings.push(([i, j], crossing_point(s, t).expect("a crossing")));
            }
            if share_more_than_a_point(s, t) {
                overlaps.push([i, j]);
            }
        }
        for (v, &p) in pslg.points.iter().enumerate() {
            if !pslg.points[..v].contains(&p) && is_between(s[0], s[1], p) {
                on.push((i, v, p));
            }
        }
    }
    let found = facts.crossings.first.iter().map(|c| (c.segments, c.at));
    assert_eq!(found.collect::<Vec<_>>(), crossings);
    assert_eq!(facts.overlaps.first, overlaps);
    let found = facts.on_segments.first.iter();
    let found = found.map(|f| (f.segment, f.vertex.index(), f.at));
    assert_eq!(found.collect::<Vec<_>>(), on);
    assert_eq!(
        facts.is_clean(),
        crossings.is_empty() && overlaps.is_empty() && on.is_empty()
    );
    assert_eq!(facts.crossings.count, crossings.len() as u64);
}

#[test]
fn meetings_are_as_by_brute_force() {
    for seed in 0..2000 {
        let mut random = Random::new(seed);
        let size = 2 + random.below(7);
        let (points, segments) = (2 + random.below(12), random.below(14));
        assert_as_by_brute_force(&lattice(&mut random, size, points, segments));
    }
}

#[test]
fn everything_is_counted_and_the_first_are_listed() {
    let mut random = Random::new(5);
    let pslg = lattice(&mut random, 1000, 200, 100);
    let all = facts(&pslg);
    assert!(all.crossings.count > 500);
    let some = pslg.facts(3, &()).expect("a graph without mistakes");
    assert_eq!(some.crossings.count, all.crossings.count);
    assert_eq!(some.crossings.first, all.crossings.first[..3]);
}

#[test]
fn doubles_and_ends() {
    let mut pslg = Pslg::from_points([(0.0, 0.0), (4.0, 0.0), (0.0, -0.0), (9.0, 9.0), (4.0, 0.0)]);
    for (a, b) in [(0, 1), (4, 2), (0, 2), (1, 0), (3, 3)] {
        pslg.add_segment(a, b);
    }
    let facts = facts(&pslg);
    let v = VertexId::new;
    assert_eq!((facts.points, facts.segments), (5, 5));
    assert_eq!(facts.duplicates.first, [[v(2), v(0)], [v(4), v(1)]]);
    assert_eq!(facts.zero_length.first, [2, 4]);
    assert_eq!(facts.repeated.first, [[1, 0], [3, 0]]);
    assert_eq!(facts.loose_points.first, [v(3)]);
    assert_eq!(facts.open_ends.first, [v(0), v(1)]);
    assert!(!facts.is_collinear && facts.is_clean() && facts.rings.is_empty());
}

#[test]
fn points_on_a_line_are_noticed() {
    for (points, expected) in [
        (vec![], true),
        (vec![(1.0, 2.0)], true),
        (vec![(0.0, 0.0), (1e300, 1e300), (1e-300, 1e-300)], true),
        (
            vec![(0.0, 0.0), (1.0, 1.0), (3.0, 3.0_f64.next_up())],
            false,
        ),
    ] {
        assert_eq!(facts(&Pslg::from_points(points)).is_collinear, expected);
    }
}

fn add_ring(pslg: &mut Pslg, ring: &[(f64, f64)]) {
    let first = pslg.points.len() as u32;
    pslg.points.extend(ring.iter().map(|&p| Point::from(p)));
    pslg.add_ring(first..first + ring.len() as u32);
}

fn square(x: f64, y: f64, radius: f64) -> [(f64, f64); 4] {
    let r = radius;
    [
        (x - r, y - r),
        (x + r, y - r),
        (x + r, y + r),
        (x - r, y + r),
    ]
}

/// Whether a point lies inside of a ring, by the parity of the edges above it.
fn is_inside(p: Point, ring: &[Point]) -> bool {
    let next = ring.iter().cycle().skip(1);
    let above = ring.iter().zip(next).filter(|&(&a, &b)| {
        let (a, b) = if a.x < b.x { (a, b) } else { (b, a) };
        a.x <= p.x && p.x < b.x && orient2d(a, b, p) == Orientation::Right
    });
    above.count() % 2 == 1
}

fn rings_of(pslg: &Pslg, facts: &Facts) -> Vec<Vec<Point>> {
    // In these drawings the segments of a ring follow each other.
    let points = |ring: &delone::Ring| {
        pslg.segments[ring.segment..ring.segment + ring.len]
            .iter()
            .map(|s| pslg.points[s[0].index()])
    };
    facts
        .rings
        .iter()
        .map(|ring| points(ring).collect())
        .collect()
}

fn assert_nested(pslg: &Pslg) {
    let facts = facts(pslg);
    assert!(facts.are_rings_apart);
    let rings = rings_of(pslg, &facts);
    for (i, ring) in facts.rings.iter().enumerate() {
        let around: BTreeSet<usize> = (0..rings.len())
            .filter(|&j| j != i && is_inside(rings[i][0], &rings[j]))
            .collect();
        assert_eq!(ring.depth, around.len());
        let parent = around
            .iter()
            .copied()
            .find(|&j| facts.rings[j].depth + 1 == ring.depth);
        assert_eq!(ring.parent, parent);
    }
}

#[test]
fn rings_know_their_parents() {
    for seed in 0..300 {
        let mut random = Random::new(seed);
        let mut pslg = Pslg::default();
        // Squares and diamonds of odd sizes around points of a lattice do not meet in most cases.
        for _ in 0..1 + random.below(12) {
            let [x, y] = [0; 2].map(|_| 16.0 * random.below(3) as f64);
            let r = 0.5 + random.below(15) as f64;
            let mut ring = match random.below(2) {
                0 => square(x, y, r),
                _ => [(x - r, y), (x, y - r), (x + r, y), (x, y + r)],
            };
            if random.below(2) == 0 {
                ring.reverse();
            }
            let mut more = pslg.clone();
            add_ring(&mut more, &ring);
            let found = facts(&more);
            if found.is_clean() && found.duplicates.count == 0 {
                pslg = more;
            }
        }
        assert_nested(&pslg);
    }
}

#[test]
fn a_hundred_thousand_rings_take_no_time_squared() {
    let mut concentric = Pslg::default();
    let mut beside = Pslg::default();
    for i in 0..100_000 {
        let [x, y] = [f64::from(i % 316), f64::from(i / 316)];
        add_ring(&mut beside, &square(x, y, 0.25));
        add_ring(&mut concentric, &square(0.0, 0.0, 1.0 + f64::from(i)));
    }
    assert!(facts(&beside).rings.iter().all(|ring| ring.depth == 0));
    let nested = facts(&concentric);
    for (i, ring) in nested.rings.iter().enumerate() {
        assert_eq!(ring.depth, 99_999 - i);
        assert_eq!(ring.parent, (i < 99_999).then_some(i + 1));
    }
}

#[test]
fn rings_that_meet_have_no_nesting() {
    let mut pslg = Pslg::default();
    add_ring(&mut pslg, &square(0.0, 0.0, 2.0));
    add_ring(&mut pslg, &square(0.0, 0.0, 1.0));
    add_ring(&mut pslg, &square(1.0, 1.0, 1.5));
    let found = facts(&pslg);
    assert_eq!(found.rings.len(), 3);
    assert!(!found.are_rings_apart && found.rings.iter().all(|ring| ring.parent.is_none()));
    // A loose line across two rings that do not meet: their nesting is known all the same.
    pslg.segments.truncate(8);
    pslg.add_segment(8, 10);
    let found = facts(&pslg);
    assert!(!found.is_clean() && found.are_rings_apart);
    assert_eq!(found.rings[1].parent, Some(0));
    assert_eq!(found.rings[0].parent, None);
}

#[test]
fn touching_rings_and_open_lines_are_no_rings() {
    let mut pslg = Pslg::default();
    add_ring(&mut pslg, &[(0.0, 0.0), (2.0, -1.0), (2.0, 1.0)]);
    add_ring(&mut pslg, &[(0.0, 0.0), (-2.0, -1.0), (-2.0, 1.0)]);
    add_ring(&mut pslg, &[(5.0, 0.0), (6.0, 0.0), (6.0, 1.0), (5.0, 1.0)]);
    pslg.points.push(Point::new(9.0, 9.0));
    pslg.points.push(Point::new(9.0, 8.0));
    pslg.points.push(Point::new(7.0, 8.0));
    pslg.add_polyline([10, 11, 12]);
    let found = facts(&pslg);
    assert_eq!(found.rings.len(), 1);
    assert_eq!((found.rings[0].segment, found.rings[0].len), (6, 4));
}

#[test]
fn mistakes_are_named() {
    let mut pslg = Pslg::from_points([(0.0, 0.0), (1.0, f64::NAN)]);
    assert!(matches!(
        pslg.facts(1, &()),
        Err(Error::NotFinite { index: 1, .. })
    ));
    pslg.points[1].y = 1.0;
    pslg.add_segment(0, 1);
    pslg.add_segment(1, 2);
    let expected = Error::BadSegment {
        segment: 1,
        vertex: VertexId::new(2),
        points: 2,
    };
    assert_eq!(pslg.facts(1, &()), Err(expected));
}

struct Impatient;

impl Watch for Impatient {
    fn is_cancelled(&self) -> bool {
        true
    }
}

#[test]
fn a_watch_can_cancel() {
    let pslg = lattice(&mut Random::new(1), 9, 9, 9);
    assert_eq!(pslg.facts(1, &Impatient), Err(Error::Cancelled));
}

#[test]
fn facts_are_those_stated_of_the_corpus() {
    let Some(root) = corpus::root() else {
        println!("no corpus here");
        return;
    };
    let stated = corpus::facts(&root);
    let mut checked = 0;
    for (name, stated) in &stated {
        let Some(entry) = corpus::read(&root, name) else {
            continue;
        };
        let found = facts(&entry.pslg);
        let mut expected =
            [stated.crossings, stated.overlaps, stated.on_segments].map(|n| n as u64);
        if name == "earcut/water-huge2.json" {
            // The corpus leaves out the points of rings of fewer than three, which we keep, loose.
            let is_loose = |v| found.loose_points.first.binary_search(v).is_ok();
            let on = found.on_segments.first.iter();
            expected[2] += on.filter(|f| is_loose(&f.vertex)).count() as u64;
        }
        let [x, o] = [found.crossings.count, found.overlaps.count];
        let counts = [x, o, found.on_segments.count];
        assert_eq!(counts, expected, "{name}");
        checked += 1;
    }
    assert!(checked > 100, "{checked} files");
}

/// The table of nasty files also counts what is doubled.
#[test]
fn doubles_are_those_stated_of_nasty_files() {
    let Some(root) = corpus::root() else {
        println!("no corpus here");
        return;
    };
    let readme = std::fs::read_to_string(root.join("README.md")).expect("a README");
    let (_, table) = readme
        .split_once("## nasty/")
        .expect("a table of nasty files");
    let mut doubles = 0;
    for line in table.lines() {
        let cells: Vec<&str> = line.split('|').map(str::trim).collect();
        let Some(&[_, name, _, cell]) = cells.first_chunk() else {
            continue;
        };
        let name = format!("nasty/{name}");
        if !(name.ends_with(".poly") || name.ends_with(".node")) || name.contains("parser/") {
            continue;
        }
        let entry = corpus::read(&root, &name).expect("a nasty file");
        let found = facts(&entry.pslg);
        let stated = |what: &str| {
            let number = cell.split(", ").find_map(|fact| fact.strip_suffix(what));
            number.map_or(0, |n| n.trim().parse().expect("a number"))
        };
        assert_eq!(found.duplicates.count, stated("duplicate points"), "{name}");
        assert_eq!(
            found.zero_length.count,
            stated("zero-length segs"),
            "{name}"
        );
        assert_eq!(found.repeated.count, stated("repeated segs"), "{name}");
        assert_eq!(found.crossings.count, stated("crossings"), "{name}");
        assert_eq!(found.is_collinear, cell == "all collinear", "{name}");
        doubles += found.duplicates.count + found.zero_length.count + found.repeated.count;
    }
    assert!(doubles >= 7, "{doubles} doubles");
}

/// Boxes of long edges side by side all overlap: this took half a minute.
#[test]
fn many_nested_diamonds_take_no_time() {
    let rings = 20_000_u32;
    let mut drawing = Pslg::default();
    for i in 0..rings {
        let r = f64::from(i + 1);
        let corners = [(r, 0.0), (0.0, 0.4142 * r), (-r, 0.0), (0.0, -0.4142 * r)];
        drawing.points.extend(corners.map(Point::from));
        for k in 0..4 {
            drawing.add_segment(4 * i + k, 4 * i + (k + 1) % 4);
        }
    }
    let facts = drawing.facts(usize::MAX, &()).unwrap();
    assert!(facts.is_clean());
    assert!(facts.rings.iter().enumerate().all(|(i, ring)| {
        let around = rings as usize - 1 - i;
        ring.depth == around && ring.parent == (around > 0).then_some(i + 1)
    }));
}
