//! Meshes of other programs as inputs: taken for what they hold, everywhere.

mod support;

use std::path::Path;
use support::Folder;

/// A folder with files of the plate in it: two squares side by side, regions 2 and 5.
fn folder() -> Folder {
    let folder = Folder::new();
    let fixtures = Path::new(env!("CARGO_MANIFEST_DIR")).join("../delone-io/tests/data/fem");
    for (name, fixture) in [
        ("plate.msh", "gmsh-41b-1.msh"),
        ("plate.vtu", "vtk-raw-zlib-32be.vtu"),
    ] {
        let bytes = std::fs::read(fixtures.join(fixture)).expect("fixture");
        folder.write(name, bytes);
    }
    folder
}

/// A square with a square hole, as lines.
const OUTLINE: &str = "MSHID=3\nNDIMS=2\nPOINT=8\n0;0;0\n3;0;0\n3;3;0\n0;3;0\n1;1;0\n2;1;0\n2;2;0\n1;2;0\n\
EDGE2=8\n0;1;1\n1;2;1\n2;3;1\n3;0;1\n4;5;2\n5;6;2\n6;7;2\n7;4;2\n";

#[test]
fn a_mesh_is_checked_converted_and_refined() {
    let folder = folder();
    folder.run("check plate.msh", 0);
    folder.run("check plate.vtu", 0);
    folder
        .run("convert plate.msh p.ele", 0)
        .says(&["21 points and 28 triangles", "names of groups are not kept"]);
    let coarse = folder.run("check p.ele --json", 0).json();
    assert_eq!(coarse["triangles"], 28);
    folder.run("mesh plate.msh --max-edge 0.2 -o fine.msh", 0);
    let fine = folder.run("check fine.msh --json", 0);
    let triangles = fine.json()["triangles"].as_u64().expect("a count");
    assert!(triangles > 100, "{triangles}");
    // Constrained edges, their markers and regions are handed down.
    let text = folder.read("fine.msh");
    for name in [
        "\"marker 1\"",
        "\"marker 7\"",
        "\"marker 9\"",
        "\"region 2\"",
        "\"region 5\"",
    ] {
        assert!(text.contains(name), "{name}");
    }
}

#[test]
fn regions_are_taken_by_name() {
    let folder = folder();
    folder
        .run("convert plate.msh left.msh --region 2", 0)
        .says(&["14 triangles"]);
    let half = folder.run("check left.msh --json", 0).json();
    assert_eq!(half["triangles"], 14);
    assert!(!folder.read("left.msh").contains("\"marker 9\""));
    folder.run("mesh plate.msh --region 2 --max-edge 0.1 -o fine.vtu", 0);
    folder.run("check plate.msh --region 5,2", 0);
    folder
        .run("check plate.msh --region 3", 2)
        .says(&["plate.msh has no region 3; there are 2 and 5"]);
    folder.write("a.jig", OUTLINE);
    folder
        .run("mesh a.jig --region 3", 2)
        .says(&["--region: a.jig brings no triangles that have regions"]);
}

#[test]
fn lines_of_a_mesh_format_are_a_domain() {
    let folder = Folder::new();
    folder.write("outline.msh", OUTLINE);
    let figures = folder.run("triangulate outline.msh --json", 0).json();
    assert_eq!(
        (&figures["triangles"], &figures["segments"]),
        (&8.into(), &8.into())
    );
    folder
        .run("convert outline.msh o.vtk", 0)
        .says(&["8 points, 8 segments"]);
    folder
        .run("convert o.vtk o.poly", 0)
        .says(&["8 points, 8 segments"]);
    let again = folder.run("triangulate o.vtk --json", 0).json();
    assert_eq!(again["hash"], figures["hash"]);
    folder
        .run("convert outline.msh o.ele", 2)
        .says(&["outline.msh brings none"]);
}

#[test]
fn what_is_not_used_is_said() {
    let folder = folder();
    folder
        .run("triangulate plate.msh", 0)
        .says(&["only the points are used, triangles, segments and their data are not"]);
    folder.run("convert plate.msh p.ele", 0);
    folder
        .run("triangulate p.ele", 0)
        .says(&["the segments in p.poly are not"]);
    folder
        .run("convert plate.vtu p.csv", 0)
        .says(&["plate.vtu: only the points are used"]);
}

#[test]
fn content_comes_from_standard_input_too() {
    let folder = folder();
    let mut command = folder.command("check - --from msh --json");
    command.write_stdin(folder.bytes("plate.msh"));
    let json = support::Output::of(command.assert().code(0)).json();
    assert_eq!(json["triangles"], 28);
}
