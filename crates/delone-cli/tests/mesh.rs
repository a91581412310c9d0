//! `delone mesh`, seen from the shell.

mod support;

use serde_json::Value;
use support::Folder;

/// A square of side 4, numbered from 1; its sides have markers 11 to 14, and its corners the
/// attribute 2x + 3y + 1.
const SQUARE: &str = "\
4 2 1 1
1 0 0 1 21
2 4 0 9 22
3 4 4 21 23
4 0 4 13 24
4 1
1 1 2 11
2 2 3 12
3 3 4 13
4 4 1 14
0
";

/// A wedge of one degree at point 1, between segments 1 and 3; numbered from 1.
const WEDGE: &str = "\
3 2 0 0
1 0 0
2 10 0
3 10 0.17455
3 0
1 1 2
2 2 3
3 3 1
0
";

/// A square of side 4 in two halves, the left one a region that wants small triangles.
const HALVES: &str = "\
6 2 0 0
0 0 0
1 2 0
2 4 0
3 4 4
4 2 4
5 0 4
7 0
0 0 1
1 1 2
2 2 3
3 3 4
4 4 5
5 5 0
6 1 4
0
2
0 1 2 7 0.02
1 3 2 8 -1
";

fn with(files: &[(&str, &str)]) -> Folder {
    let folder = Folder::new();
    for (name, content) in files {
        folder.write(name, content);
    }
    folder
}

fn square() -> Folder {
    with(&[("square.poly", SQUARE)])
}

fn json(folder: &Folder, line: &str) -> Value {
    folder.run(&format!("{line} --json"), 0).json()
}

fn number(json: &Value, key: &str) -> f64 {
    json[key]
        .as_f64()
        .unwrap_or_else(|| panic!("{key} is {}", json[key]))
}

fn keys(value: &Value) -> Vec<&str> {
    let object = value.as_object().expect("an object");
    object.keys().map(String::as_str).collect()
}

/// The rows of a file of Triangle's family, without the header and without numbers of rows.
fn rows(folder: &Folder, name: &str) -> Vec<Vec<f64>> {
    let cell = |word: &str| word.parse().expect("a number");
    let row = |line: &str| line.split_whitespace().skip(1).map(cell).collect();
    folder.read(name).lines().skip(1).map(row).collect()
}

#[test]
fn json_has_the_documented_keys_and_what_was_asked_is_reached() {
    let folder = square();
    let line = "mesh square.poly --min-angle 30 --max-edge 0.5 --max-area 0.06 --threads 2";
    let json = json(&folder, line);
    for key in [
        "vertices",
        "hash",
        "steiner",
        "steiner_on_segments",
        "min_angle_degrees",
        "max_edge",
        "max_area",
        "asked",
        "outcome",
        "unmet",
        "unexcused",
        "unmet_by_reason",
        "seconds",
        "peak_rss_bytes",
    ] {
        assert!(keys(&json).contains(&key), "{key}");
    }
    assert!(number(&json, "min_angle_degrees") >= 30.0);
    assert!(number(&json, "max_edge") <= 0.5);
    assert!(number(&json, "max_area") <= 0.06);
    assert!(number(&json, "triangles") >= 16.0 / 0.06);
    let steiner = number(&json, "steiner");
    assert_eq!(steiner, number(&json, "vertices") - 4.0);
    let on_segments = number(&json, "steiner_on_segments");
    assert!(4.0 * 7.0 <= on_segments && on_segments < steiner);
    assert_eq!(number(&json, "hull_edges"), on_segments + 4.0);
    assert_eq!(
        (&json["outcome"], &json["unmet"]),
        (&"complete".into(), &0.into())
    );
    let asked = &json["asked"];
    for (key, value) in [
        ("min_angle_degrees", 30.0),
        ("max_edge", 0.5),
        ("max_area", 0.06),
    ] {
        assert_eq!(number(asked, key), value);
    }
    assert_eq!(asked["sizing"], false);
    let reasons = [
        "gradation",
        "locked_boundary",
        "precision",
        "small_input_angle",
        "stopped",
    ];
    assert_eq!(keys(&json["unmet_by_reason"]), reasons);
    let phases = [
        "carve",
        "constrain",
        "read",
        "refine",
        "smooth",
        "triangulate",
        "write",
    ];
    assert_eq!(keys(&json["seconds"]), phases);
    assert_eq!(
        folder.names(),
        ["square.poly"],
        "nothing else was asked for"
    );
}

