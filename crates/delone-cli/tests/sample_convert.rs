//! `delone sample` and `delone convert`, seen from the shell.

mod support;

use support::{Folder, hash_by_hand};

#[test]
fn samples_are_listed() {
    let list = Folder::new().run("sample", 0).stdout;
    for name in [
        "populated-places",
        "Natural Earth",
        "uniform",
        "kuzmin",
        "tilted-grid",
        "lake",
        "coast",
        "thesis-two",
        "degenerate-grid",
    ] {
        assert!(list.contains(name), "{name}");
    }
}

#[test]
fn generated_samples_have_the_count_and_depend_on_the_seed_alone() {
    let folder = Folder::new();
    let text = |line: &str| folder.run(line, 0).stdout;
    let seven = text("sample gauss -n 50 --seed 7");
    assert_eq!(seven, text("sample gauss -n 50 --seed 7"));
    assert_ne!(seven, text("sample gauss -n 50 --seed 8"));
    assert_eq!(
        seven
            .lines()
            .filter(|l| l.starts_with(['-', '0', '1', '2']))
            .count(),
        50
    );
}

#[test]
fn a_sample_is_the_same_in_every_format() {
    let folder = Folder::new();
    folder.run(
        "sample kuzmin -n 200 -o a.csv -o a.npy -o a.node -o a.xyz",
        0,
    );
    let hash =
        |file: &str| folder.run(&format!("triangulate {file} --json"), 0).json()["hash"].clone();
    let csv = hash("a.csv");
    for file in ["a.npy", "a.node", "a.xyz"] {
        assert_eq!(hash(file), csv, "{file}");
    }
}

#[test]
fn the_embedded_sample_can_be_had_as_a_file() {
    let folder = Folder::new();
    folder
        .run("sample populated-places -o cities.csv", 0)
        .says(&["1,249 points", "cities.csv"]);
    let json = folder.run("triangulate cities.csv --json", 0).json();
    assert_eq!(
        (&json["vertices"], &json["segments"]),
        (&1249.into(), &0.into())
    );
    assert!(folder.read("cities.csv").starts_with("x,y,population\n"));
}

#[test]
fn points_are_converted_back_and_forth() {
    let folder = Folder::with_points();
    folder
        .run("convert points.csv a.npy", 0)
        .says(&["6 points", "a.npy"]);
    folder.run("convert a.npy b.node --one-based", 0);
    folder.run("convert b.node c.csv", 0);
    let json = folder.run("triangulate c.csv --json", 0).json();
    assert_eq!(json["hash"], hash_by_hand());
    assert_eq!(json["duplicates"], 1);
}

#[test]
fn points_go_into_every_format_that_has_points() {
    let folder = Folder::new();
    folder.write("p.csv", "x,y,z\n0,0,1\n4,0.1,9\n4,3,2.5\n0,3,1\n4,3,7\n");
    let csv = folder.run("triangulate p.csv --json", 0).json();
    let written = folder.run("formats --json", 0).json();
    let formats = written.as_array().expect("a list");
    let can = |format: &serde_json::Value, what: &str| {
        let list = format[what].as_array().expect("a list");
        list.contains(&"points".into())
    };
    let both = formats
        .iter()
        .filter(|f| can(f, "reads") && can(f, "writes"));
    let names: Vec<_> = both.filter_map(|f| f["name"].as_str()).collect();
    assert!(names.contains(&"geojson") && names.contains(&"poly"));
    // What is read from a picture are its paths.
    for name in names
        .into_iter()
        .filter(|name| !["csv", "svg"].contains(name))
    {
        folder.run(&format!("-q convert p.csv p.{name}"), 0);
        folder.run(&format!("-q convert p.{name} {name}.npy --points"), 0);
        let found = folder.run(&format!("triangulate {name}.npy --json"), 0);
        for key in ["hash", "duplicates"] {
            assert_eq!(found.json()[key], csv[key], "{name}: {key}");
        }
    }
    assert!(folder.read("p.geojson").contains("[4,0.1,9]"));
}

#[test]
fn meshes_are_converted_back_and_forth() {
    let folder = Folder::with_points();
    folder.run("triangulate points.csv -o a.ele", 0);
    folder.run("convert a.ele b.vtu", 0).says(&["4 triangles"]);
    folder.run("convert b.vtu c.npy", 0);
    folder.run("convert c.npy d.node --one-based", 0);
    let json = folder.run("check d.ele --json", 0).json();
    assert_eq!(json["hash"], hash_by_hand());
    folder.run("convert d.node d.svg", 0);
    assert!(folder.read("d.svg").contains("<svg"));
}

#[test]
fn points_alone_leave_the_triangles_behind() {
    let folder = Folder::with_points();
    folder.run("triangulate points.csv -o a.ele", 0);
    folder
        .run("convert a.ele b.csv", 0)
        .says(&["6 points to b.csv"]);
    folder
        .run("convert a.ele b.node --points", 0)
        .says(&["6 points to b.node"]);
    assert!(!folder.names().contains(&"b.ele".to_owned()));
}

