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
3
1 3 1 .25 .125
2 3 2 7
3 3 3 8 -1
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
        region(2.0, 7.0, None),
        region(3.0, 8.0, None),
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
