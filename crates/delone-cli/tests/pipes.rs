//! Pipes: `-` in and out of every command, readers that go away, and nothing but results on standard output.

mod support;

use support::{Folder, Output};

const HEIGHTS: &str = "x,y,z\n0,0,1\n4,0,90\n4,3,10\n0,3,26\n1,1,5\n3,2,7\n";

/// Commands that read `-`, and write `-` if they write anything.
const LINES: [(&str, &str); 19] = [
    ("mesh - -o - --to ele", "0"),
    ("mesh - -o - --to vtu", "<?xml"),
    ("triangulate - -o - --to ele", "0"),
    ("triangulate - -o - --to geojson", "{"),
    ("triangulate - -o - --to svg", "<"),
    ("triangulate - -o - --to npy", "\u{93}NUMPY"),
    ("convert - - --from csv --to xyz", "0"),
    ("convert - - --from csv --to npy", "\u{93}NUMPY"),
    ("nearest - p.csv -o - --to csv", "query,vertex"),
    ("nearest p.csv - -o - --to csv", "query,vertex"),
    ("voronoi - -o - --to geojson", "{"),
    ("interpolate - --cell 1 -o - --to asc", "ncols"),
    ("interpolate - p.csv -o - --to csv", "x,y"),
    ("contour - -o - --to geojson", "{"),
    ("cover - -d 2 -o - --to ele", ""),
    ("graph - --kind mst -o - --to csv", "from,to"),
    ("cluster - -n 2 -o - --to csv", "x,y"),
    ("algorithms run incremental - -o - --to ele", ""),
    ("sample uniform -n 3", "x,y"),
];

#[test]
fn every_command_reads_and_writes_pipes() {
    let folder = Folder::new();
    folder.write("p.csv", HEIGHTS);
    for (line, begin) in LINES {
        let assert = folder.command(line).write_stdin(HEIGHTS).assert().code(0);
        let bytes = assert.get_output().stdout.clone();
        // The first byte of an array is no UTF-8.
        let text: String = bytes.iter().map(|&byte| char::from(byte)).collect();
        assert!(!bytes.is_empty() && text.contains(begin), "{line}: {text}");
        assert_eq!(folder.names(), ["p.csv"], "{line}");
    }
}

#[test]
fn what_is_asked_of_pipes_is_answered_there() {
    let folder = Folder::new();
    folder.write("p.csv", HEIGHTS);
    for line in [
        "mesh - --json",
        "triangulate - --json",
        "info - --json",
        "nearest - p.csv --json",
        "voronoi - --json",
        "interpolate - --cell 1 --json",
        "contour - --json",
        "cover - -d 2 --json",
        "graph - --kind tour --json",
        "cluster - -n 2 --json",
        "race incremental sweep -n 6 --input - --json",
        "algorithms run sweep - --json",
        "convert - p.npy --json",
    ] {
        let assert = folder.command(line).write_stdin(HEIGHTS).assert().code(0);
        let json = Output::of(assert).json();
        assert!(json.is_object(), "{line}");
    }
    let page = folder.run("triangulate p.csv -o - --to vtu", 0).stdout;
    let assert = folder.command("check - --json").write_stdin(page).assert();
    assert_eq!(Output::of(assert.code(0)).json()["right"], true);
}

#[test]
fn a_graph_that_comes_without_a_name_keeps_its_segments() {
    let folder = Folder::new();
    folder.run("sample lake -o lake.poly", 0);
    let lake = folder.read("lake.poly");
    let piped = |line: &str| {
        let assert = folder.command(line).write_stdin(lake.clone()).assert();
        Output::of(assert.code(0)).json()
    };
    let segments = &folder.run("info lake.poly --json", 0).json()["segments"];
    assert_eq!(piped("info - --json")["segments"], *segments);
    let named = folder.run("triangulate lake.poly --json", 0).json();
    assert_eq!(piped("triangulate - --json")["hash"], named["hash"]);
    // A file may lack an extension, too, and be longer than what is looked at first.
    assert!(lake.len() > 4096);
    folder.write("lake", &lake);
    assert_eq!(
        folder.run("info lake --json", 0).json()["segments"],
        *segments
    );
}

#[test]
fn words_for_people_never_go_to_standard_output() {
    let folder = Folder::new();
    folder.write(
        "p.csv",
        "x,y,z,name\n0,0,1,a\n4,0,9,b\n4,3,1,c\n0,3,2,d\n1,1,5,e\n",
    );
    for line in [
        "mesh p.csv -v",
        "triangulate p.csv -v -o m.ele",
        "triangulate p.csv p.csv -v",
        "convert p.csv p.npy -v",
        "nearest p.csv p.csv -v",
        "voronoi p.csv -v",
        "interpolate p.csv --cell 1 -v",
        "contour p.csv -v",
        "cover p.csv -d 2 -v",
        "graph p.csv --kind mst -v",
        "cluster p.csv -n 2 -v",
        "sample lake -o l.poly -v",
    ] {
        let output = folder.run(line, 0);
        assert_eq!(output.stdout, "", "{line}");
        assert!(!output.stderr.is_empty(), "{line}");
        let quiet = folder.run(&line.replace(" -v", " -q"), 0);
        assert_eq!((&quiet.stdout[..], &quiet.stderr[..]), ("", ""), "{line}");
    }
}

#[cfg(unix)]
#[test]
fn a_reader_that_goes_away_ends_the_work_quietly() {
    let folder = Folder::new();
    folder.run("sample uniform -n 30000 -o p.csv", 0);
    folder.run("triangulate p.csv -o m.vtu", 0);
    let program = assert_cmd::cargo::cargo_bin("delone");
    for line in [
        "sample uniform -n 100000",
        "sample",
        "mesh p.csv -o - --to ele",
        "triangulate p.csv -o - --to vtu",
        "triangulate p.csv p.csv p.csv --json",
        "convert p.csv - --to xyz",
        "info p.csv p.csv p.csv",
        "check m.vtu m.vtu m.vtu",
        "nearest p.csv p.csv -o - --to csv",
        "voronoi p.csv -o - --to geojson",
        "graph p.csv --kind mst -o - --to csv",
        "cluster p.csv -n 5 -o - --to csv",
        "algorithms",
        "algorithms show sweep",
        "completions bash",
        "man mesh",
        "--help",
    ] {
        // Whoever reads has gone before the first byte is written.
        let script = format!(
            "{{ sleep 0.05; '{}' {line}; echo $? > code; }} 2> said | true",
            program.display()
        );
        let mut shell = std::process::Command::new("sh");
        shell.current_dir(folder.path()).args(["-c", &script]);
        shell.status().expect("a shell");
        let said = folder.read("said");
        assert!(
            !said.contains("anic") && !said.contains("error"),
            "{line}: {said}"
        );
        assert_eq!(folder.read("code").trim(), "0", "{line}: {said}");
    }
}

#[cfg(unix)]
#[test]
fn a_closed_standard_error_is_no_failure() {
    let folder = Folder::with_points();
    let program = assert_cmd::cargo::cargo_bin("delone");
    for line in [
        "triangulate points.csv -v",
        "info points.csv",
        "convert points.csv p.npy",
    ] {
        let script = format!("'{}' {line} 2>&-", program.display());
        let mut shell = std::process::Command::new("sh");
        shell.current_dir(folder.path()).args(["-c", &script]);
        let output = shell.output().expect("a shell");
        assert_eq!(output.status.code(), Some(0), "{line}");
    }
}
