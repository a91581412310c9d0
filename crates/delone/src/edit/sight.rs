//! What lies between two vertices: a straight walk, from edge to edge and from vertex to vertex.
//!
//! *Cost*: an orientation test for each edge crossed, and the degree of each vertex passed.

use crate::constrained::{Ahead, Draft};
use crate::predicates::{Orientation, orient2d};
use crate::{HalfEdgeId, Point, VertexId};

/// Finds the first constrained edge that the open segment between two vertices crosses.
pub(super) fn first_in_the_way(draft: &Draft, [a, b]: [VertexId; 2]) -> Option<HalfEdgeId> {
    let ends = [a, b].map(|v| draft.point(v));
    let mut v = a;
    while v != b {
        v = match draft.ahead(v, ends[1]) {
            Ahead::Along(h) => draft.mesh.dest(h),
            Ahead::Across(h) => match cross(draft, ends, h) {
                Ok(next) => next,
                Err(constrained) => return Some(constrained),
            },
            Ahead::Outside => unreachable!("bug: a vertex outside the convex hull"),
        };
    }
    None
}

/// Goes on from the open edge of `h` to the next vertex on the line of sight, unless a constrained edge
/// comes first.
///
/// ```text
///            w                  h runs from r to l; w lies to the left of the line of sight, which
///          /   \                then leaves by rw, to its right, or upon it
///        l ----- r
///         \ h→  /
/// ```
fn cross(draft: &Draft, [a, b]: [Point; 2], mut h: HalfEdgeId) -> Result<VertexId, HalfEdgeId> {
    let mesh = &draft.mesh;
    loop {
        if draft.marks.is_constrained(h) {
            return Err(h);
        }
        let beyond = mesh.twin(h);
        let w = mesh.apex(beyond);
        h = match orient2d(a, b, draft.point(w)) {
            Orientation::Left => beyond.next(),
            Orientation::Right => beyond.prev(),
            Orientation::Collinear => return Ok(w),
        };
    }
}