#[test]
fn each_bound_works_alone() {
    let folder = square();
    let plain = json(&folder, "mesh square.poly --min-angle 0");
    assert_eq!(
        (&plain["triangles"], &plain["steiner"]),
        (&2.into(), &0.into())
    );
    assert_eq!(plain["asked"]["min_angle_degrees"], Value::Null);
    let usual = json(&folder, "mesh square.poly");
    assert_eq!(usual["asked"]["min_angle_degrees"], 25.0);
    let edge = json(&folder, "mesh square.poly --min-angle 0 --max-edge 0.3");
    assert!(number(&edge, "max_edge") <= 0.3);
    let area = json(&folder, "mesh square.poly --min-angle 0 --max-area 0.01");
    assert!(number(&area, "max_area") <= 0.01 && number(&area, "max_edge") > 0.1);
}

#[test]
fn without_input_the_sample_leaves_mesh_picture_and_page() {
    let folder = Folder::new();
    let output = folder.run("mesh --max-edge 0.5", 0);
    assert_eq!(output.stdout, "");
    output.says(&[
        "islands",
        "Steiner points",
        "(asked: 25°)",
        "(asked: 0.5)",
        "0° ·",
        "1 triangle is not as asked, but excused",
        "meet at vertex",
        "open lake.html",
        "refined in",
    ]);
    let files = ["edge", "ele", "html", "neigh", "node", "png", "poly"];
    assert_eq!(folder.names(), files.map(|e| format!("lake.{e}")));
}

#[test]
fn only_what_is_asked_for_is_written() {
    let folder = Folder::new();
    folder.run("mesh --report page.html", 0);
    assert_eq!(folder.names(), ["page.html"]);
    folder.run("mesh --picture lake.svg", 0);
    assert_eq!(folder.names(), ["lake.svg", "page.html"]);
    let output = folder.run("-q mesh -o lake.vtu --report page.svg --report page.png", 0);
    assert_eq!((output.stdout.as_str(), output.stderr.as_str()), ("", ""));
    let names = ["lake.svg", "lake.vtu", "page.html", "page.png", "page.svg"];
    assert_eq!(folder.names(), names);
}

#[test]
fn the_mesh_is_the_same_for_any_number_of_threads_and_in_every_file() {
    let folder = square();
    let line = "mesh square.poly --max-area 0.02 --conforming";
    let one = json(&folder, &format!("{line} -t 1"))["hash"].clone();
    assert_eq!(json(&folder, &format!("{line} -t 4"))["hash"], one);
    folder.run(&format!("{line} -o m.ele -o m.vtu -o m.npy"), 0);
    // Of a conforming mesh of a convex domain every triangle is Delaunay, and all of the hull is there.
    for name in ["m.ele", "m.vtu", "m.npy"] {
        assert_eq!(
            json(&folder, &format!("check {name}"))["hash"],
            one,
            "{name}"
        );
    }
}

#[test]
fn steiner_points_inherit_attributes_and_markers() {
    let folder = square();
    folder.run("mesh square.poly --max-area 0.05 -o m.ele", 0);
    let nodes = rows(&folder, "m.node");
    assert!(nodes.len() > 200);
    for node in &nodes[4..] {
        let [x, y, attribute, marker] = node[..] else {
            panic!("{node:?}");
        };
        let expected = 2.0 * x + 3.0 * y + 1.0;
        assert!((attribute - expected).abs() < 1e-12, "{node:?}");
        let side = match (x, y) {
            (_, 0.0) => 11.0,
            (4.0, _) => 12.0,
            (_, 4.0) => 13.0,
            (0.0, _) => 14.0,
            _ => 0.0,
        };
        assert_eq!(marker, side, "{node:?}");
    }
}

