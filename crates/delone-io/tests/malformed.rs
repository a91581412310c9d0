//! Malformed files: the error names file, line and culprit, and nothing panics or allocates much.

use delone_io::{
    DomainData, Error, Format, MeshData, PointSet, ReadOptions, Source, read_domain, read_mesh,
    read_points,
};
use proptest::prelude::*;
use std::path::{Path, PathBuf};

fn points_of(name: &str, bytes: &[u8]) -> Result<PointSet, Error> {
    let source = Source::Memory {
        name: name.to_owned(),
        bytes: bytes.to_vec(),
    };
    read_points(&source, &ReadOptions::default(), &())
}

fn points_at(path: &Path) -> Result<PointSet, Error> {
    read_points(&Source::Path(path.to_owned()), &ReadOptions::default(), &())
}

#[track_caller]
fn assert_error<T: std::fmt::Debug>(outcome: Result<T, Error>, expected: &str) {
    let message = outcome.expect_err(expected).to_string();
    assert!(message.contains(expected), "{message:?} lacks {expected:?}");
}

/// Name of the file, content, what the error must say.
const TABLE: &[(&str, &str, &str)] = &[
    ("a.node", "", "a.node: the file is empty"),
    ("a.node", "# only a comment\n", "the file is empty"),
    (
        "a.node",
        "3 2 0 0\n0 0 0\n1 1 0\n",
        "a.node:3: truncated: header says 3 points, file has 2",
    ),
    (
        "a.node",
        "1 2 0 0\n0 0 0\n1 1 0\n",
        "a.node:3: header says 1 points, but more rows follow",
    ),
    (
        "a.node",
        "2 2 0 0\n0 0 0\n2 1 0\n",
        "a.node:3: row is numbered \"2\", expected 1",
    ),
    (
        "a.node",
        "2 2 0 0\n7 0 0\n8 1 0\n",
        "a.node:2: row is numbered \"7\"",
    ),
    (
        "a.node",
        "1 2 0 0\n1 zero 0\n",
        "a.node:2: x is not a number: \"zero\"",
    ),
    (
        "a.node",
        "1 2 0 0\n1 0\n",
        "a.node:2: expected 3 columns, found 2",
    ),
    (
        "a.node",
        "1 2 0 1\n1 0 0 x\n",
        "a.node:2: marker is not a number",
    ),
    (
        "a.node",
        "1 2 0 7\n1 0 0 0\n",
        "a.node:1: 7 markers a point",
    ),
    (
        "a.node",
        "1 2 99999999999 0\n1 0 0\n",
        "99999999999 columns, at most 4096 are possible",
    ),
    (
        "a.node",
        "99999999999999999999 2 0 0\n",
        "count in the header is not a number",
    ),
    (
        "a.node",
        "1 2 0 0\n1 1e999 0\n",
        "point 1: x is 1e999, coordinates must be finite",
    ),
    ("a.node", "1 2 0 0\n1 0 \u{fffd}\n", "y is not a number"),
    (
        "a.poly",
        "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n1 0\n1 3 4\n0\n",
        "segment 1 names vertex 4 of 3 (numbered from 1)",
    ),
    (
        "a.poly",
        "1 2 0 0\n1 0 0\n9 0\n1 1 1\n",
        "header says 9 segments, file has 1",
    ),
    (
        "a.poly",
        "2 2 0 0\n1 0 0\n2 1 0\n",
        "a.poly:3: truncated: no header of segments; write 0",
    ),
    (
        "a.poly",
        "1 2 0 0\n1 0 0\n1 0\n1 1 1\n",
        "a.poly:4: truncated: no header of holes; write 0",
    ),
    (
        "a.poly",
        "1 2 0 0\n1 0 0\n0 0\n1\n1 nan 0\n",
        "a.poly:5: hole 1: x is nan, it must be finite",
    ),
    (
        "a.poly",
        "1 2 0 0\n1 0 0\n0 0\n-1\n",
        "a.poly:4: -1 holes: a count cannot be negative",
    ),
    (
        "a.poly",
        "1 2 0 0\n1 0 0\n0 0\n0\n2\n1 0 0 5\n",
        "a.poly:6: truncated: header says 2 regions, file has 1",
    ),
    (
        "a.poly",
        "1 2 0 0\n1 0 0\n0 0\n0\n1\n1 0 0\n",
        "a.poly:6: expected 5 columns, found 3",
    ),
    (
        "a.poly",
        "1 2 0 0\n1 0 0\n0 0\n0\n1\n1 0 0 five\n",
        "a.poly:6: attribute or area is not a number: \"five\"",
    ),
    (
        "a.poly",
        "1 2 0 0\n1 0 0\n0 0\n0\n0\nmore\n",
        "a.poly:6: header says 0 regions, but more rows follow",
    ),
    (
        "a.node",
        "1 2 0 1\n1 0 0 3000000000\n",
        "a.node:2: marker 3000000000 does not fit 32 bits",
    ),
    ("a.csv", "", "a.csv: the file is empty"),
    ("a.csv", "hello,world\n", "a.csv: no row of numbers"),
    ("a.xyz", "hello world\n", "a.xyz: no row of numbers"),
    ("a.xyz", "hello world\nand others\n", "x is not a number"),
    ("a.csv", "1,2\n3\0,4\n", "a.csv at byte 5: a zero byte"),
    (
        "a.csv",
        "1,2\n3,4\r5,6\n",
        "a.csv:2: a carriage return within a line",
    ),
    ("a.tsv", "1\t\n3\t4\n", "a.tsv:1: y is not a number: \"\""),
    (
        "a.csv",
        "x,y\n1,2\n3,four\n",
        "a.csv:3: y is not a number: \"four\"",
    ),
    ("a.csv", "1,2\n3\n", "a.csv:2: expected 2 columns, found 1"),
    (
        "a.csv",
        "1,2\n3,4,5\n",
        "a.csv:2: expected 2 columns, found 3",
    ),
    ("a.csv", "1,2\n3,nan\n", "a.csv:2: point 1: y is nan"),
    ("a.csv", "1,2\n3,\n", "a.csv:2: y is not a number: \"\""),
    ("a.csv", "0.l,2\n3,4\n", "a.csv:1: x is not a number"),
    ("a.csv", "\"a,1\n", "quote without end"),
    (
        "a.xyz",
        "1\n2\n",
        "found 1 column: a table of points needs two",
    ),
    ("a.npy", "", "a.npy: the file is empty"),
    ("a.npy", "\u{93}", "not an array"),
    ("a.vtu", "", "a.vtu: the file is empty"),
    ("a.vtu", "<VTKFile/>", "no <Piece>"),
    (
        "a.vtu",
        "<VTKFile><Piece>",
        "truncated: the file ends before </VTKFile>",
    ),
    (
        "a.vtu",
        "<VTKFile type=\"PolyData\"/>",
        "only UnstructuredGrid",
    ),
    (
        "a.vtu",
        "<VTKFile compressor=\"z\"/>",
        "without compression",
    ),
    ("a.vtu", "<VTKFile><a></b>", "broken XML"),
    ("a.geojson", " \n", "a.geojson: the file is empty"),
    (
        "a.geojson",
        "{\"type\":",
        "a.geojson:1:8: EOF while parsing",
    ),
    (
        "a.geojson",
        "[{}]",
        "a.geojson:1:3: invalid type: map, expected a number or an array of numbers",
    ),
    (
        "a.json",
        "[[1, 2], [[3, 4]]]",
        "positions and rings in one array",
    ),
    (
        "a.json",
        "[[1, 2],\n[3]]",
        "a position of one number; it needs two",
    ),
    (
        "a.json",
        "[1, 2, 3]",
        "an odd number of coordinates: the last x has no y",
    ),
    (
        "a.json",
        "[[[[1, 2]]]]",
        "arrays within arrays, deeper than those of one polygon",
    ),
    ("a.json", "[[[1, 2], 3]]", "numbers and arrays in one array"),
    ("a.json", "[[1, 2], [3, 1e400]]", "number out of range"),
    ("a.json", "[[1, 2]", "EOF while parsing"),
    ("a.json", "[[1, 2]] 3", "trailing characters"),
    (
        "a.csv",
        "x;y\n1,5;2,5\n1.5;2\n",
        "a.csv:3: x is not a number: \"1.5\"",
    ),
    (
        "a.csv",
        "1,234;567\n2,345;678\n",
        "a.csv: commas in the coordinates may be decimal ones or set thousands apart",
    ),
    (
        "a.csv",
        "x;y\n1,5;2,5\n1,2,3;4\n",
        "a.csv:3: x is not a number: \"1,2,3\"",
    ),
    ("a.geojson", "null", "null where an object should be"),
    ("a.geojson", "{}", "an object without the member \"type\""),
    (
        "a.geojson",
        "{\"type\": \"Topology\"}",
        "type \"Topology\" is none of GeoJSON's",
    ),
    (
        "a.geojson",
        "{\"type\": \"Point\"}",
        "a Point needs the member \"coordinates\"",
    ),
    (
        "a.geojson",
        "{\"type\": \"Point\", \"coordinates\": [1, 2]} x",
        "a.geojson:1:42: trailing characters",
    ),
    (
        "a.geojson",
        "{\"type\": \"Point\", \"coordinates\": [1, 1e999]}",
        "number out of range",
    ),
    (
        "a.geojson",
        "{\"type\": \"Point\", \"coordinates\": [1]}",
        "a position of one number",
    ),
    (
        "a.geojson",
        "{\"type\": \"Point\", \"coordinates\": [1, \"2\"]}",
        "invalid type: string \"2\", expected a number or an array",
    ),
    (
        "a.geojson",
        "{\"type\": \"Point\", \"coordinates\": [1, [2]]}",
        "a position of one number",
    ),
    (
        "a.geojson",
        "{\"type\": \"Point\", \"coordinates\": [1, []]}",
        "numbers and arrays in one array",
    ),
    (
        "a.geojson",
        "{\"type\": \"Point\", \"geometries\": []}",
        "a Point has no member \"geometries\"",
    ),
    (
        "a.geojson",
        "{\"type\": \"Point\", \"coordinates\": [], \"coordinates\": []}",
        "an object with the members \"coordinates\" and \"coordinates\"",
    ),
    (
        "a.geojson",
        "{\"type\": \"LineString\", \"coordinates\": [1, 2]}",
        "a position where an array of positions should be",
    ),
    (
        "a.geojson",
        "{\"type\": \"LineString\", \"coordinates\": [[1, 2]]}",
        "a line of one position",
    ),
    (
        "a.geojson",
        "{\"type\": \"FeatureCollection\", \"features\": [{\"type\": \"Point\", \"coordinates\": []}]}",
        "feature 0: a Point does not belong here",
    ),
    (
        "a.geojson",
        "{\"type\": \"FeatureCollection\", \"features\": [\n\
         {\"type\": \"Feature\", \"geometry\": null},\n\
         {\"type\": \"Feature\", \"geometry\":\n\
         {\"type\": \"Polygon\", \"coordinates\": [[[0, 0], [1, 0], [1, 1], [0, 1]]]}}]}",
        "a.geojson:4:70: feature 1: ring 0 is not closed: it begins at (0, 0) and ends at (0, 1)",
    ),
    (
        "a.geojson",
        "{\"type\": \"FeatureCollection\", \"features\": [\n\
         {\"geometry\": {\"geometries\": [], \"type\": \"GeometryCollection\"}, \"type\": \"Feat\"}]}",
        "a.geojson:2:78: feature 0: type \"Feat\" is none of GeoJSON's",
    ),
    (
        "a.geojson",
        "{\"type\": \"FeatureCollection\", \"features\": []} x",
        "a.geojson:1:47: trailing characters",
    ),
    (
        "a.geojson",
        "{\"type\": \"Polygon\", \"coordinates\": [[[0, 0], [1, 0], [0, 0]]]}",
        "ring 0 has 3 positions; at least 4 are needed",
    ),
    ("a.wkt", "", "a.wkt: the file is empty"),
    (
        "a.wkt",
        "POINT (1 2)\nPOINT (1",
        "a.wkt:2:9: expected a number, found the end of the file",
    ),
    (
        "a.wkt",
        "POINT (1 2, 3 4)",
        "a.wkt:1:16: a point of 2 positions",
    ),
    ("a.wkt", "POINT 1 2", "expected '(' or EMPTY, found \"1\""),
    ("a.wkt", "POINT (1 2;", "expected ',' or ')', found ';'"),
    ("a.wkt", "POINT (nan 2)", "point 0: x is nan"),
    ("a.wkt", "POINT (1 two)", "y is not a number: \"two\""),
    ("a.wkt", "POINT (1 2-3)", "y is not a number: \"2-3\""),
    ("a.wkt", "POINT Z (1 2)", "a position of 2 numbers"),
    ("a.wkt", "POINT (1 2 3 4 5)", "a position of 5 numbers"),
    (
        "a.wkt",
        "SRID=x;POINT (1 2)",
        "a.wkt:1:6: expected a number",
    ),
    (
        "a.wkt",
        "CIRCULARSTRING (0 0, 1 1, 2 0)",
        "a.wkt:1:1: \"CIRCULARSTRING\": curves are not read; replace them by lines",
    ),
    (
        "a.wkt",
        "BRIDGE (0 0, 1 1, 2 0)",
        "\"BRIDGE\" is not understood; known are POINT",
    ),
    (
        "a.wkt",
        "POINT (1 2)\n0101000000000000000000F03F0000000000\n",
        "a.wkt:2:1: byte 5 of the geometry: truncated: the geometry ends too early",
    ),
    (
        "a.wkt",
        "010100000000000",
        "a.wkt:1:1: an odd number of hexadecimal digits",
    ),
    (
        "a.wkt",
        "\\y0101",
        "a.wkt:1:2: expected x and hexadecimal digits, found \"y0101\"",
    ),
    (
        "a.wkt",
        "POLYGON ((0 0, 1 0, 1 1, 0 1))",
        "a.wkt:1:30: ring 0 is not closed",
    ),
    ("a.wkt", "POLYGON (EMPTY)", "ring 0 has 0 positions"),
    ("a.wkt", "LINESTRING (0 0)", "a line of one position"),
    ("a.ele", "1 3 0\n0 0 1 2\n", "without the files beside it"),
    ("a.edge", "0 1\n", "format edge cannot be read"),
    ("a.png", "", "format png cannot be read"),
    ("noise", "hello world\n", "unknown format"),
];

