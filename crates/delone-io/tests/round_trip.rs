//! What is written reads back the same, to the last bit.

use delone::{Point, VertexId};
use delone_io::{
    Attribute, Error, Format, LeftOut, Lines, MeshData, MeshView, PointSet, ReadOptions, Source,
    Target, WriteOptions, read_mesh, read_points, write_mesh, write_points,
};
use proptest::prelude::*;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU32, Ordering};

fn target(path: &Path) -> Target {
    Target::from_arg(path, None)
}

fn read_back(path: &Path) -> PointSet {
    let source = Source::from_arg(path);
    read_points(&source, &ReadOptions::default(), &()).expect("written by us")
}

fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![
        any::<f64>().prop_filter("finite", |v| v.is_finite()),
        (-1000i32..1000).prop_map(f64::from),
        Just(5e-324),
        Just(f64::MAX),
    ]
}

prop_compose! {
    fn point_set()(rows in prop::collection::vec((coordinate(), coordinate(), coordinate(), any::<i32>()), 1..40)) -> PointSet {
        PointSet {
            points: rows.iter().map(|r| Point::new(r.0, r.1)).collect(),
            attributes: vec![Attribute { name: "attribute1".to_owned(), values: rows.iter().map(|r| r.2).collect() }],
            markers: Some(rows.iter().map(|r| r.3).collect()),
            ..PointSet::default()
        }
    }
}

