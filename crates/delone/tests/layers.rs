//! The layering of the library: topology knows no coordinates, geometry knows no topology.

use std::path::{Path, PathBuf};

/// Asserts that the code of a room, comments aside, never says any of the words.
fn assert_never_says(room: &str, words: &[&str]) {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src").join(room);
    let files = rust_files(&root);
    assert!(!files.is_empty(), "no room {room}");
    for file in files {
        let text = std::fs::read_to_string(&file).expect("readable source");
        for (number, line) in text.lines().enumerate() {
            let code = line.split("//").next().unwrap_or_default();
            let mut tokens = code.split(|c: char| !c.is_alphanumeric() && c != '_');
            let said = tokens.find(|token| words.contains(token));
            assert!(said.is_none(), "{}:{}: {line}", file.display(), number + 1);
        }
    }
}

fn rust_files(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in std::fs::read_dir(folder).expect("a room is a folder") {
        let path = entry.expect("readable folder").path();
        if path.is_dir() {
            files.extend(rust_files(&path));
        } else if path.extension().is_some_and(|e| e == "rs") {
            files.push(path);
        }
    }
    files
}

#[test]
fn mesh_knows_no_coordinates() {
    let words = [
        "Point",
        "point",
        "predicates",
        "f64",
        "f32",
        "orient2d",
        "in_circle",
    ];
    assert_never_says("mesh", &words);
}

#[test]
fn predicates_know_no_topology() {
    let words = ["mesh", "Mesh", "VertexId", "HalfEdgeId", "TriangleId"];
    assert_never_says("predicates", &words);
}

#[test]
fn check_shares_nothing_with_the_builders() {
    assert_never_says("check", &["delaunay", "Incremental", "locate"]);
}
