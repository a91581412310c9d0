//! The Voronoi diagram and its clipping, against half-planes intersected one by one.

use delone::predicates::{CircleSide, Orientation, circumcenter, in_circle, orient2d};
use delone::voronoi::{Clipped, Domain, Line, Lloyd, Voronoi};
use delone::{ConstrainedDelaunay, Error, Phase, Point, Pslg, VertexId, Watch};
use delone_testkit::generate::{Kind, Random};

fn voronoi(points: &[Point]) -> Voronoi {
    let t = delone::triangulate(points.iter().copied()).expect("finite points");
    Voronoi::new(&t, &()).expect("nobody cancels")
}

fn lattice(n: usize, size: usize, random: &mut Random) -> Vec<Point> {
    let coordinate = |random: &mut Random| random.below(size) as f64;
    (0..n)
        .map(|_| Point::new(coordinate(random), coordinate(random)))
        .collect()
}

/// A ring around (cx, cy), which may cross itself if `is_wild`.
fn ring(corners: usize, size: usize, random: &mut Random) -> Pslg {
    let mut pslg = Pslg::from_points(lattice(corners, size, random));
    pslg.add_ring((0..corners).map(|i| i as u32));
    pslg
}

/// A star-shaped ring, with real coordinates.
fn star(corners: usize, center: f64, radius: f64, random: &mut Random) -> Vec<Point> {
    let corner = |i: usize, random: &mut Random| {
        let (sin, cos) = (i as f64 / corners as f64 * std::f64::consts::TAU).sin_cos();
        let r = radius * (0.2 + 0.8 * random.unit());
        Point::new(center + r * cos, center + r * sin)
    };
    (0..corners).map(|i| corner(i, random)).collect()
}

fn polygon(rings: &[Vec<Point>]) -> Domain {
    let mut pslg = Pslg::from_points(rings.concat());
    let mut first = 0;
    for ring in rings {
        let end = first + ring.len() as u32;
        pslg.add_ring(first..end);
        first = end;
    }
    Domain::polygon(pslg, &()).expect("rings")
}

/// What is left of a ring in the half-plane of `s` against `t`: of Sutherland and Hodgman, right for the
/// area of any ring.
fn halve(ring: &[Point], s: Point, t: Point) -> Vec<Point> {
    let side = |p: Point| {
        let middle = [(s.x + t.x) / 2.0, (s.y + t.y) / 2.0];
        (t.x - s.x) * (p.x - middle[0]) + (t.y - s.y) * (p.y - middle[1])
    };
    let mut kept = Vec::new();
    for (i, &b) in ring.iter().enumerate() {
        let a = ring[(i + ring.len() - 1) % ring.len()];
        let (u, v) = (side(a), side(b));
        if (u < 0.0 && v > 0.0) || (u > 0.0 && v < 0.0) {
            let t = u / (u - v);
            kept.push(Point::new(a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)));
        }
        if v <= 0.0 {
            kept.push(b);
        }
    }
    kept
}

fn area(ring: &[Point]) -> f64 {
    let Some(&o) = ring.first() else { return 0.0 };
    let pairs = ring.iter().zip(ring.iter().cycle().skip(1));
    let crosses = pairs.map(|(a, b)| (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x));
    0.5 * crosses.sum::<f64>()
}

/// The area of the cell of `site` in a domain, naively.
fn naive_area(points: &[Point], site: Point, domain: &Domain) -> f64 {
    let cut = |ring: &[Point]| {
        let others = points.iter().filter(|&&t| t != site);
        let ring = others.fold(ring.to_vec(), |ring, &t| halve(&ring, site, t));
        area(&ring)
    };
    domain.boundaries().map(cut).sum()
}