#[test]
fn small_angles_of_the_input_are_excused_and_named_as_the_file_counts() {
    let folder = with(&[("wedge.poly", WEDGE)]);
    let json = json(&folder, "mesh wedge.poly");
    assert!(number(&json, "unmet") >= 1.0);
    assert_eq!(json["unmet"], json["unmet_by_reason"]["small_input_angle"]);
    assert_eq!(
        (&json["unexcused"], &json["outcome"]),
        (&0.into(), &"complete".into())
    );
    assert!((number(&json, "min_angle_degrees") - 1.0).abs() < 0.01);
    folder.run("mesh wedge.poly", 0).says(&[
        "excused",
        "segments 1 and 3 meet at vertex 1 at 1°",
        "(numbered from 1)",
    ]);
}

#[test]
fn corners_of_the_hull_of_bare_points_are_named_by_their_ends() {
    let folder = with(&[("p.csv", "x,y\n0,0\n10,0\n10,0.2\n")]);
    let output = folder.run("mesh p.csv", 0);
    output.says(&["the hull's edge from 0 to 1 and the hull's edge from 2 to 0 meet at vertex 0"]);
}

#[test]
fn a_budget_that_does_not_suffice_is_4_and_the_mesh_is_written() {
    let folder = square();
    let line = "mesh square.poly --max-area 0.01 --max-vertices 30 -o m.ele";
    let output = folder.run(&format!("{line} --json"), 4);
    let json = output.json();
    assert_eq!(
        (&json["outcome"], &json["vertices"]),
        (&"budget_exhausted".into(), &30.into())
    );
    assert_eq!(json["unmet_by_reason"]["stopped"], json["unexcused"]);
    assert!(folder.read("m.node").starts_with("30 2 1 1\n"));
    output.says(&[
        "\"error\":\"square.poly: ",
        "triangles are not as asked, and the input is no excuse",
        "near (",
        "--max-vertices",
    ]);
    folder
        .run("mesh square.poly --max-vertices 0 --max-edge 3", 4)
        .says(&["2 of 2 triangles are not as asked"]);
    // Errors are said even to those who want quiet.
    folder.run(&format!("-q {line}"), 4).says(&["not as asked"]);
    let output = folder.run("mesh square.poly --max-area 1e-5 --max-time 1e-9", 4);
    output.says(&["--max-time", "with area "]);
    let output = folder.run(
        "mesh square.poly --min-angle 0 --max-edge 1 --max-vertices 4",
        4,
    );
    output.says(&[
        "with edge 5.657 above 1",
        "the work stopped before its turn",
    ]);
}

#[test]
fn a_boundary_may_be_kept() {
    let folder = with(&[("square.poly", SQUARE), ("halves.poly", HALVES)]);
    let free = json(&folder, "mesh square.poly --max-area 0.05");
    assert!(number(&free, "steiner_on_segments") > 0.0);
    for option in [
        "--keep-boundary",
        "--keep-boundary=all",
        "--keep-boundary=outer",
    ] {
        let json = json(
            &folder,
            &format!("mesh square.poly --max-area 0.05 {option}"),
        );
        assert_eq!(json["steiner_on_segments"], 0, "{option}");
        assert!(number(&json, "steiner") > 0.0, "{option}");
        assert_eq!(json["unexcused"], 0, "{option}");
    }
    let line = "mesh halves.poly --min-angle 20 --max-area 1 --keep-boundary=outer";
    let halves = json(&folder, line);
    assert!(number(&halves, "steiner_on_segments") > 0.0);
    assert_eq!(halves["hull_edges"], 6);
    // Triangles at the ends of what splits the domain would need a vertex on its boundary.
    assert_eq!(
        halves["unmet_by_reason"]["locked_boundary"],
        halves["unmet"]
    );
    assert!(number(&halves, "unmet") > 0.0);
    let line = "mesh halves.poly --min-angle 20 --max-area 1 --keep-boundary";
    assert_eq!(json(&folder, line)["steiner_on_segments"], 0);
}

