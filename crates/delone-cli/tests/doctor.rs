//! `delone doctor`, seen from the shell: troubles in the numbers of the file, pictures, repairs.

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

/// A square that misses closing by 0.01, with a line that falls short by 0.02, and markers.
const SLOPPY: &str = "\
8 2 1 1
0 0 0     1 0
1 4 0     2 0
2 4 4     3 0
3 0 4     4 0
4 0 0.01  5 9
5 2 0.02  6 0
6 2 3     7 0
7 3 2     8 0
6 1
0 0 1 5
1 1 2 6
2 2 3 7
3 3 4 8
4 5 6 0
5 5 7 2
0
1
0 1 1 7 0.5
";

fn doctor(text: &str, options: &str, code: i32) -> Value {
    let folder = Folder::new();
    folder.write("drawing.poly", text);
    folder
        .run(&format!("doctor drawing.poly --json{options}"), code)
        .json()
}

fn kind<'v>(found: &'v Value, kind: &str) -> &'v Value {
    let troubles = found["troubles"].as_array().expect("a list");
    let mut such = troubles.iter().filter(|t| t["kind"] == kind);
    such.next().unwrap_or(&Value::Null)
}

#[test]
fn every_trouble_is_named_with_numbers_and_coordinates() {
    let found = doctor(DIRTY, "", 5);
    assert_eq!(found["base"], 1);
    assert_eq!(found["healthy"], false);
    assert_eq!(found["errors"], 0);
    let duplicate = &kind(&found, "duplicate")["listed"][0];
    assert_eq!(duplicate["points"], json!([5, 1]));
    assert_eq!(duplicate["at"], json!([0.0, 0.0]));
    assert_eq!(
        kind(&found, "zero_length")["listed"][0]["segments"],
        json!([7])
    );
    assert_eq!(
        kind(&found, "repeated")["listed"][0]["segments"],
        json!([5, 1])
    );
    let on = &kind(&found, "vertex_on_segment");
    assert_eq!(on["total"], 2);
    assert_eq!(on["listed"][0]["points"], json!([6]));
    assert_eq!(on["listed"][1]["segments"], json!([6]));
    let overlap = &kind(&found, "overlap")["listed"][0];
    assert_eq!(overlap["segments"], json!([1, 6]));
    assert_eq!(
        [&overlap["at"], &overlap["to"]],
        [&json!([2.0, 0.0]), &json!([4.0, 0.0])]
    );
    assert!(kind(&found, "crossing").is_null());
    assert_eq!(overlap["number"], 1, "the worst is the first");
}

#[test]
fn crossings_are_errors_counted_all_and_listed_as_far_as_asked() {
    let crossed =
        "6 2 0 0\n0 0 0\n1 4 4\n2 0 4\n3 4 0\n4 0 2\n5 4 3\n3 0\n0 0 1\n1 2 3\n2 4 5\n0\n";
    let found = doctor(crossed, "", 5);
    assert_eq!(found["errors"], 3);
    let crossing = &kind(&found, "crossing")["listed"][0];
    assert_eq!(crossing["segments"], json!([0, 1]));
    assert_eq!(crossing["at"], json!([2.0, 2.0]));
    for (limit, listed) in [(2, 2), (0, 0)] {
        let found = doctor(crossed, &format!(" --limit {limit}"), 5);
        let crossings = kind(&found, "crossing");
        assert_eq!(crossings["total"], 3);
        assert_eq!(crossings["listed"].as_array().map(Vec::len), Some(listed));
    }
}

#[test]
fn words_say_the_same() {
    let folder = Folder::new();
    folder.write("drawing.poly", DIRTY);
    let output = folder.run("doctor drawing.poly", 5);
    for words in [
        "drawing.poly: 0 errors,",
        "10 points and 9 segments; exact, no tolerance",
        "note: 1 duplicate point. They are merged",
        "point 5 equals 1 at (0.0, 0.0)",
        "segment 7 at (1.0, 1.0)",
        "segment 5 equals 1 from (4.0, 0.0) to (0.0, 0.0)",
        "warning: 2 points inside segments.",
        "1. segments 1 and 6 overlap from (2.0, 0.0) to (4.0, 0.0)",
        "count from 1",
    ] {
        assert!(output.stdout.contains(words), "{words}: {}", output.stdout);
    }
    let output = folder.run("doctor drawing.poly --limit 1", 5);
    let words = "and 1 other (see --limit)";
    assert!(output.stdout.contains(words), "{}", output.stdout);
}

#[test]
fn samples_are_healthy() {
    let folder = Folder::new();
    folder.run("sample lake -o lake.poly", 0);
    let lake = folder.run("doctor lake.poly --json", 0).json();
    assert_eq!(lake["healthy"], true, "{lake}");
    let folder = Folder::with_points();
    let points = folder.run("doctor points.csv --json", 0).json();
    assert_eq!(kind(&points, "duplicate")["total"], 1);
}

