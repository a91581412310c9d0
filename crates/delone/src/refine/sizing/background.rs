//! Sizes given at points, and linear in between.

use super::tree::{Bounds, Near, Shape, Tree};
use super::unit::Unit;
use super::{SizingField, input};
use crate::delaunay::Delaunay;
use crate::{Error, Point, Triangulation, VertexId};

/// A field with sizes given at the vertices of a mesh: linear inside of its triangles; elsewhere, in
/// holes of the mesh too, that of the nearest point of a triangle.
///
/// ```
/// use delone::{Point, SizingField, sizing::Background};
/// let points = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)].map(Point::from);
/// let field = Background::from_points(&points, &[1.0, 2.0, 3.0])?;
/// assert_eq!(field.max_edge(Point::new(0.25, 0.5)), 2.25);
/// assert_eq!(field.max_edge(Point::new(0.5, -9.0)), 1.5);
/// # Ok::<(), delone::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Background {
    tree: Tree<Patch>,
    unit: Unit,
}

impl Background {
    /// Makes the field of scattered points, linear on the triangles of their Delaunay triangulation; of
    /// equal points the smallest size counts. If all points lie on one line it is linear along it.
    ///
    /// # Errors
    /// [`Error::SizesMissing`] unless each point has a size; [`Error::BadSize`] for one that is not a
    /// positive finite number; otherwise those of [`triangulate`](crate::triangulate).
    ///
    /// *Cost*: O(n log n); a question in practice O(log n).
    pub fn from_points(points: &[Point], sizes: &[f64]) -> Result<Self, Error> {
        input::require_number(sizes.len(), points.len(), "points")?;
        input::require_sizes(sizes)?;
        let triangulation = Delaunay::new().triangulate(points.iter().copied())?;
        let mut sizes = sizes.to_vec();
        for duplicate in triangulation.duplicates() {
            let other = sizes[duplicate.dropped.index()];
            let size = &mut sizes[duplicate.kept.index()];
            *size = size.min(other);
        }
        Ok(Self::of(points, &patches(&triangulation), &sizes))
    }

    /// Makes the field of a mesh, which need not be Delaunay, nor convex, nor even free of overlaps; in
    /// those, any of the triangles counts.
    ///
    /// # Errors
    /// [`Error::SizesMissing`] unless each point has a size; [`Error::BadSize`] for one that is not a
    /// positive finite number; [`Error::BadTriangle`] for a corner that is no point;
    /// [`Error::NotFinite`] for a point.
    ///
    /// *Cost*: O(n log n); a question in practice O(log n).
    pub fn from_mesh(
        points: &[Point],
        triangles: &[[VertexId; 3]],
        sizes: &[f64],
    ) -> Result<Self, Error> {
        input::require_number(sizes.len(), points.len(), "points")?;
        input::require_sizes(sizes)?;
        input::require_finite(points)?;
        input::require_corners(triangles, points.len())?;
        Ok(Self::of(points, triangles, sizes))
    }

    fn of(points: &[Point], triangles: &[[VertexId; 3]], sizes: &[f64]) -> Self {
        let unit = Unit::of(points.iter());
        let patch = |corners: &[VertexId; 3]| Patch {
            corners: corners.map(|v| unit.measure(points[v.index()])),
            sizes: corners.map(|v| sizes[v.index()]),
        };
        let patches: Vec<Patch> = triangles
            .iter()
            .map(|t| patch(t).counter_clockwise())
            .collect();
        Self {
            tree: Tree::new(&patches),
            unit,
        }
    }
}

/// Lists triangles; if all points lie on one line, its edges, as triangles without area; if there is
/// but one point, that.
fn patches(triangulation: &Triangulation) -> Vec<[VertexId; 3]> {
    match triangulation.num_vertices() {
        0 => Vec::new(),
        1 => vec![[triangulation.representative(VertexId::new(0)); 3]],
        _ if triangulation.num_triangles() == 0 => {
            triangulation.edges().map(|[a, b]| [a, b, b]).collect()
        }
        _ => triangulation.triangles().to_vec(),
    }
}

impl SizingField for Background {
    fn max_edge(&self, at: Point) -> f64 {
        let at = self.unit.measure(at);
        let mut size = None;
        // Most places lie in a triangle, and finding that costs far less than the nearest.
        self.tree.around(at, &mut |patch| {
            size = patch.size_within(at);
            size.is_some()
        });
        let beside = || {
            let (patch, _) = self.tree.nearest(at, 0.0)?;
            Some(patch.size_beside(at))
        };
        size.or_else(beside).unwrap_or(f64::INFINITY)
    }
}

