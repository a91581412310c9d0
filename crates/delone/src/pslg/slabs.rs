//! Strips of the plane that hold segments, as narrow as the segments are parallel.
//!
//! Boxes of long segments side by side overlap however far apart the segments are, unless a side of the
//! box happens to have their direction. A strip takes its direction from what it holds, as oriented
//! boxes do (Gottschalk, Lin and Manocha, *OBBTree*, 1996).
//!
//! The distance from a line is computed with errors; strips are wider by more than these, so what has
//! a point in common is never told apart. They may be too wide: they only spare work.

use crate::Point;

/// The points p with `range[0]` ≤ `normal` · p ≤ `range[1]`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Slab {
    /// Neither component is above 1 in magnitude.
    normal: [f64; 2],
    range: [f64; 2],
}

impl Slab {
    /// Holds everything.
    pub const PLANE: Self = Self {
        normal: [0.0, 1.0],
        range: [f64::NEG_INFINITY, f64::INFINITY],
    };

    /// Bounds segments along the longest of them.
    pub fn of(segments: &[[Point; 2]]) -> Self {
        let spans = segments.iter().map(|[a, b]| [b.x - a.x, b.y - a.y]);
        let length = |[x, y]: [f64; 2]| x.abs().max(y.abs());
        let longer = |s, t| if length(t) > length(s) { t } else { s };
        let normal = normal_to(spans.fold([0.0; 2], longer));
        let range = range(normal, segments);
        Self { normal, range }
    }

    /// Tells whether some point of the segments, or one that a point of them rounds to, may lie in here.
    pub fn may_hold(&self, segments: &[[Point; 2]]) -> bool {
        let [least, largest] = range(self.normal, segments);
        least <= self.range[1] && self.range[0] <= largest
    }

    /// About the largest ordinate in here over an abscissa.
    pub fn top(&self, x: f64) -> f64 {
        let [u, v] = self.normal;
        let [y, z] = self.range.map(|r| (r - u * x) / v);
        // NaN if the strip is vertical; the maximum drops it.
        y.max(z).max(f64::MIN)
    }
}

/// Something normal to a direction; exactness does not matter.
fn normal_to([x, y]: [f64; 2]) -> [f64; 2] {
    let (flat, steep) = (y / x, x / y);
    if flat.abs() <= 1.0 {
        [-flat, 1.0]
    } else if steep.abs() <= 1.0 {
        [1.0, -steep]
    } else {
        // No direction, or too long a segment.
        [0.0, 1.0]
    }
}

/// Bounds `normal` · p for all points of segments, and those that they round to.
///
/// With u = 2⁻⁵³, the product and the sum err by up to u (|x| + |y|) each, and rounding p moves it by
/// u |x| and u |y|, besides half of the least number each: 3 u (|x| + |y|), to first order. The margin
/// is more than twice that.
fn range([u, v]: [f64; 2], segments: &[[Point; 2]]) -> [f64; 2] {
    const SHARE: f64 = 4.0 * f64::EPSILON;
    let lesser = |a: f64, b: f64| if b < a { b } else { a };
    let larger = |a: f64, b: f64| if b > a { b } else { a };
    let (mut least, mut largest) = (f64::INFINITY, f64::NEG_INFINITY);
    let mut size = [0.0_f64; 2];
    for p in segments.as_flattened() {
        let at = u * p.x + v * p.y;
        least = lesser(least, at);
        largest = larger(largest, at);
        size = [larger(size[0], p.x.abs()), larger(size[1], p.y.abs())];
    }
    let margin = SHARE * size[0] + SHARE * size[1] + f64::MIN_POSITIVE;
    [least - margin, largest + margin]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn segment(ends: [(f64, f64); 2]) -> [Point; 2] {
        ends.map(Point::from)
    }

    #[test]
    fn segments_side_by_side_are_told_apart() {
        for slope in [0.0, 1.0, 0.4142, 2.5, -0.3, -70.0, f64::INFINITY] {
            let (x, y) = if slope == f64::INFINITY {
                (0.0, 1.0)
            } else {
                (1.0, slope)
            };
            // Across the slope.
            let [u, v] = normal_to([x, y]);
            for far in [0.0, 5e5] {
                let along = |d: f64| {
                    let start = (far + d * u, far + d * v);
                    [segment([start, (start.0 + x, start.1 + y)])]
                };
                let slab = Slab::of(&along(0.0));
                assert!(slab.may_hold(&along(0.0)), "{slope}");
                assert!(!slab.may_hold(&along(1e-8)), "{slope}");
                assert!(!slab.may_hold(&along(-1e-8)), "{slope}");
            }
        }
    }

    #[test]
    fn whatever_has_a_point_in_common_is_not_told_apart() {
        let ladder = [-f64::MAX, -1.0, -5e-324, 0.0, 5e-324, 0.1, f64::MAX];
        let points = ladder.map(|x| ladder.map(|y| (x, y)));
        let points = points.as_flattened();
        for &shared in points {
            for &p in points {
                let slab = Slab::of(&[segment([shared, p])]);
                for &q in points {
                    let other = [segment([q, shared])];
                    assert!(slab.may_hold(&other), "{shared:?} {p:?} {q:?}");
                }
            }
        }
    }

    #[test]
    fn the_top_is_that_of_the_strip() {
        let slab = Slab::of(&[segment([(0.0, 1.0), (4.0, 3.0)])]);
        assert!((slab.top(2.0) - 2.0).abs() < 1e-9);
        let steep = Slab::of(&[segment([(0.0, 0.0), (1.0, 4.0)])]);
        assert!((steep.top(0.5) - 2.0).abs() < 1e-9);
        let upright = Slab::of(&[segment([(1.0, 0.0), (1.0, 4.0)])]);
        assert!(upright.top(1.0) >= 4.0);
    }
}
