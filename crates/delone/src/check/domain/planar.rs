//! Do some edges meet at ends only? The [sweep](super::sweep), for who has edges and no segments.

use super::super::{Corner, Defects};
use super::edges;
use super::graph::{Dart, Graph};
use super::places::Places;
use super::sweep::{self, Conflict};
use crate::pace::Pace;
use crate::{Error, Point, VertexId};

/// Where edges meet that must not.
pub(in super::super) enum Meeting {
    /// Two cross, or overlap.
    Edges([[Corner; 2]; 2]),
    /// A point lies inside one.
    Point(Corner, [Corner; 2]),
}

/// Finds two edges that share more than an end, or a point inside an edge, if there are any.
///
/// No two points may be equal, and no edge may be listed twice; ends must be indices of points. What else is wrong
/// with edges is a defect.
///
/// *Cost*: O(n log n) for n points, used or not, and edges.
pub(in super::super) fn find_meeting(
    points: &[Point],
    edges: &[[VertexId; 2]],
    pace: &mut Pace,
    defects: &mut Defects,
) -> Result<Option<Meeting>, Error> {
    let before = defects.total();
    edges::check_ends(points, edges, pace, defects)?;
    if defects.total() > before {
        return Ok(None);
    }
    let places = Places::find(points, pace)?;
    let (edges, _) = edges::collect(&places, edges, false, pace)?;
    let graph = Graph::new(&places, edges, pace)?;
    let corners = |edge: usize| graph.corners(Dart::rightward(edge));
    let found = sweep::sweep(&graph, &[], pace)?;
    Ok(found.err().map(|conflict| match conflict {
        Conflict::Edges(edges) => Meeting::Edges(edges.map(corners)),
        Conflict::Place(place, inside) => Meeting::Point(places.corner(place), corners(inside)),
    }))
}
