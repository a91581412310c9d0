//! `delone algorithms` and `delone race`, seen from the shell.

mod support;

use delone::classic::{Algorithm, Takes};
use serde_json::Value;
use support::{Folder, hash_by_hand};

/// A kite in a mesh of the longer diagonal, numbered from 1: one flip makes it Delaunay.
const KITE: &str = "4 2 0 0\n1 0 0\n2 4 0\n3 5 3\n4 0 3\n";
const LONG: &str = "2 3 0\n1 1 2 3\n2 1 3 4\n";

/// A square with a square hole, and a loose point between.
const RING: &str = "9 2 0 0\n0 0 0\n1 9 0\n2 9 9\n3 0 9\n4 3 3\n5 6 3\n6 6 6\n7 3 6\n8 1 7\n\
                    8 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n4 4 5\n5 5 6\n6 6 7\n7 7 4\n1\n0 4 4\n";

fn claims(algorithm: &&Algorithm) -> bool {
    algorithm.about().is_delaunay && !algorithm.refines()
}

fn points(line: &str) -> String {
    format!("sample {line} --seed 3 -o")
}

/// The two hashes of a file: that of an algorithm, which must be canonical, and that of the library.
fn both(folder: &Folder, name: &str, file: &str, rule: &str) -> [Value; 2] {
    let line = format!("algorithms run {name} {file} --json {rule}");
    let mine = folder.run(&line, 0).json();
    assert_eq!(mine["is_canonical"], true, "{line}");
    let line = format!("triangulate {file} --json {rule}");
    let canonical = folder.run(&line, 0).json();
    [mine, canonical].map(|json| json["hash"].clone())
}

#[test]
fn the_list_names_all_and_json_says_more() {
    let folder = Folder::new();
    let lines = folder.run("algorithms", 0).stdout;
    let all = folder.run("algorithms --json", 0).json();
    let all = all.as_array().expect("an array");
    assert_eq!(all.len(), Algorithm::ALL.len());
    for ((algorithm, line), json) in Algorithm::ALL.iter().zip(lines.lines()).zip(all) {
        let about = algorithm.about();
        assert!(line.starts_with(about.name), "{line}");
        assert!(line.ends_with(about.cost), "{line}");
        for (key, value) in [
            ("name", about.name),
            ("title", about.title),
            ("source", about.source),
            ("idea", about.idea),
            ("cost", about.cost),
            ("guarantees", about.guarantees),
        ] {
            assert_eq!(json[key], value, "{key} of {}", about.name);
        }
        assert_eq!(json["delaunay"], about.is_delaunay);
        assert_eq!(
            json["code"].as_array().expect("lines").len(),
            about.code.len()
        );
        let takes = match about.takes {
            Takes::Points => "points",
            Takes::Triangulation => "triangulation",
            Takes::Domain => "domain",
            Takes::Data => "data",
        };
        assert_eq!(json["takes"], takes);
        let line = format!("algorithms show {} --json", about.name);
        assert_eq!(folder.run(&line, 0).json(), *json);
    }
}

#[test]
fn show_says_all_that_there_is() {
    let folder = Folder::new();
    for algorithm in Algorithm::ALL {
        let about = algorithm.about();
        let text = folder
            .run(&format!("algorithms show {}", about.name), 0)
            .stdout;
        let said = [
            about.title,
            about.source,
            about.idea,
            about.cost,
            about.guarantees,
        ];
        for words in said.iter().chain(about.code) {
            assert!(text.contains(words), "{}: {words}", about.name);
        }
    }
}

#[test]
fn all_run_on_what_is_at_hand() {
    let folder = Folder::new();
    for algorithm in Algorithm::ALL {
        let about = algorithm.about();
        let json = folder
            .run(&format!("algorithms run {} --json", about.name), 0)
            .json();
        assert_eq!(json["algorithm"], about.name);
        assert_eq!(
            json["points"],
            match about.takes {
                Takes::Points => 30,
                Takes::Data => 60,
                Takes::Triangulation | Takes::Domain => 9,
            }
        );
        assert!(
            json["statistics"]["steps"].as_u64() > Some(20),
            "{}",
            about.name
        );
        assert!(
            !about.is_delaunay || json["is_canonical"] == true,
            "{}",
            about.name
        );
    }
    assert_eq!(folder.names(), [""; 0]);
}

