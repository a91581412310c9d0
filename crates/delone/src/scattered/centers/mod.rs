//! Centers of clusters, one more at a time (3.30).
//!
//! The center that has most data (of several the first) falls in two: its data are cut at the midpoint of the
//! longer side of their box, and the means of both halves take its place. Then all data go to the nearest center,
//! of several the first. Centers do not move: that is what distinguishes it from Schreiber's algorithm (3.23).
//!
//! Only data near the new centers [change](sharing); a Delaunay triangulation of the centers tells which.
//!
//! *Cost*: in practice, for a split, a few comparisons of distances for each of the data of the center and of its
//! neighbours.
//!
//! *Source*: diploma thesis, Duisburg, about 1998, algorithm 3.30.

mod sharing;
mod sites;

use super::extent::Extent;
use crate::predicates::compare_lengths;
use crate::{Cut, Point};
use sites::Sites;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Centers of clusters of data.
#[derive(Clone, Debug)]
pub(super) struct Centers<'d> {
    data: &'d [Point],
    positions: Vec<Point>,
    sites: Sites,
    /// Centers by how many data they have; what has changed since is passed over.
    queue: BinaryHeap<(usize, Reverse<usize>)>,
}

/// A center that has fallen in two.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Split {
    /// The numbers of the center of the lower half, which is that of the old one, and of the upper half, which
    /// is new.
    pub centers: [usize; 2],
    /// Where the old one was.
    pub before: Point,
    /// Where the new ones are.
    pub after: [Point; 2],
    /// Where its data were cut.
    pub cut: Cut,
    /// How many it had.
    pub data: usize,
}

impl<'d> Centers<'d> {
    /// Begins with the mean of finite data, of which there are fewer than 2³²; with no center if there are none.
    /// Data that are equal count as often as they are there.
    pub fn new(data: &'d [Point]) -> Self {
        let mut centers = Self {
            data,
            positions: Vec::new(),
            sites: Sites::default(),
            queue: BinaryHeap::new(),
        };
        if let Some(extent) = Extent::of(data.iter().copied()) {
            let site = centers.put(0, extent.mean(data.iter().copied()));
            centers.sites.data_of(site).extend(0..data.len() as u32);
            centers.enqueue(site);
        }
        centers
    }

    /// Returns where the centers are.
    pub fn positions(&self) -> &[Point] {
        &self.positions
    }

    /// Counts the data of each center. *Cost*: linear in their number.
    #[cfg(test)]
    pub fn counts(&self) -> Vec<usize> {
        let count = |center| self.data_of(center).len();
        (0..self.positions.len()).map(count).collect()
    }

    /// Returns the data of a center, in no particular order.
    pub fn data_of(&self, center: usize) -> &[u32] {
        self.sites.data_of_center(center)
    }

    /// Replaces the center with most data, of those that have different ones, by two; `None` if no center has.
    pub fn split(&mut self) -> Option<Split> {
        let (center, cut) = self.fullest()?;
        let site = self.sites.of_center(center);
        let data = std::mem::take(self.sites.data_of(site));
        self.sites.leave(center);
        let count = data.len();
        let halves = self.cut_in_two(data, cut);
        let after = [0, 1].map(|k| self.mean(&halves[k]));
        let centers = [center, self.positions.len()];
        let before = self.positions[center];
        let new = [0, 1].map(|k| self.put(centers[k], after[k]));
        for site in sharing::share(&mut self.sites, self.data, new, halves) {
            self.enqueue(site);
        }
        Some(Split {
            centers,
            before,
            after,
            cut,
            data: count,
        })
    }

    /// Takes the center with most data that can be cut from the queue, and tells where.
    fn fullest(&mut self) -> Option<(usize, Cut)> {
        loop {
            let (count, Reverse(center)) = self.queue.pop()?;
            let data = self.data_of(center);
            if data.len() != count {
                continue;
            }
            let places = data.iter().map(|&i| self.data[i as usize]);
            if let Some(cut) = Extent::of(places).and_then(middle) {
                return Some((center, cut));
            }
        }
    }

    /// Puts the center of this number somewhere.
    fn put(&mut self, center: usize, at: Point) -> sites::Site {
        self.positions
            .resize(self.positions.len().max(center + 1), at);
        self.positions[center] = at;
        self.sites.enter(center, at)
    }

    /// Notes how many data a site has now.
    fn enqueue(&mut self, site: sites::Site) {
        let count = self.sites.data_of(site).len();
        if count > 0 {
            self.queue.push((count, Reverse(self.sites.rank(site))));
        }
    }

    fn cut_in_two(&self, data: Vec<u32>, cut: Cut) -> [Vec<u32>; 2] {
        let is_lower = |&i: &u32| {
            let p = self.data[i as usize];
            match cut {
                Cut::Vertical(x) => p.x <= x,
                Cut::Horizontal(y) => p.y <= y,
            }
        };
        let (lower, upper) = data.into_iter().partition(is_lower);
        [lower, upper]
    }

    fn mean(&self, data: &[u32]) -> Point {
        let places = || data.iter().map(|&i| self.data[i as usize]);
        let extent = Extent::of(places()).expect("bug: a cut leaves data on both sides");
        extent.mean(places())
    }
}

/// Cuts a box at the midpoint of its longer side, so that its ends are on different sides; `None` if it has no
/// length.
fn middle(Extent { low, high }: Extent) -> Option<Cut> {
    let corner = Point::new(high.x, low.y);
    let is_wide = compare_lengths([low, corner], [corner, high]).is_ge();
    let halve = |low: f64, high: f64| {
        let middle = f64::midpoint(low, high);
        // Of neighbouring numbers it may be the larger one.
        if middle < high { middle } else { low }
    };
    match is_wide {
        true if low.x < high.x => Some(Cut::Vertical(halve(low.x, high.x))),
        false if low.y < high.y => Some(Cut::Horizontal(halve(low.y, high.y))),
        _ => None,
    }
}

#[cfg(test)]
mod tests;
