//! trimesh, meshio and PyVista read our `.obj`, `.off` and `.ply` with equal numbers, and we read theirs.

mod peers;

use delone::{Point, VertexId};
use delone_io::{
    Attribute, Constraints, MeshData, MeshView, PointSet, ReadOptions, Source, Target,
    WriteOptions, read_mesh, write_mesh,
};
use serde_json::{Value, json};
use std::path::Path;

/// Two triangles with a height, heat, and a line, in numbers that need all digits of a double.
fn sample() -> MeshData {
    let points = [
        (0.1, 1.0 / 3.0),
        (1e6 + 0.1, 0.0),
        (1.0, 2.0 / 3.0),
        (-7.5, 1e-3),
    ];
    let column = |name: &str, values: &[f64]| Attribute {
        name: name.to_owned(),
        values: values.to_vec(),
    };
    MeshData {
        vertices: PointSet {
            points: points.map(Point::from).to_vec(),
            attributes: vec![
                column("z", &[0.5, 0.1, 0.2, 0.7]),
                column("heat", &[1.1, 2.2, 3.3, 4.4]),
            ],
            markers: Some(vec![1, 2, 3, 4]),
            ..PointSet::default()
        },
        triangles: [[0, 1, 2], [0, 2, 3]]
            .map(|t| t.map(VertexId::new))
            .to_vec(),
        triangle_attributes: vec![column("region", &[2.0, 5.0])],
        constraints: Some(Constraints {
            edges: vec![[0, 2].map(VertexId::new)],
            markers: Some(vec![9]),
            ..Constraints::default()
        }),
        quadratic: false,
    }
}

fn coordinates(mesh: &MeshData) -> Value {
    let z = mesh.vertices.attributes.iter().find(|a| a.name == "z");
    let points = mesh.vertices.points.iter().enumerate();
    let rows: Vec<[f64; 3]> = points
        .map(|(v, p)| [p.x, p.y, z.map_or(0.0, |z| z.values[v])])
        .collect();
    json!(rows)
}

fn corners(mesh: &MeshData) -> Value {
    let rows: Vec<_> = mesh
        .triangles
        .iter()
        .map(|t| t.map(VertexId::raw))
        .collect();
    json!(rows)
}

/// Writes a mesh under a name.
fn write(folder: &Path, name: &str, ascii: bool, mesh: &MeshData) {
    let options = WriteOptions {
        ascii,
        ..WriteOptions::default()
    };
    let target = Target::from_arg(folder.join(name), None);
    write_mesh(&[target], &MeshView::from(mesh), &options, &()).expect("written");
}

fn read(path: &Path) -> MeshData {
    read_mesh(&Source::from_arg(path), &ReadOptions::default(), &()).expect("theirs")
}

#[test]
fn trimesh_reads_ours_and_we_read_its() {
    let Some(python) = peers::python(&["trimesh", "numpy", "json"]) else {
        return;
    };
    let folder = tempfile::tempdir().expect("folder");
    write(folder.path(), "a.obj", false, &sample());
    write(folder.path(), "a.off", false, &sample());
    write(folder.path(), "b.ply", false, &sample());
    write(folder.path(), "t.ply", true, &sample());
    let script = r#"
import trimesh, json, numpy
out = {}
for name in ["a.obj", "a.off", "b.ply", "t.ply"]:
    m = trimesh.load(name, process=False, maintain_order=True, force="mesh")
    out[name] = [m.vertices.tolist(), m.faces.tolist()]
m = trimesh.Trimesh([[0.1, 0, 0], [1, 0, 0.5], [1, 1, 0.25]], [[0, 1, 2]], process=False,
    vertex_colors=[[255, 0, 0, 255], [0, 255, 0, 255], [0, 0, 255, 128]])
m.export("theirs.obj", digits=17)
m.export("theirs.off", digits=17)
m.export("theirs_b.ply")
m.export("theirs_t.ply", encoding="ascii")
print(json.dumps(out))
"#;
    let out = peers::run(python, folder.path(), script);
    let mesh = sample();
    for name in ["a.obj", "a.off", "b.ply", "t.ply"] {
        assert_eq!(out[name][0], coordinates(&mesh), "{name}");
        assert_eq!(out[name][1], corners(&mesh), "{name}");
    }
    for name in ["theirs.obj", "theirs.off", "theirs_b.ply", "theirs_t.ply"] {
        let mesh = read(&folder.path().join(name));
        assert!(
            (mesh.vertices.points[0].x - 0.1).abs() < 1e-7,
            "{name}: {mesh:?}"
        );
        assert_eq!(
            mesh.vertices.points[1..],
            [(1.0, 0.0), (1.0, 1.0)].map(Point::from),
            "{name}"
        );
        assert_eq!(corners(&mesh), json!([[0, 1, 2]]), "{name}");
        if name.ends_with("off") {
            continue; // It writes no colours there.
        }
        let red = mesh.vertices.attributes.iter().find(|a| a.name == "red");
        let red = red.unwrap_or_else(|| panic!("{name} has colours"));
        assert!(red.values[0] > red.values[1], "{name}");
    }
}

