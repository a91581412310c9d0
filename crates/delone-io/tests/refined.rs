//! Refined meshes: what their Steiner points inherit.

use delone::{
    DomainRule, Origin, Point, Quality, RefinedMesh, Refinement, SegmentPolicy, VertexId,
};
use delone_io::{Attribute, DomainData, Inherited, PointSet};

/// A domain of points with one attribute, and segments with markers.
fn domain(points: &[(f64, f64)], values: Vec<f64>, segments: &[([usize; 2], i32)]) -> DomainData {
    DomainData {
        vertices: PointSet {
            points: points.iter().map(|&p| Point::from(p)).collect(),
            attributes: vec![Attribute {
                name: "height".to_owned(),
                values,
            }],
            markers: Some(vec![9; points.len()]),
            ..PointSet::default()
        },
        segments: segments
            .iter()
            .map(|(ends, _)| ends.map(VertexId::new))
            .collect(),
        segment_markers: Some(segments.iter().map(|&(_, marker)| marker).collect()),
        ..DomainData::default()
    }
}

fn refine(domain: &DomainData, max_area: f64, rule: DomainRule) -> (RefinedMesh, Inherited) {
    let mut domain = domain.clone();
    let quality = Quality {
        max_area: Some(max_area),
        ..Quality::default()
    };
    let refined = Refinement::new(quality)
        .crossings(SegmentPolicy::Split)
        .domain(rule)
        .mesh(domain.take_pslg())
        .expect("a domain");
    let inherited = Inherited::new(&refined.mesh, domain, &()).expect("its own domain");
    (refined, inherited)
}

/// Visits the Steiner points: origin, position, attribute and marker.
fn steiner<'a>(
    refined: &'a RefinedMesh,
    inherited: &'a Inherited,
) -> impl Iterator<Item = (Origin, Point, f64, i32)> + 'a {
    let n = refined.mesh.triangulation().points().len();
    let markers = inherited.markers.as_deref().expect("markers");
    assert_eq!(
        (inherited.attributes[0].values.len(), markers.len()),
        (n, n)
    );
    assert!(refined.mesh.num_steiner() > 20);
    (n - refined.mesh.num_steiner()..n).map(move |v| {
        let id = VertexId::new(v);
        (
            refined.mesh.origin(id),
            refined.mesh.triangulation().point(id),
            inherited.attributes[0].values[v],
            markers[v],
        )
    })
}

const SQUARE: [(f64, f64); 4] = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)];

/// A square with two towers beside a valley from corner to corner, which only its segment makes: the
/// Delaunay triangulation joins the towers.
fn valley() -> DomainData {
    let towers = [(1.9, 2.2), (2.2, 1.9)];
    let points: Vec<_> = SQUARE.into_iter().chain(towers).collect();
    let segments = [
        ([0, 1], 1),
        ([1, 2], 0),
        ([2, 3], 3),
        ([3, 0], 4),
        ([0, 2], 0),
    ];
    domain(&points, vec![0.0, 0.0, 0.0, 0.0, 8.0, 8.0], &segments)
}

#[test]
fn breaklines_stay_breaklines() {
    let (refined, inherited) = refine(&valley(), 0.01, DomainRule::Carve);
    let mut near = 0;
    for (origin, p, height, _) in steiner(&refined, &inherited) {
        assert!((0.0..=8.0).contains(&height));
        let distance = (p.x - p.y).abs();
        if origin == Origin::OnSegment(4) {
            assert_eq!(height, 0.0, "{p:?}");
        } else if distance < 0.1 {
            // The towers stand 0.3 off the line, and are 8 high.
            assert!(height <= distance * 8.0 / 0.3 + 1e-9, "{p:?}: {height}");
            near += 1;
        }
    }
    assert!(near > 5, "{near}");
}

