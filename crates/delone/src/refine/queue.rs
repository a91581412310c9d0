//! The bad-triangle queue: buckets of nearly equal keys, the last one in comes out first.
//!
//! *Cost*: constant for each triangle, whatever their number.

use crate::{TriangleId, VertexId};

/// How many of the leading bits of a key its bucket is named by: the exponent, and three more.
const KEY_BITS: u32 = 14;
const NUM_BUCKETS: usize = 1 << KEY_BITS;

/// Marks the end of a list.
const NONE: u32 = u32::MAX;

/// Triangles by a positive key, the least first, up to a factor of 2^(1/8).
pub(super) struct Queue {
    /// The topmost entry of each bucket.
    tops: Vec<u32>,
    /// A bit for each bucket that is not empty, and a bit for each such word.
    words: [u64; NUM_BUCKETS / 64],
    summary: [u64; NUM_BUCKETS / 64 / 64],
    entries: Vec<Entry>,
    /// Entries that are free again.
    free: u32,
    len: usize,
}

#[derive(Clone, Copy)]
struct Entry {
    triangle: TriangleId,
    /// A triangle that has changed in the meantime has other corners.
    corners: [VertexId; 3],
    below: u32,
}

impl Queue {
    pub fn new() -> Self {
        Self {
            tops: vec![NONE; NUM_BUCKETS],
            words: [0; _],
            summary: [0; _],
            entries: Vec::new(),
            free: NONE,
            len: 0,
        }
    }

    /// Counts the entries, also of triangles that are no more.
    pub fn len(&self) -> usize {
        self.len
    }

    /// Adds triangle `t` with its corners.
    #[inline]
    pub fn push(&mut self, key: f64, t: TriangleId, corners: [VertexId; 3]) {
        let bucket = (key.to_bits() >> (63 - KEY_BITS)) as usize & (NUM_BUCKETS - 1);
        let entry = Entry {
            triangle: t,
            corners,
            below: self.tops[bucket],
        };
        let i = self.free;
        if i == NONE {
            self.tops[bucket] = self.entries.len() as u32;
            self.entries.push(entry);
        } else {
            self.free = self.entries[i as usize].below;
            self.entries[i as usize] = entry;
            self.tops[bucket] = i;
        }
        self.words[bucket / 64] |= 1 << (bucket % 64);
        self.summary[bucket / 64 / 64] |= 1 << (bucket / 64 % 64);
        self.len += 1;
    }

    /// Takes the triangle of least key, with the corners it had when it was pushed.
    pub fn pop(&mut self) -> Option<(TriangleId, [VertexId; 3])> {
        let s = self.summary.iter().position(|&s| s != 0)?;
        let w = 64 * s + self.summary[s].trailing_zeros() as usize;
        let bucket = 64 * w + self.words[w].trailing_zeros() as usize;
        let i = self.tops[bucket];
        let entry = self.entries[i as usize];
        self.tops[bucket] = entry.below;
        if entry.below == NONE {
            self.words[w] &= !(1 << (bucket % 64));
            if self.words[w] == 0 {
                self.summary[s] &= !(1 << (w % 64));
            }
        }
        self.entries[i as usize].below = self.free;
        self.free = i;
        self.len -= 1;
        Some((entry.triangle, entry.corners))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn least_comes_first_and_of_equals_the_last() {
        let mut queue = Queue::new();
        let corners = [0, 1, 2].map(VertexId::new);
        let keys = [3.0, 1e-30, 7e20, 3.0, 1e-30, 0.0, f64::MAX];
        for (i, key) in keys.into_iter().enumerate() {
            queue.push(key, TriangleId::new(i), corners);
        }
        assert_eq!(queue.len(), 7);
        let order: Vec<usize> = std::iter::from_fn(|| queue.pop())
            .map(|(t, _)| t.index())
            .collect();
        assert_eq!(order, [5, 4, 1, 3, 0, 2, 6]);
        assert_eq!((queue.len(), queue.pop()), (0, None));
        queue.push(2.0, TriangleId::new(9), corners);
        assert_eq!(queue.pop(), Some((TriangleId::new(9), corners)));
    }
}
