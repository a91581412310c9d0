//! `.obj`, `.off` and `.ply`: what is read, what is refused and how that is said, what comes back.

use delone::{Point, VertexId};
use delone_io::{
    Attribute, Constraints, DomainData, Error, Format, MeshData, MeshView, PointSet, ReadOptions,
    Source, Target, WriteOptions, in_memory, read_domain, read_mesh, read_points, write_domain,
    write_mesh, write_points,
};
use proptest::prelude::*;

fn source(name: &str, bytes: impl AsRef<[u8]>) -> Source {
    Source::Memory {
        name: name.to_owned(),
        bytes: bytes.as_ref().to_vec(),
    }
}

fn mesh(name: &str, bytes: impl AsRef<[u8]>) -> MeshData {
    read_mesh(&source(name, bytes), &ReadOptions::default(), &()).expect("well-formed")
}

#[track_caller]
fn refused(name: &str, bytes: impl AsRef<[u8]>) -> String {
    let read = read_mesh(&source(name, bytes), &ReadOptions::default(), &());
    read.expect_err("malformed").to_string()
}

fn ids<const N: usize>(rows: &[[usize; N]]) -> Vec<[VertexId; N]> {
    rows.iter().map(|row| row.map(VertexId::new)).collect()
}

fn values<'a>(attributes: &'a [Attribute], name: &str) -> &'a [f64] {
    let found = attributes.iter().find(|a| a.name == name);
    &found
        .unwrap_or_else(|| panic!("no {name} in {attributes:?}"))
        .values
}

/// What is written to one file in memory.
fn written(
    name: &str,
    write: impl Fn(&[Target]) -> Result<Vec<std::path::PathBuf>, Error>,
) -> Vec<u8> {
    let written = in_memory(|| write(&[Target::from_arg(name, None)]));
    let (_, files) = written.expect("written");
    assert_eq!(files.len(), 1);
    files[0].bytes.clone()
}

const ROOF: &str = "\
# two roofs on a wall\r
mtllib roof.mtl\r
v 0 0 3\r
v 1 0 3 1.0\r
v 1 1 4 0.5 0.25 1\r
v 0 1 4\r
vt 0 0\r
vn 0 0 1\r
g left\r
usemtl tiles\r
s off\r
f 1/1 2/1/1 \\\r
  3//1\r
g right\r
f -4 -2 -1 # back from the last\r
g ridge\r
l 1 2 3\r
g gutter\r
l -1 -4\r
";

#[test]
fn an_obj_brings_triangles_lines_colours_and_groups() {
    let roof = mesh("roof.obj", ROOF);
    let points = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(Point::from);
    assert_eq!(roof.vertices.points, points);
    assert_eq!(roof.triangles, ids(&[[0, 1, 2], [0, 2, 3]]));
    assert_eq!(values(&roof.vertices.attributes, "z"), [3.0, 3.0, 4.0, 4.0]);
    assert_eq!(values(&roof.vertices.attributes, "green")[2], 0.25);
    assert!(values(&roof.vertices.attributes, "red")[0].is_nan());
    assert_eq!(values(&roof.triangle_attributes, "region"), [1.0, 2.0]);
    let lines = roof.constraints.expect("lines");
    assert_eq!(lines.edges, ids(&[[0, 1], [1, 2], [3, 0]]));
    assert_eq!(lines.markers, Some(vec![1, 1, 2]));
    assert_eq!(roof.vertices.lines.of(0), Some(3));
    assert_eq!(Format::sniff(ROOF.as_bytes()), Some(Format::Obj));
}

#[test]
fn a_single_polygon_of_an_obj_is_an_outline() {
    let text = "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 2 2 0\nf 1 2 3 4\np 5\n";
    let domain = read_domain(&source("a.obj", text), &ReadOptions::default(), &()).expect("read");
    assert_eq!(domain.segments, ids(&[[0, 1], [1, 2], [2, 3], [3, 0]]));
    assert!(domain.vertices.attributes.is_empty());
    assert_eq!(domain.segment_markers, None);
    // Vertices may come behind what names them.
    let late = mesh("a.obj", "f 1 2 3\nv 0 0 0\nv 4 0 0\nv 4 4 0\n");
    assert_eq!(late.triangles, ids(&[[0, 1, 2]]));
}

