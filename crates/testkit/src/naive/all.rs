//! All triangulations of a small point set, and how good their angles are.

use dashu_ratio::RBig;
use delone::predicates::{Orientation, orient2d};
use delone::{Point, VertexId, triangulate};
use std::cmp::Ordering;
use std::collections::BTreeSet;

/// Triangles, each counter-clockwise with its lowest corner first, sorted.
type Triangles = Vec<[VertexId; 3]>;

/// Lists all triangulations of `points`, which use every distinct point: all that flips can reach, and they
/// can reach all (Lawson 1972). For at most some ten points.
///
/// # Panics
/// If a coordinate is not finite.
pub fn all_triangulations(points: &[Point]) -> Vec<Triangles> {
    let first = triangulate(points.iter().copied()).expect("finite points");
    let first = sorted(first.triangles().iter().copied());
    let mut seen = BTreeSet::from([first.clone()]);
    let mut waiting = vec![first];
    while let Some(triangles) = waiting.pop() {
        for flipped in flips(points, &triangles) {
            if seen.insert(flipped.clone()) {
                waiting.push(flipped);
            }
        }
    }
    seen.into_iter().collect()
}

/// All triangulations that are one flip away.
fn flips(points: &[Point], triangles: &Triangles) -> Vec<Triangles> {
    let mut all = Vec::new();
    for (i, s) in triangles.iter().enumerate() {
        for t in &triangles[i + 1..] {
            all.extend(flip(points, *s, *t).map(|pair| {
                let others = triangles.iter().filter(|u| *u != s && *u != t);
                sorted(others.copied().chain(pair))
            }));
        }
    }
    all
}

/// The two triangles on the other diagonal, if two have an edge in common and form a strictly convex
/// quadrilateral.
fn flip(points: &[Point], s: [VertexId; 3], t: [VertexId; 3]) -> Option<[[VertexId; 3]; 2]> {
    let k = (0..3).find(|&k| t.contains(&s[k]) && t.contains(&s[(k + 1) % 3]))?;
    let [a, b, c] = [s[k], s[(k + 1) % 3], s[(k + 2) % 3]];
    let d = *t.iter().find(|v| **v != a && **v != b)?;
    let is_left = |p: VertexId, q: VertexId, r: VertexId| {
        let [p, q, r] = [p, q, r].map(|v| points[v.index()]);
        orient2d(p, q, r) == Orientation::Left
    };
    (is_left(c, d, b) && is_left(d, c, a)).then_some([[c, d, b], [d, c, a]])
}

fn sorted(triangles: impl Iterator<Item = [VertexId; 3]>) -> Triangles {
    let mut triangles: Vec<_> = triangles.collect();
    for t in &mut triangles {
        let lowest = (0..3).min_by_key(|&k| t[k]).expect("three corners");
        t.rotate_left(lowest);
    }
    triangles.sort();
    triangles
}

/// Compares the least angles of two sets of triangles, exactly; that of none is larger than any.
pub fn compare_least_angles(
    points: &[Point],
    s: &[[VertexId; 3]],
    t: &[[VertexId; 3]],
) -> Ordering {
    match [s, t].map(|triangles| angles(points, triangles).into_iter().next()) {
        [None, None] => Ordering::Equal,
        [None, Some(_)] => Ordering::Greater,
        [Some(_), None] => Ordering::Less,
        // The larger the cotangent, the smaller the angle.
        [Some(s), Some(t)] => t.cmp(&s),
    }
}

/// Compares all angles of two sets of triangles, from the least on, exactly.
pub fn compare_angles(points: &[Point], s: &[[VertexId; 3]], t: &[[VertexId; 3]]) -> Ordering {
    let [s, t] = [s, t].map(|triangles| angles(points, triangles));
    t.iter().cmp(&s)
}

/// The cotangents of all angles, largest first.
fn angles(points: &[Point], triangles: &[[VertexId; 3]]) -> Vec<RBig> {
    let corners = triangles
        .iter()
        .flat_map(|&[a, b, c]| [[a, b, c], [b, c, a], [c, a, b]]);
    let mut angles: Vec<_> = corners
        .map(|t| cotangent(t.map(|v| points[v.index()])))
        .collect();
    angles.sort_by(|a, b| b.cmp(a));
    angles
}

/// The cotangent of the angle at the first corner.
fn cotangent([a, b, c]: [Point; 3]) -> RBig {
    let exact = |x: f64| RBig::try_from(x).expect("finite");
    let arm = |p: Point| [exact(p.x) - exact(a.x), exact(p.y) - exact(a.y)];
    let ([bx, by], [cx, cy]) = (arm(b), arm(c));
    (&bx * &cx + &by * &cy) / (bx * cy - by * cx)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn convex_points_have_catalan_many() {
        let circle = [(5, 0), (3, 4), (-3, 4), (-5, 0), (-3, -4), (3, -4), (0, -5)];
        for (n, count) in [(3, 1), (4, 2), (5, 5), (6, 14), (7, 42)] {
            let points = circle[..n]
                .iter()
                .map(|&(x, y)| Point::new(x.into(), y.into()));
            let points: Vec<_> = points.collect();
            assert_eq!(all_triangulations(&points).len(), count);
        }
    }

    #[test]
    fn angles_are_compared_exactly() {
        let points = [
            (0.0, 0.0),
            (1.0, 0.0),
            (0.0, 1.0),
            (1.0, 1.0 + f64::EPSILON),
        ];
        let points = points.map(Point::from);
        let v = [0, 1, 2, 3].map(VertexId::new);
        let [s, t] = [[v[0], v[1], v[2]], [v[0], v[1], v[3]]];
        assert!(compare_least_angles(&points, &[s], &[t]).is_gt());
        assert!(compare_angles(&points, &[s], &[s]).is_eq());
        assert!(compare_least_angles(&points, &[], &[t]).is_gt());
    }
}
