//! Pictures, `.svg`.

use crate::{area, data, domain, file, places, read, refuses};
use delone::DomainRule;
use delone_io::{
    Format, MeshView, ReadOptions, Source, Target, WriteOptions, read_domain, write_mesh,
};

#[test]
fn shapes_of_a_picture_are_read() {
    let domain = file("shapes.svg", &ReadOptions::default());
    assert_eq!(domain.vertices.notes, ["left out: 1 text"]);
    assert_eq!(domain.usual_rule, DomainRule::EvenOdd);
    // Round rectangle, circle, ellipse, path with a hole, polygon, and the leaf twice.
    assert_eq!(domain.polygons.len(), 7);
    let markers = domain.segment_markers.as_ref().unwrap();
    assert_eq!((markers[0], markers[markers.len() - 1]), (1, 10));
    assert!(
        domain
            .vertices
            .points
            .iter()
            .all(|p| p.y <= 0.0 && p.y >= -100.0),
        "y is negated"
    );
    let head = std::fs::read(data("shapes.svg")).unwrap();
    assert_eq!(Format::sniff(&head), Some(Format::Svg));
}

fn picture(body: &str) -> String {
    format!("<svg xmlns=\"http://www.w3.org/2000/svg\">\n{body}\n</svg>")
}

#[test]
fn commands_of_paths_go_where_they_should() {
    for (path, expected) in [
        ("M1 2 3 4", vec![[1.0, -2.0], [3.0, -4.0]]),
        (
            "m1,2 3-4h.5.5",
            vec![[1.0, -2.0], [4.0, 2.0], [4.5, 2.0], [5.0, 2.0]],
        ),
        ("M0 0V1H2z", vec![[0.0, 0.0], [0.0, -1.0], [2.0, -1.0]]),
        (
            "M0 0h1v1zl-1 0",
            vec![[0.0, 0.0], [-1.0, 0.0], [0.0, 0.0], [1.0, 0.0], [1.0, -1.0]],
        ),
        ("M5 5h0", vec![[5.0, -5.0]]),
        ("M1 1A0 3 0 0 0 4 4", vec![[1.0, -1.0], [4.0, -4.0]]),
        ("M1e1-1e1L+1.5.5", vec![[10.0, 10.0], [1.5, -0.5]]),
    ] {
        let domain = domain("a.svg", &picture(&format!("<path d=\"{path}\"/>")));
        assert_eq!(places(&domain), expected, "{path}");
    }
}

#[test]
fn smooth_curves_go_on_as_the_last_one_did() {
    for (smooth, explicit) in [
        ("M0 0C0 2 4 2 4 0S8-2 8 0", "M0 0C0 2 4 2 4 0C4-2 8-2 8 0"),
        ("M0 0Q1 2 2 0T4 0", "M0 0Q1 2 2 0Q3-2 4 0"),
        ("M0 0C0 2 4 2 4 0T8 0", "M0 0C0 2 4 2 4 0L8 0"),
    ] {
        let [found, expected] = [smooth, explicit].map(|path| {
            let text = picture(&format!("<path d=\"{path}\"/>"));
            places(&domain("a.svg", &text))
        });
        assert_eq!(found[0], [0.0, 0.0]);
        assert!(found.len() > 10, "{smooth}: {found:?}");
        assert_eq!(found, expected, "{smooth}");
    }
}

#[test]
fn arcs_of_pictures_are_circles() {
    // The four arcs between two points of a circle of radius 5, of which two are large.
    for (flags, area_of) in [
        ("0 0", "small"),
        ("0 1", "small"),
        ("1,0", "large"),
        ("11", "large"),
    ] {
        let separator = if flags.len() == 2 { "" } else { " " };
        let text = picture(&format!("<path d=\"M0 0A5 5 0 {flags}{separator}6 0z\"/>"));
        let options = ReadOptions {
            flatness: Some(1e-5),
            ..ReadOptions::default()
        };
        let domain = read("a.svg", text.as_bytes(), &options).unwrap();
        let half = (0.6f64).asin();
        let small = 25.0 * half - 12.0;
        let expected = match area_of {
            "small" => small,
            _ => 25.0 * std::f64::consts::PI - small,
        };
        let is_below = domain.vertices.points.iter().map(|p| p.y).sum::<f64>() < 0.0;
        // Positive sweep is clockwise on the screen: from left to right over the top.
        assert_eq!(is_below, flags.ends_with('0'), "{flags}");
        let found = area(domain);
        assert!(
            (found - expected).abs() < 1e-3,
            "{flags}: {found} for {expected}"
        );
    }
}

