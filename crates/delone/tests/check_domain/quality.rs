//! Quality: which triangles break bounds, and what excuses them.

use crate::claim::{add_square, point};
use crate::mesh::Mesh;
use delone::check::{Asked, Counts, DomainMesh, Excuse, QualityVerdict, verify_quality};
use delone::{
    Angle, Broken, DomainRule, Error, Locked, Point, Pslg, Quality, Region, Seed, VertexId,
};

fn angle(degrees: f64) -> Quality {
    Quality {
        min_angle: Some(Angle::degrees(degrees)),
        ..Quality::default()
    }
}

fn edge(max_edge: f64) -> Quality {
    Quality {
        max_edge: Some(max_edge),
        ..Quality::default()
    }
}

fn area(max_area: f64) -> Quality {
    Quality {
        max_area: Some(max_area),
        ..Quality::default()
    }
}

fn square() -> Pslg {
    let mut input = Pslg::default();
    add_square(&mut input, [2.0, 2.0], 2.0);
    input
}

/// An outline of some corners.
fn outline<const N: usize>(corners: [(f64, f64); N]) -> Pslg {
    let mut input = Pslg::from_points(corners);
    input.add_ring(0..N as u32);
    input
}

fn carved(input: &Pslg) -> Mesh {
    Mesh::new(input, DomainRule::Carve)
}

fn counts(mesh: &Mesh, quality: Quality) -> Counts {
    mesh.judge(&Asked::new(quality)).counts()
}

fn num_unexcused(mesh: &Mesh, asked: &Asked) -> usize {
    mesh.judge(asked).counts().unexcused
}

#[test]
fn bounds_hold_up_to_rounding_and_no_further() {
    // Two right triangles with legs of 4.
    let mesh = carved(&square());
    let diagonal = 32.0_f64.sqrt();
    for (quality, unmet) in [
        (angle(45.0), 0),
        (angle(45.0 + 1e-6), 2),
        (edge(diagonal), 0),
        (edge(diagonal - 1e-6), 2),
        (area(8.0), 0),
        (area(8.0 - 1e-6), 2),
        (Quality::default(), 0),
    ] {
        let verdict = mesh.judge(&Asked::new(quality));
        assert_eq!(verdict.counts().unexcused, unmet, "{quality:?}");
        assert_eq!(verdict.is_met(), unmet == 0);
        assert_eq!(verdict.certificate.triangles, 2);
        for found in verdict.unmet {
            let broken = Broken {
                angle: quality.min_angle.is_some(),
                edge: quality.max_edge.is_some(),
                area: quality.max_area.is_some(),
            };
            assert_eq!((found.broken, found.shape.area), (broken, 8.0));
        }
    }
}

#[test]
fn sizes_may_depend_on_the_place() {
    let mut mesh = carved(&square());
    mesh.halve(0, 0);
    mesh.triangulate().unwrap();
    let unmet = |sizes: &dyn Fn(Point) -> [f64; 2]| {
        let asked = Asked::new(Quality::default()).sizes(sizes);
        num_unexcused(&mesh, &asked)
    };
    assert_eq!(unmet(&|_| [f64::NAN, 0.0]), 0);
    assert_eq!(unmet(&|_| [-1.0, 1.0]), 3);
    assert_eq!(unmet(&|_| [1.0, -1.0]), 3);
    // One triangle has its centroid to the right of 3, of area 4.
    assert_eq!(
        unmet(&|p| [f64::INFINITY, if p.x > 3.0 { 3.9 } else { 9.0 }]),
        1
    );
    assert_eq!(
        unmet(&|p| [f64::INFINITY, if p.x > 3.0 { 4.0 } else { 9.0 }]),
        0
    );
}

#[test]
fn regions_have_areas_of_their_own_only_if_asked() {
    let mut input = square();
    input.add_segment(0, 2);
    let region = |x, y, max_area| Region {
        at: point(x, y),
        attribute: 1.0,
        max_area,
    };
    input.regions = vec![region(3.0, 1.0, Some(5.0)), region(3.5, 1.0, Some(99.0))];
    input.regions.push(region(1.0, 3.0, None));
    let mesh = carved(&input);
    let by_region = Quality {
        region_areas: true,
        ..Quality::default()
    };
    assert_eq!(counts(&mesh, Quality::default()).unexcused, 0);
    let verdict = mesh.judge(&Asked::new(by_region));
    assert_eq!(verdict.unmet.len(), 1);
    let corners = mesh.corners(verdict.unmet[0].triangle);
    assert!(corners.contains(&point(4.0, 0.0)), "{corners:?}");

    let judge = |at| {
        let mut input = input.clone();
        input.regions[0].at = at;
        let edges = mesh.subsegments();
        let claim = DomainMesh::new(&mesh.points, &mesh.triangles, &edges);
        verify_quality(&input, mesh.rule, &claim, &Asked::new(by_region), &())
    };
    assert!(judge(point(3.0, 1.0)).is_ok());
    let seed = Seed::Region(0);
    let on_segment = judge(point(1.0, 1.0)).expect_err("a seed on a segment");
    assert!(matches!(on_segment, Error::SeedOnSegment { seed: s, segment: 4, .. } if s == seed));
    let nowhere = judge(point(1.0, f64::NAN)).expect_err("a seed that is nowhere");
    assert!(matches!(nowhere, Error::SeedNotFinite { seed: s, .. } if s == seed));
}

