//! How far from a segment the vertices of its chain may lie.
//!
//! Where segments cross, the point is rounded, and a piece that has been bent may be cut again: a few
//! rounds of at most half a unit in the last place each. A vertex is *near* a segment if it lies in the
//! segment's bounding box, which rounding never leaves, and the box of [`CROSSING_DRIFT`] units around the vertex
//! meets the segment, the unit of an axis being that of the segment's largest coordinate. The box is
//! rounded; whether it meets the segment is decided exactly.
//!
//! # Steiner points
//! Refinement splits subsegments again and again. Each point is rounded once, to within half a unit of the
//! subsegment that it splits, and may have been moved to a neighbouring `f64` on each axis where the
//! triangles around it demanded that: 1½ units. The drift of a point t of the way from an end with drift d
//! to one with drift e is (1 − t) d + t e + 1½ at most, and of the two ends one is two levels older. t lies
//! between a quarter and three quarters, so a level adds no more than 1½ / 1.25 = 1.2 units, and a
//! subsegment 2ᵏ times shorter than its segment is the work of k / log₂ (4/3) = 2.41 k levels at
//! most: less than [`STEINER_DRIFT`] units for each k. The step to a vertex is no longer than the piece
//! that the vertex once cut off, so its length tells.
//!
//! Only beside a vertex that leaves no room between, nearer than 2¹⁰ units, a subsegment is split at any t.
//! Such a split may add 1½ units and halve nothing. It is not proven that a segment has few of them one
//! upon the other: [`CROSSING_DRIFT`] leaves room for five, beside what noding takes, and the errors of rounding would
//! have to be of one sign. A chain that drifts farther is reported as a defect, never let pass.
//!
//! A segment that is nearly parallel to an axis may be left by such a move across it, out of the
//! bounding box and back. Therefore steps of refined chains have to go on along the longer side of the
//! box only.

use crate::Point;
use crate::predicates::{Orientation, orient2d};
use std::cmp::Ordering;

/// Units in the last place by which a vertex may lie off its segment, along each axis, the unit being that of the
/// segment's largest coordinate there: sixteen rounds, twice as many as have ever been seen.
pub const CROSSING_DRIFT: f64 = 8.0;

/// Further units that a Steiner point may lie off, each time the segment has been halved.
pub const STEINER_DRIFT: f64 = 3.0;

/// Most halvings that count: there are no more between neighbouring `f64` of one size.
const MOST_HALVINGS: f64 = 64.0;

/// A segment, and what is near it.
pub(super) struct Corridor {
    from: Point,
    to: Point,
    /// The unit in the last place on each axis.
    unit: [f64; 2],
    /// Whether Steiner points may lie on the chain.
    is_refined: bool,
}

impl Corridor {
    pub fn new(from: Point, to: Point, is_refined: bool) -> Self {
        let axes = [(from.x, to.x), (from.y, to.y)];
        Self {
            from,
            to,
            unit: axes.map(|(a, b)| unit(a.abs().max(b.abs()))),
            is_refined,
        }
    }

    /// Tells whether `p` lies on the line of the segment.
    pub fn is_on_line(&self, p: Point) -> bool {
        orient2d(self.from, self.to, p) == Orientation::Collinear
    }

    /// Tells whether going from `p` to `q` goes on along the segment, and no further than its end.
    ///
    /// No axis may turn back, so a chain that goes on never returns; from a point of the bounding box
    /// the way stays in it. For refined chains it is enough that the longer axis goes on.
    pub fn goes_on(&self, p: Point, q: Point) -> bool {
        self.goes_on_along_both(p, q) || self.is_refined && self.goes_on_along_longer(p, q)
    }

    /// Tells which of two points the way from the first end to the second comes to first, if all steps
    /// [go on](Self::goes_on).
    pub fn compare_ways(&self, p: Point, q: Point) -> Ordering {
        let [dx, dy] = extents(self.from, self.to);
        // Both zeros are one.
        let compare = |p: f64, q: f64| (p + 0.0).total_cmp(&(q + 0.0));
        let along = |from: f64, to: f64, p: f64, q: f64| match from <= to {
            true => compare(p, q),
            false => compare(q, p),
        };
        let x = || along(self.from.x, self.to.x, p.x, q.x);
        let y = || along(self.from.y, self.to.y, p.y, q.y);
        match dx >= dy {
            true => x().then_with(y),
            false => y().then_with(x),
        }
    }

    fn goes_on_along_both(&self, p: Point, q: Point) -> bool {
        let axes = [
            (self.from.x, p.x, q.x, self.to.x),
            (self.from.y, p.y, q.y, self.to.y),
        ];
        axes.iter().all(|&(from, p, q, to)| {
            if from <= to {
                p <= q && q <= to
            } else {
                p >= q && q >= to
            }
        })
    }

    fn goes_on_along_longer(&self, p: Point, q: Point) -> bool {
        let [dx, dy] = extents(self.from, self.to);
        let [from, p, q, to] = [self.from, p, q, self.to].map(|p| if dx >= dy { p.x } else { p.y });
        if from < to {
            p < q && q <= to
        } else {
            p > q && q >= to
        }
    }

    /// Tells whether the segment is near `q`, where a step from `p` that goes on has led.
    pub fn is_near(&self, p: Point, q: Point) -> bool {
        self.is_on_line(q) || self.meets_box_around(q, self.drift(p, q))
    }

