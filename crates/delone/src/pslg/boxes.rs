//! Which of many boxes overlap: a packed tree over them, in the order of a space-filling curve.
//!
//! A packed R-tree (Kamel and Faloutsos, *On packing R-trees*, 1993), its boxes cut off at the
//! corners: besides x and y they bound x + y and x − y, because axis-parallel boxes of diagonal
//! segments overlap even where the segments are far apart. The bounds of sums are of the *rounded*
//! sums: rounding is monotone, so boxes of sets with a common point overlap.
//!
//! *Cost*: O(n log n) to build, with 73 bytes a box; a query in practice O(log n) and what it finds.
//! Long segments of one slope, neither axis-parallel nor diagonal, side by side, can still cost a
//! query O(n).

use crate::Point;
use crate::parallel::Workers;

/// Children of an inner node.
const FAN: usize = 8;

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

    #[inline]
    fn union(&self, other: &Self) -> Self {
        let lesser = |a: f64, b: f64| if b < a { b } else { a };
        let larger = |a: f64, b: f64| if b > a { b } else { a };
        Self {
            least: std::array::from_fn(|k| lesser(self.least[k], other.least[k])),
            largest: std::array::from_fn(|k| larger(self.largest[k], other.largest[k])),
        }
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

    /// The middle in x and y, halved so that it cannot overflow.
    fn half_middle(&self) -> [f64; 2] {
        [0, 1].map(|k| self.least[k] / 4.0 + self.largest[k] / 4.0)
    }
}

/// Boxes in curve order, and above them the boxes of each `FAN` of them, and so on up to one.
pub(super) struct BoxTree {
    /// What the caller calls each box.
    items: Vec<u32>,
    /// The boxes of the items, then of the nodes, level by level.
    levels: Vec<Vec<Octagon>>,
}

impl BoxTree {
    /// Packs items with their boxes.
    pub fn new(items: &[u32], bounds: impl Fn(u32) -> Octagon + Sync, workers: Workers) -> Self {
        let items = in_curve_order(items, &bounds, workers);
        let chunks = items.chunks(workers.chunk_len(items.len(), 1)).collect();
        let of_items = |items: &[u32]| items.iter().map(|&i| bounds(i)).collect::<Vec<_>>();
        let mut levels = vec![workers.map(chunks, of_items).concat()];
        while let Some(below) = levels.last().filter(|level| level.len() > 1) {
            levels.push(below.chunks(FAN).map(Octagon::union_of).collect());
        }
        Self { items, levels }
    }

    /// Returns the items, those that are close to each other in the plane mostly close in the list.
    pub fn items(&self) -> &[u32] {
        &self.items
    }

    /// Counts the leaves: groups of items that are close to each other.
    pub fn num_leaves(&self) -> usize {
        self.items.len().div_ceil(FAN)
    }

    /// Returns the positions of the items of a leaf.
    fn leaf(&self, leaf: usize) -> std::ops::Range<usize> {
        FAN * leaf..(FAN * leaf + FAN).min(self.items.len())
    }

    /// Visits every pair of items whose boxes overlap, the first of them in `leaf`, the second one
    /// later in the order, as long as `visit` returns true.
    pub fn pairs(
        &self,
        leaf: usize,
        stack: &mut Stack,
        visit: impl FnMut(u32, u32) -> bool,
    ) -> bool {
        self.join::<true>(leaf, self, stack, visit)
    }

