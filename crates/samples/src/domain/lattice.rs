//! Segments on a lattice, where nothing is in general position.

use super::{Drawing, index};
use crate::Random;

/// How far a segment may reach in x and in y.
const REACH: usize = 3;

/// Draws `count` segments between points of the smallest square lattice that has so many, all of
/// whose points are there, in random order.
pub fn lines(count: usize, random: &mut Random) -> Drawing {
    // With less than two points in a row no segment has a length.
    let side = count.saturating_sub(1).isqrt().max(1) + 1;
    let mut places: Vec<usize> = (0..side * side).collect();
    random.shuffle(&mut places);
    let mut number = vec![0; places.len()];
    for (i, &place) in places.iter().enumerate() {
        number[place] = index(i);
    }
    let segment = |_| step(side, random).map(|[x, y]| number[y * side + x]);
    Drawing {
        segments: (0..count).map(segment).collect(),
        points: places
            .iter()
            .map(|&place| [place % side, place / side].map(|c| c as f64))
            .collect(),
        holes: Vec::new(),
    }
}

/// Draws two different places, not far from each other.
fn step(side: usize, random: &mut Random) -> [[usize; 2]; 2] {
    loop {
        let from = [random.below(side), random.below(side)];
        let to = from.map(|c| (c + random.below(2 * REACH + 1)).wrapping_sub(REACH));
        if to != from && to.iter().all(|&c| c < side) {
            return [from, to];
        }
    }
}