#[test]
fn domains_are_converted_with_their_segments() {
    let folder = Folder::new();
    folder.run("sample coast -n 60 -o a.poly", 0);
    folder
        .run("convert a.poly b.geojson", 0)
        .says(&["60 points and 60 segments to b.geojson"]);
    folder.run("convert b.geojson c.poly --one-based", 0);
    folder.run("convert c.poly d.svg", 0);
    let hash = |file: &str| {
        let line = format!("triangulate {file} --domain carve --json");
        folder.run(&line, 0).json()["hash"].clone()
    };
    for file in ["b.geojson", "c.poly"] {
        assert_eq!(hash(file), hash("a.poly"), "{file}");
    }
    folder
        .run("convert a.poly e.csv", 0)
        .says(&["note: a.poly: only the points", "60 points to e.csv"]);
    folder
        .run("convert a.poly f.node --points", 0)
        .says(&["60 points to f.node"]);
}

#[test]
fn conversion_works_in_a_pipe() {
    let folder = Folder::new();
    folder
        .command("convert - - --from csv --to node")
        .write_stdin(support::POINTS)
        .assert()
        .code(0)
        .stdout(predicates::str::starts_with("6 2 "));
}

#[test]
fn the_content_tells_what_the_name_does_not() {
    let folder = Folder::with_points();
    folder.run("triangulate points.csv -o a.vtu -o b.npy", 0);
    for (from, to) in [
        ("a.vtu", "a.data"),
        ("b.npy", "c"),
        ("b.points.npy", "c.points.npy"),
    ] {
        std::fs::copy(folder.path().join(from), folder.path().join(to)).expect("a copy");
    }
    for (line, output) in [
        ("convert a.data d.ele", "d.ele"),
        ("convert - e.vtu", "e.vtu"),
        ("convert c f.ele", "f.ele"),
    ] {
        folder
            .command(line)
            .write_stdin(folder.read("a.vtu"))
            .assert()
            .code(0);
        let json = folder.run(&format!("check {output} --json"), 0).json();
        assert_eq!(json["hash"], hash_by_hand(), "{line}");
    }
    folder
        .command("convert - g.csv")
        .write_stdin(support::POINTS)
        .assert()
        .code(0);
    assert_eq!(folder.read("g.csv"), support::POINTS);
}

#[test]
fn what_a_conversion_leaves_out_is_mentioned() {
    let folder = Folder::new();
    folder.write("named.csv", "x,y,name\n0,0,a\n1,0,b\n0,1,c\n");
    folder
        .run("convert named.csv a.npy", 0)
        .says(&["note: named.csv", "name"]);
    folder.run("triangulate named.csv -o m.vtu -o m.npy -o m.ele", 0);
    for mesh in ["m.vtu", "m.npy", "m.ele"] {
        folder
            .run(&format!("convert {mesh} p.csv"), 0)
            .says(&[&format!("note: {mesh}"), "only the points"]);
        let rows = folder.read("p.csv");
        let starts = rows.lines().zip(["x,y", "0,0", "1,0", "0,1"]);
        assert!(
            starts.clone().all(|(row, start)| row.starts_with(start)),
            "{mesh}: {rows}"
        );
        assert_eq!(starts.count(), 4, "{mesh}: {rows}");
    }
    folder
        .run("convert m.ele n.off", 0)
        .says(&["note: n.off", "boundary markers"]);
    // There they are the last column of the points.
    let kept = folder.run("convert m.ele n.npy", 0).stderr;
    assert!(!kept.contains("left out"), "{kept}");
    folder
        .run("sample populated-places -o cities.npy", 0)
        .says(&["note", "name"]);
    assert_eq!(folder.run("-q convert named.csv a.npy", 0).stderr, "");
}

#[test]
fn more_points_than_can_be_had_are_4() {
    let folder = Folder::new();
    folder
        .run("sample uniform -n 4000000000 -o a.npy", 4)
        .says(&["4,000,000,000 points", "715,827,882"]);
    assert_eq!(folder.names(), [""; 0]);
}

#[cfg(target_os = "linux")]
#[test]
fn more_points_than_fit_into_memory_are_4() {
    let program = assert_cmd::cargo::cargo_bin("delone");
    let line = "ulimit -v 2000000; exec \"$0\" sample uniform -n 500000000";
    assert_cmd::Command::new("sh")
        .args(["-c", line])
        .arg(program)
        .assert()
        .code(4)
        .stderr(predicates::str::contains("do not fit into memory"));
}

#[test]
fn to_overrules_the_name_if_every_name_tells() {
    let folder = Folder::new();
    folder.run("sample uniform -n 9 -o s.txt --to npy", 0);
    assert!(folder.bytes("s.txt").starts_with(b"\x93NUMPY"));
    folder.run("convert s.txt t.txt --from npy --to node", 0);
    assert!(folder.read("t.txt").starts_with("9 2 "));
    let output = folder.run("sample uniform -n 9 -o a.csv -o - --to node", 0);
    assert!(output.stdout.starts_with("9 2 "), "{}", output.stdout);
    assert!(folder.read("a.csv").starts_with("x,y\n"));
}
