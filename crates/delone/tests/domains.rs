//! Domains: whatever is drawn, in whatever order, there is one constrained triangulation.
//!
//! Every result is held against what must be true of it (`testkit::domains`), tiny ones against the
//! definitions too.

use delone::{
    ConstrainedTriangulation, DomainRule, Error, Origin, Point, Pslg, Region, Seed, SegmentPolicy,
    TriangulationHash, VertexId, Warning, hash_triangles,
};
use delone_testkit::domains::{Domain, check_canonical, check_naive, check_sound};
use delone_testkit::fuzz::Case;
use delone_testkit::fuzz::segments::{case, check};
use delone_testkit::generate::{Kind, Random, scaled};

const RULES: [DomainRule; 3] = [DomainRule::Hull, DomainRule::Carve, DomainRule::EvenOdd];

/// Builds with crossings split.
fn split(pslg: &Pslg, rule: DomainRule) -> ConstrainedTriangulation {
    let domain = Domain {
        pslg: pslg.clone(),
        crossings: SegmentPolicy::Split,
        rule,
    };
    domain.triangulate(2).expect("a result")
}

/// Builds under every rule; the results must be sound, canonical and, if `is_tiny`, by the book.
fn assert_right(pslg: &Pslg, is_tiny: bool) {
    for rule in RULES {
        let domain = Domain {
            pslg: pslg.clone(),
            crossings: SegmentPolicy::Split,
            rule,
        };
        let t = domain.triangulate(1).expect("a result");
        let outcome = check_sound(pslg, &t)
            .and_then(|()| check_canonical(&domain, &t, 3, &mut Random::new(1)))
            .and_then(|()| {
                if is_tiny {
                    check_naive(&domain, &t)
                } else {
                    Ok(())
                }
            });
        if let Err(reason) = outcome {
            panic!(
                "{reason}\n{}",
                if is_tiny {
                    domain.as_source()
                } else {
                    String::new()
                }
            );
        }
    }
}

/// Joins `m` random pairs of the points.
fn joined(points: Vec<Point>, m: usize, random: &mut Random) -> Pslg {
    let n = points.len();
    let mut pslg = Pslg::from_points(points);
    pslg.segments = (0..m)
        .map(|_| [0; 2].map(|_| VertexId::new(random.below(n))))
        .collect();
    pslg
}

/// Draws `m` segments whose ends are at most `length` apart in each coordinate.
fn sprinkled(m: usize, length: f64, random: &mut Random) -> Pslg {
    let mut pslg = Pslg::default();
    for _ in 0..m {
        let [x, y] = [random.unit(), random.unit()];
        let mut near = |c: f64| c + length * (2.0 * random.unit() - 1.0);
        let end = Point::new(near(x), near(y));
        let first = pslg.points.len() as u32;
        pslg.points.extend([Point::new(x, y), end]);
        pslg.add_segment(first, first + 1);
    }
    pslg
}

fn drawn(points: &[(f64, f64)], segments: &[[u32; 2]]) -> Pslg {
    let mut pslg = Pslg::from_points(points.iter().copied());
    pslg.segments = segments.iter().map(|s| s.map(VertexId::from)).collect();
    pslg
}

/// Adds the square around `centre` with this half side.
fn add_square(pslg: &mut Pslg, centre: (f64, f64), half: f64) {
    let first = pslg.points.len() as u32;
    let corners = [(-half, -half), (half, -half), (half, half), (-half, half)];
    pslg.points
        .extend(corners.map(|(x, y)| Point::new(centre.0 + x, centre.1 + y)));
    pslg.add_ring(first..first + 4);
}

fn squares(halves: &[f64]) -> Pslg {
    let mut pslg = Pslg::default();
    halves
        .iter()
        .for_each(|&half| add_square(&mut pslg, (0.0, 0.0), half));
    pslg
}

fn chain(t: &ConstrainedTriangulation, segment: usize) -> Vec<u32> {
    t.chain(segment).iter().map(|v| v.raw()).collect()
}

fn count(pslg: &Pslg, rule: DomainRule) -> usize {
    split(pslg, rule).triangulation().num_triangles()
}

// Against the definitions.

