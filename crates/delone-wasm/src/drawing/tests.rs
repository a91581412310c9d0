//! Drawings are what was drawn, before edits and after.

use super::*;

#[test]
fn what_goes_in_comes_out() {
    let points = [0.0, 0.0, 4.0, 0.0, 0.0, 3.0];
    let drawing = Drawing::new(&points, &[0, 1, 1, 2], &[1.0, 1.0]).expect("a drawing");
    assert_eq!(drawing.points(), points);
    assert_eq!(drawing.segments(), [0, 1, 1, 2]);
    assert_eq!(drawing.holes(), [1.0, 1.0]);
    assert!(drawing.about().contains(r#""rule":"carve""#));
}

#[test]
fn nonsense_is_refused_by_name() {
    let refused = |points: &[f64], segments: &[u32]| {
        let drawing = Drawing::new(points, segments, &[]);
        drawing.expect_err("nonsense").to_string()
    };
    assert!(refused(&[0.0; 3], &[]).contains("points: 3 numbers"));
    assert!(refused(&[0.0; 4], &[0, 2]).contains("segment 0 joins 0 and 2 of 2 points"));
}

/// A square with a diagonal, an attribute, markers, a hole and a region.
const SQUARE: &str = "4 2 1 1\n0 0 0 .5 1\n1 4 0 .6 2\n2 4 4 .7 3\n3 0 4 .8 4\n\
    5 1\n0 0 1 10\n1 1 2 11\n2 2 3 12\n3 3 0 13\n4 0 2 14\n1\n0 3 1\n1\n0 1 3 7 0.5\n";

fn square() -> Drawing {
    Drawing::from_file("square.poly", SQUARE.as_bytes()).expect("a drawing")
}

fn refusal(drawing: &mut Drawing, edits: &str) -> String {
    let before = drawing.save("a.poly", None).expect("a file")[0].bytes();
    let message = drawing.edit(edits).expect_err(edits).to_string();
    let after = drawing.save("a.poly", None).expect("a file")[0].bytes();
    assert_eq!(before, after, "{edits} has changed something");
    message
}

#[test]
fn what_stays_keeps_what_it_has() {
    let mut drawing = square();
    drawing.edit(r#"[{"removePoint": 1}]"#).expect("an edit");
    assert_eq!(drawing.points(), [0.0, 0.0, 4.0, 4.0, 0.0, 4.0]);
    assert_eq!(drawing.segments(), [1, 2, 2, 0, 0, 1]);
    let data = &drawing.data;
    assert_eq!(data.segment_markers, Some(vec![12, 13, 14]));
    assert_eq!(data.vertices.markers, Some(vec![1, 3, 4]));
    assert_eq!(data.vertices.attributes[0].values, [0.5, 0.7, 0.8]);
    assert_eq!(drawing.regions(), [1.0, 3.0, 7.0, 0.5]);
}

#[test]
fn what_comes_has_nothing_yet() {
    let mut drawing = square();
    let edits = r#"[{"addPoint": [2, 5]}, {"addSegment": [2, 4]}, {"movePoint": [4, 2, 6.5]},
        {"addHole": [9, 9]}, {"moveHole": [0, 3, 2]}, {"addRegion": [2, 5, 8, null]}, {"moveRegion": [0, 1, 2]}]"#;
    drawing.edit(edits).expect("edits");
    assert_eq!(drawing.points()[8..], [2.0, 6.5]);
    assert_eq!(drawing.segments()[10..], [2, 4]);
    assert_eq!(drawing.holes(), [3.0, 2.0, 9.0, 9.0]);
    assert_eq!(drawing.regions()[..7], [1.0, 2.0, 7.0, 0.5, 2.0, 5.0, 8.0]);
    assert!(drawing.regions()[7].is_nan());
    let vertices = &drawing.data.vertices;
    assert!(vertices.attributes[0].values[4].is_nan());
    assert_eq!(vertices.markers.as_ref().expect("markers")[4], 0);
    assert_eq!(
        drawing.data.segment_markers.as_ref().expect("markers")[5],
        0
    );
    let edits = r#"[{"removeHole": 0}, {"removeRegion": 0}, {"removeSegment": 4}]"#;
    drawing.edit(edits).expect("edits");
    assert_eq!((drawing.holes().len(), drawing.regions().len()), (2, 4));
    assert_eq!(drawing.data.segment_markers, Some(vec![10, 11, 12, 13, 0]));
}

#[test]
fn all_edits_are_made_or_none() {
    let mut drawing = square();
    for (edits, expected) in [
        (
            r#"[{"addPoint": [1, 1]}, {"movePoint": [5, 0, 0]}]"#,
            "edit 1, movePoint: there is no point 5",
        ),
        (
            r#"[{"addPoint": [null, 1]}]"#,
            "edit 0, addPoint: (no number, 1) is no place",
        ),
        (
            r#"[{"addSegment": [2, 2]}]"#,
            "edit 0, addSegment: a segment from point 2 to itself",
        ),
        (
            r#"[{"removePoint": 3}, {"addSegment": [0, 3]}]"#,
            "edit 1, addSegment: there is no point 3",
        ),
        (
            r#"[{"removePoint": 3}, {"removePoint": 2}, {"removeSegment": 1}]"#,
            "there is only segment 0",
        ),
        (
            r#"[{"removeHole": 1}]"#,
            "there is no hole 1: there is only hole 0",
        ),
        (
            r#"[{"clear": true}, {"removePoint": 0}]"#,
            "there are no points",
        ),
        (r#"[{"clear": false}]"#, "edit 0, clear"),
        (
            r#"[{"addPoint": [1, 1]}, {"turn": 3}]"#,
            "edit 1, {\"turn\":3}: unknown variant `turn`",
        ),
        (r#"[{"removePoint": -1}]"#, "edit 0, {\"removePoint\":-1}"),
        (r#"{"removePoint": 1}"#, "edits: "),
    ] {
        let message = refusal(&mut drawing, edits);
        assert!(message.contains(expected), "{message}");
    }
}

#[test]
fn many_points_go_as_one_by_one() {
    let points: Vec<f64> = (0..40).map(f64::from).collect();
    let segments: Vec<u32> = (0..19).flat_map(|i| [i, i + 1]).collect();
    let drawing = Drawing::new(&points, &segments, &[]).expect("a drawing");
    let remove = |list: &[usize]| {
        let list: Vec<_> = list
            .iter()
            .map(|i| format!(r#"{{"removePoint": {i}}}"#))
            .collect();
        format!("[{}]", list.join(","))
    };
    let numbers = [18, 17, 9, 4, 4, 2, 7, 3];
    let (mut at_once, mut singly) = (drawing.copy(), drawing);
    at_once.edit(&remove(&numbers)).expect("edits");
    numbers
        .iter()
        .for_each(|&i| singly.edit(&remove(&[i])).expect("an edit"));
    assert_eq!(at_once.points(), singly.points());
    assert_eq!(at_once.segments(), singly.segments());
    assert_eq!(at_once.points().len(), 24);
}

#[test]
fn polygons_last_as_long_as_they_are_closed() {
    let text = b"GEOMETRYCOLLECTION (POLYGON ((0 0, 4 0, 0 4, 0 0)), LINESTRING (5 5, 6 6), POLYGON ((9 9, 12 9, 9 12, 9 9)))";
    let mut drawing = Drawing::from_file("a.wkt", text).expect("polygons");
    let polygons = drawing.data.polygons.clone();
    assert_eq!(polygons.len(), 2);
    let inside = polygons[0].end..polygons[1].start;
    let line = (0..drawing.data.segments.len())
        .find(|&k| inside.contains(&k) || polygons.iter().all(|polygon| !polygon.contains(&k)));
    let line = line.expect("a line");
    drawing
        .edit(&format!(r#"[{{"removeSegment": {line}}}]"#))
        .expect("an edit");
    assert_eq!(drawing.data.polygons.len(), 2);
    let triangles = |drawing: &Drawing| {
        let mesh = crate::mesh::Mesh::constrain(drawing, None, None).expect("a mesh");
        mesh.triangles().len() / 3
    };
    assert_eq!(triangles(&drawing), 2);
    // A corner goes, and its neighbours are joined by hand: the ring is a ring again.
    let [a, b] = drawing.data.segments[0].map(|v| v.index());
    let [p, q] = [
        drawing.data.vertices.points[a],
        drawing.data.vertices.points[b],
    ];
    let n = drawing.data.vertices.points.len();
    let middle = [(p.x + q.x) / 2.0, (p.y + q.y) / 2.0 - 1.0];
    let edits = format!(
        r#"[{{"removeSegment": 0}}, {{"addPoint": [{}, {}]}}, {{"addSegment": [{a}, {n}]}}, {{"addSegment": [{n}, {b}]}}]"#,
        middle[0], middle[1]
    );
    drawing.edit(&edits).expect("edits");
    assert!(drawing.data.polygons.is_empty());
    assert_eq!(triangles(&drawing), 3);
}

#[test]
fn a_drawing_begins_with_nothing() {
    let mut drawing = square();
    drawing.edit(r#"[{"clear": true}]"#).expect("an edit");
    assert!(drawing.points().is_empty() && drawing.about().contains(r#""rule":"hull""#));
    let edits = r#"[{"addPoint": [0, 0]}, {"addPoint": [1, 0]}, {"addSegment": [0, 1]}]"#;
    drawing.edit(edits).expect("edits");
    assert!(drawing.about().contains(r#""rule":"carve""#));
    drawing.edit(r#"[{"removeSegment": 0}]"#).expect("an edit");
    assert!(drawing.about().contains(r#""rule":"hull""#));
}

#[test]
fn edited_points_are_no_corners_of_triangles_that_were_brought() {
    let points = Drawing::preset("grid", 16, 1).expect("points");
    let mesh = crate::mesh::Mesh::triangulate(&points, None).expect("a mesh");
    let file = mesh.save("a.vtu", None).expect("a file")[0].bytes();
    for (edit, is_kept) in [
        (r#"[{"movePoint": [0, -1, -1]}]"#, false),
        (r#"[{"removePoint": 0}]"#, false),
        (r#"[{"addPoint": [9, 9]}]"#, false),
        (r#"[{"addHole": [9, 9]}]"#, true),
    ] {
        let mut drawing = Drawing::from_file("a.vtu", &file).expect("a mesh");
        drawing.edit(edit).expect("an edit");
        assert_eq!(!drawing.triangles().is_empty(), is_kept, "{edit}");
    }
}
