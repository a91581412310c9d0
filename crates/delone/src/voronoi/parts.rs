//! Cells that have been cut out: polygons with holes, all in a few long lists.

use super::measure::{Measure, Moments};
use crate::Point;
use std::ops::Range;

/// The parts of cells, each an outline and its holes.
#[derive(Clone, Debug)]
pub(crate) struct Shapes {
    points: Vec<Point>,
    /// Where each ring begins, and the end of the last; likewise the rings of each part, and the parts
    /// of each cell.
    rings: Vec<usize>,
    parts: Vec<usize>,
    cells: Vec<usize>,
}

impl Default for Shapes {
    fn default() -> Self {
        Self {
            points: Vec::new(),
            rings: vec![0],
            parts: vec![0],
            cells: vec![0],
        }
    }
}

impl Shapes {
    /// Adds a ring to the part that is being made.
    pub fn add_ring(&mut self, ring: &[Point]) {
        self.points.extend_from_slice(ring);
        self.rings.push(self.points.len());
    }

    pub fn end_part(&mut self) {
        self.parts.push(self.rings.len() - 1);
    }

    pub fn end_cell(&mut self) {
        self.cells.push(self.parts.len() - 1);
    }

    /// Adds the cells of others behind these.
    pub fn append(&mut self, others: &Self) {
        append(&mut self.rings, &others.rings);
        append(&mut self.parts, &others.parts);
        append(&mut self.cells, &others.cells);
        self.points.extend_from_slice(&others.points);
    }

    /// Visits the parts of a cell.
    pub fn parts(&self, cell: usize) -> impl ExactSizeIterator<Item = Part<'_>> + Clone {
        (self.cells[cell]..self.cells[cell + 1]).map(|part| Part {
            shapes: self,
            rings: self.parts[part]..self.parts[part + 1],
        })
    }
}

/// Adds where more things end to a list that begins with 0.
fn append(ends: &mut Vec<usize>, more: &[usize]) {
    let before = ends[ends.len() - 1];
    ends.extend(more[1..].iter().map(|end| before + end));
}

/// A connected part of a clipped cell: a polygon, perhaps with holes.
#[derive(Clone, Debug)]
pub struct Part<'a> {
    shapes: &'a Shapes,
    rings: Range<usize>,
}

impl<'a> Part<'a> {
    /// Returns the outline, counter-clockwise; its last point is joined to the first.
    pub fn outline(&self) -> &'a [Point] {
        self.ring(self.rings.start)
    }

    /// Visits the holes, clockwise.
    pub fn holes(&self) -> impl ExactSizeIterator<Item = &'a [Point]> + Clone + use<'a> {
        let part = self.clone();
        (self.rings.start + 1..self.rings.end).map(move |ring| part.ring(ring))
    }

    /// Visits the outline and the holes.
    pub fn rings(&self) -> impl ExactSizeIterator<Item = &'a [Point]> + Clone + use<'a> {
        let part = self.clone();
        self.rings.clone().map(move |ring| part.ring(ring))
    }

    /// Measures the part, in rounded numbers.
    pub fn measure(&self) -> Measure {
        Moments::of(self.rings()).finish()
    }

    fn ring(&self, ring: usize) -> &'a [Point] {
        let Shapes { points, rings, .. } = self.shapes;
        &points[rings[ring]..rings[ring + 1]]
    }
}
