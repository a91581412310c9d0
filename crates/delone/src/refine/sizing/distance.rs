//! Sizes that grow with the distance from given points and segments.

use super::tree::{Bounds, Near, Shape, Tree};
use super::unit::Unit;
use super::{SizingField, input};
use crate::{Error, Point};

/// By which share of itself a distance may be taken for too large.
const SLACK: f64 = 1.0 / 64.0;

/// A field that is small at given features and grows with the distance from the nearest of them:
/// `at_feature + growth × distance`, but never more than a [largest size](Self::at_most). Of many features
/// at nearly the same distance any may be taken, so distances may be 1.6 % too large.
///
/// ```
/// use delone::{Point, SizingField, sizing::Distance};
/// let wall = [[Point::new(0.0, 0.0), Point::new(0.0, 9.0)]];
/// let field = Distance::from_features(&[], &wall, 0.125, 0.25)?.at_most(1.0)?;
/// assert_eq!(field.max_edge(Point::new(0.0, 5.0)), 0.125);
/// assert_eq!(field.max_edge(Point::new(2.0, 5.0)), 0.625);
/// assert_eq!(field.max_edge(Point::new(9.0, 5.0)), 1.0);
/// # Ok::<(), delone::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Distance {
    tree: Tree<Feature>,
    unit: Unit,
    at_feature: f64,
    growth: f64,
    largest: f64,
}

impl Distance {
    /// Makes the field of points and segments. Without any there is no bound.
    ///
    /// `growth` is by how much sizes grow over a distance of one: edges next to each other differ by
    /// about this share, so 0.1 to 0.5 are usual.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for a point or an end, those of segment `s` counted as `2s` and `2s + 1`
    /// behind the points; [`Error::BadQuality`] if `at_feature` is not positive or `growth` negative.
    ///
    /// *Cost*: O(n log n); a question in practice O(log n).
    pub fn from_features(
        points: &[Point],
        segments: &[[Point; 2]],
        at_feature: f64,
        growth: f64,
    ) -> Result<Self, Error> {
        input::require_finite(points.iter().chain(segments.as_flattened()))?;
        input::require(
            "size at features, which must be positive and finite",
            at_feature,
            at_feature > 0.0 && at_feature < f64::INFINITY,
        )?;
        input::require(
            "growth of sizes, which must be at least 0 and finite",
            growth,
            (0.0..f64::INFINITY).contains(&growth),
        )?;
        let unit = Unit::of(points.iter().chain(segments.as_flattened()));
        let points = points.iter().map(|&p| [p; 2]);
        let features = points.chain(segments.iter().copied());
        let features: Vec<_> = features
            .map(|ends| Feature::new(ends.map(|p| unit.measure(p))))
            .collect();
        Ok(Self {
            tree: Tree::new(&features),
            unit,
            at_feature,
            growth,
            largest: f64::INFINITY,
        })
    }

    /// Limits the sizes far from all features.
    ///
    /// # Errors
    /// [`Error::BadQuality`] if the size is not positive.
    pub fn at_most(self, largest: f64) -> Result<Self, Error> {
        let what = "largest size, which must be positive";
        input::require(what, largest, largest > 0.0)?;
        Ok(Self { largest, ..self })
    }
}

impl SizingField for Distance {
    fn max_edge(&self, at: Point) -> f64 {
        let nearest = self.tree.nearest(self.unit.measure(at), SLACK);
        let size = nearest.map_or(f64::INFINITY, |(_, squared)| {
            self.at_feature + self.growth * self.unit.length(squared.sqrt())
        });
        size.min(self.largest)
    }
}

/// A segment, or a point.
#[derive(Clone, Copy, Debug)]
struct Feature {
    start: Point,
    along: [f64; 2],
    /// Of the squared length; 0 if that is none.
    inverse: f64,
}

impl Feature {
    fn new([start, end]: [Point; 2]) -> Self {
        let along = [end.x - start.x, end.y - start.y];
        let squared = along[0] * along[0] + along[1] * along[1];
        Self {
            start,
            along,
            // What is shorter is a point.
            inverse: if squared > 1e-290 { 1.0 / squared } else { 0.0 },
        }
    }
}

