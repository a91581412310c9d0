//! Live editing: after every edit the triangulation is the one that would be made from scratch.
//!
//! The scripts of the test kit are compared step by step, with their vertices, constraints, chains and
//! refusals; here are the cases that deserve a name, and what scripts cannot say.

use delone::edit::{ConstraintId, EditError, Inserted, LiveTriangulation};
use delone::locate::Location;
use delone::{
    Angle, ConstrainedDelaunay, ConstrainedTriangulation, DomainRule, Point, Pslg, Quality,
    Refinement, SegmentPolicy, VertexId, triangulate,
};
use delone_testkit::fuzz::Case;
use delone_testkit::fuzz::edit::{Edit, Script, case, check};
use delone_testkit::generate::{Kind, Random};

fn v(i: usize) -> VertexId {
    VertexId::new(i)
}

fn require(script: &Script) {
    if let Err(reason) = check(script) {
        panic!("{reason}\n{}", script.as_source());
    }
}

fn points(coordinates: &[(f64, f64)]) -> Vec<Point> {
    coordinates.iter().map(|&p| p.into()).collect()
}

/// Inserts points, then removes all vertices in some order, then inserts them again.
fn down_and_up(start: &[Point], r: &mut Random) {
    let mut edits: Vec<_> = (0..start.len())
        .map(|_| Edit::Remove(r.below(1 << 16)))
        .collect();
    // Some more: from nothing nothing can be removed.
    edits.extend([Edit::Remove(0), Edit::Remove(1)]);
    let mut again = start.to_vec();
    r.shuffle(&mut again);
    edits.extend(again.into_iter().map(Edit::Insert));
    let start = start.to_vec();
    require(&Script { start, edits });
}

#[test]
fn every_kind_of_points_goes_down_to_nothing_and_up_again() {
    for kind in Kind::ALL {
        for seed in 0..6 {
            let mut r = Random::new(seed);
            down_and_up(&kind.points(30, seed), &mut r);
        }
    }
}

#[test]
fn every_kind_of_points_is_moved_about() {
    for kind in Kind::ALL {
        for seed in 0..6 {
            let r = &mut Random::new(seed);
            let edits = kind.points(40, seed + 100).into_iter();
            let edits = edits.map(|p| Edit::Move(r.below(1 << 16), p)).collect();
            let start = kind.points(20, seed);
            require(&Script { start, edits });
        }
    }
}

#[test]
fn random_scripts_on_lattices_and_worse() {
    let mut script = Script::default();
    for seed in 0..1500 {
        case(seed, 16, 40, &mut script);
        require(&script);
    }
}

/// Rows: all on one line, at any slope, with constraints upon it and points off it for a while.
#[test]
fn a_row_is_edited_at_its_ends_inside_and_off_it() {
    for (dx, dy) in [(1.0, 0.0), (0.0, 1.0), (1.0, 1.0), (-3.0, 1.0)] {
        let at = |t: f64| Point::new(dx * t, dy * t);
        let start: Vec<_> = (0..6).map(|t| at(f64::from(t))).collect();
        let edits = vec![
            Edit::Insert(at(2.5)),
            Edit::Insert(at(-1.0)),
            Edit::Insert(at(9.0)),
            Edit::Constrain(0, 4),
            Edit::Constrain(2, 8),
            Edit::Remove(1),
            Edit::Remove(3),
            Edit::Remove(0),
            Edit::Move(0, at(4.5)),
            Edit::Move(0, Point::new(1.0, 2.0)),
            Edit::Move(0, at(20.0)),
            Edit::Release(0),
            Edit::Release(0),
            Edit::Insert(Point::new(100.0, 3.0)),
            Edit::Remove(8),
            Edit::Remove(7),
            Edit::Remove(0),
            Edit::Remove(0),
            Edit::Remove(0),
            Edit::Remove(0),
            Edit::Remove(0),
            Edit::Remove(0),
            Edit::Insert(at(3.0)),
        ];
        require(&Script { start, edits });
    }
}

#[test]
fn a_vertex_on_the_hull_leaves_pockets_and_straight_edges() {
    // Five on the lower side, a crown above; every vertex once the first to go.
    let start = points(&[
        (0.0, 0.0),
        (1.0, 0.0),
        (2.0, 0.0),
        (3.0, 0.0),
        (4.0, 0.0),
        (2.0, 9.0),
        (1.0, 2.0),
        (2.0, 3.0),
        (3.0, 2.0),
        (2.0, 1.0),
    ]);
    for first in 0..start.len() {
        for second in 0..start.len() - 1 {
            let edits = vec![Edit::Remove(first), Edit::Remove(second), Edit::Remove(0)];
            require(&Script {
                start: start.clone(),
                edits,
            });
        }
    }
}

fn square_with_centre() -> (LiveTriangulation, [VertexId; 5]) {
    let mut live = LiveTriangulation::new();
    let corners = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0), (2.0, 2.0)];
    let corners = corners.map(|p| live.insert(p).expect("finite").vertex());
    (live, corners)
}

