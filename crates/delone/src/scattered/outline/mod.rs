//! The outer polygon of Algorithm A: around all data, with fewer and fewer corners.
//!
//! It is strictly convex and contains all data, at every moment: exactly, with the corners as they are handed out,
//! rounded. It begins as the hull of the data, [blown up](inflating), and is [reduced](reducing) corner by corner;
//! where that is not possible, it becomes a triangle that [encloses](enclosing) the box of the data.
//!
//! *Source*: diploma thesis, Duisburg, about 1998, algorithms 3.27 and 3.31.

mod domain;
mod edges;
mod enclosing;
mod hull;
mod inflating;
mod reducing;

use super::extent::Extent;
use crate::{Error, Point};
use edges::Edges;
use hull::Hull;
pub(super) use reducing::Reduction;

/// A strictly convex polygon that contains all data.
///
/// Corners are numbered counter-clockwise; a corner keeps its number as long as it is there.
#[derive(Clone, Debug)]
pub(super) struct Outline {
    ring: Ring,
    /// Edges that may shrink.
    edges: Edges,
    /// What it becomes if none does.
    enclosing: [Point; 3],
}

impl Outline {
    /// Lays a polygon around finite data (3.27): the hull, blown up by `factor`, without needless corners. It is the
    /// enclosing triangle if the data lie on one line, or if rounding would leave a datum outside.
    ///
    /// # Errors
    /// [`Error::TooFewData`] if there are none; [`Error::BadChoice`] if the factor is below 1 or not finite, or
    /// if the data are so large that a triangle around them has no finite corners.
    ///
    /// *Cost*: O(n log n).
    pub fn around(data: &[Point], factor: f64) -> Result<Self, Error> {
        let [distinct, least] = [0, 1];
        let extent = Extent::of(data.iter().copied());
        let extent = extent.ok_or(Error::TooFewData { distinct, least })?;
        if !(factor.is_finite() && factor >= 1.0) {
            return Err(Error::BadChoice {
                what: "the factor by which the hull of the data is blown up",
                given: factor,
                must: "it must be finite, and 1 at least",
            });
        }
        let enclosing = enclosing::enclosing(extent)?;
        let polygon = Hull::of(data).and_then(|hull| inflating::inflated(&hull, factor));
        let polygon = polygon.unwrap_or_else(|| enclosing.to_vec());
        Ok(Self::of(polygon, enclosing))
    }

    /// Takes a strictly convex polygon.
    fn of(polygon: Vec<Point>, enclosing: [Point; 3]) -> Self {
        let ring = Ring::new(polygon);
        Self {
            edges: Edges::new(&ring),
            ring,
            enclosing,
        }
    }

    /// Returns the corners of a domain that is given instead: a simple polygon, not necessarily convex, in
    /// either direction. Counter-clockwise, each once; straight corners stay.
    ///
    /// # Errors
    /// [`Error::BadDomain`].
    pub fn of_domain(corners: &[Point]) -> Result<Vec<Point>, Error> {
        domain::corners_of(corners)
    }

    /// Visits the corners, with their numbers, counter-clockwise; the numbers ascend.
    pub fn corners(&self) -> impl Iterator<Item = (usize, Point)> + '_ {
        let ring = &self.ring;
        let all = ring.places.iter().copied().enumerate();
        all.filter(|&(i, _)| ring.is_corner[i])
    }

    /// Returns where the corners are, counter-clockwise.
    pub fn points(&self) -> Vec<Point> {
        self.corners().map(|(_, p)| p).collect()
    }

    /// Counts the corners. *Cost*: constant.
    pub fn num_corners(&self) -> usize {
        self.ring.count
    }

    /// Tells whether there is a corner of this number at this place.
    pub fn has(&self, (number, at): (usize, Point)) -> bool {
        let is_corner = self.ring.is_corner.get(number).copied();
        is_corner == Some(true) && self.ring.at(number) == at
    }

    /// Tells whether it is a triangle: it cannot be reduced any more then.
    pub fn is_triangle(&self) -> bool {
        self.num_corners() == 3
    }
}

/// A polygon as a linked list of corners.
#[derive(Clone, Debug)]
struct Ring {
    places: Vec<Point>,
    next: Vec<usize>,
    previous: Vec<usize>,
    is_corner: Vec<bool>,
    /// How many corners there are.
    count: usize,
}

impl Ring {
    fn new(places: Vec<Point>) -> Self {
        let count = places.len();
        Self {
            places,
            next: (1..count).chain([0]).collect(),
            previous: [count - 1].into_iter().chain(0..count - 1).collect(),
            is_corner: vec![true; count],
            count,
        }
    }

    /// Takes a corner out.
    fn unlink(&mut self, i: usize) {
        let [before, after] = [self.previous[i], self.next[i]];
        self.next[before] = after;
        self.previous[after] = before;
        self.is_corner[i] = false;
        self.count -= 1;
    }

    /// Returns the place of a corner.
    fn at(&self, i: usize) -> Point {
        self.places[i]
    }

    /// Returns the ends of the edge that begins in a corner, with the corners before and behind.
    fn around(&self, i: usize) -> [usize; 4] {
        let j = self.next[i];
        [self.previous[i], i, j, self.next[j]]
    }
}

#[cfg(test)]
mod tests;
