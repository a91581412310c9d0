//! The mesh as the thesis (Ulm, 2012) keeps it: triangles in slots, and a numbered row for each edge. Of
//! equals, numbers decide what its algorithms do next; so whoever repeats them needs its tables.
//!
//! | in the thesis | here |
//! |---|---|
//! | `triangles` | [`Tables::triangles`]: corners, counter-clockwise |
//! | `edges_with_triangles` | [`Tables::rows`]: the ends, the larger first; where the edge lies in its first and its second triangle |
//! | `triangles_with_edges` | [`Tables::edges_of`]: the rows of a triangle's edges |
//!
//! An edge has position 0, 1 or 2 in a triangle (v₁v₂, v₂v₃, v₃v₁): one less than in print, as all
//! numbers are. In print an edge without a second triangle is a constraint and no other is; here lines
//! within the domain may be constraints, too. [`EdgeTables`] is the printed form.
//!
//! - [`edits`]: the three ways to change them. [`flips`]: `edge_flip`. [`telling`]: both, observed.
//! - [`numbering`]: the tables of a domain, numbered as the thesis would number it.
//! - [`shape`]: lengths, angles and areas as the thesis compares them.
//!
//! *Cost*: O(1) an edit; O(n log n) to make them.

mod edits;
mod flips;
mod numbering;
mod printed;
mod shape;
mod telling;

pub(crate) use flips::{FlipLines, Marks, edge_flip, examine};
pub(crate) use numbering::tables_of;
pub use printed::EdgeTables;
pub(crate) use shape::{Shape, area, circumcenter, length, middle};
pub(crate) use telling::Teller;

use crate::Point;
use crate::predicates::{Orientation, orient2d};

/// Where an edge lies in a triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Side {
    pub triangle: u32,
    pub position: usize,
}

impl Side {
    pub fn new(triangle: u32, position: usize) -> Self {
        Self { triangle, position }
    }

    /// The side after this one, counter-clockwise.
    pub fn next(self) -> Self {
        Self::new(self.triangle, (self.position + 1) % 3)
    }

    /// The side before this one.
    pub fn prev(self) -> Self {
        Self::new(self.triangle, (self.position + 2) % 3)
    }
}

/// An edge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Row {
    /// Its ends, the larger number first.
    pub ends: [u32; 2],
    pub first: Side,
    pub second: Option<Side>,
    pub is_constraint: bool,
    pub length: f64,
}

/// The mesh.
#[derive(Clone, Debug, Default)]
pub(crate) struct Tables {
    pub points: Vec<Point>,
    pub triangles: Vec<[u32; 3]>,
    pub edges_of: Vec<[u32; 3]>,
    pub rows: Vec<Row>,
    /// Triangles and rows that were written, for whoever keeps an order of them.
    pub written: Written,
}

/// What was written since it was last looked at.
#[derive(Clone, Debug, Default)]
pub(crate) struct Written {
    pub triangles: Vec<u32>,
    pub rows: Vec<u32>,
}

impl Tables {
    /// Makes the tables of triangles that are counter-clockwise. Rows are numbered by columns of the
    /// lower triangle of the matrix of edges: by the smaller end, then by the larger.
    pub fn new(
        points: Vec<Point>,
        triangles: Vec<[u32; 3]>,
        is_constraint: impl Fn([u32; 2]) -> bool,
    ) -> Self {
        let mut tables = Self {
            points,
            edges_of: vec![[0; 3]; triangles.len()],
            triangles,
            ..Self::default()
        };
        let sides = numbered(&tables.triangles);
        for run in sides.chunk_by(|a, b| a.0 == b.0) {
            let ([low, high], first) = run[0];
            let second = run.get(1).map(|&(_, side)| side);
            let is_constraint = second.is_none() || is_constraint([high, low]);
            let row = tables.rows.len() as u32;
            tables.set_row(row, [high, low], first, second, is_constraint);
            for &(_, Side { triangle, position }) in run {
                tables.edges_of[triangle as usize][position] = row;
            }
        }
        tables
    }