fn corner_of(verdict: &QualityVerdict, i: usize) -> (VertexId, [usize; 2], f64) {
    match verdict.unmet[i].excuse {
        Some(Excuse::SmallInputAngle {
            vertex,
            segments,
            angle,
        }) => (vertex, segments, angle.to_degrees()),
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_small_angle_of_the_input_excuses_the_triangle_at_it() {
    // 14 degrees at the first corner, 76 at the last.
    let mesh = carved(&outline([(0.0, 0.0), (4.0, 0.0), (4.0, 1.0)]));
    let verdict = mesh.judge(&Asked::new(angle(20.0)));
    let (vertex, segments, degrees) = corner_of(&verdict, 0);
    assert_eq!((vertex, segments), (VertexId::new(0), [0, 2]));
    assert!((degrees - 14.0362).abs() < 1e-3);
    assert!(verdict.is_met());
    // No size is excused by it, nor an angle together with a size.
    assert_eq!(counts(&mesh, edge(1.0)).unexcused, 1);
    let both = Quality {
        max_edge: Some(1.0),
        ..angle(20.0)
    };
    assert_eq!(counts(&mesh, both).unexcused, 1);
}

/// A wedge with a corner of so many degrees that is cut once on each side, equally far from it, and
/// then once more far off.
fn wedge(degrees: f64) -> Mesh {
    let (s, c) = degrees.to_radians().sin_cos();
    let mut mesh = carved(&outline([(0.0, 0.0), (8.0, 0.0), (8.0 * c, 8.0 * s)]));
    let ends = |segment: usize| [mesh.chains[segment][0], mesh.chains[segment][1]];
    let (lower, upper) = (ends(0), ends(2));
    mesh.split(lower, point(4.0, 0.0));
    mesh.split(upper, point(4.0 * c, 4.0 * s));
    mesh.triangulate().unwrap();
    mesh
}

#[test]
fn a_small_angle_excuses_triangles_whose_shortest_edge_joins_its_sides() {
    // The triangle at the corner, and two beyond, one with its shortest edge from side to side.
    let mesh = wedge(5.0);
    let verdict = mesh.judge(&Asked::new(angle(20.0)));
    assert_eq!(verdict.counts().small_input_angle, 3, "{verdict:?}");
    for i in 0..3 {
        let (vertex, segments, degrees) = corner_of(&verdict, i);
        assert_eq!((vertex, segments), (VertexId::new(0), [0, 2]));
        assert!((degrees - 5.0).abs() < 1e-9);
    }
}

#[test]
fn corners_of_60_degrees_excuse_nothing() {
    let at_corner = |degrees, bound| {
        let mesh = wedge(degrees);
        let verdict = mesh.judge(&Asked::new(angle(bound)));
        let is_at_corner = |t| mesh.corners(t).contains(&point(0.0, 0.0));
        let mut unmet = verdict.unmet.iter().filter(|u| is_at_corner(u.triangle));
        unmet.next().expect("too small").excuse
    };
    assert!(at_corner(59.9, 59.95).is_some());
    // Here the two other angles are too small, and not between segments.
    assert_eq!(at_corner(60.1, 59.99), None);
}

#[test]
fn skinny_triangles_away_from_small_angles_have_no_excuse() {
    let mut mesh = carved(&square());
    mesh.free(2.0, 0.1);
    mesh.triangulate().unwrap();
    let verdict = mesh.judge(&Asked::new(angle(20.0)));
    assert_eq!(verdict.counts().unexcused, 1);
    let corners = mesh.corners(verdict.unmet[0].triangle);
    assert!(corners.contains(&point(2.0, 0.1)));
    assert!(!verdict.is_met());
}

#[test]
fn segments_meet_where_one_ends_on_the_other_and_where_they_cross() {
    for (line, vertex) in [
        // From below the lower side, through it.
        ([point(-4.0, -1.0), point(4.0, 1.0)], None),
        // From the lower side.
        ([point(0.0, 0.0), point(4.0, 1.0)], Some(point(0.0, 0.0))),
    ] {
        let mut input = outline([(-8.0, 0.0), (8.0, 0.0), (8.0, 8.0), (-8.0, 8.0)]);
        input.points.extend([point(-8.0, -8.0), point(8.0, -8.0)]);
        input.add_polyline([0u32, 4, 5, 1]);
        let ends = [6u32, 7].map(VertexId::from);
        input.points.extend(line);
        input.segments.push(ends);
        let mut mesh = carved(&input);
        // Cut both at 3 and at 1.5 of the meeting point, the side 4 to the right.
        let lower = mesh.chains[0].clone();
        let far = mesh.split([lower[1], lower[2]], point(2.5, 0.0));
        mesh.split([lower[1], far], point(1.25, 0.0));
        let upper = mesh.chains[7].clone();
        let from = upper[upper.len() - 2];
        let far = mesh.split([from, upper[upper.len() - 1]], point(2.4, 0.6));
        mesh.split([from, far], point(1.2, 0.3));
        mesh.triangulate().unwrap();
        let verdict = mesh.judge(&Asked::new(angle(13.9)));
        let joined: Vec<_> = verdict
            .unmet
            .iter()
            .filter(|u| {
                mesh.corners(u.triangle)
                    .iter()
                    .all(|p| p.x > 0.5 && p.x < 3.0)
            })
            .collect();
        for unmet in &joined {
            let Some(Excuse::SmallInputAngle {
                vertex: found,
                segments,
                angle,
            }) = unmet.excuse
            else {
                panic!("{unmet:?}");
            };
            let at = mesh.points[found.index()];
            assert_eq!(at, vertex.unwrap_or(point(0.0, 0.0)));
            assert_eq!(segments, [0, 7]);
            assert!((angle.to_degrees() - 14.0362).abs() < 1e-3);
        }
        assert!(!joined.is_empty(), "{verdict:?}");
    }
}

#[test]
fn segments_on_one_line_do_not_meet() {
    // The lower side is drawn twice, and a vertex lies close to it.
    let mut input = square();
    input.add_segment(0, 1);
    input.points.push(point(2.0, 0.0));
    input.add_segment(0, 4);
    let mut mesh = carved(&input);
    mesh.free(1.0, 0.05);
    mesh.free(3.0, 0.05);
    mesh.triangulate().unwrap();
    let counts = counts(&mesh, angle(10.0));
    assert_eq!((counts.small_input_angle, counts.unexcused > 0), (0, true));
}

#[test]
fn edges_of_the_hull_are_segments() {
    let input = Pslg::from_points([(0.0, 0.0), (8.0, 0.0), (8.0, 1.0)]);
    let mesh = Mesh::new(&input, DomainRule::Hull);
    let verdict = mesh.judge(&Asked::new(angle(20.0)));
    assert_eq!(corner_of(&verdict, 0).1, [0, 2]);
}

#[test]
fn what_must_not_be_split_excuses_the_triangles_at_it() {
    let mut input = square();
    input.points.extend([point(1.0, 2.0), point(3.0, 2.0)]);
    input.add_segment(4, 5);
    let mut mesh = carved(&input);
    mesh.free(2.0, 1.0);
    mesh.triangulate().unwrap();
    let judge = |locked| {
        let verdict = mesh.judge(&Asked::new(edge(0.1)).locked(locked));
        let counts = verdict.counts();
        assert!(verdict.on_locked.is_empty());
        [counts.locked, counts.unexcused]
    };
    let all = mesh.triangles.len();
    assert_eq!(judge(Locked::Nothing), [0, all]);
    // The others hang on those at the boundary by their longest edges.
    assert_eq!(judge(Locked::Boundary), [all, 0]);
    assert_eq!(judge(Locked::Segments), [all, 0]);
    // Two triangles on both sides of their longest edge hang on nothing.
    for (x, y) in [(1.9, 1.5), (2.1, 1.5), (2.0, 1.33), (2.0, 1.67)] {
        mesh.free(x, y);
    }
    mesh.triangulate().unwrap();
    let verdict = mesh.judge(&Asked::new(edge(0.15)).locked(Locked::Boundary));
    assert!(verdict.counts().unexcused >= 2);
}

#[test]
fn what_must_not_be_split_must_not_have_been() {
    let mut input = square();
    input.add_segment(0, 2);
    let mut mesh = carved(&input);
    let inner = mesh.halve(4, 0);
    let outer = mesh.halve(0, 0);
    mesh.triangulate().unwrap();
    for (locked, expected) in [
        (Locked::Nothing, vec![]),
        (Locked::Boundary, vec![outer]),
        (Locked::Segments, vec![inner, outer]),
    ] {
        let verdict = mesh.judge(&Asked::new(Quality::default()).locked(locked));
        assert_eq!(verdict.on_locked, expected);
        assert_eq!(verdict.is_met(), expected.is_empty());
    }
    // A crossing is no Steiner point.
    input.add_segment(1, 3);
    let verdict = carved(&input).judge(&Asked::new(Quality::default()).locked(Locked::Segments));
    assert!(verdict.is_met());
}

#[test]
fn precision_excuses_only_what_is_a_few_thousand_units_long() {
    let unit = f64::EPSILON;
    for (width, is_excused) in [(4095.0, true), (4097.0, false)] {
        let width = width * unit;
        let mut input = outline([
            (0.0, 1.0),
            (1.0, 1.0),
            (1.0, 1.0 + width),
            (0.0, 1.0 + width),
        ]);
        input.points[2].x = 1.0;
        let mesh = carved(&input);
        let asked = Quality {
            max_edge: Some(0.5),
            ..angle(20.0)
        };
        let counts = counts(&mesh, asked);
        let expected = if is_excused { [2, 0] } else { [0, 2] };
        assert_eq!([counts.precision, counts.unexcused], expected);
    }
}

#[test]
fn conforming_meshes_have_no_vertex_in_a_diametral_circle() {
    let mut input = Pslg::default();
    add_square(&mut input, [2.0, 2.0], 8.0);
    input.points.extend([point(1.0, 2.0), point(3.0, 2.0)]);
    input.add_segment(4, 5);
    let mut mesh = carved(&input);
    for side in 0..4 {
        mesh.halve(side, 0);
    }
    mesh.triangulate().unwrap();
    let encroached = |mesh: &Mesh, locked| {
        let asked = Asked::new(Quality::default()).conforming().locked(locked);
        let verdict = mesh.judge(&asked);
        let unexcused = verdict.encroached.iter().filter(|e| e.excuse.is_none());
        assert_eq!(verdict.is_met(), unexcused.count() == 0);
        verdict.encroached
    };
    assert!(encroached(&mesh, Locked::Nothing).is_empty());
    // On the circle is not inside.
    let apex = mesh.free(2.0, 1.0);
    mesh.triangulate().unwrap();
    assert!(encroached(&mesh, Locked::Nothing).is_empty());
    mesh.points[apex.index()].y = 1.5;
    mesh.triangulate().unwrap();
    let found = encroached(&mesh, Locked::Nothing);
    let mut edge = found[0].edge;
    edge.sort_unstable();
    assert_eq!((found.len(), edge), (1, [4, 5].map(VertexId::new)));
    assert_eq!((found[0].apex, found[0].excuse), (apex, None));
    let asked = Asked::new(Quality::default()).conforming();
    let locked = mesh.judge(&asked.locked(Locked::Segments)).encroached;
    assert_eq!(locked[0].excuse, Some(Excuse::Locked));
    // Nobody asked.
    let verdict = mesh.judge(&Asked::new(Quality::default()));
    assert!(verdict.encroached.is_empty());
}

#[test]
fn a_vertex_too_close_to_a_segment_for_another_excuses_that_it_is_encroached_upon() {
    for (units, excuse) in [(4095.0, Some(Excuse::Precision)), (4097.0, None)] {
        let mut input = Pslg::default();
        add_square(&mut input, [2.0, 2.0], 8.0);
        input.points.extend([point(0.5, 1.0), point(1.5, 1.0)]);
        input.add_segment(4, 5);
        let mut mesh = carved(&input);
        let apex = mesh.free(1.0, 1.0 + units * f64::EPSILON);
        mesh.triangulate().unwrap();
        let verdict = mesh.judge(&Asked::new(Quality::default()).conforming());
        let found = verdict.encroached.iter().find(|e| e.apex == apex);
        assert_eq!(found.unwrap().excuse, excuse, "{units} units");
    }
}

#[test]
fn the_worst_come_first() {
    let mut mesh = wedge(5.0);
    let inside = point(7.9, 0.3);
    mesh.free(inside.x, inside.y);
    mesh.triangulate().unwrap();
    let verdict = mesh.judge(&Asked::new(angle(40.0)));
    let keys: Vec<_> = verdict
        .unmet
        .iter()
        .map(|u| (u.excuse.is_some(), u.shape.min_angle()))
        .collect();
    assert!(
        keys.is_sorted_by(|a, b| a.partial_cmp(b).is_some_and(|o| o.is_le())),
        "{keys:?}"
    );
    assert!(keys.len() > 3);
}

#[test]
fn wrong_meshes_have_no_quality_and_senseless_bounds_are_errors() {
    let mesh = carved(&square());
    let edges = mesh.subsegments();
    let claim = DomainMesh::new(&mesh.points, &mesh.triangles[1..], &edges);
    let judge = |quality| verify_quality(&mesh.input, mesh.rule, &claim, &Asked::new(quality), &());
    assert!(judge(angle(20.0)).unwrap().is_err());
    for senseless in [angle(60.0), edge(0.0), area(f64::NAN)] {
        assert!(matches!(judge(senseless), Err(Error::BadQuality { .. })));
    }
}