#[test]
fn an_off_has_columns_as_its_header_says() {
    let text = "STCNOFF 3 1 0\n0 0 0  0 0 1  255 128 0 9  .5 .25\n1 0 0  0 0 1  1 2 3 4  0 0\n# half\n1 1 0  0 0 1  5 6 7 8  0 1\n3 0 1 2  0.1 0.2 0.3\n";
    let read = mesh("a.off", text);
    let names: Vec<_> = read
        .vertices
        .attributes
        .iter()
        .map(|a| a.name.as_str())
        .collect();
    assert_eq!(
        names,
        ["nx", "ny", "nz", "red", "green", "blue", "alpha", "s", "t"]
    );
    assert_eq!(values(&read.vertices.attributes, "blue"), [0.0, 3.0, 7.0]);
    assert_eq!(values(&read.vertices.attributes, "t"), [0.25, 0.0, 1.0]);
    assert_eq!(read.triangles, ids(&[[0, 1, 2]]));
    let plain = mesh(
        "a.off",
        "OFF # no colours\n3 1\n0 0 7 1\n1 0 8 2\n1 1 9 3\n3 2 0 1\n",
    );
    assert_eq!(values(&plain.vertices.attributes, "z"), [7.0, 8.0, 9.0]);
    assert_eq!(
        values(&plain.vertices.attributes, "column4"),
        [1.0, 2.0, 3.0]
    );
    assert_eq!(
        mesh("a.off", "3 0 0\n0 0 0\n1 0 0\n0 1 0\n")
            .vertices
            .points
            .len(),
        3
    );
    let textured = mesh("a.off", "STCOFF\n1 0 0\n0 0 7  1 2 3  .5 .25\n").vertices;
    let names = textured
        .attributes
        .iter()
        .map(|a| (&a.name[..], a.values[0]));
    let expected = [
        ("z", 7.0),
        ("red", 1.0),
        ("green", 2.0),
        ("blue", 3.0),
        ("s", 0.5),
        ("t", 0.25),
    ];
    assert!(names.eq(expected), "{:?}", textured.attributes);
    assert_eq!(
        Format::sniff(b"# made by hand\nCOFF\n0 0 0\n"),
        Some(Format::Off)
    );
    assert_eq!(Format::sniff(b"nOFF 2\n"), None);
}

const PLY_HEAD: &str = "ply\r\nformat ascii 1.0\r\ncomment made by hand\r\nelement edge 1\r\nproperty ushort vertex1\r\nproperty float length\r\nproperty ushort vertex2\r\nproperty short marker\r\nelement camera 2\r\nproperty list uchar float view\r\nelement face 1\r\nproperty uchar red\r\nproperty list int uint vertex_index\r\nproperty list uchar float texcoord\r\nelement vertex 3\r\nproperty double y\r\nproperty float z\r\nproperty uchar red\r\nproperty double x\r\nproperty int marker\r\nelement nothing 99999999999\r\nend_header\r\n";

#[test]
fn a_ply_may_order_everything_otherwise() {
    let rows = "2 .5 0 -7\r\n3 1 2 3\r\n0\r\n200 3 0 1 2 2 0.5 0.5\r\n0 1 10 0 4\r\n0 2 20 1 5\r\n1 3 30 1 6\r\n";
    let read = mesh("a.ply", format!("{PLY_HEAD}{rows}"));
    let points = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0)].map(Point::from);
    assert_eq!(read.vertices.points, points);
    assert_eq!(read.vertices.markers, Some(vec![4, 5, 6]));
    assert_eq!(values(&read.vertices.attributes, "red"), [10.0, 20.0, 30.0]);
    assert_eq!(read.vertices.attributes[0].name, "z");
    assert_eq!(values(&read.triangle_attributes, "red"), [200.0]);
    let edges = read.constraints.expect("edges");
    assert_eq!(
        (edges.edges, edges.markers),
        (ids(&[[2, 0]]), Some(vec![-7]))
    );
}

