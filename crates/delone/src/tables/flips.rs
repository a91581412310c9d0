//! `edge_flip`: marked edges are examined, the lowest number first, until none is marked.

use super::{Tables, Teller, ascending};
use crate::observe::{Item, Queue};
use crate::predicates::{in_circle, in_circle_perturbed};
use crate::{Event, Observer};
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// The edges still to be examined, as rows.
#[derive(Clone, Debug, Default)]
pub(crate) struct Marks {
    is_marked: Vec<bool>,
    lowest: BinaryHeap<Reverse<u32>>,
}

impl Marks {
    /// Marks edges.
    pub fn add<O: Observer>(
        &mut self,
        rows: impl IntoIterator<Item = u32>,
        tables: &Tables,
        teller: &mut Teller<O>,
    ) {
        for row in rows {
            let needed = row as usize + 1;
            if self.is_marked.len() < needed {
                self.is_marked.resize(needed, false);
            }
            if !std::mem::replace(&mut self.is_marked[row as usize], true) {
                self.lowest.push(Reverse(row));
                let queue = Queue::Suspects;
                teller.tell(|names| Event::Pushed {
                    queue,
                    item: Item::Edge(names.of(ascending(tables.row(row).ends))),
                });
            }
        }
    }

    fn take(&mut self) -> Option<u32> {
        let Reverse(row) = self.lowest.pop()?;
        self.is_marked[row as usize] = false;
        Some(row)
    }
}

/// Which lines of pseudocode flip.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FlipLines {
    /// A mark is taken.
    pub take: u16,
    /// Its edge is examined.
    pub examine: u16,
    /// It is flipped, and others are marked.
    pub flip: u16,
}

/// Makes every edge locally Delaunay that is no constraint.
///
/// The thesis leaves four points on a circle alone; here the symbolic perturbation decides, so that the
/// outcome is canonical and does not depend on the order.
///
/// *Cost*: O(log n) for each edge examined; a flip causes four more.
pub(crate) fn edge_flip<O: Observer>(
    tables: &mut Tables,
    marks: &mut Marks,
    teller: &mut Teller<O>,
    lines: FlipLines,
) {
    while examine(tables, marks, teller, lines) {}
}

/// Does so for the marked edge of lowest number; `false`: none is marked.
pub(crate) fn examine<O: Observer>(
    tables: &mut Tables,
    marks: &mut Marks,
    teller: &mut Teller<O>,
    lines: FlipLines,
) -> bool {
    let Some(row) = marks.take() else {
        return false;
    };
    let queue = Queue::Suspects;
    let from = tables.row(row).ends;
    teller.at(lines.take);
    teller.tell(|names| Event::Popped {
        queue,
        item: Item::Edge(names.of(ascending(from))),
    });
    teller.at(lines.examine);
    teller.tell(|names| Event::EdgeExamined {
        edge: names.of(from),
    });
    if must_flip(tables, row, teller) {
        let suspects = tables.flip(row);
        let to = tables.row(row).ends;
        teller.at(lines.flip);
        teller.tell(|names| Event::EdgeFlipped {
            from: names.of(from),
            to: names.of(to),
        });
        marks.add(suspects, tables, teller);
    }
    true
}

/// Tells whether an edge is no constraint, and the corner beyond lies in the circle of its triangle.
fn must_flip<O: Observer>(tables: &Tables, row: u32, teller: &mut Teller<O>) -> bool {
    let edge = tables.row(row);
    let Some(second) = edge.second.filter(|_| !edge.is_constraint) else {
        return false;
    };
    let [a, b] = tables.ends(edge.first);
    let corners = [a, b, tables.apex(edge.first), tables.apex(second)];
    let [a, b, c, d] = corners.map(|v| tables.point(v));
    let is_inside = in_circle_perturbed(a, b, c, d);
    teller.tell(|names| {
        let answer = in_circle(a, b, c, d);
        let [a, b, c, point] = names.of(corners);
        // The triangle that runs from the larger end.
        let (triangle, point) = match edge.ends[0] == corners[0] {
            true => ([a, b, c], point),
            false => ([b, a, point], c),
        };
        Event::CircleTested {
            triangle,
            point,
            answer,
            is_inside,
        }
    });
    is_inside
}
