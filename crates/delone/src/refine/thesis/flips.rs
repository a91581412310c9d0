//! `edge_flip`: marked edges are examined, the lowest number first, until none is marked.

use super::tables::Tables;
use crate::predicates::in_circle_perturbed;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// The edges still to be examined, as rows.
#[derive(Clone, Debug, Default)]
pub(super) struct Marks {
    is_marked: Vec<bool>,
    lowest: BinaryHeap<Reverse<u32>>,
}

impl Marks {
    pub fn add(&mut self, rows: impl IntoIterator<Item = u32>) {
        for row in rows {
            let needed = row as usize + 1;
            if self.is_marked.len() < needed {
                self.is_marked.resize(needed, false);
            }
            if !std::mem::replace(&mut self.is_marked[row as usize], true) {
                self.lowest.push(Reverse(row));
            }
        }
    }

    fn take(&mut self) -> Option<u32> {
        let Reverse(row) = self.lowest.pop()?;
        self.is_marked[row as usize] = false;
        Some(row)
    }
}

/// Makes every edge locally Delaunay that is no constraint; `told` hears of the ends of each edge
/// examined, and of the edge that has taken its place, if one has.
///
/// The thesis leaves four points on a circle alone; here the symbolic perturbation decides, so that the
/// outcome is canonical and does not depend on the order.
///
/// *Cost*: O(log n) for each edge examined; a flip causes four more.
pub(super) fn edge_flip(
    tables: &mut Tables,
    marks: &mut Marks,
    mut told: impl FnMut([u32; 2], Option<[u32; 2]>),
) {
    while let Some(row) = marks.take() {
        let ends = tables.row(row).ends;
        let must_flip = must_flip(tables, row);
        if must_flip {
            marks.add(tables.flip(row));
        }
        told(ends, must_flip.then(|| tables.row(row).ends));
    }
}

fn must_flip(tables: &Tables, row: u32) -> bool {
    let row = tables.row(row);
    let Some(second) = row.second.filter(|_| !row.is_constraint) else {
        return false;
    };
    let [a, b] = tables.ends(row.first);
    let corners = [a, b, tables.apex(row.first), tables.apex(second)];
    let [a, b, c, d] = corners.map(|v| tables.point(v));
    in_circle_perturbed(a, b, c, d)
}