/// A triangle with a size at each corner, counter-clockwise, perhaps flat.
#[derive(Clone, Copy, Debug)]
struct Patch {
    corners: [Point; 3],
    sizes: [f64; 3],
}

impl Patch {
    fn counter_clockwise(mut self) -> Self {
        let [a, b, c] = self.corners;
        if cross(a, b, c) < 0.0 {
            self.corners.swap(1, 2);
            self.sizes.swap(1, 2);
        }
        self
    }

    /// Returns the size at a point; `None` if that is outside, and if the triangle is flat.
    #[inline]
    fn size_within(&self, at: Point) -> Option<f64> {
        let ([a, b, c], [f, g, h]) = (self.corners, self.sizes);
        let [u, v, w] = [cross(at, b, c), cross(at, c, a), cross(at, a, b)];
        let sum = u + v + w;
        let is_inside = u >= 0.0 && v >= 0.0 && w >= 0.0 && sum > 0.0;
        is_inside.then(|| self.clamp((u * f + v * g + w * h) / sum))
    }

    /// Returns the size at the nearest point of an edge.
    fn size_beside(&self, at: Point) -> f64 {
        self.clamp(self.nearest_on_edges(at).1)
    }

    /// Rounding must not lead out of what was given.
    fn clamp(&self, size: f64) -> f64 {
        let [f, g, h] = self.sizes;
        size.clamp(f.min(g).min(h), f.max(g).max(h))
    }

    /// Returns the square of the distance to the nearest edge, and the size there.
    fn nearest_on_edges(&self, at: Point) -> (f64, f64) {
        let ([a, b, c], [f, g, h]) = (self.corners, self.sizes);
        let edges = [([a, b], [f, g]), ([b, c], [g, h]), ([c, a], [h, f])];
        let nearest = edges.map(|(ends, sizes)| {
            let (squared, share) = from_segment(ends, at);
            (squared, sizes[0] + share * (sizes[1] - sizes[0]))
        });
        let lesser = |a: (f64, f64), b: (f64, f64)| if b.0 < a.0 { b } else { a };
        lesser(lesser(nearest[0], nearest[1]), nearest[2])
    }
}

impl Shape for Patch {
    fn bounds(&self) -> Bounds {
        Bounds::of(&self.corners)
    }
}

impl Near for Patch {
    fn distance_squared(&self, from: Point) -> f64 {
        self.nearest_on_edges(from).0
    }
}

/// Returns the square of the distance from a segment, and how far along it the nearest point lies.
fn from_segment([a, b]: [Point; 2], at: Point) -> (f64, f64) {
    let (along, to) = ([b.x - a.x, b.y - a.y], [at.x - a.x, at.y - a.y]);
    let squared = along[0] * along[0] + along[1] * along[1];
    let share = (to[0] * along[0] + to[1] * along[1]) / squared;
    // Of a segment of no length it is no number.
    let share = if squared > 0.0 {
        share.clamp(0.0, 1.0)
    } else {
        0.0
    };
    let [dx, dy] = [to[0] - share * along[0], to[1] - share * along[1]];
    (dx * dx + dy * dy, share)
}

