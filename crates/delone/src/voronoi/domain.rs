//! What cells are clipped to: boundaries that have been cleaned, the inside always to their left.

use super::measure::{Measure, Moments};
use crate::{
    ConstrainedDelaunay, ConstrainedTriangulation, DomainRule, Error, HalfEdgeId, Point, Pslg,
    SegmentPolicy, TriangleId, Triangulation, Watch,
};
use std::ops::Range;

/// A bounded part of the plane: a box, or polygons with holes, islands in the holes, and so on.
///
/// ```
/// use delone::{Pslg, voronoi::Domain};
///
/// let mut frame = Pslg::from_points([
///     (0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0), // outline
///     (1.0, 1.0), (3.0, 1.0), (3.0, 3.0), (1.0, 3.0), // hole, in any direction
/// ]);
/// frame.add_ring([0, 1, 2, 3]);
/// frame.add_ring([4, 5, 6, 7]);
/// assert_eq!(Domain::polygon(frame, &())?.measure().area, 12.0);
/// assert_eq!(Domain::rectangle((0.0, 0.0), (3.0, 2.0))?.measure().area, 6.0);
/// # Ok::<(), delone::Error>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct Domain {
    points: Vec<Point>,
    rings: Vec<Boundary>,
}

/// A closed line with the domain to its left.
#[derive(Clone, Debug)]
pub(super) struct Boundary {
    pub points: Range<usize>,
    /// Which connected piece of the domain it bounds.
    pub piece: u32,
    /// Whether it goes around the piece; else it goes around a hole.
    pub is_outer: bool,
}

impl Domain {
    /// Makes a domain of the box between two opposite corners; it is empty if they share a coordinate.
    ///
    /// # Errors
    /// [`Error::NotFinite`] names the corner, 0 or 1, with a coordinate that is NaN or infinite.
    pub fn rectangle(a: impl Into<Point>, b: impl Into<Point>) -> Result<Self, Error> {
        let corners: [Point; 2] = [a.into(), b.into()];
        if let Some(index) = corners.iter().position(|p| !p.is_finite()) {
            let Point { x, y } = corners[index];
            return Err(Error::NotFinite { index, x, y });
        }
        let [a, b] = corners;
        if a.x == b.x || a.y == b.y {
            return Ok(Self::default());
        }
        let (low, high) = (
            Point::new(a.x.min(b.x), a.y.min(b.y)),
            Point::new(a.x.max(b.x), a.y.max(b.y)),
        );
        let points = vec![
            low,
            Point::new(high.x, low.y),
            high,
            Point::new(low.x, high.y),
        ];
        Ok(Self {
            points,
            rings: vec![Boundary {
                points: 0..4,
                piece: 0,
                is_outer: true,
            }],
        })
    }

    /// Makes a domain of what lies behind an odd number of segments, of the union of the
    /// [polygons](Pslg::polygons) if there are any. Segments may repeat, overlap and cross; where they
    /// cross, they are cut, which rounds.
    ///
    /// # Errors
    /// Those of [`ConstrainedDelaunay::triangulate`], but [`Error::Crossing`].
    ///
    /// *Cost*: a constrained triangulation.
    pub fn polygon(outlines: Pslg, watch: &dyn Watch) -> Result<Self, Error> {
        let builder = ConstrainedDelaunay::new()
            .domain(DomainRule::EvenOdd)
            .crossings(SegmentPolicy::Split)
            .watch(watch);
        Ok(Self::of(&builder.triangulate(outlines)?))
    }

    /// Makes a domain of that of a triangulation, under whatever rule it was made.
    pub fn of(result: &ConstrainedTriangulation) -> Self {
        Self::of_triangles(result.triangulation())
    }

    fn of_triangles(t: &Triangulation) -> Self {
        let piece_of = pieces(t);
        let mut is_seen = vec![false; 3 * t.num_triangles()];
        let mut domain = Self::default();
        for h in (0..3 * t.num_triangles()).map(HalfEdgeId::new) {
            if !is_border(t, h) || is_seen[h.index()] {
                continue;
            }
            let start = domain.points.len();
            let mut side = h;
            while !std::mem::replace(&mut is_seen[side.index()], true) {
                domain.points.push(t.point(t.mesh().origin(side)));
                side = next_border(t, side);
            }
            domain.rings.push(Boundary {
                points: start..domain.points.len(),
                piece: piece_of[h.triangle().index()],
                is_outer: false,
            });
        }
        domain.find_outer();
        domain
    }

