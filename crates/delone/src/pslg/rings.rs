//! Rings, and which lies in which.
//!
//! The leftmost vertex of a ring lies just above the edge of some other ring, or above none. If that
//! ring is below itself, that is if its inside is above the edge, it is the parent; if not, both have
//! the same parent, which is known already when rings are taken from left to right. The edge below is
//! looked for in a box tree, from the top down.
//!
//! *Cost*: in practice O(n log n) for n edges; exact.

use super::boxes::{BoxTree, Stack};
use super::facts::Merged;
use super::meeting::Ends;
use super::search::tree_of;
use super::vertices::Vertices;
use crate::parallel::Workers;
use crate::predicates::{Orientation, orient2d};
use crate::{Point, Watch};

/// A closed chain of segments.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Ring {
    /// The least index of its segments.
    pub segment: usize,
    /// Number of its segments.
    pub len: usize,
    /// The ring directly around it, as an index of the list of rings; `None` also if rings meet.
    pub parent: Option<usize>,
    /// Number of rings around it; 0 also if rings meet.
    pub depth: usize,
}

/// A closed walk: segments, and the vertex where each begins.
pub(super) struct Walk {
    pub segments: Vec<u32>,
    starts: Vec<u32>,
}

/// Collects the rings, by their first segments.
pub(super) fn walk(ends: &[Ends], degrees: &[u32]) -> Vec<Walk> {
    let mut at: Vec<Ends> = vec![[u32::MAX; 2]; degrees.len()];
    for (s, ends) in (0..).zip(ends) {
        for v in ends.map(|v| v as usize) {
            if degrees[v] == 2 {
                let is_second = usize::from(at[v][0] != u32::MAX);
                at[v][is_second] = s;
            }
        }
    }
    let mut is_seen = vec![false; ends.len()];
    let all = 0..ends.len() as u32;
    all.filter_map(|first| walk_from(first, ends, &at, &mut is_seen))
        .collect()
}

/// Walks on from a segment until it comes back to it; `None` if it does not, or was seen before.
fn walk_from(first: u32, ends: &[Ends], at: &[Ends], is_seen: &mut [bool]) -> Option<Walk> {
    let (mut segments, mut starts) = (Vec::new(), Vec::new());
    let [mut s, mut v] = [first, ends[first as usize][0]];
    loop {
        if std::mem::replace(&mut is_seen[s as usize], true) {
            let is_closed = s == first && !segments.is_empty();
            return is_closed.then_some(Walk { segments, starts });
        }
        segments.push(s);
        starts.push(v);
        let [a, b] = ends[s as usize];
        v = if v == a { b } else { a };
        let [p, q] = at[v as usize];
        if p == u32::MAX {
            return None;
        }
        s = if s == p { q } else { p };
    }
}

/// Describes rings, with their nesting if they do not meet; `None` if the watch cancelled.
pub(super) fn describe(
    walks: Vec<Walk>,
    merged: &Merged,
    vertices: &Vertices,
    nest: bool,
    workers: Workers,
    watch: &dyn Watch,
) -> Option<Vec<Ring>> {
    let ring = |walk: &Walk| Ring {
        segment: merged.names[walk.segments[0] as usize] as usize,
        len: walk.segments.len(),
        parent: None,
        depth: 0,
    };
    let mut rings: Vec<Ring> = walks.iter().map(ring).collect();
    if !nest {
        return Some(rings);
    }
    let nesting = Nesting::new(&walks, merged, vertices, workers);
    let mut order: Vec<usize> = (0..walks.len()).collect();
    let leftmost = |i: usize| vertices.at(nesting.leftmost[i]);
    order.sort_unstable_by(|&i, &j| leftmost(i).lex_cmp(&leftmost(j)));
    let mut stack = Stack::default();
    for i in order {
        if watch.is_cancelled() {
            return None;
        }
        if let Some((below, is_inside)) = nesting.below(i, &mut stack) {
            let parent = if is_inside {
                Some(below)
            } else {
                rings[below].parent
            };
            rings[i].parent = parent;
            rings[i].depth = parent.map_or(0, |parent| rings[parent].depth + 1);
        }
    }
    Some(rings)
}

/// Rings that do not meet.
struct Nesting<'a> {
    vertices: &'a Vertices<'a>,
    ends: &'a [Ends],
    tree: BoxTree,
    /// For each segment its ring, and whether the inside of the ring is above it.
    sides: Vec<(u32, bool)>,
    /// For each ring its lexicographically least vertex.
    leftmost: Vec<u32>,
}

