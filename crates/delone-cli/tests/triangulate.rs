//! `delone triangulate`, seen from the shell.

mod support;

use serde_json::Value;
use support::{Folder, Output, POINTS, hash_by_hand};

fn keys(value: &Value) -> Vec<&str> {
    let object = value.as_object().expect("an object");
    object.keys().map(String::as_str).collect()
}

#[test]
fn json_is_one_object_with_the_documented_keys_and_the_right_values() {
    let folder = Folder::with_points();
    let output = folder.run("triangulate points.csv --json --threads 2", 0);
    let json = output.json();
    let mut expected = vec![
        "vertices",
        "triangles",
        "edges",
        "hull_edges",
        "duplicates",
        "carved",
        "segments",
        "constrained_edges",
        "crossings_split",
        "steiner",
        "threads",
        "hash",
        "seconds",
        "peak_rss_bytes",
    ];
    expected.sort_unstable();
    assert_eq!(keys(&json), expected);
    let phases = ["carve", "constrain", "read", "triangulate", "write"];
    assert_eq!(keys(&json["seconds"]), phases);
    for (key, value) in [
        ("vertices", 5),
        ("triangles", 4),
        ("edges", 8),
        ("hull_edges", 4),
        ("duplicates", 1),
        ("carved", 0),
        ("segments", 0),
        ("constrained_edges", 0),
        ("crossings_split", 0),
        ("steiner", 0),
        ("threads", 2),
    ] {
        assert_eq!(json[key], value, "{key}");
    }
    assert_eq!(json["hash"], hash_by_hand());
    assert!(json["seconds"]["triangulate"].as_f64().expect("a number") >= 0.0);
    assert_eq!(output.stderr, "");
    assert_eq!(folder.names(), ["points.csv"], "nothing else was asked for");
}

#[cfg(target_os = "linux")]
#[test]
fn the_peak_of_memory_is_that_of_this_process() {
    let folder = Folder::with_points();
    let json = folder.run("triangulate points.csv --json", 0).json();
    let peak = json["peak_rss_bytes"].as_u64().expect("Linux tells");
    assert!((1 << 20..200 << 20).contains(&peak), "{peak}");
}

#[test]
fn a_name_of_the_family_writes_the_family() {
    for name in ["mesh.ele", "mesh.node", "mesh.poly"] {
        let folder = Folder::with_points();
        let output = folder.run(&format!("triangulate points.csv -o {name}"), 0);
        for file in ["mesh.node", "mesh.ele", "mesh.edge", "mesh.neigh"] {
            assert!(folder.names().contains(&file.to_owned()), "{name} → {file}");
            output.says(&[file]);
        }
        assert!(folder.read("mesh.ele").starts_with("4 3 0\n"));
        folder.run("check mesh.ele", 0);
    }
}

#[test]
fn one_based_shifts_every_number() {
    let folder = Folder::with_points();
    folder.run("triangulate points.csv -o zero.ele", 0);
    folder.run("triangulate points.csv -o one.ele --one-based", 0);
    let rows = |name: &str| -> Vec<Vec<usize>> {
        let number = |w: &str| w.parse().expect("a number");
        let row = |l: &str| l.split_whitespace().map(number).collect();
        folder.read(name).lines().skip(1).map(row).collect()
    };
    let shifted: Vec<Vec<usize>> = rows("zero.ele")
        .into_iter()
        .map(|row| row.into_iter().map(|n| n + 1).collect())
        .collect();
    assert_eq!(rows("one.ele"), shifted);
    assert_eq!(rows("zero.ele").len(), 4);
    folder.run("check one.ele", 0);
}

#[test]
fn without_input_the_sample_leaves_mesh_and_picture() {
    let folder = Folder::new();
    let output = folder.run("triangulate", 0);
    assert_eq!(output.stdout, "");
    output.says(&[
        "628 vertices",
        "522 segments",
        "islands",
        "delone check lake.ele --domain drawing.poly",
    ]);
    assert!(!output.stderr.contains("note"), "{}", output.stderr);
    let files = ["edge", "ele", "neigh", "node", "png", "poly"];
    assert_eq!(folder.names(), files.map(|e| format!("lake.{e}")));
    folder.run("sample lake -o drawing.poly", 0);
    folder.run("check lake.ele --domain drawing.poly", 0);
}

#[test]
fn without_input_only_what_is_asked_for_is_written() {
    let folder = Folder::new();
    let json = folder.run("triangulate --json", 0).json();
    assert_eq!(json["vertices"], 628);
    assert_eq!(folder.names(), [""; 0]);
    folder.run("triangulate --picture map.svg", 0);
    assert_eq!(folder.names(), ["map.svg"]);
}

#[test]
fn without_output_nothing_is_written() {
    let folder = Folder::with_points();
    let output = folder.run("triangulate points.csv", 0);
    output.says(&["5 vertices", "4 triangles", "1 duplicate merged", "hash"]);
    assert_eq!(output.stdout, "");
    assert_eq!(folder.names(), ["points.csv"]);
}

#[test]
fn quiet_says_nothing() {
    let folder = Folder::with_points();
    let output = folder.run(
        "-q triangulate points.csv -o mesh.vtu --picture mesh.png",
        0,
    );
    assert_eq!(
        (output.stdout, output.stderr),
        (String::new(), String::new())
    );
    assert_eq!(folder.names(), ["mesh.png", "mesh.vtu", "points.csv"]);
}

