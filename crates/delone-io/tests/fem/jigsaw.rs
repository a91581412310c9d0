//! JIGSAW: outlines and meshes.

use super::mesh_of;
use delone::DomainRule;
use delone_io::{ReadOptions, Source, read_domain};
use std::path::{Path, PathBuf};

/// A square by hand.
pub const JIGSAW: &str = "# by hand\nMSHID=3;EUCLIDEAN-MESH\nNDIMS=2\nPOINT=4\n0;0;7\n1;0;0\n1;1;0\n0;1;0\n\
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
