//! The worked examples of the thesis, and the tables under random edits.

use super::code;
use super::limits::Limits;
use super::opening::{Opening, opening};
use super::sight::{Place, lowest_around, sight};
use super::split::split_edges;
use super::work::Work;
use crate::constrained::{Steiner, extend};
use crate::parallel::Workers;
use crate::predicates::{Orientation, orient2d};
use crate::tables::{EdgeTables, Marks, Side, Tables, Teller, edge_flip, middle, tables_of};
use crate::{
    Angle, Budget, ConstrainedDelaunay, ConstrainedTriangulation, DomainRule, Event, Log, Observer,
    Outcome, Point, Pslg, VertexId,
};
use serde_json::Value;

fn fixture(text: &str) -> Value {
    serde_json::from_str(text).expect("a fixture")
}

fn structures() -> Value {
    fixture(include_str!(
        "../../../tests/data/thesis/000-ex2.13-2.15-2.17-structures.json"
    ))
}

fn flips() -> Value {
    fixture(include_str!(
        "../../../tests/data/thesis/000-ex2.20-edge-flip.json"
    ))
}

fn split() -> Value {
    fixture(include_str!(
        "../../../tests/data/thesis/000-ex1.16-1.21-split.json"
    ))
}

fn points(value: &Value) -> Vec<Point> {
    let points: Vec<[f64; 2]> = serde_json::from_value(value.clone()).expect("points");
    points.into_iter().map(Point::from).collect()
}

fn rows<const N: usize>(value: &Value) -> Vec<[u32; N]> {
    let rows = value.as_array().expect("rows").iter();
    let numbers = |row: &Value| -> Vec<u32> { serde_json::from_value(row.clone()).expect("a row") };
    rows.map(|row| numbers(row).try_into().expect("its length"))
        .collect()
}

/// Tables of printed triangles, without constraints inside.
fn tables(points: Vec<Point>, triangles: &Value) -> Tables {
    let triangles = rows(triangles).into_iter();
    let triangles = triangles.map(|t: [u32; 3]| t.map(|v| v - 1)).collect();
    Tables::new(points, triangles, |_| false)
}

/// Marks all edges and flips; lists those examined, and which flipped to what.
fn flip_all(tables: &mut Tables) -> (Vec<[VertexId; 2]>, Vec<[[VertexId; 2]; 2]>) {
    let mut log = Log::default();
    let names = (0..tables.points.len()).map(VertexId::new).collect();
    let mut teller = Teller::new(names, &mut log);
    let mut marks = Marks::default();
    marks.add(0..tables.rows.len() as u32, tables, &mut teller);
    edge_flip(tables, &mut marks, &mut teller, code::FLIP);
    let (mut examined, mut flipped) = (Vec::new(), Vec::new());
    for step in log.steps {
        match step.event {
            Event::EdgeExamined { edge } => examined.push(edge),
            Event::EdgeFlipped { from, to } => flipped.push([from, to]),
            _ => {}
        }
    }
    (examined, flipped)
}

/// Tells nobody.
fn nobody(nobody: &mut ()) -> Teller<'_, impl Observer> {
    Teller::new(Vec::new(), nobody)
}

/// Every entry agrees with every other, and triangles turn counter-clockwise.
fn assert_sound(tables: &Tables) {
    assert_eq!(tables.triangles.len(), tables.edges_of.len());
    for t in 0..tables.triangles.len() as u32 {
        let [a, b, c] = tables.corners(t);
        assert_eq!(orient2d(a, b, c), Orientation::Left, "triangle {t}");
        for side in [0, 1, 2].map(|k| Side::new(t, k)) {
            let row = tables.row(tables.row_of(side));
            let [a, b] = tables.ends(side);
            assert_eq!(row.ends, [a.max(b), a.min(b)], "{side:?}");
            assert!(row.first == side || row.second == Some(side), "{side:?}");
            if let Some(other) = tables.across(side) {
                assert_eq!(tables.ends(other), [b, a]);
                assert_eq!(tables.across(other), Some(side));
            }
        }
    }
    for row in &tables.rows {
        assert!(row.is_constraint || row.second.is_some());
        assert_ne!(row.second, Some(row.first));
    }
}