#[test]
fn every_malformed_text_says_what_is_wrong() {
    for (name, content, expected) in TABLE {
        assert_error(points_of(name, content.as_bytes()), expected);
    }
}

#[test]
fn files_of_known_parser_bugs_are_refused() {
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data");
    let cases = [
        (
            "huge-count.node",
            "truncated: header says 4000000000 points, file has 1",
        ),
        ("neg-count.node", "-3 points: a count cannot be negative"),
        ("bad-index.poly", "segment 1 names vertex 7 of 3"),
        ("nan.node", "nan.node:3: point 1: x is nan"),
        ("dim3.node", "dim3.node:1: dimension must be 2, not 3"),
    ];
    for (name, expected) in cases {
        assert_error(points_at(&data.join(name)), expected);
    }
}

#[test]
fn every_shared_nasty_file_is_refused() {
    let Some(folder) = shared("data/nasty/parser") else {
        eprintln!("skipped: the shared data are absent (set DELONE_SHARED)");
        return;
    };
    let files = std::fs::read_dir(folder).expect("folder");
    for path in files.map(|entry| entry.expect("entry").path()) {
        let error = points_at(&path).expect_err("a malformed file");
        let name = path
            .file_name()
            .expect("name")
            .to_string_lossy()
            .into_owned();
        assert!(error.to_string().contains(&name), "{error}");
    }
}

