//! Which of many segments may meet: a packed tree over them, in the order of a space-filling curve.
//!
//! A packed R-tree (Kamel and Faloutsos, *On packing R-trees*, 1993), its boxes cut off at the
//! corners: besides x and y they bound x + y and x − y, because axis-parallel boxes of diagonal
//! segments overlap even where the segments are far apart. The bounds of sums are of the *rounded*
//! sums: rounding is monotone, so boxes of sets with a common point overlap. Nodes also have a strip
//! along what they hold (`slabs.rs`), for long segments side by side in any direction.
//!
//! *Cost*: O(n log n) to build, with 50 bytes a segment; a query in practice O(log n) and what it
//! finds.

use super::slabs::Slab;
use crate::Point;
use crate::parallel::Workers;
use std::ops::Range;

/// Children of an inner node.
const FAN: usize = 8;

/// Nodes over more segments than this have no strip: they are few, and making theirs takes long.
const LARGEST_STRIP: usize = FAN.pow(4);

/// Bounds of x, y, x + y and x − y.
#[derive(Clone, Copy, Debug)]
pub(super) struct Octagon {
    least: [f64; 4],
    largest: [f64; 4],
}

impl Octagon {
    const EMPTY: Self = Self {
        least: [f64::INFINITY; 4],
        largest: [f64::NEG_INFINITY; 4],
    };

    /// Bounds a point.
    #[inline]
    pub fn of_point(p: Point) -> Self {
        let bounds = [p.x, p.y, p.x + p.y, p.x - p.y];
        Self {
            least: bounds,
            largest: bounds,
        }
    }

    /// Bounds a segment.
    #[inline]
    pub fn of_segment([a, b]: [Point; 2]) -> Self {
        Self::of_point(a).union(&Self::of_point(b)).loosened()
    }

    /// Widens the bounds of the sums so that they hold everything to which a point in the bounds of
    /// x and y can be rounded: each coordinate moves by up to 2⁻⁵³ of itself or half of the least
    /// number, and sums are rounded.
    #[inline]
    fn loosened(mut self) -> Self {
        const SHARE: f64 = f64::EPSILON * 2.0;
        let size = |k: usize| self.largest[k].abs().max(self.least[k].abs());
        let margin = SHARE * size(0) + SHARE * size(1) + f64::MIN_POSITIVE;
        for k in [2, 3] {
            self.least[k] -= margin;
            self.largest[k] += margin;
        }
        self
    }

    /// Bounds everything that is at most `radius` away from a point.
    fn around(p: Point, radius: f64) -> Self {
        const SHARE: f64 = f64::EPSILON * 8.0;
        let margin = SHARE * p.x.abs() + SHARE * p.y.abs() + f64::MIN_POSITIVE;
        let [reach, diagonal] =
            [1.0, std::f64::consts::SQRT_2].map(|factor| radius * factor * (1.0 + SHARE) + margin);
        let reaches = [reach, reach, diagonal, diagonal];
        let middle = Self::of_point(p).least;
        // A sum that overflows bounds nothing.
        let bound = |k: usize, reach: f64| match middle[k].is_finite() {
            true => middle[k] + reach,
            false => reach * f64::INFINITY,
        };
        Self {
            least: std::array::from_fn(|k| bound(k, -reaches[k])),
            largest: std::array::from_fn(|k| bound(k, reaches[k])),
        }
    }

    #[inline]
    fn union(&self, other: &Self) -> Self {
        let lesser = |a: f64, b: f64| if b < a { b } else { a };
        let larger = |a: f64, b: f64| if b > a { b } else { a };
        Self {
            least: std::array::from_fn(|k| lesser(self.least[k], other.least[k])),
            largest: std::array::from_fn(|k| larger(self.largest[k], other.largest[k])),
        }
    }

    fn of_segments(segments: &[[Point; 2]]) -> Self {
        let boxes = segments.iter().map(|&ends| Self::of_segment(ends));
        boxes.fold(Self::EMPTY, |all, b| all.union(&b))
    }

