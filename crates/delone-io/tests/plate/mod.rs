//! The plate of `data/fem`, as every program has it: two squares side by side.

use delone::VertexId;
use delone_io::{Error, MeshData, ReadOptions, Source, read_mesh};
use std::collections::BTreeMap;
use std::path::Path;

/// How many points and triangles it has.
pub const POINTS: usize = 21;
pub const TRIANGLES: usize = 28;

/// Reads a file.
pub fn read(path: &Path) -> Result<MeshData, Error> {
    read_mesh(&Source::from_arg(path), &ReadOptions::default(), &())
}

/// Requires that a file holds the plate, with what its format and its maker can say about it.
pub fn check(path: &Path) {
    let name = path.file_name().expect("a name").to_string_lossy();
    let mesh = read(path).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(mesh.vertices.points.len(), POINTS, "{name}");
    let area: f64 = (0..mesh.triangles.len()).map(|t| area(&mesh, t)).sum();
    assert!((area - 2.0).abs() < 1e-12, "{name}: {area}");
    assert_eq!(mesh.triangles.len(), TRIANGLES, "{name}");
    if name.ends_with(".msh") {
        check_groups(&mesh, &name);
    } else if name != "gmsh.vtk" {
        check_data(&mesh, &name);
    }
    let is_quadratic = ["-2.msh", "-2p.msh"].iter().any(|end| name.ends_with(end));
    assert_eq!(mesh.quadratic, is_quadratic, "{name}");
}

fn area(mesh: &MeshData, t: usize) -> f64 {
    let [a, b, c] = mesh.triangles[t].map(|v| mesh.vertices.points[v.index()]);
    ((b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y)) / 2.0
}

/// Of Gmsh's files: an area of one in either region, and lengths by marker.
fn check_groups(mesh: &MeshData, name: &str) {
    let regions = &mesh.triangle_attributes[0];
    assert_eq!(regions.name, "region", "{name}");
    for region in [2.0, 5.0] {
        let of = (0..mesh.triangles.len()).filter(|&t| regions.values[t] == region);
        let area: f64 = of.map(|t| area(mesh, t)).sum();
        assert!(
            (area - 1.0).abs() < 1e-12,
            "{name}: region {region} has {area}"
        );
    }
    let graph = mesh.constraints.as_ref().expect("lines");
    let markers = graph.markers.as_ref().expect("markers");
    let mut lengths = BTreeMap::new();
    for (&marker, ends) in markers.iter().zip(&graph.edges) {
        let [a, b] = ends.map(|v: VertexId| mesh.vertices.points[v.index()]);
        *lengths.entry(marker).or_insert(0.0) += (a.x - b.x).hypot(a.y - b.y);
    }
    let lengths: Vec<_> = lengths.into_iter().collect();
    let expected = [(1, 5.0), (7, 1.0), (9, 1.0)];
    for ((marker, length), expected) in lengths.iter().zip(expected) {
        assert!(
            *marker == expected.0 && (length - expected.1).abs() < 1e-12,
            "{name}: {lengths:?}"
        );
    }
    assert_eq!(lengths.len(), 3, "{name}");
}

/// Of other files: data of points that come from their places, and the number of each triangle.
fn check_data(mesh: &MeshData, name: &str) {
    let points = &mesh.vertices.points;
    let data = |wanted: &str| {
        let found = mesh.vertices.attributes.iter().find(|a| a.name == wanted);
        &found
            .unwrap_or_else(|| panic!("{name} lacks {wanted}"))
            .values
    };
    for (i, p) in points.iter().enumerate() {
        // VTK writes such numbers with six digits, and others with as many as they need, or eleven.
        assert!((data("t")[i] - p.x).abs() < 1e-5, "{name}");
        let v = ["v_0", "v_1", "v_2"].map(|component| data(component)[i]);
        let away = [v[0] - 2.0 * p.x, v[1] - 2.0 * p.y, v[2]];
        assert!(away.iter().all(|d| d.abs() < 1e-9), "{name}: {away:?}");
        if name.starts_with("vtk") {
            let away = data("with blank")[i] - p.x - 1.0;
            assert!(away.abs() < 1e-9, "{name}: {away}");
        }
    }
    if name != "vtk-strips.vtk" {
        let ids = &mesh
            .triangle_attributes
            .iter()
            .find(|a| a.name == "id")
            .expect("id")
            .values;
        assert!(
            ids.iter().zip(0..).all(|(&id, t)| id == f64::from(t)),
            "{name}: {ids:?}"
        );
        let lines = mesh.constraints.as_ref().expect("lines").edges.len();
        assert_eq!(lines, 14, "{name}");
    }
}
