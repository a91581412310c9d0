//! Every way of being wrong is found.

use super::cover::{Cover, points};
use delone::check::Defect;
use delone::{Error, Point, TriangleId, VertexId};

/// Two triangles with a diagonal from (0, 0) to (4, 4), and five data that lie on it or beside it.
fn square() -> Cover {
    let corners = [(0., 0.), (4., 0.), (4., 4.), (0., 4.)];
    let mut cover = Cover::bare(&corners, &[[0, 1, 2], [0, 2, 3]]);
    cover.data = points(&[(3., 1.), (2., 2.), (1., 3.), (2., 2.), (1., 1.)]);
    cover.holders = [0, 0, 1, 0, 1].map(TriangleId::new).to_vec();
    cover.least = 2;
    cover
}

macro_rules! refused {
    ($cover:expr, $pattern:pat $(if $guard:expr)?) => {
        $cover.refuses(|defect| matches!(defect, $pattern $(if $guard)?))
    };
}

#[test]
fn the_square_is_right() {
    assert_eq!(square().certificate().histogram, [0, 0, 2]);
}

#[test]
fn corners() {
    let mut cover = square();
    cover.triangles[1][2] = VertexId::new(4);
    refused!(cover, Defect::OutOfRange { corner, points: 4, .. } if corner.index() == 4);
    let mut cover = square();
    cover.triangles[1][2] = VertexId::new(0);
    refused!(cover, Defect::RepeatedCorner { .. });
    let mut cover = square();
    cover.triangles[0].swap(0, 1);
    refused!(cover, Defect::Clockwise { .. });
    refused!(cover, Defect::SameSide { .. });
    let mut cover = square();
    cover.points[1] = Point::new(1.0, 1.0);
    refused!(cover, Defect::Degenerate { .. });
}

#[test]
fn vertices() {
    let mut cover = square();
    cover.points[2].y = f64::INFINITY;
    let error = cover.verdict().expect_err("no point");
    assert!(matches!(error, Error::NotFinite { index: 2, .. }));
    let mut cover = square();
    cover.points.push(Point::new(9.0, 9.0));
    refused!(cover, Defect::IdleVertex { corner } if corner.vertex.index() == 4);
    // The diagonal has been cut: its ends are two vertices each.
    let mut cover = square();
    cover.points.extend([(0., 0.), (4., 4.)].map(Point::from));
    cover.triangles[1] = [4, 5, 3].map(VertexId::new);
    refused!(cover, Defect::SharedPosition { .. });
}

#[test]
fn a_slit() {
    // From a corner to the middle: the corner is two vertices, and the border goes in and out between them.
    let coordinates = [(0., 0.), (4., 0.), (4., 4.), (0., 4.), (2., 2.), (0., 0.)];
    let cover = Cover::bare(&coordinates, &[[4, 0, 1], [4, 1, 2], [4, 2, 3], [4, 3, 5]]);
    let defects = cover.verify().expect_err("a slit");
    assert!(
        matches!(defects.listed(), [Defect::SharedPosition { .. }]),
        "{defects}"
    );
}

#[test]
fn holders() {
    let mut cover = square();
    cover.holders.pop();
    refused!(
        cover,
        Defect::HolderCount {
            data: 5,
            holders: 4
        }
    );
    let mut cover = square();
    cover.holders[2] = TriangleId::new(2);
    refused!(
        cover,
        Defect::HolderOutOfRange {
            datum: 2,
            triangles: 2,
            ..
        }
    );
    for (datum, holder) in [(0, 1), (2, 0)] {
        let mut cover = square();
        cover.holders[datum] = TriangleId::new(holder);
        cover.refuses(
            |d| matches!(d, Defect::OutsideHolder { datum: found, .. } if *found == datum),
        );
    }
    let mut cover = square();
    cover.holders[3] = TriangleId::new(1);
    refused!(cover, Defect::DividedDatum { data: [1, 3], .. });
}

#[test]
fn data() {
    for at in [
        (4.0 + 1e-15, 1.0),
        (f64::NAN, 1.0),
        (1.0, f64::INFINITY),
        (-1e-300, 0.0),
    ] {
        let mut cover = square();
        cover.data[0] = Point::from(at);
        refused!(cover, Defect::OutsideHolder { datum: 0, .. });
    }
}

