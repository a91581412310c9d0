//! Domains: what each format says about segments, polygons, holes and regions.

use delone::{DomainRule, Point, Region, VertexId};
use delone_io::{DomainData, Error, ReadOptions, Source, read_domain, read_points};

fn read(name: &str, text: &str) -> Result<DomainData, Error> {
    let source = Source::Memory {
        name: name.to_owned(),
        bytes: text.into(),
    };
    read_domain(&source, &ReadOptions::default(), &())
}

fn ids<const N: usize>(segments: [[usize; 2]; N]) -> Vec<[VertexId; 2]> {
    segments.map(|s| s.map(VertexId::new)).to_vec()
}

/// A square with everything that `.poly` knows.
const SQUARE: &str = "\
# a square
4 2 1 1   # points with one attribute and a marker
1 0 0 .5 7
2 4 0 .5 8
3 4 4 .5 9
4 0 4 .5 10

5 1
0 1 2 5   # numbered from 0, though the points are not
1 2 3 6
2 3 4 0
3 4 1 -3
4 1 3 2
1
1 1 2
4
1 3 1 .25 .125
2 3 2 7
3 3 3 8 -1
4 3 .5 9 0
";

#[test]
fn a_poly_file_is_read_whole() {
    let domain = read("a.poly", SQUARE).expect("a domain");
    assert_eq!(domain.vertices.points.len(), 4);
    assert_eq!(domain.vertices.base, 1);
    assert_eq!(domain.vertices.attributes[0].values, [0.5; 4]);
    assert_eq!(domain.vertices.markers, Some(vec![7, 8, 9, 10]));
    let segments = ids([[0, 1], [1, 2], [2, 3], [3, 0], [0, 2]]);
    assert_eq!(domain.segments, segments);
    assert_eq!(domain.segment_markers, Some(vec![5, 6, 0, -3, 2]));
    assert_eq!(domain.holes, [Point::new(1.0, 2.0)]);
    let region = |y, attribute, max_area| Region {
        at: Point::new(3.0, y),
        attribute,
        max_area,
    };
    let regions = [
        region(1.0, 0.25, Some(0.125)),
        region(2.0, 7.0, Some(7.0)),
        region(3.0, 8.0, None),
        region(0.5, 9.0, None),
    ];
    assert_eq!(domain.regions, regions);
    assert!(domain.polygons.is_empty());
    assert_eq!(domain.usual_rule, DomainRule::Carve);
}

#[test]
fn a_graph_is_taken_out_and_the_data_stay() {
    let mut domain = read("a.poly", SQUARE).expect("a domain");
    let whole = domain.clone();
    let pslg = domain.take_pslg();
    assert_eq!(pslg.points, whole.vertices.points);
    assert_eq!(pslg.segments, whole.segments);
    assert_eq!((&pslg.holes, &pslg.regions), (&whole.holes, &whole.regions));
    assert_eq!(domain.vertices.attributes, whole.vertices.attributes);
    assert_eq!(domain.segment_markers, whole.segment_markers);
    assert_eq!(DomainData::from(pslg).usual_rule, DomainRule::Carve);
}

#[test]
fn points_may_stand_in_a_file_of_their_own() {
    let folder = tempfile::tempdir().expect("folder");
    let [poly, node] = ["a.poly", "a.node"].map(|name| folder.path().join(name));
    std::fs::write(&node, "2 2 0 0\n1 0 0\n2 1 0\n").expect("written");
    std::fs::write(&poly, "0 2 0 0\n1 0\n1 1 2\n0\n").expect("written");
    let domain = read_domain(&Source::Path(poly), &ReadOptions::default(), &());
    let domain = domain.expect("a domain");
    assert_eq!(domain.segments, ids([[0, 1]]));
    assert_eq!(domain.vertices.base, 1);
}

#[test]
fn bare_points_are_a_domain_too() {
    for (name, text) in [
        ("a.node", "1 2 0 0\n1 0 0\n"),
        ("a.csv", "0,0\n"),
        ("a.poly", "1 2 0 0\n1 0 0\n0 0\n0\n"),
    ] {
        let domain = read(name, text).expect(name);
        assert_eq!(domain.vertices.points, [Point::new(0.0, 0.0)]);
        assert!(domain.segments.is_empty(), "{name}");
        assert_eq!(domain.usual_rule, DomainRule::Hull, "{name}");
    }
}

#[test]
fn points_of_a_domain_can_be_read_alone() {
    let source = Source::Memory {
        name: "a.poly".to_owned(),
        bytes: SQUARE.into(),
    };
    let points = read_points(&source, &ReadOptions::default(), &()).expect("points");
    assert_eq!(points, read("a.poly", SQUARE).expect("a domain").vertices);
}