prop_compose! {
    fn mesh()(vertices in point_set(), seeds in prop::collection::vec(any::<[prop::sample::Index; 3]>(), 0..40)) -> MeshData {
        let n = vertices.points.len();
        let triangles: Vec<_> = seeds.iter().map(|t| t.map(|i| VertexId::new(i.index(n)))).collect();
        let values = (0..triangles.len()).map(|t| t as f64 / 3.0).collect();
        MeshData {
            vertices,
            triangle_attributes: if triangles.is_empty() { vec![] } else {
                vec![Attribute { name: "attribute1".to_owned(), values }]
            },
            triangles,
            constraints: None,
            quadratic: false,
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn points_survive_node_npy_and_csv(set in point_set(), one_based: bool) {
        let folder = tempfile::tempdir().expect("folder");
        let paths = ["a.node", "a.npy", "a.csv"].map(|name| folder.path().join(name));
        let options = WriteOptions { one_based, ..WriteOptions::default() };
        let written = write_points(&paths.clone().map(|p| target(&p)), &set, &options, &()).expect("written");
        prop_assert_eq!(written.len(), 3);
        let node = read_back(&paths[0]);
        prop_assert_eq!(node.base, u32::from(one_based));
        prop_assert_eq!(PointSet { base: 0, lines: Lines::default(), ..node }, set.clone());
        let npy = read_back(&paths[1]);
        prop_assert_eq!(&npy.points, &set.points);
        prop_assert_eq!(&npy.attributes[0].values, &set.attributes[0].values);
        prop_assert_eq!(&npy.attributes[1].values, &markers_of(&set));
        let csv = read_back(&paths[2]);
        prop_assert_eq!(&csv.points, &set.points);
        prop_assert_eq!(&csv.attributes[0], &set.attributes[0]);
        prop_assert_eq!(&csv.attributes[1].name, "marker");
    }

    #[test]
    fn tables_survive_with_every_separator(set in point_set()) {
        let folder = tempfile::tempdir().expect("folder");
        for extension in ["csv", "tsv", "tab", "xyz", "xy", "pts", "txt", "dat", "asc"] {
            let path = folder.path().join("a").with_extension(extension);
            write_points(&[target(&path)], &set, &WriteOptions::default(), &()).expect("written");
            let copy = read_back(&path);
            prop_assert_eq!(&copy.points, &set.points);
            prop_assert_eq!(&copy.attributes[0].values, &set.attributes[0].values);
            prop_assert_eq!(&copy.attributes[1].values, &markers_of(&set));
        }
    }

    #[test]
    fn meshes_survive_ele_npy_and_vtu(mesh in mesh(), one_based: bool) {
        let folder = tempfile::tempdir().expect("folder");
        let paths = ["a.ele", "a.npy", "a.vtu"].map(|name| folder.path().join(name));
        let options = WriteOptions { one_based, ..WriteOptions::default() };
        let view = MeshView::from(&mesh);
        let written = write_mesh(&paths.clone().map(|p| target(&p)), &view, &options, &()).expect("written");
        prop_assert_eq!(written.len(), 7);
        let read = |path: &PathBuf| read_mesh(&Source::from_arg(path), &ReadOptions::default(), &()).expect("written by us");
        let ele = read(&paths[0]);
        prop_assert_eq!(&ele.vertices.points, &mesh.vertices.points);
        prop_assert_eq!(&ele.vertices.markers, &mesh.vertices.markers);
        prop_assert_eq!(&ele.triangle_attributes, &mesh.triangle_attributes);
        prop_assert_eq!(&ele.triangles, &mesh.triangles);
        let mut node = read(&folder.path().join("a.node"));
        prop_assert_eq!(node.vertices.lines.of(0), Some(2));
        node.vertices.lines = Lines::default(); // which are those of another file
        prop_assert_eq!(&node, &ele);
        prop_assert_eq!(&read(&paths[2]), &mesh);
        let npy = read(&paths[1]);
        prop_assert_eq!(&npy.vertices.points, &mesh.vertices.points);
        prop_assert_eq!(&npy.triangles, &mesh.triangles);
    }
}

fn markers_of(set: &PointSet) -> Vec<f64> {
    let markers = set.markers.as_deref().unwrap_or_default();
    markers.iter().copied().map(f64::from).collect()
}

#[test]
fn the_extension_of_a_table_tells_its_separator() {
    let folder = tempfile::tempdir().expect("folder");
    let set = PointSet {
        points: vec![Point::new(1.0, 2.5)],
        attributes: vec![Attribute {
            name: "height, m".to_owned(),
            values: vec![3.0],
        }],
        ..PointSet::default()
    };
    for (name, expected) in [
        ("a.csv", "x,y,\"height, m\"\n1,2.5,3\n"),
        ("a.tsv", "x\ty\t\"height, m\"\n1\t2.5\t3\n"),
        ("a.xyz", "# x y \"height, m\"\n1 2.5 3\n"),
    ] {
        let path = folder.path().join(name);
        write_points(&[target(&path)], &set, &WriteOptions::default(), &()).expect("written");
        let text = std::fs::read_to_string(&path).expect("written");
        assert_eq!(text, expected);
        assert_eq!(read_back(&path).points, set.points);
    }
}

#[test]
fn no_points_keep_their_columns() {
    let folder = tempfile::tempdir().expect("folder");
    let path = folder.path().join("a.node");
    std::fs::write(&path, "0 2 2 1\n").expect("written");
    let set = read_back(&path);
    assert_eq!(set.attributes.len(), 2);
    assert_eq!(set.markers, Some(vec![]));
    write_points(&[target(&path)], &set, &WriteOptions::default(), &()).expect("written");
    assert_eq!(std::fs::read_to_string(&path).expect("file"), "0 2 2 1\n");
}

#[test]
fn duplicates_are_marked_as_the_vertex_that_stands_for_them() {
    let folder = tempfile::tempdir().expect("folder");
    let path = folder.path().join("a.node");
    let points = [(0.0, 0.0), (4.0, 0.0), (0.0, 4.0), (1.0, 1.0)];
    let twice = points.iter().chain(&points).copied();
    let t = delone::triangulate(twice.map(Point::from)).expect("finite");
    write_mesh(
        &[target(&path)],
        &MeshView::from(&t),
        &WriteOptions::default(),
        &(),
    )
    .expect("written");
    assert_eq!(read_back(&path).markers, Some(vec![1, 1, 1, 0, 1, 1, 1, 0]));
}

/// Two triangles over a square, and a vertex that belongs to none.
fn square() -> MeshData {
    let points = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (1.0, 1.0)];
    MeshData {
        vertices: PointSet {
            points: points.map(Point::from).to_vec(),
            ..PointSet::default()
        },
        triangles: [[0, 1, 2], [0, 2, 3]]
            .map(|t| t.map(VertexId::from))
            .to_vec(),
        ..MeshData::default()
    }
}

#[test]
fn the_family_is_written_as_triangle_does() {
    let folder = tempfile::tempdir().expect("folder");
    let mesh = square();
    let options = WriteOptions {
        one_based: true,
        ..WriteOptions::default()
    };
    let targets = [
        target(&folder.path().join("s.poly")),
        target(&folder.path().join("s.node")),
    ];
    let written = write_mesh(&targets, &MeshView::from(&mesh), &options, &()).expect("written");
    assert_eq!(written.len(), 4, "each file once: {written:?}");
    let text = |name: &str| std::fs::read_to_string(folder.path().join(name)).expect(name);
    assert_eq!(
        text("s.node"),
        "5 2 0 1\n1 0 0 1\n2 1 0 1\n3 1 1 1\n4 0 1 1\n5 1 1 0\n"
    );
    assert_eq!(text("s.ele"), "2 3 0\n1 1 2 3\n2 1 3 4\n");
    assert_eq!(text("s.neigh"), "2 3\n1 -1 2 -1\n2 -1 -1 1\n");
    assert_eq!(
        text("s.edge"),
        "5 1\n1 2 3 1\n2 3 1 0\n3 1 2 1\n4 3 4 1\n5 4 1 1\n"
    );
}

#[test]
fn columns_are_chosen_by_name_place_or_number() {
    let read = |text: &str, columns: Option<[&str; 2]>| {
        let source = Source::Memory {
            name: "a.csv".to_owned(),
            bytes: text.into(),
        };
        let columns = columns.map(|c| c.map(|c| c.parse().expect("infallible")));
        let options = ReadOptions {
            columns,
            ..ReadOptions::default()
        };
        read_points(&source, &options, &())
    };
    let point = |text, columns| read(text, columns).expect("points").points[0];
    assert_eq!(point("id;lat;lon\n7;50;8\n", None), Point::new(8.0, 50.0));
    assert_eq!(point("name,a,b\nBonn,1,2\n", None), Point::new(1.0, 2.0));
    assert_eq!(point("1 2 3\n", Some(["3", "1"])), Point::new(3.0, 1.0));
    assert_eq!(
        point("a,b,2020\n1,2,3\n", Some(["b", "a"])),
        Point::new(2.0, 1.0)
    );
    assert_eq!(
        point("a\tB\tc\n1\t2\t3\n", Some(["b", "C"])),
        Point::new(2.0, 3.0)
    );
    assert_eq!(point("\u{feff}1 , 2\r\n", None), Point::new(1.0, 2.0));
    let error = read("1 2\n", Some(["3", "1"])).expect_err("no such column");
    assert!(matches!(error, Error::NoSuchColumn { .. }), "{error}");

    let error = read("1 2\n", Some(["2", "2"])).expect_err("one column");
    assert!(matches!(error, Error::SameColumn { .. }), "{error}");

    let set = read("x,y,city,height\n1,2,Bonn,\n3,4,5,6\n", None).expect("points");
    let left_out = LeftOut {
        name: "city".to_owned(),
        point: 0,
        text: "Bonn".to_owned(),
    };
    assert_eq!(set.left_out, [left_out]);
    assert_eq!(set.attributes[0].name, "height");
    assert!(set.attributes[0].values[0].is_nan());
    assert_eq!(set.attributes[0].values[1], 6.0);
    // Doubled quotes stand for one; delimiters and blanks between quotes for themselves.
    let quoted = read("x,y,\"the \"\"z\"\", in m\"\n1,2,\"3\"\n", None).expect("points");
    assert_eq!(quoted.attributes[0].name, "the \"z\", in m");
    assert_eq!(quoted.attributes[0].values, [3.0]);
}

#[test]
fn tables_are_taken_as_they_come() {
    let read = |text: &str| {
        let source = Source::Memory {
            name: "a.txt".to_owned(),
            bytes: text.into(),
        };
        read_points(&source, &ReadOptions::default(), &()).expect(text)
    };
    let expected = [Point::new(1.0, 2.0), Point::new(3.0, 4.0)];
    for text in [
        "1 2\n3 4\n",
        "1,2\r3,4\r",
        "# x, y, and more\n1 2\n3 4\n",
        "1 2 # a, b\n3 4 # c, d\n",
        "1 2\t\n3 4\t\n",
        "\u{feff}x\ty\tz\r\n1\t2\t\r\n3\t4\t5\r\n",
        "\tx\ty\n\t1\t2\nb\t3\t4\n",
        "street,x,y\nAve #1,1,2\nAve #2,3,4\n",
        "street\tx\ty\nElm street #1\t1\t2\nElm street #2\t3\t4\n",
    ] {
        assert_eq!(read(text).points, expected, "{text:?}");
    }
    let z = &read("x\ty\tz\n1\t2\t\n3\t4\t5\n").attributes[0].values;
    assert!(z[0].is_nan() && z[1] == 5.0, "{z:?}");
    assert_eq!(read("x,y\n").points, []);
}

#[test]
fn everything_in_a_grid_is_kept() {
    let vtu = include_str!("data/two-triangles.vtu")
        .replace("0 0 0  1 0 0", "0 0 7 <!-- corner --> 1 0 0")
        .replace(
            "</Points>",
            "</Points>
            <PointData>
            <DataArray type=\"Int32\" Name=\"marker\">
              <InformationKey name=\"L2\"><Value index=\"0\">9</Value></InformationKey>
              1 -2 3 4
            </DataArray>
            <DataArray type=\"Float32\" Name=\"wind\" NumberOfComponents=\"2\">1 2 3 4 5 6 7 8</DataArray>
            </PointData>
            <FieldData><DataArray type=\"Float64\" Name=\"time\">1</DataArray></FieldData>",
        );
    let read = |text: String| {
        let bytes = text.into_bytes();
        let name = "a.vtu".to_owned();
        let source = Source::Memory { name, bytes };
        read_mesh(&source, &ReadOptions::default(), &()).expect("a grid")
    };
    let mesh = read(vtu.clone());
    assert_eq!(mesh.triangles.len(), 2);
    assert_eq!(mesh.vertices.markers, Some(vec![1, -2, 3, 4]));
    let column = |name: &str, values: [f64; 4]| Attribute {
        name: name.to_owned(),
        values: values.to_vec(),
    };
    assert_eq!(
        mesh.vertices.attributes,
        [
            column("z", [7.0, 0.0, 0.0, 0.0]),
            column("wind_0", [1.0, 3.0, 5.0, 7.0]),
            column("wind_1", [2.0, 4.0, 6.0, 8.0]),
        ]
    );
    for (from, to, value) in [("Int32", "Float64", -2.0), ("-2", "3000000000", 3e9)] {
        let set = read(vtu.replace(from, to)).vertices;
        assert_eq!(set.markers, None);
        assert_eq!(set.attributes[1], column("marker", [1.0, value, 3.0, 4.0]));
    }
}

#[test]
fn content_tells_the_format() {
    assert_eq!(
        Format::sniff(b"2 2 0 0\n1 0 0\n2 1 1\n"),
        Some(Format::Node)
    );
    assert_eq!(
        Format::sniff(b"2 2 0 0\n1 0 0 0\n2 1 1 0\n"),
        Some(Format::Table)
    );
    for (text, expected) in [
        ("2 2 0 0\n1 0 0\n2 1 1\n1 0\n1 1 2\n0\n", Format::Poly),
        ("2 2 0 1\n0 0 0 5\n1 1 1 5 # last\n\n0\n0\n", Format::Poly),
        // A point too many is no header of segments, nor is one half seen.
        ("2 2 0 0\n1 0 0\n2 1 1\n3 2 2\n", Format::Node),
        ("2 2 0 0\n1 0 0\n2 1 1\n1 0.5\n", Format::Node),
        ("3 2 0 0\n1 0 0\n2 1 1\n3\n", Format::Node),
    ] {
        assert_eq!(Format::sniff(text.as_bytes()), Some(expected), "{text}");
    }
    assert_eq!(Format::sniff(b"\xef\xbb\xbf1,2\n"), Some(Format::Table));
    assert_eq!(Format::sniff(b"x,y\n1,2\n"), Some(Format::Table));
    assert_eq!(Format::sniff(b"\x93NUMPY\x01"), Some(Format::Npy));
    assert_eq!(Format::sniff(b"<?xml?><VTKFile>"), Some(Format::Vtu));
    assert_eq!(Format::sniff(b"hello"), None);
}

/// Cancels at the n-th question.
struct CancelAfter(AtomicU32);

impl delone::Watch for CancelAfter {
    fn is_cancelled(&self) -> bool {
        let left = self.0.load(Ordering::Relaxed);
        self.0.store(left.saturating_sub(1), Ordering::Relaxed);
        left == 0
    }
}

#[test]
fn cancelled_writing_leaves_nothing() {
    let mesh = square();
    for questions in 0..5 {
        let folder = tempfile::tempdir().expect("folder");
        let watch = CancelAfter(questions.into());
        let targets = [
            target(&folder.path().join("s.ele")),
            target(&folder.path().join("s.vtu")),
        ];
        let outcome = write_mesh(
            &targets,
            &MeshView::from(&mesh),
            &WriteOptions::default(),
            &watch,
        );
        assert!(matches!(outcome, Err(Error::Cancelled)), "{outcome:?}");
        assert_eq!(std::fs::read_dir(folder.path()).expect("folder").count(), 0);
    }
}

/// A square grid of so many points on a side.
fn grid(side: usize) -> MeshData {
    let points = (0..side * side).map(|i| Point::new((i % side) as f64, (i / side) as f64));
    let is_corner = |&i: &usize| i % side + 1 < side && i / side + 1 < side;
    let halves = |i| [[i, i + 1, i + side], [i + side, i + 1, i + side + 1]];
    MeshData {
        vertices: PointSet {
            points: points.collect(),
            ..PointSet::default()
        },
        triangles: (0..side * side)
            .filter(is_corner)
            .flat_map(halves)
            .map(|t| t.map(VertexId::new))
            .collect(),
        ..MeshData::default()
    }
}

#[test]
fn readers_ask_the_watch_again_and_again() {
    let mesh = grid(200);
    let folder = tempfile::tempdir().expect("folder");
    let mut read = 0;
    for format in Format::ALL.into_iter().filter(|f| !f.is_picture()) {
        let path = folder.path().join("grid").with_extension(format.name());
        let source = Source::from_arg(&path);
        let (targets, options) = ([target(&path)], WriteOptions::default());
        if format.writes_mesh() && format.reads_mesh() {
            write_mesh(&targets, &MeshView::from(&mesh), &options, &()).expect("written");
            cancel_everywhere(|watch| {
                read_mesh(&source, &ReadOptions::default(), watch).map(|read| {
                    assert_eq!(read.triangles.len(), mesh.triangles.len(), "{format}");
                })
            });
            read += 1;
        }
        if format.writes_points() && format.reads_points() {
            write_points(&targets, &mesh.vertices, &options, &()).expect("written");
            cancel_everywhere(|watch| {
                read_points(&source, &ReadOptions::default(), watch).map(|read| {
                    assert_eq!(read.points.len(), mesh.vertices.points.len(), "{format}");
                })
            });
            read += 1;
        }
    }
    assert!(read >= 20, "{read}");
}

#[test]
fn copies_and_empty_features_ask_the_watch_too() {
    let lines = "<line x2=\"1\"/>".repeat(200);
    let uses = "<use href=\"#l\"/>".repeat(200);
    let svg = format!("<svg><g id=\"l\">{lines}</g>{uses}</svg>");
    let dxf = "0 SECTION 2 BLOCKS 0 BLOCK 2 B 10 0 20 0 0 POINT 8 0 10 0 20 0 0 ENDBLK 0 ENDSEC \
               0 SECTION 2 ENTITIES 0 INSERT 2 B 10 0 20 0 70 200 71 200 0 ENDSEC 0 EOF";
    let features = vec!["{\"type\":\"Feature\"}"; 20_000].join(",");
    let geojson = format!("{{\"type\":\"FeatureCollection\",\"features\":[{features}]}}");
    for (name, text) in [
        ("a.svg", svg),
        ("a.dxf", dxf.replace(' ', "\n")),
        ("a.geojson", geojson),
    ] {
        let (name, bytes) = (name.to_owned(), text.into_bytes());
        let source = Source::Memory { name, bytes };
        cancel_everywhere(|watch| read_points(&source, &ReadOptions::default(), watch).map(drop));
    }
}

/// Cancels at some of the questions, of which there must be a few.
#[track_caller]
fn cancel_everywhere(read: impl Fn(&CancelAfter) -> Result<(), Error>) {
    let patient = CancelAfter(u32::MAX.into());
    read(&patient).expect("written by us");
    let asked = u32::MAX - patient.0.into_inner();
    assert!(asked >= 4, "asked but {asked} times");
    for questions in [0, 1, asked / 2, asked - 1] {
        let outcome = read(&CancelAfter(questions.into()));
        assert!(matches!(outcome, Err(Error::Cancelled)), "{questions}");
    }
}

#[test]
fn a_failed_target_leaves_no_other() {
    let mesh = square();
    let folder = tempfile::tempdir().expect("folder");
    let targets = [
        target(&folder.path().join("s.vtu")),
        target(&folder.path().join("missing/s.vtu")),
    ];
    let outcome = write_mesh(
        &targets,
        &MeshView::from(&mesh),
        &WriteOptions::default(),
        &(),
    );
    assert!(
        outcome
            .expect_err("no such folder")
            .to_string()
            .contains("missing/s.vtu")
    );
    assert_eq!(std::fs::read_dir(folder.path()).expect("folder").count(), 0);
}

#[test]
fn a_mesh_with_wrong_corners_is_refused() {
    let mut mesh = square();
    mesh.triangles[1][2] = VertexId::new(9);
    let outcome = write_mesh(&[], &MeshView::from(&mesh), &WriteOptions::default(), &());
    assert!(
        outcome
            .expect_err("corner 9 of 5")
            .to_string()
            .contains("triangle 1 names vertex 9 of 5")
    );
}

#[cfg(unix)]
mod unix {
    use super::{MeshView, Source, Target, WriteOptions, read_points, square, target, write_mesh};
    use delone_io::{Format, ReadOptions};
    use std::os::unix::fs::{FileTypeExt, PermissionsExt, symlink};
    use std::path::Path;

    #[test]
    fn written_files_have_the_permissions_of_any_other() {
        let folder = tempfile::tempdir().expect("folder");
        let [ours, other] = ["s.vtu", "other"].map(|name| folder.path().join(name));
        std::fs::write(&other, "").expect("written");
        let mesh = square();
        write_mesh(
            &[target(&ours)],
            &MeshView::from(&mesh),
            &WriteOptions::default(),
            &(),
        )
        .expect("written");
        let mode = |path: &Path| std::fs::metadata(path).expect("file").permissions().mode();
        assert_eq!(mode(&ours), mode(&other));
    }

    #[test]
    fn links_stay_links_and_devices_stay_devices() {
        let folder = tempfile::tempdir().expect("folder");
        let [file, link] = ["s.vtu", "link.vtu"].map(|name| folder.path().join(name));
        std::fs::write(&file, "old").expect("written");
        symlink(&file, &link).expect("link");
        let mesh = square();
        let null = Target::from_arg("/dev/null", Some(Format::Vtu));
        let targets = [target(&link), null];
        write_mesh(
            &targets,
            &MeshView::from(&mesh),
            &WriteOptions::default(),
            &(),
        )
        .expect("written");
        assert!(std::fs::symlink_metadata(&link).expect("link").is_symlink());
        assert!(
            std::fs::read_to_string(&file)
                .expect("file")
                .starts_with("<?xml")
        );
        let null = std::fs::metadata("/dev/null").expect("device");
        assert!(null.file_type().is_char_device());
    }

    #[test]
    fn a_folder_is_not_a_file() {
        let folder = tempfile::tempdir().expect("folder");
        let error = read_points(
            &Source::from_arg(folder.path()),
            &ReadOptions::default(),
            &(),
        );
        assert!(
            error
                .expect_err("a folder")
                .to_string()
                .contains("cannot read")
        );
        let place = Target::from_arg(folder.path(), Some(Format::Vtu));
        let mesh = square();
        let error = write_mesh(
            &[place],
            &MeshView::from(&mesh),
            &WriteOptions::default(),
            &(),
        );
        assert!(
            error
                .expect_err("a folder")
                .to_string()
                .contains("cannot write")
        );
    }
}
