//! `delone cover`, seen from the shell.

mod support;

use serde_json::Value;
use std::collections::BTreeMap;
use support::Folder;

/// A lattice of 12 by 10 points, moved a little, one of them twice, with two columns; and what goes wrong.
fn folder() -> Folder {
    let folder = Folder::new();
    let mut data = "lon,lat,depth,ship\n".to_owned();
    for i in 0..120 {
        let (x, y) = (f64::from(i % 12), f64::from(i / 12));
        let [dx, dy] = [37 * i % 11, 53 * i % 7].map(|k| f64::from(k) / 40.0);
        data += &format!("{},{},{},s{}\n", x + dx, y + dy, -i, i % 3);
    }
    let first = data.lines().nth(1).expect("a row").to_owned();
    folder.write("data.csv", format!("{data}{first}\n"));
    folder.write("few.csv", "x,y\n0,0\n1,0\n0,1\n1,1\n0,0\n");
    folder.write("line.csv", rows((0..20).map(|i| [i, 2 * i])));
    folder.write("empty.csv", "x,y\n");
    folder.write("nan.csv", "x,y\n0,0\nnan,1\n1,1\n");
    folder.write(
        "square.wkt",
        "POLYGON ((-1 -1, 13 -1, 13 11, -1 11, -1 -1))",
    );
    folder.write("small.wkt", "POLYGON ((-1 -1, 5 -1, 5 11, -1 11, -1 -1))");
    folder.write(
        "l.geojson",
        r#"{"type":"Polygon","coordinates":[[[-1,-1],[13,-1],[13,11],[9,14],[-1,11],[-1,-1]]]}"#,
    );
    folder.write("bow.wkt", "POLYGON ((-1 -1, 13 11, 13 -1, -1 11, -1 -1))");
    folder.write(
        "ring.wkt",
        "POLYGON ((-1 -1, 13 -1, 13 11, -1 11, -1 -1), (3 3, 4 3, 4 4, 3 3))",
    );
    folder.write("way.wkt", "LINESTRING (0 0, 4 0, 4 4)");
    folder.write(
        "pole.wkt",
        "POLYGON ((-1 -1, 13 -1, 13 11, 6 40, 5.9 40, -1 11, -1 -1))",
    );
    folder
}

fn rows(points: impl Iterator<Item = [i32; 2]>) -> String {
    let rows = points.map(|[x, y]| format!("{x},{y}\n"));
    format!("x,y\n{}", rows.collect::<String>())
}

fn json(folder: &Folder, line: &str) -> Value {
    folder.run(&format!("{line} --json"), 0).json()
}

fn number(value: &Value) -> usize {
    value
        .as_u64()
        .unwrap_or_else(|| panic!("a number: {value}")) as usize
}

/// How many data each triangle of a file of features holds.
fn held(folder: &Folder, name: &str) -> Vec<usize> {
    let features: Value = serde_json::from_str(&folder.read(name)).expect("JSON");
    let features = features["features"].as_array().expect("a list").clone();
    let held = features.iter().map(|f| number(&f["properties"]["data"]));
    held.collect()
}

#[test]
fn everything_is_written_and_says_the_same() {
    let folder = folder();
    let line =
        "cover data.csv -d 5 -o c.vtu -o c.ele -o c.geojson --picture c.png --data-out held.csv";
    let output = folder.run(line, 0);
    output.says(&[
        "120 data (1 duplicate) in",
        "asked for were 5 to 14",
        "#",
        "c.vtu, c.node, c.ele, c.edge, c.neigh, c.geojson, c.png and held.csv",
        "left out, because they hold no numbers of points: ship",
    ]);
    let held = held(&folder, "c.geojson");
    assert_eq!(held.iter().sum::<usize>(), 120);
    assert!(held.iter().all(|&n| n >= 5), "{held:?}");
    // The .ele and the rows tell the same.
    let ele = folder.read("c.ele");
    let of_ele = ele.lines().skip(1).map(|row| {
        let cells: Vec<&str> = row.split_whitespace().collect();
        cells[4].parse().expect("a number")
    });
    assert_eq!(of_ele.collect::<Vec<usize>>(), held);
    let mut rows: Vec<usize> = vec![0; held.len()];
    let csv = folder.read("held.csv");
    for row in csv.lines().skip(1).take(120) {
        let (_, triangle) = row.rsplit_once(',').expect("columns");
        rows[triangle.parse::<usize>().expect("a triangle")] += 1;
    }
    assert_eq!(rows, held);
    let vtu = folder.read("c.vtu");
    assert!(vtu.contains("Name=\"data\"") && vtu.contains("Name=\"special\""));
    assert!(folder.bytes("c.png").starts_with(b"\x89PNG"));
}