/// Two squares with a common side, a hole in the first, a line, and a point, as GeoJSON.
const FEATURES: &str = r#"{"features": [
  {"type": "Feature", "properties": {"name": "left", "more": [1, {"marker": 9}]}, "geometry":
    {"coordinates": [[[0,0],[9,0],[9,9],[0,9],[0,0]], [[1,1],[2,1],[1,2],[1,1]]], "type": "Polygon"}},
  {"type": "Feature", "properties": {"marker": 7}, "geometry":
    {"type": "MultiPolygon", "coordinates": [[[[9,0],[18,0],[18,9],[9,9],[9,0]]]]}},
  {"type": "Feature", "properties": null, "geometry": null},
  {"type": "Feature", "id": 4, "geometry": {"type": "GeometryCollection", "geometries": [
    {"type": "LineString", "coordinates": [[3,3,5.5],[4,3],[4,4,-1,99]]},
    {"type": "Point", "coordinates": [5,5]},
    {"type": "Polygon", "coordinates": []}, {"type": "Point", "coordinates": []}]}}
], "bbox": [0,0,18,9], "type": "FeatureCollection"}"#;

/// The same as well-known text, each geometry with its marker's number.
const GEOMETRIES: &str = "SRID=4326;POLYGON((0 0,9 0,9 9,0 9,0 0),(1 1,2 1,1 2,1 1));
MultiPolygon (((9 0, 18 0, 18 9, 9 9, 9 0)))
# a comment

POINT EMPTY; GEOMETRYCOLLECTION Z (LINESTRING Z (3 3 5.5, 4 3 0, 4 4 -1), POINT (5 5), POLYGON EMPTY)
";

#[test]
fn geojson_is_read_whole() {
    let domain = read("a.geojson", FEATURES).expect("a domain");
    assert_features(&domain);
    let markers = [vec![1; 7], vec![7; 4], vec![4; 2]].concat();
    assert_eq!(domain.segment_markers, Some(markers));
    let z = &domain.vertices.attributes[0];
    assert_eq!(z.name, "z");
    assert_eq!(z.values.iter().filter(|v| v.is_nan()).count(), 13);
    assert_eq!((z.values[11], z.values[13]), (5.5, -1.0));
}

#[test]
fn well_known_text_is_read_whole() {
    let domain = read("a.wkt", GEOMETRIES).expect("a domain");
    assert_features(&domain);
    let markers = [vec![1; 7], vec![2; 4], vec![4; 2]].concat();
    assert_eq!(domain.segment_markers, Some(markers));
    assert_eq!(
        domain.vertices.attributes[0].values[11..14],
        [5.5, 0.0, -1.0]
    );
}

#[track_caller]
fn assert_features(domain: &DomainData) {
    assert_eq!(domain.vertices.points.len(), 4 + 3 + 4 + 3 + 1);
    assert_eq!(domain.polygons, [0..7, 7..11]);
    let [square, triangle] = [[[3, 0]], [[6, 4]]].map(ids);
    assert_eq!(domain.segments[3..4], square);
    assert_eq!(domain.segments[6..7], triangle);
    assert_eq!(domain.segments[11..], ids([[11, 12], [12, 13]]));
    assert_eq!(domain.usual_rule, DomainRule::EvenOdd);
}

#[test]
fn every_geometry_can_be_a_file() {
    let cases: [(&str, &str, [usize; 3]); 12] = [
        (
            r#"{"type":"Point","coordinates":[1,2]}"#,
            "POINT (1 2)",
            [1, 0, 0],
        ),
        (
            r#"{"type":"MultiPoint","coordinates":[[1,2],[3,4]]}"#,
            "MULTIPOINT (1 2, 3 4)",
            [2, 0, 0],
        ),
        (
            r#"{"type":"MultiPoint","coordinates":[]}"#,
            "MULTIPOINT EMPTY",
            [0, 0, 0],
        ),
        (
            r#"{"type":"MultiPoint","coordinates":[[1,2],[3,4]]}"#,
            "multipoint((1 2),EMPTY,(3 4))",
            [2, 0, 0],
        ),
        (
            r#"{"type":"LineString","coordinates":[[1,2],[3,4]]}"#,
            "LINESTRING(1 2,3 4)",
            [2, 1, 0],
        ),
        (
            r#"{"type":"LineString","coordinates":[[1,2],[3,4],[1,2]]}"#,
            "LINESTRINGM(1 2 0,3 4 0,1 2 0)",
            [3, 2, 0],
        ),
        (
            r#"{"type":"LineString","coordinates":[[0,0],[3,4],[4,3],[0,0]]}"#,
            "LINESTRING(0 0,3 4,4 3,-0 0)",
            [3, 3, 0],
        ),
        (
            r#"{"type":"MultiLineString","coordinates":[[[1,2],[3,4]],[[5,6],[7,8]]]}"#,
            "MULTILINESTRING((1 2,3 4),(5 6,7 8))",
            [4, 2, 0],
        ),
        (
            r#"{"type":"Polygon","coordinates":[[[0,0],[3,0],[0,4],[0,0]]]}"#,
            "POLYGON ZM((0 0 1 2,3 0 1 2,0 4 1 2,0 0 1 2))",
            [3, 3, 1],
        ),
        (
            r#"{"type":"MultiPolygon","coordinates":[[[[0,0],[3,0],[0,4],[0,0]]],[]]}"#,
            "MULTIPOLYGON(((0 0,3 0,0 4,0 0)),EMPTY)",
            [3, 3, 1],
        ),
        (
            r#"{"type":"Feature","geometry":{"type":"Point","coordinates":[1e-3,2]},"properties":{}}"#,
            "Point(1e-3 +2)",
            [1, 0, 0],
        ),
        (
            r#"{"type":"FeatureCollection","features":[]}"#,
            "GEOMETRYCOLLECTION EMPTY",
            [0, 0, 0],
        ),
    ];
    for (geojson, wkt, counts) in cases {
        for (name, text) in [
            ("a.geojson", geojson),
            ("a.wkt", wkt),
            ("-", geojson),
            ("-", wkt),
        ] {
            let domain = read(name, text).expect(text);
            let found = [
                domain.vertices.points.len(),
                domain.segments.len(),
                domain.polygons.len(),
            ];
            assert_eq!(found, counts, "{text}");
            assert_eq!(domain.segment_markers, None, "{text}");
            let rule = [DomainRule::Hull, DomainRule::EvenOdd][counts[2]];
            assert_eq!(domain.usual_rule, rule, "{text}");
        }
    }
    let measured = read("a.wkt", "POINT M (1 2 3) POINT Z (1 2 4)").expect("points");
    let columns = measured.vertices.attributes.iter().map(|a| a.name.as_str());
    assert_eq!(columns.collect::<Vec<_>>(), ["z", "m"]);
    assert_eq!(measured.vertices.attributes[0].values[1], 4.0);
    assert_eq!(measured.vertices.attributes[1].values[0], 3.0);
}