/// Checks everything about a clipping that can be told without an oracle, up to `slack`, relative.
fn check_sums(clipped: &Clipped<'_>, domain: &Domain, slack: f64) {
    let voronoi = clipped.voronoi();
    let whole = domain.measure();
    let sites = || voronoi.cells().map(|cell| cell.site());
    let extent = whole.perimeter;
    let sum: f64 = sites().map(|v| clipped.measure(v).area).sum();
    let error = (sum - whole.area).abs();
    assert!(error <= slack * extent * extent, "{sum} of {whole:?}");
    for v in sites() {
        for part in clipped.parts(v) {
            assert!(area(part.outline()) > 0.0);
            assert!(part.holes().all(|hole| area(hole) < 0.0));
        }
    }
    // Where crossings were cut, borders may run along edges but for rounding: there are slivers without
    // area in rounded numbers, which are left out.
    if domain.points().iter().all(|p| p.x.fract() % 0.125 == 0.0) {
        check_perimeters(clipped, domain);
    }
}

/// What cells share and what they have of the boundary is all the border that they have.
fn check_perimeters(clipped: &Clipped<'_>, domain: &Domain) {
    let voronoi = clipped.voronoi();
    let sites = || voronoi.cells().map(|cell| cell.site());
    let perimeters: f64 = sites().map(|v| clipped.measure(v).perimeter).sum();
    let mut shared = 0.0;
    for v in sites() {
        for (w, length) in clipped.neighbors(v) {
            let back = clipped.neighbors(w).filter(|&(u, _)| u == v);
            assert!(back.map(|(_, length)| length).eq([length]));
            shared += length;
        }
    }
    let whole = domain.measure().perimeter;
    let error = (perimeters - shared - whole).abs();
    assert!(error <= 1e-12 * perimeters, "{perimeters} {shared} {whole}");
}

fn check_against_naive(points: &[Point], domain: &Domain) {
    let voronoi = voronoi(points);
    let clipped = voronoi.clip(domain, &()).expect("nobody cancels");
    let extent = domain.measure().perimeter;
    for cell in voronoi.cells() {
        let found = clipped.measure(cell.site()).area;
        let expected = naive_area(points, cell.point(), domain);
        let error = (found - expected).abs();
        assert!(
            error <= 1e-12 * extent * extent,
            "{:?} of {points:?} in {domain:?}: {found}, not {expected}",
            cell.point()
        );
    }
    if voronoi.cells().next().is_some() {
        check_sums(&clipped, domain, 1e-14);
    }
}

#[test]
fn cells_in_boxes_are_intersections_of_half_planes() {
    let mut random = Random::new(1);
    for round in 0..400 {
        let n = random.below(14);
        let points = lattice(n, [2, 4, 7][round % 3], &mut random);
        let corners = lattice(2, 8, &mut random);
        let domain = Domain::rectangle(corners[0], corners[1]).unwrap();
        check_against_naive(&points, &domain);
    }
    for n in [1, 2, 3, 10, 60] {
        for seed in 0..10 {
            let points = Kind::Uniform.points(n, seed);
            let domain = Domain::rectangle((-0.5, 0.25), (0.75, 1.5)).unwrap();
            check_against_naive(&points, &domain);
        }
    }
}

#[test]
fn cells_in_polygons_are_intersections_of_half_planes() {
    let mut random = Random::new(2);
    for round in 0..1500 {
        let n = 1 + random.below(10);
        let size = [3, 5, 9][round % 3];
        let points = lattice(n, size, &mut random);
        let corners = 3 + random.below(9);
        let outline = ring(corners, size, &mut random);
        let domain = Domain::polygon(outline, &()).unwrap();
        check_against_naive(&points, &domain);
    }
    for seed in 0..40 {
        let points = Kind::Uniform.points(30, seed);
        let outline = star(40, 0.5, 0.6, &mut random);
        let hole = star(9, 0.5, 0.1, &mut random);
        let domain = polygon(&[outline, hole]);
        check_against_naive(&points, &domain);
        let voronoi = voronoi(&points);
        let clipped = voronoi.clip(&domain, &()).unwrap();
        check_perimeters(&clipped, &domain);
    }
}

