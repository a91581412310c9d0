//! `delone voronoi`, seen from the shell.

mod support;

use serde_json::Value;
use support::Folder;

/// Four sites, two of them on either side of x = 2.
const SITES: &str = "x,y,people,name\n1,1,10,a\n3,1,20,b\n1,3,30,c\n3,3,40,d\n";

fn folder() -> Folder {
    let folder = Folder::new();
    folder.write("sites.csv", SITES);
    folder.write("empty.csv", "x,y\n");
    folder.write("one.csv", "x,y\n1,1\n");
    folder.write("line.csv", "x,y\n0,0\n1,1\n3,3\n");
    folder.write(
        "u.wkt",
        "POLYGON ((0 0, 4 0, 4 4, 3 4, 3 2, 1 2, 1 4, 0 4, 0 0))",
    );
    folder.write("way.wkt", "LINESTRING (0 0, 4 0, 4 4)");
    folder.write("bow.wkt", "POLYGON ((0 0, 4 4, 4 0, 0 4, 0 0))");
    folder
}

fn json(folder: &Folder, line: &str) -> Value {
    folder.run(&format!("{line} --json"), 0).json()
}

#[test]
fn cells_fill_the_box() {
    let folder = folder();
    let found = json(&folder, "voronoi sites.csv --clip 0,0,4,5");
    for (key, value) in [
        ("sites", 4),
        ("cells", 4),
        ("unbounded", 4),
        ("vertices", 1),
        ("edges", 4),
    ] {
        assert_eq!(found[key], value, "{key}");
    }
    assert_eq!([&found["area"], &found["clip_area"]], [20.0, 20.0]);
    assert_eq!([&found["smallest"], &found["largest"]], [4.0, 6.0]);
    // The usual box is a tenth of the larger side larger: 2.4 by 2.4.
    let usual = json(&folder, "voronoi sites.csv");
    assert!((usual["area"].as_f64().expect("an area") - 5.76).abs() < 1e-12);
}

#[test]
fn every_format_holds_cells() {
    let folder = folder();
    let line = "voronoi sites.csv --clip 0,0,4,4 -o c.geojson -o c.vtu -o c.svg --picture c.png --size 200";
    folder
        .run(line, 0)
        .says(&["4 cells", "wrote c.geojson, c.vtu, c.svg and c.png"]);
    let cells: Value = serde_json::from_str(&folder.read("c.geojson")).expect("JSON");
    let cell = &cells["features"][2];
    assert_eq!(cell["properties"]["site"], 2);
    assert_eq!(cell["properties"]["people"], 30);
    assert_eq!(cell["properties"]["area"], 4);
    assert_eq!(cell["geometry"]["type"], "Polygon");
    assert!(folder.read("c.vtu").contains("<VTKFile"));
    assert!(folder.read("c.svg").contains("<svg"));
    assert!(folder.bytes("c.png").starts_with(b"\x89PNG"));
    let piped = folder.run("voronoi sites.csv --clip 0,0,4,4 -o - --to geojson", 0);
    assert_eq!(piped.stdout, folder.read("c.geojson"));
    folder
        .run("voronoi sites.csv -o c.csv", 2)
        .says(&["cannot hold cells", "geojson"]);
}

#[test]
fn the_files_of_triangle_come_in_pairs() {
    let folder = folder();
    folder.write("three.csv", "x,y\n0,0\n4,0\n0,4\n");
    folder
        .run("voronoi three.csv -o t.v.edge", 0)
        .says(&["t.v.node", "t.v.edge"]);
    assert_eq!(folder.read("t.v.node"), "1 2 0 0\n0 2 2\n");
    assert!(folder.read("t.v.edge").starts_with("3 0\n0 0 -1 "));
    folder.run("voronoi three.csv -o t.v.node -o t.geojson", 0);
    assert!(folder.names().contains(&"t.geojson".to_owned()));
}

#[test]
fn polygons_clip_and_cut_cells_apart() {
    let folder = folder();
    let found = json(&folder, "voronoi sites.csv --clip u.wkt -o u.geojson");
    assert_eq!([&found["area"], &found["clip_area"]], [12.0, 12.0]);
    // Two sites of one column: the upper one has both arms.
    folder.write("column.csv", "x,y\n2,1\n2,3\n");
    let found = json(&folder, "voronoi column.csv --clip u.wkt -o u.geojson");
    assert_eq!([&found["smallest"], &found["largest"]], [4.0, 8.0]);
    assert!(folder.read("u.geojson").contains("MultiPolygon"));
    folder.write("far.csv", "x,y\n1,1\n90,90\n");
    let found = json(&folder, "voronoi far.csv --clip 0,0,2,2");
    assert_eq!(found["empty"], 1);
}