#[test]
fn tiny_domains_of_every_kind_are_by_the_book() {
    for kind in Kind::ALL {
        for seed in 0..12 {
            let mut random = Random::new(seed);
            let pslg = joined(kind.points(7, seed), 5, &mut random);
            assert_right(&pslg, true);
        }
    }
}

#[test]
fn rings_lines_holes_and_regions_are_by_the_book() {
    let mut domain = Domain::default();
    for seed in 0..3000 {
        case(seed, 9, 7, &mut domain);
        let outcome = check(&domain, true, seed);
        assert_eq!(outcome, Ok(()), "{}", domain.as_source());
    }
}

#[test]
fn no_points_one_and_two() {
    for points in [&[][..], &[(1.0, 2.0)], &[(1.0, 2.0), (3.0, 2.0)]] {
        let mut pslg = Pslg::from_points(points.iter().copied());
        assert_right(&pslg, true);
        let last = points.len().saturating_sub(1) as u32;
        if !points.is_empty() {
            pslg.add_segment(0, last);
            pslg.add_segment(last, 0);
            let middle = if last == 0 { 1 } else { 2 };
            pslg.polygons = vec![0..middle, middle..2];
            pslg.holes = vec![Point::new(9.0, 9.0)];
            assert_right(&pslg, true);
        }
    }
}

// Many segments.

#[test]
fn thousands_of_crossing_segments() {
    let mut random = Random::new(3);
    let pslg = sprinkled(3000, 0.05, &mut random);
    assert!(split(&pslg, DomainRule::Hull).num_crossings() > 2000);
    assert_right(&pslg, false);
    let long = sprinkled(150, 1.0, &mut random);
    assert!(split(&long, DomainRule::Hull).num_crossings() > 1000);
    assert_right(&long, false);
}

#[test]
fn segments_on_lattices_tilted_and_far_away() {
    for seed in 0..20 {
        let mut random = Random::new(seed);
        let (sin, cos) = (random.unit() * 6.0).sin_cos();
        let tilted = |p: Point| Point::new(cos * p.x - sin * p.y, sin * p.x + cos * p.y);
        let on_map = |p: Point| Point::new(p.x * 0.1 + 500_000.1, p.y * 0.1 + 5_400_000.2);
        let lattice = Kind::Lattice { side: 8 }.points(60, seed);
        let places: [&dyn Fn(Point) -> Point; 4] =
            [&|p| p, &tilted, &on_map, &|p| on_map(tilted(p))];
        for place in places {
            let points = lattice.iter().map(|&p| place(p)).collect();
            assert_right(&joined(points, 40, &mut random), false);
        }
    }
}

#[test]
fn segments_that_cross_within_an_ulp() {
    for seed in 0..40 {
        let mut random = Random::new(seed);
        let points = Kind::UlpLattice.points(24, seed);
        assert_right(&joined(points, 16, &mut random), false);
        // Nearly parallel: all from near one place to near another.
        let near =
            |c: f64, random: &mut Random| f64::from_bits(c.to_bits() + random.below(6) as u64);
        let ends = (0..20).map(|i| {
            let [x, y] = if i % 2 == 0 {
                [1.0, 1.0]
            } else {
                [1000.3, 700.1]
            };
            Point::new(near(x, &mut random), near(y, &mut random))
        });
        let mut bundle = Pslg::from_points(ends.collect::<Vec<_>>());
        (0..10).for_each(|i| bundle.add_segment(2 * i, 2 * i + 1));
        assert_right(&bundle, false);
    }
}

// What does not depend on how the plane is turned or scaled.

/// The hash of the triangles when each of their corners is mapped.
fn mapped_hash(t: &ConstrainedTriangulation, map: impl Fn(Point) -> Point) -> TriangulationHash {
    let t = t.triangulation();
    let corners = t.triangles().iter().map(|c| c.map(|v| map(t.point(v))));
    hash_triangles(corners)
}

fn mapped(pslg: &Pslg, map: impl Fn(Point) -> Point) -> Pslg {
    let mut pslg = pslg.clone();
    pslg.points.iter_mut().for_each(|p| *p = map(*p));
    pslg.holes.iter_mut().for_each(|p| *p = map(*p));
    pslg
}

