//! What is found at places, against who looks at everything.

use super::*;
use crate::drawing::Drawing;
use crate::mesh::Mesh;
use crate::play::Player;
use delone::Triangulation;
use delone::predicates::length_up;
use serde::Deserialize;

#[derive(Deserialize)]
struct Found {
    vertex: usize,
    distance: f64,
    walk: Vec<usize>,
}

fn of(t: &Triangulation) -> Looker {
    Looker::of(t.points().iter().copied(), t.triangles().iter().copied())
}

/// Triangulations with and without cocircular and collinear points, and a domain with holes.
fn scenes() -> Vec<Triangulation> {
    let presets = [
        "uniform",
        "grid",
        "cocircular",
        "collinear",
        "f32-duplicates",
        "lake",
    ];
    let scene = |name| {
        let drawing = Drawing::preset(name, 60, 1).expect(name);
        let mesh = match name {
            "lake" => Mesh::constrain(&drawing, None, None),
            _ => Mesh::triangulate(&drawing, None),
        };
        mesh.expect(name).triangulation().clone()
    };
    presets.map(scene).to_vec()
}

/// Places within and beyond: the points themselves, between them, and a lattice over all.
fn places(points: &[Point]) -> Vec<Point> {
    let [low, high] = crate::save::around(points);
    let lattice = (0..=120).map(|i| {
        let share = |n: i32| f64::from(n) / 10.0;
        let [s, t] = [share(i % 11), share(i / 11)];
        Point::new(low.x + s * (high.x - low.x), low.y + t * (high.y - low.y))
    });
    let middles = points.windows(2).map(|pair| {
        let [a, b] = [pair[0], pair[1]];
        Point::new(a.x.midpoint(b.x), a.y.midpoint(b.y))
    });
    points
        .iter()
        .copied()
        .chain(middles)
        .chain(lattice)
        .collect()
}

fn nearest(looker: &Looker, p: Point) -> Found {
    let text = looker.nearest(p.x, p.y).expect("a place");
    serde_json::from_str(&text).expect("JSON")
}

#[test]
fn the_first_triangle_at_a_place_is_found() {
    for scene in scenes() {
        let looker = of(&scene);
        for p in places(scene.points()) {
            let holds = |corners: &[VertexId; 3]| {
                let [a, b, c] = corners.map(|v| scene.point(v));
                [[a, b], [b, c], [c, a]]
                    .iter()
                    .all(|&[a, b]| orient2d(a, b, p) != Orientation::Right)
            };
            let expected = scene.triangles().iter().position(holds).map(|t| t as u32);
            assert_eq!(
                looker.triangle_at(p.x, p.y).expect("a place"),
                expected,
                "{p:?}"
            );
        }
    }
}

#[test]
fn the_first_nearest_vertex_is_found() {
    for scene in scenes() {
        let looker = of(&scene);
        for p in places(scene.points()) {
            let compare = |&v: &usize, &w: &usize| {
                compare_distances(p, scene.points()[v], scene.points()[w]).then(v.cmp(&w))
            };
            let found = nearest(&looker, p);
            let expected = (0..scene.points().len()).min_by(compare);
            assert_eq!(Some(found.vertex), expected, "{p:?}");
            let exact = length_up([p, scene.points()[found.vertex]]);
            assert!((found.distance - exact).abs() <= 1e-15 * exact);
        }
    }
}

#[test]
fn walks_step_over_edges_and_come_to_the_place() {
    for scene in scenes() {
        let looker = of(&scene);
        for p in places(scene.points()) {
            let walk = nearest(&looker, p).walk;
            assert_eq!(walk.is_empty(), scene.num_triangles() == 0);
            for pair in walk.windows(2) {
                let [t, u] = [pair[0], pair[1]].map(|t| scene.triangles()[t]);
                assert_eq!(t.iter().filter(|v| u.contains(v)).count(), 2);
            }
            let is_at = |&t: &usize| holds(scene.triangles()[t].map(|v| scene.point(v)), p);
            // In a hull without gaps it always arrives if there is a triangle.
            if !scene.is_carved() && looker.find_triangle(p).is_some() {
                assert!(walk.last().is_some_and(is_at), "{p:?}: {walk:?}");
            }
            let mut sorted = walk.clone();
            sorted.sort_unstable();
            sorted.dedup();
            assert_eq!(sorted.len(), walk.len(), "no triangle twice");
        }
    }
}

