//! Meshes of finite-element programs: files that others wrote are read as what they are, ours come back, and broken ones
//! are refused with words.

mod plate;

use delone::{DomainRule, Point};
use delone_io::{
    Attribute, Constraints, DomainData, Error, MeshData, MeshView, PointSet, ReadOptions, Source,
    Target, WriteOptions, read_domain, read_mesh, read_points, write_domain, write_mesh,
    write_points,
};
use proptest::prelude::*;
use std::path::{Path, PathBuf};

fn fixture(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("tests/data/fem")
        .join(name)
}

fn fixtures() -> Vec<PathBuf> {
    let entries = std::fs::read_dir(fixture("")).expect("folder");
    let mut paths: Vec<_> = entries.map(|e| e.expect("entry").path()).collect();
    paths.retain(|p| {
        p.extension()
            .is_some_and(|e| e == "msh" || e == "vtk" || e == "vtu")
    });
    paths.sort();
    paths
}

/// Files that are refused, and why.
const REFUSED: [(&str, &str); 3] = [
    (
        "gmsh-quads.msh",
        "element 15 is a quadrangle (type 3); only points, lines and triangles",
    ),
    (
        "meshio-lzma.vtu",
        "data are compressed by vtkLZMADataCompressor: only vtkZLibDataCompressor is",
    ),
    (
        "vtk-raw-lz4-64le.vtu",
        "data are compressed by vtkLZ4DataCompressor",
    ),
];

#[test]
fn files_of_others_hold_the_plate() {
    let mut checked = 0;
    for path in fixtures() {
        let refused = REFUSED.iter().find(|r| path.ends_with(r.0));
        match refused {
            Some((name, why)) => {
                let error = plate::read(&path).expect_err(name).to_string();
                assert!(error.contains(why), "{error}");
            }
            None => {
                plate::check(&path);
                checked += 1;
            }
        }
    }
    assert!(checked >= 25, "{checked}");
}

#[test]
fn what_gmsh_says_besides_is_noted() {
    let notes = |name| {
        plate::read(&fixture(name))
            .expect("readable")
            .vertices
            .notes
    };
    let names =
        "names of groups are not kept: marker 1 \"wall\", marker 7 \"inlet\", region 2 \"steel\"";
    assert_eq!(notes("gmsh-41-1.msh"), [names]);
    assert_eq!(notes("gmsh-parts.msh"), ["partitions are not kept", names]);
    for name in ["gmsh-data.msh", "gmsh-datab.msh"] {
        let mesh = plate::read(&fixture(name)).expect("readable");
        let pressure = &mesh.vertices.attributes[0];
        assert_eq!(pressure.name, "pressure");
        for (p, value) in mesh.vertices.points.iter().zip(&pressure.values) {
            // Gmsh writes 16 digits.
            assert!((value - p.x * 3.0 - 0.1).abs() < 1e-14);
        }
        let names: Vec<_> = mesh
            .triangle_attributes
            .iter()
            .map(|a| a.name.as_str())
            .collect();
        assert_eq!(names, ["region", "flux_0", "flux_1", "flux_2"]);
        assert!(mesh.triangle_attributes[2].values.iter().all(|&v| v == 1.0));
    }
}

/// The plate with attributes, markers, and regions that have names of ours.
fn rich() -> MeshData {
    let mut mesh = plate::read(&fixture("gmsh-41-1.msh")).expect("readable");
    mesh.vertices.notes.clear();
    mesh.vertices.base = 0;
    let of_points = |f: fn(&Point) -> f64| mesh.vertices.points.iter().map(f).collect();
    mesh.vertices.attributes = vec![
        Attribute {
            name: "z".to_owned(),
            values: of_points(|p| p.x / 3.0 + 1e-17),
        },
        Attribute {
            name: "with blank %".to_owned(),
            values: of_points(|p| p.y.exp()),
        },
    ];
    mesh.vertices.markers = Some((0..plate::POINTS as i32).map(|i| i * i - 50).collect());
    let values = (0..plate::TRIANGLES)
        .map(|t| 1.0 / (t as f64 + 1.0))
        .collect();
    mesh.triangle_attributes.push(Attribute {
        name: "id".to_owned(),
        values,
    });
    let graph = mesh.constraints.as_mut().expect("lines");
    let markers = graph.markers.as_mut().expect("markers");
    (markers[0], markers[3]) = (-4, 7);
    mesh
}

