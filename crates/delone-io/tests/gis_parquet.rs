//! Parquet: tables by every writer, meshes that come back, broken files and bombs.

#![cfg(feature = "parquet")]

use delone::{Point, Region, VertexId};
use delone_io::{
    Attribute, Column, Constraints, DomainData, Error, MeshData, MeshView, PointSet, ReadOptions,
    Source, Target, WriteOptions, read_domain, read_mesh, read_points, write_mesh, write_points,
};
use std::path::{Path, PathBuf};

fn fixture(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/gis");
    folder.join(name)
}

fn bytes(name: &str) -> Vec<u8> {
    std::fs::read(fixture(name)).expect("a fixture")
}

fn read(name: &str, bytes: Vec<u8>) -> Result<DomainData, Error> {
    let name = name.to_owned();
    read_domain(
        &Source::Memory { name, bytes },
        &ReadOptions::default(),
        &(),
    )
}

fn points(name: &str, columns: Option<[Column; 2]>) -> PointSet {
    let options = ReadOptions {
        columns,
        ..ReadOptions::default()
    };
    let set = read_points(&Source::from_arg(fixture(name)), &options, &());
    set.unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn tables_of_every_writer_and_codec_are_the_same() {
    let codecs = ["none", "snappy", "gzip", "zstd", "lz4"];
    let pandas = codecs.map(|codec| format!("pandas-{codec}.parquet"));
    for name in pandas
        .iter()
        .map(String::as_str)
        .chain(["polars.parquet", "duckdb.parquet"])
    {
        let set = points(name, None);
        assert_eq!(set.points.len(), 60, "{name}");
        for (i, p) in set.points.iter().enumerate() {
            let i = i as f64;
            assert_eq!((p.x, p.y), (i * 0.1 + 0.3, i.sqrt()), "{name}");
        }
        let names: Vec<_> = set.attributes.iter().map(|a| a.name.as_str()).collect();
        assert_eq!(names, ["count", "small", "height", "wet"], "{name}");
        let value = |column: usize, row: usize| set.attributes[column].values[row];
        assert_eq!([value(0, 59), value(1, 59)], [59.0 * 1_000_003.0, 59.0]);
        assert_eq!([value(2, 6), value(3, 6), value(3, 7)], [0.75, 1.0, 0.0]);
        assert!(value(2, 7).is_nan(), "{name}");
        let markers: Vec<i32> = (0..60).map(|i| i % 5 - 2).collect();
        assert_eq!(set.markers, Some(markers), "{name}");
        let left_out: Vec<_> = set.left_out.iter().map(|c| c.name.as_str()).collect();
        assert_eq!(left_out, ["name", "when"], "{name}");
    }
}

#[test]
fn columns_are_chosen_by_name_or_place() {
    let named = ["lat", "small"].map(|n| Column::Name(n.to_owned()));
    let set = points("duckdb.parquet", Some(named));
    assert_eq!(set.points[4], Point::new(2.0, 4.0));
    assert_eq!(
        points("duckdb.parquet", Some([2, 4].map(Column::Index))).points,
        set.points
    );
    let message = |columns: [&str; 2]| {
        let options = ReadOptions {
            columns: Some(columns.map(|n| Column::Name(n.to_owned()))),
            ..ReadOptions::default()
        };
        let source = Source::Memory {
            name: "a.parquet".to_owned(),
            bytes: bytes("duckdb.parquet"),
        };
        read_points(&source, &options, &())
            .expect_err("an error")
            .to_string()
    };
    assert_eq!(
        message(["lat", "name"]),
        "a.parquet: column \"name\" holds no coordinates but text"
    );
    assert_eq!(
        message(["lat", "height"]),
        "a.parquet: point 7: y is NaN or null, coordinates must be finite; repair or remove it"
    );
    assert!(
        message(["lat", "up"])
            .starts_with("a.parquet: no column \"up\"; there are 1 (name), 2 (lon)")
    );
}

fn mesh() -> MeshData {
    let numbers = |name: &str, values: &[f64]| Attribute {
        name: name.to_owned(),
        values: values.to_vec(),
    };
    let corners = [[0, 1, 2], [0, 2, 3]];
    let region = |x| Region {
        at: Point::new(x, 0.5),
        attribute: x,
        max_area: None,
    };
    MeshData {
        vertices: PointSet {
            points: [(0.0, 0.0), (0.1, -0.0), (1e300, 5e-324), (0.0, 1.0)]
                .map(|(x, y)| Point::new(x, y))
                .to_vec(),
            // A name that is taken is changed, not lost.
            attributes: vec![
                numbers("z", &[0.1, f64::NAN, -0.0, f64::INFINITY]),
                numbers("x", &[1.0, 2.0, 3.0, 4.0]),
            ],
            markers: Some(vec![i32::MIN, 0, 1, i32::MAX]),
            ..PointSet::default()
        },
        triangles: corners.map(|t| t.map(VertexId::new)).to_vec(),
        triangle_attributes: vec![numbers("area", &[0.5, f64::NAN])],
        constraints: Some(Constraints {
            edges: vec![[0, 1].map(VertexId::new), [2, 0].map(VertexId::new)],
            markers: Some(vec![5, -7]),
            regions: vec![region(0.25), region(0.75)],
            region_of: Some(vec![Some(1), None]),
            ..Constraints::default()
        }),
        quadratic: false,
    }
}

#[test]
fn a_mesh_comes_back_as_it_was() {
    let folder = tempfile::tempdir().expect("folder");
    let path = folder.path().join("m.parquet");
    let mesh = mesh();
    let target = Target::from_arg(&path, None);
    let view = MeshView::from(&mesh);
    let written = write_mesh(&[target], &view, &WriteOptions::default(), &()).expect("written");
    let names = written
        .iter()
        .map(|p| p.file_name().expect("name").to_str().expect("text"));
    let names: Vec<_> = names.collect();
    assert_eq!(
        names,
        ["m.parquet", "m.points.parquet", "m.segments.parquet"]
    );

    let options = ReadOptions::default();
    let back = read_mesh(&Source::from_arg(&path), &options, &()).expect("a mesh");
    assert_eq!(back.triangles, mesh.triangles);
    let bits = |points: &[Point]| -> Vec<_> {
        points
            .iter()
            .map(|p| [p.x.to_bits(), p.y.to_bits()])
            .collect()
    };
    assert_eq!(bits(&back.vertices.points), bits(&mesh.vertices.points));
    assert_eq!(back.vertices.markers, mesh.vertices.markers);
    let show = |attributes: &[Attribute]| format!("{attributes:?}").replace("\"x_\"", "\"x\"");
    assert_eq!(
        show(&back.vertices.attributes),
        show(&mesh.vertices.attributes)
    );
    assert_eq!(back.vertices.attributes[1].name, "x_");
    let attributes = &back.triangle_attributes;
    assert_eq!(format!("{attributes:?}").matches("NaN").count(), 2);
    assert_eq!(
        (&attributes[0].name[..], attributes[0].values[0]),
        ("region", 1.0)
    );
    assert_eq!(
        (&attributes[1].name[..], attributes[1].values[0]),
        ("area", 0.5)
    );
    let constraints = back.constraints.expect("segments");
    assert_eq!(
        constraints.edges,
        mesh.constraints.as_ref().expect("edges").edges
    );
    assert_eq!(constraints.markers, Some(vec![5, -7]));
    // The corners are not taken for points.
    let error = read_points(&Source::from_arg(&path), &options, &()).expect_err("no points");
    assert!(error.to_string().ends_with(
        "m.parquet: corners of triangles, whose points are in the file .points.parquet beside it"
    ));
    // With other points beside it, corners may be none.
    let points = folder.path().join("m.points.parquet");
    let mut fewer = mesh.vertices.clone();
    fewer.points.truncate(2);
    (fewer.attributes, fewer.markers) = (Vec::new(), None);
    let target = Target::from_arg(&points, None);
    write_points(&[target], &fewer, &WriteOptions::default(), &()).expect("points");
    let error = read_mesh(&Source::from_arg(&path), &options, &()).expect_err("no mesh");
    let expected = "triangle 1 names vertex 2 of 2 (numbered from 0)";
    let text = error.to_string();
    assert!(
        text.contains(expected) || text.contains("triangle 0 names vertex 2 of 2"),
        "{text}"
    );
}

#[test]
fn many_rows_pass_through_several_groups() {
    let folder = tempfile::tempdir().expect("folder");
    let path = folder.path().join("p.parquet");
    let n = (1 << 20) + 70_000;
    let point = |i: usize| Point::new(i as f64 / 3.0, -(i as f64).sqrt());
    let value = |i: usize| {
        if i % 1000 == 999 {
            f64::NAN
        } else {
            (i / 7) as f64
        }
    };
    let set = PointSet {
        points: (0..n).map(point).collect(),
        attributes: vec![Attribute {
            name: "v".to_owned(),
            values: (0..n).map(value).collect(),
        }],
        ..PointSet::default()
    };
    let target = Target::from_arg(&path, None);
    write_points(&[target], &set, &WriteOptions::default(), &()).expect("written");
    let back = read_points(&Source::from_arg(&path), &ReadOptions::default(), &()).expect("read");
    assert!(back.points == set.points);
    let bits = |set: &PointSet| -> Vec<u64> {
        set.attributes[0]
            .values
            .iter()
            .map(|v| v.to_bits())
            .collect()
    };
    assert!(bits(&back) == bits(&set));
}

#[test]
fn broken_files_say_so() {
    let message = |bytes: Vec<u8>| read("a.parquet", bytes).expect_err("an error").to_string();
    assert_eq!(message(Vec::new()), "a.parquet: the file is empty");
    assert_eq!(
        message(b"PAR".to_vec()),
        "a.parquet: no Parquet file: it does not begin with PAR1"
    );
    let cut = "a.parquet: truncated: the file does not end with its table of contents and PAR1";
    assert_eq!(message(b"PAR1PAR1".to_vec()), cut);
    assert_eq!(message([b"PAR1", &[0xff; 4][..], b"PAR1"].concat()), cut);
    assert_eq!(
        message(b"PAR1\0\0\0\0PARE".to_vec()),
        "a.parquet: the file is encrypted; save it without encryption"
    );
    let footer = |footer: &[u8]| {
        let length = (footer.len() as u32).to_le_bytes();
        message([b"PAR1", footer, &length, b"PAR1"].concat())
    };
    assert_eq!(
        footer(&[0x29]),
        "a.parquet: the table of contents is broken"
    );
    // Field 2, a list of structs; each with field 5, the number of children: 2³¹ − 1, or 1.
    let huge = [0x29, 0x1c, 0x55, 0xfe, 0xff, 0xff, 0xff, 0x0f, 0, 0];
    assert_eq!(
        footer(&huge),
        "a.parquet: a column of 2147483647 parts, 0 levels deep"
    );
    let deep = [&[0x29, 0xfc, 100][..], &[0x55, 2, 0].repeat(100), &[0]].concat();
    assert_eq!(
        footer(&deep),
        "a.parquet: a column of 1 parts, 33 levels deep"
    );
    let wide = [
        &[0x29, 0xfc, 0xa0, 0x8d, 6][..],
        &[0x55, 2, 0].repeat(100_000),
        &[0],
    ]
    .concat();
    assert!(footer(&wide).starts_with("a.parquet: 16385 columns, at most 16384 are possible"));
}

#[test]
fn a_small_file_that_means_much_memory_is_refused() {
    // A hundred million rows of the same numbers, in two thousand bytes.
    let error = read("a.parquet", bytes("bomb.parquet")).expect_err("a bomb");
    let text = error.to_string();
    assert!(
        text.starts_with("a.parquet: declares more than 51"),
        "{text}"
    );
}