#[test]
fn tables_are_numbered_as_printed() {
    let printed_tables = structures();
    let tables = tables(points(&flips()["points"]), &printed_tables["triangulation"]);
    assert_sound(&tables);
    let view = EdgeTables::from(&tables);
    assert_eq!(view.triangles, rows(&printed_tables["triangulation"]));
    assert_eq!(
        view.edges_with_triangles,
        rows(&printed_tables["edges_with_triangles"])
    );
    assert_eq!(
        view.triangles_with_edges,
        rows(&printed_tables["triangles_with_edges"])
    );
    let constraints = (1..).zip(&tables.rows).filter(|(_, row)| row.is_constraint);
    let constraints: Vec<u64> = constraints.map(|(number, _)| number).collect();
    let expected = printed_tables["boundary_edge_indices"].as_array().unwrap();
    assert!(
        constraints.iter().eq(expected
            .iter()
            .map(|n| n.as_u64().unwrap())
            .collect::<Vec<_>>()
            .iter())
    );
}

#[test]
fn edges_are_flipped_as_printed() {
    let example = flips();
    let mut tables = tables(
        points(&example["points"]),
        &example["before"]["triangulation"],
    );
    let (examined, flipped) = flip_all(&mut tables);
    assert_sound(&tables);
    let flipped: Vec<_> = flipped
        .iter()
        .map(|pair| pair.map(|ends| ends.map(|v| v.index() + 1)))
        .collect();
    assert_eq!(flipped, [[[3, 2], [4, 1]], [[8, 6], [9, 7]]]);
    assert_eq!(
        examined.len() as u64,
        example["edges_examined"].as_u64().unwrap()
    );
    let (view, after) = (EdgeTables::from(&tables), &example["after"]);
    assert_eq!(view.triangles, rows(&after["triangulation"]));
    assert_eq!(
        view.edges_with_triangles,
        rows(&after["edges_with_triangles"])
    );
    assert_eq!(
        view.triangles_with_edges,
        rows(&after["triangles_with_edges"])
    );
}

/// The domain of example 1.16.
fn thesis_domain() -> (Pslg, Value) {
    let example = split();
    let mut pslg = Pslg::from_points(points(&example["input"]["points"]));
    for [a, b] in rows(&example["input"]["constraint_edges"]) {
        pslg.add_segment(a - 1, b - 1);
    }
    (pslg, example)
}

fn triangulated(pslg: Pslg) -> ConstrainedTriangulation {
    let builder = ConstrainedDelaunay::new().domain(DomainRule::EvenOdd);
    builder.triangulate(pslg).expect("a domain")
}

fn extended(t: &ConstrainedTriangulation, steiner: &Steiner) -> ConstrainedTriangulation {
    let all = steiner.points.len();
    let extended = extend(t, steiner, all, Workers::ONE).expect("few points");
    extended.expect("no vertex has changed sides")
}

fn divided(pslg: Pslg, bound: f64, budget: Budget) -> (Steiner, Result<(), Outcome>) {
    let mut steiner = Steiner::default();
    let mut limits = Limits::new(budget, &());
    let outcome = split_edges(
        &triangulated(pslg),
        bound,
        &mut steiner,
        &mut limits,
        &mut (),
    );
    (steiner, outcome)
}

#[test]
fn edges_are_split_as_printed() {
    let (pslg, example) = thesis_domain();
    let bound = example["input"]["h_max"].as_f64().unwrap();
    let (steiner, outcome) = divided(pslg.clone(), bound, Budget::default());
    assert_eq!(outcome, Ok(()));
    let all = [&pslg.points[..], &steiner.points].concat();
    assert_eq!(all, points(&example["expected"]["points"]));
    let t = extended(&triangulated(pslg), &steiner);
    let mut edges: Vec<_> = t
        .constrained_edges()
        .map(|[a, b]| [a.max(b).raw() + 1, a.min(b).raw() + 1])
        .collect();
    edges.sort_by_key(|&[high, low]| [low, high]);
    let expected = &example["expected"]["edges_larger_smaller_column_major"];
    assert_eq!(edges, rows(expected));
}

