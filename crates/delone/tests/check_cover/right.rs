//! What is right passes, with the right numbers.

use super::cover::{Cover, points};
use delone::{Error, Phase, Watch};
use delone_testkit::generate::Random;

#[test]
fn a_triangle_and_its_numbers() {
    let data = [(0., 0.), (12., 0.), (3., 3.), (6., 6.), (3., 3.), (0., 5.)];
    let found = Cover::triangle(&data, 2).certificate();
    assert_eq!((found.vertices, found.triangles, found.edges), (3, 1, 3));
    assert_eq!((found.data, found.duplicates, found.least), (5, 1, 2));
    assert_eq!((found.fewest, found.most, found.mean), (5, 5, 5.0));
    assert_eq!(found.histogram, [0, 0, 0, 0, 0, 1]);
    assert_eq!((found.min_angle, found.max_angle), (45.0, 90.0));
    assert_eq!((found.area, found.border_edges), (72.0, 3));
    assert_eq!(found.special, []);
    let text = found.to_string();
    assert!(text.contains("5 data: 1 duplicates"), "{text}");
}

#[test]
fn a_lattice_and_its_numbers() {
    let cover = Cover::lattice(3);
    let found = cover.certificate();
    assert_eq!((found.vertices, found.triangles, found.edges), (16, 18, 33));
    assert_eq!((found.border_edges, found.area), (12, 144.0));
    // 18 · 9 = 162 of 169 data; no more than three lie inside a triangle, the others may choose.
    assert_eq!(
        (found.data, found.least, found.mean),
        (169, 9, 169.0 / 18.0)
    );
    assert_eq!(found.histogram.iter().sum::<usize>(), 18);
    let held = found.histogram.iter().enumerate();
    assert_eq!(held.map(|(k, n)| k * n).sum::<usize>(), 169);
    assert_eq!(found.histogram.len(), found.most + 1);
    let fewest = found.histogram.iter().position(|&n| n > 0);
    assert_eq!(fewest, Some(found.fewest));
    assert!((found.min_angle - 45.0).abs() < 1e-12 && found.max_angle == 90.0);
}

#[test]
fn neither_order_nor_rotation_matters() {
    let mut cover = Cover::lattice(2);
    let expected = cover.certificate();
    let mut random = Random::new(1);
    for triangle in &mut cover.triangles {
        triangle.rotate_left(random.below(3));
    }
    cover.triangles.reverse();
    for holder in &mut cover.holders {
        *holder = delone::TriangleId::new(expected.triangles - 1 - holder.index());
    }
    assert_eq!(cover.certificate(), expected);
}

#[test]
fn the_border_need_not_be_convex() {
    let star = [
        (0., 0.),
        (4., 0.),
        (1., 1.),
        (0., 4.),
        (-1., 1.),
        (-4., 0.),
        (-1., -1.),
        (0., -4.),
        (1., -1.),
    ];
    let triangles = [1, 2, 3, 4, 5, 6, 7, 8].map(|v| [0, v, v % 8 + 1]);
    let found = Cover::bare(&star, &triangles).certificate();
    assert_eq!((found.border_edges, found.edges), (8, 16));
    // A spiral of triangles, which nearly touches itself.
    let spiral = [
        (0., 0.),
        (6., 0.),
        (6., 6.),
        (0., 6.),
        (0., 1.),
        (1., 1.),
        (5., 1.),
        (5., 5.),
        (1., 5.),
    ];
    let triangles = [
        [0, 1, 6],
        [1, 2, 7],
        [1, 7, 6],
        [2, 3, 8],
        [2, 8, 7],
        [3, 4, 8],
        [4, 5, 8],
    ];
    let found = Cover::bare(&spiral, &triangles).certificate();
    assert_eq!((found.vertices, found.border_edges), (9, 9));
}

#[test]
fn outer_edges_may_be_split_at_rounded_points() {
    // 0.1 + 0.2 is a little more than 0.3: the vertex lies a little inside of the line through its neighbours.
    let third = 0.1 + 0.2;
    let coordinates = [(0., 0.), (0.3, 0.3), (1., 1.), (0., 1.), (third, 0.3)];
    let found = Cover::bare(&coordinates, &[[0, 1, 3], [1, 2, 3]]);
    assert!(found.verify().is_err(), "a vertex that nobody has");
    let rounded = Cover::bare(&coordinates, &[[0, 4, 3], [4, 2, 3], [0, 1, 2]]);
    assert!(rounded.verify().is_err(), "the last is flat");
    let mut right = Cover::bare(&coordinates, &[[0, 1, 3], [1, 2, 3]]);
    right.points[1] = right.points.pop().expect("five");
    let found = right
        .fed(points(&[(0., 0.5), (0.5, 0.9), (third, 0.3)]))
        .certificate();
    assert_eq!((found.border_edges, found.least), (4, 1));
}

#[test]
fn data_at_all_scales() {
    for exponent in [-1074, -1000, -300, 0, 300, 1000] {
        // Two steps, since 2^exponent alone may leave the range. No digit is lost.
        let scale = 2f64.powi(exponent / 2);
        let mut cover = Cover::lattice(2);
        for p in cover.points.iter_mut().chain(&mut cover.data) {
            (p.x, p.y) = (p.x * scale * scale, p.y * scale * scale);
        }
        let found = cover.certificate();
        assert_eq!((found.data, found.special.len()), (81, 0), "{exponent}");
    }
    // 0.0 and −0.0 are one place.
    let mut cover = Cover::triangle(&[(0., 0.), (-0., 0.), (1., 1.)], 2);
    assert_eq!(cover.certificate().duplicates, 1);
    cover.least = 3;
    assert!(cover.verify().is_err());
}

#[test]
fn where_nothing_is_asked_nothing_is_special() {
    let found = Cover::triangle(&[(1., 1.), (2., 2.)], 0).certificate();
    assert_eq!((found.fewest, found.special.len()), (2, 0));
    let empty = Cover::triangle(&[], 0).certificate();
    assert_eq!(
        (empty.data, empty.mean, &empty.histogram[..]),
        (0, 0.0, &[1][..])
    );
    let mut cover = Cover::triangle(&[], usize::MAX);
    assert!(cover.verify().is_err());
    cover.least = 1;
    assert!(cover.verify().is_err());
}

struct Stop;

impl Watch for Stop {
    fn progress(&self, _: Phase, _: u64, _: u64) {}

    fn is_cancelled(&self) -> bool {
        true
    }
}

#[test]
fn it_can_be_stopped() {
    let Cover {
        points,
        triangles,
        data,
        holders,
        least,
    } = Cover::lattice(9);
    let verdict = delone::check::verify_cover(&points, &triangles, &data, &holders, least, &Stop);
    assert_eq!(verdict, Err(Error::Cancelled));
}
