//! Triangles of six nodes, files written one by one, and bounds on areas.

use delone::{ConstrainedDelaunay, DomainRule, Point, VertexId, triangulate};
use delone_io::{
    Attribute, DomainData, Inherited, MeshData, MeshView, PointSet, ReadOptions, Source, Target,
    WriteOptions, read_areas, read_mesh, write_mesh,
};
use std::path::Path;

/// A square with its diagonal from corner 0 as a segment of marker 5, the lower side of marker 7,
/// and a loose segment outside.
fn square() -> DomainData {
    let points = [
        [0.0, 0.0],
        [4.0, 0.0],
        [4.0, 4.0],
        [0.0, 4.0],
        [9.0, 0.0],
        [9.0, 9.0],
    ];
    let segments = [[0, 1], [1, 2], [2, 3], [3, 0], [0, 2], [4, 5]];
    DomainData {
        vertices: PointSet {
            points: points.map(Point::from).to_vec(),
            attributes: vec![Attribute {
                name: "attribute1".to_owned(),
                values: vec![1.0, 2.0, 4.0, 8.0, 16.0, 32.0],
            }],
            markers: Some(vec![1, 2, 3, 4, 5, 6]),
            ..PointSet::default()
        },
        segments: segments.map(|s| s.map(VertexId::from)).to_vec(),
        segment_markers: Some(vec![7, 0, 0, 0, 5, 9]),
        usual_rule: DomainRule::Carve,
        ..DomainData::default()
    }
}

fn written(names: &[&str], options: &WriteOptions) -> tempfile::TempDir {
    let mut domain = square();
    let builder = ConstrainedDelaunay::new().domain(DomainRule::Carve);
    let result = builder.triangulate(domain.take_pslg()).expect("a domain");
    let inherited = Inherited::new(&result, domain, &()).expect("its own domain");
    let mesh = MeshView::constrained(&result, &inherited).quadratic();
    let folder = tempfile::tempdir().expect("folder");
    let target = |name: &&str| Target::from_arg(folder.path().join(name), None);
    let targets: Vec<_> = names.iter().map(target).collect();
    write_mesh(&targets, &mesh, options, &()).expect("written");
    folder
}

fn one_based() -> WriteOptions {
    WriteOptions {
        one_based: true,
        ..WriteOptions::default()
    }
}

fn mesh_at(path: &Path) -> MeshData {
    read_mesh(&Source::from_arg(path), &ReadOptions::default(), &()).expect("a mesh")
}

fn lines(folder: &tempfile::TempDir, name: &str) -> Vec<String> {
    let text = std::fs::read_to_string(folder.path().join(name)).expect(name);
    text.lines().map(str::to_owned).collect()
}

/// Numbers of the rows behind the header, without the row's own.
fn rows(folder: &tempfile::TempDir, name: &str) -> Vec<Vec<f64>> {
    let lines = lines(folder, name);
    let row = |line: &String| {
        let words = line.split(' ').skip(1);
        words.map(|w| w.parse().expect("a number")).collect()
    };
    lines[1..].iter().map(row).collect()
}

#[test]
fn midpoints_lie_opposite_the_corners_and_have_the_markers_of_their_edges() {
    let folder = written(&["s.ele"], &one_based());
    assert_eq!(lines(&folder, "s.ele")[0], "2 6 0");
    assert_eq!(lines(&folder, "s.node")[0], "11 2 1 1");
    let nodes = rows(&folder, "s.node");
    let node = |number: f64| &nodes[number as usize - 1];
    let mut diagonals = Vec::new();
    for row in rows(&folder, "s.ele") {
        assert_eq!(row.len(), 6);
        for k in 0..3 {
            let [a, b] = [row[(k + 1) % 3], row[(k + 2) % 3]].map(node);
            let middle = node(row[3 + k]);
            for column in 0..3 {
                assert_eq!(
                    middle[column],
                    (a[column] + b[column]) / 2.0,
                    "attribute and place"
                );
            }
            let expected = match (middle[0], middle[1]) {
                (2.0, 0.0) => 7.0,
                (2.0, 2.0) => 5.0,
                _ => 1.0,
            };
            assert_eq!(middle[3], expected, "{middle:?}");
            if expected == 5.0 {
                diagonals.push(row[3 + k]);
            }
        }
    }
    assert_eq!(diagonals.len(), 2);
    assert_eq!(diagonals[0], diagonals[1], "neighbours share it");
    // Edges, neighbours and segments still speak of vertices alone.
    assert_eq!(lines(&folder, "s.edge")[0], "5 1");
    assert_eq!(lines(&folder, "s.neigh")[0], "2 3");
    assert_eq!(lines(&folder, "s.poly")[0..2], ["0 2 1 1", "6 1"]);
}

