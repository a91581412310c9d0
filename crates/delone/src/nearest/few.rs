//! The few nearest vertices, found in floating point wherever that is certain.
//!
//! A short sorted list of what has been reached, visited in its order; whatever is farther than its last is
//! dropped. That takes no heap, and no marks either: a vertex that is reached again has the same rounded
//! distance, hence the same place.
//!
//! *Exact*: in the end each listed vertex must be certainly nearer than the one after it, and the last than
//! all that were dropped; else the answer is left to exact comparisons. If so, whoever else is no farther
//! than the last is connected with the nearest through such vertices (see the [module](super)), and the
//! first of them that is not listed is a neighbour of a listed one, hence was dropped, hence is farther.
//!
//! *Cost*: O(k) for each neighbour of `k` vertices, in a few cache lines.

use super::graph::Graph;
use crate::predicates::{compare_squares, squared_length};
use crate::{Point, VertexId};

/// How many are few: a heap is better at more.
pub(super) const FEW: usize = 32;

/// Stands where there is no vertex yet.
const NONE: u32 = u32::MAX;

/// The nearest that have been reached.
struct List {
    /// Squares of distances, rounded, in ascending order; infinite where there is no vertex yet.
    squares: [f64; FEW],
    vertices: [u32; FEW],
    /// The least square that was dropped.
    dropped: f64,
}

impl Graph {
    /// Lists the `k` vertices nearest to `p` by distance, given the nearest. `k` is 1..=[`FEW`], and there
    /// are more vertices. `None` if rounded distances do not tell.
    pub fn few_nearest(&self, p: Point, nearest: u32, k: usize) -> Option<Vec<VertexId>> {
        let square = |v: u32| squared_length([p, self.points[v as usize]]);
        let mut list = List::of(nearest, square(nearest));
        // Nothing is dropped while there is room, so there is a next to visit.
        for visited in 0..k {
            for &w in self.neighbors(list.vertices[visited]) {
                list.reach(w, square(w), visited, k)?;
            }
        }
        let names = list.vertices[..k].iter().map(|&v| self.names[v as usize]);
        list.is_certain(k).then(|| names.collect())
    }
}

impl List {
    fn of(vertex: u32, square: f64) -> Self {
        let mut list = Self {
            squares: [f64::INFINITY; FEW],
            vertices: [NONE; FEW],
            dropped: f64::INFINITY,
        };
        (list.squares[0], list.vertices[0]) = (square, vertex);
        list
    }

    /// Puts a vertex in its place, if it is among the first `k` and not there yet. `None` if it ties, or is
    /// nearer than one that has been visited.
    #[inline(always)]
    fn reach(&mut self, vertex: u32, square: f64, visited: usize, k: usize) -> Option<()> {
        let last = self.squares[k - 1];
        if square > last {
            self.dropped = self.dropped.min(square);
            return Some(());
        }
        // All are looked at: cheaper than to guess wrong where to stop.
        let place = self.squares[..k].iter().filter(|&&s| s < square).count();
        if self.squares[place] == square {
            return (self.vertices[place] == vertex).then_some(());
        }
        if place <= visited {
            return None;
        }
        self.dropped = self.dropped.min(last);
        self.squares.copy_within(place..k - 1, place + 1);
        self.vertices.copy_within(place..k - 1, place + 1);
        (self.squares[place], self.vertices[place]) = (square, vertex);
        Some(())
    }

    /// Tells whether the first `k` are certainly in order, and before all that were dropped.
    fn is_certain(&self, k: usize) -> bool {
        let after = self.squares[1..k].iter().chain([&self.dropped]);
        let mut pairs = self.squares[..k].iter().zip(after);
        pairs.all(|(&near, &far)| compare_squares(near, far).is_some_and(|order| order.is_lt()))
    }
}
