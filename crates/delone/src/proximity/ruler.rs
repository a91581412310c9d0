//! Rounded lengths, in units in which nothing over- or underflows that matters.

use crate::Point;
use crate::order::{exponent, split_power};

/// Measures in units of a power of two, in which the larger side of the bounding box is between 1/2 and 1.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ruler {
    /// 1/2 if differences of coordinates may overflow, else 1.
    first: f64,
    /// Two more factors: their product may leave the range.
    factors: [f64; 2],
    /// What undoes them.
    inverses: [f64; 2],
}

impl Ruler {
    /// Makes a ruler for some points.
    pub fn new(points: impl Iterator<Item = Point>) -> Self {
        let start = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        let (min, max) = points.fold(start, |(min, max), p| {
            let min = [min[0].min(p.x), min[1].min(p.y)];
            (min, [max[0].max(p.x), max[1].max(p.y)])
        });
        let extent = |first: f64| {
            let [x, y] = [0, 1].map(|k| first * max[k] - first * min[k]);
            x.max(y)
        };
        let first = if extent(1.0) == f64::INFINITY {
            0.5
        } else {
            1.0
        };
        let size = extent(first);
        // Of no points it is infinite, of one zero.
        let is_ordinary = size > 0.0 && size.is_finite();
        let exponent = if is_ordinary { exponent(size) + 1 } else { 0 };
        Self {
            first,
            factors: split_power(-exponent),
            inverses: split_power(exponent),
        }
    }

    /// Returns the vector from `a` to `b`.
    #[inline]
    pub fn vector(&self, a: Point, b: Point) -> [f64; 2] {
        let part =
            |a: f64, b: f64| (self.first * b - self.first * a) * self.factors[0] * self.factors[1];
        [part(a.x, b.x), part(a.y, b.y)]
    }

    /// Returns the distance of two points, with a relative error of a few units in the last place; what
    /// is below 2⁻⁵⁰⁰ of the extent may come out as zero.
    #[inline]
    pub fn distance(&self, a: Point, b: Point) -> f64 {
        let [x, y] = self.vector(a, b);
        (x * x + y * y).sqrt()
    }

    /// Turns a length into the units of the coordinates, infinite if it is too large for them.
    pub fn restored(&self, length: f64) -> f64 {
        length * self.inverses[0] * self.inverses[1] / self.first
    }

    /// Returns the point at `a` plus a vector.
    pub fn moved(&self, a: Point, [x, y]: [f64; 2]) -> Point {
        // Halves, since a vector may be too long though both its ends are in range.
        let part = |a: f64, x: f64| {
            let half = x * self.inverses[0] * self.inverses[1] * (0.5 / self.first);
            (a + half) + half
        };
        Point::new(part(a.x, x), part(a.y, y))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A triangle with sides 3, 4 and 5, in all sizes.
    #[test]
    fn measures_alike_in_every_size() {
        for e in [-1074, -1022, -500, 0, 3, 700, 1021] {
            let unit = 2_f64.powi(e / 2) * 2_f64.powi(e - e / 2);
            let corners = [(0.0, 0.0), (3.0, 0.0), (3.0, 4.0)];
            let [a, b, c] = corners.map(|(x, y)| Point::new(x * unit, y * unit));
            let ruler = Ruler::new([a, b, c].into_iter());
            assert_eq!(ruler.distance(a, c), 0.625, "{e}");
            assert_eq!(ruler.restored(0.625), 5.0 * unit);
            assert_eq!(ruler.moved(c, ruler.vector(c, b)), b);
        }
    }

    #[test]
    fn measures_across_the_whole_range() {
        let [a, b] = [Point::new(-f64::MAX, 1.0), Point::new(f64::MAX, 1.0)];
        let ruler = Ruler::new([a, b].into_iter());
        assert_eq!(ruler.distance(a, b).next_up(), 1.0);
        assert_eq!(ruler.restored(1.0), f64::INFINITY);
        assert_eq!(ruler.moved(a, ruler.vector(a, b)), b);
        assert_eq!(Ruler::new([a].into_iter()).distance(a, a), 0.0);
    }
}