#[test]
fn what_is_written_with_midpoints_is_read_without() {
    let linear = square();
    let folder = written(&["s.ele", "s.vtu"], &WriteOptions::default());
    for name in ["s.ele", "s.vtu"] {
        let mesh = mesh_at(&folder.path().join(name));
        assert!(mesh.quadratic, "{name}");
        assert_eq!(mesh.vertices.points, linear.vertices.points, "{name}");
        assert_eq!(mesh.vertices.markers, linear.vertices.markers, "{name}");
        assert_eq!(mesh.vertices.attributes, linear.vertices.attributes);
        assert_eq!(mesh.triangles.len(), 2);
        let constraints = mesh.constraints.as_ref().expect("segments");
        assert_eq!(constraints.edges.len(), 6, "{name}");
        // And so they go from one format into the other.
        let again = folder.path().join("again.vtu");
        let targets = [Target::from_arg(&again, None)];
        let view = MeshView::from(&mesh);
        write_mesh(&targets, &view, &WriteOptions::default(), &()).expect("written");
        let [first, second] = ["s.vtu", "again.vtu"].map(|n| lines(&folder, n));
        let nodes = |lines: &[String]| lines.iter().find(|l| l.starts_with("<Piece")).cloned();
        assert_eq!(nodes(&first), nodes(&second), "{name}");
    }
}

/// An inline ASCII grid of one quadratic triangle and one quadratic line.
fn grid(points: &str, connectivity: &str) -> Vec<u8> {
    let array = |kind: &str, name: &str, n: usize, values: &str| {
        format!(
            "<DataArray type=\"{kind}\" Name=\"{name}\" NumberOfComponents=\"{n}\" format=\"ascii\">{values}</DataArray>"
        )
    };
    format!(
        "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\">\
         <UnstructuredGrid><Piece NumberOfPoints=\"6\" NumberOfCells=\"2\"><Points>{}</Points><Cells>{}{}{}</Cells>\
         </Piece></UnstructuredGrid></VTKFile>",
        array("Float64", "Points", 3, points),
        array("Int64", "connectivity", 1, connectivity),
        array("Int64", "offsets", 1, "6 9"),
        array("UInt8", "types", 1, "22 21"),
    )
    .into_bytes()
}

fn read_grid(points: &str, connectivity: &str) -> Result<MeshData, String> {
    let source = Source::Memory {
        name: "g.vtu".to_owned(),
        bytes: grid(points, connectivity),
    };
    read_mesh(&source, &ReadOptions::default(), &()).map_err(|error| error.to_string())
}

#[test]
fn midpoints_in_a_grid_must_come_last() {
    let points = "0 0 0 2 0 0 0 2 0 1 0 0 1 1 0 0 1 0";
    let mesh = read_grid(points, "0 1 2 3 4 5 0 1 3").expect("a mesh");
    assert_eq!((mesh.vertices.points.len(), mesh.triangles.len()), (3, 1));
    assert_eq!(mesh.constraints.map(|c| c.edges.len()), Some(1));
    let error = read_grid(points, "0 1 5 3 4 2 0 1 3").expect_err("2 before 5");
    assert!(
        error.contains("node 2 is a midpoint, but node 5 behind it"),
        "{error}"
    );
    let error = read_grid(points, "0 1 2 3 4 5 0 1 2").expect_err("a corner");
    assert!(
        error.contains("node 2 is a corner of one triangle"),
        "{error}"
    );
    let error = read_grid(points, "0 1 2 3 4 6 0 1 3").expect_err("no node");
    assert!(error.contains("names vertex 6 of 6"), "{error}");
}