/// Many small islands, with holes, in few cells.
#[test]
fn islands_and_holes_within_cells_are_found() {
    let mut rings = Vec::new();
    for i in 0..36 {
        let [x, y] = [f64::from(i % 6), f64::from(i / 6)];
        let square = |r: f64| {
            [(-r, -r), (r, -r), (r, r), (-r, r)].map(|(dx, dy)| Point::new(x + dx, y + dy))
        };
        rings.extend([0.375, 0.25, 0.125].map(|r| square(r).to_vec()));
    }
    let domain = polygon(&rings);
    for points in [
        vec![(2.75, 2.75)],
        vec![(0.0, 0.0), (5.0, 5.0)],
        vec![(2.5, 0.0), (2.5, 5.0), (0.0, 2.5)],
    ] {
        let points: Vec<Point> = points.into_iter().map(Point::from).collect();
        check_against_naive(&points, &domain);
    }
    let one = voronoi(&[Point::new(9.0, 9.0)]);
    let clipped = one.clip(&domain, &()).unwrap();
    assert_eq!(clipped.parts(0.into()).len(), 72);
    let holes = clipped.parts(0.into()).map(|part| part.holes().len());
    assert_eq!(holes.sum::<usize>(), 36);
}

/// The vertices are the centers of all circles through three points with none inside, each once.
#[test]
fn vertices_are_the_empty_circles() {
    let mut random = Random::new(3);
    for round in 0..300 {
        let n = 3 + random.below(9);
        let points = lattice(n, [3, 5, 12][round % 3], &mut random);
        let mut expected = Vec::new();
        for i in 0..n {
            for j in 0..n {
                for k in 0..n {
                    let [a, b, c] = [i, j, k].map(|i| points[i]);
                    let is_empty = || {
                        let side = |&p: &Point| in_circle(a, b, c, p);
                        points.iter().all(|p| side(p) != CircleSide::Inside)
                    };
                    if orient2d(a, b, c) == Orientation::Left && is_empty() {
                        expected.push(circumcenter(a, b, c).unwrap());
                    }
                }
            }
        }
        expected.sort_by(Point::lex_cmp);
        expected.dedup();
        let voronoi = voronoi(&points);
        let mut found = voronoi.vertices().to_vec();
        found.sort_by(Point::lex_cmp);
        assert_eq!(found, expected, "{points:?}");
        check_structure(&voronoi);
    }
}

/// Checks Euler's formula, that sides of cells follow each other, and directions.
fn check_structure(voronoi: &Voronoi) {
    let cells: Vec<_> = voronoi.cells().collect();
    let [v, e, f] = [voronoi.vertices().len(), voronoi.edges().len(), cells.len()];
    if v > 0 {
        assert_eq!(v + 1 + f, e + 2, "Euler");
    } else {
        assert_eq!(e, f.saturating_sub(1));
    }
    let mut sides = 0;
    for cell in &cells {
        let ends: Vec<_> = cell.sides().map(|side| side.ends).collect();
        sides += ends.len();
        for (i, side) in ends.iter().enumerate() {
            assert_eq!(side[1], ends[(i + 1) % ends.len()][0]);
        }
        assert_eq!(cell.measure().is_some(), cell.is_bounded());
        for side in cell.sides() {
            let edge = voronoi.edge(side.edge);
            assert!(edge.sites.contains(&cell.site()) && edge.sites.contains(&side.neighbor));
            let [left, right] = edge.sites.map(|v| voronoi.sites()[v.index()]);
            let (from, [x, y]) = match edge.line {
                Line::Segment(ends) => {
                    assert_ne!(ends[0], ends[1]);
                    continue;
                }
                Line::Ray { from, direction } => (voronoi.vertices()[from], direction),
                Line::Full { through, direction } => (through, direction),
            };
            assert!((x.hypot(y) - 1.0).abs() < 1e-15);
            // Far along the ray both sites are equally far, the left one to the left.
            let along = |p: Point| (p.x - from.x) * x + (p.y - from.y) * y;
            assert!((along(left) - along(right)).abs() < 1e-9 * (1.0 + along(left).abs()));
            assert!((left.y - from.y) * x - (left.x - from.x) * y > 0.0);
        }
    }
    assert_eq!(sides, 2 * e);
}