#[test]
fn regions_may_bound_areas() {
    let folder = with(&[("square.poly", SQUARE), ("halves.poly", HALVES)]);
    let coarse = json(&folder, "mesh halves.poly");
    let fine = json(&folder, "mesh halves.poly --area-per-region");
    assert!(number(&coarse, "triangles") < 100.0);
    assert!(number(&fine, "triangles") > 8.0 / 0.02);
    assert_eq!(fine["asked"]["area_per_region"], true);
    folder
        .run("mesh square.poly --area-per-region", 0)
        .says(&["note: --area-per-region: no region"]);
}

#[test]
fn sizes_may_depend_on_the_place() {
    let folder = square();
    let line = "mesh square.poly --sizing 0.02+0.5*hypot(x,y) -o m.ele";
    let json = json(&folder, line);
    assert_eq!(json["asked"]["sizing"], true);
    let nodes = rows(&folder, "m.node");
    let longest = |corners: &[f64]| {
        let at = |c: f64| [nodes[c as usize][0], nodes[c as usize][1]];
        let [a, b, c] = [at(corners[0]), at(corners[1]), at(corners[2])];
        let length = |p: [f64; 2], q: [f64; 2]| (p[0] - q[0]).hypot(p[1] - q[1]);
        let middle = [0, 1].map(|k| (a[k] + b[k] + c[k]) / 3.0);
        let longest = length(a, b).max(length(b, c)).max(length(c, a));
        (longest, middle[0].hypot(middle[1]))
    };
    let triangles = rows(&folder, "m.ele");
    for (length, distance) in triangles.iter().map(|row| longest(row)) {
        assert!(
            length <= 0.02 + 0.5 * distance + 1e-9,
            "{length} at {distance}"
        );
    }
    // Far from the corner triangles are as large as they may be.
    assert!(triangles.len() < 2000, "{}", triangles.len());
    folder.write("sizes.csv", "x,y,size\n0,0,1\n4,4,1\n4,0,1\n");
    let line = "mesh square.poly --sizing sizes.csv:size -o sizes.vtu --report sizes.svg";
    folder.run(line, 0);
    folder.run("mesh square.poly --sizing x+ ", 2).says(&["x+"]);
    folder
        .run("mesh square.poly --sizing nowhere.csv:size", 3)
        .says(&["nowhere.csv"]);
}

#[test]
fn a_file_of_sizes_is_not_overwritten() {
    let folder = square();
    folder.run("mesh square.poly -o old.vtu", 0);
    let before = folder.bytes("old.vtu");
    folder
        .run("mesh square.poly --sizing old.vtu:attribute1 -o old.vtu", 2)
        .says(&["old.vtu is the input"]);
    assert_eq!(folder.bytes("old.vtu"), before);
}

#[test]
fn the_thesis_opens_its_two_edges_and_falls_back_when_it_must() {
    let folder = Folder::new();
    folder.run("sample thesis -o thesis.poly", 0);
    let line = "mesh thesis.poly --strategy thesis --max-edge 3 --min-angle";
    let opened = json(&folder, &format!("{line} 20"));
    assert_eq!(
        (&opened["triangles"], &opened["outcome"]),
        (&13.into(), &"complete".into())
    );
    assert!((number(&opened, "min_angle_degrees") - 26.565).abs() < 1e-3);
    let output = folder.run(&format!("{line} 40 --json -o m.ele"), 4);
    assert_eq!(output.json()["outcome"], "fell_back");
    assert!((number(&output.json(), "min_angle_degrees") - 18.435).abs() < 1e-3);
    assert!(folder.read("m.ele").starts_with("10 3 0\n"));
    output.says(&["not as asked", "--strategy thesis"]);
}

