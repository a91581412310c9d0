//! The points of every file of the shared corpus: every coordinate pair that appears as a vertex.
//!
//! Loaders are as simple as the files allow and are no parsers to imitate: they trust the corpus
//! and panic when it surprises them. A table says how each file is read or why it is not, and a
//! file that no rule names is a failure, so nothing is left out silently.
//!
//! The corpus itself is not part of the repository. It is found at `DELONE_SHARED`, or beside the
//! workspace.

use delone::Point;
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};

/// The points of one file.
#[derive(Clone, Debug)]
pub struct Entry {
    /// Path within the corpus, with `/` between the parts.
    pub name: String,
    /// Its vertices, in the order of the file, duplicates included.
    pub points: Vec<Point>,
}

/// How a file is read.
#[derive(Clone, Copy, Debug)]
enum Rule {
    /// Triangle's `.node` and `.poly`: a header, then numbered rows.
    Node,
    /// JIGSAW's `.msh`: the rows after `point=`, separated by semicolons.
    Msh,
    /// CDT's text: a count of vertices and of edges, then rows.
    Cdt,
    /// GeoJSON, or bare arrays: every array that begins with two numbers.
    Json,
    /// Well-known text: every position between parentheses.
    Wkt,
    /// Rows that begin with two numbers; all other lines are headers and remarks.
    Table,
    /// Outlines of airfoils: rows of exactly two numbers.
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
    ("triangle/", ".1.poly", Skip("its points are in .1.node")),
    ("triangle/", ".2.poly", Skip("its points are in .2.node")),
    ("triangle/", ".3.poly", Skip("its points are in .3.node")),
    ("triangle/", ".4.poly", Skip("its points are in .4.node")),
    ("triangle/", ".poly", Node),
    ("triangle/", ".node", Node),
    ("cdt/expected/", "", Skip("topologies: output of CDT")),
    ("cdt/inputs/", ".txt", Cdt),
    ("poly2tri/", ".dat", Table),
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
    ("franke/FUNCTIONS.md", "", Skip("formulas")),
    ("franke/", ".csv", Table),
];

/// Finds the corpus; `None` if it is not on this machine.
pub fn root() -> Option<PathBuf> {
    let beside = concat!(env!("CARGO_MANIFEST_DIR"), "/../../../shared");
    let shared = std::env::var_os("DELONE_SHARED").map_or(beside.into(), PathBuf::from);
    Some(shared.join("data")).filter(|data| data.is_dir())
}

/// Reads the points of every file that has some, sorted by name.
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

/// Reads the points of one file; `None` if it has none.
///
/// # Panics
/// If no rule tells how to read it, or it is not as its rule expects.
pub fn read(root: &Path, name: &str) -> Option<Entry> {
    if why_skipped(name).is_some() {
        return None;
    }
    let rule = rule_for(name).unwrap_or_else(|| panic!("no rule how to read {name}"));
    let bytes = fs::read(root.join(name)).unwrap_or_else(|e| panic!("{name}: {e}"));
    let points = parse(rule, &bytes);
    assert!(!points.is_empty(), "{name}: no points found");
    let name = name.to_owned();
    Some(Entry { name, points })
}

/// Tells why a file is left out; `None` if it is read.
pub fn why_skipped(name: &str) -> Option<&'static str> {
    match rule_for(name)? {
        Skip(reason) => Some(reason),
        _ => None,
    }
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

fn parse(rule: Rule, bytes: &[u8]) -> Vec<Point> {
    // Some airfoils have remarks in Latin-1.
    let text = String::from_utf8_lossy(bytes);
    match rule {
        Node => node(&text),
        Msh => msh(&text),
        Cdt => cdt(&text),
        Json => json(&text),
        Wkt => wkt(&text),
        Table => rows(&text).filter_map(|row| first_two(&row)).collect(),
        Airfoil => rows(&text)
            .filter(|row| row.len() == 2)
            .filter_map(|row| first_two(&row))
            .collect(),
        Las => las(bytes),
        Cases => cases(&text),
        Skip(_) => Vec::new(),
    }
}

fn node(text: &str) -> Vec<Point> {
    let lines = text
        .lines()
        .map(|line| line.split('#').next().unwrap_or(""));
    let mut rows = lines.map(fields).filter(|row| !row.is_empty());
    let header = rows.next().expect("a header");
    let count = header[0].parse().expect("a count");
    rows.take(count).map(|row| point(&row[1..])).collect()
}

fn msh(text: &str) -> Vec<Point> {
    let mut lines = text.lines().map(str::to_lowercase);
    let header = lines.find_map(|line| line.strip_prefix("point=").map(str::to_owned));
    let count = header
        .expect("a section of points")
        .trim()
        .parse()
        .expect("a count");
    let rows = lines.take(count);
    rows.map(|line| point(&line.split(';').collect::<Vec<_>>()))
        .collect()
}

fn cdt(text: &str) -> Vec<Point> {
    let mut rows = rows(text);
    let count = rows.next().expect("a header")[0].parse().expect("a count");
    rows.take(count).map(|row| point(&row)).collect()
}