#[test]
fn columns_are_kept_and_one_is_added() {
    let folder = folder();
    folder.run("cover data.csv --data-out held.csv -q", 0);
    let [before, after] = ["data.csv", "held.csv"].map(|name| folder.read(name));
    assert!(after.starts_with("x,y,depth,triangle\n"), "{after}");
    assert_eq!(before.lines().count(), after.lines().count());
    let depth = |row: &str| row.split(',').nth(2).map(str::to_owned);
    for (old, new) in before.lines().zip(after.lines()).skip(1) {
        assert_eq!(depth(old), depth(new));
    }
    let rows: Vec<&str> = after.lines().skip(1).collect();
    assert_eq!(rows[0], rows[120], "equal data have one holder");
    // A column of this name is nobody else's.
    folder.run("cover held.csv --data-out again.csv -q", 0);
    assert!(
        folder
            .read("again.csv")
            .starts_with("x,y,depth,triangle,triangle_cover\n")
    );
    // Numbered as the mesh is.
    let line = "cover data.csv --one-based -o one.ele --data-out one.csv -q";
    folder.run(line, 0);
    let least = |name: &str| {
        let text = folder.read(name);
        let last = text
            .lines()
            .skip(1)
            .map(|row| row.rsplit_once(',').expect("columns").1);
        last.map(|t| t.parse::<usize>().expect("a triangle")).min()
    };
    assert_eq!([least("held.csv"), least("one.csv")], [Some(0), Some(1)]);
}

#[test]
fn the_json_has_its_keys() {
    let folder = folder();
    let found = json(&folder, "cover data.csv");
    let keys: Vec<&str> = found
        .as_object()
        .expect("an object")
        .keys()
        .map(String::as_str)
        .collect();
    let mut expected = [
        "data",
        "duplicates",
        "vertices",
        "triangles",
        "least",
        "most",
        "data_per_triangle",
        "histogram",
        "data_covered",
        "too_full",
        "special_cases",
        "min_angle_degrees",
        "area",
        "outline",
        "hash",
        "threads",
        "seconds",
        "peak_rss_bytes",
    ];
    expected.sort_unstable();
    let mut sorted = keys;
    sorted.sort_unstable();
    assert_eq!(sorted, expected);
    for (key, value) in [
        ("data", 120),
        ("duplicates", 1),
        ("least", 6),
        ("most", 17),
        ("data_covered", 120),
    ] {
        assert_eq!(found[key], value, "{key}");
    }
    let per = &found["data_per_triangle"];
    let mean = per["mean"].as_f64().expect("a mean");
    assert!((mean * found["triangles"].as_f64().expect("a count") - 120.0).abs() < 1e-9);
    let histogram: BTreeMap<usize, usize> = found["histogram"]
        .as_array()
        .expect("pairs")
        .iter()
        .map(|pair| (number(&pair[0]), number(&pair[1])))
        .collect();
    assert_eq!(
        histogram.values().sum::<usize>(),
        number(&found["triangles"])
    );
    assert_eq!(
        histogram.iter().map(|(n, often)| n * often).sum::<usize>(),
        120
    );
    let ends = [histogram.keys().next(), histogram.keys().last()];
    assert_eq!(
        ends.map(Option::unwrap),
        [&number(&per["min"]), &number(&per["max"])]
    );
    assert!(found["outline"].as_array().expect("corners").len() >= 3);
    for phase in ["read", "cover", "check", "write"] {
        assert!(found["seconds"][phase].is_f64(), "{phase}");
    }
}