#[test]
fn meshio_reads_ours_and_we_read_its() {
    let Some(python) = peers::python(&["meshio", "numpy", "json"]) else {
        return;
    };
    let folder = tempfile::tempdir().expect("folder");
    for (name, ascii) in [("a.off", false), ("b.ply", false), ("t.ply", true)] {
        // It takes no elements but vertices and faces, and of faces in bytes nothing but corners.
        let mesh = MeshData {
            constraints: None,
            triangle_attributes: Vec::new(),
            ..sample()
        };
        write(folder.path(), name, ascii, &mesh);
    }
    let script = r#"
import meshio, json, numpy
out = {}
for name in ["a.off", "b.ply", "t.ply"]:
    m = meshio.read(name)
    out[name] = [m.points.tolist(), m.cells_dict["triangle"].tolist()]
m = meshio.read("b.ply")
out["heat"] = m.point_data["heat"].tolist()
m = meshio.Mesh(numpy.array([[0.1, 0, 0], [1, 0, 0.5], [1, 1, 0.25]]), [("triangle", numpy.array([[0, 1, 2]], dtype=numpy.int32))],
    point_data={"heat": numpy.array([1.5, 2.5, 3.5])})
for name, options in [("theirs.off", {}), ("theirs.obj", {}), ("theirs_b.ply", {"binary": True}), ("theirs_t.ply", {"binary": False})]:
    m.write(name, **options)
print(json.dumps(out))
"#;
    let out = peers::run(python, folder.path(), script);
    let mesh = sample();
    for name in ["a.off", "b.ply", "t.ply"] {
        assert_eq!(out[name][0], coordinates(&mesh), "{name}");
        assert_eq!(out[name][1], corners(&mesh), "{name}");
    }
    assert_eq!(out["heat"], json!([1.1, 2.2, 3.3, 4.4]));
    for name in ["theirs.off", "theirs.obj", "theirs_b.ply", "theirs_t.ply"] {
        let mesh = read(&folder.path().join(name));
        assert_eq!(
            coordinates(&mesh),
            json!([[0.1, 0.0, 0.0], [1.0, 0.0, 0.5], [1.0, 1.0, 0.25]]),
            "{name}"
        );
        assert_eq!(corners(&mesh), json!([[0, 1, 2]]), "{name}");
        let heat = mesh.vertices.attributes.iter().find(|a| a.name == "heat");
        assert_eq!(heat.is_some(), name.ends_with("ply"), "{name}");
    }
}

/// VTK reads and writes floats of 32 bits.
#[test]
fn pyvista_reads_ours_and_we_read_its() {
    let Some(python) = peers::python(&["pyvista", "json"]) else {
        return;
    };
    let folder = tempfile::tempdir().expect("folder");
    for (name, ascii) in [("a.obj", false), ("b.ply", false), ("t.ply", true)] {
        write(folder.path(), name, ascii, &sample());
    }
    let script = r#"
import pyvista, json
out = {}
for name in ["a.obj", "b.ply", "t.ply"]:
    m = pyvista.read(name)
    out[name] = [m.points.tolist(), m.regular_faces.tolist() if name.endswith("ply") else [c.point_ids for c in m.cell if c.n_points == 3]]
m = pyvista.PolyData([[0.5, 0, 0], [1, 0, 0.5], [1, 1, 0.25]], faces=[3, 0, 1, 2])
m.save("theirs_b.ply")
m.save("theirs_t.ply", binary=False)
m.save("theirs.obj")
print(json.dumps(out))
"#;
    let out = peers::run(python, folder.path(), script);
    let mesh = sample();
    for name in ["a.obj", "b.ply", "t.ply"] {
        assert_eq!(out[name][1], corners(&mesh), "{name}");
        let ours = coordinates(&mesh);
        let [theirs, ours] = [&out[name][0], &ours].map(|rows| {
            let rows = rows.as_array().expect("rows").iter();
            let numbers = rows.flat_map(|row| row.as_array().expect("row").clone());
            numbers
                .map(|v| v.as_f64().expect("number") as f32)
                .collect::<Vec<_>>()
        });
        assert_eq!(theirs, ours, "{name}");
    }
    for name in ["theirs_b.ply", "theirs_t.ply", "theirs.obj"] {
        let mesh = read(&folder.path().join(name));
        assert_eq!(
            coordinates(&mesh),
            json!([[0.5, 0.0, 0.0], [1.0, 0.0, 0.5], [1.0, 1.0, 0.25]]),
            "{name}"
        );
        assert_eq!(corners(&mesh), json!([[0, 1, 2]]), "{name}");
    }
}
