//! Power diagrams against half-planes in rational arithmetic.

use crate::sites::{Weights, sites};
use crate::{Site, built};
use dashu_ratio::RBig;
use delone::voronoi::{Domain, Voronoi};
use delone::{Point, VertexId, triangulate};
use delone_testkit::generate::Kind;

fn rational(c: f64) -> RBig {
    RBig::try_from(c).expect("finite")
}

type Corner = [RBig; 2];

/// How much less the power of a place is with respect to `a` than to `b`, from its coordinates.
fn lead(a: Site, b: Site) -> impl Fn(&Corner) -> RBig {
    let [ax, ay, aw] = [a.0.x, a.0.y, a.1].map(rational);
    let [bx, by, bw] = [b.0.x, b.0.y, b.1].map(rational);
    let constant = &bx * &bx + &by * &by - bw - &ax * &ax - &ay * &ay + aw;
    let two = rational(2.0);
    let [u, v] = [(ax - bx) * &two, (ay - by) * &two];
    move |[x, y]| x * &u + y * &v + &constant
}

/// Cuts off a convex polygon what lies behind a line.
fn cut(polygon: &[Corner], side: impl Fn(&Corner) -> RBig) -> Vec<Corner> {
    let mut kept = Vec::new();
    for (i, p) in polygon.iter().enumerate() {
        let q = &polygon[(i + 1) % polygon.len()];
        let (at_p, at_q) = (side(p), side(q));
        if at_p >= RBig::ZERO {
            kept.push(p.clone());
        }
        if (at_p > RBig::ZERO && at_q < RBig::ZERO) || (at_p < RBig::ZERO && at_q > RBig::ZERO) {
            let t = &at_p / (&at_p - &at_q);
            kept.push(std::array::from_fn(|k| &p[k] + &t * (&q[k] - &p[k])));
        }
    }
    kept
}

fn area(polygon: &[Corner]) -> f64 {
    let next = polygon.iter().cycle().skip(1);
    let crosses = polygon
        .iter()
        .zip(next)
        .map(|(p, q)| &p[0] * &q[1] - &p[1] * &q[0]);
    let doubled = crosses.fold(RBig::ZERO, |sum, cross| sum + cross);
    doubled.to_f64().value() / 2.0
}

/// The area of each cell in a box, straight from the definition.
fn naive_areas(sites: &[Site], [low, high]: [Point; 2]) -> Vec<f64> {
    let corners = [
        (low.x, low.y),
        (high.x, low.y),
        (high.x, high.y),
        (low.x, high.y),
    ];
    let whole: Vec<Corner> = corners.iter().map(|&(x, y)| [x, y].map(rational)).collect();
    let of_site = |i: usize| {
        let mut cell = whole.clone();
        for j in (0..sites.len()).filter(|&j| j != i) {
            let [a, b] = [sites[i], sites[j]];
            // Of equal sites the first has the cell.
            if a == b && j < i {
                return 0.0;
            }
            cell = cut(&cell, lead(a, b));
        }
        area(&cell)
    };
    (0..sites.len()).map(of_site).collect()
}

fn check(sites: &[Site], window: [Point; 2], name: &str) {
    let t = built(sites);
    let diagram = Voronoi::weighted(&t, &()).expect("not cancelled");
    let domain = Domain::rectangle(window[0], window[1]).expect("a rectangle");
    let clipped = diagram.clip(&domain, &()).expect("not cancelled");
    let whole = (window[1].x - window[0].x) * (window[1].y - window[0].y);
    let expected = naive_areas(sites, window);
    for (i, expected) in expected.into_iter().enumerate() {
        let found = clipped.measure(VertexId::new(i)).area;
        let error = (found - expected).abs();
        assert!(
            error <= 1e-12 * whole,
            "{name}: {i} has {found}, not {expected} of {sites:?}"
        );
    }
    let hidden = t.hidden().iter().map(|&v| clipped.parts(v).len());
    assert_eq!(hidden.sum::<usize>(), 0, "{name}");
    assert_eq!(diagram.cells().count(), t.triangulation().num_vertices());
}