#[test]
fn special_cases_say_why() {
    let folder = folder();
    // A row of data along the whole edge, and one beside it: no vertex leaves enough.
    folder.write("edge.csv", rows((0..=40).map(|i| [i, 0]).chain([[20, 30]])));
    let line = "cover edge.csv -d 3 --factor 1 -o e.geojson";
    let found = json(&folder, line);
    let special = found["special_cases"].as_array().expect("a list");
    assert_eq!(special.len(), number(&found["too_full"]));
    for case in special {
        assert!(number(&case["data"]) > 8, "{case}");
        let cause = case["cause"].as_str().expect("a word");
        match cause {
            "edge" => assert_eq!(case["edge"].as_array().map(Vec::len), Some(2)),
            "two-edges" => assert!(case["corner"].is_u64()),
            other => assert_eq!(other, "resolution"),
        }
        assert_eq!(case["corners"].as_array().map(Vec::len), Some(3));
        assert_eq!(case["places"].as_array().map(Vec::len), Some(3));
    }
    // One triangle alone, whatever it holds, is none: nobody has tried.
    let line = "cover data.csv --no-inner-points --no-edges --no-interior";
    let found = json(&folder, line);
    assert!(number(&found["too_full"]) > 0);
    assert_eq!(found["special_cases"].as_array().map(Vec::len), Some(0));
    folder.run(line, 0).says(&["more than 17"]);
}

#[test]
fn degrees_stand_for_numbers_of_data() {
    let folder = folder();
    for (degree, least) in [(0, 1), (1, 3), (2, 6), (3, 10)] {
        let by_degree = json(&folder, &format!("cover data.csv --degree {degree}"));
        let by_number = json(&folder, &format!("cover data.csv -d {least}"));
        assert_eq!(by_degree["least"], least);
        assert_eq!(by_degree["hash"], by_number["hash"]);
    }
}

#[test]
fn choices_choose() {
    let folder = folder();
    let usual = json(&folder, "cover data.csv");
    let spelled_out = "cover data.csv -d 6 --factor 1.1 --misses 3 --bisections 25 --threads 1";
    assert_eq!(json(&folder, spelled_out)["hash"], usual["hash"]);
    let width = |found: &Value| {
        let outline = found["outline"].as_array().expect("corners");
        let xs = outline.iter().map(|p| p[0].as_f64().expect("x"));
        xs.clone().fold(f64::MIN, f64::max) - xs.fold(f64::MAX, f64::min)
    };
    let wide = json(&folder, "cover data.csv -d 2 --factor 3");
    assert!(width(&wide) > width(&json(&folder, "cover data.csv -d 2 --factor 1.05")));
    let alone = json(
        &folder,
        "cover data.csv --no-inner-points --no-edges --no-interior",
    );
    assert!(number(&alone["triangles"]) < number(&usual["triangles"]));
    json(
        &folder,
        "cover data.csv --no-optimize --no-edges --misses 1",
    );
}

#[test]
fn domains_are_covered() {
    let folder = folder();
    for (file, corners) in [("square.wkt", 4), ("l.geojson", 5)] {
        let line = format!("cover data.csv -d 5 --domain {file} --no-edges --picture d.svg");
        let found = json(&folder, &line);
        assert_eq!(
            found["outline"].as_array().map(Vec::len),
            Some(corners),
            "{file}"
        );
        assert_eq!(found["data_covered"], 120);
    }
    assert!(folder.read("d.svg").contains("that hold 121 data"));
}

