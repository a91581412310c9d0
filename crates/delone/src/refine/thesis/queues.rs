//! What is next: the longest edge, the skinniest triangle. Entries are never removed but recognised as
//! stale when they come up.

use crate::tables::Tables;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Edges longer than a bound, the longest first, of equals that of the lowest row.
pub(super) struct LongEdges {
    bound: f64,
    // Positive floats are ordered like their bits.
    heap: BinaryHeap<(u64, Reverse<u32>)>,
}

impl LongEdges {
    pub fn new(tables: &mut Tables, bound: f64) -> Self {
        let mut all = Self {
            bound,
            heap: BinaryHeap::new(),
        };
        tables.written.rows = (0..tables.rows.len() as u32).collect();
        all.update(tables);
        all
    }

    /// Takes note of the rows written since the last time.
    pub fn update(&mut self, tables: &mut Tables) {
        for row in std::mem::take(&mut tables.written).rows {
            let length = tables.row(row).length;
            if length > self.bound {
                self.heap.push((length.to_bits(), Reverse(row)));
            }
        }
    }

    /// Takes the next row.
    pub fn take(&mut self, tables: &Tables) -> Option<u32> {
        while let Some((length, Reverse(row))) = self.heap.pop() {
            if tables.row(row).length.to_bits() == length {
                return Some(row);
            }
        }
        None
    }

    pub fn len(&self) -> usize {
        self.heap.len()
    }
}

/// The key of a triangle in one of the orders below, the greatest first: the bits of its cosine and of
/// a length, its number, and how often its slot had been written.
type Key<L> = (u64, L, Reverse<u32>, u32);

/// Triangles that are to be opened.
pub(super) struct Skinny {
    /// The cosine of the smallest angle wanted.
    cosine: f64,
    /// How often each slot was written.
    versions: Vec<u32>,
    by_longest: BinaryHeap<Key<u64>>,
    by_shortest: BinaryHeap<Key<Reverse<u64>>>,
}

impl Skinny {
    pub fn new(tables: &mut Tables, cosine: f64) -> Self {
        let mut all = Self {
            cosine,
            versions: Vec::new(),
            by_longest: BinaryHeap::new(),
            by_shortest: BinaryHeap::new(),
        };
        tables.written.triangles = (0..tables.triangles.len() as u32).collect();
        all.update(tables);
        all
    }

    /// Takes note of the triangles written since the last time. Those whose angle is given by the
    /// domain do not count.
    pub fn update(&mut self, tables: &mut Tables) {
        let mut written = std::mem::take(&mut tables.written).triangles;
        written.sort_unstable();
        written.dedup();
        self.versions.resize(tables.triangles.len(), 0);
        for t in written {
            let version = &mut self.versions[t as usize];
            *version = version.wrapping_add(1);
            let shape = tables.shape(t);
            if shape.cosine > self.cosine && !tables.is_boundary_triangle(t) {
                let lengths = tables.lengths(t);
                let [shortest, longest] =
                    [shape.shortest, shape.longest].map(|k| lengths[k].to_bits());
                let cosine = shape.cosine.to_bits();
                let (number, version) = (Reverse(t), *version);
                self.by_longest.push((cosine, longest, number, version));
                let shortest = Reverse(shortest);
                self.by_shortest.push((cosine, shortest, number, version));
            }
        }
    }

    /// Finds the triangle to open next: the skinniest; of equals the one with the longest edge.
    pub fn skinniest(&mut self) -> Option<u32> {
        first_current(&mut self.by_longest, &self.versions)
    }

    /// Finds the triangle whose area counts: the skinniest; of equals the one with the shortest edge.
    pub fn smallest(&mut self) -> Option<u32> {
        first_current(&mut self.by_shortest, &self.versions)
    }
}

/// Finds the greatest key that is not stale, and leaves it: opening a triangle need not change it.
fn first_current<L: Ord>(heap: &mut BinaryHeap<Key<L>>, versions: &[u32]) -> Option<u32> {
    while let Some(&(_, _, Reverse(t), version)) = heap.peek() {
        if versions[t as usize] == version {
            return Some(t);
        }
        heap.pop();
    }
    None
}

/// Finds the triangle that [`Skinny::smallest`] would find if every triangle counted.
pub(super) fn smallest_of_all(tables: &Tables) -> Option<u32> {
    let key = |&t: &u32| {
        let shape = tables.shape(t);
        let shortest = tables.lengths(t)[shape.shortest];
        (
            shape.cosine.to_bits(),
            Reverse(shortest.to_bits()),
            Reverse(t),
        )
    };
    (0..tables.triangles.len() as u32).max_by_key(key)
}
