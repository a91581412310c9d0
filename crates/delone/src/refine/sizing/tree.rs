//! Which of many shapes is nearest to a point, or holds it: a balanced tree of boxes, built once.
//!
//! A complete binary tree in heap order: node `i` has the children `2i` and `2i + 1`, and knows the
//! boxes of both, so that one cache line tells where to go on. Shapes are shared out evenly, cut across
//! the longer side of where they lie.
//!
//! *Cost*: O(n log n) to build, with 16 bytes a shape besides the shapes; a query in practice O(log n).
//! For the nearest it *assumes* coordinates below 2⁵⁰⁰ in magnitude, of shapes and of questions, so that
//! squares are finite ([`Unit`](super::unit::Unit) sees to it).

use crate::Point;

/// Most shapes in a leaf.
const LEAF: usize = 4;

/// What the tree holds.
pub(super) trait Shape: Copy {
    /// Bounds it.
    fn bounds(&self) -> Bounds;
}

/// What can be near to a point.
pub(super) trait Near: Shape {
    /// Returns the square of its distance from a point.
    fn distance_squared(&self, from: Point) -> f64;
}

/// Bounds of x and y.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bounds {
    least: [f64; 2],
    largest: [f64; 2],
}

impl Bounds {
    const EMPTY: Self = Self {
        least: [f64::INFINITY; 2],
        largest: [f64::NEG_INFINITY; 2],
    };

    /// Bounds points.
    pub fn of(points: &[Point]) -> Self {
        let boxes = points.iter().map(|&p| {
            let [least, largest] = [<[f64; 2]>::from(p); 2];
            Self { least, largest }
        });
        boxes.fold(Self::EMPTY, Self::union)
    }

    fn union(self, other: Self) -> Self {
        Self {
            least: [0, 1].map(|k| lesser(self.least[k], other.least[k])),
            largest: [0, 1].map(|k| larger(self.largest[k], other.largest[k])),
        }
    }

    fn middle(&self) -> Point {
        Point::from([0, 1].map(|k| self.least[k] / 2.0 + self.largest[k] / 2.0))
    }

    #[inline]
    fn holds(&self, at: Point) -> bool {
        let at = [at.x, at.y];
        (0..2).all(|k| self.least[k] <= at[k] && at[k] <= self.largest[k])
    }

    /// The square of the distance from a point; 0 inside, infinite if empty.
    #[inline]
    fn distance_squared(&self, from: Point) -> f64 {
        let from = [from.x, from.y];
        let [dx, dy] = [0, 1].map(|k| {
            let beside = larger(self.least[k] - from[k], from[k] - self.largest[k]);
            larger(beside, 0.0)
        });
        dx * dx + dy * dy
    }
}

/// `f64::min` but for NaN, and faster.
#[inline]
fn lesser(a: f64, b: f64) -> f64 {
    if b < a { b } else { a }
}

/// `f64::max` but for NaN, and faster.
#[inline]
fn larger(a: f64, b: f64) -> f64 {
    if b > a { b } else { a }
}

/// Shapes, and a tree of boxes over them.
#[derive(Clone, Debug)]
pub(super) struct Tree<S> {
    /// Those of the first leaf, then those of the second one, and so on.
    shapes: Vec<S>,
    /// The boxes of the two children; there is no node 0.
    nodes: Vec<[Bounds; 2]>,
    /// A power of two; leaf `k` is node `leaves + k`.
    leaves: usize,
}

impl<S: Shape> Tree<S> {
    /// Builds the tree.
    pub fn new(shapes: &[S]) -> Self {
        let leaves = shapes.len().div_ceil(LEAF).next_power_of_two();
        let order = in_leaf_order(shapes, leaves);
        let mut tree = Self {
            shapes: order.iter().map(|&i| shapes[i as usize]).collect(),
            nodes: vec![[Bounds::EMPTY; 2]; leaves],
            leaves,
        };
        for node in (1..leaves).rev() {
            tree.nodes[node] = [2 * node, 2 * node + 1].map(|child| tree.bounds(child));
        }
        tree
    }