/// Twice the area of a triangle, rounded.
#[inline]
fn cross(a: Point, b: Point, c: Point) -> f64 {
    (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn p(x: f64, y: f64) -> Point {
        Point::new(x, y)
    }

    fn scattered(n: usize) -> Vec<Point> {
        let mut state = 3_u64;
        let mut unit = move || {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1);
            (state >> 33) as f64 / (1_u64 << 31) as f64
        };
        (0..n).map(|_| p(unit(), unit())).collect()
    }

    #[test]
    fn a_linear_field_comes_back() {
        let points = scattered(500);
        let plane = |q: Point| 3.0 + q.x - 2.0 * q.y;
        let sizes: Vec<f64> = points.iter().map(|&q| plane(q)).collect();
        let field = Background::from_points(&points, &sizes).unwrap();
        for q in scattered(2000).into_iter().skip(500) {
            let middle = p(0.2 + 0.6 * q.x, 0.2 + 0.6 * q.y);
            let difference = field.max_edge(middle) - plane(middle);
            assert!(difference.abs() < 1e-12, "{middle:?}: {difference}");
        }
        for (&q, &size) in points.iter().zip(&sizes) {
            assert!((field.max_edge(q) - size).abs() < 1e-12);
        }
    }

    #[test]
    fn outside_counts_the_nearest_point_of_the_hull() {
        let square = [p(0.0, 0.0), p(2.0, 0.0), p(2.0, 2.0), p(0.0, 2.0)];
        let field = Background::from_points(&square, &[1.0, 3.0, 5.0, 7.0]).unwrap();
        for (at, expected) in [
            (p(1.0, -4.0), 2.0),
            (p(9.0, 0.5), 3.5),
            (p(-1.0, -1.0), 1.0),
            (p(3.0, 9.0), 5.0),
        ] {
            assert_eq!(field.max_edge(at), expected, "{at:?}");
        }
    }

    #[test]
    fn points_on_a_line_make_a_field_along_it() {
        let row = [p(0.0, 0.0), p(4.0, 4.0), p(2.0, 2.0)];
        let field = Background::from_points(&row, &[1.0, 9.0, 3.0]).unwrap();
        for (at, expected) in [(p(2.0, 0.0), 2.0), (p(3.0, 3.0), 6.0), (p(9.0, 9.0), 9.0)] {
            assert_eq!(field.max_edge(at), expected, "{at:?}");
        }
        let one = Background::from_points(&[p(1.0, 1.0); 3], &[2.0, 0.5, 1.0]).unwrap();
        assert_eq!(
            one.max_edge(p(7.0, 0.0)),
            0.5,
            "the smallest of equal points"
        );
        let none = Background::from_points(&[], &[]).unwrap();
        assert_eq!(none.max_edge(p(0.0, 0.0)), f64::INFINITY);
    }

    #[test]
    fn of_equal_points_the_smallest_size_counts() {
        let points = [p(0.0, 0.0), p(1.0, 0.0), p(0.0, 1.0), p(1.0, 0.0)];
        for sizes in [[4.0, 1.0, 4.0, 2.0], [4.0, 2.0, 4.0, 1.0]] {
            let field = Background::from_points(&points, &sizes).unwrap();
            assert_eq!(field.max_edge(points[1]), 1.0);
        }
    }

    /// Clockwise triangles, one without area, and a hole between them.
    #[test]
    fn a_mesh_may_be_any_triangles() {
        let points = [
            p(0.0, 0.0),
            p(1.0, 0.0),
            p(0.0, 1.0),
            p(9.0, 0.0),
            p(10.0, 0.0),
            p(9.0, 1.0),
        ];
        let id = |t: [usize; 3]| t.map(VertexId::new);
        let triangles = [id([0, 2, 1]), id([3, 4, 5]), id([1, 3, 3])];
        let sizes = [1.0, 2.0, 3.0, 4.0, 4.0, 4.0];
        let field = Background::from_mesh(&points, &triangles, &sizes).unwrap();
        for (at, expected) in [
            (p(0.25, 0.25), 1.75),
            (p(9.25, 0.25), 4.0),
            (p(5.0, -1.0), 3.0),
            (p(9.0, 5.0), 4.0),
        ] {
            assert_eq!(field.max_edge(at), expected, "{at:?}");
        }
    }

    #[test]
    fn extreme_coordinates_give_sizes_between_those_given() {
        for scale in [1e-320, 1e-160, 1e160, 1e307] {
            let points: Vec<Point> = scattered(50)
                .iter()
                .map(|q| p(q.x * scale, q.y * scale))
                .collect();
            let sizes: Vec<f64> = (1..=50).map(f64::from).collect();
            let field = Background::from_points(&points, &sizes).unwrap();
            for q in scattered(200) {
                for factor in [scale, 1.0, 1e300] {
                    let size = field.max_edge(p(q.x * factor, -q.y * factor));
                    assert!((1.0..=50.0).contains(&size), "{scale} {factor}: {size}");
                }
            }
        }
    }

    #[test]
    fn what_makes_no_sense_is_refused() {
        let points = [p(0.0, 0.0), p(1.0, 0.0), p(0.0, 1.0)];
        let sizes = |sizes: &[f64]| Background::from_points(&points, sizes).unwrap_err();
        let missing = Error::SizesMissing {
            given: 2,
            expected: 3,
            of: "points",
        };
        assert_eq!(sizes(&[1.0, 1.0]), missing);
        for wrong in [0.0, -1.0, f64::INFINITY, f64::NAN] {
            let error = sizes(&[1.0, wrong, 1.0]);
            assert!(matches!(error, Error::BadSize { index: 1, .. }), "{error}");
        }
        let far = [[0, 1, 3].map(VertexId::new)];
        let error = Background::from_mesh(&points, &far, &[1.0; 3]).unwrap_err();
        assert!(matches!(
            error,
            Error::BadTriangle {
                triangle: 0,
                points: 3,
                ..
            }
        ));
        let nowhere = [points[0], points[1], p(f64::INFINITY, 0.0)];
        let error = Background::from_mesh(&nowhere, &[], &[1.0; 3]).unwrap_err();
        assert!(matches!(error, Error::NotFinite { index: 2, .. }));
    }
}
