//! Exit codes 2, 3 and 4, and what is said then; what help and README say.

mod support;

use support::Folder;

const README: &str = include_str!("../../../README.md");

/// What the pages have their examples read.
const DATA: [(&str, &str); 3] = [
    ("towns.csv", include_str!("../../../docs/queries/towns.csv")),
    ("sites.csv", include_str!("../../../docs/queries/sites.csv")),
    (
        "land.geojson",
        include_str!("../../../docs/queries/land.geojson"),
    ),
];

#[test]
fn wrong_usage_is_2() {
    let folder = Folder::with_points();
    for (line, words) in [
        ("", &["Usage"][..]),
        ("triangluate points.csv", &["triangulate"]),
        ("triangulate points.csv --threads 0", &["threads"]),
        ("triangulate points.csv --colour", &["--colour"]),
        (
            "triangulate points.csv -o mesh.xls",
            &["mesh.xls", "ele", "vtu"],
        ),
        ("triangulate points.csv -o mesh", &["mesh", "extension"]),
        ("triangulate points.csv -o -", &["--to"]),
        (
            "triangulate points.csv -o mesh.csv",
            &["mesh.csv", "cannot hold a mesh"],
        ),
        (
            "triangulate points.csv --picture map.ele",
            &["map.ele", "svg, png"],
        ),
        (
            "triangulate points.csv -o - --to ele --json",
            &["--json", "standard output"],
        ),
        ("triangulate points.csv -o - -o - --to ele", &["only one"]),
        ("triangulate points.csv --crossings ask", &["ask", "split"]),
        ("triangulate points.csv --domain ring", &["ring", "evenodd"]),
        ("sample uniform --to ele", &["ele", "cannot hold points"]),
        ("triangulate --from csv", &["--from", "INPUT"]),
        ("triangulate --columns lon,lat", &["--columns", "INPUT"]),
        ("check - --points -", &["--points", "standard input"]),
        ("check - --domain -", &["--domain", "standard input"]),
        ("check m.ele --rule hull", &["--domain"]),
        ("check m.ele --domain a --points b", &["--points"]),
        ("convert - mesh.xls", &["mesh.xls", "csv", "ele"]),
        ("triangulate points.csv --columns x", &["two columns"]),
        (
            "triangulate points.csv --columns x,elevation",
            &["elevation", "points.csv"],
        ),
        ("triangulate points.csv --from xls", &["xls", "node"]),
        ("sample nosuch", &["nosuch", "delone sample"]),
        ("check", &["Usage"]),
        ("convert points.csv", &["Usage"]),
        (
            "convert points.csv mesh.ele",
            &["mesh.ele", "delone triangulate"],
        ),
    ] {
        let output = folder.run(line, 2);
        assert_eq!(output.stdout, "", "{line}");
        output.says(words);
    }
    assert_eq!(folder.names(), ["points.csv"]);
}

#[test]
fn no_input_is_overwritten_and_no_output_by_another() {
    let folder = Folder::with_points();
    folder.run("triangulate points.csv -o k.node --one-based", 0);
    folder.run("triangulate points.csv -o m.npy", 0);
    folder.write("without.poly", "0 2 0 0\n0 0\n0\n");
    folder.write("without.node", "3 2 0 0\n0 0 0\n1 1 0\n2 0 1\n");
    let files = || folder.names().into_iter().map(|n| (folder.bytes(&n), n));
    let before: Vec<_> = files().collect();
    for (line, words) in [
        (
            "triangulate m.points.npy -o m.points.npy",
            &["m.points.npy is the input"][..],
        ),
        (
            "triangulate m.points.npy -o m.npy",
            &["m.npy with its file m.points.npy", "is the input"],
        ),
        (
            "triangulate k.node -o k.ele",
            &["output k.ele", "k.node is the input"],
        ),
        (
            "triangulate k.ele -o ./k.poly",
            &["./k.poly", "k.node is the input"],
        ),
        ("triangulate without.poly -o without.ele", &["is the input"]),
        (
            "triangulate points.csv --picture points.csv --to svg",
            &["cannot hold a picture"],
        ),
        (
            "convert points.csv points.csv",
            &["points.csv is the input"],
        ),
        ("convert k.ele k.node --one-based", &["k.node is the input"]),
        ("convert m.npy m.points.npy", &["m.points.npy is the input"]),
        (
            "triangulate points.csv -o q.npy -o q.points.npy",
            &["q.npy", "both write q.points.npy"],
        ),
        (
            "triangulate points.csv -o q.svg --picture q.svg --to png",
            &["both write q.svg"],
        ),
    ] {
        folder.run(line, 2).says(words);
        assert!(files().eq(before.iter().cloned()), "{line}");
    }
    // One family may be named twice.
    for _ in 0..2 {
        folder.run("triangulate points.csv -o with.ele -o with.node", 0);
    }
}