/// Finds a folder of the shared data.
fn shared(folder: &str) -> Option<PathBuf> {
    let beside = || Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared");
    let root = std::env::var_os("DELONE_SHARED").map_or_else(beside, PathBuf::from);
    let path = root.join(folder);
    path.is_dir().then_some(path)
}

/// Reads bytes as every format; panics would be bugs.
fn read_as_everything(bytes: &[u8]) {
    for format in Format::ALL {
        let options = ReadOptions {
            format: Some(format),
            ..ReadOptions::default()
        };
        let source = Source::Memory {
            name: "noise".to_owned(),
            bytes: bytes.to_vec(),
        };
        for points in [
            read_points(&source, &options, &()).ok(),
            read_mesh(&source, &options, &()).ok().map(checked),
            read_domain(&source, &options, &()).ok().map(checked_domain),
        ]
        .into_iter()
        .flatten()
        {
            assert!(points.points.iter().all(delone::Point::is_finite));
            assert!(
                points
                    .attributes
                    .iter()
                    .all(|a| a.values.len() == points.points.len())
            );
        }
    }
    let _ = Format::sniff(bytes);
}

fn checked(mesh: MeshData) -> PointSet {
    let n = mesh.vertices.points.len();
    assert!(mesh.triangles.as_flattened().iter().all(|v| v.index() < n));
    mesh.vertices
}

