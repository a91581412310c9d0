//! Files in memory that lie beside each other.

use delone_io::{Error, LogFormat, MemoryFile, ReadOptions, Source, read_domain, read_mesh};

const NODE: &str = "4 2 0 0\n1 0 0\n2 4 0\n3 4 4\n4 0 4\n";
const ELE: &str = "2 3 0\n1 1 2 3\n2 1 3 4\n";
const POLY: &str = "0 2 0 0\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n";

fn together(files: &[(&str, &str)]) -> Source {
    let file = |&(name, text): &(&str, &str)| MemoryFile {
        name: name.into(),
        bytes: text.into(),
    };
    Source::Together {
        files: files.iter().map(file).collect(),
        opened: 0,
    }
}

#[test]
fn a_mesh_finds_its_vertices_and_segments() {
    let options = ReadOptions::default();
    for first in [("a.ele", ELE), ("a.node", NODE)] {
        let source = together(&[first, ("A.POLY", POLY), ("a.ele", ELE), ("a.node", NODE)]);
        let mesh = read_mesh(&source, &options, &()).expect("a mesh");
        assert_eq!((mesh.vertices.points.len(), mesh.triangles.len()), (4, 2));
        assert_eq!(mesh.constraints.expect("segments").edges.len(), 4);
    }
}

#[test]
fn segments_find_their_points() {
    let source = together(&[("a.poly", POLY), ("a.node", NODE)]);
    let domain = read_domain(&source, &ReadOptions::default(), &()).expect("a domain");
    assert_eq!(
        (domain.vertices.points.len(), domain.segments.len()),
        (4, 4)
    );
}

#[test]
fn whoever_is_missing_is_named() {
    let options = ReadOptions::default();
    let error = read_mesh(
        &together(&[("a.ele", ELE), ("b.node", NODE)]),
        &options,
        &(),
    );
    let error = error.expect_err("no a.node");
    assert!(matches!(error, Error::Alone { .. }));
    assert_eq!(error.to_string(), "a.ele needs a.node: open both together");
    let error = read_domain(&together(&[("a.poly", POLY)]), &options, &());
    assert!(matches!(error, Err(Error::Alone { needed, .. }) if needed == "a.node"));
    read_domain(&together(&[]), &options, &()).expect_err("no file at all");
    assert!(!LogFormat::is_log(br#"{"type":"FeatureCollection"}"#));
}
