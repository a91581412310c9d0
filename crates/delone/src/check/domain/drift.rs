//! How far from a segment the vertices of its chain may lie.
//!
//! Where segments cross, the point is rounded, and a piece that has been bent may be cut again: a few
//! rounds of at most half a unit in the last place each. A vertex is *near* a segment if it lies in the
//! segment's bounding box, which rounding never leaves, and the box of [`ULPS`] units around the vertex
//! meets the segment, the unit of an axis being that of the segment's largest coordinate. The box is
//! rounded; whether it meets the segment is decided exactly.

use crate::Point;
use crate::predicates::{Orientation, orient2d};

/// Units in the last place by which a vertex may lie off its segment, along each axis: sixteen rounds,
/// twice as many as have ever been seen.
const ULPS: f64 = 8.0;

/// A segment, and what is near it.
pub(super) struct Corridor {
    from: Point,
    to: Point,
    drift: [f64; 2],
}

impl Corridor {
    pub fn new(from: Point, to: Point) -> Self {
        let drift = [(from.x, to.x), (from.y, to.y)];
        Self {
            from,
            to,
            drift: drift.map(|(a, b)| ULPS * unit(a.abs().max(b.abs()))),
        }
    }

    /// Tells whether `p` lies on the line of the segment.
    pub fn is_on_line(&self, p: Point) -> bool {
        orient2d(self.from, self.to, p) == Orientation::Collinear
    }

    /// Tells whether going from `p` to `q` goes on along the segment, and no further than its end.
    ///
    /// No axis may turn back, so a chain that goes on never returns; from a point of the bounding box
    /// the way stays in it.
    pub fn goes_on(&self, p: Point, q: Point) -> bool {
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

    /// Tells whether a point of the bounding box is near the segment.
    pub fn is_near(&self, p: Point) -> bool {
        self.is_on_line(p) || self.meets_box_around(p)
    }

    /// Tells whether the line separates no two corners of the box; axes need no test, since `p` lies
    /// in the bounding box.
    fn meets_box_around(&self, p: Point) -> bool {
        let [dx, dy] = self.drift;
        let corners = [(-dx, -dy), (dx, -dy), (dx, dy), (-dx, dy)];
        let side = |(x, y)| {
            let corner = [p.x + x, p.y + y].map(|c: f64| c.clamp(-f64::MAX, f64::MAX));
            orient2d(self.from, self.to, corner.into())
        };
        let first = side(corners[0]);
        first == Orientation::Collinear || corners[1..].iter().any(|&c| side(c) != first)
    }
}

/// The unit in the last place of a number that is not negative.
fn unit(magnitude: f64) -> f64 {
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
        let corridor = Corridor::new(Point::new(0.0, 1.0), Point::new(4.0, 1.0));
        let at = |ulps: f64| Point::new(2.0, 1.0 + ulps * f64::EPSILON);
        assert!(corridor.is_near(at(0.0)) && corridor.is_on_line(at(0.0)));
        assert!(corridor.is_near(at(8.0)) && !corridor.is_on_line(at(8.0)));
        assert!(corridor.is_near(at(-8.0)));
        assert!(!corridor.is_near(at(9.0)) && !corridor.is_near(at(-9.0)));
    }

    #[test]
    fn the_ends_of_the_range_do_not_overflow() {
        let [low, high] = [-f64::MAX, f64::MAX].map(|c| Point::new(c, c));
        let corridor = Corridor::new(low, high);
        assert!(corridor.is_near(Point::new(high.x, high.y.next_down())));
        assert!(!corridor.is_near(Point::new(0.0, 1e300)));
        let tiny = Corridor::new(Point::new(0.0, 0.0), Point::new(5e-324, 0.0));
        assert!(tiny.is_near(Point::new(0.0, 0.0)));
    }

    #[test]
    fn chains_go_on_without_turning_back() {
        let corridor = Corridor::new(Point::new(0.0, 5.0), Point::new(4.0, 1.0));
        let [p, q] = [Point::new(1.0, 4.0), Point::new(1.0, 3.0)];
        assert!(corridor.goes_on(p, q));
        assert!(!corridor.goes_on(q, p));
        assert!(!corridor.goes_on(q, Point::new(3.0, 0.0)));
    }
}
