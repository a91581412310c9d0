//! In which sub-triangles data lie, about a point with double-precision coordinates.

use super::super::share::{Parts, can_share};
use crate::Point;
use crate::predicates::Orientation::{self, Collinear, Left, Right};
use crate::predicates::orient2d;

/// A triangle to be divided, and what is wanted.
pub(super) struct Division<'d> {
    /// The corners, counter-clockwise.
    pub corners: [Point; 3],
    /// What lies in the triangle.
    pub data: &'d [Point],
    /// How many data each part is to have.
    pub least: usize,
}

impl<'d> Division<'d> {
    pub fn new(corners: [Point; 3], data: &'d [Point], least: usize) -> Self {
        Self {
            corners,
            data,
            least,
        }
    }

    /// Tells whether a point is strictly inside, and divides the triangle as wanted.
    pub fn is_good(&self, at: Point) -> bool {
        self.is_inside(at) && can_share(self.options(at), 3, self.least)
    }

    fn is_inside(&self, at: Point) -> bool {
        let is_left = |k: usize| orient2d(self.corners[k], self.corners[(k + 1) % 3], at) == Left;
        at.is_finite() && (0..3).all(is_left)
    }

    /// Counts the data in each closed part.
    pub fn counts(&self, at: Point) -> [usize; 3] {
        let mut counts = [0; 3];
        for options in self.options(at) {
            for (k, count) in counts.iter_mut().enumerate() {
                *count += usize::from(options >> k & 1);
            }
        }
        counts
    }

    /// Returns the parts in which each datum may be if the triangle is divided at a point strictly inside.
    pub fn options(&self, at: Point) -> impl Iterator<Item = Parts> {
        let side = move |k: usize, p: Point| orient2d(at, self.corners[k], p);
        self.data.iter().map(move |&p| options(|k| side(k, p)))
    }
}

/// Returns the parts in which a datum lies that is on some side of the way from the point to each corner.
///
/// Less than two right angles are between one corner and the next as seen from the point: so two sides say it all.
fn options(side: impl Fn(usize) -> Orientation) -> Parts {
    match side(0) {
        Left => match side(1) {
            Right => 0b100,
            Collinear => 0b101,
            Left => 0b001,
        },
        Right => match side(2) {
            Left => 0b010,
            Collinear => 0b011,
            Right => 0b001,
        },
        // On the edge to corner 0, at the point, or beyond it.
        Collinear => match side(1) {
            Right => 0b110,
            Collinear => 0b111,
            Left => 0b001,
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_datum_is_where_it_lies() {
        let corners = [(-3.0, -2.0), (3.0, -2.0), (0.0, 4.0)].map(Point::from);
        let at = Point::new(0.0, 0.0);
        // By definition: not right of the way to the next corner, not left of that to the one after.
        let is_in = |k: usize, p: Point| {
            orient2d(at, corners[(k + 1) % 3], p) != Right
                && orient2d(at, corners[(k + 2) % 3], p) != Left
        };
        let lattice = (0..49)
            .map(|i| (i % 7 - 3, i / 7 - 2))
            .map(|(x, y)| (f64::from(x), f64::from(y)));
        let data: Vec<Point> = lattice.map(Point::from).collect();
        let division = Division::new(corners, &data, 1);
        let mut seen = [0; 8];
        for (&p, found) in data.iter().zip(division.options(at)) {
            let expected: u8 = (0..3).map(|k| u8::from(is_in(k, p)) << k).sum();
            assert_eq!(found, expected, "{p:?}");
            seen[usize::from(found)] += 1;
        }
        assert!(seen[1..].iter().all(|&n| n > 0), "{seen:?}");
    }
}
