//! Point location against the definition: every vertex, edge and face is tried.

use delone::locate::{Location, Locator, locate};
use delone::predicates::{Orientation, is_between, orient2d};
use delone::{
    ConstrainedDelaunay, DomainRule, Error, HalfEdgeId, Phase, Point, Pslg, SegmentPolicy,
    TriangleId, Triangulation, VertexId, Watch,
};
use delone_testkit::domains::Domain;
use delone_testkit::fuzz::segments::case;
use delone_testkit::generate::{Kind, Random};
use std::sync::atomic::{AtomicU64, Ordering};

fn ends(t: &Triangulation, h: HalfEdgeId) -> Option<[Point; 2]> {
    let ends = [t.mesh().origin(h), t.mesh().dest(h)];
    (!ends.iter().any(|v| v.is_infinite())).then(|| ends.map(|v| t.point(v)))
}

/// What the definition says; of what lies outside, only that it does.
fn naive(t: &Triangulation, p: Point) -> Option<Location> {
    let mesh = t.mesh();
    if let Some(i) = t.points().iter().position(|&q| q == p) {
        return Some(Location::Vertex(VertexId::new(i)));
    }
    let on = |&h: &HalfEdgeId| ends(t, h).is_some_and(|[a, b]| is_between(a, b, p));
    if let Some(h) = mesh.half_edges().find(on) {
        return Some(Location::Edge(h));
    }
    let is_left = |h| ends(t, h).is_some_and(|[a, b]| orient2d(a, b, p) == Orientation::Left);
    let contains = |t: &TriangleId| t.half_edges().into_iter().all(is_left);
    let face = mesh.triangles().find(contains)?;
    Some(if face.index() < t.num_triangles() {
        Location::Face(face)
    } else {
        Location::Carved(face)
    })
}

/// Checks an answer for a point that lies in no vertex, edge or face.
fn assert_outside(t: &Triangulation, p: Point, found: Location) {
    let mesh = t.mesh();
    match found {
        Location::Apart => assert!(t.num_vertices() < 2),
        Location::Outside(h) => {
            let [a, b] = ends(t, h).expect("a finite edge");
            assert!(mesh.apex(h).is_infinite());
            assert_eq!(orient2d(a, b, p), Orientation::Left);
        }
        Location::Beyond(h) => {
            assert!(mesh.dest(h).is_infinite() && t.num_triangles() == 0);
            let end = mesh.origin(h);
            let before = mesh
                .star(h)
                .map(|g| mesh.dest(g))
                .find(|v| !v.is_infinite());
            let [before, end] = [before.expect("a row"), end].map(|v| t.point(v));
            assert!(is_between(before, p, end), "{p:?} is not beyond {end:?}");
        }
        inside => panic!("{p:?} lies outside, not {inside:?}"),
    }
}

/// Asks for every point in every way.
fn assert_located(t: &Triangulation, asked: &[Point], random: &mut Random) {
    let locator = Locator::new(t);
    let one: Vec<_> = asked
        .iter()
        .map(|&p| locator.locate(p).expect("finite"))
        .collect();
    for (&p, &found) in asked.iter().zip(&one) {
        match naive(t, p) {
            Some(expected) => assert_eq!(found, expected, "{p:?} in {:?}", t.points()),
            None => assert_outside(t, p, found),
        }
        assert_eq!(
            found.triangle(t),
            touching(t, p),
            "{p:?} in {:?}",
            t.points()
        );
        if t.mesh().num_faces() > 0 {
            let hint = HalfEdgeId::new(random.below(3 * t.mesh().num_faces()));
            assert_eq!(locator.locate_from(hint, p), Ok(found));
            let by_walk = locate(t.mesh(), t.points(), hint, p);
            assert_eq!(
                std::mem::discriminant(&by_walk),
                std::mem::discriminant(&flat(found))
            );
        }
    }
    for threads in [1, 3] {
        let all = locator.clone().threads(threads).locate_all(asked, &());
        assert_eq!(all.as_ref(), Ok(&one));
    }
}

/// As the walk sees it, which knows of no domain.
fn flat(location: Location) -> Location {
    match location {
        Location::Carved(t) => Location::Face(t),
        other => other,
    }
}

/// The first triangle that contains `p`.
fn touching(t: &Triangulation, p: Point) -> Option<TriangleId> {
    let holds = |corners: &[VertexId; 3]| {
        let [a, b, c] = corners.map(|v| t.point(v));
        [[a, b], [b, c], [c, a]]
            .iter()
            .all(|&[a, b]| orient2d(a, b, p) != Orientation::Right)
    };
    t.triangles().iter().position(holds).map(TriangleId::new)
}

/// Points that are likely to lie on something.
fn questions(t: &Triangulation, kind: Kind, random: &mut Random) -> Vec<Point> {
    let mut asked = kind.points(12, random.bits());
    asked.extend(Kind::RawBits.points(2, random.bits()));
    let points = t.points();
    for _ in 0..if points.is_empty() { 0 } else { 16 } {
        let [a, b, c] = [0; 3].map(|_| points[random.below(points.len())]);
        let middle = |a: f64, b: f64| a / 2.0 + b / 2.0;
        let ab = Point::new(middle(a.x, b.x), middle(a.y, b.y));
        asked.extend([a, ab, Point::new(a.x, b.y)]);
        asked.push(Point::new(middle(ab.x, c.x), middle(ab.y, c.y)));
        asked.push(Point::new(a.x.next_up(), a.y));
        asked.push(Point::new(b.x + (b.x - a.x), b.y + (b.y - a.y)));
    }
    asked.retain(Point::is_finite);
    asked
}

