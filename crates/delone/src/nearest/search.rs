//! The searches: downhill to the nearest, outwards to the k nearest, and over a disc.

use super::few::FEW;
use super::graph::Graph;
use super::seen::Seen;
use crate::predicates::{CircleSide, compare_squared, in_disc, squared_length};
use crate::{Point, VertexId};
use std::cmp::{Ordering, Reverse};
use std::collections::BinaryHeap;

/// What searches leave behind: room for the next.
#[derive(Debug, Default)]
pub(super) struct Scratch {
    seen: Seen,
    stack: Vec<u32>,
    waiting: BinaryHeap<Reverse<Reached>>,
}

/// A vertex and its distance from the point of the search.
#[derive(Clone, Copy, Debug)]
struct Reached {
    vertex: u32,
    name: VertexId,
    point: Point,
    /// The square of the distance, rounded.
    square: f64,
    from: Point,
}

impl Reached {
    fn new(graph: &Graph, from: Point, vertex: u32) -> Self {
        let point = graph.points[vertex as usize];
        Self {
            vertex,
            name: graph.names[vertex as usize],
            point,
            square: squared_length([from, point]),
            from,
        }
    }

    /// Compares distances exactly.
    #[inline]
    fn by_distance(&self, other: &Self) -> Ordering {
        let points = [self.point, other.point];
        compare_squared(self.from, points, [self.square, other.square])
    }
}

/// By distance, then by name.
impl Ord for Reached {
    fn cmp(&self, other: &Self) -> Ordering {
        self.by_distance(other).then(self.name.cmp(&other.name))
    }
}

impl PartialOrd for Reached {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Reached {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Reached {}

impl Graph {
    /// Returns the vertex nearest to `p`, of several the one of lowest name, going downhill from `start`.
    pub fn nearest(&self, p: Point, start: u32, scratch: &mut Scratch) -> u32 {
        let (mut best, mut square) = (start, squared_length([p, self.points[start as usize]]));
        loop {
            let (before, mut has_equal) = (best, false);
            for &w in self.neighbors(before) {
                let points = [w, best].map(|v| self.points[v as usize]);
                let of_w = squared_length([p, points[0]]);
                match compare_squared(p, points, [of_w, square]) {
                    Ordering::Less => (best, square) = (w, of_w),
                    Ordering::Equal => has_equal = true,
                    Ordering::Greater => {}
                }
            }
            if best == before {
                return if has_equal {
                    self.first_of_equals(p, best, scratch)
                } else {
                    best
                };
            }
        }
    }

    /// Tells whether it is a few vertices only from `v` to `p`, as far as the length of an edge tells.
    pub fn is_close(&self, v: u32, p: Point) -> bool {
        let point = self.points[v as usize];
        self.neighbors(v).first().is_some_and(|&w| {
            let edge = squared_length([point, self.points[w as usize]]);
            squared_length([point, p]) <= 16.0 * edge
        })
    }

    /// Returns the vertex of lowest name among those as near to `p` as `nearest`, than which none is nearer.
    #[cold]
    fn first_of_equals(&self, p: Point, nearest: u32, scratch: &mut Scratch) -> u32 {
        let nearest = Reached::new(self, p, nearest);
        let mut first = nearest;
        self.flood(nearest.vertex, scratch, |v| {
            let reached = Reached::new(self, p, v);
            let is_equal = reached.by_distance(&nearest).is_eq();
            if is_equal && reached.name < first.name {
                first = reached;
            }
            is_equal
        });
        first.vertex
    }

    /// Visits `start` and all that are connected with it through vertices that `enter` accepts.
    fn flood(&self, start: u32, scratch: &mut Scratch, mut enter: impl FnMut(u32) -> bool) {
        let Scratch { seen, stack, .. } = scratch;
        seen.clear();
        seen.insert(start);
        stack.clear();
        if enter(start) {
            stack.push(start);
        }
        while let Some(v) = stack.pop() {
            for &w in self.neighbors(v) {
                if seen.insert(w) && enter(w) {
                    stack.push(w);
                }
            }
        }
    }

    /// Lists the `k` vertices nearest to `p` by distance, then by name, given the first of them.
    pub fn k_nearest(
        &self,
        p: Point,
        nearest: u32,
        k: usize,
        scratch: &mut Scratch,
    ) -> Vec<VertexId> {
        let are_few = (1..=FEW).contains(&k) && k < self.names.len();
        let few = are_few.then(|| self.few_nearest(p, nearest, k)).flatten();
        few.unwrap_or_else(|| self.many_nearest(p, nearest, k, scratch))
    }

    /// As [`k_nearest`](Self::k_nearest), for any `k` and ties.
    ///
    /// Those next to what is listed wait in a heap. Equally near ones are listed together, when all of them
    /// have been found: one may lead to the next only through a third.
    fn many_nearest(
        &self,
        p: Point,
        nearest: u32,
        k: usize,
        scratch: &mut Scratch,
    ) -> Vec<VertexId> {
        let Scratch { seen, waiting, .. } = scratch;
        seen.clear();
        seen.insert(nearest);
        waiting.clear();
        waiting.push(Reverse(Reached::new(self, p, nearest)));
        let mut listed = Vec::with_capacity(k.min(self.names.len()));
        let mut last: Option<Reached> = None;
        // Where in the list those begin that are as near as the last.
        let mut equals = 0;
        while let Some(Reverse(next)) = waiting.pop() {
            if last.is_some_and(|last| last.by_distance(&next).is_lt()) {
                listed[equals..].sort_unstable();
                equals = listed.len();
                if equals >= k {
                    break;
                }
            }
            listed.push(next.name);
            last = Some(next);
            for &w in self.neighbors(next.vertex) {
                if seen.insert(w) {
                    waiting.push(Reverse(Reached::new(self, p, w)));
                }
            }
        }
        listed[equals..].sort_unstable();
        listed.truncate(k);
        listed
    }

    /// Lists the vertices no farther from `p` than `radius`, by name, given a nearest one.
    pub fn within(
        &self,
        p: Point,
        nearest: u32,
        radius: f64,
        scratch: &mut Scratch,
    ) -> Vec<VertexId> {
        let mut listed = Vec::new();
        self.flood(nearest, scratch, |v| {
            let is_within = in_disc(p, radius, self.points[v as usize]) != CircleSide::Outside;
            if is_within {
                listed.push(self.names[v as usize]);
            }
            is_within
        });
        listed.sort_unstable();
        listed
    }
}