#[test]
fn vtk_begins_with_the_midpoint_between_the_first_corners() {
    let t = triangulate([(0.0, 0.0), (2.0, 0.0), (0.0, 2.0)]).expect("points");
    let [a, b, c] = t.triangles()[0].map(|v| t.point(v));
    let folder = tempfile::tempdir().expect("folder");
    let path = folder.path().join("t.vtu");
    let targets = [Target::from_arg(&path, None)];
    let view = MeshView::from(&t).quadratic();
    write_mesh(&targets, &view, &WriteOptions::default(), &()).expect("written");
    let text = std::fs::read_to_string(&path).expect("written");
    let bytes = |name: &str| {
        let (_, rest) = text.split_once(&format!("Name=\"{name}\"")).expect(name);
        let (_, rest) = rest.split_once('\n').expect("a line");
        decode(rest.lines().next().expect("a line"))
    };
    let integers: Vec<usize> = numbers(&bytes("connectivity"))
        .map(|b| i64::from_le_bytes(b) as usize)
        .collect();
    let coordinates: Vec<f64> = numbers(&bytes("Points")).map(f64::from_le_bytes).collect();
    let node = |k: usize| {
        let at = 3 * integers[k];
        Point::new(coordinates[at], coordinates[at + 1])
    };
    let middle = |a: Point, b: Point| Point::new((a.x + b.x) / 2.0, (a.y + b.y) / 2.0);
    assert_eq!([0, 1, 2].map(node), [a, b, c]);
    assert_eq!(
        [3, 4, 5].map(node),
        [middle(a, b), middle(b, c), middle(c, a)]
    );
    assert_eq!(bytes("types")[8..], [22]);
}

/// The numbers of eight bytes behind their count.
fn numbers(bytes: &[u8]) -> impl Iterator<Item = [u8; 8]> {
    let (numbers, _) = bytes.as_chunks::<8>();
    numbers[1..].iter().copied()
}

/// Decodes base64.
fn decode(text: &str) -> Vec<u8> {
    const LETTERS: &[u8] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut bits = Vec::new();
    for letter in text.trim().trim_end_matches('=').bytes() {
        let value = LETTERS.iter().position(|&l| l == letter).expect("base64");
        bits.extend((0..6).rev().map(|i| value >> i & 1));
    }
    let byte = |bits: &[usize]| bits.iter().fold(0, |byte, bit| byte << 1 | bit) as u8;
    bits.chunks_exact(8).map(byte).collect()
}

#[test]
fn formats_without_six_nodes_say_so() {
    let t = triangulate([(0.0, 0.0), (2.0, 0.0), (0.0, 2.0)]).expect("points");
    let folder = tempfile::tempdir().expect("folder");
    for (name, format) in [("t.npy", "npy"), ("t.geojson", "geojson")] {
        let targets = [Target::from_arg(folder.path().join(name), None)];
        let view = MeshView::from(&t).quadratic();
        let error = write_mesh(&targets, &view, &WriteOptions::default(), &());
        let error = error.expect_err(name).to_string();
        let expected = format!(
            "format {format} cannot hold triangles of six nodes; use one of node, ele, edge"
        );
        assert!(error.contains(&expected), "{error}");
    }
    assert_eq!(std::fs::read_dir(folder.path()).expect("folder").count(), 0);
}

fn pair(node: &str, ele: &str) -> Result<MeshData, String> {
    let folder = tempfile::tempdir().expect("folder");
    std::fs::write(folder.path().join("t.node"), node).expect("written");
    let path = folder.path().join("t.ele");
    std::fs::write(&path, ele).expect("written");
    read_mesh(&Source::from_arg(path), &ReadOptions::default(), &()).map_err(|e| e.to_string())
}