#[test]
fn bold_angles_are_warned_of() {
    let folder = square();
    let output = folder.run("mesh square.poly --min-angle 33", 0);
    assert!(!output.stderr.contains("note"), "{}", output.stderr);
    let output = folder.run("mesh square.poly --min-angle 33.5", 0);
    output.says(&["note: above 33°", "5,000,004 vertices", "--max-vertices"]);
    let output = folder.run("mesh square.poly --min-angle 33.5 --max-vertices 1000", 0);
    assert!(!output.stderr.contains("note"), "{}", output.stderr);
}

#[test]
fn triangles_may_have_six_nodes() {
    let folder = square();
    folder.run("mesh square.poly -o m.ele -o m.vtu --quadratic", 0);
    assert!(
        folder
            .read("m.ele")
            .lines()
            .next()
            .expect("a header")
            .contains(" 6 ")
    );
    folder
        .run("mesh square.poly -o m.npy --quadratic", 2)
        .says(&["npy cannot hold triangles of six nodes", "vtu"]);
}

#[test]
fn crossings_and_rules_are_those_of_triangulate() {
    let crossed = SQUARE.replace("\n4 1\n", "\n6 1\n");
    let crossed = crossed.replace("\n0\n", "\n5 1 3 0\n6 2 4 0\n0\n");
    let ring = "POLYGON((0 0,4 0,4 4,0 4,0 0),(1 1,3 1,3 3,1 3,1 1))";
    let folder = with(&[("crossed.poly", &crossed), ("ring.wkt", ring)]);
    folder
        .run("mesh crossed.poly", 3)
        .says(&["segments", "cross at (2, 2)", "--crossings split"]);
    let split = json(&folder, "mesh crossed.poly --crossings split");
    assert_eq!(split["crossings_split"], 1);
    for (rule, triangles) in [("", 8), (" --domain hull", 10)] {
        let json = json(&folder, &format!("mesh ring.wkt --min-angle 0{rule}"));
        assert_eq!(json["triangles"], triangles, "{rule}");
    }
}

#[test]
fn an_input_without_area_is_a_mesh_without_triangles() {
    let folder = with(&[("line.csv", "0,0\n1,1\n2,2\n")]);
    let json = json(&folder, "mesh line.csv --max-edge 0.5");
    assert_eq!((&json["triangles"], &json["unmet"]), (&0.into(), &0.into()));
    assert_eq!(json["min_angle_degrees"], Value::Null);
    folder
        .run("mesh line.csv --report page.html -o m.ele", 0)
        .says(&["0 triangles", "there is no triangle"]);
}

#[test]
fn wrong_usage_is_2() {
    let folder = square();
    for (line, words) in [
        ("--min-angle 60", &["--min-angle", "below 60"][..]),
        ("--min-angle -1", &["--min-angle", "at least 0"]),
        ("--max-area -1", &["--max-area", "positive"]),
        ("--max-vertices -1", &["--max-vertices", "invalid"]),
        ("--sizing -x+", &["--sizing", "no expression"]),
        ("--max-edge 0", &["--max-edge", "positive"]),
        ("--max-area x", &["--max-area"]),
        ("--max-time=-1", &["--max-time"]),
        ("--max-vertices few", &["--max-vertices"]),
        ("--keep-boundary=inner", &["inner", "outer"]),
        ("--strategy ask", &["ask", "thesis"]),
        ("--smooth 1001", &["1001"]),
        ("--report -", &["a report needs a file"]),
        (
            "--report page.vtu",
            &["page.vtu", "vtu cannot hold a report", "html"],
        ),
        ("-o page.html", &["html cannot hold a mesh"]),
        ("--report p.svg --picture p.svg", &["both write p.svg"]),
        ("--strategy thesis --max-area 1", &["thesis", "--max-area"]),
        (
            "--strategy thesis --conforming",
            &["thesis", "--conforming"],
        ),
        (
            "--strategy thesis --keep-boundary",
            &["thesis", "--keep-boundary"],
        ),
    ] {
        folder
            .run(&format!("mesh square.poly {line}"), 2)
            .says(words);
    }
    assert_eq!(folder.names(), ["square.poly"]);
}

