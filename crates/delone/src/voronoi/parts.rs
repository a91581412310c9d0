//! Cells that have been cut out: polygons with holes, all in a few long lists.

use super::measure::{Measure, Moments, doubled_area};
use crate::memory::reserve;
use crate::{Point, VertexId};
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
    /// For each site its place among the cells.
    pub ranks: Vec<u32>,
}

impl Default for Shapes {
    fn default() -> Self {
        Self {
            points: Vec::new(),
            rings: vec![0],
            parts: vec![0],
            cells: vec![0],
            ranks: Vec::new(),
        }
    }
}

impl Shapes {
    /// Begins with no cells; makes room for some.
    pub fn with_capacity(cells: usize) -> Self {
        let ends = || {
            let mut ends = reserve(cells + 1);
            ends.push(0);
            ends
        };
        Self {
            // A cell has 6 corners on average, if one counts infinity.
            points: reserve(6 * cells),
            rings: ends(),
            parts: ends(),
            cells: ends(),
            ranks: Vec::new(),
        }
    }

    /// Adds corners to the ring that is being made.
    pub fn extend(&mut self, corners: impl Iterator<Item = Point>) {
        self.points.extend(corners);
    }

    /// Ends the ring that is being made and the part, of which it is all, if the ring, without repeated
    /// points, has an area; else drops it.
    pub fn end_simple_part(&mut self) {
        let start = self.rings[self.rings.len() - 1];
        let len = without_repeated(&mut self.points[start..]);
        self.points.truncate(start + len);
        if len >= 3 && doubled_area(&self.points[start..]) > 0.0 {
            self.rings.push(self.points.len());
            self.end_part();
        } else {
            self.points.truncate(start);
        }
    }

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

    /// Says which sites the cells are of.
    pub fn number(&mut self, order: &[VertexId]) {
        self.ranks = vec![0; order.len()];
        for (rank, site) in (0..).zip(order) {
            self.ranks[site.index()] = rank;
        }
    }

    /// Visits the parts of the cell of a site.
    pub fn parts(&self, site: VertexId) -> impl ExactSizeIterator<Item = Part<'_>> + Clone {
        let cell = self.ranks[site.index()] as usize;
        (self.cells[cell]..self.cells[cell + 1]).map(|part| Part {
            shapes: self,
            rings: self.parts[part]..self.parts[part + 1],
        })
    }
}

/// Moves the points of a closed ring that differ from those before them to the front, and returns how many
/// they are.
pub(super) fn without_repeated(ring: &mut [Point]) -> usize {
    let mut len = 0;
    for i in 0..ring.len() {
        if len == 0 || ring[i] != ring[len - 1] {
            ring[len] = ring[i];
            len += 1;
        }
    }
    while len > 1 && ring[0] == ring[len - 1] {
        len -= 1;
    }
    len
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ring_repeats_no_point() {
        let of = |xs: &[i32]| {
            let mut ring: Vec<_> = xs.iter().map(|&x| Point::new(f64::from(x), 0.0)).collect();
            let len = without_repeated(&mut ring);
            ring.truncate(len);
            ring.iter().map(|p| p.x as i32).collect::<Vec<_>>()
        };
        assert!(of(&[]).is_empty());
        assert_eq!(of(&[7, 7, 7]), [7]);
        assert_eq!(of(&[1, 2, 2, 3, 1, 1]), [1, 2, 3]);
        assert_eq!(of(&[1, 2, 1, 3]), [1, 2, 1, 3]);
    }

    #[test]
    fn a_ring_without_area_is_dropped() {
        let mut shapes = Shapes::with_capacity(2);
        let corners = [(0.0, 0.0), (1.0, 0.0), (2.0, 0.0)].map(Point::from);
        shapes.extend(corners.into_iter());
        shapes.end_simple_part();
        shapes.end_cell();
        let corners = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0)].map(Point::from);
        shapes.extend(corners.into_iter());
        shapes.end_simple_part();
        shapes.end_cell();
        // The second cell is that of site 0.
        shapes.number(&[1.into(), 0.into()]);
        assert_eq!(shapes.parts(1.into()).len(), 0);
        let outlines: Vec<_> = shapes.parts(0.into()).map(|part| part.outline()).collect();
        assert_eq!(outlines, [corners]);
    }
}