    /// Finds for each piece the ring around it: the one with the piece's leftmost vertex.
    fn find_outer(&mut self) {
        let leftmost = |ring: &Boundary| {
            let points = self.points[ring.points.clone()].iter().copied();
            points.min_by(Point::lex_cmp).expect("bug: an empty ring")
        };
        let mut order: Vec<usize> = (0..self.rings.len()).collect();
        order.sort_by(|&i, &j| {
            let [p, q] = [i, j].map(|i| &self.rings[i]);
            p.piece
                .cmp(&q.piece)
                .then_with(|| leftmost(p).lex_cmp(&leftmost(q)))
        });
        let mut last = None;
        for i in order {
            let ring = &mut self.rings[i];
            ring.is_outer = last != Some(ring.piece);
            last = Some(ring.piece);
        }
    }

    /// Measures it: area, centroid, perimeter.
    pub fn measure(&self) -> Measure {
        Moments::of(self.boundaries()).finish()
    }

    /// Tells whether there is nothing in it.
    pub fn is_empty(&self) -> bool {
        self.rings.is_empty()
    }

    /// Visits its boundaries, each with the domain to its left: outlines counter-clockwise, holes
    /// clockwise. The last point of each is joined to the first.
    pub fn boundaries(&self) -> impl Iterator<Item = &[Point]> + Clone {
        self.rings
            .iter()
            .map(|ring| &self.points[ring.points.clone()])
    }

    /// Returns the corners of all boundaries.
    pub fn points(&self) -> &[Point] {
        &self.points
    }

    pub(super) fn rings(&self) -> &[Boundary] {
        &self.rings
    }
}

fn is_inside(t: &Triangulation, h: HalfEdgeId) -> bool {
    h.triangle().index() < t.num_triangles()
}

fn is_border(t: &Triangulation, h: HalfEdgeId) -> bool {
    !is_inside(t, t.mesh().twin(h))
}

/// Turns about the end of a side of the border, through the domain, to the next side. So a border that
/// touches itself in a vertex is passed on the inside: its rings bound connected pieces.
fn next_border(t: &Triangulation, side: HalfEdgeId) -> HalfEdgeId {
    let mut h = side.next();
    while !is_border(t, h) {
        h = t.mesh().twin(h).next();
    }
    h
}

/// Numbers the pieces that triangles form across their edges.
fn pieces(t: &Triangulation) -> Vec<u32> {
    const NONE: u32 = u32::MAX;
    let mut piece_of = vec![NONE; t.num_triangles()];
    let mut stack = Vec::new();
    let mut number = 0;
    for first in (0..t.num_triangles()).map(TriangleId::new) {
        if piece_of[first.index()] != NONE {
            continue;
        }
        piece_of[first.index()] = number;
        stack.push(first);
        while let Some(triangle) = stack.pop() {
            for neighbor in t.neighbors(triangle).into_iter().flatten() {
                if piece_of[neighbor.index()] == NONE {
                    piece_of[neighbor.index()] = number;
                    stack.push(neighbor);
                }
            }
        }
        number += 1;
    }
    piece_of
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two squares that touch in a corner, one with a hole that touches its outline.
    #[test]
    fn borders_that_touch_are_told_apart() {
        let mut pslg = Pslg::from_points([
            (0.0, 0.0),
            (4.0, 0.0),
            (4.0, 4.0),
            (0.0, 4.0),
            (6.0, 4.0),
            (6.0, 6.0),
            (4.0, 6.0),
            (1.0, 1.0),
            (2.0, 1.0),
        ]);
        pslg.add_ring([0, 1, 2, 3]);
        pslg.add_ring([2, 4, 5, 6]);
        pslg.add_ring([0, 7, 8]);
        let domain = Domain::polygon(pslg, &()).unwrap();
        assert_eq!(domain.rings().len(), 2);
        assert!(domain.rings().iter().all(|ring| ring.is_outer));
        assert_eq!(domain.measure().area, 16.0 + 4.0 - 0.5);
        let lengths: Vec<usize> = domain.boundaries().map(<[Point]>::len).collect();
        assert_eq!(lengths.iter().sum::<usize>(), 4 + 4 + 3);
    }

    #[test]
    fn boxes_may_be_given_by_any_corners_but_must_be_finite() {
        let measure = |a: (f64, f64), b: (f64, f64)| Domain::rectangle(a, b).map(|d| d.measure());
        assert_eq!(measure((2.0, 0.0), (0.0, 3.0)).unwrap().area, 6.0);
        assert_eq!(measure((2.0, 0.0), (2.0, 3.0)).unwrap().area, 0.0);
        let refused = measure((0.0, 0.0), (f64::INFINITY, 1.0));
        assert!(matches!(refused, Err(Error::NotFinite { index: 1, .. })));
    }
}
