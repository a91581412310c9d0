//! Data by the triangles that hold them, and by rings of triangles around one.

use crate::scattered::DataTriangulation;
use crate::{TriangleId, VertexId};
use std::collections::BTreeSet;

/// Who lies beside whom, and who holds what.
pub(super) struct Around {
    /// The triangles beyond the three edges, where there are any.
    neighbors: Vec<[Option<TriangleId>; 3]>,
    /// Where the data of each triangle start, and the end of the last.
    starts: Vec<u32>,
    data: Vec<VertexId>,
}

impl Around {
    /// *Cost*: O(n log n).
    pub fn new(cover: &DataTriangulation) -> Self {
        let (starts, data) = by_holder(cover);
        Self {
            neighbors: neighbors(cover.triangles()),
            starts,
            data,
        }
    }

    /// Returns the data that triangle `t` holds, equal ones once, ascending.
    pub fn data(&self, t: TriangleId) -> &[VertexId] {
        let [start, end] = [0, 1].map(|k| self.starts[t.index() + k] as usize);
        &self.data[start..end]
    }

    /// Begins with triangle `t` alone.
    pub fn rings(&self, t: TriangleId) -> Rings<'_> {
        Rings {
            around: self,
            within: BTreeSet::from([t]),
            last: vec![t],
            data: self.data(t).to_vec(),
        }
    }
}

/// A triangle and rings of neighbours around it: a ring is beyond the edges of the one before.
#[derive(Clone)]
pub(super) struct Rings<'a> {
    around: &'a Around,
    within: BTreeSet<TriangleId>,
    last: Vec<TriangleId>,
    data: Vec<VertexId>,
}

impl Rings<'_> {
    /// Returns the data that the triangle and the rings hold.
    pub fn data(&self) -> &[VertexId] {
        &self.data
    }

    /// Adds a ring; tells whether there is one.
    pub fn widen(&mut self) -> bool {
        let around = self.around;
        let beyond = self.last.iter().flat_map(|t| around.neighbors[t.index()]);
        let beyond = beyond.flatten().filter(|t| self.within.insert(*t));
        self.last = beyond.collect();
        self.data
            .extend(self.last.iter().flat_map(|&t| around.data(t)));
        !self.last.is_empty()
    }
}

/// Finds the triangle beyond each edge.
fn neighbors(triangles: &[[VertexId; 3]]) -> Vec<[Option<TriangleId>; 3]> {
    let ids = (0..triangles.len()).map(TriangleId::new);
    let sides = ids.zip(triangles).flat_map(|(t, &[a, b, c])| {
        let side =
            move |(k, [from, to]): (usize, [VertexId; 2])| (from.min(to), from.max(to), t, k);
        [(0, [a, b]), (1, [b, c]), (2, [c, a])].map(side)
    });
    let mut sides: Vec<_> = sides.collect();
    sides.sort_unstable();
    let mut neighbors = vec![[None; 3]; triangles.len()];
    for pair in sides.windows(2) {
        let [(a, b, t, k), (c, d, u, l)] = [pair[0], pair[1]];
        if (a, b) == (c, d) {
            neighbors[t.index()][k] = Some(u);
            neighbors[u.index()][l] = Some(t);
        }
    }
    neighbors
}

/// Sorts the data, equal ones once, by who holds them.
fn by_holder(cover: &DataTriangulation) -> (Vec<u32>, Vec<VertexId>) {
    let mut starts = vec![0_u32; cover.triangles().len() + 1];
    for (t, count) in cover.counts().into_iter().enumerate() {
        starts[t + 1] = starts[t] + count as u32;
    }
    let mut next = starts.clone();
    let mut data = vec![VertexId::INFINITE; cover.num_data()];
    let mut dropped = cover.duplicates().iter().map(|d| d.dropped).peekable();
    let ids = (0..cover.data().len()).map(VertexId::new);
    for (v, holder) in ids.zip(cover.holders()) {
        if dropped.next_if_eq(&v).is_none() {
            data[next[holder.index()] as usize] = v;
            next[holder.index()] += 1;
        }
    }
    (starts, data)
}
