//! Vertices in the order of a space-filling curve: where to begin looking for a point.
//!
//! The curve is Morton's (*A computer oriented geodetic data base and a new technique in file
//! sequencing*, 1966) over the bits of the coordinates, so it needs no frame and knows no largest or
//! smallest coordinate: each power of two is a square of its own size. Neighbours along the curve
//! mostly are neighbours in the plane; that is all that is asked of them. Comparing without mixing the
//! bits is Chan's trick (*Closest-point problems simplified on the RAM*, 2002).
//!
//! *Cost*: O(log n) for everything, about 40 bytes a vertex.

use crate::predicates::squared_length;
use crate::{Point, VertexId};
use std::cmp::Ordering;
use std::collections::BTreeMap;

/// Vertices by their place on the curve.
#[derive(Clone, Debug, Default)]
pub(super) struct Places(BTreeMap<Key, VertexId>);

impl Places {
    /// Begins with vertices of different places.
    pub fn new(vertices: impl Iterator<Item = (Point, VertexId)>) -> Self {
        Self(vertices.map(|(p, v)| (Key::of(p), v)).collect())
    }

    pub fn insert(&mut self, p: Point, v: VertexId) {
        self.0.insert(Key::of(p), v);
    }

    pub fn remove(&mut self, p: Point) {
        self.0.remove(&Key::of(p));
    }

    /// Returns some vertex, if there is one.
    pub fn any(&self) -> Option<VertexId> {
        self.0.first_key_value().map(|(_, &v)| v)
    }

    /// Returns a vertex that probably lies close to `p`: of its two neighbours along the curve the one
    /// that seems closer.
    pub fn near(&self, p: Point, place: impl Fn(VertexId) -> Point) -> Option<VertexId> {
        let key = Key::of(p);
        let after = self.0.range(key..).next();
        let before = self.0.range(..key).next_back();
        let neighbours = [after, before].map(|entry| entry.map(|(_, &v)| v));
        // Rounded, even to infinity: it only says where the walk begins.
        let distance = |v: &VertexId| squared_length([p, place(*v)]);
        let candidates = neighbours.into_iter().flatten();
        candidates.min_by(|v, w| distance(v).total_cmp(&distance(w)))
    }
}

/// The bits of a point's coordinates, such that they are ordered like numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Key([u64; 2]);

impl Key {
    fn of(p: Point) -> Self {
        // Adding zero turns −0.0 into 0.0.
        Self([p.x, p.y].map(|c| ordered_bits(c + 0.0)))
    }
}

fn ordered_bits(c: f64) -> u64 {
    let bits = c.to_bits();
    if c.is_sign_negative() {
        !bits
    } else {
        bits | 1 << 63
    }
}

impl Ord for Key {
    /// The coordinate with the highest bit that differs decides.
    fn cmp(&self, other: &Self) -> Ordering {
        let [dx, dy] = [0, 1].map(|k| self.0[k] ^ other.0[k]);
        let is_lower = dx < dy && dx < dx ^ dy;
        let k = usize::from(is_lower);
        self.0[k].cmp(&other.0[k])
    }
}

impl PartialOrd for Key {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The bits of both coordinates in turns, which need no trick to compare.
    fn mixed(p: Point) -> u128 {
        let Key([x, y]) = Key::of(p);
        let bits = (0..64).rev();
        bits.fold(0, |mixed, i| {
            mixed << 2 | u128::from(x >> i & 1) << 1 | u128::from(y >> i & 1)
        })
    }

    #[test]
    fn the_order_is_that_of_mixed_bits() {
        let numbers = [
            -1e300, -3.0, -1.5, -5e-324, -0.0, 0.0, 5e-324, 0.1, 1.5, 2.0, 3.0, 1e300,
        ];
        let points = numbers.map(|x| numbers.map(|y| Point::new(x, y)));
        for &p in points.as_flattened() {
            for &q in points.as_flattened() {
                assert_eq!(Key::of(p).cmp(&Key::of(q)), mixed(p).cmp(&mixed(q)));
            }
        }
    }

    #[test]
    fn both_zeros_are_one_place() {
        let [p, q] = [Point::new(0.0, 1.0), Point::new(-0.0, 1.0)];
        assert_eq!(Key::of(p), Key::of(q));
    }

    #[test]
    fn a_vertex_is_near_itself_and_its_cell() {
        let lattice: Vec<_> = (0..256)
            .map(|i| Point::new(f64::from(i % 16), f64::from(i / 16)))
            .collect();
        let mut places = Places::new(lattice.iter().copied().zip((0..).map(VertexId::new)));
        let place = |v: VertexId| lattice[v.index()];
        for (i, &p) in lattice.iter().enumerate() {
            assert_eq!(places.near(p, place), Some(VertexId::new(i)));
        }
        places.remove(Point::new(9.0, 9.0));
        let found = places
            .near(Point::new(9.0, 9.0), place)
            .expect("many are left");
        assert!(
            (place(found).x - 9.0)
                .abs()
                .max((place(found).y - 9.0).abs())
                <= 1.0
        );
    }
}