#[test]
fn numbers() {
    let mut cover = square();
    cover.holders[4] = TriangleId::new(0);
    refused!(cover, Defect::TooFewData { held: 1, least: 2, triangle } if triangle.index() == 1);
    let mut cover = square();
    cover.least = 3;
    let defects = cover.verify().expect_err("too few");
    assert_eq!(defects.total(), 2);
    // Datum 3 is datum 1 again, and does not count.
    refused!(cover, Defect::TooFewData { held: 2, least: 3, triangle } if triangle.index() == 0);
    let mut cover = square();
    cover.data.clear();
    cover.holders.clear();
    refused!(cover, Defect::TooFewData { held: 0, .. });
}

#[test]
fn no_triangles() {
    refused!(Cover::bare(&[], &[]), Defect::BoundaryCycles { cycles: 0 });
    let mut cover = square();
    cover.triangles.clear();
    refused!(cover, Defect::IdleVertex { .. });
    refused!(cover, Defect::HolderOutOfRange { .. });
}

#[test]
fn two_parts() {
    let apart = [(0., 0.), (1., 0.), (0., 1.), (5., 0.), (6., 0.), (5., 1.)];
    let cover = Cover::bare(&apart, &[[0, 1, 2], [3, 4, 5]]);
    refused!(cover, Defect::BoundaryCycles { cycles: 2 });
    // They touch in a vertex.
    let cover = Cover::bare(&apart[..5], &[[0, 1, 2], [1, 3, 4]]);
    assert!(cover.verify().is_err(), "the second is flat");
    let touching = [(0., 0.), (1., 0.), (0., 1.), (2., 0.), (2., 1.)];
    let cover = Cover::bare(&touching, &[[0, 1, 2], [1, 3, 4]]);
    refused!(cover, Defect::PinchedBorder { times: 2, corner } if corner.vertex.index() == 1);
    refused!(cover, Defect::SplitStar { .. });
    // One lies inside the other.
    let nested = [(0., 0.), (9., 0.), (0., 9.), (1., 1.), (2., 1.), (1., 2.)];
    let cover = Cover::bare(&nested, &[[0, 1, 2], [3, 4, 5]]);
    refused!(cover, Defect::BoundaryCycles { cycles: 2 });
    // A vertex of one lies inside an edge of the other, or they cross.
    let mut cover = cover;
    cover.points[3] = Point::new(4.0, 0.0);
    refused!(cover, Defect::VertexOnBorder { corner, .. } if corner.vertex.index() == 3);
    cover.points[3] = Point::new(4.0, -1.0);
    refused!(cover, Defect::CrossingBorder { .. });
}

#[test]
fn holes() {
    let mut cover = Cover::lattice(3);
    cover.least = 0;
    let inner = |cover: &Cover, t: &[VertexId; 3]| {
        let is_inner = |v: &VertexId| {
            let Point { x, y } = cover.points[v.index()];
            x > 0.0 && x < 12.0 && y > 0.0 && y < 12.0
        };
        t.iter().all(is_inner)
    };
    let hole = cover.triangles.iter().position(|t| inner(&cover, t));
    cover.triangles.remove(hole.expect("a triangle"));
    cover.data.clear();
    cover.holders.clear();
    refused!(cover, Defect::BoundaryCycles { cycles: 2 });
}

#[test]
fn a_hole_that_touches_the_border() {
    // A ring of triangles around [1, 5, 6], where vertex 1 is a corner of the border too.
    let coordinates = [
        (0., 0.),
        (4., 0.),
        (8., 0.),
        (8., 8.),
        (0., 8.),
        (6., 4.),
        (2., 4.),
    ];
    let ring = [
        [0, 1, 6],
        [1, 2, 5],
        [2, 3, 5],
        [3, 4, 6],
        [3, 6, 5],
        [4, 0, 6],
    ];
    let cover = Cover::bare(&coordinates, &ring);
    refused!(cover, Defect::PinchedBorder { times: 2, corner } if corner.vertex.index() == 1);
    let mut filled = cover;
    filled.triangles.push([1, 5, 6].map(VertexId::new));
    assert_eq!(filled.certificate().border_edges, 5);
}