#[test]
fn six_nodes_are_read_in_the_order_of_triangle() {
    let node = "6 2 1 1\n1 0 0 5 1\n2 2 0 6 1\n3 0 2 7 1\n4 1 1 8 1\n5 0 1 9 1\n6 1 0 9 1\n";
    let mesh = pair(node, "1 6 1\n1 1 2 3 4 5 6 0.5\n").expect("a mesh");
    assert_eq!(mesh.triangles, [[0, 1, 2].map(VertexId::from)]);
    assert_eq!(mesh.triangle_attributes[0].values, [0.5]);
    assert_eq!(mesh.vertices.points.len(), 3);
    assert_eq!(mesh.vertices.attributes[0].values, [5.0, 6.0, 7.0]);
    assert_eq!(mesh.vertices.markers, Some(vec![1; 3]));
    for (ele, expected) in [
        (
            "1 4 0\n1 1 2 3 4\n",
            "t.ele:1: 4 nodes a triangle: only 3 and 6",
        ),
        (
            "1 6 0\n1 1 2 3 4 5\n",
            "t.ele:2: expected 7 columns, found 6",
        ),
        (
            "1 6 0\n1 1 2 3 4 5 7\n",
            "t.ele:2: triangle 1 names vertex 7 of 6",
        ),
        (
            "1 6 0\n1 1 2 6 4 5 3\n",
            "t.ele: node 3 is a midpoint, but node 6 behind it",
        ),
        (
            "1 6 0\n1 1 2 3 4 5 1\n",
            "t.ele: node 1 is a corner of one triangle and a midpoint",
        ),
    ] {
        let error = pair(node, ele).expect_err(expected);
        assert!(error.contains(expected), "{error}");
    }
}

#[test]
fn files_may_be_written_one_by_one_and_without_markers() {
    let options = WriteOptions {
        one_by_one: true,
        without_markers: true,
        ..one_based()
    };
    let folder = written(&["a.1.poly", "a.1.edge", "a.1.node"], &options);
    let files = std::fs::read_dir(folder.path()).expect("folder").count();
    assert_eq!(files, 3);
    assert_eq!(lines(&folder, "a.1.poly")[..3], ["0 2 1 0", "6 0", "1 1 2"]);
    assert_eq!(lines(&folder, "a.1.edge")[0], "5 0");
    assert!(rows(&folder, "a.1.edge").iter().all(|row| row.len() == 2));
    assert_eq!(lines(&folder, "a.1.node")[..2], ["11 2 1 0", "1 0 0 1"]);
}

#[test]
fn areas_belong_to_the_triangles_of_a_mesh() {
    let areas = |text: &str| {
        let source = Source::Memory {
            name: "t.area".to_owned(),
            bytes: text.as_bytes().to_vec(),
        };
        read_areas(&source, 3, &()).map_err(|error| error.to_string())
    };
    let from_one = areas("# bounds\n3\n1 0.5\n2 -1\n3 0\n").expect("three");
    assert_eq!(from_one, [Some(0.5), None, None]);
    let from_zero = areas("3\n0 1e-9\n1 inf\n2 .25\n").expect("three");
    assert_eq!(from_zero, [Some(1e-9), Some(f64::INFINITY), Some(0.25)]);
    for (text, expected) in [
        ("", "t.area: the file is empty"),
        (
            "2\n1 1\n2 1\n",
            "t.area:1: bounds for 2 triangles, but the mesh has 3",
        ),
        (
            "3\n1 1\n2 1\n",
            "t.area:3: truncated: header says 3 triangles, file has 2",
        ),
        (
            "3\n1 1\n2 1\n3 1\n4 1\n",
            "t.area:5: header says 3 triangles, but more",
        ),
        (
            "3\n1 1\n3 1\n2 1\n",
            "t.area:3: row is numbered \"3\", expected 2",
        ),
        (
            "3\n1 1\n2 x\n3 1\n",
            "t.area:3: largest area is not a number: \"x\"",
        ),
        (
            "3\n1 1\n2 nan\n3 1\n",
            "t.area:3: the largest area of triangle 2 is NaN",
        ),
        (
            "3\n1 1\n2 1 1\n3 1\n",
            "t.area:3: expected 2 columns, found 3",
        ),
        ("-3\n", "-3 triangles: a count cannot be negative"),
    ] {
        let error = areas(text).expect_err(expected);
        assert!(error.contains(expected), "{error}");
    }
}
