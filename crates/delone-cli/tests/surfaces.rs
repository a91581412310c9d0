//! `delone interpolate` and `delone contour`, seen from the shell.

mod support;

use serde_json::Value;
use support::Folder;

/// The plane z = x + 2y over a square of side 4, and its centre.
const PLANE: &str = "x,y,z,name\n0,0,0,a\n4,0,4,b\n4,4,12,c\n0,4,8,d\n2,2,6,e\n";

/// A square of side 4 with a square hole of side 2, with heights, numbered from 1.
const HOLED: &str = "\
8 2 1 0
1 0 0 0
2 4 0 4
3 4 4 12
4 0 4 8
5 1 1 3
6 3 1 5
7 3 3 9
8 1 3 7
8 0
1 1 2
2 2 3
3 3 4
4 4 1
5 5 6
6 6 7
7 7 8
8 8 5
1
1 2 2
";

fn folder() -> Folder {
    let folder = Folder::new();
    folder.write("plane.csv", PLANE);
    folder.write("holed.poly", HOLED);
    folder.write("asked.csv", "x,y,id\n1,1,7\n9,9,8\n2,0,9\n");
    folder.write("empty.csv", "x,y,z\n");
    folder.write("line.csv", "x,y,z\n0,0,1\n1,1,2\n3,3,3\n");
    folder.write("twice.csv", "x,y,z\n0,0,1\n4,0,2\n0,4,3\n4,0,6\n");
    folder.write("gap.csv", "x,y,h\n0,0,1\n4,0,\n0,4,3\n");
    folder.write("gap.node", "3 2 1 0\n# a\n1 0 0 1\n\n2 4 0 nan\n3 0 4 3\n");
    folder.write("words.csv", "x,y,h\n0,0,1\n# a\n4,0,2\n\n0,4,n/a\n");
    folder.write("names.csv", "x,y,town\n0,0,Bonn\n4,0,Ulm\n0,4,Kiel\n");
    folder.write("bare.csv", "x,y\n0,0\n4,0\n0,4\n");
    folder.write("two.csv", "x,y,h,k\n0,0,1,0\n4,0,2,0\n0,4,3,8\n");
    folder
}

fn json(folder: &Folder, line: &str) -> Value {
    folder.run(&format!("{line} --json"), 0).json()
}

#[test]
fn points_get_one_more_column() {
    let folder = folder();
    folder
        .run("interpolate plane.csv asked.csv -o out.csv", 0)
        .says(&["3 points", "1 outside"]);
    assert_eq!(
        folder.read("out.csv"),
        "x,y,id,z\n1,1,7,3\n9,9,8,\n2,0,9,2\n"
    );
    folder.run("interpolate plane.csv plane.csv -o out.xyz", 0);
    assert!(
        folder
            .read("out.xyz")
            .starts_with("# x y z z_interpolated\n0 0 0 0\n")
    );
    folder.run(
        "interpolate plane.csv asked.csv -o out.npy -o out.node --picture out.png --size 100",
        0,
    );
    assert!(folder.bytes("out.png").starts_with(b"\x89PNG"));
}

#[test]
fn every_method_reproduces_a_plane() {
    let folder = folder();
    for method in ["linear", "natural", "laplace", "smooth", "clough-tocher"] {
        let line = format!("interpolate plane.csv asked.csv --method {method} -o out.csv");
        assert_eq!(json(&folder, &line)["method"], method);
        let out = folder.read("out.csv");
        let rows: Vec<&str> = out.lines().collect();
        let value: f64 = rows[1]
            .rsplit(',')
            .next()
            .and_then(|z| z.parse().ok())
            .expect("z");
        assert!((value - 3.0).abs() < 1e-9, "{method}: {out}");
        assert!(rows[2].ends_with(','), "{method}: {out}");
    }
}

#[test]
fn a_grid_covers_the_points() {
    let folder = folder();
    folder.run(
        "interpolate plane.csv --cell 2 -o g.asc -o g.npy -o g.svg --picture g.png --size 100",
        0,
    );
    let expected =
        "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 2\nNODATA_value -9999\n7 9\n3 5\n";
    assert_eq!(folder.read("g.asc"), expected);
    let array = folder.bytes("g.npy");
    let last = array.last_chunk::<8>().expect("numbers");
    assert_eq!(f64::from_le_bytes(*last), 5.0);
    let found = json(&folder, "interpolate plane.csv --grid 4x2");
    assert_eq!(
        [&found["columns"], &found["rows"], &found["outside"]],
        [4, 2, 0]
    );
    assert_eq!(found["cell"].to_string(), "[1.0,2.0]");
    assert_eq!(found["range"].to_string(), "[2.5,9.5]");
    let piped = folder.run("interpolate plane.csv --cell 2 -o - --to asc", 0);
    assert_eq!(piped.stdout, expected);
}

