//! Parquet, shapefiles and bare arrays of numbers through the program.

mod support;

use support::Folder;

/// Puts a file of the tests of the reader into a folder.
fn bring(folder: &Folder, name: &str) {
    let path = format!(
        "{}/../delone-io/tests/data/gis/{name}",
        env!("CARGO_MANIFEST_DIR")
    );
    folder.write(name, std::fs::read(path).expect("a fixture"));
}

#[test]
fn a_mesh_in_parquet_is_checked_and_converted() {
    let folder = Folder::with_points();
    folder.run("triangulate points.csv -o m.parquet -o m.ele", 0);
    let names = folder.names();
    assert!(names.contains(&"m.points.parquet".to_owned()), "{names:?}");
    folder.run("check m.parquet", 0);
    folder.run("convert m.parquet back.ele", 0);
    assert_eq!(folder.read("back.ele"), folder.read("m.ele"));
    folder
        .run("triangulate m.parquet -o again.ele", 0)
        .says(&["only the points in m.points.parquet are used"]);
    assert_eq!(folder.read("again.ele"), folder.read("m.ele"));
    // Its own points are not written over.
    folder.run("convert m.parquet m.points.parquet", 2);
}

#[test]
fn segments_in_parquet_come_along() {
    let folder = Folder::new();
    bring(&folder, "fields.parquet");
    folder.run("mesh fields.parquet --max-area 2 -o m.parquet", 0);
    assert!(folder.names().contains(&"m.segments.parquet".to_owned()));
    folder.run("convert m.parquet m.vtu", 0);
    let vtu = folder.read("m.vtu");
    assert!(vtu.contains("Name=\"marker\""), "{vtu}");
}

#[test]
fn a_shapefile_says_what_it_leaves_out() {
    let folder = Folder::new();
    for name in ["fields.shp", "fields.dbf"] {
        bring(&folder, name);
    }
    let output = folder.run("mesh fields.shp -o m.geojson", 0);
    output.says(&["left out, because they hold no numbers of points: crop, yield"]);
}

#[test]
fn arrays_of_numbers_are_triangulated() {
    let folder = Folder::with_points();
    folder.write("a.json", "[[0,0],[4,0],[4,3],[0,3],[1,1],[1,1]]");
    folder.run("triangulate a.json -o a.ele", 0);
    folder.run("triangulate points.csv -o b.ele", 0);
    assert_eq!(folder.read("a.ele"), folder.read("b.ele"));
}
