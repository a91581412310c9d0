//! Files that others wrote: read in full, and meshes keep their triangles through our writers.

use delone::VertexId;
use delone_io::{
    MeshView, ReadOptions, Source, Target, WriteOptions, read_domain, read_mesh, read_points,
    write_mesh,
};
use std::collections::BTreeSet;
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

/// Files with the numbers of points and of segments that the table of the shared data states, where
/// equal points, equal segments and those of no length count once.
const FACTS: &[(&str, usize, usize)] = &[
    ("wkt/africa.wkt", 10_984, 11_031),
    ("wkt/uk.wkt", 1684, 1686),
    ("wkt/bc-250k.wkt", 116, 204),
    ("wkt/plane.wkt", 258, 257),
    ("wkt/europe.wkt", 25_193, 25_231),
    ("wkt/louisiana.wkt", 1349, 1349),
    ("wkt/norway_main.wkt", 8853, 8853),
    ("wkt/nl_plots.wkt", 1586, 1885),
    ("geojson/vertical_ulp_slopes2.geojson", 399, 435),
    ("geojson/many_rects.geojson", 196, 230),
    ("geojson/issue71.geojson", 130, 132),
    ("geojson/overlapping_segments2.geojson", 72, 90),
    ("triangle/A.poly", 29, 29),
    ("triangle/double_hex.poly", 96, 96),
    ("triangle/face.poly", 26, 22),
    ("earcut/bad-diagonals.json", 8, 10),
    ("earcut/boxy.json", 61, 64),
    ("earcut/collinear-diagonal.json", 20, 24),
    ("earcut/dude.json", 104, 104),
    ("earcut/eberly-3.json", 72, 73),
    ("earcut/empty-square.json", 4, 4),
    ("earcut/hilbert.json", 1026, 1026),
    ("earcut/hourglass.json", 5, 6),
    // The table leaves out the ring of two positions, which is a line here, with two further points.
    ("earcut/issue107.json", 9, 8),
    ("earcut/issue119.json", 14, 16),
    ("earcut/issue142.json", 10, 11),
    ("earcut/issue149.json", 9, 11),
    ("earcut/issue17.json", 11, 11),
    ("earcut/issue29.json", 40, 40),
    ("earcut/issue35.json", 790, 790),
    ("earcut/issue52.json", 101, 101),
    ("earcut/outside-ring.json", 64, 66),
    ("earcut/self-tangent-1.json", 22, 23),
    ("earcut/self-tangent-3.json", 141, 147),
    ("earcut/self-touching.json", 120, 122),
    ("earcut/simplified-us-border.json", 122, 124),
    ("earcut/touching-holes.json", 47, 49),
    ("earcut/touching-holes3.json", 57, 82),
    ("earcut/touching-holes5.json", 109, 160),
    ("earcut/touching2.json", 9, 9),
    ("earcut/touching4.json", 15, 16),
    // As above: rings of one position are points here, those of two lines.
    ("earcut/water-huge2.json", 4521, 4342),
    ("earcut/water.json", 2501, 2501),
    ("earcut/water3.json", 202, 202),
    ("earcut/water4.json", 708, 708),
    ("delaunator/issue13.json", 17, 0),
    ("delaunator/issue43.json", 5, 0),
    ("delaunator/robustness1.json", 79, 0),
    ("delaunator/robustness2.json", 968, 0),
    ("delaunator/ukraine.json", 867, 0),
    ("delaunator-rs/basic.json", 867, 0),
    ("delaunator-rs/grid.json", 30, 0),
    ("delaunator-rs/issue10.json", 20, 0),
    ("delaunator-rs/issue11js.json", 7, 0),
    ("delaunator-rs/issue24.json", 4, 0),
];

#[test]
fn domains_are_read_as_their_facts_say() {
    for &(name, points, segments) in FACTS {
        let (folder, file) = name.split_once('/').expect("a folder");
        let Some(folder) = shared(folder) else { return };
        let source = Source::from_arg(folder.join(file));
        let domain = read_domain(&source, &ReadOptions::default(), &());
        let domain = domain.unwrap_or_else(|error| panic!("{error}"));
        let place = |v: VertexId| {
            let p = domain.vertices.points[v.index()];
            [p.x.to_bits(), p.y.to_bits()]
        };
        let all = (0..domain.vertices.points.len()).map(VertexId::new);
        let distinct: BTreeSet<_> = all.map(place).collect();
        let edges = domain.segments.iter().map(|s| s.map(place));
        let edges = edges
            .filter(|[a, b]| a != b)
            .map(|[a, b]| [a.min(b), a.max(b)]);
        let edges: BTreeSet<_> = edges.collect();
        assert_eq!((distinct.len(), edges.len()), (points, segments), "{name}");
    }
}

#[test]
fn domains_of_every_file_are_read() {
    for (folder, at_least) in [("natural-earth", 15), ("triangle", 10), ("nasty", 20)] {
        let Some(folder) = shared(folder) else { return };
        let mut read = 0;
        for path in files(&folder, &["poly", "geojson"]) {
            let domain = read_domain(&Source::from_arg(&path), &ReadOptions::default(), &());
            let domain = domain.unwrap_or_else(|error| panic!("{error}"));
            assert!(!domain.vertices.points.is_empty(), "{}", path.display());
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
