//! `delone nearest` and `delone graph`, seen from the shell.

mod support;

use support::Folder;

/// The corners of a rectangle, a point inside, and that point once more.
fn folder() -> Folder {
    let folder = Folder::with_points();
    // Near (1, 1); near (4, 3); as far from (0, 0) as from (0, 3).
    folder.write("asked.csv", "x,y\n1,1.5\n8,6\n-2,1.5\n");
    folder.write("asked.node", "1 2 0 0\n1 4 1\n");
    folder.write("empty.csv", "x,y\n");
    folder.write("one.csv", "x,y\n2,2\n");
    folder.write("line.csv", "x,y\n0,0\n3,4\n6,8\n");
    folder
}

fn numbers(bytes: &[u8], skip: usize) -> Vec<f64> {
    let (numbers, _) = bytes[skip..].as_chunks::<8>();
    numbers.iter().map(|n| f64::from_le_bytes(*n)).collect()
}

#[test]
fn the_nearest_point_has_the_lowest_number() {
    let folder = folder();
    folder
        .run("nearest points.csv asked.csv -o near.csv", 0)
        .says(&["3 links", "wrote near.csv"]);
    let expected = "query,vertex,distance\n0,4,0.5\n1,2,5\n2,0,2.5\n";
    assert_eq!(folder.read("near.csv"), expected);
    let piped = folder.run("nearest points.csv asked.csv -o - --to csv --threads 1", 0);
    assert_eq!(piped.stdout, expected);
    folder.run("nearest points.csv asked.csv -o near.txt", 0);
    assert!(
        folder
            .read("near.txt")
            .starts_with("# query vertex distance\n0 4 0.5\n")
    );
}

#[test]
fn several_nearest_come_by_distance() {
    let folder = folder();
    folder.run("nearest points.csv one.csv -k 3 -o near.csv", 0);
    let rows = folder.read("near.csv");
    let named: Vec<&str> = rows.lines().skip(1).map(|row| &row[..3]).collect();
    assert_eq!(named, ["0,4", "0,2", "0,3"]);
    // Exactly 2.5 away, though not nearer.
    folder.run("nearest points.csv asked.csv --radius 2.5 -o near.csv", 0);
    let all = "0,0,1.8027756377319948\n0,3,1.8027756377319948\n0,4,0.5\n2,0,2.5\n2,3,2.5\n";
    assert_eq!(
        folder.read("near.csv"),
        format!("query,vertex,distance\n{all}")
    );
    folder.run(
        "nearest points.csv asked.csv --radius 2.5 -k 1 -o near.csv",
        0,
    );
    assert_eq!(
        folder.read("near.csv"),
        "query,vertex,distance\n0,4,0.5\n2,0,2.5\n"
    );
}

#[test]
fn numbers_are_those_of_the_files() {
    let folder = folder();
    folder.write("points.node", "2 2 0 0\n1 0 0\n2 4 0\n");
    folder.run("nearest points.node asked.node -o near.csv", 0);
    assert_eq!(folder.read("near.csv"), "query,vertex,distance\n1,2,1\n");
    folder.run("nearest points.csv asked.node -o near.csv", 0);
    assert_eq!(folder.read("near.csv"), "query,vertex,distance\n1,1,1\n");
    folder.run("nearest points.node one.csv -o near.csv", 0);
    assert!(folder.read("near.csv").contains("\n0,1,2.8284271247461"));
}

#[test]
fn every_format_holds_links() {
    let folder = folder();
    folder.run(
        "nearest points.csv asked.csv -o n.npy -o n.geojson -o n.svg --picture n.png --size 200",
        0,
    );
    let array = folder.bytes("n.npy");
    let header = 10 + usize::from(array[8]) + 256 * usize::from(array[9]);
    assert_eq!(
        numbers(&array, header),
        [0.0, 4.0, 0.5, 1.0, 2.0, 5.0, 2.0, 0.0, 2.5]
    );
    let lines: serde_json::Value = serde_json::from_str(&folder.read("n.geojson")).expect("JSON");
    let line = &lines["features"][1];
    assert_eq!(line["properties"]["vertex"], 2);
    assert_eq!(
        line["geometry"]["coordinates"].to_string(),
        "[[8.0,6.0],[4.0,3.0]]".replace(".0", "")
    );
    assert!(folder.read("n.svg").contains("<svg"));
    assert!(folder.bytes("n.png").starts_with(b"\x89PNG"));
    folder
        .run("nearest points.csv asked.csv -o n.vtu", 2)
        .says(&["vtu cannot hold links"]);
}

