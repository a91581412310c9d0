//! Bare arrays of JSON, and tables with decimal commas.

use delone::Point;
use delone_io::{DomainData, PointSet, ReadOptions, Source, read_domain, read_points};

fn domain(name: &str, text: &str) -> DomainData {
    let source = Source::Memory {
        name: name.to_owned(),
        bytes: text.into(),
    };
    let domain = read_domain(&source, &ReadOptions::default(), &());
    domain.unwrap_or_else(|error| panic!("{error}"))
}

fn table(name: &str, text: &str) -> PointSet {
    let source = Source::Memory {
        name: name.to_owned(),
        bytes: text.into(),
    };
    let set = read_points(&source, &ReadOptions::default(), &());
    set.unwrap_or_else(|error| panic!("{error}"))
}

fn points(places: &[(f64, f64)]) -> Vec<Point> {
    places.iter().map(|&(x, y)| Point::new(x, y)).collect()
}

#[test]
fn arrays_of_positions_are_points() {
    let expected = points(&[(0.5, 1.0), (-2.0, 3e3)]);
    for text in [
        "[[0.5, 1], [-2, 3e3]]",
        "[0.5, 1, -2, 3e3]",
        " \u{feff}[[0.5,1],[-2,3e3]]\n",
    ] {
        let text = text.trim_start();
        let domain = domain("a.json", text);
        assert_eq!(domain.vertices.points, expected, "{text}");
        assert!(domain.segments.is_empty() && domain.vertices.attributes.is_empty());
    }
    // Without a name, the content tells.
    assert_eq!(
        domain("-", "[[0.5, 1], [-2, 3e3]]").vertices.points,
        expected
    );
    let heights = domain("a.json", "[[0.5, 1, 7], [-2, 3e3]]");
    assert_eq!(heights.vertices.attributes[0].name, "z");
    assert_eq!(heights.vertices.attributes[0].values[0], 7.0);
    for text in ["[]", "[[]]"] {
        assert!(domain("a.json", text).vertices.points.is_empty(), "{text}");
    }
}

#[test]
fn arrays_of_rings_are_one_polygon() {
    let open = "[[[0,0],[9,0],[9,9],[0,9]], [[2,2],[4,2],[3,4]]]";
    let closed = "[[[0,0],[9,0],[9,9],[0,9],[0,0]], [[2,2],[4,2],[3,4],[2,2]]]";
    let domain_of = |text| domain("a.json", text);
    let domain = domain_of(open);
    assert_eq!(domain, domain_of(closed));
    assert_eq!(
        (domain.segments.len(), format!("{:?}", domain.polygons)),
        (7, "[0..7]".to_owned())
    );
    let ends: Vec<_> = domain
        .segments
        .iter()
        .map(|s| s.map(|v| v.index()))
        .collect();
    assert_eq!(ends[3], [3, 0]);
    assert_eq!(ends[6], [6, 4]);
    // A ring of one position is a point, one of two a line.
    let flat = domain_of("[[[0,0],[9,0],[9,9]], [[5,1]], [[6,1],[6,2]]]");
    assert_eq!((flat.vertices.points.len(), flat.segments.len()), (6, 4));
    assert_eq!(format!("{:?}", flat.polygons), "[0..3]");
}

#[test]
fn decimal_commas_are_read_where_commas_set_nothing_apart() {
    let expected = points(&[(1.5, 2.5), (-3.0, 4000.25)]);
    for (name, text) in [
        ("a.csv", "1,5;2,5\n-3;4000,25\n"),
        ("a.tsv", "x\ty\n1,5\t2,5\n-3,0\t4,00025e3\n"),
        ("a.csv", "\"1,5\";\"2,5\"\n-3;4000,25\n"),
    ] {
        let set = table(name, text);
        assert_eq!(set.points, expected, "{text}");
        assert!(set.attributes.is_empty() && set.left_out.is_empty());
    }
    let set = table(
        "a.csv",
        "name;x;y;z;w\nA;1,5;2,5;10,125;1.000,5\nB;-3,0;4000,25;;2\n",
    );
    assert_eq!(set.points, expected);
    assert_eq!(set.attributes.len(), 1);
    assert_eq!(set.attributes[0].values[0], 10.125);
    assert!(set.attributes[0].values[1].is_nan());
    let left_out: Vec<_> = set.left_out.iter().map(|c| c.name.as_str()).collect();
    assert_eq!(left_out, ["name", "w"]);
    // The first comma may come late.
    let late = format!("x;y\n{}1,5;2,5\n", "1;2\n".repeat(5000));
    let set = table("a.csv", &late);
    assert_eq!(set.points.len(), 5001);
    assert_eq!(set.points[5000], Point::new(1.5, 2.5));
}

#[test]
fn commas_and_points_keep_their_meaning_elsewhere() {
    assert_eq!(
        table("a.csv", "1,5\n2,5\n").points,
        points(&[(1.0, 5.0), (2.0, 5.0)])
    );
    assert_eq!(
        table("a.csv", "1.5;2\n2;5\n").points,
        points(&[(1.5, 2.0), (2.0, 5.0)])
    );
    // A text with a comma is none of the coordinates.
    let set = table("a.csv", "x;y;who\n1.5;2;Doe, J\n2;5;3,5\n");
    assert_eq!(set.points, points(&[(1.5, 2.0), (2.0, 5.0)]));
    assert_eq!(set.left_out[0].name, "who");
}
