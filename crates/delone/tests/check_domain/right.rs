//! Right triangulations, and inputs that can have none.

use crate::claim::{RULES, add_square, crossed, lake, misread, point, right};
use delone::check::Defect;
use delone::{DomainRule, Error, Point, Pslg, Seed, VertexId};

#[test]
fn accepts_rings_in_rings_under_every_rule() {
    let counts = |rule| {
        let numbers = right(&lake(), rule).numbers();
        [numbers.components, numbers.holes, numbers.carved]
    };
    assert_eq!(counts(DomainRule::Hull), [1, 0, 0]);
    assert_eq!(counts(DomainRule::Carve), [1, 0, 1]);
    assert_eq!(counts(DomainRule::EvenOdd), [2, 1, 2]);
}

#[test]
fn accepts_crossings_and_names_what_it_proves() {
    let claim = right(&crossed(), DomainRule::Hull);
    let numbers = claim.numbers();
    assert_eq!((numbers.added, numbers.subsegments), (1, 8));
    let text = claim.verify().expect("right").to_string();
    assert!(text.starts_with("the canonical constrained Delaunay triangulation "));
    assert!(
        text.ends_with("8 subsegments, 1 added vertices, 1 components, 0 holes, 0 points outside")
    );
}

#[test]
fn accepts_what_has_no_triangles_only_where_nothing_is() {
    let open = || {
        let mut input = Pslg::from_points([(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (1.0, 3.0)]);
        input.add_polyline([0u32, 1, 2]);
        input
    };
    let line = || {
        let mut input = Pslg::from_points([(0.0, 0.0), (2.0, 2.0), (1.0, 1.0)]);
        input.add_segment(0, 1);
        input
    };
    for rule in RULES {
        right(&Pslg::default(), rule).numbers();
        right(&line(), rule).numbers();
        let mut claim = right(&open(), rule);
        claim.numbers();
        claim.triangles.clear();
        match rule {
            DomainRule::Hull => drop(assert_rejected!(claim, Defect::Uncovered { .. })),
            _ => assert_eq!(claim.numbers().components, 0),
        }
    }
    let mut claim = right(&lake(), DomainRule::Carve);
    claim.triangles.clear();
    assert_rejected!(claim, Defect::Uncovered { .. }, Defect::MissingPoint { .. });
}

#[test]
fn accepts_any_one_of_equal_points() {
    let mut input = lake();
    let copies = [input.points[0], input.points[13]];
    input.points.extend(copies);
    input.add_segment(17, 1);
    input.add_segment(18, 13);
    let mut claim = right(&input, DomainRule::Carve);
    let certificate = claim.verify().expect("right");
    assert_eq!(
        (
            certificate.points,
            certificate.vertices,
            certificate.duplicates
        ),
        (19, 17, 2)
    );
    for corner in claim.triangles.as_flattened_mut() {
        *corner = if corner.index() == 0 {
            17.into()
        } else {
            *corner
        };
    }
    assert_eq!(claim.verify(), Ok(certificate));
    // But not both.
    let corner = claim.triangles.as_flattened_mut();
    *corner
        .iter_mut()
        .find(|v| v.index() == 17)
        .expect("a corner") = 0.into();
    assert_rejected!(claim, Defect::SharedPosition { .. });
}

#[test]
fn accepts_crossings_that_round_to_points() {
    // The crossing is a point of the input now, though it lies on neither segment, and what comes
    // first there is a segment without length.
    let claim = right(&crossed(), DomainRule::Hull);
    let mut input = claim.input;
    let crossing = claim.points.len() as u32 - 1;
    input.points.push(claim.points[crossing as usize]);
    input
        .segments
        .insert(0, [crossing, crossing].map(VertexId::from));
    let claim = right(&input, DomainRule::Hull);
    assert_eq!(claim.numbers().added, 0);
    assert_eq!(claim.chains[5].len(), 3);
}

#[test]
fn accepts_a_chain_that_is_not_the_straight_way() {
    // Segment 0 is bent to vertex 9 before vertex 10, which lies upon it, comes to be.
    let steps = [
        (7, 7),
        (13, 2),
        (2, 11),
        (8, 1),
        (3, 4),
        (15, 11),
        (4, 6),
        (12, 6),
    ];
    let points = steps.map(|(x, y)| {
        let x = (0..x).fold(500_000.25, |x: f64, _| x.next_up());
        Point::new(x, (0..y).fold(4_500_000.5, |y: f64, _| y.next_up()))
    });
    let mut input = Pslg::from_points(points);
    for [a, b] in [[5, 0], [7, 2], [3, 4], [4, 3], [4, 5], [6, 3]] {
        input.add_segment(a, b);
    }
    right(&input, DomainRule::Hull).numbers();
}

#[test]
fn seeds_on_the_bare_hull_and_on_loose_points_stand_for_what_is_inside() {
    let mut input = Pslg::from_points([(0.0, 0.0), (8.0, 0.0), (8.0, 8.0), (0.0, 8.0)]);
    input
        .points
        .extend([point(4.0, 0.0), point(4.0, 8.0), point(2.0, 3.0)]);
    input.add_segment(4, 5);
    for at in [(0.0, 3.0), (0.0, 0.0), (2.0, 3.0), (1.0, 1.0)] {
        input.holes = vec![at.into()];
        let numbers = right(&input, DomainRule::Hull).numbers();
        assert_eq!((numbers.components, numbers.carved), (1, 3), "{at:?}");
    }
    input.holes = vec![point(-1.0, 3.0), point(9.0, 3.0)];
    assert_eq!(right(&input, DomainRule::Hull).numbers().carved, 0);
}

#[test]
fn polygons_are_united_each_by_its_own_parity() {
    let mut input = Pslg::default();
    for (x, half) in [(0.0, 4.0), (0.0, 2.0), (20.0, 4.0), (22.0, 4.0), (0.0, 1.0)] {
        add_square(&mut input, [x, 0.0], half);
    }
    // An outline with a hole; two that overlap; loose segments.
    input.polygons = vec![0..8, 8..12, 12..16];
    let numbers = right(&input, DomainRule::EvenOdd).numbers();
    assert_eq!(
        (numbers.components, numbers.holes, numbers.carved),
        (2, 1, 4)
    );
    // All together, the overlap is behind two segments and the innermost square behind three.
    input.polygons.clear();
    let numbers = right(&input, DomainRule::EvenOdd).numbers();
    assert_eq!(
        (numbers.components, numbers.holes, numbers.carved),
        (4, 1, 0)
    );
}

#[test]
fn polygons_must_be_closed_only_where_they_matter() {
    let mut input = lake();
    input.polygons.push(0..3);
    right(&input, DomainRule::Hull).numbers();
    right(&input, DomainRule::Carve).numbers();
}

#[test]
fn improper_inputs_are_errors_that_name_the_culprit() {
    let base = right(&lake(), DomainRule::EvenOdd);
    let error = |change: fn(&mut Pslg)| misread(base.clone(), |c| change(&mut c.input)).error();
    let found = error(|input| input.add_segment(3, 40));
    let vertex = 40.into();
    assert_eq!(
        found,
        Error::BadSegment {
            segment: 12,
            vertex,
            points: 17
        }
    );
    let found = error(|input| input.polygons.push(3..13));
    assert_eq!(
        found,
        Error::BadPolygon {
            polygon: 0,
            range: 3..13,
            segments: 12
        }
    );
    let found = error(|input| input.polygons.push(0..3));
    assert!(matches!(found, Error::OpenPolygon { polygon: 0, .. }));
    let found = error(|input| input.holes.push(point(f64::NAN, 0.0)));
    assert!(matches!(
        found,
        Error::SeedNotFinite {
            seed: Seed::Hole(0),
            ..
        }
    ));
    let found = error(|input| input.points[2].y = f64::INFINITY);
    assert!(matches!(found, Error::NotFinite { index: 2, .. }));
    for at in [point(-5.0, 1.0), point(5.0, 5.0)] {
        let mut claim = base.clone();
        claim.input.holes.push(at);
        let seed = Seed::Hole(0);
        let found = claim.error();
        assert!(matches!(found, Error::SeedOnSegment { seed: s, segment: 4..8, .. } if s == seed));
    }
}