#[test]
fn all_that_claim_it_end_in_the_one_triangulation() {
    let folder = Folder::with_points();
    folder.run(&format!("{} lattice.npy", points("tilted-grid -n 100")), 0);
    folder.run(
        &format!("{} round.node --one-based", points("circle -n 50")),
        0,
    );
    folder.run(&format!("{} twins.vtu", points("f32-duplicates -n 300")), 0);
    folder.write("row.csv", "x,y\n0,0\n1,1\n2,2\n1,1\n");
    folder.write(
        "wide.csv",
        "1e300,1e-300\n-1e300,1e300\n1e-300,0\n5,7\n3,-1e200\n",
    );
    for algorithm in Algorithm::ALL.iter().filter(claims) {
        let name = algorithm.about().name;
        for file in [
            "points.csv",
            "lattice.npy",
            "round.node",
            "twins.vtu",
            "row.csv",
            "wide.csv",
        ] {
            let [mine, canonical] = both(&folder, name, file, "");
            assert_eq!(mine, canonical, "{name} on {file}");
        }
    }
    let json = folder
        .run("algorithms run fortune points.csv --json", 0)
        .json();
    assert_eq!(json["hash"], hash_by_hand());
    assert_eq!(
        [&json["points"], &json["duplicates"], &json["triangles"]],
        [6, 1, 4]
    );
}

#[test]
fn domains_end_in_the_one_triangulation_too() {
    let folder = Folder::new();
    folder.write("ring.poly", RING);
    folder.write(
        "ring.wkt",
        "POLYGON((0 0,9 0,9 9,0 9,0 0),(3 3,6 3,6 6,3 6,3 3))",
    );
    for name in ["edge-flip", "greedy-flips", "flip-list"] {
        for (file, rule) in [
            ("ring.poly", ""),
            ("ring.poly", "--domain evenodd"),
            ("ring.wkt", ""),
            ("ring.wkt", "--domain carve"),
        ] {
            let [mine, canonical] = both(&folder, name, file, rule);
            assert_eq!(mine, canonical, "{name} on {file} {rule}");
        }
    }
    let json = folder
        .run("algorithms run sweep ring.poly --json", 0)
        .json();
    assert_eq!(json["constrained_edges"], 8);
    let refined = "algorithms run thesis ring.poly --max-edge 2 --json -o refined.ele";
    let json = folder.run(refined, 0).json();
    assert_eq!(json["is_canonical"], true);
    assert!(json["vertices_added"].as_u64() > Some(20));
    let text = folder.run("algorithms run incremental ring.poly", 0);
    text.says(&["`incremental` works on points alone: 8 segments not used"]);
}

#[test]
fn flips_begin_with_the_mesh_of_a_file() {
    let folder = Folder::new();
    folder.write("kite.node", KITE);
    folder.write("kite.ele", LONG);
    folder.run("convert kite.ele kite.vtu", 0);
    folder.write("turned.node", KITE);
    folder.write("turned.ele", "2 3 0\n1 1 3 2\n2 1 4 3\n");
    for name in ["edge-flip", "greedy-flips", "flip-list"] {
        for mesh in ["kite.ele", "kite.vtu", "turned.ele"] {
            let line = format!("algorithms run {name} {mesh} --json -o out.ele");
            let json = folder.run(&line, 0).json();
            assert_eq!(json["statistics"]["flips"], 1, "{line}");
            assert_eq!(json["is_canonical"], true, "{line}");
            folder.run("check out.ele", 0);
        }
    }
    // The long diagonal is a segment: it stays.
    folder.write("kite.poly", "0 2 0 0\n1 0\n1 1 3\n0\n");
    let json = folder
        .run("algorithms run flip-list kite.ele --json", 0)
        .json();
    assert_eq!(json["statistics"]["flips"], 0);
    assert_eq!(json["constrained_edges"], 1);
    assert_eq!(json["is_canonical"], true);
    // What has been carved away does not come back.
    folder.write("ring.poly", RING);
    folder.run("triangulate ring.poly -o carved.ele", 0);
    let json = folder
        .run("algorithms run greedy-flips carved.ele --json", 0)
        .json();
    let canonical = folder.run("triangulate ring.poly --json", 0).json();
    assert_eq!(json["hash"], canonical["hash"]);
}