    fn union_of(boxes: &[Self]) -> Self {
        boxes.iter().fold(Self::EMPTY, |all, b| all.union(b))
    }

    /// Tells whether the bounds have a point in common. One branch, not eight.
    #[inline]
    pub fn overlaps(&self, other: &Self) -> bool {
        (0..4).fold(true, |all, k| {
            all & (self.least[k] <= other.largest[k]) & (other.least[k] <= self.largest[k])
        })
    }

    /// The diagonals of the bounds of x and y.
    #[inline]
    fn diagonals(&self) -> [[Point; 2]; 2] {
        let [[x, y, ..], [u, v, ..]] = [self.least, self.largest];
        [[(x, y), (u, v)], [(x, v), (u, y)]].map(|ends| ends.map(Point::from))
    }

    /// The middle in x and y, halved so that it cannot overflow.
    fn half_middle(&self) -> [f64; 2] {
        [0, 1].map(|k| self.least[k] / 4.0 + self.largest[k] / 4.0)
    }
}

/// A number of segments that follow each other in the order, or of nodes.
#[derive(Clone, Copy)]
struct Node {
    bounds: Octagon,
    slab: Slab,
}

/// Segments in curve order, and above them nodes for each `FAN` of them, and so on up to one.
pub(super) struct BoxTree {
    /// What the caller calls each segment.
    items: Vec<u32>,
    ends: Vec<[Point; 2]>,
    /// The leaves, then the nodes above them, level by level.
    levels: Vec<Vec<Node>>,
}

impl BoxTree {
    /// Packs items with the ends of their segments; a point has itself for both.
    pub fn new(items: &[u32], ends: impl Fn(u32) -> [Point; 2] + Sync, workers: Workers) -> Self {
        let bounds = |i: u32| Octagon::of_segment(ends(i));
        let items = in_curve_order(items, &bounds, workers);
        let ends: Vec<_> = items.iter().map(|&i| ends(i)).collect();
        let mut bounds: Vec<_> = ends.chunks(FAN).map(Octagon::of_segments).collect();
        let (mut levels, mut reach) = (Vec::new(), FAN);
        loop {
            levels.push(nodes(&bounds, &ends, reach, workers));
            if bounds.len() <= 1 {
                break;
            }
            bounds = bounds.chunks(FAN).map(Octagon::union_of).collect();
            reach *= FAN;
        }
        Self {
            items,
            ends,
            levels,
        }
    }

    /// Returns the items, those that are close to each other in the plane mostly close in the list.
    pub fn items(&self) -> &[u32] {
        &self.items
    }

    /// Counts the leaves: groups of items that are close to each other.
    pub fn num_leaves(&self) -> usize {
        self.levels[0].len()
    }

    /// Returns the positions of the items of a leaf.
    fn leaf(&self, leaf: usize) -> Range<usize> {
        FAN * leaf..(FAN * leaf + FAN).min(self.items.len())
    }

    /// Visits every pair of items whose boxes overlap, the first of them in `leaf`, the second one
    /// later in the order, as long as `visit` returns true. It may leave out some that do not meet.
    pub fn pairs(
        &self,
        leaf: usize,
        stack: &mut Stack,
        visit: impl FnMut(u32, u32) -> bool,
    ) -> bool {
        self.join::<true>(leaf, self, stack, visit)
    }

    /// Visits every pair of an item in `leaf` and an item of another tree whose boxes overlap, as long
    /// as `visit` returns true. It may leave out some that do not meet.
    pub fn pairs_with(
        &self,
        leaf: usize,
        other: &Self,
        stack: &mut Stack,
        visit: impl FnMut(u32, u32) -> bool,
    ) -> bool {
        self.join::<false>(leaf, other, stack, visit)
    }

