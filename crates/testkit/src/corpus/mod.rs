//! Every file of the shared corpus as a graph of points, segments, holes and regions.
//!
//! Loaders are as simple as the files allow and are no parsers to imitate: they trust the corpus
//! and panic when it surprises them. A table says how each file is read or why it is not, and a
//! file that no rule names is a failure, so nothing is left out silently. What the corpus states of
//! a file is read from its README by [`facts`].
//!
//! The corpus itself is not part of the repository. It is found at `DELONE_SHARED`, or beside the
//! workspace.

mod facts;
mod shapes;
mod tables;

pub use facts::{Facts, facts};

use delone::Pslg;
use std::fs;
use std::path::{Path, PathBuf};

/// One file.
#[derive(Clone, Debug)]
pub struct Entry {
    /// Path within the corpus, with `/` between the parts.
    pub name: String,
    /// What is drawn in it: every coordinate pair that appears as a vertex, in the order of the
    /// file, duplicates included; and segments where the format has some.
    pub pslg: Pslg,
}

/// How a file is read.
#[derive(Clone, Copy, Debug)]
enum Rule {
    /// Triangle's `.node` and `.poly`: headers, then numbered rows.
    Node,
    /// JIGSAW's `.msh`: the rows after `point=` and `edge2=`, separated by semicolons.
    Msh,
    /// CDT's text: a count of vertices and of edges, then rows.
    Cdt,
    /// GeoJSON, or bare arrays: of positions, or of rings of positions.
    Json,
    /// Well-known text.
    Wkt,
    /// Rows that begin with two numbers; all other lines are headers and remarks.
    Table,
    /// Rows of two numbers that form a ring; `HOLE` begins another, `STEINER` loose points.
    Outline,
    /// Outlines of airfoils: rows of exactly two numbers that form a ring.
    Airfoil,
    /// LAS point clouds.
    Las,
    /// Test cases of predicates: after its number, each row holds several points and a sign.
    Cases,
    /// Has no points of its own; the reason.
    Skip(&'static str),
}

use Rule::*;

/// The rules by beginning and end of the name; the first that fits counts.
const RULES: &[(&str, &str, Rule)] = &[
    ("README.md", "", Skip("describes the corpus")),
    ("predicates/README.md", "", Skip("describes the fixtures")),
    (
        "nasty/parser/",
        "",
        Skip("malformed on purpose: for parsers"),
    ),
    ("nasty/", ".node", Node),
    ("nasty/", ".poly", Node),
    ("triangle/", ".ele", Skip("triangles: output of Triangle")),
    ("triangle/", ".edge", Skip("edges: output of Triangle")),
    ("triangle/", ".area", Skip("areas of triangles")),
    ("triangle/", ".poly", Node),
    ("triangle/", ".node", Node),
    ("cdt/expected/", "", Skip("topologies: output of CDT")),
    ("cdt/inputs/", ".txt", Cdt),
    ("poly2tri/", ".dat", Outline),
    ("earcut/expected.json", "", Skip("counts of triangles")),
    ("earcut/", ".json", Json),
    ("delaunator/", ".json", Json),
    ("delaunator-rs/", ".json", Json),
    (
        "delaunator-cpp/",
        "-triangles.json",
        Skip("triangles: output of delaunator"),
    ),
    ("delaunator-cpp/", ".geojson", Json),
    ("mesh2d/", ".msh", Msh),
    ("jigsaw/", ".msh", Msh),
    ("jigsaw-geo/", ".msh", Msh),
    ("natural-earth/", ".geojson", Json),
    ("geojson/", ".geojson", Json),
    ("lidar/", ".las", Las),
    ("lidar/", ".xyz", Table),
    ("lidar/hexbin.txt", "", Wkt),
    ("lidar/delaunaytest.txt", "", Table),
    ("predicates/", ".txt", Cases),
    ("wkt/", ".wkt", Wkt),
    ("airfoil/", ".dat", Airfoil),
    ("thesis/", ".json", Skip("worked examples: tables")),
    ("lecture/", ".json", Skip("worked examples: facts")),
    ("chapter/", ".json", Skip("worked examples: facts")),
    ("franke/FUNCTIONS.md", "", Skip("formulas")),
    (
        "franke/",
        ".json",
        Skip("nodes and errors that examples compare with"),
    ),
    ("franke/", ".csv", Table),
];

/// Finds the corpus; `None` if it is not on this machine.
pub fn root() -> Option<PathBuf> {
    let beside = concat!(env!("CARGO_MANIFEST_DIR"), "/../../../shared");
    let shared = std::env::var_os("DELONE_SHARED").map_or(beside.into(), PathBuf::from);
    Some(shared.join("data")).filter(|data| data.is_dir())
}

/// Reads every file that has points, sorted by name.
///
/// # Panics
/// If no rule tells how to read a file, or a file is not as its rule expects.
pub fn read_all(root: &Path) -> impl Iterator<Item = Entry> {
    let mut files = Vec::new();
    collect_files(root, &mut files);
    files.sort();
    let root = root.to_owned();
    files.into_iter().filter_map(move |path| {
        let relative = path.strip_prefix(&root).expect("below the root");
        let name = relative.to_string_lossy().replace('\\', "/");
        read(&root, &name)
    })
}

/// Reads one file; `None` if it has no points.
///
/// # Panics
/// If no rule tells how to read it, or it is not as its rule expects.
pub fn read(root: &Path, name: &str) -> Option<Entry> {
    if why_skipped(name).is_some() {
        return None;
    }
    let rule = rule_for(name).unwrap_or_else(|| panic!("no rule how to read {name}"));
    let path = root.join(name);
    let mut bytes = contents(&path);
    if matches!(rule, Node) && tables::has_points_elsewhere(&String::from_utf8_lossy(&bytes)) {
        bytes = [contents(&path.with_extension("node")), bytes].join(&b'\n');
    }
    let pslg = parse(rule, &bytes);
    assert!(!pslg.points.is_empty(), "{name}: no points found");
    let name = name.to_owned();
    Some(Entry { name, pslg })
}

/// Tells why a file is left out; `None` if it is read.
pub fn why_skipped(name: &str) -> Option<&'static str> {
    match rule_for(name)? {
        Skip(reason) => Some(reason),
        _ => None,
    }
}

