//! Nearest neighbours against all distances.

use delone::nearest::Nearest;
use delone::predicates::{CircleSide, compare_distances, in_disc};
use delone::{Error, Phase, Point, Triangulation, VertexId, Watch};
use delone_testkit::domains::Domain;
use delone_testkit::fuzz::segments::case;
use delone_testkit::generate::{Kind, Random};
use delone_testkit::naive::distinct;
use std::sync::atomic::{AtomicU64, Ordering};

/// All vertices by their distance from `p`, equal ones by index.
fn by_distance(points: &[Point], p: Point) -> Vec<VertexId> {
    let mut order = distinct(points);
    order.sort_by(|&i, &j| compare_distances(p, points[i], points[j]).then(i.cmp(&j)));
    order.into_iter().map(VertexId::new).collect()
}

fn by_index(points: &[Point], p: Point, radius: f64) -> Vec<VertexId> {
    let is_within = |&i: &usize| in_disc(p, radius, points[i]) != CircleSide::Outside;
    distinct(points)
        .into_iter()
        .filter(is_within)
        .map(VertexId::new)
        .collect()
}

/// Asks about every point in every way.
fn assert_nearest(nearest: &Nearest, points: &[Point], asked: &[Point], random: &mut Random) {
    let k = random.below(points.len() + 2);
    let radius = match asked {
        [a, b, ..] => (a.x - b.x).abs().min(f64::MAX),
        _ => 1.0,
    };
    let sorted: Vec<_> = asked.iter().map(|&p| by_distance(points, p)).collect();
    let first: Vec<_> = sorted.iter().map(|order| order.first().copied()).collect();
    let some: Vec<_> = sorted
        .iter()
        .map(|order| order[..k.min(order.len())].to_vec())
        .collect();
    let within: Vec<_> = asked.iter().map(|&p| by_index(points, p, radius)).collect();
    for (i, &p) in asked.iter().enumerate() {
        assert_eq!(nearest.nearest(p), Ok(first[i]), "{p:?} in {points:?}");
        assert_eq!(
            nearest.k_nearest(p, k).as_ref(),
            Ok(&some[i]),
            "{p:?} in {points:?}"
        );
        assert_eq!(
            nearest.within(p, radius).as_ref(),
            Ok(&within[i]),
            "{p:?} in {points:?}"
        );
    }
    for threads in [1, 3] {
        let nearest = nearest.clone().threads(threads);
        assert_eq!(nearest.nearest_all(asked, &()).as_ref(), Ok(&first));
        assert_eq!(nearest.k_nearest_all(asked, k, &()).as_ref(), Ok(&some));
        assert_eq!(nearest.within_all(asked, radius, &()).as_ref(), Ok(&within));
    }
}

/// Points as near to several others as can be: themselves, midpoints, centres of boxes.
fn questions(points: &[Point], kind: Kind, random: &mut Random) -> Vec<Point> {
    let mut asked = kind.points(8, random.bits());
    asked.extend(Kind::RawBits.points(1, random.bits()));
    for _ in 0..if points.is_empty() { 0 } else { 8 } {
        let [a, b, c] = [0; 3].map(|_| points[random.below(points.len())]);
        let middle = |a: f64, b: f64| a / 2.0 + b / 2.0;
        asked.extend([a, Point::new(middle(a.x, b.x), middle(a.y, b.y))]);
        asked.push(Point::new(middle(a.x, b.x), middle(b.y, c.y)));
    }
    asked.retain(Point::is_finite);
    asked
}

#[test]
fn points_alone_of_every_kind() {
    for kind in Kind::ALL {
        for seed in 0..60 {
            let random = &mut Random::new(seed);
            let n = random.below(if seed % 4 == 0 { 100 } else { 9 });
            let points = kind.points(n, seed);
            let asked = questions(&points, kind, random);
            let nearest = Nearest::of_points(points.iter().copied(), &()).unwrap();
            assert_nearest(&nearest, &points, &asked, random);
        }
    }
}

/// The centre of circles with many points, on which neighbours are as near as it gets.
#[test]
fn all_on_circles_about_the_question() {
    for seed in 0..40 {
        let random = &mut Random::new(seed);
        let points = Kind::CocircularRings.points(1 + random.below(60), seed);
        let nearest = Nearest::of_points(points.iter().copied(), &()).unwrap();
        assert_nearest(
            &nearest,
            &points,
            &[Point::new(0.0, 0.0), Point::new(1.0, 1.0)],
            random,
        );
        for radius in [5.0, 5f64.next_down(), 325f64.sqrt()] {
            let found = nearest.within((0.0, 0.0), radius).unwrap();
            assert_eq!(found, by_index(&points, Point::new(0.0, 0.0), radius));
        }
    }
}