#[test]
fn few_points_equal_points_and_rows_have_cells() {
    let none = voronoi(&[]);
    assert_eq!((none.cells().count(), none.edges().len()), (0, 0));
    let square = Domain::rectangle((0.0, 0.0), (2.0, 2.0)).unwrap();
    assert_eq!(none.clip(&square, &()).unwrap().energy(), 0.0);

    let p = |x: f64, y: f64| Point::new(x, y);
    let same = voronoi(&[p(1.0, 1.0), p(1.0, 1.0), p(1.0, 1.0)]);
    assert_eq!(same.cells().count(), 1);
    assert_eq!(same.cell(2.into()).site(), VertexId::new(0));
    assert!(!same.cell(0.into()).is_bounded() && same.cell(0.into()).sides().len() == 0);
    assert_eq!(same.clip(&square, &()).unwrap().measure(2.into()).area, 4.0);

    let row: Vec<Point> = [3.0, 1.0, 1.0, 0.0, 7.0].map(|x| p(x, 2.0 * x)).to_vec();
    let row = voronoi(&row);
    check_structure(&row);
    assert_eq!((row.vertices().len(), row.edges().len()), (0, 3));
    assert!(row.edges().all(|e| matches!(e.line, Line::Full { .. })));
}

/// Grids: every vertex of the diagram lies where four cells meet; boxes along edges, through sites, and
/// along diagonals.
#[test]
fn grids_are_cut_along_and_across() {
    let points: Vec<Point> = (0..100)
        .map(|i| Point::new((i % 10).into(), (i / 10).into()))
        .collect();
    let voronoi = voronoi(&points);
    assert_eq!((voronoi.vertices().len(), voronoi.edges().len()), (81, 180));
    check_structure(&voronoi);
    for (low, high) in [
        (-0.5, 9.5),
        (0.0, 9.0),
        (0.5, 8.5),
        (1.25, 1.75),
        (2.5, 3.5),
    ] {
        let domain = Domain::rectangle((low, low), (high, high)).unwrap();
        let clipped = voronoi.clip(&domain, &()).unwrap();
        check_sums(&clipped, &domain, 0.0);
        if low == 2.5 {
            let parts = voronoi.cells().map(|cell| clipped.parts(cell.site()).len());
            assert_eq!(parts.sum::<usize>(), 1);
        }
    }
    let diamond = [(4.5, -0.5), (9.5, 4.5), (4.5, 9.5), (-0.5, 4.5)].map(Point::from);
    let diamond = polygon(&[diamond.to_vec()]);
    check_against_naive(&points, &diamond);
}

/// Multiplying everything by a power of two multiplies the results, to the bit.
#[test]
fn scale_does_not_matter() {
    let mut random = Random::new(4);
    let points = Kind::Uniform.points(40, 4);
    let outline = star(30, 0.5, 0.7, &mut random);
    let cells = |exponent: i32| {
        let scale = |p: &Point| {
            let power = |c: f64| delone_testkit::generate::scaled(c, exponent);
            Point::new(power(p.x), power(p.y))
        };
        let points: Vec<Point> = points.iter().map(scale).collect();
        let domain = polygon(&[outline.iter().map(scale).collect()]);
        let voronoi = voronoi(&points);
        let clipped = voronoi.clip(&domain, &()).unwrap();
        let sites = voronoi.cells().map(|cell| cell.site());
        let all = sites.flat_map(|v| {
            clipped
                .parts(v)
                .flat_map(|part| part.rings().collect::<Vec<_>>())
        });
        let back = |p: &Point| {
            let power = |c: f64| delone_testkit::generate::scaled(c, -exponent);
            [power(p.x).to_bits(), power(p.y).to_bits()]
        };
        all.map(|ring| ring.iter().map(back).collect::<Vec<_>>())
            .collect::<Vec<_>>()
    };
    let expected = cells(0);
    for exponent in [-900, -300, 300, 900] {
        assert_eq!(cells(exponent), expected, "{exponent}");
    }
}

