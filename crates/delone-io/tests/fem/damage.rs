//! Broken files: refused with words, and never more than that.

use super::gmsh::MSH;
use super::jigsaw::JIGSAW;
use super::vtk::VTK;
use super::{fixture, fixtures, mesh_of};
use delone_io::{Constraints, ReadOptions, Source, read_domain, read_mesh};
use proptest::prelude::*;

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