#[test]
fn holes_have_no_values() {
    let folder = folder();
    let found = json(&folder, "interpolate holed.poly --cell 1 -o h.asc");
    assert_eq!([&found["evaluated"], &found["outside"]], [16, 4]);
    assert!(folder.read("h.asc").contains("\n5.5 -9999 -9999 8.5\n"));
    let lines = json(&folder, "contour holed.poly --levels 6 -o h.geojson");
    // On either side of the hole one.
    assert_eq!([&lines["lines"], &lines["rings"]], [2, 0]);
    // Below and left of the hole one line.
    let low = json(&folder, "contour holed.poly --levels 1");
    assert_eq!(low["lines"], 1);
}

#[test]
fn contours_lie_at_their_levels() {
    let folder = folder();
    let found = json(
        &folder,
        "contour plane.csv --levels 6,3,6 -o c.geojson -o c.svg --picture c.png",
    );
    assert_eq!(found["levels"].to_string(), "[3.0,6.0]");
    assert_eq!([&found["lines"], &found["rings"]], [2, 0]);
    let lines: Value = serde_json::from_str(&folder.read("c.geojson")).expect("JSON");
    for line in lines["features"].as_array().expect("features") {
        let level = line["properties"]["level"].as_f64().expect("a level");
        for p in line["geometry"]["coordinates"].as_array().expect("points") {
            let [x, y] = [0, 1].map(|i| p[i].as_f64().expect("a number"));
            assert!((x + 2.0 * y - level).abs() < 1e-12, "{p} at {level}");
        }
    }
    assert!(folder.read("c.svg").contains("<svg"));
    assert!(folder.bytes("c.png").starts_with(b"\x89PNG"));
    let every = json(&folder, "contour plane.csv --interval 5");
    assert_eq!(every["levels"].to_string(), "[5.0,10.0]");
    let some = json(&folder, "contour plane.csv --count 2");
    assert!((1..=4).contains(&some["levels"].as_array().expect("levels").len()));
    let below = json(&folder, "contour plane.csv --levels -5,100");
    assert_eq!(below["lines"], 0);
}

#[test]
fn values_are_chosen_by_name_or_number() {
    let folder = folder();
    for (choice, top) in [("h", 3.0), ("K", 8.0), ("1", 3.0), ("2", 8.0)] {
        let found = json(&folder, &format!("contour two.csv --value {choice}"));
        assert_eq!(found["range"][1], top, "{choice}");
    }
    let mean = json(&folder, "contour twice.csv --average");
    assert_eq!(mean["range"].to_string(), "[1.0,4.0]");
}

#[test]
fn what_makes_no_surface_is_refused() {
    let folder = folder();
    for (line, code, words) in [
        ("contour two.csv", 2, "--value: h, k"),
        ("contour two.csv --value m", 2, "no column \"m\""),
        ("contour two.csv --value 3", 2, "no column 3"),
        ("contour bare.csv", 3, "no column of numbers"),
        (
            "contour gap.csv",
            3,
            "gap.csv:3: point 1 has no number in column \"h\"",
        ),
        (
            "contour gap.node",
            3,
            "gap.node:5: point 2 has no number in column \"attribute1\"",
        ),
        (
            "interpolate words.csv --value H --cell 1",
            3,
            "words.csv:6: point 2 has \"n/a\", which is no number, in column \"h\"",
        ),
        ("contour words.csv", 3, "words.csv:6: point 2 has \"n/a\""),
        (
            "contour names.csv",
            3,
            "no numbers: town (line 2: \"Bonn\")",
        ),
        (
            "contour twice.csv",
            3,
            "twice.csv:5: points 1 and 3 are equal",
        ),
        ("contour twice.csv", 3, "the first stands on line 3"),
        ("contour twice.csv", 3, "--average"),
        ("contour line.csv", 3, "no triangle"),
        ("contour empty.csv", 3, "no triangle"),
        ("contour plane.csv --interval 0", 2, "positive"),
        ("contour plane.csv --interval 1e-9", 2, "contour lines"),
        ("contour plane.csv --count 0", 2, "levels"),
        ("contour plane.csv --levels 1,x", 2, "numbers"),
        ("contour plane.csv --levels 1 --count 3", 2, "--count"),
        ("contour plane.csv -o c.asc", 2, "cannot hold contour lines"),
        ("contour plane.csv --picture -", 2, "a picture needs a file"),
        ("interpolate plane.csv", 2, "--cell"),
        ("interpolate plane.csv asked.csv --cell 1", 2, "--cell"),
        ("interpolate plane.csv --cell -1", 2, "positive"),
        ("interpolate plane.csv --grid 0x4", 2, "400x300"),
        (
            "interpolate plane.csv --grid 99999x99999",
            2,
            "number of cells",
        ),
        ("interpolate plane.csv --cell 1 -o g.csv", 2, "only .asc"),
        (
            "interpolate plane.csv --cell 1 -o g.geojson",
            2,
            "cannot hold a raster",
        ),
        (
            "interpolate plane.csv asked.csv -o asked.csv",
            2,
            "is the input",
        ),
        ("interpolate line.csv --cell 1", 3, "no triangle"),
    ] {
        folder.run(line, code).says(&[words]);
    }
}