#[test]
fn decimals_are_read_to_the_last_bit() {
    for text in [
        "0.1",
        "9007199254740993",
        "5e-324",
        "1.7976931348623157e308",
        "-122.419415999999999",
    ] {
        let value: f64 = text.parse().expect("a number");
        let geojson = format!(r#"{{"type":"Point","coordinates":[{text},0]}}"#);
        for (name, content) in [
            ("a.geojson", geojson),
            ("a.wkt", format!("POINT({text} 0)")),
        ] {
            let domain = read(name, &content).expect("a point");
            assert_eq!(
                domain.vertices.points[0].x.to_bits(),
                value.to_bits(),
                "{text}"
            );
        }
    }
}

/// Cancels at once.
struct Cancelled;

impl delone::Watch for Cancelled {
    fn is_cancelled(&self) -> bool {
        true
    }
}

#[test]
fn reading_can_be_cancelled() {
    let positions: Vec<_> = (0..5000).map(|i| [i, i * i % 97]).collect();
    let wkt = positions
        .iter()
        .map(|[x, y]| format!("{x} {y}"))
        .collect::<Vec<_>>();
    let wkt = format!("LINESTRING({})", wkt.join(","));
    let geojson = format!(r#"{{"type":"LineString","coordinates":{positions:?}}}"#);
    for (name, text) in [
        ("a.wkt", wkt),
        ("a.geojson", geojson),
        ("a.poly", SQUARE.to_owned()),
    ] {
        assert!(read(name, &text).is_ok(), "{name} but for the watch");
        let source = Source::Memory {
            name: name.to_owned(),
            bytes: text.into(),
        };
        let outcome = read_domain(&source, &ReadOptions::default(), &Cancelled);
        assert!(matches!(outcome, Err(Error::Cancelled)), "{name}");
    }
}

/// Found by breaking files: faces of two corners, in `.obj`, are polygons of two segments.
#[test]
fn a_polygon_of_two_segments_goes_into_geojson_as_lines() {
    let ids = |rows: &[[usize; 2]]| {
        rows.iter()
            .map(|row| row.map(delone::VertexId::new))
            .collect()
    };
    let domain = delone_io::DomainData {
        segments: ids(&[[0, 1], [1, 0], [0, 1], [1, 2], [2, 0]]),
        polygons: vec![0..2, 2..5],
        ..delone_io::DomainData::from(delone_io::PointSet {
            points: [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)]
                .map(delone::Point::from)
                .to_vec(),
            ..Default::default()
        })
    };
    let targets = [delone_io::Target::from_arg("f.geojson", None)];
    let options = delone_io::WriteOptions::default();
    let write = || delone_io::write_domain(&targets, &domain, &options, &());
    let (_, files) = delone_io::in_memory(write).expect("written");
    let source = delone_io::Source::Memory {
        name: "f.geojson".to_owned(),
        bytes: files[0].bytes.clone(),
    };
    let read = delone_io::read_domain(&source, &Default::default(), &()).expect("read");
    assert_eq!(read.segments.len(), 5);
    assert_eq!(read.polygons.len(), 1);
}