#[test]
fn pieces_are_even_and_begin_at_the_larger_end() {
    let mut pslg = Pslg::from_points([(0.0, 0.0), (7.0, 0.0), (0.0, 3.0)]);
    pslg.add_ring([0, 1, 2]);
    let (steiner, outcome) = divided(pslg.clone(), 3.0, Budget::default());
    assert_eq!(outcome, Ok(()));
    // First 0–1, in three from 1 on, then 0–2, which is not too long, then 1–2, in three from 2 on.
    let third = 7.0 / 3.0;
    assert_eq!(steiner.points.len(), 4);
    assert!((steiner.points[0].x - 2.0 * third).abs() < 1e-15);
    assert!((steiner.points[1].x - third).abs() < 1e-15);
    assert!((steiner.points[2].x - third).abs() < 1e-15 && steiner.points[2].y == 2.0);
    let most = Budget {
        vertices: Some(5),
        ..Budget::default()
    };
    let (steiner, outcome) = divided(pslg.clone(), 3.0, most);
    assert_eq!(
        (steiner.points.len(), outcome),
        (2, Err(Outcome::BudgetExhausted))
    );
    // Pieces below the grid of the coordinates: they end at once.
    let (_, outcome) = divided(pslg, 1e-310, Budget::default());
    assert_eq!(outcome, Err(Outcome::PrecisionLimit));
}

#[test]
fn a_mesh_is_numbered_as_the_sweep_would() {
    let (pslg, example) = thesis_domain();
    let bound = example["input"]["h_max"].as_f64().unwrap();
    let (steiner, _) = divided(pslg.clone(), bound, Budget::default());
    let (tables, names) = tables_of(&extended(&triangulated(pslg), &steiner), 1.0);
    assert_sound(&tables);
    let after = &flips()["after"];
    assert_eq!(tables.points, points(&flips()["points"]));
    let same = |rows: Vec<[u32; 3]>| {
        let mut rows: Vec<_> = rows
            .into_iter()
            .map(|[a, b, c]| [[a, b, c], [b, c, a], [c, a, b]].into_iter().min())
            .collect();
        rows.sort();
        rows
    };
    let expected: Vec<[u32; 3]> = rows(&after["triangulation"]);
    let view = EdgeTables::from(&tables);
    assert_eq!(same(view.triangles), same(expected));
    // Written with the last vertex in the middle, by that vertex.
    assert!(tables.triangles.iter().all(|[a, b, c]| b > a && b > c));
    assert!(tables.triangles.is_sorted_by_key(|t| t[1]));
    assert_eq!(
        names[4].index(),
        9,
        "the vertex at (1.5, 3.5) was added last"
    );
}

/// Two triangles with a common edge 1–2, which is a constraint if asked for.
fn pair(is_constraint: bool) -> Tables {
    let points = [(0.0, 0.0), (2.0, -1.0), (2.0, 1.0), (4.0, 0.0)];
    let points = points.map(Point::from).to_vec();
    Tables::new(points, vec![[0, 1, 2], [1, 3, 2]], |ends| {
        is_constraint && ends == [2, 1]
    })
}

#[test]
fn bisecting_and_inserting_number_as_stated() {
    let mut tables = pair(true);
    let row = tables.row_of(Side::new(0, 1));
    tables.points.push((2.0, 0.0).into());
    let suspects = tables.bisect(row, 4);
    assert_sound(&tables);
    // A = 1, B = 2, C = 0, D = 3, X = 4.
    let expected = [[1, 4, 0], [2, 4, 3], [0, 4, 2], [3, 4, 1]];
    assert_eq!(tables.triangles, expected);
    let ends = |row: u32| tables.row(row).ends;
    assert_eq!([row, 5, 6, 7].map(ends), [[4, 1], [4, 0], [4, 2], [4, 3]]);
    assert!(tables.row(row).is_constraint && tables.row(6).is_constraint);
    assert!(!tables.row(5).is_constraint && !tables.row(7).is_constraint);
    assert_eq!(suspects.len(), 8);

    let border = tables.row_of(Side::new(0, 2));
    tables.points.push((1.0, -0.5).into());
    let suspects = tables.bisect(border, 5);
    assert_sound(&tables);
    // A = 0, B = 1, C = 4, X = 5.
    assert_eq!(
        (tables.triangles[0], tables.triangles[4]),
        ([0, 5, 4], [4, 5, 1])
    );
    assert_eq!(suspects, [8, tables.row_of(Side::new(4, 2)), 5]);

    let mut tables = pair(false);
    tables.points.push((1.5, 0.25).into());
    let suspects = tables.insert(0, 4);
    assert_sound(&tables);
    // A = 0, B = 1, C = 2, X = 4.
    let expected = [[2, 4, 1], [1, 3, 2], [0, 4, 2], [1, 4, 0]];
    assert_eq!(tables.triangles, expected);
    assert_eq!(suspects[..3], [5, 6, 7]);
    assert_eq!(
        [5, 6, 7].map(|r| tables.row(r).ends),
        [[4, 0], [4, 1], [4, 2]]
    );
    assert_eq!(suspects.len(), 6);
}

