//! What must hold of results: one for all orders, that of Delaunay without weights, the laws of weights,
//! errors, and many sites.

use crate::sites::{Weights, everywhere, shuffled, sites};
use crate::{Site, built, hidden, hull, triangles};
use delone::predicates::{Weighted, power_center};
use delone::regular::{self, WeightedDelaunay};
use delone::{Error, Phase, Point, TriangleId, VertexId, Watch, triangulate};
use delone_testkit::generate::{Kind, Random};
use std::sync::atomic::{AtomicBool, Ordering};

#[test]
fn one_result_for_all_orders() {
    everywhere(0..60, 6, |sites, name| {
        let first = built(sites);
        for seed in 0..3 {
            let (sites, order) = shuffled(sites, seed);
            let other = built(&sites);
            let hash = first.triangulation().hash();
            assert_eq!(other.triangulation().hash(), hash, "{name}: {sites:?}");
            // Of sites that are equal in all, the lowest index stands for them: compare what they are.
            let of = |hidden: Vec<usize>, place: &dyn Fn(usize) -> Site| {
                let mut list: Vec<_> = hidden.into_iter().map(place).collect();
                list.sort_by(|(p, v), (q, w)| p.lex_cmp(q).then(v.total_cmp(w)));
                list
            };
            let given = |i: usize| sites[order.iter().position(|&o| o == i).expect("all")];
            assert_eq!(
                of(hidden(&first), &given),
                of(hidden(&other), &|i| sites[i]),
                "{name}"
            );
        }
    });
}

#[test]
fn without_weights_it_is_the_delaunay_triangulation() {
    for kind in Kind::ALL {
        for (n, seed) in (0..40).map(|i| (i as usize, i)).chain([(3000, 1)]) {
            let points = kind.points(n, seed);
            let delaunay = triangulate(points.iter().copied()).expect("finite");
            for weight in [0.0, -7.5, f64::MAX] {
                let sites: Vec<Site> = points.iter().map(|&p| (p, weight)).collect();
                let t = built(&sites);
                let found = t.triangulation();
                assert_eq!(found.hash(), delaunay.hash(), "{kind:?} {n} {seed}");
                assert_eq!(found.num_vertices(), delaunay.num_vertices());
                assert_eq!(found.num_edges(), delaunay.num_edges());
                let dropped = delaunay.duplicates().iter().map(|d| d.dropped.index());
                assert_eq!(hidden(&t), dropped.collect::<Vec<_>>());
                assert_eq!(found.hull().count(), delaunay.hull().count());
            }
        }
    }
}

/// Heights on one plane are all tied: then the points of each set are a triangulation in which the
/// perturbation alone decides, and adding a linear function to all weights changes nothing.
#[test]
fn linear_functions_of_place_change_nothing() {
    for seed in 0..300 {
        let sites = sites(Kind::Lattice { side: 5 }, Weights::Few(4), 20, seed);
        let mut r = Random::new(seed);
        let [u, v, w] = [0; 3].map(|_| r.below(9) as f64 - 4.0);
        let tilted: Vec<Site> = sites
            .iter()
            .map(|&(p, weight)| (p, weight + u * p.x + v * p.y + w))
            .collect();
        assert_eq!(triangles(&built(&tilted)), triangles(&built(&sites)));
        assert_eq!(hidden(&built(&tilted)), hidden(&built(&sites)));
    }
}

#[test]
fn powers_of_two_change_nothing() {
    for (seed, exponent) in (0..200).zip((-260..260).step_by(13).cycle()) {
        let scale = 2_f64.powi(exponent);
        let sites = sites(Kind::Lattice { side: 4 }, Weights::Few(5), 16, seed);
        let scaled: Vec<Site> = sites
            .iter()
            .map(|&(p, w)| (Point::new(p.x * scale, p.y * scale), w * scale * scale))
            .collect();
        assert_eq!(triangles(&built(&scaled)), triangles(&built(&sites)));
        assert_eq!(hidden(&built(&scaled)), hidden(&built(&sites)));
    }
}

