//! Polygons of degenerate data, reduced to the last corner; each step against its definition.

use super::*;
use crate::predicates::{Orientation, compare_lengths, orient2d, turning};
use crate::scattered::samples;
use delone_testkit::generate::Kind;

/// Strictly convex, and nothing is outside.
fn assert_contains(polygon: &[Point], points: &[Point]) {
    let n = polygon.len();
    assert!(n > 2);
    for i in 0..n {
        let [a, b, c] = [i, i + 1, i + 2].map(|k| polygon[k % n]);
        assert_eq!(orient2d(a, b, c), Orientation::Left, "{polygon:?}");
        let is_out = |&&p: &&Point| orient2d(a, b, p) == Orientation::Right;
        assert_eq!(points.iter().find(is_out), None, "{polygon:?}");
    }
    // Convex in each corner may still go round twice.
    let is_descent = |i: &usize| polygon[*i].lex_cmp(&polygon[(i + 1) % n]).is_gt();
    let turns = (0..n).filter(|&i| is_descent(&i) && !is_descent(&((i + 1) % n)));
    assert_eq!(turns.count(), 1);
}

/// The shortest edge that may shrink, by looking at each.
fn shortest(outline: &Outline) -> Option<[usize; 2]> {
    let corners: Vec<_> = outline.corners().collect();
    let n = corners.len();
    let edges = (0..n).map(|i| [i + n - 1, i, i + 1, i + 2].map(|k| corners[k % n]));
    let mut best: Option<[(usize, Point); 2]> = None;
    for [p, a, b, q] in edges {
        let may = turning([p.1, a.1], [b.1, q.1]) == Orientation::Left;
        let is_shorter = best.is_none_or(|[c, d]| compare_lengths([a.1, b.1], [c.1, d.1]).is_lt());
        if may && is_shorter {
            best = Some([a, b]);
        }
    }
    best.map(|ends| ends.map(|(i, _)| i))
}

/// Reduces to a triangle, and counts the edges that have shrunk, and whether it ended enclosed.
fn reduce_to_triangle(outline: &mut Outline, data: &[Point]) -> (usize, bool) {
    let mut shrunk = 0;
    while !outline.is_triangle() {
        let before = outline.points();
        let expected = shortest(outline);
        match outline.reduce().expect("no triangle") {
            Reduction::Edge { ends, at } => {
                shrunk += 1;
                assert_eq!(Some(ends), expected);
                assert!(outline.corners().any(|corner| corner == (ends[0], at)));
                assert!(outline.corners().all(|(i, _)| i != ends[1]));
                let after = outline.points();
                assert!(after.len() < before.len());
                assert_contains(&after, &before);
            }
            Reduction::Enclosed => {
                assert_contains(&outline.points(), data);
                return (shrunk, true);
            }
        }
    }
    assert_eq!(outline.reduce(), None);
    (shrunk, false)
}

#[test]
fn degenerate_data_are_contained_to_the_last_corner() {
    let [mut shrunk, mut enclosed, mut refused] = [0; 3];
    for (kind, seed) in Kind::ALL
        .into_iter()
        .flat_map(|k| (0..6).map(move |s| (k, s)))
    {
        let data = samples(kind, [1, 2, 3, 5, 20, 60][seed as usize], seed);
        for factor in [1.0, 1.0 + f64::EPSILON, 1.1, 3.0] {
            let Ok(mut outline) = Outline::around(&data, factor) else {
                let largest = data.iter().flat_map(|p| [p.x.abs(), p.y.abs()]);
                assert!(largest.fold(0.0, f64::max) > 1e307, "{kind:?} is refused");
                refused += 1;
                continue;
            };
            assert_contains(&outline.points(), &data);
            let (edges, is_enclosed) = reduce_to_triangle(&mut outline, &data);
            shrunk += edges;
            enclosed += usize::from(is_enclosed);
        }
    }
    assert!(
        shrunk > 300 && enclosed > 10 && refused < 40,
        "{shrunk} {enclosed} {refused}"
    );
}

#[test]
fn points_an_ulp_apart_and_of_any_size_are_contained() {
    let base = [
        [0.0, 0.0],
        [1.0, 0.0],
        [2.0, 1.0],
        [2.0, 2.0],
        [1.0, 3.0],
        [-1.0, 2.0],
        [0.0, 1.0],
    ];
    for (scale, offset) in [
        (f64::EPSILON, 1.0),
        (2.0 * f64::EPSILON, 1.0),
        (1e-10, 1e6),
        (5e-324, 0.0),
        (1e-320, 0.0),
        (1e-300, 0.0),
        (1e300, 0.0),
        (1e307, 0.0),
        (1e292, 1e307),
    ] {
        let data = base.map(|[x, y]| Point::new(offset + scale * x, offset + scale * y));
        for factor in [1.0, 1.1] {
            let mut outline = Outline::around(&data, factor).expect("room");
            assert_contains(&outline.points(), &data);
            reduce_to_triangle(&mut outline, &data);
            assert_contains(&outline.points(), &data);
        }
    }
}

