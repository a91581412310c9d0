//! `delone info`, seen from the shell: exact facts, in the numbers of the file.

mod support;

use serde_json::{Value, json};
use support::{Folder, Output};

/// Everything that can be wrong, once, numbered from 1.
const DIRTY: &str = "\
10 2 0 0
1 0 0
2 4 0
3 4 4
4 0 4
5 0 0
6 2 0
7 6 0
8 1 1
9 1 3
10 3 2
9 0
1 1 2
2 2 3
3 3 4
4 4 5
5 2 1
6 6 7
7 8 8
8 8 10
9 9 3
0
";

fn info(text: &str, options: &str) -> Value {
    let folder = Folder::new();
    folder.write("drawing.poly", text);
    folder
        .run(&format!("info drawing.poly --json{options}"), 0)
        .json()
}

#[test]
fn every_trouble_is_named_with_numbers_and_coordinates() {
    let found = info(DIRTY, "");
    let expected = [
        (
            "duplicates",
            json!([{"point": 5, "equals": 1, "at": [0.0, 0.0]}]),
        ),
        ("zero_length", json!([{"segment": 7, "at": [1.0, 1.0]}])),
        (
            "repeated",
            json!([{"segment": 5, "equals": 1, "ends": [[4.0, 0.0], [0.0, 0.0]]}]),
        ),
        (
            "on_segments",
            json!([
                {"point": 6, "segment": 1, "at": [2.0, 0.0]},
                {"point": 2, "segment": 6, "at": [4.0, 0.0]},
            ]),
        ),
        (
            "overlaps",
            json!([{"segments": [1, 6], "ends": [[2.0, 0.0], [4.0, 0.0]]}]),
        ),
        ("crossings", json!([])),
    ];
    for (key, listed) in expected {
        let total = listed.as_array().expect("a list").len();
        assert_eq!(
            found[key],
            json!({"total": total, "listed": listed}),
            "{key}"
        );
    }
    assert_eq!(found["clean"], false);
    assert_eq!(found["base"], 1);
}

#[test]
fn counts_and_bounds_are_those_of_the_file() {
    let found = info(DIRTY, "");
    for (key, value) in [
        ("points", 10),
        ("segments", 9),
        ("polygons", 0),
        ("holes", 0),
        ("regions", 0),
    ] {
        assert_eq!(found[key], value, "{key}");
    }
    assert_eq!(found["bounds"], json!([[0.0, 0.0], [6.0, 4.0]]));
    assert_eq!(found["usual_rule"], "carve");
    assert_eq!(found["collinear"], false);
    let folder = Folder::new();
    folder.write("empty.wkt", "MULTIPOLYGON EMPTY");
    let empty = folder.run("info empty.wkt --json", 0).json();
    assert_eq!(empty["points"], 0);
    assert!(empty["bounds"].is_null());
}

#[test]
fn crossings_are_counted_all_and_listed_as_far_as_asked() {
    let crossed =
        "6 2 0 0\n0 0 0\n1 4 4\n2 0 4\n3 4 0\n4 0 2\n5 4 3\n3 0\n0 0 1\n1 2 3\n2 4 5\n0\n";
    let found = info(crossed, "");
    assert_eq!(found["crossings"]["total"], 3);
    assert_eq!(
        found["crossings"]["listed"][0],
        json!({"segments": [0, 1], "at": [2.0, 2.0]})
    );
    let found = info(crossed, " --limit 2");
    assert_eq!(found["crossings"]["total"], 3);
    assert_eq!(
        found["crossings"]["listed"].as_array().map(Vec::len),
        Some(2)
    );
    assert_eq!(
        info(crossed, " --limit 0")["crossings"]["listed"],
        json!([])
    );
}

#[test]
fn rings_know_what_is_around_them() {
    let folder = Folder::new();
    folder.run("sample lake -o lake.poly", 0);
    let lake = folder.run("info lake.poly --json", 0).json();
    assert_eq!(lake["clean"], true, "{lake}");
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
    folder.write("drawing.poly", DIRTY);
    let output = folder.run("info drawing.poly", 0);
    for words in [
        "drawing.poly: segments meet elsewhere than at common ends.",
        "10 points and 9 segments (rule: carve)",
        "1 duplicate point:\n    point 5 equals 1 at (0.0, 0.0)",
        "1 segment of no length:\n    segment 7 at (1.0, 1.0)",
        "1 repeated segment:\n    segment 5 equals 1: (4.0, 0.0) – (0.0, 0.0)",
        "2 points inside segments:",
        "1 pair of segments that overlap:\n    segments 1 and 6 from (2.0, 0.0) to (4.0, 0.0)",
        "count from 1",
    ] {
        assert!(output.stdout.contains(words), "{words}: {}", output.stdout);
    }
    let output = folder.run("info drawing.poly --limit 1", 0);
    assert!(
        output.stdout.contains("and 1 other (see --limit)"),
        "{}",
        output.stdout
    );
}

#[test]
fn points_alone_have_facts_too() {
    let folder = Folder::with_points();
    let found = folder.run("info points.csv --json", 0).json();
    assert_eq!(found["duplicates"]["total"], 1);
    assert_eq!(found["usual_rule"], "hull");
    let output = folder.run("info points.csv", 0);
    assert!(
        output.stdout.contains("points.csv: no segments."),
        "{}",
        output.stdout
    );
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
    folder.write("drawing.poly", DIRTY);
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
        .write_stdin(DIRTY)
        .assert()
        .code(0);
    assert_eq!(Output::of(assert).json()["file"], "-");
}
