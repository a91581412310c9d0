//! One suite for every builder: whatever the algorithm and its order of work, a point set has one
//! triangulation.

use delone::delaunay::Incremental;
use delone::predicates::{Orientation, orient2d};
use delone::{Delaunay, Duplicate, Error, Point, Triangulation, VertexId, check};
use delone_testkit::generate::{Kind, Random, scaled};
use delone_testkit::naive::{distinct, naive_delaunay, sorted_triangles};
use proptest::prelude::*;
use std::collections::HashMap;

type Builder = (&'static str, fn(&[Point]) -> Triangulation);

const BUILDERS: &[Builder] = &[
    ("divide and conquer", |points| bulk(points, 1)),
    ("divide and conquer, 3 threads", |points| bulk(points, 3)),
    ("incremental", in_given_order),
    ("incremental, backwards", backwards),
    ("incremental, sorted", sorted),
    ("incremental, shuffled", shuffled),
];

fn bulk(points: &[Point], threads: usize) -> Triangulation {
    let result = Delaunay::new()
        .threads(threads)
        .triangulate(points.iter().copied());
    result.expect("finite points")
}

fn in_given_order(points: &[Point]) -> Triangulation {
    let mut growing = Incremental::new();
    for &p in points {
        growing.insert(p).expect("finite points");
    }
    growing.finish()
}

fn in_order(points: &[Point], order: &[usize]) -> Triangulation {
    Incremental::triangulate_in_order(points, order).expect("finite points")
}

fn backwards(points: &[Point]) -> Triangulation {
    in_order(points, &(0..points.len()).rev().collect::<Vec<_>>())
}

fn sorted(points: &[Point]) -> Triangulation {
    let mut order: Vec<_> = (0..points.len()).collect();
    order.sort_by(|&i, &j| points[i].lex_cmp(&points[j]));
    in_order(points, &order)
}

fn shuffled(points: &[Point]) -> Triangulation {
    in_order(points, &Random::new(7).permutation(points.len()))
}

/// Calls `test` with the result of every builder.
fn each_builder(points: &[Point], test: impl Fn(&Triangulation)) {
    for (name, build) in BUILDERS {
        let run = || test(&build(points));
        if let Err(panic) = std::panic::catch_unwind(std::panic::AssertUnwindSafe(run)) {
            eprintln!("builder: {name}; points: {points:?}");
            std::panic::resume_unwind(panic);
        }
    }
}

/// Everything that must hold for the triangulation of any points.
fn assert_sound(t: &Triangulation, points: &[Point]) {
    assert_eq!(t.points(), points);
    t.mesh().validate().expect("a closed sphere");
    assert_eq!(t.duplicates(), expected_duplicates(points));
    assert_counts(t);
    assert_ghosts_last(t);
    for corners in t.triangles() {
        let [a, b, c] = corners.map(|v| t.point(v));
        assert_eq!(orient2d(a, b, c), Orientation::Left, "{corners:?}");
    }
    assert_hull_is_convex(t);
}

fn expected_duplicates(points: &[Point]) -> Vec<Duplicate> {
    let key = |p: &Point| [p.x + 0.0, p.y + 0.0].map(f64::to_bits);
    let mut first = HashMap::new();
    let mut duplicates = Vec::new();
    for (i, p) in points.iter().enumerate() {
        let dropped = VertexId::new(i);
        let kept = *first.entry(key(p)).or_insert(dropped);
        if kept != dropped {
            duplicates.push(Duplicate { dropped, kept });
        }
    }
    duplicates
}

/// Euler: n vertices on a sphere with infinity have 2n − 2 faces; each vertex is in use.
fn assert_counts(t: &Triangulation) {
    let n = t.num_vertices();
    let faces = if n < 2 { 0 } else { 2 * n - 2 };
    assert_eq!(t.mesh().num_faces(), faces);
    assert_eq!(t.edges().count(), t.num_edges());
    assert_eq!(
        t.num_edges(),
        if n == 0 { 0 } else { n - 1 + t.num_triangles() }
    );
    let mut used = vec![false; t.points().len()];
    for v in t.mesh().faces().as_flattened() {
        if !v.is_infinite() {
            used[v.index()] = true;
        }
    }
    let in_use = used.iter().filter(|&&used| used).count();
    assert_eq!(in_use, if n < 2 { 0 } else { n });
}

fn assert_ghosts_last(t: &Triangulation) {
    for (i, corners) in t.mesh().faces().iter().enumerate() {
        let is_ghost = corners.iter().any(|v| v.is_infinite());
        assert_eq!(is_ghost, i >= t.num_triangles());
    }
}

/// Never a turn to the right around the hull, and no point outside any of its edges.
fn assert_hull_is_convex(t: &Triangulation) {
    let hull: Vec<_> = t.hull().map(|v| t.point(v)).collect();
    assert_eq!(hull.len(), t.mesh().num_faces() - t.num_triangles());
    for (i, &a) in hull.iter().enumerate() {
        let b = hull[(i + 1) % hull.len()];
        let outside = |&&p: &&Point| orient2d(a, b, p) == Orientation::Right;
        if t.num_triangles() > 0 {
            assert_eq!(t.points().iter().find(outside), None, "outside {a:?} {b:?}");
        } else {
            let off = |&&p: &&Point| orient2d(a, b, p) != Orientation::Collinear;
            assert_eq!(t.points().iter().find(off), None, "off {a:?} {b:?}");
        }
    }
}

/// All builders are sound on `points` and agree with the naive oracle.
fn assert_canonical(points: &[Point]) {
    let expected = naive_delaunay(points);
    each_builder(points, |t| {
        assert_sound(t, points);
        assert_eq!(sorted_triangles(t), expected);
    });
}

/// All builders are sound on `points` and agree with the first one: for sets too large for the
/// naive oracle.
fn assert_agree(points: &[Point]) {
    let first = BUILDERS[0].1(points);
    let (triangles, hash) = (sorted_triangles(&first), first.hash());
    each_builder(points, |t| {
        assert_sound(t, points);
        assert_eq!(t.hash(), hash);
        assert_eq!(sorted_triangles(t), triangles);
    });
}

fn points<const N: usize>(coordinates: [(f64, f64); N]) -> Vec<Point> {
    coordinates.map(Point::from).to_vec()
}

#[test]
fn few_and_equal_points() {
    assert_canonical(&[]);
    for n in 1..5 {
        assert_canonical(&vec![Point::new(2.5, -1.0); n]);
    }
    assert_canonical(&points([(0.0, 0.0), (-0.0, 0.0), (0.0, -0.0), (1.0, 0.0)]));
    assert_canonical(&points([(0.0, 0.0), (0.0, f64::from_bits(1))]));
    assert_canonical(&points([(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)]));
    assert_canonical(&points([(0.0, 0.0), (0.0, 1.0), (1.0, 0.0)]));
}

#[test]
fn rows_in_every_direction() {
    for (dx, dy) in [(1.0, 0.0), (0.0, 1.0), (1.0, 1.0), (-2.0, 1.0), (3.0, -7.0)] {
        for n in 2..9 {
            let row: Vec<_> = (0..n)
                .map(|i| Point::new(f64::from(i) * dx, f64::from(i) * dy))
                .collect();
            assert_canonical(&row);
            let mut lifted = row.clone();
            lifted.push(Point::new(-dy, dx));
            assert_canonical(&lifted);
            lifted.push(Point::new(dy, -dx));
            assert_canonical(&lifted);
        }
    }
}

#[test]
fn all_subsets_of_a_small_lattice() {
    let lattice: Vec<_> = (0..9)
        .map(|i| Point::new(f64::from(i % 3), f64::from(i / 3)))
        .collect();
    for subset in 0..1 << 9 {
        let chosen = lattice
            .iter()
            .enumerate()
            .filter(|(i, _)| subset >> i & 1 == 1);
        assert_canonical(&chosen.map(|(_, &p)| p).collect::<Vec<_>>());
    }
}

#[test]
fn every_kind_small() {
    for kind in Kind::ALL {
        for seed in 0..20 {
            assert_canonical(&kind.points(1 + seed as usize % 12, seed));
        }
    }
}

#[test]
fn every_kind_larger() {
    for kind in Kind::ALL {
        assert_agree(&kind.points(150, 1));
    }
}

/// Large enough for many tasks in the bulk builder: not only the triangles, but also their order and
/// that of their corners must not depend on the number of threads.
#[test]
fn threads_do_not_change_a_bit() {
    for kind in [Kind::Uniform, Kind::Lattice { side: 200 }, Kind::Clusters] {
        let points = kind.points(60_000, 2);
        let one = bulk(&points, 1);
        one.mesh().validate().expect("a closed sphere");
        let mut shuffled = points.clone();
        Random::new(5).shuffle(&mut shuffled);
        assert_eq!(bulk(&shuffled, 2).hash(), one.hash(), "{kind:?} shuffled");
        for threads in [2, 4, 7] {
            let many = bulk(&points, threads);
            assert!(many.mesh() == one.mesh(), "{kind:?} on {threads} threads");
            assert_eq!(many.duplicates(), one.duplicates());
        }
    }
}

/// Large sets that take the bulk builder's rare paths: groups of equal keys larger than a task, a hull
/// of all points, and rows.
#[test]
fn rare_paths_on_large_sets() {
    let n = 20_000;
    let mix = |i: u32| f64::from(i.wrapping_mul(2_654_435_761)) / f64::from(u32::MAX);
    let uniform = (0..n).map(|i| Point::new(mix(i), mix(i ^ 0x5555)));
    let equal = (0..n).map(|_| Point::new(0.25, 0.5));
    let outlier = std::iter::once(Point::new(1e9, -1e9));
    let sets: [(&str, Vec<Point>); 6] = [
        ("all equal", equal.clone().collect()),
        ("half equal", equal.chain(uniform.clone()).collect()),
        ("a far outlier", uniform.clone().chain(outlier).collect()),
        (
            "a far pile",
            uniform
                .map(|p| Point::new(p.x * 1e-30, p.y))
                .chain((0..n).map(|_| Point::new(1e9, 1e9)))
                .collect(),
        ),
        (
            "a row",
            (0..n).map(|i| Point::new(f64::from(i), 3.0)).collect(),
        ),
        (
            "two rows",
            (0..n)
                .map(|i| Point::new(f64::from(i), f64::from(i % 2) * 1e-3))
                .collect(),
        ),
    ];
    for (name, points) in sets {
        let one = bulk(&points, 1);
        one.mesh()
            .validate()
            .unwrap_or_else(|e| panic!("{name}: {e}"));
        check::verify(&points, one.triangles(), &())
            .unwrap()
            .into_result()
            .unwrap_or_else(|e| panic!("{name}: {e}"));
        assert!(bulk(&points, 3).mesh() == one.mesh(), "{name}");
    }
}

/// Halving coordinates against overflow must not make different ones equal.
#[test]
fn subnormal_steps_beside_huge_coordinates() {
    for (a, b) in [(0.0, 5e-324), (1.5e-323, 2e-323)] {
        let row: Vec<_> = (0..14)
            .map(|i| Point::new(1e305, if i < 7 { a } else { b }))
            .collect();
        assert_agree(&row);
        let mut turned: Vec<_> = row.iter().map(|p| Point::new(p.y, -p.x)).collect();
        turned.push(Point::new(1.0, 1.0));
        assert_agree(&turned);
    }
}

/// Nearly cocircular points so small that a filter without a guard underflows, beside one large enough for
/// the largest coordinate to need no scaling.
#[test]
fn tiny_circles_beside_a_coordinate_at_the_border_of_the_class() {
    for seed in 0..300 {
        // At this size the underflow of an unguarded filter is wrong in one set of five.
        let lattice = Kind::UlpLattice.points(6 + seed as usize % 7, seed);
        let mut points: Vec<_> = lattice
            .iter()
            .map(|p| Point::new(scaled(p.x, -269), scaled(p.y, -269)))
            .collect();
        points.push(Point::new(2f64.powi(249), 0.0));
        assert_agree(&points);
    }
}

/// The depth of the recursion must not grow with the range of the exponents.
#[test]
fn all_exponents_fit_a_small_stack() {
    let ladder = || (-1074..1024).map(|e| 2f64.powi(e / 2) * 2f64.powi(e - e / 2));
    let mut points: Vec<_> = ladder()
        .flat_map(|c| [Point::new(c, 0.0), Point::new(0.0, c)])
        .collect();
    points.extend(
        (0..20_000).map(|i| Point::new(f64::from(i % 150) * 5e-324, f64::from(i / 150) * 5e-324)),
    );
    let small = std::thread::Builder::new().stack_size(1 << 20);
    let hash = |points: &[Point]| {
        let t = bulk(points, 1);
        check::verify(points, t.triangles(), &())
            .unwrap()
            .into_result()
            .unwrap()
            .hash
    };
    small
        .spawn(move || hash(&points))
        .unwrap()
        .join()
        .expect("no overflow, and the right triangles");
}

/// Deep recursion in the bulk builder, against the incremental one.
#[test]
fn hashes_agree_on_large_sets() {
    for kind in [Kind::Uniform, Kind::Lattice { side: 60 }, Kind::Clusters] {
        let points = kind.points(5000, 2);
        let hash = in_given_order(&points).hash();
        for threads in [1, 2, 4, 7] {
            let t = bulk(&points, threads);
            t.mesh().validate().expect("a closed sphere");
            assert_eq!(t.hash(), hash, "{kind:?} on {threads} threads");
        }
    }
}

#[test]
fn grids() {
    for side in [4, 11] {
        let grid: Vec<_> = (0..side * side)
            .map(|i| Point::new(f64::from(i % side), f64::from(i / side)))
            .collect();
        assert_agree(&grid);
        each_builder(&grid, |t| {
            let cells = (side as usize - 1).pow(2);
            assert_eq!(t.num_triangles(), 2 * cells);
            assert_eq!(t.num_hull_edges(), 4 * (side as usize - 1));
        });
    }
}

#[test]
fn order_of_the_input_does_not_matter() {
    for kind in Kind::ALL {
        let points = kind.points(40, 3);
        let hash = BUILDERS[0].1(&points).hash();
        let mut other = points.clone();
        Random::new(5).shuffle(&mut other);
        each_builder(&other, |t| assert_eq!(t.hash(), hash));
    }
}

#[test]
fn scaling_by_powers_of_two_does_not_matter() {
    for kind in [
        Kind::Lattice { side: 5 },
        Kind::CocircularRings,
        Kind::Uniform,
    ] {
        let points = kind.points(25, 11);
        let expected = sorted_triangles(&BUILDERS[0].1(&points));
        for exponent in [-900, -200, -3, 1, 200, 1000] {
            let scale = |p: &Point| Point::new(scaled(p.x, exponent), scaled(p.y, exponent));
            let scaled_points: Vec<_> = points.iter().map(scale).collect();
            each_builder(&scaled_points, |t| {
                assert_eq!(sorted_triangles(t), expected)
            });
        }
    }
}

#[test]
fn not_finite_is_refused_with_its_index() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let points = points([(0.0, 0.0), (1.0, 0.0), (2.0, bad), (bad, 0.0)]);
        for result in [
            delone::triangulate(points.iter().copied()),
            Incremental::triangulate_in_order(&points, &[3, 2, 1, 0]),
        ] {
            let error = result.expect_err("not finite");
            assert!(
                matches!(error, Error::NotFinite { index: 2, .. }),
                "{error}"
            );
        }
    }
}

