//! The program itself, on very few points.

use std::path::PathBuf;
use std::process::{Command, Output};

fn bench(args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_delone-bench"))
        .args(args)
        .output()
        .expect("the program starts")
}

fn scratch_file(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name)
}

#[test]
fn one_command_prints_tables_and_writes_json() {
    let path = scratch_file("bench.json");
    let json = path.to_str().expect("a path in UTF-8");
    let output = bench(&[
        "--sizes=300,100",
        "--distributions=uniform,grid",
        "--peers=spade,delaunator",
        "--runs=2",
        "--warmups=1",
        "--repeats=2",
        "--json",
        json,
    ]);
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(output.status.success());
    assert_eq!(text.matches("\n| grid    | 300 |").count(), 4, "{text}");
    assert_eq!(text.matches("Largest ratio").count(), 3, "{text}");

    let json = std::fs::read_to_string(path).unwrap();
    let report: serde_json::Value = serde_json::from_str(&json).unwrap();
    let cells = report["cells"].as_array().unwrap();
    assert_eq!(cells.len(), 2 * 2 * 4);
    for cell in cells {
        assert_eq!(cell["verdict"], "right", "{cell}");
        assert_eq!(cell["fresh"].as_array().map(Vec::len), Some(2));
        assert_eq!(cell["repeated"].as_array().map(Vec::len), Some(2));
    }
}

#[test]
fn domains_have_a_table_of_their_own() {
    let output = bench(&[
        "--sizes=200",
        "--domains=segments,coast",
        "--peers=spade,cdt,i_triangle,ghx_constrained_delaunay",
        "--runs=1",
        "--warmups=0",
        "--repeats=1",
    ]);
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(output.status.success());
    assert_eq!(text.matches("\n| coast    | 200 |").count(), 4, "{text}");
    assert_eq!(text.matches("Largest ratio").count(), 3, "{text}");
    assert!(
        text.contains("ns a segment") && !text.contains(" on coast"),
        "{text}"
    );
}

#[test]
fn clean_and_crossing_domains_do_not_mix() {
    let output = bench(&["--domains=coast,tangle"]);
    let complaint = String::from_utf8(output.stderr).unwrap();
    assert!(!output.status.success());
    assert!(complaint.contains("`coast`") && complaint.contains("`tangle`"));
    assert!(
        !bench(&["--domains=coast", "--peers=delaunator"])
            .status
            .success()
    );
    assert!(
        !bench(&["--domains=coast", "--distributions=grid"])
            .status
            .success()
    );
}

#[test]
fn refinement_has_tables_of_its_own_and_goes_on_without_python() {
    let path = scratch_file("refine.json");
    let output = bench(&[
        "refine",
        "--outlines=square,holes:300",
        "--angles=20,25",
        "--areas=none,500",
        "--peers=triangle,spade",
        "--python=/nowhere/python",
        "--runs=2",
        "--warmups=0",
        "--json",
        path.to_str().expect("a path in UTF-8"),
    ]);
    let text = String::from_utf8(output.stdout).unwrap();
    let complaint = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success(), "{complaint}");
    assert!(
        complaint.contains("/nowhere/python: no process"),
        "{complaint}"
    );
    assert!(complaint.contains("triangle is left out"), "{complaint}");
    // Two loads, five tables each, two angles.
    assert_eq!(text.matches("\n| holes ").count(), 2 * 5 * 2, "{text}");
    let json = std::fs::read_to_string(path).unwrap();
    let report: serde_json::Value = serde_json::from_str(&json).unwrap();
    let cells = report["cells"].as_array().unwrap();
    assert_eq!(cells.len(), 2 * 2 * 2 * 3);
    for cell in cells {
        assert_eq!(cell["runs"].as_array().map(Vec::len), Some(2), "{cell}");
    }
}