#[cfg(unix)]
#[test]
fn an_input_is_known_by_every_name() {
    let folder = Folder::with_points();
    let at = |name: &str| folder.path().join(name);
    std::os::unix::fs::symlink(at("points.csv"), at("link.csv")).expect("a link");
    folder
        .run("convert points.csv link.csv", 2)
        .says(&["link.csv", "points.csv is the input"]);
}

#[test]
fn bad_input_is_3_and_names_file_and_line() {
    let folder = Folder::new();
    folder.write("word.csv", "x,y\n0,0\n1,zero\n");
    folder.write("nan.csv", "x,y\n0,0\nNaN,1\n");
    folder.write("huge.node", "4000000000 2 0 0\n0 1 1\n");
    folder.write("short.node", "3 2 0 0\n0 0 0\n1 1 0\n");
    folder.write("three.node", "1 3 0 0\n0 0 0 0\n");
    folder.write("infinite.node", "1 2 0 0\n0 inf 0\n");
    folder.write("noise.npy", [0xff; 64]);
    folder.write("bad.node", "3 2 0 0\n0 0 0\n1 1 0\n2 0 1\n");
    folder.write("bad.ele", "1 3 0\n0 0 1 7\n");
    for (line, words) in [
        ("triangulate nowhere.csv", &["nowhere.csv"][..]),
        ("triangulate word.csv", &["word.csv:3", "zero"]),
        ("triangulate nan.csv", &["nan.csv:3"]),
        ("triangulate huge.node", &["huge.node", "4000000000"]),
        ("triangulate short.node", &["short.node", "truncated"]),
        ("triangulate three.node", &["three.node:1", "dimension"]),
        ("triangulate infinite.node", &["infinite.node:2", "finite"]),
        ("triangulate noise.npy", &["noise.npy"]),
        ("check bad.ele", &["bad.ele:2", "vertex 7"]),
        ("check nowhere.ele", &["nowhere"]),
        ("convert word.csv word.npy", &["word.csv:3"]),
    ] {
        let output = folder.run(line, 3);
        assert_eq!(output.stdout, "", "{line}");
        output.says(words);
        assert_eq!(
            output.stderr.lines().count(),
            1,
            "one line: {}",
            output.stderr
        );
    }
    assert!(!folder.names().iter().any(|n| n == "word.npy"));
}

#[test]
fn what_cannot_be_written_is_4() {
    let folder = Folder::with_points();
    folder
        .run("triangulate points.csv -o nowhere/mesh.ele", 4)
        .says(&["nowhere", "create"]);
    std::fs::create_dir(folder.path().join("taken.svg")).expect("a folder");
    folder
        .run("triangulate points.csv --picture taken.svg", 4)
        .says(&["taken.svg", "folder"]);
    std::fs::create_dir(folder.path().join("taken.neigh")).expect("a folder");
    // Said before the work, whose input is not even there.
    folder
        .run("triangulate nowhere.csv -o taken.ele", 4)
        .says(&["taken.neigh", "folder"]);
    assert_eq!(folder.names(), ["points.csv", "taken.neigh", "taken.svg"]);
}

#[test]
fn help_and_version_are_0() {
    let folder = Folder::new();
    let version = folder.run("--version", 0);
    assert_eq!(
        version.stdout.trim(),
        concat!("delone ", env!("CARGO_PKG_VERSION"))
    );
    for command in [
        "mesh",
        "triangulate",
        "info",
        "doctor",
        "check",
        "sample",
        "convert",
        "cover",
        "algorithms",
        "race",
        "theatre",
        "run",
        "completions",
        "man",
    ] {
        assert!(folder.run("--help", 0).stdout.contains(command));
        let help = folder.run(&format!("{command} --help"), 0).stdout;
        for words in [
            "Examples:",
            &format!("delone {command} "),
            "Exit codes:",
            "130",
        ] {
            assert!(help.contains(words), "{command}: {words}");
        }
        let short = folder.run(&format!("{command} -h"), 0).stdout;
        assert!(short.contains("Examples:") && short.len() < help.len());
    }
}