#[test]
fn elements_without_rows_need_no_properties() {
    let text = "ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\nproperty int y\nelement face 0\n\
                element edge 0\nelement tristrips 0\nend_header\n1 2\n";
    let read = mesh("a.ply", text);
    assert_eq!(read.vertices.points, [Point::new(1.0, 2.0)]);
    assert_eq!((read.triangles.len(), read.constraints), (0, None));
}

/// The same in bytes of either order.
#[test]
fn a_ply_is_read_from_bytes_of_either_order() {
    for big in [false, true] {
        let order = if big { "big" } else { "little" };
        let mut file = PLY_HEAD
            .replace("ascii", &format!("binary_{order}_endian"))
            .into_bytes();
        let mut put = |bytes: &[u8]| match big {
            true => file.extend(bytes.iter().rev()),
            false => file.extend(bytes),
        };
        put(&2u16.to_le_bytes());
        put(&0.5f32.to_le_bytes());
        put(&0u16.to_le_bytes());
        put(&(-7i16).to_le_bytes());
        for view in [&[1f32, 2.0, 3.0][..], &[]] {
            put(&[view.len() as u8]);
            view.iter().for_each(|v| put(&v.to_le_bytes()));
        }
        put(&[200]);
        put(&3i32.to_le_bytes());
        [0u32, 1, 2].iter().for_each(|v| put(&v.to_le_bytes()));
        put(&[0]);
        for (y, z, red, x, marker) in [
            (0f64, 1f32, 10u8, 0f64, 4i32),
            (0.0, 2.0, 20, 1.0, 5),
            (1.0, 3.0, 30, 0.1, 6),
        ] {
            put(&y.to_le_bytes());
            put(&z.to_le_bytes());
            put(&[red]);
            put(&x.to_le_bytes());
            put(&marker.to_le_bytes());
        }
        let read = mesh("a.ply", &file);
        assert_eq!(read.vertices.points[2], Point::new(0.1, 1.0));
        assert_eq!(read.vertices.markers, Some(vec![4, 5, 6]));
        assert_eq!(read.triangles, ids(&[[0, 1, 2]]));
        let edges = read.constraints.expect("edges");
        assert_eq!(
            (edges.edges, edges.markers),
            (ids(&[[2, 0]]), Some(vec![-7]))
        );
        file.pop();
        let message = refused("a.ply", &file);
        assert!(
            message.contains("truncated: header says 3 points, file has 2"),
            "{message}"
        );
    }
}