#[test]
fn a_triangle_that_does_not_fit_is_named_as_the_file_counts() {
    let folder = Folder::new();
    for name in ["twice", "upon"] {
        folder.write(&format!("{name}.node"), KITE);
    }
    folder.write("twice.ele", "3 3 0\n1 1 2 4\n2 2 3 4\n3 4 1 2\n");
    folder.write("upon.ele", "2 3 0\n1 1 2 4\n2 1 2 3\n");
    for (file, words) in [
        (
            "twice.ele",
            &["twice.ele: triangle 3 ", "twice", "(numbered from 1)"][..],
        ),
        ("upon.ele", &["upon.ele: triangle 2 ", "overlaps"]),
    ] {
        for name in ["edge-flip", "greedy-flips", "flip-list"] {
            folder
                .run(&format!("algorithms run {name} {file}"), 3)
                .says(words);
        }
    }
    folder.write(
        "x.poly",
        "4 2 0 0\n1 0 0\n2 4 4\n3 0 4\n4 4 0\n2 0\n1 1 2\n2 3 4\n0\n",
    );
    let crossing = folder.run("algorithms run sweep x.poly", 3);
    crossing.says(&["x.poly: segments 1 and 2 cross at (2, 2)", "-o cut.poly"]);
    // As it says.
    folder.run("triangulate x.poly --crossings split -o cut.poly", 0);
    folder.run("algorithms run sweep cut.poly", 0);
}

#[test]
fn the_print_fails_where_it_is_said_to() {
    let folder = Folder::new();
    folder.write(
        "pentagon.poly",
        "5 2 0 0\n0 40 20\n1 18 11\n2 37 36\n3 40 29\n4 31 19\n5 0\n0 0 1\n1 1 2\n2 2 3\n3 3 4\n4 4 0\n0\n",
    );
    let json = folder
        .run("algorithms run printed-sweep pentagon.poly --json", 0)
        .json();
    let failures = json["failures"].as_array().expect("failures");
    let lost = failures.iter().filter(|f| f["kind"] == "segment-lost");
    let lost: Vec<_> = lost
        .map(|f| f["vertices"].as_array().expect("ends").len())
        .collect();
    assert!(
        !lost.is_empty() && lost.iter().all(|&ends| ends == 2),
        "{json}"
    );
    folder
        .run("algorithms run printed-sweep pentagon.poly", 0)
        .says(&["as printed it fails: ", " lost"]);
    let json = folder
        .run("algorithms run sweep pentagon.poly --json", 0)
        .json();
    assert_eq!(json["failures"].as_array().map(Vec::len), Some(0));
}

#[test]
fn the_hull_is_listed() {
    let folder = Folder::with_points();
    let run = folder.run("algorithms run convex-hull points.csv --json", 0);
    assert_eq!(run.json()["hull"].to_string(), "[2,3,0,1]");
    folder
        .run("algorithms run convex-hull points.csv", 0)
        .says(&["6 points, 4 on the hull"]);
}

#[test]
fn logs_and_moving_pictures_are_what_they_claim() {
    let folder = Folder::with_points();
    let line = "algorithms run incremental points.csv --log run.json --svg run.svg --gif run.gif \
                --filmstrip run.png --frames 4 -p result.png -o result.vtu";
    folder
        .run(line, 0)
        .says(&["run.json", "run.svg", "run.gif", "run.png"]);
    let log: Value = serde_json::from_str(&folder.read("run.json")).expect("JSON");
    assert!(log.to_string().contains("incremental"));
    assert!(folder.read("run.svg").contains("<animate"));
    let gif = folder.bytes("run.gif");
    assert!(gif.starts_with(b"GIF89a"));
    assert_eq!(u16::from_le_bytes([gif[6], gif[7]]), 800);
    for name in ["run.png", "result.png"] {
        assert!(folder.bytes(name).starts_with(b"\x89PNG"), "{name}");
    }
    folder.run("check result.vtu", 0);
    folder.run("algorithms run incremental points.csv --log run.dlog", 0);
    assert!(folder.bytes("run.dlog").len() < folder.bytes("run.json").len());
}