#[test]
fn a_tolerance_is_suggested_and_mends() {
    let found = doctor(SLOPPY, "", 5);
    assert_eq!(found["suggestion"], 0.01);
    assert_eq!(kind(&found, "unclosed_ring")["listed"][0]["size"], 0.01);
    assert_eq!(kind(&found, "nothing")["total"], 1);
    let folder = Folder::new();
    folder.write("sloppy.poly", SLOPPY);
    let done = folder
        .run(
            "doctor sloppy.poly --tolerance 0.02 --repair clean.poly --json",
            0,
        )
        .json();
    let repair = &done["repair"];
    assert_eq!(repair["healthy"], true, "{done}");
    assert_eq!(repair["moved"]["total"], 1);
    assert_eq!(
        repair["moved"]["listed"][0],
        json!([4, [0.0, 0.01], [0.0, 0.0], 0.01])
    );
    assert_eq!(repair["merged"]["listed"], json!([[4, 0]]));
    assert_eq!(repair["split"]["listed"][0][0], 0);
    assert_eq!(repair["closed"], 1);
    assert_eq!(repair["dropped"], 1);
    let again = folder
        .run("doctor clean.poly --tolerance 0.02 --json", 0)
        .json();
    assert_eq!(again["healthy"], true);
    // Markers, attributes and regions have come along: of the merged points the one that stays took over a
    // marker, both halves of the cut side have that of the whole.
    let info = folder.run("info clean.poly --json", 0).json();
    assert_eq!(
        info["segment_markers"]["listed"],
        json!([[0, 1], [2, 1], [5, 2], [6, 1], [7, 1], [8, 1]])
    );
    assert_eq!(info["point_markers"]["listed"], json!([[0, 6], [9, 1]]));
    assert_eq!(info["regions"]["listed"][0]["attribute"], 7.0);
    assert_eq!(info["columns"][0]["largest"], 8.0);
    assert_eq!(info["points"], 7);
    folder.run("triangulate clean.poly", 0);
}

#[test]
fn crossings_are_cut_and_attributes_interpolated() {
    let folder = Folder::new();
    folder.write(
        "x.poly",
        "4 2 1 0\n0 0 0 1\n1 4 4 5\n2 0 4 0\n3 4 0 0\n2 0\n0 0 1\n1 2 3\n0\n",
    );
    // Two lines enclose nothing, which is told of the result, too.
    let output = folder.run("doctor x.poly --repair y.poly", 5);
    assert!(
        output.stdout.contains("cut segments at 1 crossing"),
        "{}",
        output.stdout
    );
    assert!(
        folder.read("y.poly").contains("4 2 2 3"),
        "{}",
        folder.read("y.poly")
    );
    folder
        .run("doctor x.poly --repair - --to poly", 5)
        .says(&["cut segments at 1 crossing"]);
    folder.run("triangulate y.poly --domain hull", 0);
}

#[test]
fn polygons_become_seeds_of_holes_or_stay() {
    let folder = Folder::new();
    // Two squares that cross, one of them with a hole.
    folder.write(
        "two.wkt",
        "MULTIPOLYGON(((0 0,4 0,4 4,0 4,0 0),(1 1,2 1,2 2,1 2,1 1)),((3 3,6 3,6 6,3 6,3 3)))",
    );
    folder.run("doctor two.wkt --repair flat.poly", 0);
    let flat = folder.run("info flat.poly --json", 0).json();
    assert_eq!(flat["holes"], 1);
    assert_eq!(flat["segments"], 16);
    folder.run("doctor two.wkt --repair two.geojson", 0);
    let kept = folder.run("info two.geojson --json", 0).json();
    assert_eq!(kept["polygons"], 2);
    // The same triangles from both.
    let triangles = |file: &str| {
        folder.run(&format!("triangulate {file} --json"), 0).json()["triangles"].clone()
    };
    assert_eq!(triangles("flat.poly"), triangles("two.geojson"));
}

#[test]
fn pictures_and_features_show_what_is_listed() {
    let folder = Folder::new();
    folder.write("drawing.poly", DIRTY);
    folder.run("doctor drawing.poly --picture d.svg --geojson d.geojson", 5);
    folder.run("doctor drawing.poly -p d.png", 5);
    let features: Value = serde_json::from_str(&folder.read("d.geojson")).expect("JSON");
    let features = features["features"].as_array().expect("a list");
    let found = folder.run("doctor drawing.poly --json", 5).json();
    let total = |key: &str| found[key].as_u64().expect("a count");
    assert_eq!(
        features.len() as u64,
        total("errors") + total("warnings") + total("notes")
    );
    assert_eq!(features[0]["properties"]["kind"], "overlap");
    assert_eq!(features[0]["properties"]["severity"], "warning");
    assert_eq!(features[0]["geometry"]["type"], "LineString");
    assert!(folder.read("d.svg").starts_with("<svg"));
    assert!(folder.bytes("d.png").starts_with(b"\x89PNG"));
}

#[test]
fn wrong_usage_is_said() {
    let folder = Folder::new();
    folder.write("a.poly", DIRTY);
    folder.write("b.poly", DIRTY);
    for (line, words) in [
        ("doctor a.poly b.poly --repair c.poly", "single file"),
        ("doctor a.poly --repair a.poly", "a.poly"),
        (
            "doctor a.poly --repair - --to poly --json",
            "standard output",
        ),
        ("doctor a.poly --tolerance=-1", "tolerance"),
        ("doctor a.poly --picture p.geojson", "--geojson"),
    ] {
        folder.run(line, 2).says(&[words]);
    }
    let output = folder.run("doctor a.poly nowhere.poly b.poly --json", 3);
    assert_eq!(output.stdout.lines().count(), 2);
    let assert = folder
        .command("doctor - --from poly --json")
        .write_stdin(DIRTY)
        .assert()
        .code(5);
    assert_eq!(Output::of(assert).json()["file"], "-");
}