#[test]
fn queries_have_a_section_for_each_room_and_go_on_without_python() {
    let path = scratch_file("queries.json");
    let output = bench(&[
        "queries",
        "--questions=undo,insert,natural,voronoi,nearest",
        "--distributions=uniform,grid",
        "--size=300",
        "--python=/nowhere/python",
        "--runs=2",
        "--warmups=0",
        "--json",
        path.to_str().expect("a path in UTF-8"),
    ]);
    let text = String::from_utf8(output.stdout).unwrap();
    let complaint = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success(), "{complaint}");
    assert!(complaint.contains("scipy is left out"), "{complaint}");
    let sections: Vec<_> = text.lines().filter(|l| l.starts_with("### ")).collect();
    assert_eq!(sections.len(), 4, "{text}");
    // Time, building and memory; what Voronoi diagrams take to build is not timed apart.
    for (question, tables) in [
        ("nearest", 3),
        ("voronoi", 2),
        ("natural", 3),
        ("insert", 3),
    ] {
        let rows = text.matches(&format!("\n| {question} ")).count();
        assert_eq!(rows, 2 * tables, "{question}\n{text}");
    }
    let json = std::fs::read_to_string(path).unwrap();
    let report: serde_json::Value = serde_json::from_str(&json).unwrap();
    let cells = report["cells"].as_array().unwrap();
    // Ours in three settings and three peers; two and three; three and one; one and one; ours alone.
    assert_eq!(cells.len(), 2 * (6 + 5 + 4 + 2 + 1));
    for cell in cells {
        assert_eq!(cell["runs"].as_array().map(Vec::len), Some(2), "{cell}");
    }
}

/// Runs only where `DELONE_PYTHON` names a Python with numpy and SciPy.
#[test]
fn scipy_agrees() {
    let Ok(python) = std::env::var("DELONE_PYTHON") else {
        eprintln!("skipped: DELONE_PYTHON names no Python");
        return;
    };
    let output = bench(&[
        "queries",
        "--distributions=uniform,lonlat",
        "--size=3000",
        "--python",
        &python,
        "--peers=scipy",
        "--threads=1",
        "--runs=1",
        "--warmups=0",
    ]);
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(
        output.status.success() && text.contains("| scipy "),
        "{text}"
    );
    assert!(
        !text.contains("wrong") && !text.contains("- scipy"),
        "{text}"
    );
}

#[test]
fn what_encloses_nothing_cannot_be_meshed() {
    let output = bench(&["refine", "--outlines=tangle"]);
    let complaint = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2));
    assert!(complaint.contains("encloses no area"), "{complaint}");
    let output = bench(&["refine", "--angles=60"]);
    assert_eq!(output.status.code(), Some(2));
}

#[test]
fn profiling_prints_every_run() {
    for (subject, unit) in [("line", "ns/point"), ("spiral", "ns/segment")] {
        let output = bench(&["profile", subject, "1k", "3"]);
        let text = String::from_utf8(output.stdout).unwrap();
        assert!(output.status.success());
        assert_eq!(text.lines().count(), 4, "{text}");
        let last = text.lines().last().unwrap();
        assert!(last.starts_with("min ") && last.ends_with(unit), "{last}");
    }
}

#[test]
fn unknown_names_are_refused_with_the_known_ones() {
    for args in [
        ["--peers=qhull"],
        ["--distributions=square"],
        ["--domains=uniform"],
        ["--threads=0"],
    ] {
        let output = bench(&args);
        assert_eq!(output.status.code(), Some(2), "{args:?}");
    }
    let complaint = String::from_utf8(bench(&["--peers=qhull"]).stderr).unwrap();
    assert!(complaint.contains("spade-stable"), "{complaint}");
}

#[test]
fn covers_are_checked_timed_and_drawn() {
    let [json, plot] = ["cover.json", "cover.svg"].map(scratch_file);
    let output = bench(&[
        "cover",
        "--sizes=300,600",
        "--data=uniform,tracks",
        "--least=6",
        "--runs=2",
        "--warmups=0",
        "--json",
        json.to_str().expect("a path in UTF-8"),
        "--plot",
        plot.to_str().expect("a path in UTF-8"),
    ]);
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(output.status.success(), "{text}");
    // Times, and what comes out.
    assert_eq!(text.matches("\n| tracks  |   600 |").count(), 2, "{text}");
    assert!(text.contains("no peer"), "{text}");
    let drawn = std::fs::read_to_string(plot).unwrap();
    assert!(drawn.contains("Algorithm B"), "{drawn}");
    let json = std::fs::read_to_string(json).unwrap();
    let report: serde_json::Value = serde_json::from_str(&json).unwrap();
    let cells = report["cells"].as_array().unwrap();
    assert_eq!(cells.len(), 4);
    for cell in cells {
        assert_eq!(cell["runs"].as_array().map(Vec::len), Some(2), "{cell}");
        assert_eq!(cell["facts"]["special"], 0, "{cell}");
    }
}
