//! The edges of the outer polygon that may shrink to a point, the shortest first.
//!
//! May shrink: the lines of the neighbours meet beyond the edge, that is, its interior angles sum to more than π
//! (remark 3.32.2). In the order of a heap; entries of edges that have changed since are passed over.

use super::Ring;
use crate::Point;
use crate::predicates::{Orientation, compare_lengths, turning};
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// Edges by their length; each is named by the corner where it begins.
#[derive(Clone, Debug)]
pub(super) struct Edges {
    heap: BinaryHeap<Edge>,
    /// How often the edge that begins in a corner has changed.
    versions: Vec<u32>,
}

impl Edges {
    pub fn new(ring: &Ring) -> Self {
        let mut edges = Self {
            heap: BinaryHeap::new(),
            versions: vec![0; ring.places.len()],
        };
        (0..ring.places.len()).for_each(|i| edges.renew(ring, i));
        edges
    }

    /// Looks anew at the edge that begins in a corner, because it has changed, or an edge beside it has.
    pub fn renew(&mut self, ring: &Ring, from: usize) {
        self.versions[from] += 1;
        let [p, a, b, q] = ring.around(from).map(|i| ring.at(i));
        if turning([p, a], [b, q]) == Orientation::Left {
            self.heap.push(Edge {
                ends: [a, b],
                from,
                version: self.versions[from],
            });
        }
    }

    /// Forgets the edge that began in a corner.
    pub fn forget(&mut self, from: usize) {
        self.versions[from] += 1;
    }

    /// Takes the shortest edge that may shrink, of several that of lowest number.
    pub fn pop(&mut self) -> Option<usize> {
        loop {
            let edge = self.heap.pop()?;
            if self.versions[edge.from] == edge.version {
                return Some(edge.from);
            }
        }
    }
}

/// An edge as it was.
#[derive(Clone, Copy, Debug)]
struct Edge {
    ends: [Point; 2],
    from: usize,
    version: u32,
}

impl Ord for Edge {
    /// The shortest edge is the greatest.
    fn cmp(&self, other: &Self) -> Ordering {
        let order = compare_lengths(other.ends, self.ends);
        order.then_with(|| (other.from, other.version).cmp(&(self.from, self.version)))
    }
}

impl PartialOrd for Edge {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Edge {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Edge {}