/// Name, content, what the error must say.
const MALFORMED: &[(&str, &str, &str)] = &[
    ("a.obj", "", "a.obj: the file is empty"),
    ("a.obj", "v 0 0\n", "a.obj:1: expected 3 columns, found 2"),
    ("a.obj", "v 0 x 0\n", "a.obj:1: y is not a number: \"x\""),
    (
        "a.obj",
        "v 0 inf 0\n",
        "a.obj:1: point 1: y is inf, coordinates must be finite",
    ),
    ("a.obj", "v 0 0 0\nf 1 1\n", "a.obj:2: face 1 has 2 corners"),
    (
        "a.obj",
        "v 0 0 0\nf 1 1 2\n",
        "a.obj:2: face 1 names vertex 2 of 1 (numbered from 1)",
    ),
    (
        "a.obj",
        "v 0 0 0\n\nf 1 1 0\n",
        "a.obj:3: face 1 names vertex 0 of 1",
    ),
    (
        "a.obj",
        "v 0 0 0\nl 1 -2\n",
        "a.obj:2: line 1 names vertex -2 of 1",
    ),
    ("a.obj", "v 0 0 0\nl 1\n", "a.obj:2: line 1 has 1 points"),
    (
        "a.obj",
        "v 0 0 0\nf 1/x a 1\n",
        "a.obj:2: vertex of face 1 is not a number: \"a\"",
    ),
    (
        "a.obj",
        "v 0 0 0\nf 1 1 99999999999999\n",
        "face 1 names vertex 99999999999999 of 1",
    ),
    (
        "a.obj",
        "v 0 0 0\nf 1 1 1 1\nf 1 1 1\n",
        "a.obj:2: face 1 has 4 corners: beside other faces only triangles",
    ),
    (
        "a.obj",
        "v 0 0 0\nf 1 1 1\nf 1 1 1 1 1\n",
        "a.obj:3: face 2 has 5 corners",
    ),
    (
        "a.obj",
        "v 0 0 0\ncurv 0 1 1 1\n",
        "a.obj:2: curv: curves and surfaces of free form are not understood",
    ),
    (
        "a.obj",
        "v 0 0 0\nhello\n",
        "a.obj:2: unknown statement \"hello\"",
    ),
    ("a.off", "", "a.off: the file is empty"),
    ("a.off", "OFF\n", "a.off: the file is empty"),
    (
        "a.off",
        "OFF BINARY\n",
        "a.off:1: binary .off is not understood",
    ),
    (
        "a.off",
        "4OFF\n1 0 0\n",
        "a.off:1: 4OFF: of the headers only OFF",
    ),
    (
        "a.off",
        "OOF\n1 0 0\n",
        "a.off:1: header must be OFF, not \"OOF\"",
    ),
    (
        "a.off",
        "OFF\n1 -1 0\n0 0 0\n",
        "a.off:2: count of faces is not a number: \"-1\"",
    ),
    (
        "a.off",
        "OFF\n2 0 0\n0 0 0\n",
        "a.off:3: truncated: header says 2 points, file has 1",
    ),
    (
        "a.off",
        "OFF\n4000000000 1 0\n0 0 0\n",
        "a.off:3: truncated: header says 4000000000 points, file has 1",
    ),
    (
        "a.off",
        "OFF\n99999999999 1 0\n0 0 0\n",
        "a.off:2: 99999999999 points, at most",
    ),
    (
        "a.off",
        "OFF\n2 0 0\n0 0 0\n1 0\n",
        "a.off:4: expected 3 columns, found 2",
    ),
    (
        "a.off",
        "OFF\n1 0 0\n0 nan 0\n",
        "a.off:3: point 0: y is nan",
    ),
    (
        "a.off",
        "OFF\n1 1 0\n0 0 0\n4 0 0 0 0\n",
        "a.off:4: face 0 has 4 corners: only triangles",
    ),
    (
        "a.off",
        "OFF\n1 1 0\n0 0 0\n3 0 0\n",
        "a.off:4: expected 4 columns, found 3",
    ),
    (
        "a.off",
        "OFF\n1 1 0\n0 0 0\n3 0 0 1\n",
        "a.off:4: face 0 names vertex 1 of 1 (numbered from 0)",
    ),
    (
        "a.off",
        "OFF\n1 0 0\n0 0 0\n3 0 0 0\n",
        "a.off:4: header says 0 faces, but more rows follow",
    ),
    ("a.ply", "", "a.ply: the file is empty"),
    ("a.ply", "plx\n", "a.ply:1: the first line must be `ply`"),
    (
        "a.ply",
        "ply\nformat ascii 2.0\n",
        "a.ply:2: the version must be 1.0",
    ),
    (
        "a.ply",
        "ply\nformat morse 1.0\n",
        "a.ply:2: format \"morse\" is none of",
    ),
    (
        "a.ply",
        "ply\nformat ascii 1.0\n",
        "truncated: the file ends before end_header",
    ),
    (
        "a.ply",
        "ply\nend_header\n",
        "a.ply:2: the header names no format",
    ),
    (
        "a.ply",
        "ply\nformat ascii 1.0\nend_header\n",
        "a.ply: the header declares no element vertex",
    ),
    (
        "a.ply",
        "ply\nproperty int x\n",
        "a.ply:2: a property stands before every element",
    ),
    (
        "a.ply",
        "ply\nelement vertex many\n",
        "a.ply:2: count of an element is not a number: \"many\"",
    ),
    (
        "a.ply",
        "ply\nelement vertex 1\nelement vertex 1\n",
        "a.ply:3: one element \"vertex\" too many",
    ),
    (
        "a.ply",
        "ply\nelement vertex 1\nproperty half x\n",
        "a.ply:3: type \"half\" is none of",
    ),
    (
        "a.ply",
        "ply\nelement vertex 1\nproperty int x\nproperty int x\n",
        "a.ply:4: property \"x\" of element \"vertex\" needs a name of its own",
    ),
    (
        "a.ply",
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\nproperty int y\nelement edge_marker 1\nproperty int marker\nend_header\n1 2\n3\n",
        "a.ply:6: 1 markers of edges for 0 edges",
    ),
    (
        "a.ply",
        "ply\nnonsense\n",
        "a.ply:2: \"nonsense\" in the header is neither",
    ),
    (
        "a.ply",
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\nend_header\n1\n",
        "a.ply:3: element vertex has no number y",
    ),
    (
        "a.ply",
        "ply\nformat ascii 1.0\nelement vertex 99999999999\nproperty int x\nproperty int y\nend_header\n",
        "a.ply:3: 99999999999 points, at most",
    ),
    (
        "a.ply",
        "ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty int x\nproperty int y\nend_header\n1 2\n",
        "a.ply:7: truncated: header says 4000000000 points, file has 1",
    ),
    (
        "a.ply",
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\nproperty int y\nend_header\n1\n",
        "a.ply:7: the row ends before property \"y\"",
    ),
    (
        "a.ply",
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\nproperty int y\nend_header\n1 2 3\n",
        "a.ply:7: \"3\" stands behind the last property",
    ),
    (
        "a.ply",
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\nproperty int y\nend_header\n1 inf\n",
        "a.ply:7: point 0: y is inf",
    ),
    (
        "a.ply",
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\nproperty int y\nend_header\n1 2\n3 4\n",
        "a.ply:8: more follows than the header declares",
    ),
    (
        "a.ply",
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\nproperty int y\nelement face 1\nproperty list char int vertex_indices\nend_header\n1 2\n4 0 0 0 0\n",
        "a.ply:10: face 0 has 4 corners: only triangles",
    ),
    (
        "a.ply",
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\nproperty int y\nelement face 1\nproperty list char int vertex_indices\nend_header\n1 2\n3 0 0 1\n",
        "a.ply:10: face 0 names vertex 1 of 1",
    ),
    (
        "a.ply",
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\nproperty int y\nelement face 1\nproperty list char int vertex_indices\nend_header\n1 2\n-3 0 0 1\n",
        "a.ply:10: -3 is not the length of a list",
    ),
    (
        "a.ply",
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\nproperty int y\nelement face 1\nproperty int vertex_indices\nend_header\n1 2\n3\n",
        "a.ply:6: element face has no list vertex_indices",
    ),
    (
        "a.ply",
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\nproperty int y\nelement tristrips 1\nproperty list int int vertex_indices\nend_header\n1 2\n3 0 0 0\n",
        "a.ply:6: triangle strips are not understood",
    ),
    (
        "a.ply",
        "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty char x\nproperty char y\nend_header\n\x01\x02\x03",
        "a.ply at byte 107: truncated: header says 4000000000 points, file has 1",
    ),
    (
        "a.ply",
        "ply\nformat binary_big_endian 1.0\nelement vertex 1\nproperty char x\nproperty char y\nend_header\n\x01\x02\x03",
        "a.ply at byte 95: more follows than the header declares",
    ),
];

