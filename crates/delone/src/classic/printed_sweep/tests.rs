//! The tables of the thesis, number by number; and how often the print fails.

use super::*;
use crate::{Log, Scene, Stage};
use serde_json::Value;

fn fixture(text: &str) -> Value {
    serde_json::from_str(text).expect("a fixture")
}

fn strip_and_inside() -> Value {
    fixture(include_str!(
        "../../../tests/data/thesis/000-ex1.26-1.29-strip-inside.json"
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

/// The thesis' numbers: sorted, helpers first.
struct Numbers(Vec<VertexId>);

impl Numbers {
    fn of(scene: &Scene) -> Self {
        let mut all: Vec<_> = scene.vertices().collect();
        all.sort_by(|(_, p), (_, q)| p.lex_cmp(q));
        Self(all.into_iter().map(|(v, _)| v).collect())
    }

    fn number(&self, v: VertexId) -> u32 {
        let at = self.0.iter().position(|&w| w == v);
        at.expect("a vertex") as u32 + 1
    }
}

/// A point, the triangles that it makes, and the front with it.
#[derive(Debug, PartialEq)]
struct Row {
    point: u32,
    triangles: Vec<[u32; 3]>,
    front: Vec<u32>,
}

/// Reads from a log what the sweep does point by point.
fn table(log: &Log) -> Vec<Row> {
    let mut scene = log.first_scene();
    let mut table: Vec<Row> = Vec::new();
    let mut numbers = Numbers(Vec::new());
    let ends = Event::StageEnded {
        stage: Stage::Sweep,
        min_angle: None,
    };
    for step in log.steps.iter().take_while(|step| step.event != ends) {
        scene.apply(step.event).expect("it fits");
        match (step.event, table.last_mut()) {
            (Event::VertexCreated { .. }, _) => numbers = Numbers::of(&scene),
            (Event::PointConsidered { vertex }, _) => table.push(Row {
                point: numbers.number(vertex),
                triangles: Vec::new(),
                front: Vec::new(),
            }),
            (Event::TriangleCreated { triangle }, Some(row)) => {
                row.triangles.push(triangle.map(|v| numbers.number(v)));
            }
            (Event::FrontEntered { .. }, Some(row)) => {
                row.front = scene.front().map(|v| numbers.number(v)).collect();
            }
            _ => {}
        }
    }
    table
}

/// The domain of example 1.16, split: its vertices are numbered as they are sorted.
fn example() -> Input<'static> {
    let value = strip_and_inside();
    let mut input = Input::from_points(points(&value["points"]));
    for [a, b] in rows(&value["constraint_edges"]) {
        input.pslg.add_segment(a - 1, b - 1);
    }
    input.domain = DomainRule::EvenOdd;
    input
}

fn observed(input: &Input, helpers: Option<[Point; 2]>) -> (Output, Log) {
    let mut log = Log::new("printed-sweep", input.pslg.points.clone());
    let output = replay(input, helpers, &mut log).expect("a replay");
    (output, log)
}

#[test]
fn points_are_sorted_as_in_example_1_23() {
    let value = fixture(include_str!(
        "../../../tests/data/thesis/000-ex1.23-sort.json"
    ));
    for variant in value["variants"].as_array().expect("variants") {
        let helpers = points(&variant["helpers"]);
        let input = example();
        let mut nobody = ();
        let mut replay = Replay::new(&input, &mut nobody).expect("a replay");
        replay.sweep(Some([helpers[0], helpers[1]])).expect("swept");
        let sorted: Vec<_> = replay
            .order
            .iter()
            .map(|&v| replay.board.point(v))
            .collect();
        assert_eq!(sorted, points(&variant["expected_points"]));
    }
}

#[test]
fn triangles_and_fronts_are_those_of_example_1_25() {
    let value = fixture(include_str!(
        "../../../tests/data/thesis/000-ex1.25-planesweep.json"
    ));
    for variant in value["variants"].as_array().expect("variants") {
        let all = points(&variant["points"]);
        let (output, log) = observed(&example(), Some([all[0], all[1]]));
        let table = table(&log);
        let steps = variant["steps"].as_array().expect("steps");
        assert_eq!(table.len(), steps.len());
        for (row, step) in table.iter().zip(steps) {
            let front: Vec<u32> =
                serde_json::from_value(step["chain_after"].clone()).expect("a front");
            let triangles = rows(&step["new_triangles"]);
            let point = step["point"].as_u64().expect("a point") as u32;
            assert_eq!(
                row,
                &Row {
                    point,
                    triangles,
                    front
                }
            );
        }
        assert_eq!(output.failures, []);
        check_strip_and_inside(&output, &log);
    }
}

/// Helpers removed, and the inside test: examples 1.26 and 1.29, whichever helpers there were.
fn check_strip_and_inside(output: &Output, log: &Log) {
    let value = strip_and_inside();
    let tested = log.steps.iter().filter_map(|step| match step.event {
        Event::InsideTested {
            triangle,
            is_inside,
            ..
        } => Some((triangle.map(|v| v.raw() + 1), is_inside)),
        _ => None,
    });
    let (stripped, inside): (Vec<_>, Vec<_>) = tested.unzip();
    assert_eq!(stripped, rows(&value["triangles_after_strip"]));
    assert_eq!(Value::from(inside), value["inside"]);
    let kept: Vec<_> = output
        .triangles
        .iter()
        .map(|t| t.map(|v| v.raw() + 1))
        .collect();
    assert_eq!(kept, rows(&value["triangles_inside"]));
    let ends = log
        .steps
        .iter()
        .filter(|step| matches!(step.event, Event::TriangleDeleted { .. }));
    let removed: Vec<_> = ends.rev().take(2).collect();
    let expected: Vec<[u32; 3]> = rows(&value["removed"]);
    for (step, expected) in removed.iter().rev().zip(expected) {
        let triangle = expected.map(|v| VertexId::from(v - 1));
        assert_eq!(step.event, Event::TriangleDeleted { triangle });
    }
}

#[test]
fn a_polygon_of_five_corners_loses_segments() {
    let value = fixture(include_str!(
        "../../../tests/data/thesis/000-planesweep-failure.json"
    ));
    let printed = &value["printed_algorithm"];
    let mut input = Input::from_points(points(&value["polygon"]));
    input.pslg.add_ring([0, 1, 2, 3, 4]);
    let sorted = points(&printed["sorted_points"]);
    let (output, log) = observed(&input, Some([sorted[0], sorted[1]]));
    let number = |v: VertexId| {
        let at = sorted
            .iter()
            .position(|&p| p == input.pslg.points[v.index()]);
        at.expect("a point") as u32 + 1
    };
    let mut triangles = vec![[1, 3, 2]];
    triangles.extend(table(&log).into_iter().flat_map(|row| row.triangles));
    assert_eq!(triangles, rows(&printed["triangles"]));
    let lost = output.failures.iter().filter_map(|failure| match failure {
        Failure::SegmentLost([a, b]) => {
            Some([number(*a).max(number(*b)), number(*a).min(number(*b))])
        }
        _ => None,
    });
    let mut lost: Vec<_> = lost.collect();
    let mut expected = rows(&printed["missing_constraints_sorted_indices"]);
    // The only triangle at this side goes with the helpers.
    expected.push([6, 3]);
    lost.sort();
    expected.sort();
    assert_eq!(lost, expected);
    let area = &printed["inside_area"];
    let [a, b, c] = output.triangles[0].map(|v| output.points[v.index()]);
    let doubled = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    assert_eq!(
        (output.triangles.len(), Some(doubled / 2.0)),
        (1, area.as_f64())
    );
    let has = |failure| output.failures.contains(&failure);
    assert!(
        has(Failure::SeesOne(VertexId::new(4))),
        "vertex 4 of the sorted ones is a spike"
    );
    assert!(
        has(Failure::SeesSeveralRuns(VertexId::new(3))),
        "vertex 7 sees 5 and 6"
    );
}