/// Writes a mesh to files in a folder.
fn written(mesh: &MeshView<'_>, names: &[&str], ascii: bool) -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("folder");
    let target = |name: &&str| Target::from_arg(folder.path().join(name), None);
    let targets: Vec<_> = names.iter().map(target).collect();
    let options = WriteOptions {
        ascii,
        ..WriteOptions::default()
    };
    write_mesh(&targets, mesh, &options, &()).unwrap_or_else(|error| panic!("{error}"));
    folder
}

fn plain(mesh: MeshData) -> MeshData {
    let vertices = PointSet {
        base: 0,
        ..mesh.vertices
    };
    MeshData { vertices, ..mesh }
}

#[test]
fn ours_come_back() {
    let mesh = rich();
    for ascii in [false, true] {
        let names = ["m.msh", "m.msh2", "m.vtk", "m.vtu"];
        let folder = written(&MeshView::from(&mesh), &names, ascii);
        for name in names {
            let back =
                plate::read(&folder.path().join(name)).unwrap_or_else(|error| panic!("{error}"));
            let back = plain(back);
            assert_eq!(back.vertices, mesh.vertices, "{name}");
            assert_eq!(back.triangle_attributes, mesh.triangle_attributes, "{name}");
            assert_eq!(back, mesh, "{name}");
        }
    }
}

#[test]
fn six_nodes_come_back() {
    let mesh = rich();
    let names = ["m.msh", "m.msh2", "m.vtk"];
    let folder = written(&MeshView::from(&mesh).quadratic(), &names, false);
    // Lines have their midpoints, too: elements of type 8.
    let text = std::fs::read_to_string(folder.path().join("m.msh2")).expect("text");
    let (_, elements) = text.split_once("$Elements").expect("a section");
    let is_line = |row: &&str| row.split(' ').nth(1) == Some("8");
    let edges = &mesh.constraints.as_ref().expect("lines").edges;
    assert_eq!(elements.lines().filter(is_line).count(), edges.len());
    for name in names {
        let back = plain(plate::read(&folder.path().join(name)).expect("readable"));
        assert!(back.quadratic);
        assert_eq!(
            MeshData {
                quadratic: false,
                ..back
            },
            mesh,
            "{name}"
        );
    }
}

#[test]
fn regions_are_groups_that_tell_their_attribute() {
    let mut mesh = rich();
    let regions = std::mem::take(&mut mesh.triangle_attributes).swap_remove(0);
    let region = |attribute| delone::Region {
        at: Point::new(0.5, 0.5),
        attribute,
        max_area: None,
    };
    let graph = mesh.constraints.as_mut().expect("lines");
    graph.regions = vec![region(10.0), region(-2.5)];
    let of = regions.values.iter().map(|&r| Some(u32::from(r == 5.0)));
    graph.region_of = Some(of.collect());
    let folder = written(&MeshView::from(&mesh), &["m.msh", "m.msh2"], false);
    for name in ["m.msh", "m.msh2"] {
        let text = std::fs::read_to_string(folder.path().join(name)).expect("text");
        assert!(text.contains("\"region 0 (attribute 10)\""), "{text}");
        assert!(text.contains("2 1 \"region 1 (attribute -2.5)\""), "{text}");
        assert!(text.contains("\"marker -4\""), "{text}");
        let back = plate::read(&folder.path().join(name)).expect("readable");
        let expected: Vec<f64> = regions
            .values
            .iter()
            .map(|&r| f64::from(u8::from(r == 5.0)))
            .collect();
        assert_eq!(back.triangle_attributes[0].values, expected);
        assert_eq!(back.vertices.notes, Vec::<String>::new());
    }
}