    /// The pairs of a leaf with the items of `other`, or with those `LATER` in the same tree.
    fn join<const LATER: bool>(
        &self,
        leaf: usize,
        other: &Self,
        stack: &mut Stack,
        mut visit: impl FnMut(u32, u32) -> bool,
    ) -> bool {
        let own = self.leaf(leaf);
        let boxes = self.boxes(leaf);
        let from = if LATER { leaf } else { 0 };
        let shape = (&self.levels[0][leaf], &self.ends[own.clone()]);
        other.leaves_meeting(shape, from, stack, |leaf| {
            let others = other.boxes(leaf);
            let range = other.leaf(leaf);
            own.clone().all(|i| {
                let bounds = &boxes[i - own.start];
                let start = if LATER {
                    range.start.max(i + 1)
                } else {
                    range.start
                };
                (start..range.end).all(|j| {
                    !bounds.overlaps(&others[j - range.start])
                        || visit(self.items[i], other.items[j])
                })
            })
        })
    }

    /// Bounds the items of a leaf. They are not kept: that would double the memory.
    #[inline]
    fn boxes(&self, leaf: usize) -> [Octagon; FAN] {
        let ends = &self.ends[self.leaf(leaf)];
        std::array::from_fn(|k| {
            ends.get(k)
                .map_or(Octagon::EMPTY, |&ends| Octagon::of_segment(ends))
        })
    }

    /// Visits all items that are at most `radius` away from `p`, and some that are not, as long as `visit`
    /// returns true.
    pub fn near(
        &self,
        p: Point,
        radius: f64,
        stack: &mut Stack,
        mut visit: impl FnMut(u32) -> bool,
    ) -> bool {
        let disc = Octagon::around(p, radius);
        let square = disc.diagonals();
        // Strips cannot judge what overflows.
        let is_finite = square.as_flattened().iter().all(Point::is_finite);
        let top = self.levels.len() - 1;
        stack.0.clear();
        stack.0.extend(self.levels[top].first().map(|_| (top, 0)));
        while let Some((level, node)) = stack.0.pop() {
            let Node { bounds, slab } = &self.levels[level][node];
            if !bounds.overlaps(&disc) || (is_finite && !slab.may_hold(&square)) {
                continue;
            }
            if level > 0 {
                let children = FAN * node..(FAN * node + FAN).min(self.levels[level - 1].len());
                stack.0.extend(children.map(|child| (level - 1, child)));
                continue;
            }
            let boxes = self.boxes(node);
            for (i, bounds) in self.leaf(node).zip(&boxes) {
                if bounds.overlaps(&disc) && !visit(self.items[i]) {
                    return false;
                }
            }
        }
        true
    }

    /// Visits items whose boxes reach over or below `p`, those that reach higher mostly first. `visit`
    /// returns the ordinate below which nothing is of interest any more.
    pub fn below(&self, p: Point, stack: &mut Stack, mut visit: impl FnMut(u32) -> f64) {
        let top = self.levels.len() - 1;
        let Some(root) = self.levels[top].first() else {
            return;
        };
        // What is of interest meets the upright line from p down to the floor.
        let down_to = |floor: f64| {
            let line = [p, Point::new(p.x, floor.min(p.y))];
            (Node::of(&[line]), [line])
        };
        let mut line = down_to(root.bounds.least[1]);
        stack.0.clear();
        stack.0.push((top, 0));
        while let Some((level, node)) = stack.0.pop() {
            if !self.levels[level][node].may_meet((&line.0, &line.1)) {
                continue;
            }
            if level == 0 {
                let boxes = self.boxes(node);
                for (i, bounds) in self.leaf(node).zip(&boxes) {
                    if bounds.overlaps(&line.0.bounds) {
                        let floor = visit(self.items[i]);
                        line = down_to(floor.max(root.bounds.least[1]));
                    }
                }
                continue;
            }
            let first = stack.0.len();
            let below = &self.levels[level - 1];
            let children = FAN * node..(FAN * node + FAN).min(below.len());
            stack.0.extend(children.map(|child| (level - 1, child)));
            let height = |node: usize| {
                let Node { bounds, slab } = &below[node];
                bounds.largest[1].min(p.y).min(slab.top(p.x))
            };
            stack.0[first..].sort_by(|a, b| height(a.1).total_cmp(&height(b.1)));
        }
    }