#[test]
fn sites_are_spread_evenly() {
    let folder = folder();
    folder.write("two.csv", "x,y\n0.2,1\n0.4,1\n");
    let line = "voronoi two.csv --clip 0,0,4,2 --lloyd 200 --sites even.csv";
    let found = json(&folder, line);
    let lloyd = &found["lloyd"];
    assert!(lloyd["energy_after"].as_f64() < lloyd["energy_before"].as_f64());
    assert!((found["smallest"].as_f64().expect("an area") - 4.0).abs() < 1e-6);
    let even = folder.read("even.csv");
    let first: Vec<f64> = even
        .lines()
        .skip(1)
        .map(|row| {
            row.split(',')
                .next()
                .and_then(|x| x.parse().ok())
                .expect("x")
        })
        .collect();
    assert!(
        (first[0] - 1.0).abs() < 1e-6 && (first[1] - 3.0).abs() < 1e-6,
        "{even}"
    );
    folder
        .run("voronoi two.csv --sites even.csv", 2)
        .says(&["--lloyd"]);
    folder
        .run("voronoi two.csv --lloyd 1 --sites -", 2)
        .says(&["points need a file"]);
    folder
        .run("voronoi two.csv --lloyd 1 --sites two.csv", 2)
        .says(&["is the input"]);
}

#[test]
fn weights_move_borders() {
    let folder = folder();
    folder.write("discs.csv", "x,y,r2,name\n0,0,4,a\n4,0,0,b\n2,0,-50,c\n");
    let found = json(&folder, "voronoi discs.csv --weights r2 --clip 0,-1,4,1");
    assert_eq!([&found["cells"], &found["hidden"]], [2, 1]);
    // x² − 4 = (x − 4)² at x = 2.5.
    assert_eq!([&found["smallest"], &found["largest"]], [3.0, 5.0]);
    for (line, code, words) in [
        ("voronoi discs.csv --weights mass", 2, "no column \"mass\""),
        ("voronoi discs.csv --weights 2", 2, "r2"),
        ("voronoi one.csv --weights 1", 3, "no column of numbers"),
        (
            "voronoi discs.csv --weights 1 -o d.v.node",
            2,
            "power cells",
        ),
        ("voronoi discs.csv --weights 1 --lloyd 3", 2, "--lloyd"),
    ] {
        folder.run(line, code).says(&[words]);
    }
}

#[test]
fn few_sites_have_large_cells() {
    let folder = folder();
    let found = json(&folder, "voronoi empty.csv -o c.geojson");
    assert_eq!([&found["cells"], &found["empty"]], [0, 0]);
    assert_eq!(found["area"].to_string(), "0.0");
    let found = json(&folder, "voronoi one.csv --picture one.png");
    assert_eq!([&found["area"], &found["largest"]], [4.0, 4.0]);
    let found = json(&folder, "voronoi line.csv --clip 0,0,4,4");
    assert_eq!([&found["vertices"], &found["edges"]], [0, 2]);
    // Cut along x + y = 2 and x + y = 4… of a square of side 4.
    assert_eq!(found["area"], 16.0);
    assert_eq!(found["largest"], 8.0);
    let found = json(&folder, "voronoi empty.csv --lloyd 3 --sites s.csv");
    assert_eq!(found["sites"], 0);
}

#[test]
fn what_cannot_be_clipped_to_is_refused() {
    let folder = folder();
    for (line, code, words) in [
        ("--clip 0,0,1", 2, "four numbers"),
        ("--clip 0,0,0,1", 2, "empty"),
        ("--clip gone.geojson", 3, "gone.geojson"),
        ("--clip line.csv", 3, "no polygon"),
        ("--clip way.wkt", 3, "no polygon"),
        ("--clip bow.wkt", 3, "segments 0 and 2 cross"),
        ("--clip u.wkt -o u.wkt", 2, "u.wkt"),
        ("--crossings split", 2, "--clip"),
    ] {
        folder
            .run(&format!("voronoi sites.csv {line}"), code)
            .says(&[words]);
    }
    folder
        .run("voronoi sites.csv --clip bow.wkt", 3)
        .says(&["--crossings split"]);
    let found = json(
        &folder,
        "voronoi sites.csv --clip bow.wkt --crossings split",
    );
    assert_eq!(found["clip_area"], 8.0);
}