/// A square with a hole and a loose line, whose points have markers.
fn outline() -> DomainData {
    let ring = |x: f64, w: f64| [[x, x], [x + w, x], [x + w, x + w], [x, x + w]];
    let mut points = [ring(0.0, 3.0), ring(1.0, 1.0)].concat();
    points.push([5.0, 5.0]);
    let segments = [
        [0, 1],
        [1, 2],
        [2, 3],
        [3, 0],
        [4, 5],
        [5, 6],
        [6, 7],
        [7, 4],
        [2, 8],
    ];
    let mut domain = DomainData::from_rows(points, segments.to_vec(), vec![]).expect("a domain");
    domain.segment_markers = Some(vec![1, 2, 3, 4, 5, 5, 5, 5, 0]);
    domain
}

#[test]
fn domains_come_back_with_their_rings() {
    let domain = outline();
    let folder = tempfile::tempdir().expect("folder");
    for name in ["d.msh", "d.msh2", "d.vtk", "d.vtu"] {
        let path = folder.path().join(name);
        let target = Target::from_arg(&path, None);
        write_domain(&[target], &domain, &WriteOptions::default(), &()).expect("writable");
        let back =
            read_domain(&Source::from_arg(&path), &ReadOptions::default(), &()).expect("readable");
        assert_eq!(back.vertices.points, domain.vertices.points, "{name}");
        assert_eq!(back.segments, domain.segments, "{name}");
        assert_eq!(back.segment_markers, domain.segment_markers, "{name}");
        assert_eq!(back.usual_rule, DomainRule::EvenOdd, "{name}");
        assert_eq!(back.polygons, vec![0..8; 1], "{name}");
    }
}

#[test]
fn seeds_are_refused_not_lost() {
    let domain = DomainData {
        holes: vec![Point::new(1.5, 1.5)],
        ..outline()
    };
    let folder = tempfile::tempdir().expect("folder");
    for name in ["d.msh", "d.msh2", "d.vtk", "d.vtu"] {
        let target = Target::from_arg(folder.path().join(name), None);
        let error =
            write_domain(&[target], &domain, &WriteOptions::default(), &()).expect_err(name);
        assert!(
            error
                .to_string()
                .contains("hold holes and regions that are named by points"),
            "{error}"
        );
    }
}

#[test]
fn points_come_back() {
    let set = PointSet { ..rich().vertices };
    let folder = tempfile::tempdir().expect("folder");
    for name in ["p.msh", "p.msh2", "p.vtk"] {
        let path = folder.path().join(name);
        let target = Target::from_arg(&path, None);
        write_points(&[target], &set, &WriteOptions::default(), &()).expect("writable");
        let back =
            read_points(&Source::from_arg(&path), &ReadOptions::default(), &()).expect("readable");
        assert_eq!(PointSet { base: 0, ..back }, set, "{name}");
    }
}

fn mesh_of(name: &str, text: &str) -> Result<MeshData, Error> {
    let source = Source::Memory {
        name: name.to_owned(),
        bytes: text.as_bytes().to_vec(),
    };
    read_mesh(&source, &ReadOptions::default(), &())
}

const JIGSAW: &str = "# by hand\nMSHID=3;EUCLIDEAN-MESH\nNDIMS=2\nPOINT=4\n0;0;7\n1;0;0\n1;1;0\n0;1;0\n\
EDGE2=4\n0;1;1\n1;2;2\n2;3;3\n3;0;4\n";