    fn bounds(&self, node: usize) -> Bounds {
        let parts = match node.checked_sub(self.leaves) {
            None => return self.nodes[node][0].union(self.nodes[node][1]),
            Some(leaf) => self.leaf(leaf).iter().map(S::bounds),
        };
        parts.fold(Bounds::EMPTY, Bounds::union)
    }

    #[inline]
    fn leaf(&self, leaf: usize) -> &[S] {
        let [start, end] = [leaf, leaf + 1].map(|k| start_of(k, self.leaves, self.shapes.len()));
        &self.shapes[start..end]
    }

    /// Visits the shapes whose boxes hold a point, and perhaps a few others, until `visit` returns true.
    pub fn around(&self, at: Point, visit: &mut impl FnMut(&S) -> bool) {
        self.descend(1, at, visit);
    }

    fn descend(&self, node: usize, at: Point, visit: &mut impl FnMut(&S) -> bool) -> bool {
        if let Some(leaf) = node.checked_sub(self.leaves) {
            return self.leaf(leaf).iter().any(visit);
        }
        let [left, right] = self.nodes[node].map(|bounds| bounds.holds(at));
        left && self.descend(2 * node, at, visit) || right && self.descend(2 * node + 1, at, visit)
    }
}

impl<S: Near> Tree<S> {
    /// Returns a shape nearest to a point, and the square of its distance; `None` if there are none.
    /// None is nearer by more than the share `slack` of the distance.
    ///
    /// Inside of a circle of n segments, half as far from its centre as they are, √n of them are
    /// nearly the nearest, and it takes some slack not to look at all of those.
    pub fn nearest(&self, from: Point, slack: f64) -> Option<(&S, f64)> {
        let mut search = Search {
            tree: self,
            from,
            stretch: (1.0 + slack) * (1.0 + slack),
            best: None,
            least: f64::INFINITY,
        };
        search.below(1);
        Some((search.best?, search.least))
    }
}

/// A search for the nearest.
struct Search<'s, S> {
    tree: &'s Tree<S>,
    from: Point,
    /// Squared distances of boxes are taken for so many times as much.
    stretch: f64,
    best: Option<&'s S>,
    least: f64,
}

impl<S: Near> Search<'_, S> {
    /// Looks below a node for what is nearer than the best so far, the nearer child first.
    fn below(&mut self, node: usize) {
        if let Some(leaf) = node.checked_sub(self.tree.leaves) {
            for shape in self.tree.leaf(leaf) {
                let distance = shape.distance_squared(self.from);
                if distance < self.least {
                    (self.best, self.least) = (Some(shape), distance);
                }
            }
            return;
        }
        let boxes = &self.tree.nodes[node];
        let [left, right] = [0, 1].map(|k| self.stretch * boxes[k].distance_squared(self.from));
        let mut children = [(left, 2 * node), (right, 2 * node + 1)];
        if right < left {
            children.swap(0, 1);
        }
        for (distance, child) in children {
            if distance < self.least {
                self.below(child);
            }
        }
    }
}

/// Where the shapes of a leaf begin.
#[inline]
fn start_of(leaf: usize, leaves: usize, shapes: usize) -> usize {
    (leaf as u64 * shapes as u64 / leaves as u64) as usize
}

/// Orders shapes so that the leaves are small in the plane. What is cut where does not depend on how
/// the standard library selects and sorts: no two shapes compare as equal.
fn in_leaf_order<S: Shape>(shapes: &[S], leaves: usize) -> Vec<u32> {
    let middles: Vec<[f64; 2]> = shapes.iter().map(|s| s.bounds().middle().into()).collect();
    let mut order: Vec<u32> = (0..shapes.len() as u32).collect();
    let mut width = leaves;
    while width > 1 {
        for first in (0..leaves).step_by(width) {
            let ends = [first, first + width / 2, first + width];
            let [start, cut, end] = ends.map(|leaf| start_of(leaf, leaves, shapes.len()));
            if cut < end {
                let part = &mut order[start..end];
                let k = longer_side(part, &middles);
                let place = |&i: &u32| (middles[i as usize][k], i);
                part.select_nth_unstable_by(cut - start, |a, b| {
                    let (a, b) = (place(a), place(b));
                    a.0.total_cmp(&b.0).then(a.1.cmp(&b.1))
                });
            }
        }
        width /= 2;
    }
    for leaf in 0..leaves {
        let [start, end] = [leaf, leaf + 1].map(|k| start_of(k, leaves, shapes.len()));
        order[start..end].sort_unstable();
    }
    order
}

