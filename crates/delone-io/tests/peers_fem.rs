//! Gmsh, meshio and VTK read what we write, with equal numbers, and we read all that they write.
//!
//! Runs only where `DELONE_PYTHON` names a Python that has them.

mod peers;
mod plate;

use delone::VertexId;
use delone_io::{Attribute, MeshData, MeshView, Target, WriteOptions, write_mesh};
use serde_json::Value;
use std::path::{Path, PathBuf};

/// Runs a script of the fixtures; `None` if the programs are absent.
fn python(script: &str, arguments: &[PathBuf]) -> Option<String> {
    let mut python = peers::python(&["gmsh", "meshio", "vtk", "numpy"])?;
    let fixtures = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/fem");
    Some(peers::said(
        python.arg(fixtures.join(script)).args(arguments),
    ))
}

#[test]
fn all_that_they_write_is_read() {
    let folder = tempfile::tempdir().expect("folder");
    if python("make.py", &[folder.path().to_owned()]).is_none() {
        return;
    }
    let entries = std::fs::read_dir(folder.path()).expect("folder");
    let mut checked = 0;
    for path in entries.map(|entry| entry.expect("entry").path()) {
        let name = path
            .file_name()
            .expect("name")
            .to_string_lossy()
            .into_owned();
        // Text is not compressed, whatever its file says about compression.
        let is_refused = name.contains("lzma") || name.contains("lz4") || name.contains("quads");
        match is_refused {
            true => assert!(plate::read(&path).is_err(), "{name}"),
            false => plate::check(&path),
        }
        checked += 1;
    }
    assert!(checked > 100, "{checked}");
}

fn sample() -> MeshData {
    let fixture = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/fem/gmsh-41-1.msh");
    let mut mesh = plate::read(&fixture).expect("readable");
    let values = mesh
        .vertices
        .points
        .iter()
        .map(|p| p.x / 3.0 + 1e-17)
        .collect();
    mesh.vertices.attributes = vec![Attribute {
        name: "heat".to_owned(),
        values,
    }];
    mesh.vertices.markers = Some((0..plate::POINTS as i32).map(|i| i * i - 50).collect());
    let values = (0..plate::TRIANGLES)
        .map(|t| 1.0 / (t as f64 + 1.0))
        .collect();
    mesh.triangle_attributes.push(Attribute {
        name: "id".to_owned(),
        values,
    });
    mesh
}

#[test]
fn they_read_what_we_write() {
    let folder = tempfile::tempdir().expect("folder");
    let mesh = sample();
    let mut bare = mesh.clone();
    bare.triangle_attributes.truncate(1);
    let mut files = Vec::new();
    for (mesh, names, ascii) in [
        (&mesh, &["a.msh", "a.msh2", "a.vtk", "a.vtu"][..], false),
        (&mesh, &["t.vtk"], true),
        (&bare, &["plain.msh", "plain.msh2"], false),
    ] {
        let paths: Vec<_> = names.iter().map(|name| folder.path().join(name)).collect();
        let targets: Vec<_> = paths
            .iter()
            .map(|path| Target::from_arg(path, None))
            .collect();
        let options = WriteOptions {
            ascii,
            ..WriteOptions::default()
        };
        write_mesh(&targets, &MeshView::from(mesh), &options, &()).expect("writable");
        files.extend(paths);
    }
    let Some(answers) = python("read.py", &files) else {
        return;
    };
    let answers: Vec<Value> = serde_json::from_str(&answers).expect("JSON");
    assert_eq!(answers.len(), 12);
    for answer in &answers {
        compare(answer, &mesh);
    }
}

/// Requires that a program has read what was written.
fn compare(answer: &Value, mesh: &MeshData) {
    let who = format!("{} of {}", answer["reader"], answer["file"]);
    let is_bare = who.contains("plain");
    // Nodes and elements stand in blocks in a .msh, which meshio numbers as they come.
    let is_reordered = answer["reader"] == "by_meshio" && is_bare;
    let read = |value: &Value| -> Vec<f64> {
        let read = serde_json::from_value(value.clone());
        read.unwrap_or_else(|error| panic!("{who}: {error}"))
    };
    let rows = |key: &str| -> Vec<Vec<f64>> {
        let rows = answer[key].as_array().expect("rows");
        rows.iter().map(read).collect()
    };
    let points: Vec<_> = mesh
        .vertices
        .points
        .iter()
        .map(|p| vec![p.x, p.y])
        .collect();
    // For each point as read its number here.
    let number = |found: Vec<f64>| {
        points
            .iter()
            .position(|p| *p == found)
            .expect("a point of ours")
    };
    let numbers: Vec<usize> = rows("points").into_iter().map(number).collect();
    assert!(
        is_reordered || numbers.iter().copied().eq(0..points.len()),
        "{who}"
    );
    let cells = |key: &str| {
        let rows = rows(key).into_iter();
        let mut cells: Vec<Vec<usize>> = rows
            .map(|row| row.into_iter().map(|v| numbers[v as usize]).collect())
            .collect();
        if is_reordered {
            cells.sort();
        }
        cells
    };
    let ours = |corners: Vec<Vec<usize>>| {
        let mut corners = corners;
        if is_reordered {
            corners.sort();
        }
        corners
    };
    let graph = mesh.constraints.as_ref().expect("lines");
    let triangles = mesh
        .triangles
        .iter()
        .map(|t| t.map(VertexId::index).to_vec());
    let lines = graph.edges.iter().map(|e| e.map(VertexId::index).to_vec());
    assert_eq!(cells("triangles"), ours(triangles.collect()), "{who}");
    assert_eq!(cells("lines"), ours(lines.collect()), "{who}");

    let of_points = |name: &str| {
        let values = read(&answer["data"][name]);
        let mut sorted = vec![f64::NAN; points.len()];
        numbers
            .iter()
            .zip(values)
            .for_each(|(&v, value)| sorted[v] = value);
        sorted
    };
    assert_eq!(
        of_points("heat"),
        mesh.vertices.attributes[0].values,
        "{who}"
    );
    let markers: Vec<f64> = mesh
        .vertices
        .markers
        .iter()
        .flatten()
        .map(|&m| m.into())
        .collect();
    assert_eq!(of_points("marker"), markers, "{who}");
    if !is_bare {
        let ids = read(&answer["cells"]["id"]);
        assert_eq!(ids, mesh.triangle_attributes[1].values, "{who}");
    }
    if answer["reader"] == "by_gmsh" {
        assert_eq!(answer["warnings"], Value::Array(Vec::new()), "{who}");
        let expected = serde_json::json!({
            "marker 1": [1, 1, 10], "marker 7": [1, 7, 2], "marker 9": [1, 9, 2],
            "region 2": [2, 2, 14], "region 5": [2, 5, 14],
        });
        assert_eq!(answer["groups"], expected, "{who}");
    }
}
