//! A number for each triangle, to colour it by, or to count by in whatever bins a picture has.

use super::Mesh;
use crate::Trouble;
use delone::TriangleId;
use delone::check::Shape;
use std::str::FromStr;

/// What is measured of a triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Measure {
    MinAngle,
    MaxAngle,
    Area,
    LongestEdge,
    RadiusRatio,
    Region,
}

impl FromStr for Measure {
    type Err = Trouble;

    fn from_str(name: &str) -> Result<Self, Trouble> {
        Ok(match name {
            "minAngle" => Self::MinAngle,
            "maxAngle" => Self::MaxAngle,
            "area" => Self::Area,
            "longestEdge" => Self::LongestEdge,
            "radiusRatio" => Self::RadiusRatio,
            "region" => Self::Region,
            _ => {
                return Err(Trouble::asked(format!(
                    "no measure is called {name:?}; there are minAngle, maxAngle, area, longestEdge, radiusRatio and region"
                )));
            }
        })
    }
}

impl Measure {
    /// Measures every triangle, in their order.
    pub fn all(self, mesh: &Mesh) -> impl Iterator<Item = f64> + '_ {
        let t = mesh.triangulation();
        let domain = mesh.domain();
        let region = move |i: usize| domain.and_then(|d| d.region(TriangleId::new(i)));
        let triangles = t.triangles().iter().enumerate();
        triangles.map(move |(i, corners)| match self {
            Self::Region => region(i).map_or(-1.0, |region| region as f64),
            _ => self.of(&Shape::of(corners.map(|v| t.point(v)))),
        })
    }

    fn of(self, shape: &Shape) -> f64 {
        match self {
            Self::MinAngle => shape.min_angle(),
            Self::MaxAngle => shape.max_angle(),
            Self::Area => shape.area,
            Self::LongestEdge => shape.edges.into_iter().fold(0.0, f64::max),
            Self::RadiusRatio => radius_ratio(shape),
            Self::Region => -1.0,
        }
    }
}

/// The radius of the incircle by that of the circumcircle, twice: 1 for an equilateral triangle, 0 for a flat one.
fn radius_ratio(shape: &Shape) -> f64 {
    let longest = shape.edges.into_iter().fold(0.0, f64::max);
    if longest == 0.0 {
        return 0.0;
    }
    // In units of the longest edge nothing overflows.
    let [a, b, c] = shape.edges.map(|edge| edge / longest);
    let around = (a + b + c) * a * b * c;
    let doubled = shape.aspect.recip();
    match around > 0.0 {
        true => (4.0 * doubled * doubled / around).min(1.0),
        false => 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::Drawing;
    use delone::Point;

    fn mesh(points: &[f64]) -> Mesh {
        let drawing = Drawing::new(points, &[], &[]).expect("points");
        Mesh::triangulate(&drawing, None).expect("a mesh")
    }

    #[test]
    fn radii_tell_good_triangles_from_bad() {
        let of = |c: (f64, f64)| {
            let corners = [(0.0, 0.0), (2.0, 0.0), c].map(Point::from);
            radius_ratio(&Shape::of(corners))
        };
        assert!((of((1.0, 3f64.sqrt())) - 1.0).abs() < 1e-12);
        // Radii 1 and 5/2 of the triangle 3, 4, 5.
        let right = [(0.0, 0.0), (3.0, 0.0), (0.0, 4.0)].map(Point::from);
        assert!((radius_ratio(&Shape::of(right)) - 0.8).abs() < 1e-12);
        assert_eq!((of((1.0, 0.0)), of((0.0, 0.0))), (0.0, 0.0));
        assert!(of((1.0, 1e-200)).is_finite());
    }

    #[test]
    fn every_triangle_is_measured() {
        let square = mesh(&[0.0, 0.0, 2.0, 0.0, 2.0, 2.0, 0.0, 2.0, 0.5, 1.0]);
        let sorted = |name: &str| {
            let measure: Measure = name.parse().expect("a measure");
            let mut all: Vec<f64> = measure.all(&square).collect();
            all.sort_by(f64::total_cmp);
            all
        };
        assert_eq!(sorted("area"), [0.5, 1.0, 1.0, 1.5]);
        assert_eq!(sorted("longestEdge")[3], 2.0);
        assert_eq!(sorted("region"), [-1.0; 4]);
        for name in ["minAngle", "maxAngle", "radiusRatio"] {
            assert_eq!(sorted(name).len(), 4, "{name}");
        }
    }

    #[test]
    fn without_triangles_there_are_no_numbers_and_other_measures_are_refused() {
        assert_eq!(Measure::Area.all(&mesh(&[])).count(), 0);
        "beauty".parse::<Measure>().expect_err("no measure");
    }
}