#[test]
fn ids_stay_and_come_back() {
    let (mut live, [a, b, ..]) = square_with_centre();
    assert_eq!(live.insert((4.0, 0.0)), Ok(Inserted::Duplicate(b)));
    assert_eq!(live.insert((4.0, -0.0)), Ok(Inserted::Duplicate(b)));
    assert_eq!(live.remove(b), Ok(Point::new(4.0, 0.0)));
    assert_eq!(live.remove(b), Err(EditError::NoVertex { vertex: b }));
    assert_eq!(live.point(b), None);
    assert_eq!(live.star(b).count(), 0);
    assert_eq!(live.remove(a), Ok(Point::new(0.0, 0.0)));
    assert_eq!(live.insert((7.0, 7.0)), Ok(Inserted::Vertex(a)));
    assert_eq!(live.insert((8.0, 7.0)), Ok(Inserted::Vertex(b)));
    assert_eq!(live.insert((9.0, 7.0)), Ok(Inserted::Vertex(v(5))));
    assert_eq!(live.num_vertices(), 6);
    for v in [VertexId::INFINITE, v(6), v(1000)] {
        assert_eq!(live.point(v), None);
        assert_eq!(
            live.move_to(v, (0.0, 0.0)),
            Err(EditError::NoVertex { vertex: v })
        );
        assert_eq!(
            live.add_constraint(a, v),
            Err(EditError::NoVertex { vertex: v })
        );
        assert!(live.constraints_ending_at(v).is_empty());
    }
}

#[test]
fn refusals_name_the_culprit_and_change_nothing() {
    let (mut live, [a, b, c, d, m]) = square_with_centre();
    let ac = live.add_constraint(a, c).expect("free");
    let before = live.hash();
    assert_eq!(
        live.add_constraint(b, b),
        Err(EditError::NoLength { vertex: b })
    );
    assert_eq!(
        live.remove(c),
        Err(EditError::IsEnd {
            vertex: c,
            constraint: ac
        })
    );
    let at = Point::new(0.0, 4.0);
    assert_eq!(
        live.move_to(a, at),
        Err(EditError::Occupied { vertex: d, at })
    );
    assert!(matches!(
        live.insert((f64::NAN, 0.0)),
        Err(EditError::NotFinite { .. })
    ));
    assert!(matches!(
        live.move_to(a, (0.0, f64::INFINITY)),
        Err(EditError::NotFinite { .. })
    ));
    let none = ConstraintId::new(7);
    assert_eq!(
        live.remove_constraint(none),
        Err(EditError::NoConstraint { constraint: none })
    );
    // Through the centre the diagonals may cross; then it has to stay where it is.
    let bd = live.add_constraint(b, d).expect("they meet in a vertex");
    let crossroads = EditError::Crossroads {
        vertex: m,
        constraints: [ac, bd],
    };
    assert_eq!(live.remove(m), Err(crossroads));
    assert_eq!(live.move_to(m, (1.0, 3.5)), Err(crossroads));
    assert_eq!(live.hash(), before);
    live.remove_constraint(bd).expect("there");
    live.remove(m).expect("a vertex in a constraint");
    let at = Point::new(2.0, 2.0);
    let crossing = EditError::Crossing {
        ends: [d, b],
        crossed: ac,
        at,
    };
    assert_eq!(live.add_constraint(d, b), Err(crossing));
    assert_eq!(
        crossing.to_string(),
        "a constraint from vertex 3 to 1 would cross constraint 0 at (2, 2)"
    );
}

#[test]
fn a_constraint_moves_with_its_end_or_not_at_all() {
    let (mut live, [a, b, c, d, m]) = square_with_centre();
    let wall = live.add_constraint(a, d).expect("free");
    let ray = live.add_constraint(m, b).expect("free");
    let twin = live.add_constraint(b, m).expect("along the other");
    let before = live.snapshot();
    let outcome = live.move_to(m, (-3.0, 1.0));
    assert!(matches!(
        outcome,
        Err(EditError::Crossing { ends, crossed, .. }) if ends == [b, m] && crossed == wall
    ));
    let after = live.snapshot();
    assert_eq!(before.constraints, after.constraints);
    assert_eq!(
        before.triangulation.segments(),
        after.triangulation.segments()
    );
    assert_eq!(live.point(m), Some(Point::new(2.0, 2.0)));
    live.move_to(m, (5.0, 8.0)).expect("free");
    for id in [ray, twin] {
        assert_eq!(live.chain(id).map(|chain| chain.len()), Some(2));
    }
    live.remove_constraint(ray).expect("there");
    let along: Vec<_> = live.constraints_ending_at(m);
    assert_eq!(along, [twin]);
    assert_eq!(live.remove(c), Ok(Point::new(4.0, 4.0)));
}

