//! Is the boundary a convex polygon that is run through once?

use super::{Corner, Defect, Defects, adjacency::Adjacency};
use crate::pace::Pace;
use crate::predicates::{Orientation, orient2d};
use crate::{Error, HalfEdgeId, Point, VertexId};

/// Walks along the boundary, reports what keeps it from being a convex polygon, and counts its edges.
///
/// Where edges have too many triangles there is no boundary to speak of; then nothing is reported,
/// since that has been.
pub(super) fn check(
    points: &[Point],
    adjacency: &Adjacency,
    pace: &mut Pace,
    defects: &mut Defects,
) -> Result<usize, Error> {
    let mut walker = Walker {
        points,
        adjacency,
        seen: vec![false; adjacency.num_half_edges()],
        edges: 0,
        leftmost: 0,
    };
    if adjacency.is_manifold() {
        walker.walk_all(pace, defects)?;
    }
    Ok(walker.edges)
}

struct Walker<'a> {
    points: &'a [Point],
    adjacency: &'a Adjacency<'a>,
    seen: Vec<bool>,
    edges: usize,
    /// Vertices that are smaller than the ones before and after; the number of turns of the walk
    /// if it always turns left.
    leftmost: usize,
}

impl Walker<'_> {
    fn walk_all(&mut self, pace: &mut Pace, defects: &mut Defects) -> Result<(), Error> {
        let mut cycles = 0;
        for h in self.adjacency.half_edges() {
            pace.step()?;
            if self.adjacency.twin(h).is_none() && !self.seen[h.index()] {
                cycles += 1;
                self.walk_cycle(h, pace, defects)?;
            }
        }
        if cycles != 1 {
            defects.push(Defect::BoundaryCycles { cycles });
        } else if self.leftmost != 1 {
            let turns = self.leftmost;
            defects.push(Defect::WindingBoundary { turns });
        }
        Ok(())
    }

    fn walk_cycle(
        &mut self,
        first: HalfEdgeId,
        pace: &mut Pace,
        defects: &mut Defects,
    ) -> Result<(), Error> {
        let mut h = first;
        loop {
            self.seen[h.index()] = true;
            self.edges += 1;
            let next = self.following(h, pace)?;
            let [a, b] = [h, next].map(|h| self.adjacency.origin(h));
            self.pass([a, b, self.adjacency.dest(next)], defects);
            h = next;
            if h == first {
                return Ok(());
            }
        }
    }

    /// Returns the boundary half-edge that starts where `h` ends, at the other side of the fan.
    fn following(&self, h: HalfEdgeId, pace: &mut Pace) -> Result<HalfEdgeId, Error> {
        let mut next = h.next();
        while let Some(twin) = self.adjacency.twin(next) {
            pace.step()?;
            next = twin.next();
        }
        Ok(next)
    }

    /// Judges the corner of the boundary at `b`.
    fn pass(&mut self, [a, b, c]: [VertexId; 3], defects: &mut Defects) {
        let [pa, pb, pc] = [a, b, c].map(|v| self.points[v.index()]);
        let rises = pa.lex_cmp(&pb).is_lt();
        let goes_on_rising = pb.lex_cmp(&pc).is_lt();
        self.leftmost += usize::from(!rises && goes_on_rising);
        let is_convex = match orient2d(pa, pb, pc) {
            Orientation::Left => true,
            Orientation::Right => false,
            Orientation::Collinear => rises == goes_on_rising,
        };
        if !is_convex {
            let corners = [a, b, c].map(|v| Corner::new(self.points, v));
            defects.push(Defect::DentedHull { corners });
        }
    }
}