#[test]
fn markers_are_those_of_the_edge_or_of_the_boundary() {
    let (refined, inherited) = refine(&valley(), 0.01, DomainRule::Carve);
    let mut seen = [0; 6];
    for (origin, p, _, marker) in steiner(&refined, &inherited) {
        let (expected, kind) = match origin {
            Origin::OnSegment(0) => (1, 0),
            // Without marker, but on the boundary.
            Origin::OnSegment(1) => (1, 1),
            Origin::OnSegment(2) => (3, 2),
            Origin::OnSegment(3) => (4, 3),
            // Without marker, and inside.
            Origin::OnSegment(4) => (0, 4),
            Origin::Free => (0, 5),
            other => panic!("{other:?} is no Steiner point"),
        };
        assert_eq!(marker, expected, "{origin:?} at {p:?}");
        seen[kind] += 1;
    }
    assert!(seen.iter().all(|&n| n > 0), "{seen:?}");
}

#[test]
fn edges_of_the_hull_are_marked_as_a_boundary() {
    let mut bare = domain(&SQUARE, vec![1.0, 5.0, 13.0, 9.0], &[]);
    let (refined, inherited) = refine(&bare, 0.05, DomainRule::Hull);
    assert_eq!(refined.mesh.num_input_segments(), 0);
    for (origin, p, height, marker) in steiner(&refined, &inherited) {
        assert!((height - (1.0 + p.x + 2.0 * p.y)).abs() < 1e-12, "{p:?}");
        assert_eq!(marker, i32::from(origin != Origin::Free), "{p:?}");
    }
    let constraints = &inherited.constraints;
    assert!(constraints.edges.len() > 4);
    let markers = constraints.markers.as_deref().expect("markers");
    assert!(markers.iter().all(|&marker| marker == 1));
    // What has no markers gets none.
    (bare.segment_markers, bare.vertices.markers) = (None, None);
    let (_, inherited) = refine(&bare, 0.05, DomainRule::Hull);
    assert_eq!(
        (inherited.markers, inherited.constraints.markers),
        (None, None)
    );
}

#[test]
fn values_run_between_the_vertices_along_a_segment() {
    // The segment 0–1 goes through vertex 4, of another height, and is crossed by 5–6 at (3, 0).
    let points: Vec<_> = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)]
        .into_iter()
        .chain([(1.0, 0.0), (3.0, -1.0), (3.0, 1.0)])
        .collect();
    let ring = [
        ([0, 1], 5),
        ([1, 2], 6),
        ([2, 3], 7),
        ([3, 0], 8),
        ([5, 6], 2),
    ];
    let values = vec![0.0, 40.0, 0.0, 0.0, -6.0, 10.0, 10.0];
    let domain = domain(&points, values, &ring);
    let (refined, inherited) = refine(&domain, 0.01, DomainRule::Hull);
    assert_eq!(inherited.constraints.crossings, 7..8);
    // Crossings are interpolated along the first segment from end to end: 30 at x = 3.
    assert_eq!(inherited.attributes[0].values[7], 30.0);
    let mut seen = [0; 3];
    for (origin, p, height, marker) in steiner(&refined, &inherited) {
        if origin != Origin::OnSegment(0) {
            continue;
        }
        let (piece, expected) = match p.x {
            x if x < 1.0 => (0, -6.0 * x),
            x if x < 3.0 => (1, -6.0 + 18.0 * (x - 1.0)),
            x => (2, 30.0 + 10.0 * (x - 3.0)),
        };
        assert!((height - expected).abs() < 1e-12, "{p:?}: {height}");
        assert_eq!(marker, 5);
        seen[piece] += 1;
    }
    assert!(seen.iter().all(|&n| n > 0), "{seen:?}");
}

#[test]
fn duplicates_and_what_is_carved_do_no_harm() {
    let mut points = SQUARE.to_vec();
    points.extend([(4.0, 0.0), (9.0, 9.0)]);
    let ring = [([0, 4], 1), ([4, 2], 2), ([2, 3], 3), ([3, 0], 4)];
    // Of equal points the first one counts.
    let values = vec![1.0, 5.0, 13.0, 9.0, 1e9, 1e9];
    let (refined, inherited) = refine(&domain(&points, values, &ring), 0.05, DomainRule::Carve);
    for (origin, p, height, _) in steiner(&refined, &inherited) {
        assert!(
            (height - (1.0 + p.x + 2.0 * p.y)).abs() < 1e-12,
            "{origin:?} {p:?}"
        );
    }
}
