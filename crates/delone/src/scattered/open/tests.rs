//! Openings against brute force and against the exact search.

use super::*;
use crate::VertexId;
use crate::predicates::{Orientation, orient2d};
use proptest::prelude::*;

type Corners = [Point; 3];

fn points(list: &[(f64, f64)]) -> Vec<Point> {
    list.iter().map(|&p| p.into()).collect()
}

/// Random numbers from 0 to 1.
struct Random(u64);

impl Random {
    fn unit(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Points of a triangle; of larger `power`, more of them near corner 0.
    fn inside(&mut self, corners: Corners, n: usize, power: i32) -> Vec<Point> {
        let mut data: Vec<Point> = Vec::new();
        while data.len() < n {
            let (mut s, mut t) = (self.unit(), self.unit());
            if s + t > 1.0 {
                (s, t) = (1.0 - s, 1.0 - t);
            }
            let shrink = (s + t).powi(power);
            let p = balanced::place(corners, [1.0 - (s + t) * shrink, s * shrink, t * shrink]);
            if lies_in(corners, p) && !data.contains(&p) {
                data.push(p);
            }
        }
        data
    }
}

fn lies_in([a, b, c]: Corners, p: Point) -> bool {
    [[a, b], [b, c], [c, a]]
        .iter()
        .all(|&[a, b]| orient2d(a, b, p) != Orientation::Right)
}

/// Checks an opening from its definition.
fn assert_opens(corners: Corners, data: &[Point], least: usize, opening: &Opening) {
    let at = opening.at;
    let mut held = [0; 3];
    assert_eq!(opening.shares.len(), data.len());
    for (&p, &part) in data.iter().zip(&opening.shares) {
        let mut triangle = corners;
        triangle[usize::from(part)] = at;
        assert!(
            lies_in(triangle, p),
            "{p:?} in part {part} of {corners:?} at {at:?}"
        );
        held[usize::from(part)] += 1;
    }
    for k in 0..3 {
        let [a, b] = [corners[(k + 1) % 3], corners[(k + 2) % 3]];
        assert_eq!(orient2d(a, b, at), Orientation::Left);
    }
    assert!(
        held.iter().all(|&held| held >= least),
        "{held:?} of {least}"
    );
}

fn exact_search(corners: Corners, data: &[Point], least: usize) -> bool {
    let search = PointSearch::new(corners, data, least, Counting::Unique).expect("a triangle");
    let most = search.most_moves();
    let steps: Vec<_> = search.collect();
    assert!(steps.len() <= most + 1);
    let end = steps.last().expect("a step").next;
    assert!(matches!(end, Next::Found | Next::Stuck(_)), "{end:?}");
    end == Next::Found
}

const BASE: [(f64, f64); 3] = [(0.0, 0.0), (60.0, 0.0), (20.0, 50.0)];

#[test]
fn there_is_always_room_among_data_that_are_spread() {
    let affine = |scale: [f64; 2], shift: f64| {
        BASE.map(|(x, y)| Point::new(x * scale[0] + shift, y * scale[1] + shift))
    };
    let shapes = [
        affine([1.0; 2], 0.0),
        affine([1.0; 2], 1e6),
        affine([1e-4; 2], 1e6),
        affine([1e300; 2], 0.0),
        affine([1e-300; 2], 0.0),
        affine([1e-200, 1e200], 0.0),
        affine([1e-6, 1.0], 3.0),
        affine([2e306; 2], -6e307),
    ];
    let mut random = Random(88_172_645_463_325_252);
    for corners in shapes {
        for round in 0..200 {
            let least = 1 + round % 12;
            let n = 3 * least + round / 3 % 7 * least / 4;
            let data = random.inside(corners, n, [0, 0, 1, 4][round % 4]);
            let opening = open_at(corners, &data, least);
            let opening = opening.unwrap_or_else(|| panic!("{corners:?} {data:?} {least}"));
            assert_opens(corners, &data, least, &opening);
        }
    }
}

#[test]
fn a_tiny_cluster_is_divided() {
    let corners = BASE.map(Point::from);
    let mut random = Random(123_456_789);
    for (corner, power) in [(0, 0), (1, 1), (2, 0), (0, 2)] {
        let turned = [0, 1, 2].map(|k| corners[(corner + k) % 3]);
        let near = turned.map(|p| between(turned[0], p, 1e-9));
        let data = random.inside(near, 36, power);
        let data: Vec<_> = data
            .into_iter()
            .filter(|&p| lies_in(turned, p))
            .take(30)
            .collect();
        assert_eq!(data.len(), 30);
        let opening = open_at(turned, &data, 10).expect("an opening");
        assert_opens(turned, &data, 10, &opening);
    }
}

#[test]
fn many_data_are_divided_after_a_sample() {
    let corners = BASE.map(Point::from);
    let mut random = Random(987_654_321);
    let near = [
        corners[0],
        between(corners[0], corners[1], 0.01),
        between(corners[0], corners[2], 0.01),
    ];
    let mut data: Vec<_> = (0..20_000)
        .map(|_| random.inside(corners, 1, 0)[0])
        .collect();
    data.extend((0..80_000).map(|_| random.inside(near, 1, 1)[0]));
    for least in [10, 20_000, 33_000, 33_333] {
        let opening = open_at(corners, &data, least).expect("an opening");
        assert_opens(corners, &data, least, &opening);
    }
}

#[test]
fn data_on_a_line_to_a_corner_choose() {
    // All on the line from corner 0 through the point (8, 8), at which one of them lies.
    let corners = [(0.0, 0.0), (32.0, 0.0), (0.0, 32.0)].map(Point::from);
    let data: Vec<_> = (1..=9)
        .map(|k| Point::new(f64::from(k), f64::from(k)))
        .collect();
    let opening = open_at(corners, &data, 3).expect("an opening");
    assert_eq!(opening.at.x, opening.at.y);
    assert_opens(corners, &data, 3, &opening);
    // Nothing can be done without the line.
    assert_eq!(open_at(corners, &data, 4), None);
    // Two on a line through corner 2, and one of them is the only place for which few digits are enough.
    let steep = [(0.0, 8.0), (0.0, 1.0), (5.0, 0.0)].map(Point::from);
    let pair = points(&[(0.0, 6.0), (1.0, 6.0), (3.0, 3.0)]);
    let opening = open_at(steep, &pair, 1).expect("an opening");
    assert_opens(steep, &pair, 1, &opening);
    // Lines to all three corners, through one point: remark 3.40.
    let star = points(&[
        (8.0, 8.0),
        (4.0, 4.0),
        (2.0, 2.0),
        (20.0, 4.0),
        (26.0, 2.0),
        (4.0, 20.0),
        (2.0, 26.0),
    ]);
    let opening = open_at(corners, &star, 2).expect("an opening");
    assert_opens(corners, &star, 2, &opening);
}

#[test]
fn edges_and_corners_hold_data_too() {
    let corners = [(0.0, 0.0), (12.0, 0.0), (0.0, 12.0)].map(Point::from);
    let on = points(&[(0.0, 0.0), (12.0, 0.0), (0.0, 12.0)]);
    let opening = open_at(corners, &on, 1).expect("an opening");
    assert_opens(corners, &on, 1, &opening);
    let edge = points(&[
        (3.0, 0.0),
        (6.0, 0.0),
        (9.0, 0.0),
        (1.0, 4.0),
        (4.0, 1.0),
        (2.0, 2.0),
    ]);
    let opening = open_at(corners, &edge, 2);
    assert_eq!(opening.is_some(), exact_search(corners, &edge, 2));
}

#[test]
fn narrow_triangles_end_in_nothing_or_in_a_point() {
    // A few units in the last place wide.
    let x = 1e6_f64;
    let unit = x.next_up() - x;
    let at = |i: i32, j: i32| Point::new(x + unit * f64::from(i), x + unit * f64::from(j));
    let corners = [at(0, 0), at(2, 1), at(1, 3)];
    let data = [at(1, 1), at(1, 2), at(0, 0)];
    if let Some(opening) = open_at(corners, &data, 1) {
        assert_opens(corners, &data, 1, &opening);
    }
    let empty = [at(0, 0), at(1, 0), at(0, 1)];
    assert_eq!(open_at(empty, &empty, 1), None);
    assert_eq!(open_at(empty, &empty[..2], 1), None);
}

/// A triangle on a small lattice, and data in it.
fn small() -> impl Strategy<Value = (Corners, Vec<Point>, usize)> {
    let place = |n: i32| (0..n, 0..n).prop_map(|(x, y)| Point::new(f64::from(x), f64::from(y)));
    let corners = [place(9), place(9), place(9)];
    let all = (corners, prop::collection::vec(place(9), 1..40), 1..5_usize);
    all.prop_filter_map("a triangle", |(corners, mut data, least)| {
        let [a, b, c] = corners;
        let corners = match orient2d(a, b, c) {
            Orientation::Left => [a, b, c],
            Orientation::Right => [a, c, b],
            Orientation::Collinear => return None,
        };
        data.retain(|&p| lies_in(corners, p));
        data.sort_by(Point::lex_cmp);
        data.dedup();
        (data.len() >= 3).then_some(())?;
        let least = least.min(data.len() / 3);
        Some((corners, data, least))
    })
}

/// Whether a point on a fine lattice does.
fn lattice_has_one(corners: Corners, data: &[Point], least: usize) -> Option<Point> {
    let division = Division::new(corners, data, least);
    let steps = 9 * 16;
    let lattice = (0..=steps * steps).map(|i| (i % steps, i / steps));
    let mut places = lattice.map(|(x, y)| Point::new(f64::from(x) / 16.0, f64::from(y) / 16.0));
    places.find(|&at| division.is_good(at))
}

fn agrees((corners, data, least): (Corners, Vec<Point>, usize)) -> Result<(), TestCaseError> {
    let ids = [0, 1, 2].map(VertexId::new);
    let has_room = conditions(corners, ids, &data, least).is_ok();
    prop_assert_eq!(has_room, exact_search(corners, &data, least));
    match open_at(corners, &data, least) {
        Some(opening) => {
            prop_assert!(has_room);
            assert_opens(corners, &data, least, &opening);
        }
        None if has_room => prop_assert_eq!(lattice_has_one(corners, &data, least), None),
        None => {}
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]
    #[test]
    fn whoever_has_room_is_opened(case in small()) {
        agrees(case)?;
    }
}
