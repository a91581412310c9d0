//! Are the triangles around each vertex one fan or one cycle?
//!
//! The proof does not need it, but a vertex where two parts touch explains other defects.

use super::{Corner, Defect, Defects, adjacency::Adjacency};
use crate::pace::Pace;
use crate::{Error, HalfEdgeId, Point, VertexId};

/// Reports the vertices whose triangles fall into several parts.
///
/// *Cost*: linear.
pub(super) fn check(
    points: &[Point],
    adjacency: &Adjacency,
    pace: &mut Pace,
    defects: &mut Defects,
) -> Result<(), Error> {
    if !adjacency.is_manifold() {
        return Ok(());
    }
    let mut stars = vec![Star::default(); points.len()];
    for h in adjacency.half_edges() {
        pace.step()?;
        stars[adjacency.origin(h).index()].add(h, adjacency.twin(h).is_none());
    }
    for (v, star) in stars.iter().enumerate() {
        let reached = star.reach(adjacency, pace)?;
        if reached != star.triangles {
            defects.push(Defect::SplitStar {
                corner: Corner::new(points, VertexId::new(v)),
                reached,
                triangles: star.triangles,
            });
        }
    }
    Ok(())
}

/// The triangles around one vertex.
#[derive(Clone, Default)]
struct Star {
    triangles: usize,
    /// Where to begin: at the clockwise end of a fan, if there is one.
    first: Option<HalfEdgeId>,
}

impl Star {
    fn add(&mut self, h: HalfEdgeId, is_end: bool) {
        self.triangles += 1;
        if is_end || self.first.is_none() {
            self.first = Some(h);
        }
    }

    /// Counts the triangles that can be reached from the first across edges.
    fn reach(&self, adjacency: &Adjacency, pace: &mut Pace) -> Result<usize, Error> {
        let mut reached = 0;
        let mut current = self.first;
        while let Some(h) = current {
            pace.step()?;
            reached += 1;
            current = adjacency.onext(h).filter(|&next| Some(next) != self.first);
        }
        Ok(reached)
    }
}