/// Tells whether some of the middles are spread more in x (0) or in y (1).
fn longer_side(part: &[u32], middles: &[[f64; 2]]) -> usize {
    let boxes = part
        .iter()
        .map(|&i| Bounds::of(&[middles[i as usize].into()]));
    let all = boxes.fold(Bounds::EMPTY, Bounds::union);
    let [width, height] = [0, 1].map(|k| all.largest[k] - all.least[k]);
    usize::from(height > width)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(Clone, Copy, Debug, PartialEq)]
    struct Disc(Point, f64);

    impl Shape for Disc {
        fn bounds(&self) -> Bounds {
            let Self(Point { x, y }, r) = *self;
            Bounds::of(&[Point::new(x - r, y - r), Point::new(x + r, y + r)])
        }
    }

    impl Near for Disc {
        fn distance_squared(&self, from: Point) -> f64 {
            let [dx, dy] = [from.x - self.0.x, from.y - self.0.y];
            let beyond = (dx * dx + dy * dy).sqrt() - self.1;
            beyond.max(0.0).powi(2)
        }
    }

    fn units() -> impl FnMut() -> f64 {
        let mut state = 7_u64;
        move || {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1);
            (state >> 33) as f64 / (1_u64 << 31) as f64
        }
    }

    /// From none to many, scattered and in a row, against looking at each.
    #[test]
    fn the_nearest_is_the_nearest_of_all() {
        let mut unit = units();
        for n in [0, 1, 3, 4, 5, 8, 9, 100, 1000] {
            for height in [0.0, 1.0] {
                let mut disc = || Disc(Point::new(unit(), height * unit()), 0.01 * unit());
                let discs: Vec<Disc> = (0..n).map(|_| disc()).collect();
                let tree = Tree::new(&discs);
                for _ in 0..50 {
                    let from = Point::new(2.0 * unit() - 0.5, 2.0 * unit() - 0.5);
                    let distances = discs.iter().map(|d| d.distance_squared(from));
                    let expected = distances.min_by(f64::total_cmp);
                    assert_eq!(tree.nearest(from, 0.0).map(|(_, d)| d), expected);
                    let near = tree.nearest(from, 0.25).map_or(0.0, |(_, d)| d.sqrt());
                    assert!(near <= 1.2500001 * expected.unwrap_or(0.0).sqrt());
                }
            }
        }
    }

    #[test]
    fn whatever_holds_a_point_is_around_it() {
        let mut unit = units();
        let discs: Vec<Disc> = (0..300)
            .map(|_| Disc(Point::new(unit(), unit()), 0.1 * unit()))
            .collect();
        let tree = Tree::new(&discs);
        for _ in 0..200 {
            let at = Point::new(unit(), unit());
            let (mut held, mut visited) = (0, 0);
            tree.around(at, &mut |disc| {
                held += usize::from(disc.distance_squared(at) == 0.0);
                visited += 1;
                false
            });
            let expected = discs.iter().filter(|d| d.distance_squared(at) == 0.0);
            assert_eq!(held, expected.count());
            assert!(visited < 150, "the tree leaves most of them out");
            let mut visited = 0;
            tree.around(at, &mut |_| {
                visited += 1;
                visited == 3
            });
            assert!(visited <= 3, "told to stop");
        }
    }

    /// Many equal shapes cannot be told apart by any cut.
    #[test]
    fn equal_shapes_do_no_harm() {
        let disc = Disc(Point::new(1.0, 2.0), 0.0);
        let tree = Tree::new(&[disc; 1000]);
        let nearest = tree.nearest(Point::new(4.0, 6.0), 0.0);
        assert_eq!(nearest, Some((&disc, 25.0)));
    }
}