#[test]
fn ellipses_of_arcs_may_be_turned_and_grow() {
    // Both ends of an axis, the longer of which is turned by 30 degrees, in either order.
    let [long, short] = [[12f64.sqrt(), 2.0], [-1.0, 3f64.sqrt()]];
    let options = ReadOptions {
        flatness: Some(1e-5),
        ..ReadOptions::default()
    };
    for [x, y] in [long, long.map(|v| -v), short, short.map(|v| -v)] {
        for radii in ["4 2", "1 .5"] {
            let text = format!("<path d=\"M{} {}A{radii} 30 0 1 {x} {y}z\"/>", -x, -y);
            let half = read("a.svg", picture(&text).as_bytes(), &options).unwrap();
            let found = area(half);
            let expected = 4.0 * std::f64::consts::PI;
            assert!((found - expected).abs() < 1e-3, "{text}: {found}");
        }
    }
}

#[test]
fn corners_of_rectangles_may_be_round() {
    let options = ReadOptions {
        flatness: Some(1e-5),
        ..ReadOptions::default()
    };
    let corner = 1.0 - std::f64::consts::FRAC_PI_4;
    for (radii, expected) in [
        ("rx=\"1\"", 32.0 - 4.0 * corner),
        ("rx=\"3\" ry=\"1\"", 32.0 - 12.0 * corner),
        ("ry=\"9\"", 32.0 - 32.0 * corner),
        ("rx=\"0\" ry=\"1\"", 32.0),
    ] {
        let text = picture(&format!("<rect width=\"8\" height=\"4\" {radii}/>"));
        let found = area(read("a.svg", text.as_bytes(), &options).unwrap());
        assert!((found - expected).abs() < 1e-3, "{radii}: {found}");
    }
}

#[test]
fn shapes_without_area_or_with_negated_zeros_leave_nothing_odd() {
    let flat = "<rect width=\"3\"/><rect height=\"2\"/><rect width=\"1\" height=\"0\"/>";
    assert_eq!(places(&domain("a.svg", &picture(flat))).len(), 0);
    let line = domain("a.svg", &picture("<line x1=\"-0\" x2=\"4\"/>"));
    let is_negative = |p: &delone::Point| p.x.is_sign_negative() || p.y.is_sign_negative();
    assert!(!line.vertices.points.iter().any(is_negative));
}

#[test]
fn uses_and_views_are_followed() {
    let text = picture(
        "<defs><symbol id=\"s\" viewBox=\"0 0 10 10\"><path d=\"M0 0H10\"/></symbol><line id=\"l\" x2=\"2\" y2=\"1\"/></defs>\
         <use href=\"#s\" x=\"100\" width=\"20\" height=\"40\"/>\
         <svg x=\"7\" y=\"1\" width=\"10\" height=\"10\" viewBox=\"0 0 5 5\"><use href=\"#l\" x=\"1\"/></svg>\
         <use href=\"#nowhere\"/><image href=\"a.png\"/><rect width=\"100%\" height=\"100%\"/>\
         <line clip-path=\"url(#c)\" x1=\"1mm\" y2=\"2in\"/>",
    );
    let domain = domain("a.svg", &text);
    let expected = [[100.0, -10.0], [120.0, -10.0], [9.0, -1.0], [13.0, -3.0]];
    assert_eq!(places(&domain)[..4], expected);
    assert!((places(&domain)[4][0] - 96.0 / 25.4).abs() < 1e-12);
    assert_eq!(places(&domain)[5], [0.0, -192.0]);
    assert_eq!(
        domain.vertices.notes,
        [
            "left out: 1 image, 1 rect with lengths in per cent and 1 use of something that is not in the file",
            "1 element is read whole, as clip paths and masks cut nothing"
        ]
    );
}

