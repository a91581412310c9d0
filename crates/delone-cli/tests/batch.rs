//! Several files at once: names, collisions, failures, the table, JSON.

mod support;

use serde_json::Value;
use support::{Folder, POINTS};

/// Two drawings and some noise, in two folders.
fn maps() -> Folder {
    let folder = Folder::new();
    for name in ["a", "b"] {
        std::fs::create_dir(folder.path().join(name)).expect("a folder");
    }
    folder.run("sample lake -o a/x.poly", 0);
    folder.run("sample coast -n 50 -o a/y.poly", 0);
    folder.run("sample coast -n 60 -o b/x.poly", 0);
    folder.write("b/noise.poly", "junk\n");
    folder
}

fn names(folder: &Folder, below: &str) -> Vec<String> {
    let entries = std::fs::read_dir(folder.path().join(below)).expect("a folder");
    let name = |e: std::io::Result<std::fs::DirEntry>| e.expect("an entry").file_name();
    let mut names: Vec<String> = entries
        .map(|e| name(e).into_string().expect("UTF-8"))
        .collect();
    names.sort();
    names
}

fn objects(text: &str) -> Vec<Value> {
    let object = |line| serde_json::from_str(line).expect("an object a line");
    text.lines().map(object).collect()
}

#[test]
fn results_go_to_a_folder_and_are_those_of_each_alone() {
    let folder = maps();
    folder.run("mesh a/x.poly -o x.vtu", 0);
    folder.run("mesh a/y.poly -o y.vtu", 0);
    for jobs in ["1", "2", "7"] {
        let line = format!("mesh a/x.poly a/y.poly --out-dir out --to vtu --jobs {jobs}");
        let output = folder.run(&line, 0);
        output.says(&["smallest angle", "a/x.poly", "2 files, all done"]);
        assert_eq!(output.stdout, "");
        assert_eq!(names(&folder, "out"), ["x.vtu", "y.vtu"]);
        for name in ["x.vtu", "y.vtu"] {
            assert_eq!(folder.bytes(name), folder.bytes(&format!("out/{name}")));
        }
    }
}

#[test]
fn patterns_are_expanded_and_names_made_of_those_of_inputs() {
    let folder = maps();
    folder.run("triangulate a/*.poly -o {}.vtu --picture {}-small.svg", 0);
    let made = names(&folder, "a");
    for name in ["x.vtu", "x-small.svg", "y.vtu", "y-small.svg"] {
        assert!(made.iter().any(|n| n == name), "{name}: {made:?}");
    }
    folder.run("mesh [a]/y.poly -o alone.vtu", 0);
    assert!(folder.names().contains(&"alone.vtu".to_owned()));
    folder
        .run("mesh a/*.csv --json", 3)
        .says(&["a/*.csv: no file matches"]);
    folder.run("mesh a/[ --json", 2).says(&["no pattern"]);
    // What has the name of a pattern is a file all the same.
    folder.write("[p].csv", POINTS);
    folder.run("triangulate [p].csv --json", 0);
}

#[test]
fn one_failure_stops_nobody_and_the_worst_code_counts() {
    let folder = maps();
    let line = "mesh a/x.poly b/noise.poly a/y.poly --out-dir out --to vtu";
    let output = folder.run(line, 3);
    output.says(&[
        "error: b/noise.poly:1:",
        "bad input (3)",
        "3 files: 2 done, 1 not",
    ]);
    assert_eq!(names(&folder, "out"), ["x.vtu", "y.vtu"]);

    let output = folder.run(&format!("{line} --json"), 3);
    let done = objects(&output.stdout);
    let files: Vec<_> = done.iter().map(|json| json["file"].clone()).collect();
    assert_eq!(files, ["a/x.poly", "a/y.poly"]);
    assert_eq!(done[0]["outputs"], serde_json::json!(["out/x.vtu"]));
    assert_eq!(done[0]["outcome"], "complete");
    let failed = objects(&output.stderr);
    assert_eq!(failed.len(), 1);
    assert_eq!(failed[0]["file"], "b/noise.poly");
    assert_eq!(
        (&failed[0]["code"], &failed[0]["line"]),
        (&3.into(), &1.into())
    );

    // A mesh that is not as asked is written, and worse than bad input.
    let line =
        "mesh a/x.poly b/noise.poly --max-area 1e-4 --max-vertices 900 -o {}.vtu --out-dir out";
    let output = folder.run(line, 4);
    output.says(&["error: a/x.poly:", "not as asked (4)", "bad input (3)"]);
}