#[test]
fn a_tie_leaves_a_site_visible() {
    let site = |x: f64, y: f64, w: f64| (Point::new(x, y), w);
    let corners = [
        site(0.0, 0.0, 0.0),
        site(4.0, 0.0, 0.0),
        site(0.0, 4.0, 0.0),
    ];
    // In the triangle, and on its edges, of which the last gets a triangle on the other side.
    let ties = [
        ((1.0, 1.0), -6.0),
        ((1.0, 0.0), -3.0),
        ((0.0, 2.0), -4.0),
        ((2.0, 2.0), -8.0),
    ];
    for (p, tie) in ties {
        let weights = [tie + 0.5, tie, f64::next_down(tie), tie - 0.5];
        for (weight, count) in weights.into_iter().zip([0, 0, 1, 1]) {
            let mut sites = corners.to_vec();
            sites.push(site(p.0, p.1, weight));
            assert_eq!(hidden(&built(&sites)).len(), count, "{p:?} {weight}");
            sites.push(site(5.0, 5.0, -20.0));
            assert_eq!(hidden(&built(&sites)).len(), count, "{p:?} {weight}");
        }
    }
}

/// A site on a hull edge that hides the corner of another edge on the same line, from beyond its end.
#[test]
fn heavy_sites_hide_what_lies_on_their_line() {
    let row = [0.0, 1.0, 2.0, 3.0].map(|x| (Point::new(x, 0.0), 0.0));
    for apex in [Some((Point::new(0.0, 9.0), -100.0)), None] {
        let mut sites: Vec<Site> = row.into_iter().chain(apex).collect();
        sites.push((Point::new(4.0, 0.0), 6.0));
        let t = built(&sites);
        // The chord from (2, 4) to (4, 16 − 6) passes below (3, 9), that from (1, 1) through (2, 4).
        assert_eq!(hidden(&t), [3], "{apex:?}");
        let expected = if apex.is_some() { 5 } else { 6 };
        assert_eq!(hull(&t).len(), expected);
    }
}

#[test]
fn none_one_and_two() {
    let t = built(&[]);
    assert_eq!((t.triangulation().num_vertices(), t.hidden().len()), (0, 0));
    let p = Point::new(1.0, 2.0);
    let t = built(&[(p, 1.0), (p, 3.0), (p, 3.0)]);
    assert_eq!(
        (t.triangulation().num_vertices(), hidden(&t)),
        (1, vec![0, 2])
    );
    let t = built(&[(p, 1.0), (Point::new(0.0, 0.0), 1e300)]);
    assert_eq!((t.triangulation().num_vertices(), t.hidden().len()), (2, 0));
    assert_eq!(t.triangulation().num_edges(), 1);
}

#[test]
fn culprits_are_named() {
    let sites = |w: f64| [((0.0, 0.0), 1.0), ((1.0, 0.0), w)];
    for weight in [f64::INFINITY, f64::NEG_INFINITY] {
        let error = regular::triangulate(sites(weight)).expect_err("infinite");
        assert_eq!(error, Error::BadWeight { index: 1, weight });
    }
    let error = regular::triangulate(sites(f64::NAN)).expect_err("NaN");
    assert!(matches!(error, Error::BadWeight { index: 1, .. }));
    let error = regular::triangulate([((0.0, f64::INFINITY), 0.0)]).expect_err("infinite");
    assert!(matches!(error, Error::NotFinite { index: 0, .. }));
}

/// Cancels when triangulating has begun.
#[derive(Default)]
struct Impatient {
    enough: AtomicBool,
}

impl Watch for Impatient {
    fn progress(&self, phase: Phase, done: u64, _total: u64) {
        if phase == Phase::Triangulate && done > 0 {
            self.enough.store(true, Ordering::Relaxed);
        }
    }

    fn is_cancelled(&self) -> bool {
        self.enough.load(Ordering::Relaxed)
    }
}