/// Coordinates of all sizes at once: nothing breaks, and areas add up.
#[test]
fn any_finite_coordinates_will_do() {
    let mut random = Random::new(5);
    for round in 0..300 {
        let mut coordinate = || match round % 3 {
            0 => random.finite(),
            1 => random.choose(&[
                0.0,
                5e-324,
                1e-300,
                -1e-300,
                1.0,
                -1.0,
                1e300,
                f64::MAX,
                -f64::MAX,
            ]),
            _ => random.choose(&[0.0, 1e-320, 1e-310, 3e-320, 1.0, 1.0 + f64::EPSILON]),
        };
        let points: Vec<Point> = (0..8)
            .map(|_| Point::new(coordinate(), coordinate()))
            .collect();
        let corners: Vec<Point> = (0..5)
            .map(|_| Point::new(coordinate(), coordinate()))
            .collect();
        let mut pslg = Pslg::from_points(corners.iter().copied());
        pslg.add_ring(0..5);
        let voronoi = voronoi(&points);
        assert!(voronoi.vertices().iter().all(Point::is_finite));
        for domain in [
            Domain::rectangle(corners[0], corners[1]).unwrap(),
            Domain::polygon(pslg, &()).unwrap(),
        ] {
            let clipped = voronoi.clip(&domain, &()).unwrap();
            let largest = domain
                .points()
                .iter()
                .fold(0.0, |m: f64, p| m.max(p.x.abs()).max(p.y.abs()));
            if (1e-100..1e100).contains(&largest) {
                let sum: f64 = voronoi
                    .cells()
                    .map(|c| clipped.measure(c.site()).area)
                    .sum();
                let error = (sum - domain.measure().area).abs();
                assert!(error <= 1e-13 * largest * largest, "{points:?} {domain:?}");
            }
        }
    }
}

#[test]
fn a_triangulation_with_segments_is_triangulated_anew() {
    let corners = [
        (0.0, 0.0),
        (10.0, 0.0),
        (10.0, 1.0),
        (5.0, 0.25),
        (5.0, 3.0),
        (0.0, 1.0),
    ];
    let mut pslg = Pslg::from_points(corners);
    pslg.add_segment(0, 2); // not Delaunay
    let t = ConstrainedDelaunay::new().triangulate(pslg).unwrap();
    let points = t.triangulation().points().to_vec();
    let found = Voronoi::new(t.triangulation(), &()).unwrap();
    let expected = voronoi(&points);
    assert_ne!(
        t.triangulation().hash(),
        delone::triangulate(points).unwrap().hash()
    );
    let sorted = |voronoi: &Voronoi| {
        let mut vertices = voronoi.vertices().to_vec();
        vertices.sort_by(Point::lex_cmp);
        vertices
    };
    assert_eq!(sorted(&found), sorted(&expected));
}

#[test]
fn relaxing_never_raises_the_energy() {
    let mut random = Random::new(6);
    let outline = star(24, 0.5, 0.6, &mut random);
    let hole = star(8, 0.5, 0.1, &mut random);
    let domains = [
        Domain::rectangle((0.0, 0.0), (1.0, 1.0)).unwrap(),
        polygon(&[outline, hole]),
    ];
    for domain in &domains {
        for points in [
            Kind::Uniform.points(60, 7),
            lattice(60, 5, &mut random),
            vec![Point::new(9.0, 9.0), Point::new(0.25, 0.5)],
        ] {
            let relaxed = Lloyd::new(30)
                .relax(points.iter().copied(), domain)
                .unwrap();
            for pair in relaxed.energies.windows(2) {
                assert!(pair[1] <= pair[0] * (1.0 + 1e-13), "{:?}", relaxed.energies);
            }
            let [first, .., last] = relaxed.energies[..] else {
                panic!("no step");
            };
            assert!(last < first);
            assert_eq!(relaxed.points.len(), points.len());
        }
    }
    let halves = Lloyd::new(1000).until(1e-9);
    let relaxed = halves.relax([(0.1, 0.2), (0.3, 0.1)], &domains[0]).unwrap();
    assert!(relaxed.movement <= 1e-9 && relaxed.energies.len() < 1000);
}