#[test]
fn cells_are_those_of_the_definition() {
    let kinds = [
        (Kind::Lattice { side: 3 }, 3.0),
        (Kind::Lattice { side: 5 }, 5.0),
        (Kind::Uniform, 1.0),
        (Kind::CocircularRings, 18.0),
        (Kind::Collinear, 20.0),
        (Kind::Cross, 20.0),
    ];
    for (kind, size) in kinds {
        for weights in [
            Weights::Equal,
            Weights::Few(3),
            Weights::Few(6),
            Weights::Plane,
            Weights::Even,
        ] {
            for seed in 0..12 {
                let sites = sites(kind, weights, seed as usize % 14, seed);
                let name = format!("{kind:?} {weights:?} {seed}");
                // A window around all, one through lattice points, and one that lies askew.
                for (low, high) in [(-2.0, 2.0), (0.0, 1.0), (0.3, 0.77)] {
                    let window = [low, high].map(|c| Point::new(c * size, c * size + low));
                    check(&sites, window, &name);
                }
            }
        }
    }
}

#[test]
fn equal_weights_make_the_voronoi_diagram() {
    for kind in Kind::ALL {
        for seed in 0..20 {
            let points = kind.points(seed as usize, seed);
            let t = built(&points.iter().map(|&p| (p, 2.5)).collect::<Vec<_>>());
            let power = Voronoi::weighted(&t, &()).expect("not cancelled");
            let delaunay = triangulate(points).expect("finite");
            let voronoi = Voronoi::new(&delaunay, &()).expect("not cancelled");
            let places = |diagram: &Voronoi| {
                let mut places = diagram.vertices().to_vec();
                places.sort_by(Point::lex_cmp);
                places
            };
            assert_eq!(places(&power), places(&voronoi), "{kind:?} {seed}");
            assert_eq!(power.edges().len(), voronoi.edges().len());
            for (cell, expected) in power.cells().zip(voronoi.cells()) {
                assert_eq!(cell.site(), expected.site());
                assert_eq!(cell.is_bounded(), expected.is_bounded());
                assert_eq!(cell.sides().len(), expected.sides().len());
            }
            assert_eq!(power.cells().count(), voronoi.cells().count());
        }
    }
}

/// Cells that are less than an area: a site tied in a triangle, and one tied on the hull.
#[test]
fn tied_sites_have_cells_without_area() {
    let corners = [(0.0, 0.0), (4.0, 0.0), (0.0, 4.0)].map(|p| (Point::from(p), 0.0));
    for (p, weight, sides) in [((1.0, 1.0), -6.0, 0), ((2.0, 0.0), -4.0, 2)] {
        let mut sites = vec![(Point::from(p), weight)];
        sites.extend(corners);
        let t = built(&sites);
        assert_eq!(t.hidden(), []);
        let diagram = Voronoi::weighted(&t, &()).expect("not cancelled");
        let cell = diagram.cell(VertexId::new(0));
        assert_eq!((cell.sides().len(), cell.is_bounded()), (sides, sides == 0));
        assert_eq!(diagram.vertices(), [Point::new(2.0, 2.0)]);
        check(
            &sites,
            [Point::new(-1.0, -1.0), Point::new(3.0, 3.5)],
            "tied",
        );
        check(
            &sites,
            [Point::new(2.0, 0.0), Point::new(4.0, 3.5)],
            "along the line",
        );
    }
}

/// Between two sites the border is where the powers are equal, also far beyond them.
#[test]
fn a_line_may_lie_beyond_both_sites() {
    let t = built(&[(Point::new(0.0, 0.0), 24.0), (Point::new(2.0, 0.0), 0.0)]);
    let diagram = Voronoi::weighted(&t, &()).expect("not cancelled");
    let edge = diagram.edge(0);
    assert!(matches!(
        edge.line,
        delone::voronoi::Line::Full { through, .. } if through == Point::new(7.0, 0.0)
    ));
}