#[test]
fn frames_are_as_many_and_as_large_as_asked_for() {
    let folder = Folder::with_points();
    let line = "algorithms run incremental points.csv --gif run.gif --size 200 --max-frames 5";
    folder
        .run(line, 0)
        .says(&["run.gif shows 5 of ", "evenly spread"]);
    let gif = folder.bytes("run.gif");
    assert_eq!(u16::from_le_bytes([gif[6], gif[7]]), 200);
    // One control extension a frame.
    let controls = gif.windows(3).filter(|w| w == &[0x21, 0xf9, 4]).count();
    assert_eq!(controls, 5);
}

#[test]
fn what_makes_no_sense_is_refused_before_the_work() {
    let folder = Folder::with_points();
    folder.write("in.json", "{}");
    let before = folder.names();
    for (line, words) in [
        ("algorithms show nosuch", &["nosuch", "fortune"][..]),
        ("algorithms run", &["NAME"]),
        (
            "algorithms run sweep --log run.txt",
            &["run.txt", ".json or .dlog"],
        ),
        ("algorithms run sweep --svg run.gif", &["run.gif", ".svg"]),
        ("algorithms run sweep --gif -", &["-", ".gif"]),
        (
            "algorithms run sweep --svg a.svg -p a.svg",
            &["both write a.svg"],
        ),
        (
            "algorithms run sweep -o a.json --to geojson --log a.json",
            &["both write a.json"],
        ),
        (
            "algorithms run sweep in.json --from csv --log in.json",
            &["in.json is the input"],
        ),
        (
            "algorithms run sweep --gif a.gif --size 63",
            &["64 pixels", "--size"],
        ),
        (
            "algorithms run sweep --gif a.gif --seconds 0.01",
            &["0.1 to 36000"],
        ),
        (
            "algorithms run sweep --max-edge 1",
            &["`thesis`", "`sweep`"],
        ),
        (
            "algorithms run incremental --domain carve",
            &["--domain", "`incremental`"],
        ),
        (
            "algorithms run incremental --columns 1,2",
            &["--columns", "INPUT"],
        ),
        (
            "algorithms run incremental -o - --to ele --json",
            &["--json", "standard output"],
        ),
        ("race thesis", &["`thesis` refines"]),
        ("race -p - --to svg", &["standard output"]),
        ("race --columns 1,2", &["--columns", "--input"]),
        (
            "race --input points.csv -n 7",
            &["points.csv has 6 points", "--sizes"],
        ),
        ("race -n 4000000000", &["4000000000"]),
        ("race --seconds 0", &["positive"]),
    ] {
        folder.run(line, 2).says(words);
        assert_eq!(folder.names(), before, "{line}");
    }
    folder
        .run("algorithms run sweep --svg nowhere/a.svg", 4)
        .says(&["nowhere", "create"]);
    folder
        .run("algorithms run thesis --max-edge 1e-9", 4)
        .says(&["`thesis`", "2000000 vertices", "longer edges"]);
}

#[test]
fn a_race_counts_and_times() {
    let folder = Folder::new();
    let line = "race incremental fortune incremental --sizes 50,20 --json";
    let json = folder.run(line, 0).json();
    let laps = json["laps"].as_array().expect("laps");
    let named = |lap: &Value| (lap["algorithm"].clone(), lap["points"].clone());
    let named: Vec<_> = laps.iter().map(named).collect();
    assert_eq!(
        serde_json::to_string(&named).expect("JSON"),
        r#"[["incremental",20],["incremental",50],["fortune",20],["fortune",50]]"#
    );
    for lap in laps {
        let number = |key: &str| lap[key].as_u64().unwrap_or_else(|| panic!("{key}: {lap}"));
        assert_eq!(
            number("predicates"),
            number("orientation_tests") + number("circle_tests")
        );
        assert!(number("runs") >= 1 && number("steps") > 100);
    }
    assert_eq!(laps[1]["hash"], laps[3]["hash"]);
    assert_eq!(json["input"], "uniform");
}

