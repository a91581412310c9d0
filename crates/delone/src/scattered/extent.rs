//! The box around points, and their mean.
//!
//! A mean is that of all points, whatever their order: coordinates are added as integers, multiples of 2⁻⁹⁰
//! of the largest power of two among them. Whatever is cut off there is far below the last place of the largest
//! coordinate; nothing overflows, and nothing depends on the order in which points are visited.
//!
//! *Cost*: O(n), about 20 ns a point.

use crate::Point;

/// Bits of a coordinate before it is added to others: 2³² of them fit 127 bits.
const BITS: i32 = 90;

/// The smallest box, parallel to the axes, that contains some points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Extent {
    /// Its lower left corner.
    pub low: Point,
    /// Its upper right corner.
    pub high: Point,
}

impl Extent {
    /// Finds the box of finite points; `None` if there are none.
    pub fn of(points: impl IntoIterator<Item = Point>) -> Option<Self> {
        let boxes = points.into_iter().map(|p| Self { low: p, high: p });
        boxes.reduce(|a, b| Self {
            low: Point::new(a.low.x.min(b.low.x), a.low.y.min(b.low.y)),
            high: Point::new(a.high.x.max(b.high.x), a.high.y.max(b.high.y)),
        })
    }

    /// Returns the mean of at most 2³² points, of which this is the box. It lies in the box, and is off by less
    /// than a unit in its last place and 2⁻⁸⁸ of the largest coordinate.
    pub fn mean(&self, points: impl IntoIterator<Item = Point>) -> Point {
        let mut x = Sum::new([self.low.x, self.high.x]);
        let mut y = Sum::new([self.low.y, self.high.y]);
        let mut count = 0;
        for p in points {
            x.add(p.x);
            y.add(p.y);
            count += 1;
        }
        Point::new(x.mean(count), y.mean(count))
    }
}

/// Numbers added up as integers.
struct Sum {
    /// Between which they lie.
    ends: [f64; 2],
    /// By which power of two they are multiplied before.
    shift: i32,
    sum: i128,
}

impl Sum {
    fn new(ends: [f64; 2]) -> Self {
        let shift = BITS - exponent_above(ends[0].abs().max(ends[1].abs()));
        Self {
            ends,
            shift,
            sum: 0,
        }
    }

    #[inline]
    fn add(&mut self, c: f64) {
        // Below 2⁹⁰ in magnitude. What underflows is less than one.
        self.sum += times_power_of_two(c, self.shift) as i128;
    }

    fn mean(&self, count: i128) -> f64 {
        let [low, high] = self.ends;
        let mean = self.sum.div_euclid(count.max(1)) as f64;
        // Adding zero turns −0.0 into 0.0.
        times_power_of_two(mean, -self.shift).clamp(low, high) + 0.0
    }
}

/// Returns the exponent of a power of two that is larger than a number that is not negative.
fn exponent_above(size: f64) -> i32 {
    let biased = (size.to_bits() >> 52) as i32;
    biased.max(1) - 1022
}

/// Returns `c · 2^exponent`, for exponents up to 2000 in magnitude.
#[inline]
fn times_power_of_two(c: f64, exponent: i32) -> f64 {
    let power = |e: i32| f64::from_bits(u64::from((1023 + e).cast_unsigned()) << 52);
    let half = exponent / 2;
    c * power(half) * power(exponent - half)
}

#[cfg(test)]
mod tests {
    use super::*;
    use dashu_ratio::RBig;
    use delone_testkit::generate::Kind;

    fn exact_mean(numbers: &[f64]) -> f64 {
        let exact = |&c: &f64| RBig::try_from(c).expect("finite");
        let sum = numbers.iter().map(exact).fold(RBig::ZERO, |a, b| a + b);
        (sum / RBig::from(numbers.len())).to_f64().value()
    }

    #[test]
    fn means_are_those_of_rational_arithmetic_in_any_order() {
        for kind in Kind::ALL {
            for n in [1, 2, 3, 7, 100] {
                let mut points = crate::scattered::samples(kind, n, 5);
                let extent = Extent::of(points.iter().copied()).expect("points");
                let mean = extent.mean(points.iter().copied());
                points.reverse();
                assert_eq!(extent.mean(points.iter().copied()), mean);
                let x: Vec<f64> = points.iter().map(|p| p.x).collect();
                let y: Vec<f64> = points.iter().map(|p| p.y).collect();
                let ends = [(extent.low.x, extent.high.x), (extent.low.y, extent.high.y)];
                let means = [(mean.x, exact_mean(&x)), (mean.y, exact_mean(&y))];
                for ((low, high), (mean, exact)) in ends.into_iter().zip(means) {
                    let exact = exact.clamp(low, high);
                    let slack = low.abs().max(high.abs()) * 2_f64.powi(-88);
                    let is_near =
                        exact.next_down() - slack <= mean && mean <= exact.next_up() + slack;
                    assert!(is_near, "{kind:?}: {mean} for {exact}");
                }
            }
        }
    }

    #[test]
    fn means_stay_in_the_box_at_any_size() {
        let sizes = [5e-324, 1e-310, 1e-300, 1.0, 1e300, f64::MAX];
        for size in sizes {
            let at = |x: f64| Point::new(x, -x);
            let points = [size, size, size.next_down()].map(at);
            let extent = Extent::of(points).expect("points");
            let Point { x, y } = extent.mean(points);
            assert!(extent.low.x <= x && x <= extent.high.x && y == -x);
            assert_eq!(
                Extent::of([at(size); 3]).map(|e| e.mean([at(size); 3])),
                Some(at(size))
            );
            let mean = Extent::of([at(-size), at(size)]).map(|e| e.mean([at(-size), at(size)]));
            assert_eq!(mean, Some(Point::new(0.0, 0.0)));
        }
        assert_eq!(Extent::of([]), None);
    }
}