fn checked_domain(domain: DomainData) -> PointSet {
    let n = domain.vertices.points.len();
    let s = domain.segments.len();
    let ends = domain.segments.as_flattened();
    assert!(ends.iter().all(|v| v.index() < n));
    assert!(domain.segment_markers.is_none_or(|m| m.len() == s));
    let mut ranges = domain.polygons.iter();
    assert!(ranges.all(|range| range.start < range.end && range.end <= s));
    let regions = domain.regions.iter().map(|region| region.at);
    assert!(
        domain
            .holes
            .into_iter()
            .chain(regions)
            .all(|p| p.is_finite())
    );
    domain.vertices
}

/// Makes an array file.
fn npy(descr: &str, shape: &str, data: &[u8]) -> Vec<u8> {
    let text = format!("{{'descr': '{descr}', 'fortran_order': False, 'shape': {shape}, }}\n");
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    bytes.extend((text.len() as u16).to_le_bytes());
    bytes.extend(text.bytes());
    bytes.extend(data);
    bytes
}

#[test]
fn shapes_of_arrays_are_checked_before_anything_is_made() {
    let read = |shape| points_of("a.npy", &npy("<f8", shape, &[]));
    for (shape, expected) in [
        ("(0, 1000000000000000000)", "1000000000000000000 columns"),
        ("(0, 5000000)", "5000000 columns, at most 4096"),
        ("(9223372036854775808, 4611686018427387904)", "at most 4096"),
        ("(9223372036854775808, 2)", "says 9223372036854775808 rows"),
        ("(4611686018427387904, 4096)", "file has 0"),
        ("(1, 0)", "holds no points"),
    ] {
        assert_error(read(shape), expected);
    }
    assert_eq!(read("(0, 2)").expect("no points").points, []);
}