#[test]
fn a_race_of_a_file_is_a_table_and_a_plot() {
    let folder = Folder::with_points();
    let line = "race --input points.csv -n 3,6,100 -p race.svg -p race.png";
    let output = folder.run(line, 0);
    output.says(&["points.csv has 6 points", "left out", "race.svg"]);
    let takes_points = |a: &&Algorithm| a.about().takes != Takes::Domain;
    let racing = Algorithm::ALL
        .iter()
        .filter(claims)
        .filter(takes_points)
        .count();
    assert_eq!(output.stdout.lines().count(), 1 + 2 * racing);
    assert!(folder.read("race.svg").contains("fortune"));
    assert!(folder.bytes("race.png").starts_with(b"\x89PNG"));
}

#[test]
fn who_is_too_slow_is_left_out() {
    let folder = Folder::new();
    let line = "race greedy-flips printed-sweep -n 100000,200000 --seconds 0.2 --json";
    let start = std::time::Instant::now();
    let json = folder.run(line, 0).json();
    assert!(
        start.elapsed().as_secs_f64() < 10.0,
        "{:?}",
        start.elapsed()
    );
    assert_eq!(json["laps"].as_array().map(Vec::len), Some(0));
    assert_eq!(json["skipped"].as_array().map(Vec::len), Some(4));
    folder
        .run("race printed-sweep -n 50000 --seconds 0.1", 0)
        .says(&["printed-sweep: too slow for 50,000 points", "--seconds"]);
}

/// Examples of a help page, without what follows a blank of three, or a pipe.
fn examples(help: &str) -> Vec<&str> {
    let lines = help
        .lines()
        .filter_map(|line| line.strip_prefix("  delone "));
    let cut = |line: &str, at: &str| line.find(at).unwrap_or(line.len());
    lines
        .map(|line| line[..cut(line, "   ").min(cut(line, " | "))].trim())
        .collect()
}

#[test]
fn the_examples_of_the_help_run() {
    let folder = Folder::with_points();
    folder.write("survey.csv", support::POINTS);
    let square = "4 2 0 0\n0 0 0\n1 1 0\n2 1 1\n3 0 1\n4 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n0\n";
    folder.write("outline.poly", square);
    folder.run("triangulate points.csv --domain hull -o mesh.ele", 0);
    for (command, expected) in [("algorithms", 5), ("algorithms run", 6), ("race", 4)] {
        let help = folder.run(&format!("{command} --help"), 0).stdout;
        let examples = examples(&help);
        assert_eq!(examples.len(), expected, "{command}");
        for example in examples {
            // Races of a few points: here they are to run, not to be won.
            let words = example.split_whitespace();
            let fast: Vec<&str> = words
                .filter(|w| !w.starts_with("--sizes") && !w.starts_with("1000,"))
                .collect();
            let few = if command == "race" { " -n 4,5" } else { "" };
            let fast = fast.join(" ") + few;
            folder.run(&fast, 0);
        }
    }
    for name in [
        "run.svg",
        "sweep.svg",
        "sweep.png",
        "flipped.ele",
        "thesis.gif",
        "run.json",
        "race.png",
    ] {
        assert!(folder.names().iter().any(|n| n == name), "{name}");
    }
}

#[test]
fn help_names_every_key_of_the_json() {
    let folder = Folder::new();
    for (command, line) in [
        ("algorithms run", "algorithms run flip-list --json"),
        ("algorithms run", "algorithms run convex-hull --json"),
        ("race", "race fortune -n 10 --json"),
    ] {
        let help = folder.run(&format!("{command} --help"), 0).stdout;
        let (_, help) = help.split_once("The JSON object").expect("a section");
        let json = folder.run(line, 0).json();
        let objects = [
            &json,
            &json["statistics"],
            &json["seconds"],
            &json["laps"][0],
        ];
        for object in objects.into_iter().filter_map(Value::as_object) {
            for key in object.keys() {
                assert!(help.contains(key.as_str()), "{command}: {key}");
            }
        }
    }
}