#[test]
fn what_is_malformed_is_said_with_its_place() {
    for (name, text, expected) in MALFORMED {
        let message = refused(name, text);
        assert!(message.contains(expected), "{message:?} lacks {expected:?}");
    }
}

/// Bytes that may be any of the formats, or nearly.
fn noise() -> impl Strategy<Value = Vec<u8>> {
    let word = prop::sample::select(vec![
        "v",
        "f",
        "l",
        "p",
        "g",
        "usemtl",
        "OFF",
        "ply",
        "format",
        "ascii",
        "binary_little_endian",
        "1.0",
        "element",
        "vertex",
        "face",
        "edge",
        "property",
        "list",
        "int",
        "uchar",
        "double",
        "x",
        "y",
        "vertex_indices",
        "vertex1",
        "end_header",
        "0",
        "1",
        "-1",
        "3",
        "2.5",
        "nan",
        "1e999",
        "99999999999",
        "1/2/3",
        "\\",
        "#",
        "\r\n",
        "\n",
        "\n",
        "\n",
        "\t",
        "\0",
        "\u{ff}",
    ]);
    prop::collection::vec(word, 0..80)
        .prop_map(|words| words.join(" ").replace(" \n ", "\n").into_bytes())
}

fn survives(bytes: &[u8]) {
    for name in ["a.obj", "a.off", "a.ply"] {
        let source = source(name, bytes);
        let options = ReadOptions::default();
        if let Ok(mesh) = read_mesh(&source, &options, &()) {
            let n = mesh.vertices.points.len();
            assert!(mesh.triangles.as_flattened().iter().all(|v| v.index() < n));
            let edges = mesh.constraints.unwrap_or_default().edges;
            assert!(edges.as_flattened().iter().all(|v| v.index() < n));
            let columns = &mesh.vertices.attributes;
            assert!(columns.iter().all(|a| a.values.len() == n));
        }
        drop(read_points(&source, &options, &()));
        drop(read_domain(&source, &options, &()));
    }
}

