//! Incremental construction in random order, which makes the number of flips linear in expectation.
//!
//! [`incremental`] after a shuffle. Whatever the points are, the one that came last is any of them with equal
//! probability, and inserting it has cost as many flips as it has edges, less three or so; the average degree is
//! below six. So the i-th insertion flips fewer than three edges in expectation, and all of them fewer than 3n;
//! the worst order may need some n²/2. *Does not* make location cheaper: the breadth-first search stays O(n) a
//! point.
//!
//! The order depends on the number of points and on the seed alone, on any machine: the shuffle of Fisher and
//! Yates with the generator SplitMix64 (Steele, Lea and Flood 2014), both in integers.

use super::{About, Board, Input, Output, Takes, incremental};
use crate::{Error, Observer};

/// What there is to say of it.
pub(super) const ABOUT: About = About {
    name: "random-incremental",
    title: "incremental construction in random order",
    source: "Lecture on geometric graphs, 6.1.4, theorem 6.20; Guibas, Knuth and Sharir 1992",
    idea: "Shuffle the points first: in a random order few edges have to be flipped.",
    cost: "O(n) flips expected, whatever the points; O(n²) with the search for faces",
    guarantees: "the canonical Delaunay triangulation, after every point",
    takes: Takes::Points,
    is_delaunay: true,
    code: &[
        "shuffle the points",
        "find the first point q that is not on one line with all before it",
        "T := the points before q in a row, all joined to q",
        "for each further point p:",
        "  search the faces of T breadth-first for one that holds p",
        "  inside: join p to the corners of its face; on an edge: of both faces",
        "  outside: join p to each outer half-edge a→c with (a, c, p) counter-clockwise",
        "  push the edges opposite to p",
        "  while an edge e can be popped:",
        "    if e is not locally Delaunay:",
        "      g := flip(e); push g.twin.next and g.next.next",
    ],
};

/// Inserts the points in the order that the seed of the input names.
pub(super) fn run(input: &Input, observer: &mut impl Observer) -> Result<Output, Error> {
    let (mut board, mut order) = Board::new(input, observer)?;
    shuffle(&mut order, input.seed);
    incremental::insert_all(&mut board, &order, 1)?;
    Ok(board.finish())
}

/// Puts items into the order that a seed names (Fisher and Yates): each of all orders alike.
fn shuffle<T>(items: &mut [T], seed: u64) {
    let mut random = SplitMix(seed);
    for i in (1..items.len()).rev() {
        items.swap(i, random.below(i + 1));
    }
}

/// SplitMix64: a counter, scrambled.
struct SplitMix(u64);

impl SplitMix {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Draws from 0 … `bound` − 1; the bias is below `bound` · 2⁻⁶⁴.
    fn below(&mut self, bound: usize) -> usize {
        ((u128::from(self.bits()) * bound as u128) >> 64) as usize
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_generator_is_that_of_the_paper() {
        let mut random = SplitMix(1_234_567);
        let expected = [6_457_827_717_110_365_317, 3_203_168_211_198_807_973];
        assert_eq!([random.bits(), random.bits()], expected);
    }

    #[test]
    fn every_order_comes_about_as_often() {
        let mut counts = std::collections::BTreeMap::new();
        for seed in 0..6000 {
            let mut items = [0, 1, 2];
            shuffle(&mut items, seed);
            *counts.entry(items).or_insert(0) += 1;
        }
        assert_eq!(counts.len(), 6);
        assert!(
            counts.values().all(|n| (850..1150).contains(n)),
            "{counts:?}"
        );
    }
}