#[test]
fn what_cannot_be_covered_is_told_and_nothing_is_written() {
    let folder = folder();
    folder.write("c.vtu", "before");
    folder.write("held.csv", "before");
    let before = folder.names();
    for (line, code, words) in [
        (
            "cover data.csv -d 121",
            3,
            &["data.csv", "at least 121", "120 different", "-d 120"][..],
        ),
        (
            "cover few.csv",
            3,
            &["few.csv", "at least 6", "4 different"],
        ),
        (
            "cover line.csv",
            3,
            &["line.csv", "20 different data lie on one line"],
        ),
        ("cover empty.csv", 3, &["empty.csv", "0 different"]),
        ("cover nan.csv", 3, &["nan.csv:3"]),
        ("cover nosuch.csv", 3, &["nosuch.csv"]),
        (
            "cover data.csv --domain small.wkt",
            3,
            &["data.csv:", "lies outside of the domain"],
        ),
        (
            "cover data.csv --domain ring.wkt",
            3,
            &["ring.wkt", "more than one ring"],
        ),
        (
            "cover data.csv --domain way.wkt",
            3,
            &["way.wkt", "one closed ring"],
        ),
        (
            "cover data.csv --domain few.csv",
            3,
            &["few.csv", "no polygon"],
        ),
        (
            "cover data.csv --domain pole.wkt",
            4,
            &["pole.wkt", "at least 6"],
        ),
        (
            "cover data.csv --factor 0.9",
            2,
            &["--factor", "at least 1"],
        ),
        ("cover data.csv --factor -2", 2, &["--factor", "at least 1"]),
        ("cover data.csv --factor inf", 2, &["at least 1"]),
        ("cover data.csv -d 0", 2, &["0"]),
        ("cover data.csv -d 6 --degree 2", 2, &["--degree"]),
        (
            "cover data.csv --factor 2 --domain square.wkt",
            2,
            &["--factor", "--domain"],
        ),
        (
            "cover data.csv --no-edges --bisections 3",
            2,
            &["--bisections"],
        ),
        ("cover - --domain -", 2, &["standard input"]),
        ("cover", 2, &["POINTS"]),
    ] {
        let output = folder.run(
            &format!("{line} -o c.vtu --data-out held.csv --picture c.png"),
            code,
        );
        output.says(words);
        assert_eq!(output.stdout, "", "{line}");
        assert_eq!(folder.names(), before, "{line}");
        assert_eq!(
            [folder.read("c.vtu"), folder.read("held.csv")],
            ["before"; 2],
            "{line}"
        );
    }
    for (line, words) in [
        ("cover data.csv -o data.csv", "cannot hold a mesh"),
        ("cover data.csv --data-out data.csv", "is the input"),
        (
            "cover data.csv --domain l.geojson -o l.geojson",
            "is the input",
        ),
        ("cover data.csv --data-out -", "need a file"),
        ("cover data.csv --picture c.vtu", "c.vtu"),
        ("cover data.csv -o - --to ele --json", "--json"),
    ] {
        folder.run(line, 2).says(&[words]);
    }
    folder
        .run("cover data.csv -o nowhere/c.vtu", 4)
        .says(&["nowhere"]);
}

#[test]
fn a_domain_that_crosses_itself_is_refused() {
    let folder = folder();
    let before = folder.names();
    let output = folder.run("cover data.csv --domain bow.wkt -o c.vtu", 3);
    output.says(&["bow.wkt", "no simple polygon"]);
    assert_eq!(folder.names(), before);
}

#[test]
fn a_pipe_will_do() {
    let folder = folder();
    let data = folder.read("data.csv");
    folder.run("cover data.csv -o c.geojson -q", 0);
    let mut command = folder.command("cover - -o - --to geojson -q");
    let output = support::Output::of(command.write_stdin(data).assert().code(0));
    assert_eq!(output.stdout, folder.read("c.geojson"));
    assert_eq!(output.stderr, "");
}

#[test]
fn every_format_of_points_is_read() {
    let folder = folder();
    let usual = json(&folder, "cover data.csv");
    for name in ["d.npy", "d.xyz", "d.node", "d.vtu"] {
        folder.run(&format!("convert data.csv {name} -q"), 0);
        let found = json(&folder, &format!("cover {name}"));
        assert_eq!(found["hash"], usual["hash"], "{name}");
    }
    let swapped = json(&folder, "cover data.csv --columns lat,lon");
    assert_eq!(swapped["data"], 120);
    assert_ne!(swapped["hash"], usual["hash"]);
}
