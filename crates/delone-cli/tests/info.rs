//! `delone info`, seen from the shell: what files hold, in their own numbers.

mod support;

use serde_json::{Value, json};
use support::{Folder, Output};

/// A drawing with markers, an attribute, a hole and a region, numbered from 1.
const DRAWING: &str = "\
6 2 1 1
1 0 0  5 1
2 4 0  7 1
3 4 4  0 1
4 0 4  6 1
5 1 1  5.5 0
6 9 9  -2 3
5 1
1 1 2 4
2 2 3 4
3 3 4 4
4 4 1 4
5 5 3 0
1
1 3 1
1
1 1 3 7 0.5
";

fn info(text: &str, options: &str) -> Value {
    let folder = Folder::new();
    folder.write("drawing.poly", text);
    folder
        .run(&format!("info drawing.poly --json{options}"), 0)
        .json()
}

#[test]
fn counts_bounds_and_rule_are_those_of_the_file() {
    let found = info(DRAWING, "");
    for (key, value) in [
        ("points", 6),
        ("segments", 5),
        ("polygons", 0),
        ("holes", 1),
        ("triangles", 0),
        ("base", 1),
    ] {
        assert_eq!(found[key], value, "{key}");
    }
    assert_eq!(found["bounds"], json!([[0.0, 0.0], [9.0, 9.0]]));
    assert_eq!(found["usual_rule"], "carve");
    assert_eq!(found["collinear"], false);
    let folder = Folder::new();
    folder.write("empty.wkt", "MULTIPOLYGON EMPTY");
    let empty = folder.run("info empty.wkt --json", 0).json();
    assert_eq!(empty["points"], 0);
    assert!(empty["bounds"].is_null());
}

#[test]
fn columns_markers_and_regions_are_summed_up() {
    let found = info(DRAWING, "");
    assert_eq!(
        found["columns"],
        json!([{"name": "attribute1", "count": 6, "least": -2.0, "largest": 7.0}])
    );
    assert_eq!(
        found["point_markers"],
        json!({"total": 3, "listed": [[0, 1], [1, 4], [3, 1]]})
    );
    assert_eq!(found["segment_markers"]["listed"], json!([[0, 1], [4, 4]]));
    assert_eq!(
        found["regions"],
        json!({"total": 1, "listed": [{"at": [1.0, 3.0], "attribute": 7.0, "max_area": 0.5}]})
    );
    let folder = Folder::new();
    folder.write("survey.csv", "x,y,height\n0,0,5\n1,0,\n1,1,7\n");
    let output = folder.run("info survey.csv", 0);
    assert!(
        output
            .stdout
            .contains("column height: 5.000 to 7.000, 1 number missing"),
        "{}",
        output.stdout
    );
}

#[test]
fn meshes_have_triangles() {
    let folder = Folder::with_points();
    folder.run("triangulate points.csv -o mesh.ele", 0);
    let found = folder.run("info mesh.ele --json", 0).json();
    assert_eq!(found["triangles"], 4);
    assert_eq!(found["points"], 6);
    let output = folder.run("info mesh.ele", 0);
    assert!(
        output.stdout.starts_with("mesh.ele: 4 triangles, 6 points"),
        "{}",
        output.stdout
    );
}

#[test]
fn rings_know_what_is_around_them() {
    let folder = Folder::new();
    folder.run("sample lake -o lake.poly", 0);
    let lake = folder.run("info lake.poly --json", 0).json();
    assert_eq!(lake["rings"]["apart"], true);
    // Shore, six islands, pond, depth contour.
    assert_eq!(lake["rings"]["total"], 9);
    let rings = lake["rings"]["listed"].as_array().expect("a list");
    let at_depth = |depth: u64| rings.iter().filter(|r| r["depth"] == depth).count();
    // The pond lies on an island, and another island within the contour.
    assert_eq!([0, 1, 2].map(at_depth), [1, 6, 2]);
    let pond = rings.iter().find(|r| r["depth"] == 2).expect("a ring");
    let around = |r: &&Value| r["segment"] == pond["inside"];
    assert_eq!(rings.iter().find(around).expect("a ring")["depth"], 1);
}

#[test]
fn words_say_the_same() {
    let folder = Folder::new();
    folder.write("drawing.poly", DRAWING);
    let output = folder.run("info drawing.poly", 0);
    for words in [
        "drawing.poly: 6 points, 5 segments, 1 hole and 1 region.",
        "rule: carve",
        "from (0.0, 0.0) to (9.0, 9.0)",
        "markers of segments: 0 (1 time), 4 (4 times)",
        "region 1 around (1.0, 3.0): attribute 7, triangles up to 0.5",
        "count from 1",
    ] {
        assert!(output.stdout.contains(words), "{words}: {}", output.stdout);
    }
}

#[test]
fn points_alone_are_something_too() {
    let folder = Folder::with_points();
    let found = folder.run("info points.csv --json", 0).json();
    assert_eq!(found["usual_rule"], "hull");
    folder.write("line.csv", "0,0\n1,1\n3,3\n");
    let output = folder.run("info line.csv", 0);
    assert!(
        output.stdout.contains("all on one line"),
        "{}",
        output.stdout
    );
}

#[test]
fn several_files_have_a_line_each_and_a_bad_one_hides_no_other() {
    let folder = Folder::with_points();
    folder.write("drawing.poly", DRAWING);
    folder.write("a.wkt", "POLYGON((0 0,1 0,0 1,0 0))");
    let output = folder.run("info drawing.poly nowhere.poly a.wkt --json", 3);
    output.says(&["nowhere.poly"]);
    let lines: Vec<Value> = (output.stdout.lines())
        .map(|line| serde_json::from_str(line).expect("JSON"))
        .collect();
    assert_eq!(lines.len(), 2);
    assert_eq!(lines[1]["usual_rule"], "evenodd");
    assert_eq!(lines[1]["polygons"], 1);
}

#[test]
fn a_drawing_comes_from_standard_input() {
    let folder = Folder::new();
    let assert = folder
        .command("info - --from poly --json")
        .write_stdin(DRAWING)
        .assert()
        .code(0);
    assert_eq!(Output::of(assert).json()["file"], "-");
}