fn find(cover: &Cover, at: Point) -> VertexId {
    let v = cover.points.iter().position(|&p| p == at);
    VertexId::new(v.expect("a vertex"))
}

#[test]
fn a_vertex_inside_an_edge() {
    let coordinates = [(0., 0.), (4., 0.), (4., 4.), (0., 4.), (2., 2.)];
    // One side of the diagonal has been split, the other has not.
    let cover = Cover::bare(&coordinates, &[[0, 1, 2], [0, 4, 3], [4, 2, 3]]);
    refused!(cover, Defect::CrossingBorder { .. });
    // The same away from the outer edges.
    let mut cover = Cover::lattice(3);
    let [a, b] = [(8., 4.), (4., 8.)]
        .map(Point::from)
        .map(|p| find(&cover, p));
    let is_beside = |t: &[VertexId; 3]| t.contains(&a) && t.contains(&b);
    let t = cover
        .triangles
        .iter()
        .position(is_beside)
        .expect("the diagonal");
    let middle = VertexId::new(cover.points.len());
    cover.points.push(Point::new(6.0, 6.0));
    let halves = [a, b].map(|old| cover.triangles[t].map(|v| if v == old { middle } else { v }));
    cover.triangles[t] = halves[0];
    cover.triangles.push(halves[1]);
    cover.refuses(|d| {
        matches!(
            d,
            Defect::CrossingBorder { .. } | Defect::VertexOnBorder { .. }
        )
    });
}

#[test]
fn overlaps() {
    // The same triangle twice; three triangles at an edge.
    let mut cover = square();
    cover.triangles.push(cover.triangles[0]);
    refused!(cover, Defect::CrowdedEdge { .. } | Defect::SameSide { .. });
    let fan = [(0., 0.), (4., 0.), (4., 1.), (3., 2.), (2., 3.)];
    let cover = Cover::bare(&fan, &[[0, 1, 2], [0, 1, 3], [0, 1, 4]]);
    refused!(cover, Defect::CrowdedEdge { count: 3, .. });
    // A fold: the second triangle comes back over the first.
    let cover = Cover::bare(
        &[(0., 0.), (4., 0.), (0., 4.), (3., 3.)],
        &[[0, 1, 2], [0, 1, 3]],
    );
    refused!(cover, Defect::SameSide { .. });
}

#[test]
fn a_border_that_goes_round_twice() {
    // Twelve triangles around one vertex, at 60 degrees each.
    let ring = [
        (2., 0.),
        (1., 2.),
        (-1., 2.),
        (-2., 0.),
        (-1., -2.),
        (1., -2.),
    ];
    let mut coordinates = vec![(0., 0.)];
    for turn in [1.0, 2.0] {
        coordinates.extend(ring.map(|(x, y)| (x * turn, y * turn)));
    }
    let triangles: Vec<_> = (1..=12).map(|v| [0, v, v % 12 + 1]).collect();
    let cover = Cover::bare(&coordinates, &triangles);
    let defects = cover.verify().expect_err("two layers");
    let kinds = defects.listed().iter();
    let is_crossing = |d: &Defect| {
        matches!(
            d,
            Defect::CrossingBorder { .. } | Defect::VertexOnBorder { .. }
        )
    };
    assert!(kinds.into_iter().all(is_crossing), "{defects}");
}

#[test]
fn a_strip_that_overlaps_itself_far_away() {
    // A strip that bends round and comes to lie on its beginning; locally all is well.
    let strip = [
        (0., 0.),
        (0., 1.),
        (9., 0.),
        (8., 1.),
        (9., 9.),
        (8., 8.),
        (0., 9.),
        (1., 8.),
        (0.5, -1.),
        (1.5, -1.),
    ];
    let triangles = [
        [0, 3, 1],
        [0, 2, 3],
        [2, 5, 3],
        [2, 4, 5],
        [4, 7, 5],
        [4, 6, 7],
        [6, 9, 7],
        [6, 8, 9],
    ];
    let cover = Cover::bare(&strip, &triangles);
    let defects = cover.verify().expect_err("an overlap");
    assert!(
        matches!(defects.listed(), [Defect::CrossingBorder { .. }]),
        "{defects}"
    );
}
