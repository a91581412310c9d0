//! The lecture's half-edges, predicates and flip, and the slides' bounding triangle, against their examples.

use delone::classic::{bounding_triangle, printed_bounding_triangle};
use delone::predicates::{CircleSide, Orientation, in_circle, in_circle_perturbed, orient2d};
use delone::{HalfEdgeId, Mesh, Point, VertexId, triangulate};
use delone_testkit::generate::{Kind, Random};
use serde_json::Value;
use std::collections::BTreeMap;

fn facts() -> Value {
    let text = include_str!("../data/lecture/003-properties.json");
    serde_json::from_str(text).expect("a fixture")
}

fn points(value: &Value) -> Vec<Point> {
    let points: Vec<[f64; 2]> = serde_json::from_value(value.clone()).expect("points");
    points.into_iter().map(Point::from).collect()
}

/// The half-edge from `a` to `b`.
fn half_edge(mesh: &Mesh, a: VertexId, b: VertexId) -> HalfEdgeId {
    let mut all = mesh.half_edges();
    all.find(|&h| mesh.origin(h) == a && mesh.dest(h) == b)
        .expect("there is such an edge")
}

/// The square with the diagonal ac, and its half-edge ac; a, b, c, d are 0, 1, 2, 3.
fn square() -> (Mesh, HalfEdgeId) {
    let [a, b, c, d] = [0, 1, 2, 3].map(VertexId::new);
    let mut mesh = Mesh::default();
    let ac = mesh.seed(a, c);
    mesh.split_face(ac.triangle(), d);
    let ca = half_edge(&mesh, c, a);
    mesh.split_face(ca.triangle(), b);
    mesh.validate().expect("two triangles");
    let ac = half_edge(&mesh, a, c);
    (mesh, ac)
}

/// Names a half-edge by its ends: "ac".
fn name(mesh: &Mesh, h: HalfEdgeId) -> String {
    let letter = |v: VertexId| "abcd".as_bytes()[v.index()] as char;
    [mesh.origin(h), mesh.dest(h)].map(letter).iter().collect()
}

/// Names the finite faces, each from its first letter.
fn faces(mesh: &Mesh) -> Vec<String> {
    let first = |t: delone::TriangleId| {
        let h = t.half_edges().into_iter().min_by_key(|&h| mesh.origin(h));
        let mut letters = name(mesh, h.expect("three"));
        letters.push(name(mesh, h.expect("three").next()).remove(1));
        letters
    };
    let mut faces: Vec<_> = mesh.triangles().map(first).collect();
    faces.sort();
    faces
}

/// Reads the faces of the example in the same way.
fn expected_faces(value: &Value) -> Vec<String> {
    let rows: Vec<Vec<String>> = serde_json::from_value(value.clone()).expect("faces");
    let mut faces: Vec<_> = rows
        .into_iter()
        .map(|mut corners| {
            let first = (0..3).min_by_key(|&k| corners[k].clone());
            corners.rotate_left(first.expect("three corners"));
            corners.concat()
        })
        .collect();
    faces.sort();
    faces
}

#[test]
fn flip_makes_the_cycles_of_the_lecture() {
    let facts = &facts()["flip"];
    let (mut mesh, ac) = square();
    assert_eq!(faces(&mesh), expected_faces(&facts["before"]));
    let ca = mesh.twin(ac);
    mesh.flip(ac);
    mesh.validate().expect("flipped");
    assert_eq!(faces(&mesh), expected_faces(&facts["after"]));
    let next: BTreeMap<String, String> =
        serde_json::from_value(facts["next"].clone()).expect("next");
    assert_eq!(next.len(), 6);
    for h in mesh.triangles().flat_map(delone::TriangleId::half_edges) {
        assert_eq!(next[&name(&mesh, h)], name(&mesh, h.next()));
    }
    // What was ac and ca are now the edges that the nodes a and c point to, and bd = g follows ab.
    assert_eq!(facts["node_edge"]["a"], name(&mesh, ac));
    assert_eq!(facts["node_edge"]["c"], name(&mesh, ca));
    let g = ac.next();
    assert_eq!(facts["returns"], name(&mesh, g));
    let recursion = [(g.next().next(), ac), (mesh.twin(g).next(), ca.prev())];
    for (i, (lecture, ours)) in recursion.into_iter().enumerate() {
        assert_eq!(lecture, ours);
        let stated = facts["restore_recursion"][i].as_str().expect("text");
        assert!(stated.contains(&name(&mesh, ours)), "{stated}");
    }
}

#[test]
fn half_edges_keep_the_invariants_of_the_lecture() {
    for kind in Kind::ALL {
        let t = triangulate(kind.points(40, 8)).expect("finite");
        let mesh = t.mesh();
        for h in mesh.half_edges() {
            assert_eq!(mesh.twin(mesh.twin(h)), h);
            assert_eq!(mesh.origin(mesh.twin(h)), mesh.origin(h.next()));
            assert_eq!(h.next().next().next(), h);
            assert!(mesh.star(h).all(|g| mesh.origin(g) == mesh.origin(h)));
        }
        let Some(ghost) = mesh.ghosts().next() else {
            continue;
        };
        let outer: Vec<_> = mesh.hull(mesh.hull_edge_of(ghost)).collect();
        assert_eq!(outer.len(), mesh.ghosts().count());
        for (i, &h) in outer.iter().enumerate() {
            // Listed counter-clockwise, each ends where the one before began: they run clockwise.
            let before = outer[(i + outer.len() - 1) % outer.len()];
            assert_eq!(mesh.dest(h), mesh.origin(before));
        }
    }
}