#[test]
fn jigsaw_brings_domains_or_meshes() {
    let domain = |text: &str| {
        let source = Source::Memory {
            name: "a.msh".to_owned(),
            bytes: text.as_bytes().to_vec(),
        };
        read_domain(&source, &ReadOptions::default(), &()).unwrap_or_else(|error| panic!("{error}"))
    };
    let plain = domain(JIGSAW);
    assert_eq!(plain.segment_markers, Some(vec![1, 2, 3, 4]));
    assert_eq!(plain.vertices.markers, Some(vec![7, 0, 0, 0]));
    assert_eq!(
        (plain.usual_rule, plain.polygons),
        (DomainRule::EvenOdd, vec![0..4; 1])
    );
    // Two parts share the diagonal.
    let parts = JIGSAW.replace("EDGE2=4", "EDGE2=5\n0;2;0");
    let parts = format!(
        "{parts}BOUND=6\n1;0;20\n2;0;20\n1;1;20\n1;2;20\n2;3;20\n2;4;20\nVALUE=4\n1\n2\n3\n4\n"
    );
    let parts = domain(&parts);
    assert_eq!(parts.polygons, [0..3, 3..6]);
    assert_eq!(parts.segments.len(), 6);
    assert_eq!(parts.vertices.attributes[0].values, [1.0, 2.0, 3.0, 4.0]);
    let mesh = format!("{JIGSAW}TRIA3=2\n0;1;2;5\n0;2;3;6\n");
    let mesh = mesh_of("a.msh", &mesh).expect("a mesh");
    assert_eq!(mesh.triangles.len(), 2);
    assert_eq!(mesh.triangle_attributes[0].values, [5.0, 6.0]);
}

#[test]
fn what_jigsaw_says_besides_is_noted() {
    let mesh = mesh_of(
        "a.msh",
        &format!("{JIGSAW}POWER=4;1\n0\n1\n2\n3\nHEXA8=0\n"),
    );
    let notes = mesh.expect("a mesh").vertices.notes;
    assert_eq!(notes, ["weights of points (POWER) are not kept"]);
}

#[test]
fn jigsaw_of_the_corpus_has_its_facts() {
    let beside = || Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared");
    let root = std::env::var_os("DELONE_SHARED")
        .map_or_else(beside, PathBuf::from)
        .join("data");
    if !root.is_dir() {
        eprintln!("skipped: the shared data are absent (set DELONE_SHARED)");
        return;
    }
    for (name, points, segments, polygons) in [
        ("mesh2d/airfoil.msh", 476, 476, 1),
        ("mesh2d/channel.msh", 103, 103, 1),
        ("jigsaw/airfoil.msh", 476, 476, 1),
        ("jigsaw-geo/us48.msh", 47_316, 47_370, 0),
    ] {
        let source = Source::from_arg(root.join(name));
        let domain =
            read_domain(&source, &ReadOptions::default(), &()).unwrap_or_else(|e| panic!("{e}"));
        assert_eq!(domain.vertices.points.len(), points, "{name}");
        let mut edges: Vec<_> = domain
            .segments
            .iter()
            .map(|&[a, b]| [a.min(b), a.max(b)])
            .collect();
        edges.sort_unstable();
        edges.dedup();
        assert_eq!(edges.len(), segments, "{name}");
        assert_eq!(domain.usual_rule, DomainRule::EvenOdd, "{name}");
        if polygons > 0 {
            assert_eq!(domain.polygons.len(), polygons, "{name}");
        }
    }
}

const MSH: &str = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n10 0 0 0\n20 1 0 0\n40 0 1 5\n$EndNodes\n\
$Elements\n1\n7 2 2 3 1 10 20 40\n$EndElements\n";

#[test]
fn of_several_groups_the_first_is_kept_and_that_is_said() {
    const TWICE: &str = "triangles that are there twice are kept once: 1";
    const FIRST: &str = "of elements in several physical groups only the first group is kept";
    // In version 2 an element of several groups is there once for each.
    let triangle = "7 2 2 3 1 10 20 40\n";
    for (elements, expected) in [
        ("8 2 2 5 1 20 40 10\n", &[TWICE, FIRST][..]),
        ("8 2 2 3 1 10 20 40\n", &[TWICE]),
        ("1 1 2 6 1 10 20\n2 1 2 9 1 20 10\n", &[FIRST]),
        ("1 1 2 6 1 10 20\n2 1 2 6 1 20 10\n", &[]),
        ("1 15 2 4 1 10\n2 15 2 8 1 10\n", &[FIRST]),
        ("1 15 2 4 1 10\n2 1 2 9 1 10 20\n", &[]),
    ] {
        let count = 1 + elements.lines().count();
        let text = MSH.replace(
            &format!("1\n{triangle}"),
            &format!("{count}\n{triangle}{elements}"),
        );
        let name = "a.msh".to_owned();
        let bytes = text.into_bytes();
        let source = Source::Memory { name, bytes };
        let mesh = read_mesh(&source, &ReadOptions::default(), &()).expect("a mesh");
        assert_eq!(mesh.vertices.notes, expected, "{elements}");
        assert_eq!(mesh.triangles.len(), 1, "{elements}");
        assert_eq!(mesh.triangle_attributes[0].values, [3.0], "{elements}");
        if elements.starts_with("1 1 ") {
            let markers = mesh.constraints.expect("a segment").markers;
            assert_eq!(markers, Some(vec![6]), "{elements}");
        }
        if elements.starts_with("1 15 ") {
            let markers = mesh.vertices.markers.expect("markers");
            assert_eq!(markers[0], 4, "{elements}");
        }
    }
}