/// A square of side 4 in two triangles of attributes 7 and 8, the second of which wants small ones.
fn old_mesh() -> Folder {
    with(&[
        ("old.node", "4 2 0 0\n1 0 0\n2 4 0\n3 4 4\n4 0 4\n"),
        ("old.ele", "2 3 1\n1 1 2 3 7\n2 1 3 4 8\n"),
        ("old.area", "2\n1 -1\n2 0.05\n"),
    ])
}

#[test]
fn a_mesh_is_refined_as_its_area_file_asks_and_hands_attributes_down() {
    let folder = old_mesh();
    let all = json(&folder, "mesh old.ele");
    assert!(number(&all, "triangles") < 10.0);
    let line = "mesh old.ele --area-per-region --one-based -o new.ele";
    let fine = json(&folder, line);
    assert_eq!(
        (&fine["unmet"], &fine["asked"]["sizing"]),
        (&0.into(), &false.into())
    );
    let vertices = rows(&folder, "new.node");
    let mut fine = 0;
    for row in rows(&folder, "new.ele") {
        let [a, b, c] = [row[0], row[1], row[2]].map(|v| &vertices[v as usize - 1]);
        let area = ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2.0;
        let [x, y] = [0, 1].map(|k| (a[k] + b[k] + c[k]) / 3.0);
        assert_eq!(row[3], if x > y { 7.0 } else { 8.0 }, "({x}, {y})");
        if y > x {
            fine += 1;
            assert!(area <= 0.05, "{area}");
        }
    }
    assert!(fine >= 160, "{fine}");
    folder.run("check new.ele", 0);
    // A mesh may be meshed again, from other formats too.
    folder.run("mesh new.ele --max-area 1 -o new.vtu", 0);
    let again = json(&folder, "mesh new.vtu --min-angle 20");
    assert!(number(&again, "triangles") >= 160.0);
}

#[test]
fn area_files_must_fit_and_are_missed_if_asked_for() {
    let folder = old_mesh();
    folder.write("old.area", "1\n1 0.5\n");
    folder.run("mesh old.ele", 0);
    let output = folder.run("mesh old.ele --area-per-region", 3);
    output.says(&["old.area", "bounds for 1 triangles, but the mesh has 2"]);
    std::fs::remove_file(folder.path().join("old.area")).expect("a file");
    let output = folder.run("mesh old.ele --area-per-region", 0);
    output.says(&["no region of the input has a largest area", ".area file"]);
    folder
        .run("mesh old.ele -o old.ele", 2)
        .says(&["is the input"]);
}

#[test]
fn points_beside_a_mesh_are_meshed_as_points() {
    let folder = old_mesh();
    let json = json(&folder, "mesh old.node --max-area 1");
    assert_eq!(json["segments"], 0);
}

#[test]
fn a_report_says_how_the_mesh_was_made() {
    let folder = square();
    let line = "mesh square.poly --sizing 0.5+x --threads 1 --report page.html --json";
    let hash = folder.run(line, 0).json()["hash"]
        .as_str()
        .expect("text")
        .to_owned();
    let page = folder.read("page.html");
    for words in [
        "0.5+x",
        "1 thread",
        &hash,
        "delone mesh square.poly --sizing 0.5+x",
    ] {
        assert!(page.contains(words), "{words}");
    }
}