#[test]
fn points_come_from_standard_input_and_the_mesh_goes_to_standard_output() {
    let folder = Folder::new();
    let assert = folder
        .command("triangulate - -o - --to ele")
        .write_stdin(POINTS)
        .assert()
        .code(0);
    let output = Output::of(assert);
    assert!(output.stdout.starts_with("4 3 0\n"), "{}", output.stdout);
    output.says(&["4 triangles"]);
    assert_eq!(folder.names(), [""; 0]);
}

#[test]
fn several_outputs_are_written_at_once() {
    let folder = Folder::with_points();
    folder.run(
        "triangulate points.csv -o a.ele -o b.vtu -o c.npy --picture d.svg",
        0,
    );
    for name in ["a.node", "b.vtu", "c.npy", "c.points.npy", "d.svg"] {
        assert!(folder.names().contains(&name.to_owned()), "{name}");
    }
    for name in ["a.ele", "b.vtu", "c.npy"] {
        let json = folder.run(&format!("check {name} --json"), 0).json();
        assert_eq!(json["hash"], hash_by_hand(), "{name}");
    }
}

#[test]
fn columns_are_chosen_by_name_or_place() {
    let folder = Folder::new();
    folder.write(
        "t.csv",
        "id,north,east\n7,0,0\n8,0,4\n9,3,4\n10,3,0\n11,1,1\n",
    );
    for columns in ["east,north", "3,2"] {
        let line = format!("triangulate t.csv --json --columns {columns}");
        assert_eq!(
            folder.run(&line, 0).json()["hash"],
            hash_by_hand(),
            "{columns}"
        );
    }
}

#[test]
fn order_of_points_and_number_of_threads_do_not_change_the_hash() {
    let folder = Folder::new();
    folder.run("sample uniform -n 3000 -o a.csv", 0);
    let text = folder.read("a.csv");
    let (header, rows) = text.split_once('\n').expect("a header");
    let mut rows: Vec<&str> = rows.lines().collect();
    rows.reverse();
    folder.write("b.csv", format!("{header}\n{}\n", rows.join("\n")));
    let hash = |line: &str| folder.run(line, 0).json()["hash"].clone();
    let first = hash("triangulate a.csv --json --threads 1");
    assert_eq!(first, hash("triangulate b.csv --json --threads 1"));
    for threads in [2, 4, 7] {
        assert_eq!(
            first,
            hash(&format!("triangulate a.csv --json --threads {threads}"))
        );
    }
}

#[test]
fn degenerate_inputs_have_defined_results() {
    let folder = Folder::new();
    for (points, vertices, triangles, edges) in [
        ("1,1\n", 1, 0, 0),
        ("1,1\n1,1\n", 1, 0, 0),
        ("1,1\n2,2\n", 2, 0, 1),
        ("0,0\n1,1\n2,2\n3,3\n", 4, 0, 3),
        ("0,0\n1,0\n1,1\n0,1\n", 4, 2, 5),
    ] {
        folder.write("p.csv", points);
        let json = folder.run("triangulate p.csv --json", 0).json();
        assert_eq!(json["vertices"], vertices, "{points}");
        assert_eq!(json["triangles"], triangles, "{points}");
        assert_eq!(json["edges"], edges, "{points}");
    }
}

#[test]
fn text_columns_left_out_are_mentioned() {
    let folder = Folder::new();
    folder.write("named.csv", "x,y,name\n0,0,a\n1,0,b\n0,1,c\n");
    folder
        .run("triangulate named.csv", 0)
        .says(&["note", "name"]);
    folder.write("broken.csv", "x,y,z\n0,0,1\n1,0,-\n0,1,2\n");
    folder
        .run("triangulate broken.csv", 0)
        .says(&["note", "z (line 3: \"-\")"]);
    assert_eq!(folder.run("-q triangulate named.csv", 0).stderr, "");
}

#[test]
fn of_a_mesh_only_the_points_are_used_and_that_is_mentioned() {
    let folder = Folder::with_points();
    folder.run("triangulate points.csv -o m.ele -o m.vtu -o m.npy", 0);
    for mesh in ["m.ele", "m.vtu", "m.npy"] {
        let output = folder.run(&format!("triangulate {mesh} -o again.ele"), 0);
        output.says(&[&format!("note: {mesh}: only the points"), "4 triangles"]);
        let json = folder.run("check again.ele --json", 0).json();
        assert_eq!(json["hash"], hash_by_hand(), "{mesh}");
    }
    for points in ["m.node", "m.points.npy"] {
        let output = folder.run(&format!("triangulate {points}"), 0);
        assert!(!output.stderr.contains("note"), "{}", output.stderr);
    }
    // Who names columns means the numbers of this very array.
    let json = folder
        .run("triangulate m.npy --columns 1,2 --json", 0)
        .json();
    assert_ne!(json["hash"], hash_by_hand());
}

#[cfg(unix)]
#[test]
fn the_name_of_the_device_means_standard_output() {
    let folder = Folder::with_points();
    let output = folder.run("-q triangulate points.csv -o /dev/stdout --to ele", 0);
    assert!(output.stdout.starts_with("4 3 0\n"), "{}", output.stdout);
}

#[cfg(unix)]
#[test]
fn a_closed_pipe_is_no_error() {
    use std::process::{Command, Stdio};
    let mut child = Command::new(assert_cmd::cargo::cargo_bin("delone"))
        .args(["sample", "uniform", "-n", "200000"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    drop(child.stdout.take());
    let output = child.wait_with_output().expect("the program ends");
    assert_eq!(output.status.code(), Some(0));
    assert_eq!(String::from_utf8_lossy(&output.stderr), "");
}
