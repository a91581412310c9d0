//! Oracles straight from the definitions: no mesh, no walk, no cleverness, nothing shared with the
//! library but points and predicates. For tiny inputs.
//!
//! [`naive_delaunay`]: a triangle belongs to the Delaunay triangulation if no other point lies
//! inside its circle, ties broken by the symbolic perturbation; all triples are tried against all
//! points, O(n⁴). The others build on each other: [`naive_noding`] cuts segments in rational
//! arithmetic, [`naive_constrained`] decides which triangles see no point in their circles, and
//! [`naive_domain`] which of them belong to the domain. [`naive_sharing`] shares data out among triangles.

mod all;
mod constrained;
mod domain;
mod facts;
mod noding;
mod pairs;
mod sharing;

pub use all::{all_triangulations, compare_angles, compare_least_angles};
pub use constrained::naive_constrained;
pub use domain::{NaiveDomain, naive_domain};
pub use facts::naive_facts;
pub use noding::{NaiveNoding, naive_first_crossing, naive_noding};
pub use sharing::{naive_largest_least, naive_sharing, triangles_at};

use delone::predicates::{Orientation, in_circle_perturbed, orient2d};
use delone::{Point, Triangulation, VertexId};

/// Lists the Delaunay triangles of `points`: counter-clockwise, lowest index first, sorted.
///
/// Of equal points only the first counts. Coordinates must be finite.
pub fn naive_delaunay(points: &[Point]) -> Vec<[VertexId; 3]> {
    let first = distinct(points);
    let is_delaunay = |&[a, b, c]: &[usize; 3]| {
        let others = first.iter().filter(|v| ![a, b, c].contains(v));
        let [a, b, c] = [a, b, c].map(|v| points[v]);
        !others
            .into_iter()
            .any(|&d| in_circle_perturbed(a, b, c, points[d]))
    };
    sorted(triples(points, &first).filter(is_delaunay))
}

/// Lists the indices of the points that equal no earlier one.
pub fn distinct(points: &[Point]) -> Vec<usize> {
    let is_first = |&i: &usize| !points[..i].contains(&points[i]);
    (0..points.len()).filter(is_first).collect()
}

/// Lists the triangles of a result as [`naive_delaunay`] does.
pub fn sorted_triangles(t: &Triangulation) -> Vec<[VertexId; 3]> {
    sorted(t.triangles().iter().map(|t| t.map(VertexId::index)))
}

/// Visits all triples of `vertices` that are not collinear, counter-clockwise.
fn triples(points: &[Point], vertices: &[usize]) -> impl Iterator<Item = [usize; 3]> {
    let n = vertices.len();
    let all = (0..n).flat_map(move |i| (i + 1..n).map(move |j| (i, j)));
    let all = all.flat_map(move |(i, j)| (j + 1..n).map(move |k| [i, j, k]));
    all.filter_map(move |triple| upright(points, triple.map(|i| vertices[i])))
}

/// Orders three corners counter-clockwise; `None` if they are collinear.
fn upright(points: &[Point], [i, j, k]: [usize; 3]) -> Option<[usize; 3]> {
    match orient2d(points[i], points[j], points[k]) {
        Orientation::Left => Some([i, j, k]),
        Orientation::Right => Some([i, k, j]),
        Orientation::Collinear => None,
    }
}

fn sorted(triangles: impl Iterator<Item = [usize; 3]>) -> Vec<[VertexId; 3]> {
    let mut triangles: Vec<_> = triangles
        .map(|t| lowest_first(t).map(VertexId::new))
        .collect();
    triangles.sort_unstable();
    triangles
}

fn lowest_first([a, b, c]: [usize; 3]) -> [usize; 3] {
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