#[test]
fn constraints_and_vertices_block_the_view() {
    let (open, closed) = (pair(false), pair(true));
    let look = |tables: &Tables, goal: (f64, f64)| {
        sight(tables, Side::new(0, 1), goal.into(), &mut nobody(&mut ()))
    };
    let beyond = Side::new(1, 2);
    for (goal, place) in [
        ((1.0, 0.25), Some(Place::Triangle(0))),
        ((2.0, 0.5), Some(Place::Edge(Side::new(0, 1)))),
        ((3.0, 0.25), Some(Place::Triangle(1))),
        ((3.0, 0.0), Some(Place::Triangle(1))),
        ((4.0, 0.0), Some(Place::Vertex(beyond))),
        ((5.0, 0.0), None),
        ((4.5, 0.25), None),
        ((-1.0, 0.0), None),
        ((1.0, 2.0), None),
        ((1.0, 0.5), None),
    ] {
        assert_eq!(look(&open, goal), place, "{goal:?}");
        let touches = goal.0 <= 2.0;
        assert_eq!(look(&closed, goal), place.filter(|_| touches), "{goal:?}");
    }
    assert_eq!(lowest_around(&open, Place::Edge(beyond)), 0);
    assert_eq!(lowest_around(&open, Place::Vertex(Side::new(1, 0))), 0);
    assert_eq!(lowest_around(&open, Place::Vertex(beyond)), 1);
}

/// A triangle under test, and what becomes of it.
fn opened(points: &[(f64, f64)], triangles: &[[u32; 3]], degrees: f64) -> Opening {
    let points = points.iter().map(|&p| p.into()).collect();
    let tables = Tables::new(points, triangles.to_vec(), |_| false);
    assert_sound(&tables);
    let sine = f64::to_radians(degrees).sin();
    opening(&tables, 0, sine, &mut nobody(&mut ()))
}

#[test]
fn triangles_are_opened_by_the_rules() {
    // No obtuse angle: the longest edge.
    let needle = [(0.0, 0.0), (1.0, 0.0), (0.5, 9.0)];
    assert!(matches!(
        opened(&needle, &[[0, 1, 2]], 20.0),
        Opening::Bisect(_)
    ));
    // Obtuse, its longest edge a border that hides the circumcenter: that edge.
    let flat = [(0.0, 0.0), (8.0, 0.0), (4.0, 1.0)];
    assert_eq!(opened(&flat, &[[0, 1, 2]], 20.0), Opening::Bisect(0));
    // Obtuse, the circumcenter (4, −7.5) in an acute triangle below, whose longest edge is inside.
    let wide = [(0.0, 0.0), (8.0, 0.0), (4.0, 1.0), (4.0, -9.0)];
    let below = [[0, 1, 2], [0, 3, 1]];
    let rule = |degrees| opened(&wide, &below, degrees);
    // Its longest edges are borders, its largest angle 66°: the ε-rule forbids its circumcenter from 24° on.
    assert_eq!(rule(23.0), Opening::Circumcenter(1));
    assert!(matches!(rule(25.0), Opening::Bisect(row) if row != 0));
}

#[test]
fn a_right_angle_bisects() {
    // The circumcenter of a right triangle lies on its longest edge, in the lower of two triangles.
    let square = [(0.0, 0.0), (4.0, 0.0), (4.0, 1.0), (0.0, 1.0)];
    let halves = [[0, 1, 2], [0, 2, 3]];
    let diagonal = Opening::Bisect(1);
    assert_eq!(opened(&square, &halves, 20.0), diagonal);
}

