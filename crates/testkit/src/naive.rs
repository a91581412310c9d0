//! The Delaunay triangulation straight from its definition.
//!
//! A triangle belongs to it if no other point lies inside its circle, ties broken by the symbolic
//! perturbation. All triples are tried against all points, O(n⁴): no mesh, no walk, no cleverness,
//! nothing shared with the builders but the predicates.

use delone::predicates::{Orientation, in_circle_perturbed, orient2d};
use delone::{Point, Triangulation, VertexId};

/// Lists the Delaunay triangles of `points`: counter-clockwise, lowest index first, sorted.
///
/// Of equal points only the first counts. Coordinates must be finite.
pub fn naive_delaunay(points: &[Point]) -> Vec<[VertexId; 3]> {
    let first = distinct(points);
    let mut triangles = Vec::new();
    for (i, &a) in first.iter().enumerate() {
        for (j, &b) in first.iter().enumerate().skip(i + 1) {
            for &c in &first[j + 1..] {
                triangles.extend(delaunay_triangle(points, &first, [a, b, c]));
            }
        }
    }
    triangles.sort_unstable();
    triangles
}

/// Lists the indices of the points that equal no earlier one.
pub fn distinct(points: &[Point]) -> Vec<usize> {
    let is_first = |&i: &usize| !points[..i].contains(&points[i]);
    (0..points.len()).filter(is_first).collect()
}

/// Lists the triangles of a result as [`naive_delaunay`] does.
pub fn sorted_triangles(t: &Triangulation) -> Vec<[VertexId; 3]> {
    let mut triangles: Vec<_> = t.triangles().iter().map(|&t| lowest_first(t)).collect();
    triangles.sort_unstable();
    triangles
}

fn delaunay_triangle(
    points: &[Point],
    others: &[usize],
    [i, j, k]: [usize; 3],
) -> Option<[VertexId; 3]> {
    let [i, j, k] = match orient2d(points[i], points[j], points[k]) {
        Orientation::Left => [i, j, k],
        Orientation::Right => [i, k, j],
        Orientation::Collinear => return None,
    };
    let [a, b, c] = [i, j, k].map(|v| points[v]);
    let is_inside = |&d: &usize| ![i, j, k].contains(&d) && in_circle_perturbed(a, b, c, points[d]);
    (!others.iter().any(is_inside)).then(|| lowest_first([i, j, k].map(VertexId::new)))
}

fn lowest_first([a, b, c]: [VertexId; 3]) -> [VertexId; 3] {
    if a < b && a < c {
        [a, b, c]
    } else if b < c {
        [b, c, a]
    } else {
        [c, a, b]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_square_has_two_triangles_and_its_duplicates_none() {
        let square = [(0, 0), (1, 0), (1, 1), (0, 1), (1, 1)];
        let points = square.map(|(x, y)| Point::new(f64::from(x), f64::from(y)));
        // The largest corner, 2, does not touch the diagonal.
        let expected = [[0, 1, 3], [1, 2, 3]].map(|t| t.map(VertexId::new));
        assert_eq!(naive_delaunay(&points), expected);
    }
}
