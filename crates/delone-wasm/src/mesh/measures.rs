//! A number for each triangle, to colour it by, and counts of these numbers.

use super::Mesh;
use crate::Trouble;
use delone::TriangleId;
use delone::check::Shape;
use serde::Serialize;
use std::str::FromStr;

/// Most bins of a histogram: more than any picture has columns.
const MOST_BINS: usize = 10_000;

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

/// How many triangles have which numbers.
#[derive(Debug, PartialEq, Serialize)]
pub(super) struct Histogram {
    low: f64,
    high: f64,
    counts: Vec<usize>,
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

    /// Returns what the measure can be, if that does not depend on the mesh: meshes side by side then have the same
    /// axis.
    fn range(self) -> Option<[f64; 2]> {
        match self {
            Self::MinAngle => Some([0.0, 60.0]),
            Self::MaxAngle => Some([60.0, 180.0]),
            Self::RadiusRatio => Some([0.0, 1.0]),
            Self::Area | Self::LongestEdge | Self::Region => None,
        }
    }

    /// Counts the triangles in even bins; what is infinite is in none.
    pub fn histogram(self, mesh: &Mesh, bins: usize) -> Result<Histogram, Trouble> {
        if !(1..=MOST_BINS).contains(&bins) {
            let message = format!("a histogram of {bins} bins: there must be 1 to {MOST_BINS}");
            return Err(Trouble::asked(message));
        }
        let values: Vec<f64> = self.all(mesh).filter(|value| value.is_finite()).collect();
        let [low, high] = self.range().unwrap_or_else(|| span(&values));
        let mut counts = vec![0; bins];
        for value in values {
            let share = match high > low {
                true => (value - low) / (high - low),
                false => 0.0,
            };
            // Beyond the ends by rounding only; a cast takes them to the nearest bin.
            counts[((share * bins as f64) as usize).min(bins - 1)] += 1;
        }
        Ok(Histogram { low, high, counts })
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

fn span(values: &[f64]) -> [f64; 2] {
    let low = values.iter().copied().fold(f64::INFINITY, f64::min);
    let high = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    match low <= high {
        true => [low, high],
        false => [0.0; 2],
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
    fn every_triangle_is_counted_once() {
        let square = mesh(&[0.0, 0.0, 2.0, 0.0, 2.0, 2.0, 0.0, 2.0, 0.5, 1.0]);
        for name in [
            "minAngle",
            "maxAngle",
            "area",
            "longestEdge",
            "radiusRatio",
            "region",
        ] {
            let measure: Measure = name.parse().expect("a measure");
            let counted = measure.histogram(&square, 7).expect("a histogram");
            assert_eq!(counted.counts.iter().sum::<usize>(), 4, "{name}");
        }
        let area = Measure::Area.histogram(&square, 3).expect("a histogram");
        assert_eq!(
            (area.low, area.high, area.counts),
            (0.5, 1.5, vec![1, 2, 1])
        );
    }

    #[test]
    fn what_cannot_be_counted_is_refused() {
        let nothing = mesh(&[]);
        let empty = Measure::Area.histogram(&nothing, 2).expect("a histogram");
        assert_eq!(empty.counts, [0, 0]);
        for bins in [0, MOST_BINS + 1] {
            Measure::Area.histogram(&nothing, bins).expect_err("bins");
        }
        "beauty".parse::<Measure>().expect_err("no measure");
    }
}
