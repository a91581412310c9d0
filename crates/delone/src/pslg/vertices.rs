//! The vertices of a noding: the points of the input, and those added where segments cross.

use super::meeting::Ends;
use crate::{Point, Watch};
use std::collections::HashMap;

/// Where vertices lie.
pub(super) struct Vertices<'a> {
    input: &'a [Point],
    pub added: Vec<Point>,
}

impl<'a> Vertices<'a> {
    pub fn new(input: &'a [Point]) -> Self {
        let added = Vec::new();
        Self { input, added }
    }

    /// Counts the vertices, equal points of the input included.
    pub fn len(&self) -> usize {
        self.input.len() + self.added.len()
    }

    /// Counts the points of the input.
    pub fn num_input(&self) -> usize {
        self.input.len()
    }

    #[inline]
    pub fn at(&self, v: u32) -> Point {
        match self.input.get(v as usize) {
            Some(&p) => p,
            None => self.added[v as usize - self.input.len()],
        }
    }

    /// Tells whether a vertex on the line of a segment lies strictly between its ends.
    #[inline]
    pub fn is_inside(&self, [a, b]: Ends, v: u32) -> bool {
        let [a, b, p] = [a, b, v].map(|v| self.at(v));
        a.lex_cmp(&p).is_lt() && p.lex_cmp(&b).is_lt()
    }

    /// Returns the ends of a segment, the lexicographically smaller first.
    #[inline]
    pub fn sorted(&self, [a, b]: [u32; 2]) -> Ends {
        if self.at(a).lex_cmp(&self.at(b)).is_lt() {
            [a, b]
        } else {
            [b, a]
        }
    }
}

/// Finds vertices by their coordinates. Only looked up in, so its order plays no part.
pub(super) struct Index(HashMap<[u64; 2], u32>);

impl Index {
    /// Enters distinct vertices; `None` if the watch cancelled.
    pub fn new(
        vertices: &Vertices,
        list: impl ExactSizeIterator<Item = u32>,
        watch: &dyn Watch,
    ) -> Option<Self> {
        /// Entries between two looks at the watch.
        const STRIDE: usize = 1 << 14;
        let mut index = Self(HashMap::with_capacity(list.len()));
        for (i, v) in list.enumerate() {
            if i.is_multiple_of(STRIDE) && watch.is_cancelled() {
                return None;
            }
            index.insert(vertices.at(v), v);
        }
        Some(index)
    }

    pub fn insert(&mut self, p: Point, v: u32) {
        self.0.insert(key(p), v);
    }

    pub fn get(&self, p: Point) -> Option<u32> {
        self.0.get(&key(p)).copied()
    }
}

/// The bits of the coordinates, those of −0.0 the same as those of 0.0.
fn key(p: Point) -> [u64; 2] {
    [p.x, p.y].map(|c| (c + 0.0).to_bits())
}