#[test]
fn names_that_clash_are_refused_before_anything_is_done() {
    let folder = maps();
    for (line, words) in [
        (
            "mesh a/x.poly b/x.poly --out-dir out --to vtu",
            &["out/x.vtu would be written for both a/x.poly and b/x.poly"][..],
        ),
        (
            "mesh a/x.poly a/x.poly -o {}.vtu",
            &["would be written for both"],
        ),
        (
            "convert a/x.poly a/y.poly --out-dir a --to poly",
            &["a/x.poly would be written for a/x.poly, but it is an input"],
        ),
        (
            // The family of one holds the input of the other.
            "triangulate a/x.poly b/x.poly --out-dir a --to ele",
            &["a/x.poly would be written for a/x.poly, but it is an input"],
        ),
        (
            "mesh a/x.poly a/y.poly -o m.vtu",
            &["one name will not do", "{}"],
        ),
        (
            "mesh a/x.poly a/y.poly --picture m.png",
            &["--picture m.png"],
        ),
        (
            "mesh a/x.poly a/y.poly --report m.html",
            &["--report m.html"],
        ),
        ("mesh a/x.poly --out-dir out", &["in which format?"]),
        ("mesh --out-dir out", &["none is named"]),
        ("mesh a/x.poly --jobs 2", &["--jobs is about several files"]),
        ("mesh a/x.poly - --json", &["none can be standard input"]),
        (
            "mesh a/x.poly a/y.poly -o - --to vtu",
            &["one name will not do"],
        ),
        ("convert a/x.poly", &["an output is needed"]),
        (
            "convert a/x.poly a/y.poly z.geojson",
            &["one name will not do"],
        ),
    ] {
        folder.run(line, 2).says(words);
        assert_eq!(folder.names(), ["a", "b"], "{line}");
        assert_eq!(names(&folder, "a"), ["x.poly", "y.poly"], "{line}");
    }
}

#[test]
fn old_results_are_replaced_and_those_of_failures_stay() {
    let folder = maps();
    std::fs::create_dir(folder.path().join("out")).expect("a folder");
    folder.write("out/y.vtu", "old");
    folder.write("out/noise.vtu", "old");
    folder.run("mesh a/y.poly b/noise.poly --out-dir out --to vtu", 3);
    assert_ne!(folder.read("out/y.vtu"), "old");
    assert_eq!(folder.read("out/noise.vtu"), "old");
    assert_eq!(names(&folder, "out"), ["noise.vtu", "y.vtu"]);
}

#[test]
fn many_files_are_converted() {
    let folder = Folder::new();
    let count = 40;
    for i in 0..count {
        folder.write(&format!("p{i:02}.csv"), POINTS);
    }
    let line = "convert p*.csv --out-dir out --to npy";
    folder.run(line, 0).says(&["40 files, all done"]);
    assert_eq!(names(&folder, "out").len(), count);
    let done = objects(&folder.run(&format!("{line} --json"), 0).stdout);
    // In the order of the command line, however long each takes.
    let files: Vec<String> = done
        .iter()
        .map(|json| json["file"].as_str().expect("a name").to_owned())
        .collect();
    let expected: Vec<String> = (0..count).map(|i| format!("p{i:02}.csv")).collect();
    assert_eq!(files, expected);
    assert!(
        done.iter()
            .all(|json| json["points"] == 6 && json["holds"] == "points")
    );
    folder.run("convert p0*.csv {}.xyz -q", 0);
    assert!(folder.names().contains(&"p07.xyz".to_owned()));
}

#[test]
fn notes_are_said_of_each_file_unless_quiet() {
    let folder = Folder::new();
    for name in ["a.csv", "b.csv"] {
        folder.write(name, "x,y,name\n0,0,p\n1,0,q\n0,1,r\n");
    }
    let output = folder.run("triangulate a.csv b.csv", 0);
    output.says(&["note: a.csv: left out", "note: b.csv: left out"]);
    assert_eq!(folder.run("triangulate a.csv b.csv -q", 0).stderr, "");
}

#[test]
fn checks_and_infos_take_patterns_too() {
    let folder = maps();
    folder.run("triangulate a/*.poly --out-dir out --to ele", 0);
    let checked = folder.run("check out/*.ele --json", 1);
    assert_eq!(objects(&checked.stdout).len(), 2);
    let known = folder.run("info a/x.poly a/y.poly --json", 0);
    assert_eq!(objects(&known.stdout).len(), 2);
}

