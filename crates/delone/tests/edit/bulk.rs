//! From results of builders to live triangulations, large ones too, and back.

use super::v;
use delone::edit::{ConstraintId, Inserted, LiveTriangulation};
use delone::{
    Angle, ConstrainedDelaunay, ConstrainedTriangulation, DomainRule, Point, Pslg, Quality,
    Refinement, SegmentPolicy, VertexId, triangulate,
};
use delone_testkit::generate::{Kind, Random};

/// What would be made of the points and constraints from scratch.
fn from_scratch(live: &LiveTriangulation) -> ConstrainedTriangulation {
    let snapshot = live.snapshot();
    let points = snapshot
        .vertices
        .iter()
        .map(|&v| live.point(v).expect("a vertex"));
    let mut pslg = Pslg::from_points(points);
    let place = |v: VertexId| snapshot.vertices.binary_search(&v).expect("a live vertex");
    for &id in &snapshot.constraints {
        let [a, b] = live.constraint(id).expect("a constraint").map(place);
        pslg.add_segment(a as u32, b as u32);
    }
    ConstrainedDelaunay::new()
        .triangulate(pslg)
        .expect("a planar drawing")
}

fn require_canonical(live: &LiveTriangulation) {
    let fresh = from_scratch(live);
    let snapshot = live.snapshot();
    let mine = &snapshot.triangulation;
    mine.triangulation().mesh().validate().expect("a sphere");
    assert_eq!(live.hash(), fresh.triangulation().hash());
    assert_eq!(live.hash(), mine.triangulation().hash());
    assert_eq!(
        mine.triangulation().points(),
        fresh.triangulation().points()
    );
    assert_eq!(
        mine.triangulation().num_hull_edges(),
        fresh.triangulation().num_hull_edges()
    );
    assert_eq!(mine.segments(), fresh.segments());
    for segment in 0..mine.segments().len() {
        assert_eq!(mine.chain(segment), fresh.chain(segment));
    }
    assert_eq!(
        mine.constrained_edges().count(),
        fresh.constrained_edges().count()
    );
}

/// Removes, moves and inserts a while, wherever it is allowed.
fn edit_at_random(live: &mut LiveTriangulation, edits: usize, r: &mut Random) {
    for _ in 0..edits {
        let live_ids: Vec<_> = live.vertices().collect();
        let p = Point::new(4.0 * r.unit(), 4.0 * r.unit());
        let some = r.choose(&live_ids);
        match r.below(5) {
            0 => drop(live.insert(p)),
            1 => drop(live.remove(some)),
            2 => drop(live.move_to(some, p)),
            3 => drop(live.add_constraint(some, r.choose(&live_ids))),
            _ => {
                let first = live.constraints().next();
                let _ = first.map(|id| live.remove_constraint(id));
            }
        }
    }
}

fn drawing() -> Pslg {
    let mut pslg = Pslg::from_points([
        (0.0, 0.0),
        (4.0, 0.0),
        (4.0, 3.0),
        (2.0, 1.0),
        (0.0, 4.0),
        (4.0, 0.0),
        (1.0, 0.0),
        (3.7, 2.9),
    ]);
    pslg.add_ring([0, 1, 2, 3, 4]);
    for [a, b] in [[0, 7], [4, 5], [3, 3], [0, 1]] {
        pslg.add_segment(a, b);
    }
    pslg
}

#[test]
fn domains_that_were_cut_and_carved_go_on_living() {
    let t = ConstrainedDelaunay::new()
        .domain(DomainRule::Carve)
        .crossings(SegmentPolicy::Split)
        .triangulate(drawing())
        .expect("a drawing");
    assert!(t.triangulation().is_carved() && t.num_crossings() > 0);
    let (mut live, of_segments) = LiveTriangulation::from_constrained(&t);
    require_canonical(&live);
    assert_eq!(of_segments.len(), t.segments().len());
    // Through vertex 6, exactly; crossed, so in pieces; without length.
    assert_eq!(of_segments[0].len(), 1);
    let first = ConstraintId::new(of_segments[0].start);
    assert_eq!(live.chain(first), Some(t.chain(0).to_vec()));
    assert!(of_segments[5].len() > 1 && of_segments[7].is_empty());
    // Vertex 5 was merged into vertex 1.
    assert_eq!(
        (live.point(v(5)), live.num_vertices()),
        (None, t.triangulation().num_vertices())
    );
    assert_eq!(live.insert((9.0, 9.0)), Ok(Inserted::Vertex(v(5))));
    let r = &mut Random::new(1);
    for _ in 0..20 {
        edit_at_random(&mut live, 10, r);
        require_canonical(&live);
    }
}