#[test]
fn a_quarter_turn_turns_the_triangles_where_nothing_is_cocircular() {
    for seed in 0..30 {
        let mut random = Random::new(seed);
        let pslg = joined(Kind::Uniform.points(40, seed), 20, &mut random);
        let turned = mapped(&pslg, |p| Point::new(-p.y, p.x));
        for rule in RULES {
            let expected = split(&pslg, rule).triangulation().hash();
            let back = mapped_hash(&split(&turned, rule), |p| Point::new(p.y, -p.x));
            assert_eq!(back, expected, "seed {seed}, {rule:?}");
        }
    }
}

#[test]
fn powers_of_two_scale_the_triangles() {
    for seed in 0..30 {
        let mut random = Random::new(seed);
        let kind = random.choose(&[Kind::Uniform, Kind::Lattice { side: 6 }, Kind::UlpLattice]);
        let pslg = joined(kind.points(30, seed), 14, &mut random);
        for exponent in [-700, -60, 40, 800] {
            let times = |p: Point, e| Point::new(scaled(p.x, e), scaled(p.y, e));
            let other = mapped(&pslg, |p| times(p, exponent));
            for rule in RULES {
                let expected = split(&pslg, rule).triangulation().hash();
                let back = mapped_hash(&split(&other, rule), |p| times(p, -exponent));
                assert_eq!(back, expected, "seed {seed}, 2^{exponent}, {rule:?}");
            }
        }
    }
}

// How segments meet.

#[test]
fn t_junctions_and_overlaps_are_no_errors() {
    let line = [
        (0.0, 0.0),
        (4.0, 0.0),
        (8.0, 0.0),
        (4.0, 5.0),
        (2.0, -3.0),
        (6.0, 0.0),
    ];
    let pslg = drawn(&line, &[[0, 2], [3, 1], [5, 1], [1, 0], [4, 3], [2, 0]]);
    let mut domain = Domain {
        pslg,
        ..Domain::default()
    };
    // The segment from 4 to 3 crosses the long one in no vertex.
    let error = domain.triangulate(1).expect_err("a crossing");
    let Error::Crossing { segments, at } = error else {
        panic!("{error}");
    };
    assert_eq!((segments, at), ([0, 4], Point::new(2.75, 0.0)));
    domain.pslg.segments.remove(4);
    let t = domain.triangulate(1).expect("no crossing");
    let chains: Vec<_> = (0..5).map(|s| chain(&t, s)).collect();
    let expected = [
        vec![0, 1, 5, 2],
        vec![3, 1],
        vec![5, 1],
        vec![1, 0],
        vec![2, 5, 1, 0],
    ];
    assert_eq!(chains, expected);
    assert_right(&domain.pslg, true);
}

#[test]
fn a_crossing_knows_its_segments_and_both_chains_pass_it() {
    let mut pslg = squares(&[4.0]);
    pslg.add_segment(0, 2);
    pslg.add_segment(3, 1);
    let t = split(&pslg, DomainRule::Carve);
    assert_eq!(t.num_crossings(), 1);
    let crossing = VertexId::new(4);
    assert_eq!(t.origin(crossing), Origin::Crossing([4, 5]));
    assert_eq!(t.origin(VertexId::new(3)), Origin::Input(VertexId::new(3)));
    assert_eq!(t.triangulation().point(crossing), Point::default());
    assert_eq!([chain(&t, 4), chain(&t, 5)], [vec![0, 4, 2], vec![3, 4, 1]]);
    assert_eq!(t.triangulation().num_triangles(), 4);
}

#[test]
fn segments_that_cross_in_a_vertex_do_not_cross() {
    let mut pslg = squares(&[4.0]);
    pslg.add_segment(0, 2);
    pslg.add_segment(3, 1);
    pslg.points.push(Point::default());
    let domain = Domain {
        pslg,
        ..Domain::default()
    };
    let t = domain.triangulate(1).expect("no crossing");
    assert_eq!([chain(&t, 4), chain(&t, 5)], [vec![0, 4, 2], vec![3, 4, 1]]);
}

#[test]
fn equal_points_and_segments_without_length() {
    let pslg = drawn(
        &[(0.0, 0.0), (4.0, 0.0), (0.0, -0.0), (0.0, 4.0), (4.0, 0.0)],
        &[[2, 4], [0, 2], [3, 3], [1, 3], [3, 0], [4, 2]],
    );
    let t = split(&pslg, DomainRule::Carve);
    let chains: Vec<_> = (0..6).map(|s| chain(&t, s)).collect();
    let expected = [
        vec![0, 1],
        vec![0],
        vec![3],
        vec![1, 3],
        vec![3, 0],
        vec![1, 0],
    ];
    assert_eq!(chains, expected);
    assert_eq!(t.constrained_edges().count(), 3);
    assert_right(&pslg, true);
}