#[test]
fn integers_beyond_the_precision_of_doubles_are_refused() {
    let rows = [[1, 2], [3, (1i64 << 53) + 1]];
    let bytes: Vec<u8> = rows
        .iter()
        .flatten()
        .flat_map(|v| v.to_le_bytes())
        .collect();
    for kind in ["<i8", "<u8"] {
        let outcome = points_of("a.npy", &npy(kind, "(2, 2)", &bytes));
        assert_error(outcome, "row 1: 9007199254740993 cannot be held exactly");
    }
    let points = points_of("a.npy", &npy("<i8", "(1, 2)", &bytes[..16]));
    assert_eq!(points.expect("small").points[0], (1.0, 2.0).into());
    let vtu = with_data("Int64", "1 2 9007199254740993 4");
    assert_error(vtu, "array \"a\": row 2: 9007199254740993 cannot be held");
}

/// Two triangles in VTK's format.
const VTU: &str = include_str!("data/two-triangles.vtu");

/// Reads two triangles with one array of point data.
fn with_data(kind: &str, values: &str) -> Result<PointSet, Error> {
    let data = format!(
        "</Points><PointData><DataArray type=\"{kind}\" Name=\"a\" format=\"ascii\">{values}</DataArray></PointData>"
    );
    points_of("a.vtu", VTU.replace("</Points>", &data).as_bytes())
}