/// Example 3.33: twenty data, and three times an edge shrinks, until one triangle is left.
#[test]
fn twenty_data_end_in_one_triangle_after_three_reductions() {
    let hull = [
        [10.0, 4.0],
        [7.0, 9.0],
        [2.0, 8.0],
        [0.0, 5.0],
        [1.0, 1.0],
        [6.0, 0.0],
    ];
    let inside = (0..14).map(|i| [3.0 + f64::from(i % 4), 3.0 + f64::from(i / 4)]);
    let data: Vec<Point> = hull.into_iter().chain(inside).map(Point::from).collect();
    assert_eq!(data.len(), 20);
    let mut outline = Outline::around(&data, 1.1).expect("room");
    assert_eq!(outline.points().len(), 6);
    assert_eq!(reduce_to_triangle(&mut outline, &data), (3, false));
    assert_contains(&outline.points(), &data);
}

#[test]
fn a_meeting_is_the_exact_one_where_that_can_be_written() {
    let house = [
        [4.0, 0.0],
        [4.0, 2.0],
        [3.0, 3.0],
        [1.0, 3.0],
        [0.0, 2.0],
        [0.0, 0.0],
    ];
    let mut outline = Outline::around(&house.map(Point::from), 1.0).expect("room");
    // From the rightmost: (4, 2), (3, 3), (1, 3), (0, 2), (0, 0), (4, 0).
    let at = Point::new(4.0, 3.0);
    assert_eq!(outline.reduce(), Some(Reduction::Edge { ends: [0, 1], at }));
    let at = Point::new(0.0, 3.0);
    assert_eq!(outline.reduce(), Some(Reduction::Edge { ends: [2, 3], at }));
    assert_eq!(outline.points().len(), 4);
    // A rectangle.
    assert_eq!(outline.reduce(), Some(Reduction::Enclosed));
    assert_contains(&outline.points(), &house.map(Point::from));
}

/// Rounded, opposite sides of rectangles are parallel or not, as it happens.
#[test]
fn rectangles_do_not_become_needles() {
    let mut met = 0;
    for angle in (1..200).map(f64::from) {
        let [u, v] = [(0.3 * angle).cos(), (0.3 * angle).sin()];
        let corner = |x: f64, y: f64| Point::new(1e3 + u * x - v * y, v * x + u * y);
        let data = [
            corner(0.0, 0.0),
            corner(3.0, 0.0),
            corner(3.0, 1.0),
            corner(0.0, 1.0),
        ];
        let mut outline = Outline::around(&data, 1.0).expect("room");
        met += usize::from(shortest(&outline).is_some());
        assert_eq!(outline.reduce(), Some(Reduction::Enclosed));
        assert_contains(&outline.points(), &data);
    }
    assert!(met > 100, "{met}");
}

#[test]
fn the_first_and_the_last_corner_are_neighbours() {
    // Its shortest edge is from the last corner to the first.
    let data = [
        [5.0, 1.0],
        [0.0, 9.0],
        [-7.0, 3.0],
        [-2.0, -4.0],
        [4.5, 0.0],
    ];
    let data = data.map(Point::from);
    let mut outline = Outline::around(&data, 1.0).expect("room");
    let Some(Reduction::Edge { ends, at }) = outline.reduce() else {
        panic!("{outline:?}");
    };
    assert_eq!(ends, [4, 0]);
    assert_eq!(outline.corners().last(), Some((4, at)));
    assert_contains(&outline.points(), &data);
}

#[test]
fn what_cannot_be_is_refused() {
    assert!(matches!(
        Outline::around(&[], 1.1),
        Err(Error::TooFewData { .. })
    ));
    let data = [Point::new(0.0, 0.0)];
    for factor in [0.5, -1.0, f64::NAN, f64::INFINITY] {
        let refused = Outline::around(&data, factor);
        assert!(matches!(refused, Err(Error::BadChoice { .. })));
    }
    let refused = Outline::around(&[Point::new(f64::MAX, 0.0)], 1.1);
    assert!(matches!(refused, Err(Error::BadChoice { .. })));
}

#[test]
fn many_corners_go_one_by_one() {
    let data = samples(Kind::Circle, 4000, 1);
    let mut outline = Outline::around(&data, 1.0).expect("room");
    assert!(outline.points().len() > 3000);
    let mut steps = 0;
    while outline.reduce().is_some() {
        steps += 1;
        if steps % 500 == 0 {
            assert_contains(&outline.points(), &data);
        }
    }
    assert_contains(&outline.points(), &data);
}

#[test]
fn a_domain_may_be_given_instead() {
    let dart = [[0.0, 0.0], [0.0, 4.0], [1.0, 1.0], [4.0, 0.0], [0.0, 0.0]];
    let turned = [[0.0, 0.0], [4.0, 0.0], [1.0, 1.0], [0.0, 4.0]];
    let corners = Outline::of_domain(&dart.map(Point::from));
    assert_eq!(corners, Ok(turned.map(Point::from).to_vec()));
    let refused = Outline::of_domain(
        &dart[..2]
            .iter()
            .copied()
            .map(Point::from)
            .collect::<Vec<_>>(),
    );
    assert!(matches!(refused, Err(Error::BadDomain { .. })));
}