/// What fails in the middle of an inner transaction undoes that one; the outer one goes on.
#[test]
fn transactions_nest() {
    let (mut live, [a, b, c, d, m]) = square_with_centre();
    let before = live.hash();
    let outcome = live.transaction(|live| {
        let ac = live.add_constraint(a, c)?;
        let inner = live.transaction(|live| {
            live.move_to(m, (1.0, 3.0))?;
            live.insert((0.5, 0.5))?;
            live.add_constraint(b, d)
        });
        assert!(matches!(inner, Err(EditError::Crossing { .. })));
        assert_eq!(live.chain(ac), Some(vec![a, m, c]));
        assert_eq!(live.num_vertices(), 5);
        live.remove(m)
    });
    assert_eq!(outcome, Ok(Point::new(2.0, 2.0)));
    let outcome: Result<(), &str> = live.transaction(|live| {
        let again = live.insert((2.0, 2.0)).map_err(|_| "not inserted")?;
        assert_eq!(again, Inserted::Vertex(m));
        live.remove_constraint(ConstraintId::new(0))
            .map_err(|_| "not removed")?;
        live.remove(a).map_err(|_| "not removed")?;
        Err("enough")
    });
    assert_eq!(outcome, Err("enough"));
    assert_eq!((live.num_vertices(), live.num_constraints()), (4, 1));
    assert_eq!(live.hash(), before_without_centre());
    assert_ne!(live.hash(), before);
}

fn before_without_centre() -> delone::TriangulationHash {
    let mut square = Pslg::from_points([(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)]);
    square.add_segment(0, 2);
    let t = ConstrainedDelaunay::new().triangulate(square);
    t.expect("a square").triangulation().hash()
}

#[test]
fn everything_is_located() {
    let mut live = LiveTriangulation::new();
    assert_eq!(live.locate((1.0, 1.0)), None);
    let a = live.insert((1.0, 1.0)).expect("finite").vertex();
    assert_eq!(live.locate((1.0, 1.0)), Some(Location::Vertex(a)));
    assert_eq!(live.locate((1.0, 2.0)), None);
    assert_eq!(live.locate((f64::NAN, 2.0)), None);
    let b = live.insert((3.0, 1.0)).expect("finite").vertex();
    let ends = |live: &LiveTriangulation, h| [live.mesh().origin(h), live.mesh().dest(h)];
    let on_edge = live.locate((2.0, 1.0));
    assert!(matches!(on_edge, Some(Location::Edge(h)) if ends(&live, h).contains(&b)));
    let beyond = live.locate((4.0, 1.0));
    assert!(
        matches!(beyond, Some(Location::Beyond(h)) if ends(&live, h) == [b, VertexId::INFINITE])
    );
    let above = live.locate((9.0, 2.0));
    assert!(matches!(above, Some(Location::Outside(h)) if ends(&live, h) == [a, b]));
    live.insert((2.0, 3.0)).expect("finite");
    assert!(matches!(live.locate((2.0, 2.0)), Some(Location::Face(_))));
    assert_eq!(live.triangles().count(), 1);
    let t = live.mesh().triangles().next().expect("one");
    assert_eq!(live.neighbors(t), [None; 3]);
}

/// Where edges are constrained, a visibility walk may run in circles. Every point of a fine lattice is
/// looked for from wherever the search begins.
#[test]
fn locations_agree_with_orientation_among_constraints() {
    use delone::predicates::{Orientation, orient2d};
    let mut live = LiveTriangulation::new();
    let r = &mut Random::new(5);
    let ids: Vec<_> = Kind::Lattice { side: 8 }
        .points(40, 3)
        .into_iter()
        .map(|p| live.insert(p).expect("finite").vertex())
        .collect();
    for _ in 0..200 {
        let _ = live.add_constraint(r.choose(&ids), r.choose(&ids));
    }
    assert!(live.num_constraints() > 20);
    let point = |v| live.point(v).expect("a vertex");
    for i in 0..37 * 37 {
        let p = Point::new(f64::from(i % 37) / 4.0 - 1.0, f64::from(i / 37) / 4.0 - 1.0);
        let mesh = live.mesh();
        let side = |h| orient2d(point(mesh.origin(h)), point(mesh.dest(h)), p);
        match live.locate(p).expect("many vertices") {
            Location::Vertex(v) => assert_eq!(point(v), p),
            Location::Face(t) => {
                assert!(t.half_edges().iter().all(|&h| side(h) == Orientation::Left))
            }
            Location::Edge(h) => {
                let [a, b] = [mesh.origin(h), mesh.dest(h)].map(point);
                assert!(delone::predicates::is_between(a, b, p));
            }
            Location::Outside(h) => {
                assert!(mesh.apex(h).is_infinite() && side(h) == Orientation::Left);
            }
            Location::Beyond(_) => panic!("{p:?} is beyond a row"),
        }
    }
}

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
