//! Point clouds in, files for printers, pages and meshers out, seen from the shell.

mod support;

use std::path::Path;
use support::Folder;

/// A folder with a cloud of 237 points.
fn with_cloud() -> Folder {
    let folder = Folder::new();
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("../delone-io/tests/data/lidar");
    for name in ["seven.laz", "seven.csv"] {
        folder.write(name, std::fs::read(data.join(name)).expect("fixture"));
    }
    folder
}

#[test]
fn a_cloud_is_triangulated_by_class() {
    let folder = with_cloud();
    folder.run("triangulate seven.laz --class 2 -o ground.vtu", 0);
    folder.run(
        "triangulate seven.laz --class 2,6 --return last -o ground.ele",
        0,
    );
    let ground = folder.read("ground.node");
    let all = folder.read("seven.csv");
    let wanted = |line: &&str| {
        let cells: Vec<&str> = line.split(',').collect();
        matches!(cells[3], "2" | "6") && cells[5] == cells[6]
    };
    let count = all.lines().skip(1).filter(wanted).count();
    assert!(count > 10);
    assert!(ground.starts_with(&format!("{count} 2 ")), "{ground}");
    let none = folder.run("triangulate seven.laz --class 9 -o none.vtu", 3);
    none.says(&["none of the points is of the classes", "1, 2, 5, 6"]);
}

#[test]
fn what_formats_have_no_place_for_is_said() {
    let folder = with_cloud();
    let stl = folder.run("triangulate seven.laz -o s.stl", 0);
    stl.says(&[
        "s.stl: left out, for stl has no place: attribute classification, attribute intensity",
        "s.stl: coordinates are rounded to 32 bits",
    ]);
    let text = folder.run("triangulate seven.laz -o s.stl --ascii", 0);
    assert!(!text.stderr.contains("rounded"), "{}", text.stderr);
    assert!(folder.read("s.stl").starts_with("solid delone\n"));
    let medit = folder.run("triangulate seven.laz -o m.mesh", 0);
    medit.says(&["m.mesh: left out, for mesh has no place: attribute z, attribute classification"]);
    folder.run("triangulate seven.laz -o p.tikz", 0);
    assert!(folder.read("p.tikz").contains("\\begin{tikzpicture}"));
}