fn small_lattice(side: i32, n: usize) -> impl Strategy<Value = Vec<Point>> {
    let coordinate = move || (0..side).prop_map(f64::from);
    let point = (coordinate(), coordinate()).prop_map(Point::from);
    prop::collection::vec(point, 0..n)
}

fn any_floats(n: usize) -> impl Strategy<Value = Vec<Point>> {
    let coordinate = || {
        prop_oneof![
            prop::num::f64::NORMAL | prop::num::f64::SUBNORMAL | prop::num::f64::ZERO,
            -1.0..1.0f64,
            (-3i32..4).prop_map(f64::from),
        ]
    };
    let point = (coordinate(), coordinate()).prop_map(Point::from);
    prop::collection::vec(point, 0..n)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(150))]

    #[test]
    fn canonical_on_small_lattices(points in small_lattice(4, 11)) {
        assert_canonical(&points);
    }

    #[test]
    fn canonical_on_larger_lattices(points in small_lattice(9, 14)) {
        assert_canonical(&points);
    }

    #[test]
    fn canonical_on_any_floats(points in any_floats(10)) {
        assert_canonical(&points);
    }

    #[test]
    fn points_without_duplicates_are_all_vertices(points in small_lattice(6, 30)) {
        let first = distinct(&points);
        each_builder(&points, |t| assert_eq!(t.num_vertices(), first.len()));
    }
}