/// Name, what is replaced in a good file by what, and what the error must say.
const BROKEN: &[(&str, &str, &str, &str, &str)] = &[
    (
        "a.msh",
        MSH,
        "2.2",
        "2.9",
        "a.msh:2: version 2.9: only 2.2, 4.0 and 4.1 are understood",
    ),
    (
        "a.msh",
        MSH,
        "$Nodes\n3",
        "$Nodes\n99999999999",
        "node is not a number: \"$EndNodes\"",
    ),
    (
        "a.msh",
        MSH,
        "20 1 0 0",
        "20 1 nan 0",
        "a.msh: point 20: y is NaN",
    ),
    (
        "a.msh",
        MSH,
        "20 1 0 0",
        "10 1 0 0",
        "a.msh: node 10 is there twice",
    ),
    (
        "a.msh",
        MSH,
        "10 20 40",
        "10 20 30",
        "a.msh:12: element 7 names node 30, which is not there",
    ),
    (
        "a.msh",
        MSH,
        "7 2 2",
        "7 4 2",
        "a.msh:12: element 7 is a tetrahedron (type 4)",
    ),
    (
        "a.msh",
        MSH,
        "$EndElements\n",
        "",
        "truncated: the file ends before $EndElements",
    ),
    (
        "a.msh",
        MSH,
        "$Nodes",
        "$NOD",
        "truncated: the file ends before $EndNOD",
    ),
    (
        "a.msh",
        JIGSAW,
        "NDIMS=2",
        "NDIMS=3",
        "a.msh:3: dimension must be 2, not 3",
    ),
    (
        "a.msh",
        JIGSAW,
        "MESH",
        "GRID",
        "EUCLIDEAN-GRID is not understood: only EUCLIDEAN-MESH is",
    ),
    (
        "a.msh",
        JIGSAW,
        "MSHID=3",
        "MSHID=4",
        "version \"4\": only 1, 2 and 3",
    ),
    (
        "a.msh",
        JIGSAW,
        "POINT=4",
        "POINT=9999999999",
        "9999999999 points, at most 4294967294 are possible",
    ),
    (
        "a.msh",
        JIGSAW,
        "EDGE2=4",
        "EDGE2=99",
        "truncated: header says 99 edges, file has 4",
    ),
    (
        "a.msh",
        JIGSAW,
        "3;0;4",
        "3;4;4",
        "edge 3 names vertex 4 of 4 (numbered from 0)",
    ),
    (
        "a.msh",
        JIGSAW,
        "EDGE2",
        "QUAD4",
        "QUAD4 is not understood: only POINT, EDGE2",
    ),
    (
        "a.vtk",
        VTK,
        "3.0",
        "6.0",
        "versions up to 5.1 are understood",
    ),
    (
        "a.vtk",
        VTK,
        "UNSTRUCTURED_GRID",
        "STRUCTURED_GRID",
        "a.vtk:4: dataset STRUCTURED_GRID: only",
    ),
    (
        "a.vtk",
        VTK,
        "POINTS 3",
        "POINTS 99999999999",
        "a.vtk:9: \"CELLS\" is not a number",
    ),
    (
        "a.vtk",
        VTK,
        "3 0 1 2",
        "3 0 1 3",
        "triangle 0 names vertex 3 of 3 (numbered from 0)",
    ),
    (
        "a.vtk",
        VTK,
        "3 0 1 2",
        "9 0 1 2",
        "cell 0 has 9 corners, more than there are",
    ),
    (
        "a.vtk",
        VTK,
        "CELL_TYPES 1\n5",
        "CELL_TYPES 1\n9",
        "cell 0 has VTK type 9: only triangles",
    ),
    (
        "a.vtk",
        VTK,
        "double",
        "quad",
        "a.vtk:5: type \"quad\" is not understood",
    ),
    ("a.vtk", VTK, "1 0 0", "1 inf 0", "point 1: y is inf"),
    (
        "a.mesh",
        SIX_NODES,
        "Edges 1 1 2",
        "Edges 1 1 4",
        "a.mesh: node 4 is the end of an edge and a midpoint",
    ),
];