#[test]
fn help_names_every_key_of_the_json_of_meshes() {
    let folder = Folder::with_points();
    let triangulate = folder.run("triangulate --help", 0).stdout;
    let mesh = triangulate.clone() + &folder.run("mesh --help", 0).stdout;
    for (command, help) in [("triangulate", triangulate), ("mesh", mesh)] {
        let json = folder
            .run(&format!("{command} points.csv --json"), 0)
            .json();
        for key in json.as_object().expect("an object").keys() {
            assert!(help.contains(key.as_str()), "help of {command}: {key}");
        }
    }
}

#[test]
fn help_names_every_key_of_the_json_of_info_and_check() {
    let folder = Folder::with_points();
    folder.run("triangulate points.csv --domain hull -o m.ele", 0);
    for (command, line) in [
        ("info", "info points.csv --json"),
        ("doctor", "doctor points.csv --json"),
        ("check", "check m.ele --json"),
        ("cover", "cover points.csv -d 2 --json"),
        ("convert", "convert points.csv p.npy --json"),
        ("sample", "sample lake -o lake.poly --json"),
    ] {
        let help = folder.run(&format!("{command} --help"), 0).stdout;
        let (_, help) = help.split_once("The JSON object").expect("a section");
        let json = folder.run(line, 0).json();
        for key in json.as_object().expect("an object").keys() {
            assert!(help.contains(key.as_str()), "{command}: {key}");
        }
    }
}

#[test]
fn help_and_readme_say_the_same_of_exit_codes() {
    let help = Folder::new().run("--help", 0).stdout;
    let (_, codes) = help.split_once("Exit codes:\n").expect("the codes");
    // What does not begin with a code goes on with the line before.
    let mut rows: Vec<String> = Vec::new();
    for line in codes.lines().take_while(|l| l.starts_with("  ")) {
        match rows.last_mut() {
            Some(row) if line.starts_with("     ") => row.push_str(&format!(" {}", line.trim())),
            _ => rows.push(line.trim().to_owned()),
        }
    }
    assert_eq!(rows.len(), 7);
    for row in rows {
        let (code, meaning) = row.split_once(' ').expect("a code");
        let row = format!("| {code} | {} |", meaning.trim());
        assert!(README.contains(&row), "the README lacks: {row}");
    }
}

#[test]
fn the_examples_of_the_readme_run() {
    let folder = Folder::with_points();
    let (_, section) = README.split_once("## Command line").expect("a section");
    let (section, _) = section.split_once("\n## ").expect("a section after it");
    let examples = section
        .lines()
        .filter_map(|line| line.strip_prefix("delone "))
        .map(|line| line.split('#').next().unwrap_or(line).trim());
    // Samples come first, for others read them.
    let (samples, others): (Vec<_>, Vec<_>) = examples.partition(|e| e.starts_with("sample"));
    assert_eq!((samples.len(), others.len()), (2, 22));
    for (name, content) in DATA {
        folder.write(name, content);
    }
    folder.write("survey.xyz", "0 0 1\n20 0 15\n0 20 32\n");
    folder.write(
        "cloud.laz",
        include_bytes!("../../delone-io/tests/data/lidar/seven.laz"),
    );
    folder.write(
        "map.shp",
        include_bytes!("../../delone-io/tests/data/gis/fields.shp"),
    );
    folder.write(
        "jobs.toml",
        "[[job]]\ninput = \"lake.poly\"\noutput = \"again.vtu\"\n",
    );
    std::fs::create_dir(folder.path().join("maps")).expect("a folder");
    folder.run("sample lake -o maps/lake.poly", 0);
    for example in samples.iter().chain(&others) {
        folder.run(&example.replace("1000000", "1000"), 0);
    }
}

