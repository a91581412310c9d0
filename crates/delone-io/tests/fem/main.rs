//! Meshes of finite-element programs: files that others wrote are read as what they are, ours come back, and broken ones
//! are refused with words.
//!
//! Here is what all formats have in common: the plate, and that what is written comes back.

mod damage;
mod gmsh;
mod jigsaw;
#[path = "../plate/mod.rs"]
mod plate;
mod vtk;

use delone::{DomainRule, Point};
use delone_io::{
    Attribute, DomainData, Error, MeshData, MeshView, PointSet, ReadOptions, Source, Target,
    WriteOptions, read_domain, read_mesh, read_points, write_domain, write_mesh, write_points,
};
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
