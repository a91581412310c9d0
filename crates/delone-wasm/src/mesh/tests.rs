//! Meshes are what was asked for, and tell about themselves.

use super::*;

fn preset(name: &str) -> Drawing {
    Drawing::preset(name, 200, 1).expect("a preset")
}

#[test]
fn points_are_triangulated_with_and_without_a_domain_alike() {
    let drawing = preset("uniform");
    let bare = Mesh::triangulate(&drawing, None).expect("a mesh");
    let domain = Mesh::constrain(&drawing, None, None).expect("a mesh");
    assert_eq!(bare.hash(), domain.hash());
    assert_eq!(bare.triangles().len() % 3, 0);
    assert!(bare.quality().contains(r#""outcome":null"#));
}

#[test]
fn refinement_reaches_what_is_asked_for() {
    let options = r#"{"minAngle": 25, "maxEdge": 0.5, "smoothing": 1}"#.to_owned();
    let mesh = Mesh::refine(&preset("thesis"), Some(options), None).expect("a mesh");
    let figures = Figures::of(&mesh);
    assert!(figures.longest_edge.is_some_and(|edge| edge <= 0.5));
    assert!(mesh.quality().contains(r#""outcome":"complete""#));
    assert!(!mesh.constrained().is_empty());
}

#[test]
fn crossings_are_an_error_unless_they_are_split() {
    let drawing = preset("degenerate-grid");
    let error = Mesh::constrain(&drawing, None, None)
        .err()
        .expect("crossings");
    assert!(error.to_string().contains("cross"), "{error}");
    let split = r#"{"crossings": "split"}"#.to_owned();
    let mesh = Mesh::constrain(&drawing, Some(split), None).expect("a mesh");
    assert!(Figures::of(&mesh).crossings_split > 0);
}

#[test]
fn unknown_options_are_refused() {
    for bad in [r#"{"minangle": 25}"#, r#"{"minAngle": "x"}"#, "nonsense"] {
        let refused = Mesh::refine(&preset("thesis"), Some(bad.to_owned()), None);
        let error = refused.err().expect("nonsense");
        assert!(error.to_string().starts_with("options: "), "{error}");
    }
    let impossible = r#"{"minAngle": 90}"#.to_owned();
    let refused = Mesh::refine(&preset("thesis"), Some(impossible), None);
    assert!(refused.is_err());
}

#[test]
fn points_on_a_line_have_no_triangles_and_no_measures() {
    let mesh = Mesh::triangulate(&preset("collinear"), None).expect("a mesh");
    assert!(mesh.triangles().is_empty());
    assert_eq!(mesh.edges().len(), 2 * 23);
    assert!(mesh.quality().contains(r#""minAngle":null"#));
}

fn thesis(options: &str) -> Mesh {
    Mesh::refine(&preset("thesis"), Some(options.to_owned()), None).expect("a mesh")
}

fn told(mesh: &Mesh) -> impl Iterator<Item = Explanation> + '_ {
    let triangles = 0..mesh.triangulation().num_triangles();
    triangles.map(|t| Explanation::of(mesh, t).expect("a triangle"))
}

#[test]
fn every_vertex_that_was_added_has_a_cause() {
    let rules = rules_of(&thesis(
        r#"{"thesis": true, "minAngle": 29, "maxEdge": 3, "explains": true}"#,
    ));
    assert!(rules.contains("size") && rules.len() > 1, "{rules:?}");
    let rules = rules_of(&thesis(
        r#"{"minAngle": 29, "maxArea": 0.5, "explains": true}"#,
    ));
    assert!(
        rules.contains("circumcenter") && rules.contains("size"),
        "{rules:?}"
    );
    let options = r#"{"minAngle": 30, "maxEdge": 0.25, "explains": true}"#.to_owned();
    let lake = Drawing::preset("lake", 0, 1).expect("a preset");
    let lake = Mesh::refine(&lake, Some(options), None).expect("a mesh");
    let rules = rules_of(&lake);
    assert!(
        rules.contains("lattice") && rules.contains("encroachment"),
        "{rules:?}"
    );
}

/// Lists why vertices were added, and checks each.
fn rules_of(mesh: &Mesh) -> std::collections::BTreeSet<&'static str> {
    let mut rules = std::collections::BTreeSet::new();
    for triangle in told(mesh) {
        for corner in triangle.vertices {
            let is_added = corner.origin != "input";
            assert_eq!(corner.cause.is_some(), is_added, "{}", corner.vertex);
            let Some(cause) = corner.cause else { continue };
            rules.insert(cause.rule);
            // What is sown has no parents.
            if cause.parent.is_empty() {
                let is_sown = cause.rule == "lattice" || corner.origin == "onSegment";
                assert!(is_sown, "{} for {}", corner.vertex, cause.rule);
                continue;
            }
            assert!((2..=3).contains(&cause.parent.len()));
            if corner.origin == "onSegment" {
                let [[ax, ay], [bx, by]] = cause.edge.expect("a divided edge");
                let [x, y] = corner.at;
                assert!(x >= ax.min(bx) && x <= ax.max(bx) && y >= ay.min(by) && y <= ay.max(by));
            }
        }
    }
    rules
}

#[test]
fn causes_change_nothing() {
    let options =
        |explains| format!(r#"{{"minAngle": 25, "maxArea": 0.1, "explains": {explains}}}"#);
    let (with, without) = (thesis(&options(true)), thesis(&options(false)));
    assert_eq!(with.hash(), without.hash());
    assert!(told(&without).all(|t| t.vertices.iter().all(|v| v.cause.is_none())));
}

/// A needle: its angle is of the input, and no mesh is better.
#[test]
fn a_small_angle_of_the_input_is_named() {
    let points = [0.0, 0.0, 10.0, 0.0, 10.0, 0.5];
    let needle = Drawing::new(&points, &[0, 1, 1, 2, 2, 0], &[]).expect("a drawing");
    let options = r#"{"minAngle": 25}"#.to_owned();
    let mesh = Mesh::refine(&needle, Some(options), None).expect("a mesh");
    let at_tip = told(&mesh).find(|t| t.corners.contains(&0)).expect("a tip");
    let unmet = at_tip.unmet.as_ref().expect("a small angle");
    assert_eq!(
        (&unmet.broken[..], unmet.reason),
        ("angle", "smallInputAngle")
    );
    assert_eq!((unmet.corner, unmet.segments), (Some(0), Some([0, 2])));
    assert!(unmet.excused);
    let english = mesh.sentence(at_tip.triangle, "en").expect("sentences");
    assert!(
        english.contains("25° asked for: segments 0 and 2 meet at vertex 0 at only 2.862°"),
        "{english}"
    );
    let german = mesh.sentence(at_tip.triangle, "de").expect("sentences");
    assert!(german.contains("unter nur 2,862°"), "{german}");
    mesh.sentence(at_tip.triangle, "fr")
        .expect_err("no such language");
}

#[test]
fn sentences_are_complete() {
    let split = r#"{"crossings": "split"}"#.to_owned();
    let crossing = Mesh::constrain(&preset("degenerate-grid"), Some(split), None);
    for mesh in [
        thesis(r#"{"thesis": true, "minAngle": 20, "maxEdge": 1, "explains": true}"#),
        thesis(r#"{"minAngle": 30, "maxVertices": 12}"#),
        crossing.expect("a mesh"),
        Mesh::triangulate(&preset("uniform"), None).expect("a mesh"),
    ] {
        for t in 0..mesh.triangulation().num_triangles() {
            for language in ["en", "de"] {
                let text = mesh.sentence(t, language).expect("sentences");
                assert!(text.ends_with('.') && !text.contains(['{', '}']), "{text}");
                assert!(
                    (2..=5).contains(&text.matches(". ").count().saturating_add(1)),
                    "{text}"
                );
            }
        }
    }
}

#[test]
fn hidden_vertices_are_seen() {
    // A wall between a triangle and a vertex within its circle.
    let points = [0.0, 0.0, 4.0, 0.0, 2.0, 3.0, 2.0, -0.5];
    let mesh = |segments: &[u32]| {
        let drawing = Drawing::new(&points, segments, &[]).expect("a drawing");
        let options = r#"{"domain": "hull"}"#.to_owned();
        Mesh::constrain(&drawing, Some(options), None).expect("a mesh")
    };
    let upper = |mesh: &Mesh| {
        told(mesh)
            .find(|t| t.corners.contains(&2))
            .expect("a triangle")
    };
    assert!(upper(&mesh(&[])).is_delaunay);
    let walled = upper(&mesh(&[0, 1]));
    assert!(!walled.is_delaunay);
    let [x, y] = walled.circumcenter.expect("a center");
    assert!(
        (x - 2.0).abs() < 1e-12
            && (f64::hypot(x, y) - walled.radius.expect("a radius")).abs() < 1e-12
    );
}

#[test]
fn triangles_are_found_where_they_are() {
    let mesh = thesis(r#"{"minAngle": 25, "maxEdge": 0.3}"#);
    let t = mesh.triangulation();
    for (i, corners) in t.triangles().iter().enumerate() {
        let [a, b, c] = corners.map(|v| t.point(v));
        let (x, y) = ((a.x + b.x + c.x) / 3.0, (a.y + b.y + c.y) / 3.0);
        assert_eq!(mesh.triangle_at(x, y), Some(i));
    }
    assert_eq!(mesh.triangle_at(1e9, 0.0), None);
    assert_eq!(mesh.triangle_at(f64::NAN, 0.0), None);
    let corner = mesh.points();
    assert!(mesh.triangle_at(corner[0], corner[1]).is_some());
}

#[test]
fn triangles_that_do_not_exist_are_refused() {
    let mesh = Mesh::triangulate(&preset("collinear"), None).expect("a mesh");
    let error = mesh.explain(0).expect_err("no triangles").to_string();
    assert_eq!(error, "there is no triangle 0: there are no triangles");
    assert_eq!(mesh.triangle_at(0.0, 0.0), None);
    assert!(mesh.measures("area").expect("a measure").is_empty());
}

/// Without segments the edges of the hull are what must stay; they have no numbers in the input.
#[test]
fn edges_of_the_hull_are_no_segments_of_the_input() {
    let points = [0.0, 0.0, 10.0, 0.0, 10.0, 0.5];
    let needle = Drawing::new(&points, &[], &[]).expect("a drawing");
    let options = r#"{"minAngle": 25}"#.to_owned();
    let mesh = Mesh::refine(&needle, Some(options), None).expect("a mesh");
    let at_tip = told(&mesh).find(|t| t.corners.contains(&0)).expect("a tip");
    let unmet = at_tip.unmet.as_ref().expect("a small angle");
    assert_eq!((unmet.corner, unmet.segments), (Some(0), None));
    let english = mesh.sentence(at_tip.triangle, "en").expect("sentences");
    assert!(
        english.contains("the domain has a corner of only 2.862° at vertex 0"),
        "{english}"
    );
}