prop_compose! {
    /// A mesh with all that a `.ply` can hold.
    fn any_mesh()(rows in prop::collection::vec((any::<f64>(), any::<f64>(), any::<f64>(), any::<i32>()), 3..30),
                  seeds in prop::collection::vec((any::<[prop::sample::Index; 3]>(), any::<f64>(), -1i32..4), 1..30),
                  lines in prop::collection::vec((any::<[prop::sample::Index; 2]>(), any::<i32>()), 1..30)) -> MeshData {
        let finite = |v: f64| if v.is_finite() { v } else { 0.0 };
        let vertices = PointSet {
            points: rows.iter().map(|r| Point::new(finite(r.0), finite(r.1))).collect(),
            attributes: ["z", "heat"].map(|name| Attribute {
                name: name.to_owned(),
                values: rows.iter().map(|r| finite(r.2) + 1e-300).collect(),
            }).to_vec(),
            markers: Some(rows.iter().map(|r| r.3).collect()),
            ..PointSet::default()
        };
        let n = rows.len();
        let heat = seeds.iter().map(|s| finite(s.1)).collect();
        let region = seeds.iter().map(|s| f64::from(s.2)).collect();
        MeshData {
            vertices,
            triangles: seeds.iter().map(|s| s.0.map(|i| VertexId::new(i.index(n)))).collect(),
            triangle_attributes: [("heat", heat), ("region", region)]
                .map(|(name, values)| Attribute { name: name.to_owned(), values }).to_vec(),
            constraints: Some(Constraints {
                edges: lines.iter().map(|l| l.0.map(|i| VertexId::new(i.index(n)))).collect(),
                // 0 means 1 on a border.
                markers: Some(lines.iter().map(|l| l.1.max(1)).collect()),
                ..Constraints::default()
            }),
            quadratic: false,
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(256))]

    #[test]
    fn noise_and_cut_files_neither_panic_nor_lie(bytes in noise(), cut in any::<prop::sample::Index>()) {
        survives(&bytes);
        let head = PLY_HEAD.replace("\r\n", "\n").into_bytes();
        let glued: Vec<u8> = head.into_iter().chain(bytes).collect();
        survives(&glued);
        survives(&glued[..cut.index(glued.len())]);
        survives(&ROOF.as_bytes()[..cut.index(ROOF.len())]);
    }

    #[test]
    fn bytes_of_a_ply_that_are_damaged_do_no_harm(mesh in any_mesh(), place in any::<prop::sample::Index>(), byte: u8) {
        let view = MeshView::from(&mesh);
        let mut file = written("a.ply", |to| write_mesh(to, &view, &WriteOptions::default(), &()));
        let place = place.index(file.len());
        file[place] = byte;
        survives(&file);
        survives(&file[..place]);
    }

    #[test]
    fn meshes_survive_ply_obj_and_off(mesh in any_mesh(), ascii: bool) {
        let view = MeshView::from(&mesh);
        let options = WriteOptions { ascii, ..WriteOptions::default() };
        let write = |name: &str| written(name, |to| write_mesh(to, &view, &options, &()));
        prop_assert_eq!(&self::mesh("a.ply", write("a.ply")), &mesh);

        let obj = self::mesh("a.obj", write("a.obj"));
        prop_assert_eq!(&obj.vertices.points, &mesh.vertices.points);
        prop_assert_eq!(&obj.vertices.attributes, &mesh.vertices.attributes[..1]);
        prop_assert_eq!(&obj.triangles, &mesh.triangles);
        prop_assert_eq!(&obj.constraints, &mesh.constraints);
        let regions = &mesh.triangle_attributes[1].values;
        if regions.iter().any(|&r| r >= 0.0) {
            prop_assert_eq!(&obj.triangle_attributes[0].values, regions);
        }

        let off = self::mesh("a.off", write("a.off"));
        prop_assert_eq!(&off.vertices.points, &mesh.vertices.points);
        prop_assert_eq!(&off.vertices.attributes, &mesh.vertices.attributes[..1]);
        prop_assert_eq!(&off.triangles, &mesh.triangles);
    }
}