const SIX_NODES: &str = "MeshVersionFormatted 2 Dimension 2 Vertices 6 0 0 0 2 0 0 0 2 0 1 0 0 1 1 0 0 1 0\n\
Edges 1 1 2 0 TrianglesP2 1 1 2 3 4 5 6 0 End\n";

const VTK: &str = "# vtk DataFile Version 3.0\ntitle\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 3 double\n\
0 0 0\n1 0 0\n0 1 0\nCELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n5\n";

#[test]
fn tensors_of_vtk_have_all_their_components() {
    let rows = |row: &str| [row; 3].join("\n");
    let tensors = rows("1 2 3 4 5 6 7 8 9");
    let symmetric = rows("1 2 3 4 5 6");
    let data = format!(
        "POINT_DATA 3\nTENSORS t double\n{tensors}\nTENSORS6 s double\n{symmetric}\nNORMALS n double\n{}\n\
         FIELD f 1\nid%20of 1 3 int\n7 8 9\n",
        rows("0 0 1")
    );
    let mesh = mesh_of("a.vtk", &format!("{VTK}{data}")).expect("a mesh");
    let names: Vec<_> = mesh
        .vertices
        .attributes
        .iter()
        .map(|a| &a.name[..])
        .collect();
    assert_eq!(names.len(), 9 + 6 + 3 + 1);
    assert_eq!((names[8], names[9], names[18]), ("t_8", "s_0", "id of"));
    assert_eq!(mesh.vertices.attributes[8].values, [9.0; 3]);
    assert_eq!(mesh.vertices.attributes[18].values, [7.0, 8.0, 9.0]);
    let whole = VTK.replace(
        "DATASET",
        "FIELD FieldData 1\ntime 1 1 double\n0.5\nDATASET",
    );
    let notes = mesh_of("a.vtk", &whole).expect("a mesh").vertices.notes;
    assert_eq!(notes, ["data of the whole file are not kept: \"time\""]);
}

#[test]
fn what_cells_say_about_lines_is_noted_if_it_is_something() {
    let both = VTK.replace(
        "CELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n5\n",
        "CELLS 2 7\n2 0 1\n3 0 1 2\nCELL_TYPES 2\n3\n5\nCELL_DATA 2\nSCALARS heat double\n",
    );
    for (value, is_noted) in [("0", false), ("-1", false), ("nan", false), ("0.5", true)] {
        let mesh = mesh_of("a.vtk", &format!("{both}{value}\n7\n")).expect("a mesh");
        let note = "what \"heat\" says about lines is not kept";
        assert_eq!(
            mesh.vertices.notes.iter().any(|n| n == note),
            is_noted,
            "{value}"
        );
        assert_eq!(mesh.triangle_attributes[0].values, [7.0]);
        assert_eq!(mesh.constraints.expect("a line").markers, None);
    }
}