/// The objects that a command prints, without what is never the same.
fn timeless(text: &str) -> Vec<Value> {
    let mut all = objects(text);
    for object in &mut all {
        let keys = object.as_object_mut().expect("an object");
        keys.retain(|key, _| !["seconds", "peak_rss_bytes"].contains(&key.as_str()));
    }
    all
}

#[test]
fn meshes_are_checked_several_at_once_and_told_of_in_order() {
    let folder = Folder::new();
    for i in 0..9 {
        let (n, seed) = (2000 - 200 * i, i);
        folder.run(&format!("sample gauss -n {n} --seed {seed} -o p{i}.csv"), 0);
    }
    folder.run("triangulate p*.csv --out-dir out --to vtu -q", 0);
    folder.write("out/p3.vtu", "junk");
    // One triangle too few.
    folder.write("wrong.node", "4 2 0 0\n0 0 0\n1 1 0\n2 1 1\n3 0 1\n");
    folder.write("wrong.ele", "1 3 0\n0 0 1 2\n");
    let line = "check wrong.ele out/*.vtu --json";
    let one = folder.run(&format!("{line} --jobs 1"), 3);
    let files: Vec<_> = objects(&one.stdout)
        .iter()
        .map(|report| report["file"].as_str().expect("a name").to_owned())
        .collect();
    assert_eq!(files.len(), 9);
    assert_eq!(files[..2], ["wrong.ele", "out/p0.vtu"]);
    assert!(
        files.is_sorted_by(|a, b| a == "wrong.ele" || a < b),
        "{files:?}"
    );
    assert_eq!(objects(&one.stderr)[0]["file"], "out/p3.vtu");
    for jobs in ["", " --jobs 2", " --jobs 7"] {
        let several = folder.run(&format!("{line}{jobs}"), 3);
        assert_eq!(timeless(&several.stdout), timeless(&one.stdout), "{jobs}");
        assert_eq!(several.stderr, one.stderr, "{jobs}");
    }
    // People read the same words as for one, and no table.
    let words = folder.run("check wrong.ele out/p0.vtu", 1);
    for part in ["wrong.ele: wrong, ", "out/p0.vtu: right."] {
        assert!(words.stdout.contains(part), "{}", words.stdout);
    }
    assert_eq!(words.stderr, "");
    let quiet = folder.run("check wrong.ele out/p0.vtu -q", 1).stdout;
    assert!(quiet.starts_with("wrong.ele: wrong") && !quiet.contains("right."));
    folder
        .run("check out/p0.vtu --jobs 2", 2)
        .says(&["--jobs is about several files"]);
    folder
        .run("check out/p0.vtu out/p1.vtu --points -", 2)
        .says(&["--points", "read but once"]);
}

#[test]
fn data_are_covered_file_by_file() {
    let folder = Folder::new();
    for name in ["a", "b", "c"] {
        let seed = name.as_bytes()[0];
        folder.run(
            &format!("sample gauss -n 80 --seed {seed} -o {name}.csv"),
            0,
        );
        let line = format!("cover {name}.csv -d 4 -o {name}.vtu --data-out {name}-held.csv");
        folder.run(&line, 0);
    }
    let line = "cover a.csv [bc].csv -d 4 --out-dir out --to vtu --data-out {}-held.csv";
    let table = folder.run(line, 0);
    table.says(&["smallest angle", "c.csv", "3 files, all done"]);
    assert_eq!(table.stdout, "");
    for name in ["a", "b", "c"] {
        for end in [".vtu", "-held.csv"] {
            let name = format!("{name}{end}");
            assert_eq!(folder.bytes(&name), folder.bytes(&format!("out/{name}")));
        }
    }
    let done = objects(&folder.run("cover a.csv b.csv -d 4 --json", 0).stdout);
    assert_eq!(done[1]["file"], "b.csv");
    assert_eq!(done[1]["data"], 80);
    for (line, words) in [
        ("cover a.csv b.csv -o m.vtu", "one name will not do"),
        ("cover a.csv b.csv --data-out d.csv", "--data-out d.csv"),
        ("cover a.csv b.csv --domain -", "read but once"),
        ("cover a.csv --out-dir x", "in which format?"),
    ] {
        folder.run(line, 2).says(&[words]);
    }
}