#[test]
fn points_alone_of_every_kind() {
    for kind in Kind::ALL {
        for seed in 0..60 {
            let random = &mut Random::new(seed);
            let n = random.below(if seed % 4 == 0 { 120 } else { 9 });
            let t = delone::triangulate(kind.points(n, seed)).unwrap();
            let asked = questions(&t, kind, random);
            assert_located(&t, &asked, random);
        }
    }
}

#[test]
fn domains_of_every_kind() {
    let (mut domain, mut carved) = (Domain::default(), 0);
    for seed in 0..1500 {
        case(seed, 24, 12, &mut domain);
        let Ok(t) = domain.triangulate(1) else {
            continue;
        };
        let t = t.into_triangulation();
        carved += usize::from(t.is_carved());
        let random = &mut Random::new(seed);
        let asked = questions(&t, Kind::Lattice { side: 4 }, random);
        assert_located(&t, &asked, random);
    }
    assert!(carved > 200, "only {carved} were carved");
}

/// A comb whose teeth are thin: walks in it, and around it, pass long triangles and high degrees.
#[test]
fn thin_teeth() {
    let teeth = 150;
    let mut pslg = Pslg::from_points([(0.0, 0.0), (f64::from(teeth), -1e-3)]);
    for i in (0..teeth).rev() {
        pslg.points.push(Point::new(f64::from(i) + 0.5, 1e4));
        pslg.points
            .push(Point::new(f64::from(i), 1e-3 * f64::from(i % 3)));
    }
    pslg.add_ring(0..pslg.points.len() as u32);
    for rule in [DomainRule::Hull, DomainRule::Carve] {
        let builder = ConstrainedDelaunay::new()
            .domain(rule)
            .crossings(SegmentPolicy::Split);
        let t = builder
            .triangulate(pslg.clone())
            .unwrap()
            .into_triangulation();
        let random = &mut Random::new(1);
        let mut asked = questions(&t, Kind::Lattice { side: 5 }, random);
        asked.extend(
            (0..200).map(|_| Point::new(random.unit() * f64::from(teeth), random.unit() * 1e4)),
        );
        assert_located(&t, &asked, random);
    }
}

/// All on the hull, and questions around it: the edge named is the same from everywhere, without a walk
/// around.
#[test]
fn circles_and_rows_are_searched_not_walked() {
    let n = 20_000;
    let row: Vec<_> = (0..n)
        .map(|i| Point::new(f64::from(i), 2.0 * f64::from(i)))
        .collect();
    for points in [Kind::Circle.points(n as usize, 1), row] {
        let t = delone::triangulate(points.iter().copied()).unwrap();
        let locator = Locator::new(&t);
        for (i, &p) in points.iter().enumerate().step_by(501) {
            let at = t.representative(VertexId::new(i));
            assert_eq!(locator.locate(p), Ok(Location::Vertex(at)));
            for q in [
                Point::new(3.0 * p.x, 3.0 * p.y),
                Point::new(p.x - 1e5, p.y + 1.0),
            ] {
                assert_outside_or_row(&t, q, locator.locate(q).unwrap());
            }
        }
    }
}

fn assert_outside_or_row(t: &Triangulation, p: Point, found: Location) {
    match found {
        Location::Vertex(v) => assert_eq!(t.point(v), p),
        outside => assert_outside(t, p, outside),
    }
}

#[test]
fn what_is_not_finite_is_named() {
    let t = delone::triangulate([(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)]).unwrap();
    let locator = Locator::new(&t);
    let asked = [(0.5, 0.5), (0.0, f64::INFINITY), (f64::NAN, 0.0)].map(Point::from);
    let error = locator.locate_all(&asked, &()).unwrap_err();
    assert!(matches!(error, Error::NotFinite { index: 1, .. }));
    assert!(matches!(
        locator.locate(asked[2]),
        Err(Error::NotFinite { index: 0, .. })
    ));
    let hint = HalfEdgeId::new(0);
    assert!(locator.locate_from(hint, asked[1]).is_err());
}

/// Counts what it is told, and gives up after a while.
struct Watcher {
    told: AtomicU64,
    most: u64,
}

impl Watch for Watcher {
    fn progress(&self, phase: Phase, done: u64, _: u64) {
        if phase == Phase::Query {
            self.told.fetch_max(done, Ordering::Relaxed);
        }
    }

    fn is_cancelled(&self) -> bool {
        self.told.load(Ordering::Relaxed) > self.most
    }
}

#[test]
fn a_watch_is_told_and_may_cancel() {
    let t = delone::triangulate(Kind::Uniform.points(1000, 1)).unwrap();
    let asked = Kind::Uniform.points(50_000, 2);
    let watcher = |most| Watcher {
        told: 0.into(),
        most,
    };
    let patient = watcher(u64::MAX);
    let locator = Locator::new(&t).threads(2);
    assert!(locator.locate_all(&asked, &patient).is_ok());
    assert_eq!(patient.told.into_inner(), 50_000);
    let hasty = watcher(10_000);
    assert_eq!(locator.locate_all(&asked, &hasty), Err(Error::Cancelled));
    assert!(hasty.told.into_inner() < 50_000);
    let row = delone::triangulate([(0.0, 0.0), (1.0, 1.0)]).unwrap();
    let hasty = watcher(10_000);
    assert_eq!(
        Locator::new(&row).locate_all(&asked, &hasty),
        Err(Error::Cancelled)
    );
}