#[test]
fn strings_among_bytes_of_vtk_are_passed_over() {
    let mut file =
        b"# vtk DataFile Version 3.0\ntitle\nBINARY\nDATASET UNSTRUCTURED_GRID\nPOINTS 3 float\n"
            .to_vec();
    let points = [0f32, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0];
    file.extend(points.iter().flat_map(|v| v.to_be_bytes()));
    file.extend(b"\nPOINT_DATA 3\nFIELD FieldData 2\nnames 1 3 string\n");
    // The first two bits tell how many bytes the length takes.
    file.extend(b"\xc2ab");
    file.extend([&[0x80, 70][..], &[b'x'; 70]].concat());
    file.extend(b"\x40\0\0\x01c");
    file.extend(b"\nid 1 3 int\n");
    file.extend([7i32, -8, 70_000].iter().flat_map(|v| v.to_be_bytes()));
    let (name, bytes) = ("a.vtk".to_owned(), file);
    let mesh = read_mesh(
        &Source::Memory { name, bytes },
        &ReadOptions::default(),
        &(),
    );
    let vertices = mesh.expect("points").vertices;
    assert_eq!(vertices.attributes[0].values, [7.0, -8.0, 70_000.0]);
    assert_eq!(vertices.notes, ["strings are not kept: \"names\""]);
}

#[test]
fn triangles_of_several_groups_are_kept_once() {
    let twice = MSH.replace(
        "$Elements\n1\n7 2 2 3 1 10 20 40\n",
        "$Elements\n3\n7 2 2 3 1 10 20 40\n8 2 2 3 1 40 20 10\n9 2 2 5 1 20 10 40\n",
    );
    let more = twice
        .replace("40 0 1 5\n", "40 0 1 5\n41 2 2 0\n")
        .replace("$Nodes\n3", "$Nodes\n4");
    let more = more.replace("8 2 2 3 1 40 20 10", "8 2 2 3 1 10 40 41");
    let mesh = mesh_of("a.msh", &more).expect("a mesh");
    assert_eq!(mesh.triangles.len(), 2);
    assert_eq!(mesh.triangle_attributes[0].values, [3.0, 3.0]);
    assert_eq!(
        mesh.vertices.notes,
        [
            "triangles that are there twice are kept once: 1",
            "of elements in several physical groups only the first group is kept"
        ]
    );
    let mesh = mesh_of("a.msh", &twice).expect("a mesh");
    assert_eq!(
        mesh.vertices.notes,
        [
            "triangles that are there twice are kept once: 2",
            "of elements in several physical groups only the first group is kept"
        ]
    );
}

#[test]
fn broken_bytes_are_told_by_their_place() {
    let mut bytes = std::fs::read(fixture("gmsh-22b-1p.msh")).expect("file");
    let cut = bytes.len() / 2;
    bytes.truncate(cut);
    let source = Source::Memory {
        name: "a.msh".to_owned(),
        bytes,
    };
    let error = read_mesh(&source, &ReadOptions::default(), &()).expect_err("half a file");
    assert!(error.to_string().starts_with("a.msh at byte "), "{error}");
}

#[test]
fn broken_files_say_what_is_wrong() {
    for &(name, good, from, to, expected) in BROKEN {
        mesh_of(name, good).unwrap_or_else(|error| panic!("{error}"));
        assert!(good.contains(from), "{from}");
        let message = mesh_of(name, &good.replacen(from, to, 1))
            .expect_err(expected)
            .to_string();
        assert!(message.contains(expected), "{message:?} lacks {expected:?}");
    }
}

#[test]
fn tags_may_have_gaps_and_heights_are_kept() {
    let mesh = mesh_of("a.msh", MSH).expect("a mesh");
    assert_eq!(mesh.vertices.attributes[0].name, "z");
    assert_eq!(mesh.vertices.attributes[0].values, [0.0, 0.0, 5.0]);
    assert_eq!(mesh.triangle_attributes[0].values, [3.0]);
    assert_eq!(mesh.vertices.base, 0);
    let data = "$NodeData\n1\n\"id\"\n1\n0.5\n3\n0\n1\n3\n10 7\n20 8\n40 9\n$EndNodeData\n";
    let with_data = mesh_of("a.msh", &format!("{MSH}{data}"))
        .expect("a mesh")
        .vertices;
    assert_eq!(with_data.attributes[1].name, "id");
    assert_eq!(with_data.attributes[1].values, [7.0, 8.0, 9.0]);
    assert_eq!(with_data.markers, None, "whole numbers of another name");
    for (tags, base) in [([1, 2, 3], 1), ([2, 3, 4], 0), ([1, 2, 4], 0)] {
        let [a, b, c] = tags;
        let text = MSH.replace("10 20 40", &format!("{a} {b} {c}"));
        let text = text.replace("10 0 0 0", &format!("{a} 0 0 0"));
        let text = text.replace("20 1 0 0", &format!("{b} 1 0 0"));
        let text = text.replace("40 0 1 5", &format!("{c} 0 1 5"));
        let mesh = mesh_of("a.msh", &text).expect("a mesh");
        assert_eq!(mesh.vertices.base, base, "{tags:?}");
    }
}

