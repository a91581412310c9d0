//! Triangles that hold too many data, and what excuses them.

use super::cover::{Cover, points};
use delone::check::SpecialCause;
use delone::predicates::{Orientation, orient2d};
use delone::{Point, TriangleId, VertexId};
use delone_testkit::generate::Random;
use delone_testkit::naive::naive_sharing;

fn cause(data: &[(f64, f64)], least: usize) -> Option<SpecialCause> {
    let found = Cover::triangle(data, least).certificate();
    let case = found.special.first()?;
    assert_eq!((case.triangle, case.data), (TriangleId::new(0), data.len()));
    let is_unexcused = case.cause == SpecialCause::Unexcused;
    assert_eq!(found.unexcused(), usize::from(is_unexcused));
    Some(case.cause)
}

#[test]
fn two_less_than_the_bound_and_the_bound() {
    let inside = [(1., 1.), (2., 1.), (1., 2.), (3., 1.), (1., 3.), (2., 3.)];
    assert_eq!(cause(&inside[..5], 2), None);
    assert_eq!(cause(&inside, 2), Some(SpecialCause::Unexcused));
}

#[test]
fn too_many_on_an_edge() {
    let mut data = vec![(1., 0.), (2., 0.), (3., 0.), (0., 0.), (12., 0.), (1., 1.)];
    // Ends do not belong to the open edge: three of six are left.
    let edge = [0, 1].map(VertexId::new);
    assert_eq!(cause(&data, 2), Some(SpecialCause::Edge { edge, data: 3 }));
    data.push((2., 2.));
    assert_eq!(cause(&data, 2), Some(SpecialCause::Unexcused));
    for slanted in [(6., 6.), (5., 7.), (7., 5.), (8., 4.), (9., 3.), (2., 10.)] {
        data.push(slanted);
    }
    data.retain(|&p| p != (1., 0.));
    let edge = [1, 2].map(VertexId::new);
    assert_eq!(cause(&data, 4), Some(SpecialCause::Edge { edge, data: 6 }));
}

#[test]
fn too_many_on_two_edges() {
    let mut data = vec![
        (1., 0.),
        (2., 0.),
        (3., 0.),
        (0., 1.),
        (0., 2.),
        (0., 3.),
        (0., 0.),
        (1., 1.),
    ];
    let corner = VertexId::new(0);
    assert_eq!(
        cause(&data, 2),
        Some(SpecialCause::TwoEdges { corner, data: 7 })
    );
    // An outer end is left for the third part.
    data.push((12., 0.));
    assert_eq!(cause(&data, 2), Some(SpecialCause::Unexcused));
}

#[test]
fn several_are_listed_in_order() {
    let mut cover = Cover::lattice(2);
    cover.least = 2;
    let found = cover.certificate();
    let listed: Vec<_> = found
        .special
        .iter()
        .map(|case| case.triangle.index())
        .collect();
    assert!(listed.is_sorted() && listed.len() == 8, "{listed:?}");
    assert!(found.to_string().contains("8 special cases"), "{found}");
}

/// Tells whether one of the vertices at halves leaves enough to each of the three parts.
fn can_be_opened(cover: &Cover) -> bool {
    let [a, b, c] = [0, 1, 2].map(|v| cover.points[v]);
    let halves = (0..24 * 24).map(|i| Point::new(f64::from(i % 24) / 2.0, f64::from(i / 24) / 2.0));
    let is_inside = |&t: &Point| {
        [(a, b), (b, c), (c, a)]
            .iter()
            .all(|&(p, q)| orient2d(p, q, t) == Orientation::Left)
    };
    let parts = [[1, 2, 3], [2, 0, 3], [0, 1, 3]].map(|t| t.map(VertexId::new));
    halves.filter(is_inside).any(|t| {
        let corners = [a, b, c, t];
        naive_sharing(&corners, &parts, &cover.data, cover.least).is_some()
    })
}

#[test]
fn what_is_excused_cannot_be_opened() {
    let mut random = Random::new(3);
    let mut seen = [0; 4];
    for _ in 0..400 {
        let least = 1 + random.below(2);
        let mut data: Vec<(f64, f64)> = Vec::new();
        for _ in 0..3 * least + random.below(3) {
            let along = random.below(13) as f64;
            data.push(match random.below(6) {
                0 | 1 => (along, 0.),
                2 | 3 => (0., along),
                4 => (along, 12. - along),
                _ => (1. + random.below(5) as f64, 1. + random.below(5) as f64),
            });
        }
        data.sort_by(|a, b| a.partial_cmp(b).expect("numbers"));
        data.dedup();
        let cover = Cover::triangle(&data, least);
        let Ok(found) = cover.verify() else { continue };
        let Some(case) = found.special.first() else {
            continue;
        };
        let is_open = can_be_opened(&cover);
        match case.cause {
            SpecialCause::Unexcused => seen[2 + usize::from(is_open)] += 1,
            cause => {
                assert!(!is_open, "{cause:?}, {:?}", points(&data));
                seen[usize::from(matches!(cause, SpecialCause::TwoEdges { .. }))] += 1;
            }
        }
    }
    // Both excuses have been seen, and triangles that need none since they can be opened; few that cannot be opened
    // at halves.
    assert!(
        seen[0] > 20 && seen[1] > 2 && seen[3] > 10 * seen[2],
        "{seen:?}"
    );
}