    /// Visits the leaves from number `from` on that may meet something, as long as `visit` returns true.
    fn leaves_meeting(
        &self,
        shape: Shape,
        from: usize,
        stack: &mut Stack,
        mut visit: impl FnMut(usize) -> bool,
    ) -> bool {
        let top = self.levels.len() - 1;
        stack.0.clear();
        stack.0.extend(self.levels[top].first().map(|_| (top, 0)));
        while let Some((level, node)) = stack.0.pop() {
            if !self.levels[level][node].may_meet(shape) {
                continue;
            }
            if level == 0 {
                if !visit(node) {
                    return false;
                }
                continue;
            }
            let children = FAN * node..(FAN * node + FAN).min(self.levels[level - 1].len());
            // The last leaf below a child tells whether all of it comes too early.
            let leaves_below = FAN.pow(level as u32 - 1);
            let first = children.start.max(from / leaves_below);
            stack
                .0
                .extend((first..children.end).map(|child| (level - 1, child)));
        }
        true
    }
}

/// Segments, and their bounds.
type Shape<'a> = (&'a Node, &'a [[Point; 2]]);

impl Node {
    fn of(segments: &[[Point; 2]]) -> Self {
        Self {
            bounds: Octagon::of_segments(segments),
            slab: Slab::of(segments),
        }
    }

    #[inline]
    fn may_meet(&self, (other, segments): Shape) -> bool {
        self.bounds.overlaps(&other.bounds)
            && self.slab.may_hold(segments)
            && other.slab.may_hold(&self.bounds.diagonals())
    }
}

/// Makes the nodes of one level, each over `reach` segments.
fn nodes(bounds: &[Octagon], ends: &[[Point; 2]], reach: usize, workers: Workers) -> Vec<Node> {
    let length = workers.chunk_len(ends.len(), 1).next_multiple_of(reach);
    let jobs = ends.chunks(length).zip(bounds.chunks(length / reach));
    let made = workers.map(jobs.collect(), |(ends, bounds)| {
        let nodes = ends.chunks(reach).zip(bounds);
        let node = |(ends, &bounds): (&[_], &Octagon)| {
            let is_low = reach <= LARGEST_STRIP;
            let slab = if is_low { Slab::of(ends) } else { Slab::PLANE };
            Node { bounds, slab }
        };
        nodes.map(node).collect::<Vec<_>>()
    });
    made.concat()
}

/// Nodes still to be visited, kept between queries.
#[derive(Default)]
pub(super) struct Stack(Vec<(usize, usize)>);

/// Orders items along a Hilbert curve through the middles of their boxes, equal ones as given.
fn in_curve_order(
    items: &[u32],
    bounds: &(impl Fn(u32) -> Octagon + Sync),
    workers: Workers,
) -> Vec<u32> {
    let chunk = workers.chunk_len(items.len(), 1);
    let chunks = || items.chunks(chunk).zip((0_u64..).step_by(chunk)).collect();
    let extents = workers.map(chunks(), |(items, _): (&[u32], u64)| {
        let middles = items.iter().map(|&i| bounds(i).half_middle());
        let points = middles.map(|m| Octagon::of_point(m.into()));
        points.fold(Octagon::EMPTY, |all, b| all.union(&b))
    });
    let extent = Octagon::union_of(&extents);
    let keys = workers.map(chunks(), |(items, first)| {
        let key =
            |(&i, place): (&u32, u64)| u64::from(curve_key(&bounds(i), &extent)) << 32 | place;
        items.iter().zip(first..).map(key).collect::<Vec<u64>>()
    });
    let mut keys = keys.concat();
    keys.sort_unstable();
    keys.into_iter()
        .map(|key| items[key as u32 as usize])
        .collect()
}

/// The place of a box along the curve through the cells of `extent`, the extent of half middles.
/// Any key is right, so rounding, overflow and flat extents do no harm.
fn curve_key(b: &Octagon, extent: &Octagon) -> u32 {
    const CELLS: f64 = 65535.0;
    let middle = b.half_middle();
    let [x, y] = [0, 1].map(|k| {
        let share = (middle[k] - extent.least[k]) / (extent.largest[k] - extent.least[k]);
        // The conversion saturates, and makes NaN zero.
        (CELLS * share) as u32
    });
    hilbert(x, y)
}

