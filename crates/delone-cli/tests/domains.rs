//! Segments, holes and regions, seen from the shell.

mod support;

use serde_json::Value;
use support::{Folder, Output};

/// A square of side 4 with a square hole, numbered from 1.
const HOLED: &str = "\
8 2 0 0
1 0 0
2 4 0
3 4 4
4 0 4
5 1 1
6 3 1
7 3 3
8 1 3
8 1
1 1 2 7
2 2 3 7
3 3 4 7
4 4 1 7
5 5 6 8
6 6 7 8
7 7 8 8
8 8 5 8
1
1 2 2
";

/// Of three segments the last two cross, at (2, 1.5); numbered from 1.
const CROSSED: &str = "\
5 2 0 0
1 0 0
2 4 0
3 4 3
4 0 3
5 9 9
3 0
1 3 5
2 4 2
3 1 3
0
";

fn with(files: &[(&str, &str)]) -> Folder {
    let folder = Folder::new();
    for (name, content) in files {
        folder.write(name, content);
    }
    folder
}

fn json(folder: &Folder, line: &str) -> Value {
    folder.run(&format!("{line} --json"), 0).json()
}

#[test]
fn a_poly_is_carved_and_its_holes_are_holes() {
    let folder = with(&[("holed.poly", HOLED)]);
    let json = json(&folder, "triangulate holed.poly");
    for (key, value) in [
        ("vertices", 8),
        ("triangles", 8),
        ("edges", 16),
        ("hull_edges", 8),
        ("carved", 0),
        ("segments", 8),
        ("constrained_edges", 8),
        ("crossings_split", 0),
    ] {
        assert_eq!(json[key], value, "{key}");
    }
    assert_eq!(json["seconds"].as_object().expect("an object").len(), 5);
    let output = folder.run("triangulate holed.poly", 0);
    output.says(&["8 triangles", "8 on the border", "8 segments"]);
}

#[test]
fn the_rule_can_be_chosen() {
    let without_hole = HOLED.replace("1\n1 2 2\n", "0\n");
    let folder = with(&[("rings.poly", &without_hole)]);
    let count =
        |rule: &str| json(&folder, &format!("triangulate rings.poly{rule}"))["triangles"].clone();
    assert_eq!(count(""), 10);
    assert_eq!(count(" --domain carve"), 10);
    assert_eq!(count(" --domain hull"), 10);
    assert_eq!(count(" --domain evenodd"), 8);
}

#[test]
fn polygons_of_geojson_and_wkt_are_evenodd_and_lines_keep_the_hull() {
    let rings = "[[0,0],[4,0],[4,4],[0,4],[0,0]],[[1,1],[3,1],[3,3],[1,3],[1,1]]";
    let polygon = format!("{{\"type\":\"Polygon\",\"coordinates\":[{rings}]}}");
    let wkt = "POLYGON((0 0,4 0,4 4,0 4,0 0),(1 1,3 1,3 3,1 3,1 1))";
    let line = "LINESTRING(0 0,4 0,4 4,0 4)";
    let folder = with(&[
        ("holed.poly", HOLED),
        ("a.geojson", &polygon),
        ("a.wkt", wkt),
        ("line.wkt", line),
    ]);
    let hash = json(&folder, "triangulate holed.poly")["hash"].clone();
    for file in ["a.geojson", "a.wkt"] {
        assert_eq!(
            json(&folder, &format!("triangulate {file}"))["hash"],
            hash,
            "{file}"
        );
    }
    // The .poly beside a mesh means the same domain by its own usual rule.
    assert_eq!(json(&folder, "triangulate a.wkt -o mesh.ele")["hash"], hash);
    assert_eq!(json(&folder, "triangulate mesh.poly")["hash"], hash);
    assert_eq!(json(&folder, "triangulate line.wkt")["triangles"], 2);
    assert_eq!(
        json(&folder, "triangulate a.wkt --domain hull")["triangles"],
        10
    );
}

#[test]
fn arrays_bring_their_segments_and_a_mesh_without_is_not_called_wrong() {
    let folder = with(&[("holed.poly", HOLED)]);
    folder.run("triangulate holed.poly -o mesh.npy -o mesh.vtu", 0);
    folder.run("check mesh.vtu --domain holed.poly", 0);
    folder.run("check mesh.npy --domain holed.poly", 0);
    std::fs::remove_file(folder.path().join("mesh.segments.npy")).expect("the segments");
    let output = folder.run("check mesh.npy --domain holed.poly", 3);
    output.says(&["holds no segments", ".vtu"]);
}

#[test]
fn segments_and_their_options_leave_bare_points_as_they_were() {
    let folder = Folder::with_points();
    let plain = json(&folder, "triangulate points.csv");
    let asked = json(
        &folder,
        "triangulate points.csv --domain hull --crossings split",
    );
    for key in [
        "vertices",
        "triangles",
        "edges",
        "hull_edges",
        "duplicates",
        "hash",
    ] {
        assert_eq!(plain[key], asked[key], "{key}");
    }
    assert_eq!(
        asked["seconds"]["constrain"].as_f64().map(|s| s < 1.0),
        Some(true)
    );
    assert_eq!(plain["seconds"]["constrain"], 0.0);
}

#[test]
fn crossings_are_refused_with_both_segments_in_the_numbers_of_the_file() {
    let folder = with(&[("crossed.poly", CROSSED)]);
    let output = folder.run("triangulate crossed.poly -o m.ele", 3);
    output.says(&[
        "crossed.poly: segments 2 and 3 cross at (2, 1.5)",
        "--crossings split",
        "numbered from 1",
    ]);
    assert_eq!(output.stderr.lines().count(), 1, "{}", output.stderr);
    assert_eq!(folder.names(), ["crossed.poly"]);
    folder.run("triangulate crossed.poly --crossings error", 3);
}

