//! Largest areas given for the triangles of a mesh.

use super::tree::{Bounds, Shape, Tree};
use super::{SizingField, input};
use crate::predicates::{Orientation, orient2d};
use crate::{Error, Point, VertexId};

/// A field with a largest area for each triangle of a mesh, as `.area` files have it; outside there is
/// no bound. Where triangles meet or overlap, the smallest of their areas counts. Edges are not bounded.
///
/// ```
/// use delone::{Point, SizingField, VertexId, sizing::Areas};
/// let points = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)].map(Point::from);
/// let triangle = [0, 1, 2].map(VertexId::new);
/// let field = Areas::from_mesh(&points, &[triangle], &[0.01])?;
/// assert_eq!(field.max_area(Point::new(0.25, 0.5)), 0.01);
/// assert_eq!(field.max_area(Point::new(1.0, 1.0)), f64::INFINITY);
/// # Ok::<(), delone::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Areas {
    tree: Tree<Patch>,
}

impl Areas {
    /// Makes the field; an area that is not positive is no bound.
    ///
    /// # Errors
    /// [`Error::SizesMissing`] unless each triangle has an area; [`Error::BadTriangle`] for a corner
    /// that is no point; [`Error::NotFinite`] for a point.
    ///
    /// *Cost*: O(n log n); a question in practice O(log n).
    pub fn from_mesh(
        points: &[Point],
        triangles: &[[VertexId; 3]],
        areas: &[f64],
    ) -> Result<Self, Error> {
        input::require_number(areas.len(), triangles.len(), "triangles")?;
        input::require_finite(points)?;
        input::require_corners(triangles, points.len())?;
        let bounded = triangles.iter().zip(areas).filter(|&(_, &area)| area > 0.0);
        let patches = bounded.filter_map(|(corners, &area)| {
            let corners = corners.map(|v| points[v.index()]);
            Patch::new(corners, area)
        });
        let patches: Vec<Patch> = patches.collect();
        Ok(Self {
            tree: Tree::new(&patches),
        })
    }
}

impl SizingField for Areas {
    fn max_edge(&self, _: Point) -> f64 {
        f64::INFINITY
    }

    fn max_area(&self, at: Point) -> f64 {
        let mut least = f64::INFINITY;
        self.tree.around(at, &mut |patch| {
            if patch.area < least && patch.holds(at) {
                least = patch.area;
            }
            false
        });
        least
    }
}

/// A counter-clockwise triangle with a largest area.
#[derive(Clone, Copy, Debug)]
struct Patch {
    corners: [Point; 3],
    area: f64,
}

impl Patch {
    /// Turns the triangle counter-clockwise; a flat one holds nothing.
    fn new([a, b, c]: [Point; 3], area: f64) -> Option<Self> {
        let corners = match orient2d(a, b, c) {
            Orientation::Left => [a, b, c],
            Orientation::Right => [a, c, b],
            Orientation::Collinear => return None,
        };
        Some(Self { corners, area })
    }

    /// Tells whether a point lies in the triangle or on its edges: exactly, lest points on an edge lie
    /// in neither of its triangles.
    fn holds(&self, at: Point) -> bool {
        let [a, b, c] = self.corners;
        [(a, b), (b, c), (c, a)]
            .iter()
            .all(|&(from, to)| orient2d(from, to, at) != Orientation::Right)
    }
}

impl Shape for Patch {
    fn bounds(&self) -> Bounds {
        Bounds::of(&self.corners)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn p(x: f64, y: f64) -> Point {
        Point::new(x, y)
    }

    /// A square of two triangles, one of them clockwise, and a flat one on its lower side.
    fn square(areas: &[f64]) -> Result<Areas, Error> {
        let points = [
            p(0.0, 0.0),
            p(1.0, 0.0),
            p(1.0, 1.0),
            p(0.0, 1.0),
            p(0.5, 0.0),
        ];
        let triangles = [[0, 1, 2], [0, 3, 2], [0, 4, 1]].map(|t| t.map(VertexId::new));
        Areas::from_mesh(&points, &triangles, areas)
    }

    #[test]
    fn each_triangle_has_its_area() {
        let field = square(&[0.1, 0.2, 1e-9]).unwrap();
        for (at, expected) in [
            (p(0.7, 0.3), 0.1),
            (p(0.3, 0.7), 0.2),
            (p(0.5, 0.5), 0.1),
            (p(0.5, 0.0), 0.1),
            (p(1.0, 1.0), 0.1),
            (p(0.0, 1.0), 0.2),
            (p(1.1, 1.0), f64::INFINITY),
            (p(0.5, -5e-324), f64::INFINITY),
        ] {
            assert_eq!(field.max_area(at), expected, "{at:?}");
        }
        assert_eq!(field.max_edge(p(0.5, 0.5)), f64::INFINITY);
    }

    /// However the order, a diagonal has the smaller of both.
    #[test]
    fn an_edge_has_the_smaller_area() {
        let field = square(&[0.2, 0.1, -1.0]).unwrap();
        assert_eq!(field.max_area(p(0.25, 0.25)), 0.1);
    }

    #[test]
    fn what_is_not_positive_is_no_bound() {
        let field = square(&[-1.0, f64::NAN, 0.0]).unwrap();
        for at in [p(0.7, 0.3), p(0.3, 0.7), p(0.5, 0.0)] {
            assert_eq!(field.max_area(at), f64::INFINITY);
        }
    }

    /// Decided without squares, so no unit is needed.
    #[test]
    fn extreme_coordinates_are_right() {
        let points = [p(-1e308, -1e308), p(1e308, -1e308), p(0.0, 1e308)];
        let triangle = [0, 1, 2].map(VertexId::new);
        let field = Areas::from_mesh(&points, &[triangle], &[2.0]).unwrap();
        assert_eq!(field.max_area(p(0.0, 0.0)), 2.0);
        assert_eq!(field.max_area(p(-1e308, 1e308)), f64::INFINITY);
    }

    #[test]
    fn each_triangle_needs_an_area() {
        let missing = Error::SizesMissing {
            given: 2,
            expected: 3,
            of: "triangles",
        };
        assert_eq!(square(&[1.0, 1.0]).unwrap_err(), missing);
    }
}
