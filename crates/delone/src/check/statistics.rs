//! What the triangles of a mesh are like, in rounded numbers: for reports and pictures, never for
//! decisions.

use super::histogram::LogHistogram;
use super::once;
use super::shape::{Shape, distance};
use crate::{Point, VertexId};

/// Quality of a whole triangulation.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Statistics {
    /// Number of triangles measured.
    pub triangles: usize,
    /// Smallest angle, in degrees; 180 if there are no triangles.
    pub min_angle: f64,
    /// Largest angle, in degrees; 0 if there are no triangles.
    pub max_angle: f64,
    /// Mean of the triangles' smallest angles, in degrees; 0 if there are no triangles.
    pub mean_min_angle: f64,
    /// Length of the shortest edge, in units of the coordinates; infinite if there are none.
    pub shortest_edge: f64,
    /// Length of the longest edge, in units of the coordinates; 0 if there are none.
    pub longest_edge: f64,
    /// Mean length of the edges, each counted once; 0 if there are none.
    pub mean_edge: f64,
    /// Largest [aspect](Shape); 0 if there are no triangles.
    pub worst_aspect: f64,
    /// Mean aspect; 0 if there are no triangles, infinite if one is flat.
    pub mean_aspect: f64,
    /// Largest [ratio of circumradius to shortest edge](Shape); 0 if there are no triangles.
    pub worst_radius_edge: f64,
    /// Mean of these ratios; 0 if there are no triangles, infinite if one is flat.
    pub mean_radius_edge: f64,
    /// Sum of the areas, in squared units of the coordinates.
    pub area: f64,
    /// Smallest area; infinite if there are no triangles.
    pub smallest_area: f64,
    /// Largest area; 0 if there are no triangles.
    pub largest_area: f64,
    /// Number of triangles by their smallest angle: entry `d` counts those of at least `d` and less
    /// than `d + 1` degrees; the last entry includes 60.
    pub min_angles: [usize; 60],
    /// Number of angles by their size, three of each triangle: entry `d` counts those of at least `d`
    /// and less than `d + 1` degrees; the last entry includes 180.
    pub angles: [usize; 180],
    /// Number of edges by their length, each counted once.
    pub edges: LogHistogram,
    /// Number of triangles by their area.
    pub areas: LogHistogram,
}

/// Measures every triangle and sums up.
///
/// # Panics
/// If a corner is no index of a point; [`verify`](super::verify) tells before.
///
/// *Cost*: about 60 ns a triangle, twice that if neighbours lie far apart in memory; 8 bytes a point.
pub fn statistics(points: &[Point], triangles: &[[VertexId; 3]]) -> Statistics {
    let mut sum = Statistics::none();
    for &triangle in triangles {
        let shape = Shape::of(triangle.map(|v| points[v.index()]));
        sum.add(&shape);
        for (side, length) in once::sides(triangle).into_iter().zip(shape.edges) {
            if once::ascends(side) {
                sum.add_edge(length);
            }
        }
    }
    for [from, to] in once::lonely(points.len(), triangles) {
        sum.add_edge(distance(points[from.index()], points[to.index()]));
    }
    sum.into_means()
}

impl Statistics {
    fn none() -> Self {
        Self {
            triangles: 0,
            min_angle: 180.0,
            max_angle: 0.0,
            mean_min_angle: 0.0,
            shortest_edge: f64::INFINITY,
            longest_edge: 0.0,
            mean_edge: 0.0,
            worst_aspect: 0.0,
            mean_aspect: 0.0,
            worst_radius_edge: 0.0,
            mean_radius_edge: 0.0,
            area: 0.0,
            smallest_area: f64::INFINITY,
            largest_area: 0.0,
            min_angles: [0; 60],
            angles: [0; 180],
            edges: LogHistogram::default(),
            areas: LogHistogram::default(),
        }
    }

    /// Adds one triangle; means stay sums until the end.
    fn add(&mut self, shape: &Shape) {
        let min_angle = shape.min_angle();
        self.triangles += 1;
        self.min_angle = self.min_angle.min(min_angle);
        self.max_angle = self.max_angle.max(shape.max_angle());
        self.mean_min_angle += min_angle;
        self.min_angles[(min_angle as usize).min(59)] += 1;
        for angle in shape.angles {
            self.angles[(angle as usize).min(179)] += 1;
        }
        self.worst_aspect = self.worst_aspect.max(shape.aspect);
        self.mean_aspect += shape.aspect;
        self.worst_radius_edge = self.worst_radius_edge.max(shape.radius_edge);
        self.mean_radius_edge += shape.radius_edge;
        self.area += shape.area;
        self.smallest_area = self.smallest_area.min(shape.area);
        self.largest_area = self.largest_area.max(shape.area);
        self.areas.add(shape.area);
    }

    fn add_edge(&mut self, length: f64) {
        self.shortest_edge = self.shortest_edge.min(length);
        self.longest_edge = self.longest_edge.max(length);
        self.mean_edge += length;
        self.edges.add(length);
    }

    fn into_means(mut self) -> Self {
        let triangles = self.triangles.max(1) as f64;
        self.mean_min_angle /= triangles;
        self.mean_aspect /= triangles;
        self.mean_radius_edge /= triangles;
        self.mean_edge /= self.edges.total().max(1) as f64;
        self
    }

    /// Returns the mean area, in squared units of the coordinates; 0 if there are no triangles.
    pub fn mean_area(&self) -> f64 {
        self.area / self.triangles.max(1) as f64
    }
}

#[cfg(test)]
mod tests {
    use super::statistics;
    use crate::{Point, VertexId};

    /// Two squares that share one corner and turn about it in opposite order of indices.
    #[test]
    fn edges_count_once_where_borders_touch() {
        let points = [(0, 0), (1, 0), (1, 1), (0, 1), (-1, 0), (-1, -1), (0, -1)];
        let points = points.map(|(x, y)| Point::new(f64::from(x), f64::from(y)));
        let triangles = [[0, 1, 2], [0, 2, 3], [4, 5, 0], [5, 6, 0]];
        let triangles = triangles.map(|t| t.map(VertexId::new));
        let found = statistics(&points, &triangles);
        assert_eq!(found.edges.total(), 10);
        assert_eq!(found.angles.iter().sum::<usize>(), 12);
        assert_eq!(found.areas.total(), 4);
        assert_eq!(found.mean_edge, (8.0 + 2.0 * 2f64.sqrt()) / 10.0);
        assert_eq!((found.smallest_area, found.mean_area()), (0.5, 0.5));
    }

    #[test]
    fn one_triangle_has_three_edges_however_it_is_numbered() {
        let points = [(0., 0.), (4., 0.), (0., 3.)].map(Point::from);
        for triangle in [[0, 1, 2], [1, 2, 0], [2, 0, 1]] {
            let found = statistics(&points, &[triangle.map(VertexId::new)]);
            assert_eq!(found.edges.total(), 3, "{triangle:?}");
            assert_eq!(found.mean_edge, 4.0);
            assert_eq!((found.shortest_edge, found.longest_edge), (3.0, 5.0));
        }
    }
}