    /// Visits every pair of an item in `leaf` and an item of another tree whose boxes overlap, as long
    /// as `visit` returns true.
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
        let bounds = Octagon::union_of(&self.levels[0][own.clone()]);
        let from = if LATER { own.start } else { 0 };
        other.leaves_overlapping(&bounds, from / FAN, stack, |range| {
            own.clone().all(|i| {
                let bounds = &self.levels[0][i];
                let start = if LATER {
                    range.start.max(i + 1)
                } else {
                    range.start
                };
                (start..range.end).all(|j| {
                    !bounds.overlaps(&other.levels[0][j]) || visit(self.items[i], other.items[j])
                })
            })
        })
    }

    /// Visits items whose boxes reach over or below `p`, those that reach higher mostly first. `visit`
    /// returns the ordinate below which nothing is of interest any more.
    pub fn below(&self, p: Point, stack: &mut Stack, mut visit: impl FnMut(u32) -> f64) {
        let mut floor = f64::NEG_INFINITY;
        let top = self.levels.len() - 1;
        stack.0.clear();
        stack
            .0
            .extend((0..self.levels[top].len()).map(|node| (top, node)));
        while let Some((level, node)) = stack.0.pop() {
            let Octagon { least, largest } = &self.levels[level][node];
            let is_over = least[0] <= p.x && p.x <= largest[0] && least[1] <= p.y;
            if !is_over || largest[1] < floor {
                continue;
            }
            if level == 0 {
                floor = visit(self.items[node]);
                continue;
            }
            let first = stack.0.len();
            let below = &self.levels[level - 1];
            let children = FAN * node..(FAN * node + FAN).min(below.len());
            stack.0.extend(children.map(|child| (level - 1, child)));
            let height = |node: usize| below[node].largest[1].min(p.y);
            stack.0[first..].sort_by(|a, b| height(a.1).total_cmp(&height(b.1)));
        }
    }

    /// Visits the leaves from number `from` on whose boxes overlap `bounds`, as ranges of positions,
    /// as long as `visit` returns true.
    fn leaves_overlapping(
        &self,
        bounds: &Octagon,
        from: usize,
        stack: &mut Stack,
        mut visit: impl FnMut(std::ops::Range<usize>) -> bool,
    ) -> bool {
        let top = self.levels.len() - 1;
        if self.items.is_empty() {
            return true;
        }
        stack.0.clear();
        stack.0.push((top, 0));
        while let Some((level, node)) = stack.0.pop() {
            if !bounds.overlaps(&self.levels[level][node]) {
                continue;
            }
            if level <= 1 {
                // With a single item there is no level of leaves.
                if !visit(self.leaf(if level == 1 { node } else { 0 })) {
                    return false;
                }
                continue;
            }
            let children = FAN * node..(FAN * node + FAN).min(self.levels[level - 1].len());
            // The last leaf below a child tells whether all of it comes too early.
            let leaves_below = FAN.pow(level as u32 - 2);
            let first = children.start.max(from / leaves_below);
            stack
                .0
                .extend((first..children.end).map(|child| (level - 1, child)));
        }
        true
    }
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

    fn scattered(n: usize, size: f64) -> Vec<Octagon> {
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
            Octagon::of_segment([Point::new(x, y), end])
        };
        (0..n).map(|_| segment()).collect()
    }

    fn tree(boxes: &[Octagon], first: u32) -> BoxTree {
        let items: Vec<u32> = (first..first + boxes.len() as u32).collect();
        BoxTree::new(&items, |i| boxes[(i - first) as usize], Workers::ONE)
    }

    fn naive(a: &[Octagon], b: &[Octagon], first: usize) -> Vec<[u32; 2]> {
        let mut pairs = Vec::new();
        for (i, p) in a.iter().enumerate() {
            for (j, q) in b.iter().enumerate() {
                if p.overlaps(q) {
                    pairs.push([i as u32, (j + first) as u32]);
                }
            }
        }
        pairs
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
            let boxes = scattered(n, size);
            let tree = tree(&boxes, 0);
            let mut found = Vec::new();
            let mut stack = Stack::default();
            for leaf in 0..tree.num_leaves() {
                tree.pairs(leaf, &mut stack, |i, j| {
                    found.push([i.min(j), i.max(j)]);
                    true
                });
            }
            found.sort_unstable();
            let mut expected = naive(&boxes, &boxes, 0);
            expected.retain(|[i, j]| i < j);
            assert_eq!(found, expected, "{n} boxes");
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
            assert_eq!(found, naive(a, b, 1000));
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
        let boxes: Vec<_> = points.clone().map(Octagon::of_point).collect();
        let tree = tree(&boxes, 0);
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
    fn diagonals_side_by_side_do_not_overlap() {
        let diagonal = |i: u32| {
            let x = f64::from(i);
            Octagon::of_segment([Point::new(x, 0.0), Point::new(x + 1e4, 1e4)])
        };
        let items: Vec<u32> = (0..5000).collect();
        let tree = BoxTree::new(&items, diagonal, Workers::ONE);
        let mut stack = Stack::default();
        for leaf in 0..tree.num_leaves() {
            assert!(tree.pairs(leaf, &mut stack, |_, _| false));
        }
    }
}