#[test]
fn tables_stay_sound_under_random_edits() {
    let mut seed = 7_u64;
    let mut below = |n: usize| {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (seed >> 33) as usize % n
    };
    let (pslg, _) = thesis_domain();
    let (mut tables, _) = tables_of(&triangulated(pslg), 1.0);
    for _ in 0..300 {
        let x = tables.points.len() as u32;
        let suspects = if below(2) == 0 {
            let row = below(tables.rows.len()) as u32;
            let [a, b] = tables.row(row).ends.map(|v| tables.point(v));
            tables.points.push(middle(a, b));
            tables.bisect(row, x)
        } else {
            let t = below(tables.triangles.len()) as u32;
            let [a, b, c] = tables.corners(t);
            tables.points.push(middle(middle(a, b), c));
            tables.insert(t, x)
        };
        let mut marks = Marks::default();
        let mut told = ();
        let mut teller = nobody(&mut told);
        marks.add(suspects, &tables, &mut teller);
        edge_flip(&mut tables, &mut marks, &mut teller, code::FLIP);
        assert_sound(&tables);
    }
    let (_, forgotten) = flip_all(&mut tables);
    assert!(forgotten.is_empty(), "{forgotten:?}");
}

#[test]
fn the_result_is_what_the_tables_hold() {
    let (pslg, _) = thesis_domain();
    let t = triangulated(pslg);
    let mut steiner = Steiner::default();
    let mut limits = Limits::new(Budget::default(), &());
    let mut nobody = ();
    let mut work = Work::new(&t, &mut steiner, &mut limits, &mut nobody);
    assert_eq!(work.shorten(0.4), Ok(()));
    assert_eq!(work.open(Angle::degrees(25.0)), Ok(()));
    assert!(work.keeps_to(0.4) && !work.keeps_to(0.3));
    let triangles = 0..work.tables.triangles.len() as u32;
    let held = by_place(triangles.map(|t| work.tables.corners(t)));
    let extended = extended(&t, &steiner);
    let t = extended.triangulation();
    let corners = |corners: &[crate::VertexId; 3]| corners.map(|v| t.point(v));
    assert_eq!(by_place(t.triangles().iter().map(corners)), held);
}

/// Triangles by their places, in an order that depends on the set alone.
fn by_place(triangles: impl Iterator<Item = [Point; 3]>) -> Vec<[Point; 3]> {
    let order = |s: &[Point; 3], t: &[Point; 3]| {
        let corners = s.iter().zip(t).map(|(p, q)| p.lex_cmp(q));
        corners.fold(std::cmp::Ordering::Equal, |order, next| order.then(next))
    };
    let smallest_first = |[a, b, c]: [Point; 3]| {
        let rotations = [[a, b, c], [b, c, a], [c, a, b]];
        rotations
            .into_iter()
            .min_by(order)
            .expect("three rotations")
    };
    let mut triangles: Vec<_> = triangles.map(smallest_first).collect();
    triangles.sort_by(order);
    triangles
}

/// Rounding may move a vertex on the border past what lies beyond it, here a loose point.
#[test]
fn a_vertex_that_changes_sides_is_noticed() {
    let mut pslg = Pslg::from_points([(0.0, 0.0), (4.0, 0.0), (2.0, 3.0), (2.0, -0.5)]);
    pslg.add_ring([0, 1, 2]);
    let t = triangulated(pslg);
    let moved = |y: f64| {
        let mut steiner = Steiner::default();
        steiner.push((2.0, y).into(), Some([0, 1].map(crate::VertexId::new)));
        extend(&t, &steiner, 1, Workers::ONE).expect("few points")
    };
    let t = moved(-0.25).expect("still above the point");
    assert_eq!(t.triangulation().num_triangles(), 2);
    assert_eq!(t.chain(0).len(), 3);
    assert!(moved(-0.5).is_none(), "upon the point");
    assert!(moved(-0.75).is_none(), "below it");
    assert!(moved(3.5).is_none(), "across other segments");
}