/// What is changed in two triangles of VTK, into what, and what the error must say.
const DAMAGED_VTU: &[(&str, &str, &str)] = &[
    ("ascii", "appended", "offset is not a number: \"\""),
    (
        "ascii",
        "appended\" offset=\"0",
        "is appended, but there are no appended data",
    ),
    (
        "ascii",
        "other",
        "is in format other: only ascii, binary and appended",
    ),
    (
        "ascii\">3 6",
        "appended\"/>",
        "offset is not a number: \"\"",
    ),
    (
        "Points=\"4\"",
        "Points=\"5\"",
        "declares 5 points, its arrays hold 4",
    ),
    (
        "Cells=\"2\"",
        "Cells=\"1\"",
        "declares 1 cells, its arrays hold 2",
    ),
    (
        "Cells=\"2\"",
        "Cells=\"two\"",
        "NumberOfCells is not a number",
    ),
    (
        "</VTKFile>",
        "",
        "truncated: the file ends before </VTKFile>",
    ),
    (
        "0 1 2 0 2 3",
        "0 1 2 0 2 4",
        "names vertex 4 of 4 (numbered from 0)",
    ),
    (
        "0 1 2 0 2 3",
        "0 1&#32;2 0 2 3",
        "a reference among numbers",
    ),
    ("Float64", "Float16", "type \"Float16\" is not understood"),
];

#[test]
fn damaged_vtu_says_what_is_wrong() {
    for (from, to, expected) in DAMAGED_VTU {
        assert!(VTU.contains(from), "{from}");
        let damaged = VTU.replacen(from, to, 1);
        assert_error(points_of("a.vtu", damaged.as_bytes()), expected);
    }
    let markers =
        "<PointData><DataArray type=\"Int32\" Name=\"marker\">1 2 3</DataArray></PointData>";
    let few = VTU.replace("</Points>", &format!("</Points>{markers}"));
    let expected = "array \"marker\" has 3 values, expected 4";
    assert_error(points_of("a.vtu", few.as_bytes()), expected);
    let end = VTU.find("</VTKFile>").expect("closed") + "</VTKFile>".len();
    for length in 0..end {
        let outcome = points_of("a.vtu", &VTU.as_bytes()[..length]);
        assert!(outcome.is_err(), "{length} bytes are taken for a grid");
    }
}

#[test]
fn deep_nesting_is_refused() {
    let arrays = format!(
        "{{\"type\": \"Polygon\", \"coordinates\": {}",
        "[".repeat(200_000)
    );
    assert_error(points_of("a.geojson", arrays.as_bytes()), "recursion limit");
    // What is skipped may be as deep as it likes, but not for ever.
    let ignored = format!("{{\"name\": {}", "[".repeat(200_000));
    assert_error(points_of("a.geojson", ignored.as_bytes()), "EOF");
    let collection = "{\"type\": \"GeometryCollection\", \"geometries\": [";
    let collections = collection.repeat(50_000);
    assert_error(
        points_of("a.geojson", collections.as_bytes()),
        "recursion limit",
    );
    let collections = "GEOMETRYCOLLECTION (".repeat(50_000);
    assert_error(
        points_of("a.wkt", collections.as_bytes()),
        "collections within collections, deeper than 100",
    );
}