#[test]
fn whoever_watches_may_cancel() {
    for kind in [Kind::Uniform, Kind::Collinear] {
        let points = kind.points(20_000, 1).into_iter().enumerate();
        // Apart from each other, on one line too.
        let sites = points.map(|(i, p)| match kind {
            Kind::Collinear => (Point::new(i as f64, 0.0), 0.0),
            _ => (p, 0.0),
        });
        let watch = Impatient::default();
        let error = WeightedDelaunay::new().watch(&watch).triangulate(sites);
        assert_eq!(error.expect_err("cancelled"), Error::Cancelled);
    }
}

/// Neighbours across every edge, and hidden sites under their triangles: the local conditions that
/// imply the global one, on sets too large for oracles.
#[test]
fn many_sites_are_locally_regular() {
    for (kind, weights) in [
        (Kind::Uniform, Weights::Even),
        (Kind::Uniform, Weights::Few(2)),
        (Kind::Lattice { side: 100 }, Weights::Few(3)),
        (Kind::Lattice { side: 300 }, Weights::Plane),
        (Kind::Clusters, Weights::Even),
        (Kind::WideExponents, Weights::Any),
    ] {
        let mut sites = sites(kind, weights, 20_000, 5);
        if weights == Weights::Even {
            sites.iter_mut().for_each(|(_, w)| *w *= 1e-3);
        }
        let t = built(&sites);
        let mesh = t.triangulation().mesh();
        for h in mesh.half_edges() {
            let (face, beyond) = (h.triangle(), mesh.twin(h).triangle());
            if mesh.is_ghost(face) || mesh.is_ghost(beyond) {
                continue;
            }
            let [a, b, c] = mesh.corners(face).map(|v| t.site(v));
            let d = t.site(mesh.apex(mesh.twin(h)));
            assert!(
                !delone::predicates::in_power_circle_perturbed(a, b, c, d),
                "{kind:?}"
            );
        }
        assert_hidden_lie_above(&t);
        let expected = hidden(&t).len() + t.triangulation().num_vertices();
        assert_eq!(expected, sites.len());
    }
}

fn assert_hidden_lie_above(t: &regular::Regular) {
    use delone::locate::{Location, locate};
    use delone::predicates::{CircleSide, in_power_circle};
    let mesh = t.triangulation().mesh();
    let hint = TriangleId::new(0).half_edges()[0];
    for &v in t.hidden().iter().step_by(7) {
        let site = t.site(v);
        match locate(mesh, t.triangulation().points(), hint, site.point) {
            Location::Vertex(u) => assert!(t.site(u).weight >= site.weight),
            Location::Face(face) => {
                let [a, b, c] = mesh.corners(face).map(|v| t.site(v));
                assert_eq!(in_power_circle(a, b, c, site), CircleSide::Outside);
            }
            Location::Edge(_) => {}
            other => panic!("{v:?} is hidden {other:?}"),
        }
    }
}

#[test]
fn power_centers_are_the_circumcenters_of_equal_weights_and_equally_far_from_all() {
    let t = built(&[
        (Point::new(0.0, 0.0), 4.0),
        (Point::new(6.0, 0.0), 1.0),
        (Point::new(0.0, 8.0), 9.0),
    ]);
    let center = t.power_center(TriangleId::new(0));
    let power = |v: usize| {
        let Weighted { point: p, weight } = t.site(VertexId::new(v));
        (center.x - p.x).powi(2) + (center.y - p.y).powi(2) - weight
    };
    assert!((power(0) - power(1)).abs() < 1e-12 && (power(0) - power(2)).abs() < 1e-12);
    let [a, b, c] = [(-1.0, 0.0), (3.0, 0.0), (1.0, 1.0)].map(|p| Weighted::new(p, 0.1));
    assert_eq!(power_center(a, b, c), Some(Point::new(1.0, -1.5)));
    assert_eq!(power_center(a, a, c), None);
}
