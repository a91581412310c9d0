//! Gmsh: groups, tags and what else its files say.

use super::{fixture, mesh_of, plate};
use delone_io::{ReadOptions, Source, read_mesh};

/// A triangle by hand.
pub const MSH: &str = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n10 0 0 0\n20 1 0 0\n40 0 1 5\n$EndNodes\n\
$Elements\n1\n7 2 2 3 1 10 20 40\n$EndElements\n";

#[test]
fn what_gmsh_says_besides_is_noted() {
    let notes = |name| {
        plate::read(&fixture(name))
            .expect("readable")
            .vertices
            .notes
    };
    let names =
        "names of groups are not kept: marker 1 \"wall\", marker 7 \"inlet\", region 2 \"steel\"";
    assert_eq!(notes("gmsh-41-1.msh"), [names]);
    assert_eq!(notes("gmsh-parts.msh"), ["partitions are not kept", names]);
    for name in ["gmsh-data.msh", "gmsh-datab.msh"] {
        let mesh = plate::read(&fixture(name)).expect("readable");
        let pressure = &mesh.vertices.attributes[0];
        assert_eq!(pressure.name, "pressure");
        for (p, value) in mesh.vertices.points.iter().zip(&pressure.values) {
            // Gmsh writes 16 digits.
            assert!((value - p.x * 3.0 - 0.1).abs() < 1e-14);
        }
        let names: Vec<_> = mesh
            .triangle_attributes
            .iter()
            .map(|a| a.name.as_str())
            .collect();
        assert_eq!(names, ["region", "flux_0", "flux_1", "flux_2"]);
        assert!(mesh.triangle_attributes[2].values.iter().all(|&v| v == 1.0));
    }
}

#[test]
fn of_several_groups_the_first_is_kept_and_that_is_said() {
    const TWICE: &str = "triangles that are there twice are kept once: 1";
    const FIRST: &str = "of elements in several physical groups only the first group is kept";
    // In version 2 an element of several groups is there once for each.
    let triangle = "7 2 2 3 1 10 20 40\n";
    for (elements, expected) in [
        ("8 2 2 5 1 20 40 10\n", &[TWICE, FIRST][..]),
        ("8 2 2 3 1 10 20 40\n", &[TWICE]),
        ("1 1 2 6 1 10 20\n2 1 2 9 1 20 10\n", &[FIRST]),
        ("1 1 2 6 1 10 20\n2 1 2 6 1 20 10\n", &[]),
        ("1 15 2 4 1 10\n2 15 2 8 1 10\n", &[FIRST]),
        ("1 15 2 4 1 10\n2 1 2 9 1 10 20\n", &[]),
    ] {
        let count = 1 + elements.lines().count();
        let text = MSH.replace(
            &format!("1\n{triangle}"),
            &format!("{count}\n{triangle}{elements}"),
        );
        let name = "a.msh".to_owned();
        let bytes = text.into_bytes();
        let source = Source::Memory { name, bytes };
        let mesh = read_mesh(&source, &ReadOptions::default(), &()).expect("a mesh");
        assert_eq!(mesh.vertices.notes, expected, "{elements}");
        assert_eq!(mesh.triangles.len(), 1, "{elements}");
        assert_eq!(mesh.triangle_attributes[0].values, [3.0], "{elements}");
        if elements.starts_with("1 1 ") {
            let markers = mesh.constraints.expect("a segment").markers;
            assert_eq!(markers, Some(vec![6]), "{elements}");
        }
        if elements.starts_with("1 15 ") {
            let markers = mesh.vertices.markers.expect("markers");
            assert_eq!(markers[0], 4, "{elements}");
        }
    }
}

#[test]
fn triangles_of_several_groups_are_kept_once() {
    let twice = MSH.replace(
        "$Elements\n1\n7 2 2 3 1 10 20 40\n",
        "$Elements\n3\n7 2 2 3 1 10 20 40\n8 2 2 3 1 40 20 10\n9 2 2 5 1 20 10 40\n",
    );
    let more = twice
        .replace("40 0 1 5\n", "40 0 1 5\n41 2 2 0\n")
        .replace("$Nodes\n3", "$Nodes\n4");
    let more = more.replace("8 2 2 3 1 40 20 10", "8 2 2 3 1 10 40 41");
    let mesh = mesh_of("a.msh", &more).expect("a mesh");
    assert_eq!(mesh.triangles.len(), 2);
    assert_eq!(mesh.triangle_attributes[0].values, [3.0, 3.0]);
    assert_eq!(
        mesh.vertices.notes,
        [
            "triangles that are there twice are kept once: 1",
            "of elements in several physical groups only the first group is kept"
        ]
    );
    let mesh = mesh_of("a.msh", &twice).expect("a mesh");
    assert_eq!(
        mesh.vertices.notes,
        [
            "triangles that are there twice are kept once: 2",
            "of elements in several physical groups only the first group is kept"
        ]
    );
}

#[test]
fn tags_may_have_gaps_and_heights_are_kept() {
    let mesh = mesh_of("a.msh", MSH).expect("a mesh");
    assert_eq!(mesh.vertices.attributes[0].name, "z");
    assert_eq!(mesh.vertices.attributes[0].values, [0.0, 0.0, 5.0]);
    assert_eq!(mesh.triangle_attributes[0].values, [3.0]);
    assert_eq!(mesh.vertices.base, 0);
    let data = "$NodeData\n1\n\"id\"\n1\n0.5\n3\n0\n1\n3\n10 7\n20 8\n40 9\n$EndNodeData\n";
    let with_data = mesh_of("a.msh", &format!("{MSH}{data}"))
        .expect("a mesh")
        .vertices;
    assert_eq!(with_data.attributes[1].name, "id");
    assert_eq!(with_data.attributes[1].values, [7.0, 8.0, 9.0]);
    assert_eq!(with_data.markers, None, "whole numbers of another name");
    for (tags, base) in [([1, 2, 3], 1), ([2, 3, 4], 0), ([1, 2, 4], 0)] {
        let [a, b, c] = tags;
        let text = MSH.replace("10 20 40", &format!("{a} {b} {c}"));
        let text = text.replace("10 0 0 0", &format!("{a} 0 0 0"));
        let text = text.replace("20 1 0 0", &format!("{b} 1 0 0"));
        let text = text.replace("40 0 1 5", &format!("{c} 0 1 5"));
        let mesh = mesh_of("a.msh", &text).expect("a mesh");
        assert_eq!(mesh.vertices.base, base, "{tags:?}");
    }
}