fn contents(path: &Path) -> Vec<u8> {
    fs::read(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

fn collect_files(folder: &Path, files: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("a folder of the corpus") {
        let path = entry.expect("an entry of the corpus").path();
        if path.is_dir() {
            collect_files(&path, files);
        } else {
            files.push(path);
        }
    }
}

fn rule_for(name: &str) -> Option<Rule> {
    let mut rules = RULES.iter();
    let fits =
        |(begin, end, _): &&(&str, &str, Rule)| name.starts_with(begin) && name.ends_with(end);
    rules.find(fits).map(|&(_, _, rule)| rule)
}

fn parse(rule: Rule, bytes: &[u8]) -> Pslg {
    // Some airfoils have remarks in Latin-1.
    let text = String::from_utf8_lossy(bytes);
    match rule {
        Node => tables::node(&text),
        Msh => tables::msh(&text),
        Cdt => tables::cdt(&text),
        Json => shapes::json(&text),
        Wkt => shapes::wkt(&text),
        Table => tables::points(&text),
        Outline => tables::outline(&text),
        Airfoil => tables::airfoil(&text),
        Las => tables::las(bytes),
        Cases => tables::cases(&text),
        Skip(_) => Pslg::default(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A ring of three points, the last one equal to the first.
    const RING: &[[u32; 2]] = &[[0, 1], [1, 2]];

    /// A sample of each format, and the segments expected of it.
    const SAMPLES: &[(Rule, &str, &[[u32; 2]])] = &[
        (
            Node,
            "# remark\n2 2 1 0\n1 1.5 2 7 # why\n\n2 3 -4e2 8\n1 0\n1 1 2\n",
            &[[0, 1]],
        ),
        (
            Msh,
            "# remark\nMSHID=1\nndims=2\nPOINT=2\n1.5;2;0\n3;-4e2;0\nEDGE2=1\n0;1;0\n",
            &[[0, 1]],
        ),
        (Cdt, "2 1\n1.5  2\n3 -4e2\n0 1\n", &[[0, 1]]),
        (Json, "[[1.5, 2], [3, -4e2]]", &[]),
        (Json, "[[[1.5, 2], [3, -4e2], [1.5, 2]]]", RING),
        (
            Json,
            r#"{"bbox": [1, 2, 3, 4], "features": [{"geometry": {"type": "MultiLineString",
                "coordinates": [[[1.5, 2, 9], [3, -4e2]]]}}]}"#,
            &[[0, 1]],
        ),
        (Wkt, "LINESTRING Z (1.5 2 0,\n  3 -4e2 0)", &[[0, 1]]),
        (Table, "x,y,z\n1.5,2,0\nHOLE\n3 -4e2\n", &[]),
        (Outline, "1.5,2\n3 -4e2\n1.5 2\n", RING),
        (Outline, "STEINER\n1.5,2\n3 -4e2\n", &[]),
        (
            Airfoil,
            "NAME 12\n-2.0 3.0 -2.5 3.5\n 1.5 2\n 3 -4e2\n 1.5 2\n\nremark: 8 %",
            RING,
        ),
        (Cases, "1 1.5 2 3 -4e2 -1\n", &[]),
    ];

    #[test]
    fn reads_each_format() {
        for &(rule, text, segments) in SAMPLES {
            let pslg = parse(rule, text.as_bytes());
            let points: Vec<(f64, f64)> = pslg.points.iter().map(|&p| p.into()).collect();
            assert_eq!(points[..2], [(1.5, 2.0), (3.0, -4e2)], "{rule:?}");
            let ends = pslg.segments.iter().map(|s| s.map(|v| v.raw()));
            assert_eq!(ends.collect::<Vec<_>>(), segments, "{rule:?}");
        }
    }

    #[test]
    fn has_a_rule_only_for_what_it_knows() {
        assert!(rule_for("wkt/new.gml").is_none());
        assert_eq!(why_skipped("triangle/A.1.area"), Some("areas of triangles"));
        assert!(matches!(rule_for("triangle/A.poly"), Some(Node)));
    }
}