impl Shape for Feature {
    fn bounds(&self) -> Bounds {
        let Self { start, along, .. } = *self;
        let end = Point::new(start.x + along[0], start.y + along[1]);
        Bounds::of(&[start, end])
    }
}

impl Near for Feature {
    #[inline]
    fn distance_squared(&self, from: Point) -> f64 {
        let to = [from.x - self.start.x, from.y - self.start.y];
        let share = (to[0] * self.along[0] + to[1] * self.along[1]) * self.inverse;
        let share = share.clamp(0.0, 1.0);
        let [dx, dy] = [0, 1].map(|k| to[k] - share * self.along[k]);
        dx * dx + dy * dy
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn p(x: f64, y: f64) -> Point {
        Point::new(x, y)
    }

    #[test]
    fn points_and_segments_count_alike() {
        let field =
            Distance::from_features(&[p(10.0, 0.0)], &[[p(0.0, 0.0), p(0.0, 4.0)]], 1.0, 0.5);
        let field = field.unwrap();
        for (at, expected) in [
            (p(0.0, 2.0), 1.0),
            (p(-2.0, 2.0), 2.0),
            (p(3.0, 8.0), 3.5), // 5 from the end (0, 4)
            (p(10.0, -6.0), 4.0),
            (p(6.0, 0.0), 3.0),
        ] {
            assert_eq!(field.max_edge(at), expected, "{at:?}");
        }
    }

    #[test]
    fn a_segment_of_no_length_is_a_point() {
        let field = Distance::from_features(&[], &[[p(1.0, 1.0); 2]], 1.0, 1.0).unwrap();
        assert_eq!(field.max_edge(p(4.0, 5.0)), 6.0);
    }

    #[test]
    fn without_features_there_is_no_bound_but_the_largest() {
        let field = Distance::from_features(&[], &[], 1.0, 1.0).unwrap();
        assert_eq!(field.max_edge(p(0.0, 0.0)), f64::INFINITY);
        let field = field.at_most(2.0).unwrap();
        assert_eq!(field.max_edge(p(0.0, 0.0)), 2.0);
    }

    #[test]
    fn a_power_of_two_scales_everything() {
        let ends = [p(0.3, 0.7), p(0.9, 0.1)];
        for exponent in [-900, -30, 30, 900] {
            let scale = 2_f64.powi(exponent);
            let scaled = |p: Point| Point::new(p.x * scale, p.y * scale);
            let field = Distance::from_features(&[], &[ends], 0.1, 0.3).unwrap();
            let other =
                Distance::from_features(&[], &[ends.map(scaled)], 0.1 * scale, 0.3).unwrap();
            let at = p(-0.4, 0.2);
            assert_eq!(other.max_edge(scaled(at)), scale * field.max_edge(at));
        }
    }

    #[test]
    fn extreme_coordinates_give_sizes() {
        let ends = [p(-1e308, 5e-324), p(1e308, -1e-308)];
        for growth in [0.0, 1.0] {
            let field = Distance::from_features(&[], &[ends], 1.0, growth).unwrap();
            for at in [p(0.0, 0.0), p(f64::MAX, f64::MAX), p(-1e300, 1e-300)] {
                let size = field.max_edge(at);
                assert!(size >= 1.0, "{growth} {at:?}: {size}");
                assert!(growth > 0.0 || size == 1.0, "{at:?}: {size}");
            }
        }
    }

    #[test]
    fn senseless_numbers_are_refused() {
        let make = |at, growth| Distance::from_features(&[], &[], at, growth).err();
        for (at, growth) in [
            (0.0, 1.0),
            (f64::NAN, 1.0),
            (f64::INFINITY, 1.0),
            (1.0, -0.1),
            (1.0, f64::NAN),
            (1.0, f64::INFINITY),
        ] {
            assert!(matches!(make(at, growth), Some(Error::BadQuality { .. })));
        }
        let field = Distance::from_features(&[], &[], 1.0, 0.0).unwrap();
        assert!(field.at_most(f64::NAN).is_err());
        let nowhere = [p(0.0, 0.0), p(0.0, f64::NAN)];
        let error = Distance::from_features(&[p(0.0, 0.0)], &[nowhere], 1.0, 1.0).unwrap_err();
        assert!(matches!(error, Error::NotFinite { index: 2, .. }));
    }
}