/// The distance along the Hilbert curve to a cell of the 2¹⁶ by 2¹⁶ grid.
fn hilbert(mut x: u32, mut y: u32) -> u32 {
    let mut key = 0;
    for bit in (0..16).rev() {
        let [right, up] = [x >> bit & 1, y >> bit & 1];
        key = key << 2 | ((3 * right) ^ up);
        // The curve in each quarter is the whole one, turned.
        if up == 0 {
            if right == 1 {
                [x, y] = [!x, !y];
            }
            std::mem::swap(&mut x, &mut y);
        }
    }
    key
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::predicates::orient2d;

    fn scattered(n: usize, size: f64) -> Vec<[Point; 2]> {
        let mut state = 1_u64;
        let mut unit = move || {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1);
            (state >> 33) as f64 / (1_u64 << 31) as f64
        };
        let mut segment = || {
            let [x, y] = [unit(), unit()];
            let end = Point::new(x + size * (unit() - 0.5), y + size * (unit() - 0.5));
            [Point::new(x, y), end]
        };
        (0..n).map(|_| segment()).collect()
    }

    #[test]
    fn what_is_near_is_visited() {
        use crate::predicates::is_near_segment;
        for (size, radius) in [
            (0.01, 0.02),
            (0.5, 0.003),
            (0.0, 0.05),
            (0.1, 0.0),
            (0.1, 1e308),
        ] {
            let segments = scattered(900, size);
            let tree = tree(&segments, 0);
            let mut stack = Stack::default();
            for &[p, _] in &scattered(40, 0.3) {
                let mut seen = Vec::new();
                tree.near(p, radius, &mut stack, |s| {
                    seen.push(s);
                    true
                });
                let is_near = |s: &u32| is_near_segment(segments[*s as usize], radius, p);
                let missed = (0..900).filter(is_near).find(|s| !seen.contains(s));
                assert_eq!(missed, None, "{size} {radius} {p:?}");
            }
        }
        let far = Point::new(f64::MAX, f64::MAX);
        let tree = tree(&[[far; 2]], 0);
        let mut seen = 0;
        tree.near(
            Point::new(f64::MAX, 1.7e308),
            1e307,
            &mut Stack::default(),
            |_| {
                seen += 1;
                true
            },
        );
        assert_eq!(seen, 1);
    }

    fn tree(segments: &[[Point; 2]], first: u32) -> BoxTree {
        let items: Vec<u32> = (first..first + segments.len() as u32).collect();
        BoxTree::new(&items, |i| segments[(i - first) as usize], Workers::ONE)
    }

    /// Tells whether two segments cross, roughly: the random ones do not come close to touching.
    fn cross([a, b]: [Point; 2], [c, d]: [Point; 2]) -> bool {
        orient2d(a, b, c) != orient2d(a, b, d) && orient2d(c, d, a) != orient2d(c, d, b)
    }

    /// All pairs of which `is_wanted` is true.
    fn naive(
        a: &[[Point; 2]],
        b: &[[Point; 2]],
        first: usize,
        is_wanted: impl Fn([Point; 2], [Point; 2]) -> bool,
    ) -> Vec<[u32; 2]> {
        let mut pairs = Vec::new();
        for (i, &p) in a.iter().enumerate() {
            for (j, &q) in b.iter().enumerate() {
                if is_wanted(p, q) {
                    pairs.push([i as u32, (j + first) as u32]);
                }
            }
        }
        pairs
    }

    /// Requires that sorted pairs are different, have boxes that overlap, and hold all that cross.
    fn check(found: &[[u32; 2]], a: &[[Point; 2]], b: &[[Point; 2]], first: usize) {
        let overlap = |p, q| Octagon::of_segment(p).overlaps(&Octagon::of_segment(q));
        let possible = naive(a, b, first, overlap);
        let crossing = naive(a, b, first, cross);
        assert!(found.is_sorted_by(|p, q| p < q));
        assert!(
            found
                .iter()
                .all(|pair| possible.binary_search(pair).is_ok())
        );
        let is_found = |pair: &[u32; 2]| found.binary_search(pair).is_ok();
        let mut later = crossing.iter().filter(|[i, j]| i < j);
        assert!(later.all(is_found));
    }

    #[test]
    fn joins_find_every_pair_once() {
        for (n, size) in [
            (0, 1.0),
            (1, 1.0),
            (2, 1.0),
            (8, 0.5),
            (9, 0.5),
            (65, 0.3),
            (700, 0.1),
        ] {
            let segments = scattered(n, size);
            let tree = tree(&segments, 0);
            let mut found = Vec::new();
            let mut stack = Stack::default();
            for leaf in 0..tree.num_leaves() {
                tree.pairs(leaf, &mut stack, |i, j| {
                    found.push([i.min(j), i.max(j)]);
                    true
                });
            }
            found.sort_unstable();
            check(&found, &segments, &segments, 0);
        }
    }

    #[test]
    fn joins_of_two_trees_find_every_pair_once() {
        let [few, many] = [scattered(30, 0.5), scattered(500, 0.1)];
        for (a, b) in [(&few, &many), (&many, &few), (&few, &Vec::new())] {
            let [own, other] = [tree(a, 0), tree(b, 1000)];
            let mut found = Vec::new();
            for leaf in 0..own.num_leaves() {
                own.pairs_with(leaf, &other, &mut Stack::default(), |i, j| {
                    found.push([i, j]);
                    true
                });
            }
            found.sort_unstable();
            check(&found, a, b, 1000);
        }
    }

    #[test]
    fn a_visit_can_stop() {
        let tree = tree(&scattered(500, 0.5), 0);
        let mut visits = 0;
        assert!(!tree.pairs(0, &mut Stack::default(), |_, _| {
            visits += 1;
            visits < 3
        }));
        assert_eq!(visits, 3);
    }

    #[test]
    fn extreme_boxes_overlap_themselves() {
        let ladder = [-f64::MAX, -1.0, -5e-324, 0.0, 5e-324, 1.0, f64::MAX];
        let points = ladder
            .iter()
            .flat_map(|&x| ladder.map(|y| Point::new(x, y)));
        let dots: Vec<_> = points.clone().map(|p| [p; 2]).collect();
        let tree = tree(&dots, 0);
        for (i, p) in points.enumerate() {
            let mut found = Vec::new();
            tree.below(p, &mut Stack::default(), |j| {
                found.push(j as usize);
                p.y
            });
            assert!(found.contains(&i));
        }
    }

    #[test]
    fn the_curve_visits_neighbours() {
        let mut cells: Vec<_> = (0..64_u32).map(|i| (i % 8, i / 8)).collect();
        cells.sort_by_key(|&(x, y)| hilbert(x, y));
        for pair in cells.windows(2) {
            let [(x, y), (u, v)] = [pair[0], pair[1]];
            assert_eq!(x.abs_diff(u) + y.abs_diff(v), 1, "{pair:?}");
        }
    }

    #[test]
    fn long_segments_side_by_side_are_not_paired() {
        for slope in [0.0, 1.0, -1.0, 0.4142, -2.5, 1e6] {
            let line = |i: u32| {
                let d = f64::from(i);
                // Side by side across the slope.
                let [x, y] = [-slope * d, d];
                [Point::new(x, y), Point::new(x + 1e4, y + slope * 1e4)]
            };
            let items: Vec<u32> = (0..5000).collect();
            let tree = BoxTree::new(&items, line, Workers::ONE);
            let (mut stack, mut pairs) = (Stack::default(), 0);
            for leaf in 0..tree.num_leaves() {
                tree.pairs(leaf, &mut stack, |_, _| {
                    pairs += 1;
                    true
                });
            }
            // Those in one leaf, and a few besides.
            assert!(pairs < 40_000, "slope {slope}: {pairs}");
        }
    }
}