// What belongs to the domain.

#[test]
fn rings_in_rings_are_holes_and_islands() {
    let mut pslg = squares(&[8.0, 6.0, 4.0, 2.0]);
    pslg.points.push(Point::new(20.0, 0.0));
    let counts = RULES.map(|rule| count(&pslg, rule));
    assert_eq!(counts, [27, 26, 16]);
    assert_right(&pslg, true);
    // Each ring a polygon of its own: their union.
    pslg.polygons = (0..4).map(|i| 4 * i..4 * i + 4).collect();
    assert_eq!(count(&pslg, DomainRule::EvenOdd), 26);
    // The outer two one polygon, the third another that lies in its hole.
    pslg.polygons = vec![0..8, 8..12];
    assert_eq!(count(&pslg, DomainRule::EvenOdd), 8 + 8 + 2);
    assert_right(&pslg, true);
}

#[test]
fn several_components_touch_overlap_and_share_borders() {
    let mut pslg = Pslg::default();
    add_square(&mut pslg, (0.0, 0.0), 2.0);
    add_square(&mut pslg, (4.0, 0.0), 2.0);
    add_square(&mut pslg, (20.0, 0.0), 2.0);
    add_square(&mut pslg, (24.0, 4.0), 2.0);
    add_square(&mut pslg, (40.0, 0.0), 2.0);
    add_square(&mut pslg, (41.0, 1.0), 2.0);
    assert_right(&pslg, false);
    // The shared border counts twice, so both sides of it are inside; the overlap is outside.
    let t = split(&pslg, DomainRule::EvenOdd);
    assert_eq!(t.num_crossings(), 2);
    let overlap = count(&pslg, DomainRule::Carve) - t.triangulation().num_triangles();
    assert_eq!(overlap, 2);
    pslg.polygons = (0..6).map(|i| 4 * i..4 * i + 4).collect();
    assert_eq!(
        split(&pslg, DomainRule::EvenOdd).triangulation().hash(),
        split(&pslg, DomainRule::Carve).triangulation().hash()
    );
}

#[test]
fn open_lines_enclose_nothing_and_are_kept_as_edges() {
    let mut pslg = squares(&[4.0]);
    pslg.segments.pop();
    pslg.add_polyline([0u32, 2]);
    let t = split(&pslg, DomainRule::Carve);
    assert_eq!(t.triangulation().num_triangles(), 1);
    pslg.segments = vec![[0, 1], [1, 2], [2, 3]]
        .into_iter()
        .map(|s: [u32; 2]| s.map(VertexId::from))
        .collect();
    let t = split(&pslg, DomainRule::Carve);
    assert_eq!(t.triangulation().num_triangles(), 0);
    assert_eq!(t.warnings(), [Warning::Empty]);
    assert_eq!(t.triangulation().points().len(), 4);
    assert_right(&pslg, true);
    // Inside of a ring an open line is an edge that carves nothing.
    let mut pslg = squares(&[4.0]);
    pslg.points
        .extend([(-1.0, 0.0), (1.0, 0.5)].map(Point::from));
    pslg.add_segment(4, 5);
    assert_eq!(count(&pslg, DomainRule::Carve), 6);
    assert_right(&pslg, true);
}

#[test]
fn holes_carve_up_to_segments_under_every_rule() {
    let mut pslg = squares(&[4.0, 2.0]);
    pslg.holes = vec![Point::new(0.5, 0.25)];
    assert_eq!(RULES.map(|rule| count(&pslg, rule)), [8, 8, 8]);
    pslg.holes = vec![Point::new(3.0, 0.5)];
    assert_eq!(RULES.map(|rule| count(&pslg, rule)), [2, 2, 0]);
    // The corners of the hull are carved by a hole, since no segment keeps them.
    let open = Pslg {
        points: pslg.points.clone(),
        holes: pslg.holes.clone(),
        ..Pslg::default()
    };
    assert_eq!(RULES.map(|rule| count(&open, rule)), [0, 0, 0]);
    assert_right(&pslg, true);
}

