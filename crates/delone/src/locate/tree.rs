//! Where to begin: a sample of faces in the leaves of a balanced k-d tree (Bentley, *Multidimensional
//! binary search trees used for associative searching*, 1975).
//!
//! Its cells follow the sample, not the plane, so clusters, however tight, cost nothing: a descent is one
//! comparison a level, and about [`ITEMS_A_LEAF`] of what was sampled lie in the cell it ends in. Nothing
//! exact rests on it: it names a place to walk from.
//!
//! *Memory*: 12 bytes a leaf.

use crate::Point;

/// How many items one leaf stands for.
const ITEMS_A_LEAF: usize = 16;

/// A balanced tree with one sampled item in each leaf.
#[derive(Clone, Debug)]
pub(crate) struct Tree {
    /// Where node `i ≥ 1` is cut; its children are `2i` and `2i + 1`. The last bit of the number is no
    /// part of it: it says across which axis.
    cuts: Vec<f64>,
    items: Vec<u32>,
}

impl Tree {
    /// Samples items 0..`count`, at least one, and puts them where `place` says.
    ///
    /// One item is drawn from each of as many runs of equal length: items that are neighbours in the plane
    /// are often neighbours in number, so that spreads the sample. Which of a run is scrambled, lest a
    /// pattern in the numbers become one in the sample.
    ///
    /// *Cost*: O(m log m) for m = `count` / 16 leaves.
    pub fn sample(count: usize, place: impl Fn(usize) -> Point) -> Self {
        let leaves = 1 << (count / ITEMS_A_LEAF).max(1).ilog2();
        let draw = |leaf: usize| {
            let run = leaf * count / leaves..(leaf + 1) * count / leaves;
            run.start + scrambled(leaf) % run.len()
        };
        let drawn = (0..leaves).map(draw);
        let mut sample: Vec<_> = drawn.map(|item| (place(item), item as u32)).collect();
        let mut cuts = vec![0.0; leaves];
        cut(&mut sample, 1, &mut cuts);
        let items = sample.into_iter().map(|(_, item)| item).collect();
        Self { cuts, items }
    }

    /// Returns the item in whose cell `p` lies.
    #[inline]
    pub fn near(&self, p: Point) -> u32 {
        let leaves = self.cuts.len();
        let mut node = 1;
        while node < leaves {
            let cut = self.cuts[node];
            let c = if is_across_y(cut) { p.y } else { p.x };
            node = 2 * node + usize::from(c >= cut);
        }
        self.items[node - leaves]
    }
}

/// Cuts a sample, whose length is a power of two, in halves across the longer side of its box, and so on.
/// The depth is the binary logarithm of the length.
fn cut(sample: &mut [(Point, u32)], node: usize, cuts: &mut [f64]) {
    if sample.len() < 2 {
        return;
    }
    let is_across_y = is_tall(sample);
    let coordinate = |p: &Point| if is_across_y { p.y } else { p.x };
    let middle = sample.len() / 2;
    let by = |(p, i): &(Point, u32), (q, j): &(Point, u32)| {
        coordinate(p).total_cmp(&coordinate(q)).then(i.cmp(j))
    };
    let (_, (p, _), _) = sample.select_nth_unstable_by(middle, by);
    cuts[node] = marked(coordinate(p), is_across_y);
    let (lower, upper) = sample.split_at_mut(middle);
    cut(lower, 2 * node, cuts);
    cut(upper, 2 * node + 1, cuts);
}

/// Writes the axis into the last bit of a cut, and makes it no larger.
fn marked(c: f64, is_across_y: bool) -> f64 {
    let cut = f64::from_bits(c.to_bits() & !1 | u64::from(is_across_y));
    if cut > c {
        cut.next_down().next_down()
    } else {
        cut
    }
}

/// Reads the axis from the last bit of a cut.
#[inline]
fn is_across_y(cut: f64) -> bool {
    cut.to_bits() & 1 == 1
}

/// Tells whether the box of a sample is higher than wide.
fn is_tall(sample: &[(Point, u32)]) -> bool {
    let extent = |coordinate: fn(&Point) -> f64| {
        let values = || sample.iter().map(|(p, _)| coordinate(p));
        let largest = values().fold(f64::NEG_INFINITY, f64::max);
        // Halves, since a difference might overflow.
        0.5 * largest - 0.5 * values().fold(f64::INFINITY, f64::min)
    };
    extent(|p| p.y) > extent(|p| p.x)
}

/// Scrambles a number (the finalizer of SplitMix64; Steele, Lea and Flood, 2014).
fn scrambled(n: usize) -> usize {
    let z = (n as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    let z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    (z >> 32) as usize
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The k-th of many places on a spiral from 1e-300 to 1e300: any grid would have all but a few in one
    /// cell.
    fn place(k: usize) -> Point {
        let size = 10f64.powi((k % 600) as i32 - 300);
        Point::new(size * (k as f64).cos(), size * (k as f64).sin())
    }

    #[test]
    fn the_mark_changes_a_cut_by_one_unit_downwards_at_most() {
        for c in [
            0.0,
            -0.0,
            5e-324,
            -5e-324,
            1e-323,
            1.0,
            -1.0,
            1.0 + f64::EPSILON,
            f64::MAX,
        ] {
            for axis in [false, true] {
                let cut = marked(c, axis);
                assert!(
                    is_across_y(cut) == axis && (cut == c || cut == c.next_down()),
                    "{c}"
                );
            }
        }
    }

    #[test]
    fn every_leaf_has_an_item_of_its_own_and_finds_it() {
        for count in [1, 2, 15, 32, 33, 1000, 100_000] {
            let tree = Tree::sample(count, place);
            let mut items = tree.items.clone();
            items.sort_unstable();
            items.dedup();
            assert_eq!(items.len(), tree.cuts.len(), "{count}");
            assert!(items.iter().all(|&item| (item as usize) < count));
            for &item in &items {
                assert_eq!(tree.near(place(item as usize)), item, "of {count}");
            }
        }
    }
}