    /// Returns how far off the segment `q` may lie on each axis, at the end of a step from `p`.
    fn drift(&self, p: Point, q: Point) -> [f64; 2] {
        let mut ulps = CROSSING_DRIFT;
        if self.is_refined {
            let [whole, step] = [[self.from, self.to], [p, q]]
                .map(|[a, b]| extents(a, b).into_iter().fold(0.0, f64::max));
            ulps += STEINER_DRIFT * halvings(whole, step);
        }
        self.unit.map(|unit| ulps * unit)
    }

    /// Tells whether the line separates no two corners of the box around `p`; axes need no test, since
    /// `p` lies between the ends on the longer one, and only rounding leads out of the bounding box on
    /// the other.
    fn meets_box_around(&self, p: Point, [dx, dy]: [f64; 2]) -> bool {
        let corners = [(-dx, -dy), (dx, -dy), (dx, dy), (-dx, dy)];
        let side = |(x, y)| {
            let corner = [p.x + x, p.y + y].map(|c: f64| c.clamp(-f64::MAX, f64::MAX));
            orient2d(self.from, self.to, corner.into())
        };
        let first = side(corners[0]);
        first == Orientation::Collinear || corners[1..].iter().any(|&c| side(c) != first)
    }
}

/// The sides of the bounding box.
fn extents(a: Point, b: Point) -> [f64; 2] {
    [b.x - a.x, b.y - a.y].map(f64::abs)
}

/// How often `whole` is halved before it is no longer than `step`, up to a limit.
fn halvings(whole: f64, step: f64) -> f64 {
    let mut halvings = 0.0;
    let mut rest = whole.min(f64::MAX);
    while rest > step && halvings < MOST_HALVINGS {
        rest *= 0.5;
        halvings += 1.0;
    }
    halvings
}

/// The unit in the last place of a number that is not negative.
pub(super) fn unit(magnitude: f64) -> f64 {
    if magnitude == f64::MAX {
        magnitude - magnitude.next_down()
    } else {
        magnitude.next_up() - magnitude
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn near_is_within_eight_units_of_the_largest_coordinate() {
        let from = Point::new(0.0, 1.0);
        let corridor = Corridor::new(from, Point::new(4.0, 1.0), false);
        let at = |ulps: f64| Point::new(2.0, 1.0 + ulps * f64::EPSILON);
        let is_near = |ulps| corridor.is_near(from, at(ulps));
        assert!(is_near(0.0) && corridor.is_on_line(at(0.0)));
        assert!(is_near(8.0) && !corridor.is_on_line(at(8.0)));
        assert!(is_near(-8.0) && !is_near(9.0) && !is_near(-9.0));
    }

    #[test]
    fn steiner_points_may_lie_three_units_farther_off_for_each_halving() {
        let [from, to] = [0.0, 4.0].map(|x| Point::new(x, 1.0));
        let corridor = Corridor::new(from, to, true);
        let is_near = |x: f64, step: f64, ulps: f64| {
            let y = 1.0 + ulps * f64::EPSILON;
            corridor.is_near(Point::new(x - step, y), Point::new(x, y))
        };
        assert!(is_near(2.0, 2.0, 11.0) && !is_near(2.0, 2.0, 12.0));
        assert!(is_near(2.0, 0.125, -23.0) && !is_near(2.0, 0.125, -24.0));
        assert!(!is_near(2.0, 0.0, 210.0));
    }

    #[test]
    fn refined_chains_go_on_along_the_longer_axis() {
        let [from, to] = [0.0, 4.0].map(|y| Point::new(0.3, y));
        let beside = Point::new(0.3_f64.next_up(), 2.0);
        let steps = [(from, beside), (beside, to)];
        let goes_on = |is_refined| {
            let corridor = Corridor::new(from, to, is_refined);
            steps.map(|(p, q)| corridor.goes_on(p, q) && corridor.is_near(p, q))
        };
        assert_eq!(goes_on(true), [true, true]);
        assert_eq!(goes_on(false), [false, false]);
        let corridor = Corridor::new(from, to, true);
        assert!(!corridor.goes_on(beside, from) && !corridor.goes_on(to, beside));
        assert!(!corridor.goes_on(beside, Point::new(0.3, 4.5)));
    }

    #[test]
    fn the_ends_of_the_range_do_not_overflow() {
        let [low, high] = [-f64::MAX, f64::MAX].map(|c| Point::new(c, c));
        for is_refined in [false, true] {
            let corridor = Corridor::new(low, high, is_refined);
            assert!(corridor.is_near(low, Point::new(high.x, high.y.next_down())));
            assert!(!corridor.is_near(low, Point::new(0.0, 1e300)));
            let zero = Point::new(0.0, 0.0);
            let tiny = Corridor::new(zero, Point::new(5e-324, 0.0), is_refined);
            assert!(tiny.is_near(zero, zero));
        }
    }

    #[test]
    fn chains_go_on_without_turning_back() {
        let corridor = Corridor::new(Point::new(0.0, 5.0), Point::new(4.0, 1.0), false);
        let [p, q] = [Point::new(1.0, 4.0), Point::new(1.0, 3.0)];
        assert!(corridor.goes_on(p, q));
        assert!(!corridor.goes_on(q, p));
        assert!(!corridor.goes_on(q, Point::new(3.0, 0.0)));
    }
}