#[test]
fn a_hole_on_a_segment_is_an_error_that_names_both() {
    let mut pslg = squares(&[4.0, 2.0]);
    let at = Point::new(2.0, 1.0);
    pslg.holes = vec![Point::default(), at];
    for rule in RULES {
        let domain = Domain {
            pslg: pslg.clone(),
            rule,
            ..Domain::default()
        };
        let expected = Error::SeedOnSegment {
            seed: Seed::Hole(1),
            at,
            segment: 5,
        };
        assert_eq!(domain.triangulate(1).expect_err("a bad seed"), expected);
    }
}

#[test]
fn what_lies_outside_is_worth_a_word() {
    let region = |x: f64, y: f64| Region {
        at: Point::new(x, y),
        attribute: x,
        max_area: Some(0.5),
    };
    let mut pslg = squares(&[4.0, 2.0]);
    let far = Point::new(50.0, 0.0);
    pslg.holes = vec![far];
    pslg.regions = vec![
        region(3.0, 0.5),
        region(0.0, 0.5),
        region(-3.0, 0.5),
        region(9.0, 0.5),
    ];
    let t = split(&pslg, DomainRule::Carve);
    let expected = [
        Warning::HoleOutside { hole: 0, at: far },
        Warning::RegionTwice {
            region: 2,
            first: 0,
        },
        Warning::RegionOutside {
            region: 3,
            at: Point::new(9.0, 0.5),
        },
    ];
    assert_eq!(t.warnings(), expected);
    assert_eq!(t.regions(), pslg.regions);
    let regions = t.triangulation().mesh().triangles();
    let inner = regions
        .filter(|&triangle| t.region(triangle) == Some(1))
        .count();
    assert_eq!(inner, 2);
    assert_right(&pslg, true);
}

// What is refused.

#[test]
fn errors_name_the_culprit() {
    let refuse = |pslg: Pslg, rule| {
        let domain = Domain {
            pslg,
            rule,
            ..Domain::default()
        };
        domain.triangulate(1).expect_err("an error")
    };
    let mut pslg = squares(&[4.0]);
    pslg.points[2].y = f64::NAN;
    assert!(matches!(
        refuse(pslg, DomainRule::Hull),
        Error::NotFinite { index: 2, .. }
    ));
    let mut pslg = squares(&[4.0]);
    pslg.add_segment(1, 4);
    let bad = refuse(pslg, DomainRule::Hull);
    assert!(matches!(
        bad,
        Error::BadSegment {
            segment: 4,
            points: 4,
            ..
        }
    ));
    let mut pslg = squares(&[4.0]);
    pslg.polygons = vec![0..4, 2..9];
    let bad = refuse(pslg, DomainRule::EvenOdd);
    assert!(matches!(bad, Error::BadPolygon { polygon: 1, .. }));
    let mut pslg = squares(&[4.0]);
    pslg.polygons = vec![0..4, 1..4];
    let shared = refuse(pslg.clone(), DomainRule::EvenOdd);
    let expected = Error::SharedSegment {
        polygons: [0, 1],
        segment: 1,
    };
    assert_eq!(shared, expected);
    pslg.polygons = vec![0..0, 1..4];
    let open = refuse(pslg, DomainRule::EvenOdd);
    assert!(matches!(open, Error::OpenPolygon { polygon: 1, .. }));
    let mut pslg = squares(&[4.0]);
    pslg.holes = vec![Point::new(0.0, f64::INFINITY)];
    let seed = refuse(pslg, DomainRule::Hull);
    assert!(matches!(
        seed,
        Error::SeedNotFinite {
            seed: Seed::Hole(0),
            ..
        }
    ));
}

#[test]
fn the_first_crossing_is_named_in_the_order_of_the_segments() {
    for seed in 0..200 {
        let mut random = Random::new(seed);
        let pslg = joined(Kind::Lattice { side: 5 }.points(10, seed), 12, &mut random);
        let domain = Domain {
            pslg,
            ..Domain::default()
        };
        // The check compares with the first pair that crosses by the definition.
        assert_eq!(
            check(&domain, false, seed),
            Ok(()),
            "{}",
            domain.as_source()
        );
    }
}