#[test]
fn domains_and_points_survive() {
    let set = PointSet {
        points: vec![
            Point::new(0.1, -0.0),
            Point::new(1e300, 5e-324),
            Point::new(3.0, 4.0),
        ],
        ..PointSet::default()
    };
    let domain = DomainData {
        segments: ids(&[[0, 1], [2, 1]]),
        ..DomainData::from(set.clone())
    };
    let options = WriteOptions::default();
    for name in ["a.obj", "a.ply"] {
        let bytes = written(name, |to| write_domain(to, &domain, &options, &()));
        let copy = read_domain(&source(name, bytes), &ReadOptions::default(), &()).expect("ours");
        assert_eq!(copy.vertices.points, set.points);
        assert_eq!(copy.segments, domain.segments);
    }
    for name in ["a.obj", "a.ply", "a.off"] {
        let bytes = written(name, |to| write_points(to, &set, &options, &()));
        let copy = read_points(&source(name, &bytes), &ReadOptions::default(), &()).expect("ours");
        assert_eq!(
            (copy.points, copy.attributes),
            (set.points.clone(), vec![]),
            "{name}"
        );
        assert_eq!(
            Format::sniff(&bytes).map(Format::name),
            name.strip_prefix("a.")
        );
    }
}

#[test]
fn names_of_attributes_become_words_apart() {
    let one = |name: &str| Attribute {
        name: name.to_owned(),
        values: vec![1.0],
    };
    let set = PointSet {
        points: vec![Point::new(1.0, 2.0)],
        attributes: ["x", "marker", "dew point", "dew_point", ""]
            .map(one)
            .to_vec(),
        markers: Some(vec![3]),
        ..PointSet::default()
    };
    let bytes = written("a.ply", |to| {
        write_points(to, &set, &WriteOptions::default(), &())
    });
    let copy = read_points(&source("a.ply", bytes), &ReadOptions::default(), &()).expect("ours");
    let names: Vec<_> = copy.attributes.iter().map(|a| a.name.as_str()).collect();
    assert_eq!(names, ["x_", "marker_", "dew_point", "dew_point_", "_"]);
    assert_eq!(copy.markers, set.markers);
}

#[test]
fn files_of_other_programs_are_read() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/surf");
    let mut seen = 0;
    for entry in std::fs::read_dir(folder).expect("the folder is there") {
        let path = entry.expect("an entry").path();
        let name = path.display().to_string();
        if name.ends_with(".md") {
            continue;
        }
        let read = read_mesh(&Source::from_arg(&path), &ReadOptions::default(), &()).expect(&name);
        let points = [(0.5, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(Point::from);
        assert_eq!(read.vertices.points, points, "{name}");
        assert_eq!(read.triangles, ids(&[[0, 1, 2], [0, 2, 3]]), "{name}");
        let columns = &read.vertices.attributes;
        assert_eq!(values(columns, "z"), [0.0, 0.5, 0.25, 0.0], "{name}");
        if name.contains("trimesh") && !name.ends_with("off") {
            assert!(values(columns, "blue")[2] >= 1.0, "{name}");
        }
        if name.contains("meshio-") {
            assert_eq!(values(columns, "heat"), [1.5, 2.5, 3.5, 4.5], "{name}");
        }
        if name.contains("pyvista-") {
            assert_eq!(columns.len(), 4, "{name} has normals");
        }
        seen += 1;
    }
    assert_eq!(seen, 11);
}