impl<'a> Nesting<'a> {
    fn new(walks: &[Walk], merged: &'a Merged, vertices: &'a Vertices, workers: Workers) -> Self {
        let ends = &merged.ends;
        let mut sides = vec![(0, false); ends.len()];
        let mut leftmost = Vec::with_capacity(walks.len());
        for (ring, walk) in (0..).zip(walks) {
            let n = walk.starts.len();
            let least = (0..n).min_by(|&i, &j| {
                let [p, q] = [i, j].map(|i| vertices.at(walk.starts[i]));
                p.lex_cmp(&q)
            });
            let least = least.expect("bug: an empty ring");
            leftmost.push(walk.starts[least]);
            let corner = [least + n - 1, least, least + 1].map(|i| walk.starts[i % n]);
            let [a, b, c] = corner.map(|v| vertices.at(v));
            let is_counter_clockwise = orient2d(a, b, c) == Orientation::Left;
            for (&s, &start) in walk.segments.iter().zip(&walk.starts) {
                let goes_right = ends[s as usize][0] == start;
                sides[s as usize] = (ring, goes_right == is_counter_clockwise);
            }
        }
        let on_rings: Vec<u32> = walks
            .iter()
            .flat_map(|walk| &walk.segments)
            .copied()
            .collect();
        let tree = tree_of(vertices, &on_rings, ends, workers);
        Self {
            vertices,
            ends,
            tree,
            sides,
            leftmost,
        }
    }

    /// Finds the other ring whose edge is directly below ring `ring`'s leftmost vertex, and whether
    /// that vertex lies inside of it.
    fn below(&self, ring: usize, stack: &mut Stack) -> Option<(usize, bool)> {
        let p = self.vertices.at(self.leftmost[ring]);
        let mut highest: Option<Ends> = None;
        let mut found = None;
        self.tree.below(p, stack, |s| {
            let ends = self.ends[s as usize];
            let [a, b] = ends.map(|v| self.vertices.at(v));
            let (owner, is_above) = self.sides[s as usize];
            // Just right of the vertex, so that ends in the same column count once.
            let is_candidate = owner as usize != ring
                && a.x <= p.x
                && p.x < b.x
                && orient2d(a, b, p) == Orientation::Left
                && highest.is_none_or(|other| self.is_higher(ends, other));
            if is_candidate {
                highest = Some(ends);
                found = Some((owner as usize, is_above));
            }
            highest.map_or(f64::NEG_INFINITY, |ends| {
                height_below(ends.map(|v| self.vertices.at(v)), p.x)
            })
        });
        found
    }

    /// Tells which of two segments over the same abscissa is the higher one. They do not cross.
    fn is_higher(&self, s: Ends, t: Ends) -> bool {
        let [[a, b], [c, d]] = [s, t].map(|ends| ends.map(|v| self.vertices.at(v)));
        // Over the end that begins later; if that is a shared one, by direction.
        if c.lex_cmp(&a).is_le() {
            let side = match orient2d(c, d, a) {
                Orientation::Collinear => orient2d(c, d, b),
                side => side,
            };
            side == Orientation::Left
        } else {
            let side = match orient2d(a, b, c) {
                Orientation::Collinear => orient2d(a, b, d),
                side => side,
            };
            side == Orientation::Right
        }
    }
}

/// A height that a segment does not fall below over an abscissa between its ends, and hardly exceeds.
fn height_below([a, b]: [Point; 2], x: f64) -> f64 {
    let least = a.y.min(b.y);
    let (run, rise) = (b.x - a.x, b.y - a.y);
    if run.is_infinite() || rise.is_infinite() {
        return least;
    }
    // Differences, quotient and product err by half an ε of the rise each, five in all; the sum by half an
    // ε of the result: together less than six ε of the larger ordinate.
    let error = 8.0 * f64::EPSILON * a.y.abs().max(b.y.abs()) + f64::MIN_POSITIVE;
    (a.y + (x - a.x) / run * rise - error).max(least)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_height_is_below_and_close() {
        let shares = [0.0, 0.1, 1.0 / 3.0, 0.77, 0.999];
        for (a, b) in [
            ((0.1, 0.3), (7.7, 3.1)),
            ((-3e5, 5e6), (2e5, 4e6)),
            ((1.0, -1e-320), (1.5, 3e-320)),
            ((-1e308, 0.5), (1e308, 1.5)),
        ] {
            let ends @ [a, b] = [Point::from(a), Point::from(b)];
            for share in shares {
                let x = a.x + share * (b.x - a.x);
                if !(a.x <= x && x < b.x) {
                    continue;
                }
                let low = height_below(ends, x);
                let is_below = orient2d(a, b, Point::new(x, low)) != Orientation::Left;
                assert!(is_below, "{ends:?} {x}");
                let close = a.y + share * (b.y - a.y) - 1e-14 * a.y.abs().max(b.y.abs()) - 1e-307;
                assert!(low >= close, "{ends:?} {x}");
            }
        }
    }
}