/// Everything that can be asked of a diagram and of its cells in a domain.
fn all_of(voronoi: &Voronoi, domain: &Domain) -> impl PartialEq + use<> {
    let clipped = voronoi.clip(domain, &()).expect("nobody cancels");
    let sites = || (0..voronoi.sites().len()).map(VertexId::new);
    let sides = sites().map(|v| voronoi.cell(v).sides().collect::<Vec<_>>());
    let rings = |v| clipped.parts(v).flat_map(|part| part.rings());
    let rings = sites().map(|v| rings(v).map(<[Point]>::to_vec).collect::<Vec<_>>());
    let neighbors = sites().map(|v| clipped.neighbors(v).collect::<Vec<_>>());
    (
        voronoi.vertices().to_vec(),
        voronoi.edges().collect::<Vec<_>>(),
        sides.collect::<Vec<_>>(),
        rings.collect::<Vec<_>>(),
        neighbors.collect::<Vec<_>>(),
        clipped.energy().to_bits(),
    )
}

#[test]
fn threads_change_nothing() {
    let mut random = Random::new(8);
    let outline = star(400, 0.5, 0.6, &mut random);
    let holes = [0.48, 0.52].map(|center| star(9, center, 1e-3, &mut random));
    let domain = polygon(&[&[outline], &holes[..]].concat());
    // Nearly all of a lattice is cocircular, and a third of its points are equal to others.
    let mut grid = lattice(80_000, 1 << 8, &mut random);
    for p in &mut grid {
        *p = Point::new(p.x / 256.0, p.y / 256.0);
    }
    for points in [Kind::Uniform.points(70_000, 8), grid] {
        let t = delone::triangulate(points.iter().copied()).unwrap();
        let weighted = points.iter().map(|&p| (p, 1e-6 * p.x));
        let regular = delone::regular::triangulate(weighted).unwrap();
        let found = |threads: usize| {
            let work = || {
                let voronoi = Voronoi::new(&t, &()).unwrap();
                let power = Voronoi::weighted(&regular, &()).unwrap();
                let relaxed = Lloyd::new(1).relax(points.iter().copied(), &domain);
                let power = all_of(&power, &domain);
                (all_of(&voronoi, &domain), power, relaxed.unwrap())
            };
            delone::on_threads(threads, work).unwrap()
        };
        let one = found(1);
        for threads in [2, 3] {
            assert!(one == found(threads), "{threads} threads");
        }
    }
}

struct Impatient;

impl Watch for Impatient {
    fn progress(&self, _: Phase, _: u64, _: u64) {}

    fn is_cancelled(&self) -> bool {
        true
    }
}

#[test]
fn a_watch_may_cancel() {
    let points = Kind::Uniform.points(20_000, 1);
    let t = delone::triangulate(points.iter().copied()).unwrap();
    assert_eq!(Voronoi::new(&t, &Impatient).err(), Some(Error::Cancelled));
    let voronoi = Voronoi::new(&t, &()).unwrap();
    let square = Domain::rectangle((0.0, 0.0), (1.0, 1.0)).unwrap();
    assert_eq!(
        voronoi.clip(&square, &Impatient).err(),
        Some(Error::Cancelled)
    );
    let relaxing = Lloyd::new(5).watch(&Impatient).relax(points, &square);
    assert_eq!(relaxing.err(), Some(Error::Cancelled));
}