    /// The ends of a side, in its direction.
    pub fn ends(&self, side: Side) -> [u32; 2] {
        let corners = self.triangles[side.triangle as usize];
        [corners[side.position], corners[side.next().position]]
    }

    /// The corner opposite a side.
    pub fn apex(&self, side: Side) -> u32 {
        self.triangles[side.triangle as usize][side.prev().position]
    }

    pub fn point(&self, v: u32) -> Point {
        self.points[v as usize]
    }

    /// The positions of a triangle's corners.
    pub fn corners(&self, t: u32) -> [Point; 3] {
        self.triangles[t as usize].map(|v| self.point(v))
    }

    pub fn row_of(&self, side: Side) -> u32 {
        self.edges_of[side.triangle as usize][side.position]
    }

    pub fn row(&self, row: u32) -> &Row {
        &self.rows[row as usize]
    }

    /// The same edge in the triangle beyond.
    pub fn across(&self, side: Side) -> Option<Side> {
        let row = self.row(self.row_of(side));
        if row.first == side {
            row.second
        } else {
            Some(row.first)
        }
    }

    /// An edge in its two triangles: first in the one that runs from its larger end to its smaller.
    /// `None`: it has but one.
    pub fn both_sides(&self, row: u32) -> Option<[Side; 2]> {
        let row = self.row(row);
        let (first, second) = (row.first, row.second?);
        Some(match self.ends(first) == row.ends {
            true => [first, second],
            false => [second, first],
        })
    }

    /// The lengths of a triangle's edges, by position.
    pub fn lengths(&self, t: u32) -> [f64; 3] {
        self.edges_of[t as usize].map(|row| self.row(row).length)
    }

    pub fn shape(&self, t: u32) -> Shape {
        Shape::of(self.lengths(t))
    }

    /// Tells whether the angle of a triangle is given by the domain: its two longer edges are
    /// constraints. Of equal shortest edges the one of lowest position counts as the shortest.
    pub fn is_boundary_triangle(&self, t: u32) -> bool {
        let shortest = Side::new(t, self.shape(t).shortest);
        let longer = [shortest.next(), shortest.prev()].map(|side| self.row_of(side));
        longer.iter().all(|&row| self.row(row).is_constraint)
    }

    /// Tells on which side of a triangle's side a point lies; inside is left.
    pub fn orient(&self, side: Side, p: Point) -> Orientation {
        let [a, b] = self.ends(side).map(|v| self.point(v));
        orient2d(a, b, p)
    }

    /// Writes a slot, or the one behind the last.
    fn set_triangle(&mut self, t: u32, corners: [u32; 3], rows: [u32; 3]) {
        if t as usize == self.triangles.len() {
            self.triangles.push(corners);
            self.edges_of.push(rows);
        }
        self.triangles[t as usize] = corners;
        self.edges_of[t as usize] = rows;
        self.written.triangles.push(t);
    }

    /// Writes a row, or the one behind the last.
    fn set_row(
        &mut self,
        row: u32,
        [a, b]: [u32; 2],
        first: Side,
        second: Option<Side>,
        is_constraint: bool,
    ) {
        let content = Row {
            ends: [a.max(b), a.min(b)],
            first,
            second,
            is_constraint,
            length: length(self.point(a), self.point(b)),
        };
        if row as usize == self.rows.len() {
            self.rows.push(content);
        }
        self.rows[row as usize] = content;
        self.written.rows.push(row);
    }
}

/// Lists the sides of triangles with their ends, the smaller first, in the order of the rows: the
/// sides of an edge stand together, that of the lowest triangle first.
fn numbered(triangles: &[[u32; 3]]) -> Vec<([u32; 2], Side)> {
    let corners = (0..).zip(triangles);
    let sides = corners.flat_map(|(t, &[a, b, c])| {
        let ends = [[a, b], [b, c], [c, a]].map(ascending);
        [0, 1, 2].map(|k| (ends[k], Side::new(t, k)))
    });
    let mut sides: Vec<_> = sides.collect();
    sides.sort_by_key(|&(ends, _)| ends);
    sides
}

fn ascending([a, b]: [u32; 2]) -> [u32; 2] {
    [a.min(b), a.max(b)]
}
