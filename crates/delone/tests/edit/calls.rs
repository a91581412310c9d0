//! What calls return: ids, refusals, locations; and transactions.

use super::v;
use delone::edit::{ConstraintId, EditError, Inserted, LiveTriangulation};
use delone::locate::Location;
use delone::predicates::{Orientation, is_between, orient2d};
use delone::{ConstrainedDelaunay, Point, Pslg, TriangulationHash, VertexId};
use delone_testkit::generate::{Kind, Random};

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
        assert_eq!(
            live.add_constraint(v, a),
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

fn before_without_centre() -> TriangulationHash {
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
                assert!(is_between(a, b, p));
            }
            Location::Outside(h) => {
                assert!(mesh.apex(h).is_infinite() && side(h) == Orientation::Left);
            }
            location => panic!("{p:?} is {location:?}, but there are triangles and no domain"),
        }
    }
}
