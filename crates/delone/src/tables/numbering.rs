//! The tables of a mesh: who gets which number.
//!
//! Vertices are numbered as the thesis sorts them, by x, then y. Triangles are numbered and written as
//! its sweep would emit them, if it emitted this mesh: with the last vertex reached in the middle, by
//! that vertex, and for one vertex upwards along the front.

use super::Tables;
use crate::predicates::{Orientation, orient2d};
use crate::{ConstrainedTriangulation, HalfEdgeId, Point, TriangleId, VertexId};
use std::cmp::Ordering;

/// Makes the tables of the triangles of a domain, coordinates multiplied by `scale`, with the name of each
/// number.
pub(crate) fn tables_of(t: &ConstrainedTriangulation, scale: f64) -> (Tables, Vec<VertexId>) {
    let mesh = t.triangulation();
    let corners = mesh.triangles().as_flattened();
    let mut names = corners.to_vec();
    let point = |v: VertexId| mesh.point(v);
    names.sort_unstable();
    names.dedup();
    names.sort_unstable_by(|&v, &w| point(v).lex_cmp(&point(w)));
    let mut numbers = vec![0; mesh.points().len()];
    for (i, v) in names.iter().enumerate() {
        numbers[v.index()] = i as u32;
    }
    let number = |v: VertexId| numbers[v.index()];
    let scaled = |p: Point| Point::new(p.x * scale, p.y * scale);
    let points: Vec<_> = names.iter().map(|&v| scaled(point(v))).collect();
    let triangles = mesh.triangles().iter().map(|corners| corners.map(number));
    let mut triangles: Vec<_> = triangles.map(largest_in_the_middle).collect();
    triangles.sort_unstable_by(|s, t| by_sweep(&points, s, t));

    let half_edges = (0..mesh.num_triangles()).map(TriangleId::new);
    let half_edges = half_edges.flat_map(TriangleId::half_edges);
    let ends = |h: HalfEdgeId| {
        let [a, b] = [mesh.mesh().origin(h), mesh.mesh().dest(h)].map(number);
        [a.max(b), a.min(b)]
    };
    let mut constraints: Vec<_> = half_edges
        .filter(|&h| t.is_constrained(h))
        .map(ends)
        .collect();
    constraints.sort_unstable();
    let is_constraint = |ends| constraints.binary_search(&ends).is_ok();
    (Tables::new(points, triangles, is_constraint), names)
}

/// Rotates a triangle.
fn largest_in_the_middle(corners: [u32; 3]) -> [u32; 3] {
    let [a, b, c] = corners;
    if b > a && b > c {
        corners
    } else if c > a {
        [b, c, a]
    } else {
        [c, a, b]
    }
}

/// Compares two triangles with the largest corner in the middle.
fn by_sweep(points: &[Point], s: &[u32; 3], t: &[u32; 3]) -> Ordering {
    let [front, reached, next] = [s[0], s[1], t[0]];
    reached.cmp(&t[1]).then_with(|| {
        let corners = [reached, front, next].map(|v| points[v as usize]);
        match orient2d(corners[0], corners[1], corners[2]) {
            Orientation::Right => Ordering::Less,
            Orientation::Collinear => Ordering::Equal,
            Orientation::Left => Ordering::Greater,
        }
    })
}