#[test]
fn crossings_are_split_on_request() {
    let folder = with(&[("crossed.poly", CROSSED)]);
    let line = "triangulate crossed.poly --crossings split --domain hull";
    let result = json(&folder, line);
    assert_eq!(result["crossings_split"], 1);
    assert_eq!(result["vertices"], 6);
    folder.run(line, 0).says(&["1 crossing split"]);
    folder.run(&format!("{line} -o m.ele"), 0);
    let check = "check m.ele --domain crossed.poly --rule hull --json";
    let certificate = folder.run(check, 0).json();
    assert_eq!(certificate["domain"]["added"], 1);
    assert_eq!(certificate["hash"], result["hash"]);
}

#[test]
fn a_seed_on_a_segment_is_refused_with_both_names() {
    let on_segment = HOLED.replace("1 2 2\n", "1 2 3\n");
    let folder = with(&[("seed.poly", &on_segment)]);
    folder.run("triangulate seed.poly", 3).says(&[
        "seed.poly: the point of hole 1 at (2, 3) lies on segment 7",
        "numbered from 1",
    ]);
}

#[test]
fn what_is_right_but_strange_is_noted() {
    let open = "3 2 0 0\n0 0 0\n1 4 0\n2 0 3\n1 0\n0 0 1\n1\n0 9 9\n";
    let folder = with(&[("open.poly", open)]);
    let output = folder.run("triangulate open.poly", 0);
    output.says(&[
        "note: open.poly: nothing is left",
        "0 vertices",
        "3 points carved away",
    ]);
    let output = folder.run("triangulate open.poly --domain hull", 0);
    output.says(&["note: open.poly: hole 0 at (9, 9)"]);
    assert_eq!(folder.run("-q triangulate open.poly", 0).stderr, "");
}

#[test]
fn bare_points_are_all_carved_if_one_insists() {
    let folder = Folder::with_points();
    let result = json(&folder, "triangulate points.csv --domain carve");
    assert_eq!(result["triangles"], 0);
    assert_eq!(result["vertices"], 0);
    assert_eq!(result["carved"], 5);
}

#[test]
fn a_domain_comes_from_standard_input() {
    let folder = Folder::new();
    let assert = folder
        .command("triangulate - --from poly --json")
        .write_stdin(HOLED)
        .assert()
        .code(0);
    assert_eq!(Output::of(assert).json()["triangles"], 8);
    let assert = folder
        .command("triangulate - --from poly")
        .write_stdin(CROSSED)
        .assert()
        .code(3);
    Output::of(assert).says(&["-: segments 2 and 3 cross"]);
}

#[test]
fn the_mesh_of_a_domain_has_a_poly_of_its_subsegments() {
    let folder = with(&[("holed.poly", HOLED)]);
    let output = folder.run("triangulate holed.poly -o m.ele", 0);
    output.says(&["m.node", "m.ele", "m.edge", "m.neigh", "m.poly"]);
    let again = json(&folder, "triangulate m.poly");
    assert_eq!(
        again["hash"],
        json(&folder, "triangulate holed.poly")["hash"]
    );
    // The input is never overwritten, nor is a .poly beside points.
    folder
        .run("triangulate holed.poly -o holed.ele", 2)
        .says(&["holed.ele with its file holed.poly", "is the input"]);
}

#[test]
fn order_and_threads_do_not_change_the_hash_of_a_domain() {
    let folder = Folder::new();
    folder.run("sample tangle -n 300 -o a.poly", 0);
    let line = "triangulate a.poly --crossings split --domain hull --threads";
    let first = json(&folder, &format!("{line} 1"));
    assert!(first["crossings_split"].as_u64() > Some(1000), "{first}");
    for threads in [2, 5] {
        let other = json(&folder, &format!("{line} {threads}"));
        assert_eq!(other["hash"], first["hash"]);
    }
}

#[test]
fn the_samples_are_domains() {
    let folder = Folder::new();
    for (sample, options, triangles) in [
        ("lake", "", 793),
        ("thesis", "", 9),
        ("thesis-two", "", 12),
        // 64 points, four crossings, 28 edges on the border.
        ("degenerate-grid", " --crossings split", 2 * 68 - 2 - 28),
    ] {
        folder.run(&format!("sample {sample} -o {sample}.poly"), 0);
        let result = json(&folder, &format!("triangulate {sample}.poly{options}"));
        assert_eq!(result["triangles"], triangles, "{sample}");
    }
    folder
        .run("triangulate degenerate-grid.poly", 3)
        .says(&["segments", "cross at (3.5, 3.5)"]);
    folder
        .run("sample coast -n 999 -o coast.poly", 0)
        .says(&["999 points and 999 segments"]);
    assert_eq!(json(&folder, "triangulate coast.poly")["triangles"], 997);
    // 22 holes: n vertices, all of them on h + 1 borders, make n + 2 h - 2 triangles.
    folder.run("sample holes -n 400 -o holes.poly", 0);
    let holes = json(&folder, "triangulate holes.poly");
    assert_eq!(holes["triangles"], 400 + 2 * 22 - 2);
}

#[test]
fn a_domain_sample_goes_to_standard_output_as_poly() {
    let folder = Folder::new();
    let thesis = folder.run("sample thesis", 0).stdout;
    assert!(thesis.starts_with("9 2 "), "{thesis}");
    assert_eq!(thesis, folder.run("sample thesis", 0).stdout);
    folder
        .run("sample thesis -o t.csv", 2)
        .says(&["t.csv", "cannot hold a domain", "poly"]);
    folder
        .run("sample uniform -o t.stl", 2)
        .says(&["t.stl", "cannot hold points"]);
}