#[test]
fn refined_meshes_go_on_living() {
    let mut outline =
        Pslg::from_points([(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (2.0, 4.0), (0.0, 3.0)]);
    outline.add_ring([0, 1, 2, 3, 4]);
    let quality = Quality {
        min_angle: Some(Angle::degrees(30.0)),
        max_edge: Some(0.5),
        ..Quality::default()
    };
    let refined = Refinement::new(quality)
        .domain(DomainRule::Carve)
        .mesh(outline);
    let refined = refined.expect("an outline");
    let (mut live, _) = LiveTriangulation::from_constrained(&refined.mesh);
    require_canonical(&live);
    let r = &mut Random::new(2);
    for _ in 0..10 {
        edit_at_random(&mut live, 20, r);
        require_canonical(&live);
    }
}

#[test]
fn without_its_constraints_a_domain_is_delaunay() {
    let t = ConstrainedDelaunay::new()
        .crossings(SegmentPolicy::Split)
        .domain(DomainRule::Carve)
        .triangulate(drawing())
        .expect("a drawing");
    let live = LiveTriangulation::from_triangulation(t.triangulation());
    let fresh = triangulate(t.triangulation().points().iter().copied()).expect("finite");
    assert_eq!(live.hash(), fresh.hash());
    assert_ne!(live.hash(), t.triangulation().hash());
}

/// The hub of a wheel: flips alone would need a number that is quadratic.
#[test]
fn a_hub_with_many_spokes_comes_and_goes() {
    let n = 20_000;
    let circle = Kind::Circle.points(n, 1);
    let t = triangulate(circle.iter().copied()).expect("finite");
    let mut live = LiveTriangulation::from(&t);
    let hub = live.insert((0.0, 0.0)).expect("finite").vertex();
    assert!(live.star(hub).count() > n / 2);
    live.remove(hub).expect("a vertex");
    assert_eq!(live.hash(), t.hash());
    // On the hull, too: everything is seen from far away.
    let far = live.insert((50.0, 0.0)).expect("finite").vertex();
    live.move_to(far, (-1e9, 1e-9)).expect("a vacant place");
    live.remove(far).expect("a vertex");
    assert_eq!(live.hash(), t.hash());
}

/// Two smooth curves that face each other across a chord: flips alone would take seconds.
#[test]
fn a_chord_between_curves_comes_and_goes() {
    let n = 8000;
    let arc = |i: i32| {
        let x = f64::from(i) / f64::from(n);
        (x, 0.01 + 0.3 * x * (1.0 - x))
    };
    let mut points: Vec<_> = (1..n).map(arc).collect();
    points.extend((1..n).map(arc).map(|(x, y)| (x + 1e-6, -y)));
    points.extend([(0.0, 0.0), (1.1, 0.0)]);
    let [a, b] = [2, 1].map(|k| v(points.len() - k));
    let t = triangulate(points).expect("finite");
    let mut live = LiveTriangulation::from(&t);
    let chord = live.add_constraint(a, b).expect("free");
    assert_ne!(live.hash(), t.hash());
    require_canonical(&live);
    assert_eq!(live.remove_constraint(chord), Ok([a, b]));
    assert_eq!(live.hash(), t.hash());
    // What was made from scratch goes on like any other.
    live.remove(a).expect("a vertex");
    require_canonical(&live);
}

#[test]
fn a_large_one_stays_canonical() {
    let points = Kind::Uniform.points(20_000, 7);
    let t = triangulate(points.iter().copied()).expect("finite");
    let mut live = LiveTriangulation::from(&t);
    let r = &mut Random::new(3);
    let some: Vec<_> = (0..300).map(|_| v(r.below(points.len()))).collect();
    let added = some
        .chunks_exact(2)
        .filter_map(|pair| live.add_constraint(pair[0], pair[1]).ok());
    let added: Vec<_> = { added }.collect();
    assert!(added.len() > 3);
    for _ in 0..3000 {
        let p = Point::new(r.unit(), r.unit());
        let k = v(r.below(points.len()));
        match r.below(3) {
            0 => drop(live.insert(p)),
            1 => drop(live.remove(k)),
            _ => drop(live.move_to(k, p)),
        }
    }
    require_canonical(&live);
    for id in added {
        live.remove_constraint(id).expect("there");
    }
    require_canonical(&live);
}
