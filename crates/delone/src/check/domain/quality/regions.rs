//! Which region each triangle lies in.
//!
//! A region is a face of the graph. Triangles that share an edge which is no subsegment lie in one
//! face, and every face has a triangle beside a dart of its border, which knows the face.

use super::super::union::Union;
use super::{Found, half_edges};
use crate::Error;
use crate::pace::Pace;

/// Returns the region of each triangle. *Cost*: near linear.
pub(in super::super) fn find(found: &Found, pace: &mut Pace) -> Result<Vec<Option<usize>>, Error> {
    let Found {
        triangles,
        adjacency,
        borders,
        ..
    } = *found;
    let mut union = Union::new(triangles.len());
    for h in adjacency.half_edges() {
        pace.step()?;
        let twin = adjacency.twin(h).filter(|_| !borders.is_constrained(h));
        if let Some(twin) = twin {
            let [t, u] = [h, twin].map(|h| h.triangle().index() as u32);
            union.join(t, u);
        }
    }
    let parts = union.classes();
    let mut region_of = vec![None; parts.count()];
    for t in 0..triangles.len() {
        pace.step()?;
        for h in half_edges(t) {
            let ends = [adjacency.origin(h), adjacency.dest(h)];
            let [origin, dest] = ends.map(|v| found.graph.places.of(v));
            if let Some(dart) = found.graph.find(origin, dest) {
                region_of[parts.of(t as u32) as usize] = found.area.region_left_of(dart);
            }
        }
    }
    Ok((0..triangles.len())
        .map(|t| region_of[parts.of(t as u32) as usize])
        .collect())
}