#[test]
fn broken_pictures_name_the_place() {
    refuses("a.svg", "", "a.svg: the file is empty");
    refuses(
        "a.svg",
        "<html/>",
        "a.svg:1:1: the root element is \"html\", not svg",
    );
    refuses(
        "a.svg",
        "<svg>\n<g>",
        "truncated: the file ends within an element",
    );
    refuses("a.svg", "<svg>\n<g></svg>", "a.svg:2:");
    let cases = [
        (
            "<path d=\"L1 1\"/>",
            "a.svg:2:1: expected M or m, which begin a path, at character 1",
        ),
        (
            "<path d=\"M1 1 L2\"/>",
            "expected a number at character 8 of the data, found its end",
        ),
        (
            "<path d=\"M1 1 2 b\"/>",
            "expected a number at character 8 of the data, found \"b\"",
        ),
        (
            "<path d=\"M1 1B2 2\"/>",
            "expected one of the commands MLHVCSQTAZ at character 5",
        ),
        (
            "<path d=\"M1 1e999\"/>",
            "expected a finite number at character 4 of the data, found \"1e999\"",
        ),
        (
            "<path d=\"M0 0A1 1 0 2 0 1 1\"/>",
            "expected a flag, 0 or 1",
        ),
        (
            "<polygon points=\"1 2 3\"/>",
            "3 numbers are no points of two each",
        ),
        (
            "<circle r=\"2em\"/>",
            "unit \"em\" of a length is not understood",
        ),
        (
            "<g transform=\"spin(3)\"/>",
            "transform \"spin(3)\" is not understood",
        ),
        (
            "<g transform=\"rotate(3\"/>",
            "transform \"rotate(3\" is not understood",
        ),
        (
            "<svg viewBox=\"1 2\"/>",
            "viewBox \"1 2\" is not four numbers",
        ),
        (
            "<use href=\"#a\" id=\"a\"/>",
            "deeper than 256, or without end",
        ),
    ];
    for (body, expected) in cases {
        refuses("a.svg", &picture(body), expected);
    }
    let deep = format!("{}{}", "<g>".repeat(100_000), "</g>".repeat(100_000));
    refuses("a.svg", &picture(&deep), "deeper than 256");
    // Each level shows the one before ten times: 10^12 lines, if there were no bound.
    let mut laughs = "<g id=\"l0\"><line x2=\"1\"/></g>".to_owned();
    for level in 1..=12 {
        let inner = format!("<use href=\"#l{}\"/>", level - 1).repeat(10);
        laughs += &format!("<g id=\"l{level}\">{inner}</g>");
    }
    refuses("a.svg", &picture(&laughs), "the picture is too large");
    let bomb =
        "<!DOCTYPE svg [<!ENTITY a \"aaaa\"><!ENTITY b \"&a;&a;\">]>\n<svg><path d=\"&b;\"/></svg>";
    refuses("a.svg", bomb, "a.svg:2:6: broken XML");
}

#[test]
fn our_own_pictures_can_be_read() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("mesh.svg");
    let points = [[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [0.0, 3.0], [1.0, 1.0]];
    let triangulation = delone::triangulate(points).unwrap();
    let target = Target::from_arg(&path, None);
    write_mesh(
        &[target],
        &MeshView::from(&triangulation),
        &WriteOptions::default(),
        &(),
    )
    .unwrap();
    let domain = read_domain(&Source::Path(path), &ReadOptions::default(), &()).unwrap();
    assert!(domain.polygons.len() > 1 && domain.vertices.points.len() > 4 * 3);
    assert_eq!(
        domain.vertices.notes,
        ["left out: 1 rect with lengths in per cent"]
    );
}