#[test]
fn figures_are_json() {
    let folder = folder();
    let json = folder.run("nearest points.csv asked.csv --json", 0).json();
    for (key, value) in [
        ("points", 6),
        ("distinct_points", 5),
        ("queries", 3),
        ("links", 3),
    ] {
        assert_eq!(json[key], value, "{key}");
    }
    assert_eq!(json["longest"], 5.0);
    assert_eq!(json["unanswered"], 0);
    for phase in ["read", "index", "query", "write"] {
        assert!(json["seconds"][phase].is_number(), "{phase}");
    }
    folder.run("nearest points.csv asked.csv --json -o -", 2);
}

#[test]
fn few_points_are_no_trouble() {
    let folder = folder();
    let json = folder
        .run("nearest empty.csv asked.csv --json -k 2", 0)
        .json();
    assert_eq!(json["unanswered"], 3);
    assert!(json["longest"].is_null());
    let json = folder
        .run("nearest points.csv empty.csv --json --radius 1", 0)
        .json();
    assert_eq!(json["links"], 0);
    let json = folder
        .run("nearest one.csv asked.csv --json -k 9", 0)
        .json();
    assert_eq!(json["links"], 3);
    let json = folder.run("nearest line.csv one.csv --json -k 9", 0).json();
    assert_eq!(json["links"], 3);
}

#[test]
fn what_makes_no_sense_is_refused() {
    let folder = folder();
    for (line, code, words) in [
        ("nearest points.csv", 2, "QUERIES"),
        (
            "nearest points.csv asked.csv --radius -1",
            2,
            "not negative",
        ),
        ("nearest points.csv asked.csv -k 0", 2, "0"),
        ("nearest - -", 2, "read but once"),
        ("nearest points.csv gone.csv", 3, "gone.csv"),
        (
            "nearest points.csv asked.csv -o asked.csv",
            2,
            "asked.csv is the input",
        ),
        ("nearest points.csv asked.csv -o near", 2, "tells no format"),
        ("graph points.csv", 2, "--kind"),
        ("graph points.csv --kind fence", 2, "no such graph"),
        ("graph points.csv --kind alpha=-2", 2, "not negative"),
        (
            "graph points.csv --kind mst -o points.csv",
            2,
            "is the input",
        ),
    ] {
        folder.run(line, code).says(&[words]);
    }
    assert_eq!(folder.read("points.csv"), support::POINTS);
}

#[test]
fn a_tour_goes_around() {
    let folder = Folder::new();
    folder.write("box.csv", "x,y\n0,0\n4,0\n4,3\n0,3\n");
    folder
        .run("graph box.csv --kind tour -o tour.csv", 0)
        .says(&["1.0000 times"]);
    let tour = folder.read("tour.csv");
    assert!(
        tour == "from,to,length\n0,1,4\n1,2,3\n2,3,4\n3,0,3\n"
            || tour == "from,to,length\n0,3,3\n3,2,4\n2,1,3\n1,0,4\n",
        "{tour}"
    );
    let json = folder.run("graph box.csv --kind tour --json", 0).json();
    assert_eq!(json["length"], 14.0);
    assert_eq!(json["edges"], 4);
    assert!(json["lower_bound"].as_f64().expect("a bound") > 13.99);
}

#[test]
fn graphs_have_the_edges_that_they_should() {
    let folder = folder();
    // By hand: from (1, 1) to (0, 0), (0, 3), (4, 0); (4, 3) to (4, 0).
    folder.run("graph points.csv --kind mst -o g.csv", 0);
    let tree = folder.read("g.csv");
    let ends: Vec<&str> = tree.lines().skip(1).map(|row| &row[..3]).collect();
    assert_eq!(ends, ["0,4", "3,4", "1,2", "1,4"]);
    let count = |kind: &str| {
        let json = folder
            .run(&format!("graph points.csv --kind {kind} --json"), 0)
            .json();
        assert_eq!(json["distinct_points"], 5, "{kind}");
        json["edges"].as_u64().expect("a count")
    };
    assert_eq!(count("nearest"), 5);
    let [relative, gabriel] = [count("rng"), count("gabriel")];
    assert!((4..=gabriel).contains(&relative), "{relative}, {gabriel}");
    // Without the flat triangle at the bottom; with it, the rectangle; without any, nothing.
    assert_eq!(count("alpha"), 5);
    assert_eq!(count("alpha=99"), 4);
    assert_eq!(count("alpha=0"), 0);
}

#[test]
fn graphs_of_few_points_are_small() {
    let folder = folder();
    for kind in [
        "mst", "gabriel", "rng", "nearest", "tour", "alpha", "alpha=1",
    ] {
        for (file, most) in [("empty.csv", 0), ("one.csv", 0), ("line.csv", 3)] {
            let json = folder
                .run(&format!("graph {file} --kind {kind} --json"), 0)
                .json();
            assert!(
                json["edges"].as_u64().expect("a count") <= most,
                "{kind} of {file}"
            );
            assert!(!json["length"].to_string().starts_with('-'), "{kind}");
        }
    }
    let json = folder.run("graph line.csv --kind mst --json", 0).json();
    assert_eq!(json["length"], 10.0);
}
