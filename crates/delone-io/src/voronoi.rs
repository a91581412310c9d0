//! `.v.node`, `.v.edge`: the Voronoi diagram in the files of Triangle, written only.
//!
//! As Triangle does it, for the triangles of a mesh rather than for its points: vertex `t` is the center of
//! the circle of triangle `t`, so that some may coincide, with the attributes that the triangle's plane has
//! there; edge `e` belongs to edge `e` of the mesh. A row of edges is `number a b`, or, from a vertex to
//! infinity, `number a -1 dx dy`. It is a Voronoi diagram if the triangles are Delaunay.

use crate::target::Output;
use crate::topology::{NO_NEIGHBOR, Topology};
use crate::{Error, MeshView};
use delone::Point;
use delone::predicates::circumcenter;

/// Writes the vertices, numbered from `base`.
pub(crate) fn write_vertices(
    out: &mut Output<'_>,
    mesh: &MeshView<'_>,
    base: usize,
) -> Result<(), Error> {
    let (m, attributes) = (mesh.triangles.len(), mesh.attributes);
    out.text(format_args!("{m} 2 {} 0\n", attributes.len()))?;
    for (t, corners) in mesh.triangles.iter().enumerate() {
        let [a, b, c] = corners.map(|v| mesh.points[v.index()]);
        let center = circumcenter(a, b, c).ok_or_else(|| {
            Error::BadMesh(format!(
                "triangle {t} is flat: it has no circle (numbered from 0)"
            ))
        })?;
        out.integer((t + base) as i64);
        for coordinate in [center.x, center.y] {
            out.blank();
            out.number(coordinate);
        }
        for attribute in attributes {
            let values = corners.map(|v| attribute.values[v.index()]);
            out.blank();
            out.number(extended([a, b, c], values, center));
        }
        out.end_line()?;
    }
    Ok(())
}

/// Writes the edges in the order of those of the mesh, everything numbered from `base`.
pub(crate) fn write_edges(
    out: &mut Output<'_>,
    mesh: &MeshView<'_>,
    topology: &Topology,
    base: usize,
) -> Result<(), Error> {
    let of_triangles = |t: usize, k: usize| (t as u32) < topology.neighbors[t][k];
    let sides = (0..mesh.triangles.len()).flat_map(|t| [0, 1, 2].map(|k| (t, k)));
    let sides = sides.filter(|&(t, k)| of_triangles(t, k));
    out.text(format_args!("{} 0\n", sides.clone().count()))?;
    for (number, (t, k)) in sides.enumerate() {
        out.integer((number + base) as i64);
        out.blank();
        out.integer((t + base) as i64);
        out.blank();
        match topology.neighbors[t][k] {
            NO_NEIGHBOR => {
                let corners = mesh.triangles[t];
                let [a, b] = [1, 2].map(|i| mesh.points[corners[(k + i) % 3].index()]);
                out.bytes(b"-1 ")?;
                out.number(b.y - a.y);
                out.blank();
                out.number(a.x - b.x);
            }
            neighbor => out.integer(i64::from(neighbor) + base as i64),
        }
        out.end_line()?;
    }
    Ok(())
}

/// Returns what a function that is linear in a triangle is at a point, rounded; where that is no number,
/// as for coordinates near the largest, what it is at the first corner.
fn extended([a, b, c]: [Point; 3], [at_a, at_b, at_c]: [f64; 3], p: Point) -> f64 {
    let from_a = |q: Point| [q.x - a.x, q.y - a.y];
    let cross = |[ux, uy]: [f64; 2], [vx, vy]: [f64; 2]| ux * vy - uy * vx;
    let [u, v, w] = [b, c, p].map(from_a);
    let area = cross(u, v);
    let value = at_a + cross(w, v) / area * (at_b - at_a) + cross(u, w) / area * (at_c - at_a);
    if value.is_finite() { value } else { at_a }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_go_on_beyond_the_triangle() {
        let corners = [(0.0, 0.0), (2.0, 0.0), (0.0, 4.0)].map(Point::from);
        let plane = |p: Point| 1.0 + 3.0 * p.x - p.y;
        for p in [(1.0, 2.0), (-3.0, 8.0), (2.0, 0.0)].map(Point::from) {
            assert_eq!(extended(corners, corners.map(plane), p), plane(p));
        }
        assert_eq!(extended([corners[0]; 3], [7.0; 3], corners[1]), 7.0);
    }
}