#[test]
fn domains_of_every_kind() {
    let mut domain = Domain::default();
    for seed in 0..800 {
        case(seed, 20, 10, &mut domain);
        let Ok(t) = domain.triangulate(1) else {
            continue;
        };
        let t = t.into_triangulation();
        let random = &mut Random::new(seed);
        let asked = questions(t.points(), Kind::Lattice { side: 4 }, random);
        let nearest = Nearest::new(&t, &()).unwrap();
        assert_nearest(&nearest, t.points(), &asked, random);
    }
}

/// Two segments side by side that part what is nearest: along the graph of their triangulation nobody gets
/// there.
#[test]
fn segments_do_not_stand_in_the_way() {
    let mut pslg = delone::Pslg::from_points([(-9.0, -1.0), (9.0, -1.0), (-9.0, 1.0), (9.0, 1.0)]);
    pslg.add_segment(0, 1);
    pslg.add_segment(2, 3);
    pslg.points
        .extend([(0.0, 2.0), (0.0, -2.0)].map(Point::from));
    let t = delone::ConstrainedDelaunay::new()
        .triangulate(pslg)
        .unwrap()
        .into_triangulation();
    let nearest = Nearest::new(&t, &()).unwrap();
    assert_eq!(
        nearest.k_nearest((0.0, 2.0), 2),
        Ok(vec![4.into(), 5.into()])
    );
}

#[test]
fn many_points_and_many_questions() {
    for kind in [
        Kind::Uniform,
        Kind::Clusters,
        Kind::Circle,
        Kind::Lattice { side: 100 },
    ] {
        let points = kind.points(5000, 1);
        let t: Triangulation = delone::triangulate(points.iter().copied()).unwrap();
        let nearest = Nearest::new(&t, &()).unwrap();
        let asked = kind.points(20_000, 2);
        let answers = nearest.clone().threads(2).nearest_all(&asked, &()).unwrap();
        for (&p, &answer) in asked.iter().zip(&answers).step_by(97) {
            let expected = distinct_nearest(&points, p);
            assert_eq!(answer, Some(expected));
        }
        let tens = nearest.k_nearest_all(&asked[..500], 10, &()).unwrap();
        for (&p, ten) in asked.iter().zip(&tens).step_by(50) {
            assert_eq!(*ten, by_distance(&points, p)[..10]);
        }
    }
}

fn distinct_nearest(points: &[Point], p: Point) -> VertexId {
    let closer =
        |&i: &usize, &j: &usize| compare_distances(p, points[i], points[j]).then(i.cmp(&j));
    VertexId::new((0..points.len()).min_by(closer).expect("points"))
}

#[test]
fn what_cannot_be_asked_is_named() {
    let nearest = Nearest::of_points([(0.0, 0.0), (1.0, 0.0)], &()).unwrap();
    let asked = [(0.0, 0.0), (f64::NAN, 0.0)].map(Point::from);
    let is_second = |error| matches!(error, Error::NotFinite { index: 1, .. });
    assert!(is_second(nearest.nearest_all(&asked, &()).unwrap_err()));
    assert!(is_second(
        nearest.k_nearest_all(&asked, 2, &()).unwrap_err()
    ));
    for radius in [-1.0, f64::NAN, f64::INFINITY] {
        let error = nearest.within(asked[0], radius).unwrap_err();
        assert!(matches!(error, Error::BadRadius { given } if given.to_bits() == radius.to_bits()));
    }
    assert!(is_second(Nearest::of_points(asked, &()).unwrap_err()));
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
    let points = Kind::Uniform.points(30_000, 1);
    let nearest = Nearest::of_points(points.iter().copied(), &())
        .unwrap()
        .threads(2);
    let watcher = |most| Watcher {
        told: 0.into(),
        most,
    };
    let patient = watcher(u64::MAX);
    assert!(nearest.nearest_all(&points, &patient).is_ok());
    assert_eq!(patient.told.into_inner(), 30_000);
    assert_eq!(
        nearest.k_nearest_all(&points, 3, &watcher(5000)),
        Err(Error::Cancelled)
    );
}
