//! Angles, lengths and areas, in rounded numbers: for reports and pictures, never for decisions.

use crate::{Point, VertexId};

/// Shape of one triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shape {
    /// Angles at the corners, in degrees.
    pub angles: [f64; 3],
    /// Lengths of the edges opposite the corners, in units of the coordinates.
    pub edges: [f64; 3],
    /// Area, in squared units of the coordinates, never negative; may round to zero or infinity.
    pub area: f64,
    /// Longest edge divided by the height upon it: 1.1547 for an equilateral triangle, infinite for
    /// a flat one.
    pub aspect: f64,
}

impl Shape {
    /// Measures a triangle with corners in either orientation.
    ///
    /// Angles keep their meaning for coordinates of any size; differences beyond the largest `f64`
    /// count as that.
    pub fn of(corners: [Point; 3]) -> Self {
        let [a, b, c] = corners;
        let sides = [(b, c), (c, a), (a, b)].map(|(from, to)| difference(from, to));
        let edges = sides.map(|[x, y]| x.hypot(y));
        // Angles do not depend on the scale: neither products nor sums can overflow here, and none
        // that matters underflows.
        let longest = sides
            .as_flattened()
            .iter()
            .fold(f64::MIN_POSITIVE, |m, c| m.max(c.abs()));
        let unit @ [u, v, w] = sides.map(|side| side.map(|c| c / longest));
        let angles = [(v, w), (w, u), (u, v)].map(|(p, q)| angle_between(p, q));
        let doubled_area = cross(u, v).abs();
        let longest_squared = unit.iter().map(|[x, y]| x * x + y * y).fold(0.0, f64::max);
        Self {
            angles,
            edges,
            area: 0.5 * doubled_area * longest * longest,
            aspect: longest_squared / doubled_area,
        }
    }

    /// Returns the smallest angle, in degrees: 60 for an equilateral triangle, 0 for a flat one.
    pub fn min_angle(&self) -> f64 {
        smallest(self.angles)
    }

    /// Returns the largest angle, in degrees.
    pub fn max_angle(&self) -> f64 {
        largest(self.angles)
    }
}

/// Quality of a whole triangulation.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Quality {
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
    /// Largest [aspect](Shape); 0 if there are no triangles.
    pub worst_aspect: f64,
    /// Sum of the areas, in squared units of the coordinates.
    pub area: f64,
    /// Number of triangles by their smallest angle: entry `d` counts those of at least `d` and less
    /// than `d + 1` degrees; the last entry includes 60.
    pub min_angles: [usize; 60],
}

/// Measures every triangle and sums up.
///
/// # Panics
/// If a corner is no index of a point; [`verify`](super::verify) tells before.
///
/// *Cost*: about 100 ns a triangle.
pub fn quality(points: &[Point], triangles: &[[VertexId; 3]]) -> Quality {
    let mut sum = Quality {
        triangles: triangles.len(),
        min_angle: 180.0,
        max_angle: 0.0,
        mean_min_angle: 0.0,
        shortest_edge: f64::INFINITY,
        longest_edge: 0.0,
        worst_aspect: 0.0,
        area: 0.0,
        min_angles: [0; 60],
    };
    for corners in triangles {
        sum.add(&Shape::of(corners.map(|v| points[v.index()])));
    }
    sum.mean_min_angle /= triangles.len().max(1) as f64;
    sum
}

impl Quality {
    /// Adds one triangle; the mean stays a sum until the end.
    fn add(&mut self, shape: &Shape) {
        let min_angle = shape.min_angle();
        self.min_angle = self.min_angle.min(min_angle);
        self.max_angle = self.max_angle.max(shape.max_angle());
        self.mean_min_angle += min_angle;
        self.shortest_edge = self.shortest_edge.min(smallest(shape.edges));
        self.longest_edge = self.longest_edge.max(largest(shape.edges));
        self.worst_aspect = self.worst_aspect.max(shape.aspect);
        self.area += shape.area;
        self.min_angles[(min_angle as usize).min(59)] += 1;
    }
}

fn difference(from: Point, to: Point) -> [f64; 2] {
    [to.x - from.x, to.y - from.y].map(|c| c.clamp(-f64::MAX, f64::MAX))
}

fn cross([ax, ay]: [f64; 2], [bx, by]: [f64; 2]) -> f64 {
    ax * by - ay * bx
}

/// The angle at a corner, in degrees, between the side that comes in and the side that goes out.
fn angle_between(incoming: [f64; 2], outgoing: [f64; 2]) -> f64 {
    let [ax, ay] = incoming.map(|c| -c);
    let [bx, by] = outgoing;
    let dot = ax * bx + ay * by;
    cross([ax, ay], [bx, by]).abs().atan2(dot).to_degrees()
}

fn smallest([a, b, c]: [f64; 3]) -> f64 {
    a.min(b).min(c)
}

fn largest([a, b, c]: [f64; 3]) -> f64 {
    a.max(b).max(c)
}