#[test]
fn the_examples_of_the_pages_run() {
    let folder = Folder::new();
    std::fs::create_dir(folder.path().join("queries")).expect("a folder");
    for (name, content) in DATA {
        folder.write(&format!("queries/{name}"), content);
    }
    folder.write("survey.csv", "x,y,height\n0,0,1\n100,0,90\n0,100,260\n");
    folder.write("huts.csv", "x,y\n20,20\n200,1\n");
    folder.write("autzen-thin.xyz", "0 0 400\n30 0 405\n0 40 420\n");
    write_soundings(&folder);
    let pages = [
        (include_str!("../../../docs/queries.md"), 5),
        (include_str!("../../../docs/terrain.md"), 4),
        (include_str!("../../../docs/scattered.md"), 5),
    ];
    for (page, count) in pages {
        let examples = page.lines().filter(|l| l.starts_with("delone "));
        let examples: Vec<&str> = examples.filter(|l| !l.contains('|')).collect();
        assert_eq!(examples.len(), count);
        let mut said = String::new();
        for example in examples {
            let output = folder.run(&example["delone ".len()..], 0);
            said += &output.stderr;
            // What the page quotes is what is said.
            for line in output.stderr.lines().filter(|l| l.contains("tour")) {
                let is_figure = line.starts_with("123 points") || line.starts_with("no tour");
                assert!(!is_figure || page.contains(line), "{line}");
            }
        }
        let quoted = page.lines().filter(|l| {
            let begins = |begin: &&str| l.starts_with(begin);
            QUOTED.iter().any(begins)
        });
        for line in quoted {
            assert!(said.contains(&format!("{line}\n")), "{line}");
        }
    }
}

/// How lines of pages begin that programs print.
const QUOTED: [&str; 5] = [
    "600 data in",
    "12 data in",
    "data in a triangle:",
    "special case:",
    "600 points, ",
];

/// Writes what the page on scattered data works on, as its lines for the shell make it.
fn write_soundings(folder: &Folder) {
    let uniform = folder.run("sample uniform -n 600 --seed 3 -o - --to csv", 0);
    let [mut all, mut bay] = ["x,y,depth\n"; 2].map(str::to_owned);
    for row in uniform.stdout.lines().skip(1) {
        let (u, v) = row.split_once(',').expect("two columns");
        let [u, v] = [u, v].map(|c| c.parse::<f64>().expect("a number"));
        let [x, y] = [3000.0 * u * u.sqrt(), 2000.0 * v * v.sqrt()].map(f64::round);
        let row = format!("{x},{y},0\n");
        all += &row;
        if x < 1700.0 || y < 900.0 {
            bay += &row;
        }
    }
    folder.write("soundings.csv", all);
    folder.write("bay.csv", bay);
    let bay = "POLYGON ((-60 -60, 3100 -60, 3100 900, 1700 900, 1700 2100, -60 2100, -60 -60))";
    folder.write("bay.wkt", bay);
    let edges = "x,y\n1,0\n2,0\n3,0\n4,0\n5,0\n0,1\n0,2\n0,3\n0,4\n0,5\n1,1\n2,1\n";
    folder.write("edges.csv", edges);
    folder.write("corner.wkt", "POLYGON ((0 0, 6 0, 0 6, 0 0))");
}

#[test]
fn help_names_every_key_of_the_json_of_queries() {
    let folder = Folder::new();
    folder.write("p.csv", "x,y,z\n0,0,1\n1,0,90\n0,1,260\n");
    for (command, options) in [
        ("nearest", "p.csv"),
        ("voronoi", "--lloyd 1"),
        ("interpolate", "--cell 1"),
        ("contour", ""),
        ("graph", "--kind tour"),
        ("graph", "--kind alpha"),
        ("cluster", "-n 2"),
    ] {
        let help = folder.run(&format!("{command} --help"), 0).stdout;
        let (_, help) = help.split_once("The JSON object").expect("a section");
        let line = format!("{command} p.csv --json {options}");
        let json = folder.run(&line, 0).json();
        for key in json.as_object().expect("an object").keys() {
            assert!(help.contains(key.as_str()), "{command}: {key}");
        }
        for phase in json["seconds"].as_object().expect("phases").keys() {
            assert!(help.contains(phase.as_str()), "{command}: {phase}");
        }
    }
}