#[test]
fn predicates_have_the_signs_of_the_examples() {
    for case in facts()["predicates"].as_array().expect("cases") {
        let points = points(&case["points"]);
        let sign = match (case["kind"].as_str().expect("kind"), &points[..]) {
            ("orient", &[a, b, c]) => match orient2d(a, b, c) {
                Orientation::Left => 1,
                Orientation::Collinear => 0,
                Orientation::Right => -1,
            },
            ("incircle_ccw", &[a, b, c, d]) => match in_circle(a, b, c, d) {
                CircleSide::Inside => 1,
                CircleSide::On => 0,
                CircleSide::Outside => -1,
            },
            other => panic!("{other:?}"),
        };
        assert_eq!(case["sign"], sign, "{case}");
    }
}

#[test]
fn orientation_is_the_sign_of_the_sum_of_trapezoids() {
    let twice_area = |[a, b, c]: [[i64; 2]; 3]| {
        let trapezoid = |p: [i64; 2], q: [i64; 2]| (q[0] - p[0]) * (q[1] + p[1]);
        trapezoid(a, c) + trapezoid(c, b) + trapezoid(b, a)
    };
    let example = &facts()["orientation_formula"]["example"];
    let corner = |name| serde_json::from_value(example[name as &str].clone()).expect("a point");
    assert_eq!(
        example["twice_area"],
        twice_area(["a", "b", "c"].map(corner))
    );
    let mut random = Random::new(3);
    for _ in 0..2000 {
        let corners = [(); 3].map(|()| [(); 2].map(|()| random.below(7) as i64 - 3));
        let [a, b, c] = corners.map(|[x, y]| Point::new(x as f64, y as f64));
        let expected = match twice_area(corners).signum() {
            1 => Orientation::Left,
            0 => Orientation::Collinear,
            _ => Orientation::Right,
        };
        assert_eq!(orient2d(a, b, c), expected);
    }
}

#[test]
fn an_edge_is_judged_alike_from_both_sides_and_convex_if_it_fails() {
    let mut random = Random::new(4);
    for _ in 0..5000 {
        let corners = [(); 4].map(|()| [(); 2].map(|()| random.below(5) as f64));
        let [a, b, c, d] = corners.map(Point::from);
        let turns = [orient2d(a, b, c), orient2d(a, c, d)];
        if turns != [Orientation::Left; 2] {
            continue;
        }
        let fails = in_circle_perturbed(a, b, c, d);
        assert_eq!(fails, in_circle_perturbed(a, c, d, b));
        if fails {
            let admissible = [orient2d(a, b, d), orient2d(b, c, d)];
            assert_eq!(admissible, [Orientation::Left; 2], "{corners:?}");
        }
    }
}

/// Lists the points that are not in the closed triangle.
fn outside(triangle: [Point; 3], points: &[Point]) -> Vec<Point> {
    let [a, b, c] = triangle;
    let is_right = |p, [a, b]: [Point; 2]| orient2d(a, b, p) == Orientation::Right;
    let sides = [[a, b], [b, c], [c, a]];
    let is_outside = |p: &&Point| sides.iter().any(|&side| is_right(**p, side));
    points.iter().filter(is_outside).copied().collect()
}

#[test]
fn the_printed_bounding_triangle_leaves_corners_out_and_ours_none() {
    let text = include_str!("../data/lecture/002-bounding-triangle.json");
    let facts: Value = serde_json::from_str(text).expect("a fixture");
    let example = &facts["counterexample"];
    let square = points(&example["points"]);
    let printed = printed_bounding_triangle(&square).expect("points");
    assert_eq!(printed.to_vec(), points(&example["triangle"]));
    let mut left_out = outside(printed, &square);
    left_out.sort_by(Point::lex_cmp);
    assert_eq!(left_out, points(&example["outside"]));
    assert_eq!(
        outside(bounding_triangle(&square).expect("small"), &square),
        []
    );
}

#[test]
fn a_bounding_triangle_contains_all_points_or_there_is_none() {
    for kind in Kind::ALL {
        for n in [1, 2, 3, 20] {
            let points = kind.points(n, 5);
            let Some(triangle) = bounding_triangle(&points) else {
                let large = |p: &Point| p.x.abs().max(p.y.abs()) > 1e307;
                assert!(points.iter().any(large), "{kind:?}");
                continue;
            };
            assert_eq!(outside(triangle, &points), [], "{kind:?}");
        }
    }
    let far = [Point::new(1e300, -1e300)];
    assert_eq!(outside(bounding_triangle(&far).expect("room"), &far), []);
}
