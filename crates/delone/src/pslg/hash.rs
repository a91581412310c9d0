//! The name of a drawing: a hash that depends on what is drawn, and not on the order in which it was.
//!
//! Each point, segment, hole and region is written as a letter and the `f64` bits of its numbers, little-endian, a
//! segment from its lexicographically smaller end, and hashed by XXH3-128; a polygon is hashed as the sum of its
//! segments. All are summed modulo 2¹²⁸, so repetitions count and numbering does not.

use super::Pslg;
use crate::Point;
use std::fmt;
use xxhash_rust::xxh3::xxh3_128;

/// The hash of a drawing; shown as 32 hexadecimal digits.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct PslgHash(pub u128);

impl fmt::Display for PslgHash {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:032x}", self.0)
    }
}

impl Pslg {
    /// Returns the name of this drawing, by which it is known whatever its order.
    ///
    /// ```
    /// use delone::Pslg;
    /// let mut one = Pslg::from_points([(0.0, 0.0), (1.0, 0.0)]);
    /// one.add_segment(0, 1);
    /// let mut other = Pslg::from_points([(1.0, 0.0), (-0.0, 0.0)]);
    /// other.add_segment(0, 1);
    /// assert_eq!(one.hash(), other.hash());
    /// ```
    ///
    /// # Panics
    /// If a segment names no point, or a polygon no segments.
    ///
    /// *Cost*: about 10 ns a point or segment.
    pub fn hash(&self) -> PslgHash {
        let place = |p: Point| [p.x, p.y];
        let points = self.points.iter().map(|&p| element(b'p', &place(p)));
        let segments = (0..self.segments.len()).map(|s| self.hash_segment(s));
        let polygons = self.polygons.iter().map(|range| {
            let sum = range.clone().map(|s| self.hash_segment(s));
            xxh3_128(&sum.fold(0, u128::wrapping_add).to_le_bytes())
        });
        let holes = self.holes.iter().map(|&hole| element(b'h', &place(hole)));
        let regions = self.regions.iter().map(|region| {
            let [x, y] = place(region.at);
            match region.max_area {
                None => element(b'r', &[x, y, region.attribute]),
                Some(area) => element(b'r', &[x, y, region.attribute, area]),
            }
        });
        let all = points.chain(segments).chain(polygons).chain(holes);
        PslgHash(all.chain(regions).fold(0, u128::wrapping_add))
    }

    fn hash_segment(&self, segment: usize) -> u128 {
        let [mut a, mut b] = self.segments[segment].map(|v| self.points[v.index()]);
        if b.lex_cmp(&a).is_lt() {
            (a, b) = (b, a);
        }
        element(b's', &[a.x, a.y, b.x, b.y])
    }
}

fn element(kind: u8, numbers: &[f64]) -> u128 {
    let mut bytes = [0; 33];
    bytes[0] = kind;
    for (chunk, number) in bytes[1..].chunks_exact_mut(8).zip(numbers) {
        // Adding zero turns −0.0 into 0.0: both are the same place.
        chunk.copy_from_slice(&(number + 0.0).to_le_bytes());
    }
    xxh3_128(&bytes[..1 + 8 * numbers.len()])
}

#[cfg(test)]
mod tests {
    use crate::{Point, Pslg, Region};

    fn square() -> Pslg {
        let mut square = Pslg::from_points([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]);
        square.add_ring([0, 1, 2, 3]);
        square
    }

    #[test]
    fn whatever_is_drawn_counts() {
        let mut hashes = vec![square().hash()];
        let mut with = |change: fn(&mut Pslg)| {
            let mut other = square();
            change(&mut other);
            hashes.push(other.hash());
        };
        with(|s| s.points[2].x = 1.0_f64.next_up());
        with(|s| s.points.push(s.points[0]));
        with(|s| {
            s.segments.pop();
        });
        with(|s| s.add_segment(0, 2));
        with(|s| s.polygons.push(0..4));
        with(|s| s.holes.push(Point::new(0.5, 0.5)));
        let region = |attribute, max_area| Region {
            at: Point::new(0.5, 0.5),
            attribute,
            max_area,
        };
        let regions = [region(0.0, None), region(1.0, None), region(0.0, Some(0.5))];
        for region in regions {
            let mut other = square();
            other.regions.push(region);
            hashes.push(other.hash());
        }
        let all = hashes.len();
        hashes.sort_by_key(|h| h.0);
        hashes.dedup();
        assert_eq!(hashes.len(), all);
    }

    #[test]
    fn order_and_direction_do_not_count() {
        let mut other = Pslg::from_points([(1.0, 1.0), (0.0, 1.0), (0.0, 0.0), (1.0, 0.0)]);
        other.add_ring([3, 2, 1, 0]);
        assert_eq!(other.hash(), square().hash());
    }
}