#[test]
fn lines_of_help_fit_a_terminal() {
    let folder = Folder::new();
    for line in [
        "-h",
        "mesh -h",
        "triangulate -h",
        "info -h",
        "doctor -h",
        "check -h",
        "sample -h",
        "convert -h",
        "cluster -h",
        "algorithms -h",
        "algorithms show -h",
        "algorithms run -h",
        "race -h",
        "theatre -h",
        "run -h",
        "completions -h",
        "man -h",
        "sample",
    ] {
        for text in folder.run(line, 0).stdout.lines() {
            assert!(text.chars().count() <= 100, "{line}: {text}");
        }
    }
}

#[test]
fn under_json_a_failure_is_an_object() {
    let folder = Folder::with_points();
    folder.write("bad.csv", "x,y\n0,0\n1,zero\n");
    for (line, code, kind, file, at) in [
        (
            "mesh points.csv --json --min-angle 70",
            2,
            "usage",
            None,
            None,
        ),
        (
            "info nowhere.csv --json",
            3,
            "bad_input",
            Some("nowhere.csv"),
            None,
        ),
        (
            "triangulate bad.csv --json",
            3,
            "bad_input",
            Some("bad.csv"),
            Some(3),
        ),
        (
            "check bad.csv --json",
            3,
            "bad_input",
            Some("bad.csv"),
            None,
        ),
        (
            "contour bad.csv --json",
            3,
            "bad_input",
            Some("bad.csv"),
            Some(3),
        ),
        (
            "triangulate points.csv --json -o none/m.vtu",
            4,
            "not_reached",
            None,
            None,
        ),
        ("sample lake --json", 2, "usage", None, None),
    ] {
        let output = folder.run(line, code);
        assert_eq!(output.stdout, "", "{line}");
        assert_eq!(
            output.stderr.lines().count(),
            1,
            "{line}: {}",
            output.stderr
        );
        let told: serde_json::Value = serde_json::from_str(&output.stderr).expect(line);
        assert_eq!(told["kind"], kind, "{line}: {told}");
        assert_eq!(told["code"], code, "{line}");
        assert_eq!(told["file"].as_str(), file, "{line}: {told}");
        assert_eq!(told["line"].as_u64(), at, "{line}: {told}");
        assert!(
            !told["error"].as_str().expect("words").contains("--help"),
            "{told}"
        );
    }
}

#[test]
fn samples_are_listed_as_objects() {
    let folder = Folder::new();
    let listed = folder.run("sample --json", 0).stdout;
    let names = listed.lines().map(|line| {
        let sample: serde_json::Value = serde_json::from_str(line).expect("an object");
        sample["name"].as_str().expect("a name").to_owned()
    });
    let names: Vec<String> = names.collect();
    let said = folder.run("sample", 0).stdout;
    assert!(names.len() > 10);
    for name in names {
        assert!(said.contains(&name), "{name}");
        folder.run(&format!("sample {name} -n 20 -o s.svg --quiet"), 0);
    }
}

#[test]
fn verbose_says_what_was_read_and_how_fast_and_quiet_forbids_it() {
    let folder = Folder::with_points();
    let output = folder.run("triangulate points.csv -v -o m.vtu", 0);
    output.says(&[
        "points.csv: csv, as its name says",
        "6 points from (0, 0) to (4, 3)",
        "memory: ",
        "m.vtu (",
        " kB)",
    ]);
    assert_eq!(output.stdout, "");
    let plain = folder.run("triangulate points.csv -o m.vtu", 0).stderr;
    assert!(!plain.contains("memory"), "{plain}");
    folder
        .run("triangulate points.csv -v -q", 2)
        .says(&["--verbose", "--quiet"]);
}

#[test]
fn words_are_coloured_for_terminals_only() {
    let folder = Folder::new();
    let said = folder.run("triangulate nowhere.csv", 3).stderr;
    assert!(said.starts_with("error: cannot read nowhere.csv"), "{said}");
    let mut command = folder.command("triangulate nowhere.csv");
    let forced = command.env("CLICOLOR_FORCE", "1").assert().code(3);
    let said = support::Output::of(forced).stderr;
    assert!(said.contains("\u{1b}["), "{said:?}");
    let mut command = folder.command("triangulate nowhere.csv");
    let bare = command.env("NO_COLOR", "1").assert().code(3);
    let said = support::Output::of(bare).stderr;
    assert!(!said.contains('\u{1b}'), "{said:?}");
}
