//! Is the border one simple polygon? It need not be convex.

use super::super::domain::{Meeting, find_meeting};
use super::super::{Corner, Defect, Defects, adjacency::Adjacency};
use crate::pace::Pace;
use crate::{Error, Point, VertexId};

/// Reports what keeps the edges with one triangle from being one simple polygon, and counts them.
///
/// No two points may be equal, and edges must have one triangle, or two on different sides.
///
/// As many edges of the border come to a vertex as leave it, since each triangle brings one of either kind, and
/// edges with two triangles take away one of either kind. So if no two leave the same vertex, the border falls into
/// cycles that have no vertex in common.
pub(super) fn check(
    points: &[Point],
    adjacency: &Adjacency,
    pace: &mut Pace,
    defects: &mut Defects,
) -> Result<usize, Error> {
    let edges = edges(adjacency, pace)?;
    let mut next = vec![None; points.len()];
    let mut leaving = vec![0usize; points.len()];
    for &[origin, dest] in &edges {
        pace.step()?;
        next[origin.index()] = Some(dest);
        leaving[origin.index()] += 1;
    }
    let pinched = (0..points.len()).filter(|&v| leaving[v] > 1);
    let before = defects.total();
    for v in pinched {
        let corner = Corner::new(points, VertexId::new(v));
        let times = leaving[v];
        defects.push(Defect::PinchedBorder { corner, times });
    }
    if defects.total() == before {
        let cycles = count_cycles(next, pace)?;
        if cycles != 1 {
            defects.push(Defect::BoundaryCycles { cycles });
        }
    }
    let meeting = find_meeting(points, &edges, pace, defects)?;
    match meeting {
        None => {}
        Some(Meeting::Edges(edges)) => defects.push(Defect::CrossingBorder { edges }),
        Some(Meeting::Point(corner, edge)) => {
            defects.push(Defect::VertexOnBorder { corner, edge });
        }
    }
    Ok(edges.len())
}

/// Lists the edges with one triangle, which lies to their left.
fn edges(adjacency: &Adjacency, pace: &mut Pace) -> Result<Vec<[VertexId; 2]>, Error> {
    let mut edges = Vec::new();
    for h in adjacency.half_edges() {
        pace.step()?;
        if adjacency.twin(h).is_none() {
            edges.push([adjacency.origin(h), adjacency.dest(h)]);
        }
    }
    Ok(edges)
}

/// Counts the cycles that lead from vertex to vertex; each is used up once it is counted.
fn count_cycles(mut next: Vec<Option<VertexId>>, pace: &mut Pace) -> Result<usize, Error> {
    let mut cycles = 0;
    for first in 0..next.len() {
        let mut v = next[first].take();
        cycles += usize::from(v.is_some());
        while let Some(at) = v {
            pace.step()?;
            v = next[at.index()].take();
        }
    }
    Ok(cycles)
}