fn json(text: &str) -> Vec<Point> {
    let mut points = Vec::new();
    collect_positions(&serde_json::from_str(text).expect("JSON"), &mut points);
    points
}

fn collect_positions(value: &Value, points: &mut Vec<Point>) {
    match value {
        Value::Array(items) => match items
            .first_chunk()
            .map(|pair: &[_; 2]| pair.each_ref().map(Value::as_f64))
        {
            Some([Some(x), Some(y)]) => points.push(Point::new(x, y)),
            _ => items
                .iter()
                .for_each(|item| collect_positions(item, points)),
        },
        Value::Object(members) => ["features", "geometry", "geometries", "coordinates"]
            .iter()
            .filter_map(|&key| members.get(key))
            .for_each(|member| collect_positions(member, points)),
        _ => {}
    }
}

fn wkt(text: &str) -> Vec<Point> {
    let positions = text.split(['(', ')', ',']).map(fields);
    positions.filter_map(|row| first_two(&row)).collect()
}

fn las(bytes: &[u8]) -> Vec<Point> {
    let u32_at = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap());
    let f64_at = |at: usize| f64::from_le_bytes(bytes[at..at + 8].try_into().unwrap());
    assert_eq!(&bytes[..4], b"LASF");
    let first = u32_at(96) as usize;
    let length = usize::from(u16::from_le_bytes([bytes[105], bytes[106]]));
    let (scale, offset) = ([131, 139].map(f64_at), [155, 163].map(f64_at));
    let coordinate = |record: usize, axis: usize| {
        let raw = u32_at(record + 4 * axis).cast_signed();
        f64::from(raw) * scale[axis] + offset[axis]
    };
    let records = (0..u32_at(107) as usize).map(|i| first + i * length);
    records
        .map(|r| Point::new(coordinate(r, 0), coordinate(r, 1)))
        .collect()
}

fn cases(text: &str) -> Vec<Point> {
    let coordinates = |row: &Vec<&str>| row[1..row.len() - 1].iter().map(|f| number(f)).collect();
    let cases = rows(text).map(|row| coordinates(&row));
    let pairs = |case: Vec<f64>| case.as_chunks::<2>().0.to_vec();
    cases.flat_map(pairs).map(Point::from).collect()
}

fn rows(text: &str) -> impl Iterator<Item = Vec<&str>> {
    text.lines().map(fields).filter(|row| !row.is_empty())
}

fn fields(line: &str) -> Vec<&str> {
    let separators = |c: char| c.is_whitespace() || c == ',';
    line.split(separators).filter(|f| !f.is_empty()).collect()
}

fn first_two(row: &[&str]) -> Option<Point> {
    let [x, y] = row.first_chunk()?;
    Some(Point::new(x.parse().ok()?, y.parse().ok()?))
}

fn point(row: &[&str]) -> Point {
    Point::new(number(row[0]), number(row[1]))
}

fn number(field: &str) -> f64 {
    let number = field.trim().parse();
    number.unwrap_or_else(|_| panic!("{field:?} is no number"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn coordinates(points: &[Point]) -> Vec<(f64, f64)> {
        points.iter().map(|&p| p.into()).collect()
    }

    #[test]
    fn reads_each_format() {
        let expected = [(1.5, 2.0), (3.0, -4e2)];
        let samples = [
            (
                Node,
                "# remark\n2 2 1 0\n0 1.5 2 7 # why\n\n1 3 -4e2 8\n1 0\n0 0 1\n",
            ),
            (
                Msh,
                "# remark\nMSHID=1\nndims=2\nPOINT=2\n1.5;2;0\n3;-4e2;0\nEDGE2=1\n0;1;0\n",
            ),
            (Cdt, "2 1\n1.5  2\n3 -4e2\n0 1\n"),
            (Json, "[[1.5, 2], [3, -4e2]]"),
            (
                Json,
                r#"{"bbox": [1, 2, 3, 4], "features": [{"geometry": {"coordinates": [[[1.5, 2, 9], [3, -4e2]]]}}]}"#,
            ),
            (Wkt, "LINESTRING Z (1.5 2 0,\n  3 -4e2 0)"),
            (Table, "x,y,z\n1.5,2,0\nHOLE\n3 -4e2\n"),
            (
                Airfoil,
                "NAME 12\n-2.0 3.0 -2.5 3.5\n 1.5 2\n 3 -4e2\n\nremark: 8 %",
            ),
            (Cases, "1 1.5 2 3 -4e2 -1\n"),
        ];
        for (rule, text) in samples {
            assert_eq!(
                coordinates(&parse(rule, text.as_bytes())),
                expected,
                "{rule:?}"
            );
        }
    }

    #[test]
    fn has_a_rule_only_for_what_it_knows() {
        assert!(rule_for("wkt/new.gml").is_none());
        assert_eq!(
            why_skipped("triangle/A.1.poly"),
            Some("its points are in .1.node")
        );
        assert!(matches!(rule_for("triangle/A.poly"), Some(Node)));
    }
}