#[test]
fn every_step_of_a_run_can_be_looked_at() {
    for (name, preset) in [
        ("incremental", "uniform"),
        ("divide-and-conquer", "grid"),
        ("printed-sweep", "thesis"),
    ] {
        let drawing = Drawing::preset(preset, 20, 1).expect("a preset");
        let mut player = Player::run(name, &drawing, None, None).expect("a run");
        for position in (0..=player.length()).step_by(7) {
            player.seek(position).expect("a step that fits");
            let looker = player.looker();
            let (triangles, points) = (player.triangles(), player.points());
            for (t, corners) in (0..).zip(triangles.as_chunks::<3>().0) {
                let at = |v: u32| Point::new(points[2 * v as usize], points[2 * v as usize + 1]);
                let [a, b, c] = corners.map(at);
                let center = Point::new((a.x + b.x + c.x) / 3.0, (a.y + b.y + c.y) / 3.0);
                if holds([a, b, c], center) {
                    let found = looker.triangle_at(center.x, center.y).expect("a place");
                    assert!(found.is_some_and(|found| found <= t), "{name}");
                }
            }
        }
    }
}

/// The middle of each border has two nearest points, and none is nearer.
#[test]
fn borders_lie_between_their_two_points() {
    let points = [
        (0.0, 0.0),
        (8.0, 0.0),
        (8.0, 8.0),
        (0.0, 8.0),
        (4.0, 4.0),
        (20.0, 4.0),
    ]
    .map(Point::from);
    let borders = Looker::of(points, []).cells(None).expect("cells");
    let segments = borders.as_chunks::<4>().0;
    assert!(segments.len() >= 8);
    for [x0, y0, x1, y1] in segments {
        let middle = Point::new(x0.midpoint(*x1), y0.midpoint(*y1));
        let mut distances = points.map(|p| (p.x - middle.x).hypot(p.y - middle.y));
        distances.sort_by(f64::total_cmp);
        assert!((distances[1] - distances[0]).abs() < 1e-12, "{middle:?}");
    }
}

#[test]
fn borders_of_all_cells_are_drawn_once() {
    for scene in scenes() {
        let borders = of(&scene).cells(None).expect("cells");
        let segments = borders.as_chunks::<4>().0;
        let [low, high] = crate::save::around(scene.points());
        let within =
            |x: f64, y: f64| (low.x..=high.x).contains(&x) && (low.y..=high.y).contains(&y);
        assert!(
            segments
                .iter()
                .all(|&[x0, y0, x1, y1]| within(x0, y0) && within(x1, y1))
        );
        assert!(segments.is_sorted_by(|a, b| a != b), "no border twice");
    }
    // A lattice of 4 × 4: in the cells' lattice 3 lines across and 3 upright, cut where they meet.
    let grid = (0..16).map(|i| Point::new(f64::from(i % 4), f64::from(i / 4)));
    let looker = Looker::of(grid, []);
    assert_eq!(looker.cells(None).expect("cells").len(), 4 * 2 * 3 * 4);
    // Two points: one border, as long as the box is high.
    let two = Looker::of([(0.0, 0.0), (2.0, 0.0)].map(Point::from), []);
    let clip = Some(vec![-3.0, -3.0, 5.0, 7.0]);
    assert_eq!(two.cells(clip).expect("cells"), [1.0, -3.0, 1.0, 7.0]);
    let beside = two.cells(Some(vec![2.0, 0.0, 3.0, 1.0]));
    assert!(beside.expect("cells").is_empty());
    two.cells(Some(vec![1.0])).expect_err("no box");
    two.cells(Some(vec![0.0, 0.0, f64::NAN, 1.0]))
        .expect_err("no box");
}

#[test]
fn nothing_is_found_in_nothing() {
    let nothing = Looker::of([], []);
    assert_eq!(nothing.triangle_at(0.0, 0.0).expect("a place"), None);
    assert_eq!(nothing.nearest(0.0, 0.0).expect("a place"), "null");
    assert!(nothing.cells(None).expect("cells").is_empty());
    nothing.nearest(f64::INFINITY, 0.0).expect_err("no place");
    // A corner is missing, as in a broken log.
    let corners = [0, 1, 9].map(VertexId::new);
    let broken = Looker::of([(0.0, 0.0), (1.0, 0.0)].map(Point::from), [corners]);
    assert_eq!(broken.triangle_at(0.5, 0.1).expect("a place"), None);
    assert!(
        broken
            .nearest(0.9, 0.0)
            .expect("a place")
            .contains(r#""vertex":1"#)
    );
}
