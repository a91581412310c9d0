//! Files that others wrote: read in full, and meshes keep their triangles through our writers.

use delone_io::{
    MeshView, ReadOptions, Source, Target, WriteOptions, read_mesh, read_points, write_mesh,
};
use std::path::{Path, PathBuf};

/// Finds a folder of the shared data, or says that it is absent.
fn shared(folder: &str) -> Option<PathBuf> {
    let beside = || Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared");
    let root = std::env::var_os("DELONE_SHARED").map_or_else(beside, PathBuf::from);
    let path = root.join("data").join(folder);
    if !path.is_dir() {
        eprintln!("skipped: the shared data are absent (set DELONE_SHARED)");
        return None;
    }
    Some(path)
}

/// Lists the files of a folder with one of these extensions.
fn files(folder: &Path, extensions: &[&str]) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).expect("folder");
    let paths = entries.map(|entry| entry.expect("entry").path());
    let fits = |path: &PathBuf| {
        path.extension()
            .is_some_and(|e| extensions.iter().any(|x| e == *x))
    };
    let mut files: Vec<_> = paths.filter(fits).collect();
    files.sort();
    files
}

#[test]
fn points_of_every_file_are_read() {
    for (folder, at_least) in [("triangle", 20), ("nasty", 30), ("franke", 3), ("lidar", 3)] {
        let Some(folder) = shared(folder) else { return };
        let mut read = 0;
        for path in files(&folder, &["node", "poly", "csv", "xyz"]) {
            let set = read_points(&Source::from_arg(&path), &ReadOptions::default(), &());
            let set = set.unwrap_or_else(|error| panic!("{error}"));
            assert!(!set.points.is_empty(), "{}", path.display());
            read += 1;
        }
        assert!(read >= at_least, "{}: {read}", folder.display());
    }
}

#[test]
fn columns_of_a_point_cloud_become_attributes() {
    let Some(folder) = shared("lidar") else {
        return;
    };
    let source = Source::from_arg(folder.join("autzen-thin.xyz"));
    let set = read_points(&source, &ReadOptions::default(), &()).expect("a table");
    assert_eq!(set.points.len(), 10_653);
    assert_eq!(set.attributes[0].name, "z");
    assert_eq!(set.attributes[0].values[0], 422.24);
}

#[test]
fn meshes_of_triangle_survive_every_format() {
    let Some(folder) = shared("triangle") else {
        return;
    };
    let place = tempfile::tempdir().expect("folder");
    let ele = files(&folder, &["ele"]);
    assert!(ele.len() >= 10);
    for path in ele {
        let read = |path: &Path| {
            read_mesh(&Source::from_arg(path), &ReadOptions::default(), &()).expect("a mesh")
        };
        let mesh = read(&path);
        let written = ["m.ele", "m.npy", "m.vtu", "m.svg"].map(|name| place.path().join(name));
        let targets = written.clone().map(|path| Target::from_arg(path, None));
        write_mesh(
            &targets,
            &MeshView::from(&mesh),
            &WriteOptions::default(),
            &(),
        )
        .expect("written");
        for copy in &written[..3] {
            let copy = read(copy);
            assert_eq!(copy.triangles, mesh.triangles, "{}", path.display());
            assert_eq!(copy.vertices.points, mesh.vertices.points);
        }
    }
}