#[test]
fn bombs_are_not_unpacked() {
    // A declared size far beyond what so few bytes may be unpacked to.
    let path = fixture("vtk-raw-zlib-32be.vtu");
    let bytes = std::fs::read(&path).expect("file");
    let element = bytes
        .windows(13)
        .position(|w| w == b"<AppendedData")
        .expect("appended data");
    let underscore = bytes[element..]
        .iter()
        .position(|&b| b == b'_')
        .expect("data");
    let start = element + underscore + 1;
    let mut huge = bytes.clone();
    huge[start + 4..start + 8].copy_from_slice(&[0x7f; 4]);
    huge[start..start + 4].copy_from_slice(&[0, 0, 0, 2]);
    let source = Source::Memory {
        name: "a.vtu".to_owned(),
        bytes: huge,
    };
    let error = read_mesh(&source, &ReadOptions::default(), &())
        .expect_err("too much")
        .to_string();
    assert!(
        error.contains("too many for a file of this size; write without compression"),
        "{error}"
    );
}

#[test]
fn arrays_that_share_their_bytes_are_few() {
    let array = |name| {
        format!("<DataArray type=\"UInt8\" Name=\"{name}\" format=\"appended\" offset=\"0\"/>")
    };
    let read = |arrays: usize| {
        let arrays: String = (0..arrays).map(array).collect();
        let head = format!(
            "<VTKFile type=\"UnstructuredGrid\" header_type=\"UInt64\"><Piece NumberOfPoints=\"9999\"><PointData>\
             {arrays}</PointData></Piece><AppendedData encoding=\"raw\">_"
        );
        let count = 9999u64.to_le_bytes();
        let bytes = [
            head.as_bytes(),
            &count,
            &[7; 9999],
            b"</AppendedData></VTKFile>",
        ];
        let (name, bytes) = ("a.vtu".to_owned(), bytes.concat());
        read_mesh(
            &Source::Memory { name, bytes },
            &ReadOptions::default(),
            &(),
        )
        .expect_err("no points")
        .to_string()
    };
    assert!(
        read(2).contains("the piece declares 9999 points"),
        "{}",
        read(2)
    );
    let error = read(3);
    assert!(
        error.contains("array \"2\": shares its bytes with too many others"),
        "{error}"
    );
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, ..ProptestConfig::default() })]

    #[test]
    fn damaged_files_neither_panic_nor_hang(
        which in 0usize..64,
        flips in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..6),
        cut in prop::option::of(any::<prop::sample::Index>()),
    ) {
        let all = fixtures();
        let path = &all[which % all.len()];
        let mut bytes = std::fs::read(path).expect("file");
        if let Some(cut) = cut {
            bytes.truncate(cut.index(bytes.len()) + 1);
        }
        for (place, byte) in flips {
            let place = place.index(bytes.len());
            bytes[place] = byte;
        }
        let source = Source::Memory { name: path.file_name().expect("name").to_string_lossy().into_owned(), bytes };
        if let Ok(mesh) = read_mesh(&source, &ReadOptions::default(), &()) {
            let n = mesh.vertices.points.len();
            prop_assert!(mesh.triangles.as_flattened().iter().all(|v| v.index() < n));
            prop_assert!(mesh.vertices.attributes.iter().all(|a| a.values.len() == n));
            let graph = mesh.constraints.unwrap_or_else(Constraints::default);
            prop_assert!(graph.edges.as_flattened().iter().all(|v| v.index() < n));
        }
        drop(read_domain(&source, &ReadOptions::default(), &()));
    }
}