#[test]
fn noise_is_not_an_empty_table() {
    let noise: Vec<u8> = (0..200u32).map(|i| (i * i * 37 % 251) as u8).collect();
    let without_zeros: Vec<u8> = noise.iter().map(|b| b | 128).collect();
    for noise in [noise, without_zeros] {
        points_of("noise.csv", &noise).expect_err("noise");
        points_of("noise.xyz", &noise).expect_err("noise");
    }
}

/// A small valid file of each format that is read.
fn valid_files() -> Vec<Vec<u8>> {
    let floats: Vec<u8> = (0..6).flat_map(|i| f64::from(i).to_le_bytes()).collect();
    vec![
        b"# c\n3 2 1 1\n1 0 0 .5 1\n2 1 0 .5 0\n3 0 1 .5 1\n".to_vec(),
        b"3 2 0 0\n0 0 0\n1 1 0\n2 0 1\n2 1\n0 0 1 5\n1 1 2 6\n0\n".to_vec(),
        b"x,y,name,z\n1,2,\"a \"\"b\"\", c\",3\n4,5,d,\n".to_vec(),
        b"1 2\t3 # c\r\n4 5 6\r\n".to_vec(),
        npy("<f8", "(3, 2)", &floats),
        npy(">i2", "(4, 3)", &floats[..24]),
        include_bytes!("data/two-triangles.vtu").to_vec(),
        b"3 2 0 0\n0 0 0\n1 1 0\n2 0 1\n1 1\n0 0 1 5\n1\n0 .1 .1\n2\n0 .2 .2 3 4\n1 .3 .3 4\n".to_vec(),
        b"{\"type\":\"FeatureCollection\",\"features\":[{\"type\":\"Feature\",\"properties\":{\"marker\":3},\
          \"geometry\":{\"type\":\"Polygon\",\"coordinates\":[[[0,0],[1,0],[0,1,7],[0,0]]]}}]}"
            .to_vec(),
        b"SRID=4;POLYGON Z((0 0 1,1 0 1,0 1 1,0 0 1));MULTIPOINT(1 2,(3 4)) LINESTRING M EMPTY".to_vec(),
    ]
}

#[test]
fn truncated_files_never_panic() {
    for file in valid_files() {
        for end in 0..file.len() {
            read_as_everything(&file[..end]);
        }
    }
}

/// Pieces of GeoJSON and well-known text.
const WORDS: &[&str] = &[
    "{\"type\":\"Polygon\",\"coordinates\":",
    "{\"type\":\"Feature\",\"geometry\":",
    "{\"type\":\"FeatureCollection\",\"features\":[",
    "\"properties\":{\"marker\":1}",
    "[[0,0],[1,0],[1,1],[0,0]]",
    "null",
    "[",
    "]",
    "{",
    "}",
    ",",
    "POLYGON",
    "MULTIPOINT",
    "LINESTRING ",
    "GEOMETRYCOLLECTION",
    "EMPTY",
    " Z",
    "(",
    ")",
    ";",
    "SRID=1;",
    "0 0,1 0,1 1,0 0",
    " 7 ",
];

proptest! {
    #[test]
    fn noise_never_panics(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        read_as_everything(&bytes);
    }

    #[test]
    fn noisy_numbers_never_panic(text in "([0-9#\\-.,;e\"x \t]|\n|nan|inf| 2 | 0 |\n0 |\n1 ){0,60}") {
        read_as_everything(text.as_bytes());
    }

    #[test]
    fn noisy_words_never_panic(
        words in prop::collection::vec(prop::sample::select(WORDS), 0..40),
    ) {
        read_as_everything(words.concat().as_bytes());
    }

    #[test]
    fn damaged_files_never_panic(
        which in 0..10usize,
        damage in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..6),
    ) {
        let mut file = valid_files().swap_remove(which);
        for (place, byte) in damage {
            let place = place.index(file.len());
            file[place] = byte;
        }
        read_as_everything(&file);
    }
}
