//! What of a triangulation is Delaunay already, and what to do if it is not: for whoever asks about points
//! and is handed segments and holes.

use crate::pace::Pace;
use crate::predicates::in_circle_perturbed;
use crate::{Delaunay, Error, HalfEdgeId, Phase, Triangulation, Watch};
use std::borrow::Cow;

/// Returns *the* Delaunay triangulation of all vertices of `t`, segments and holes forgotten, vertices
/// numbered alike: `t` itself, carved faces included, unless some edge is not Delaunay.
///
/// # Errors
/// [`Error::Cancelled`] if the watch says so; [`Error::Threads`] if they cannot be started.
///
/// *Cost*: one in-circle test for each edge, and a triangulation if one of them fails.
pub(crate) fn of_vertices<'t>(
    t: &'t Triangulation,
    watch: &dyn Watch,
) -> Result<Cow<'t, Triangulation>, Error> {
    if is_delaunay(t, watch)? {
        return Ok(Cow::Borrowed(t));
    }
    let points = t.points().iter().copied();
    Ok(Cow::Owned(
        Delaunay::new().watch(watch).triangulate(points)?,
    ))
}

/// Tells whether every edge is locally Delaunay, ties included; so the whole is Delaunay (Lawson 1977), as
/// faces and carved faces cover the convex hull.
fn is_delaunay(t: &Triangulation, watch: &dyn Watch) -> Result<bool, Error> {
    let mesh = t.mesh();
    let mut pace = Pace::new(watch, Phase::Check, 3 * mesh.num_faces() as u64);
    for h in mesh.half_edges() {
        pace.step()?;
        if h < mesh.twin(h) && !is_locally_delaunay(t, h) {
            return Ok(false);
        }
    }
    pace.finish();
    Ok(true)
}

fn is_locally_delaunay(t: &Triangulation, h: HalfEdgeId) -> bool {
    let mesh = t.mesh();
    let beyond = mesh.twin(h);
    if [h, beyond].iter().any(|h| mesh.is_ghost(h.triangle())) {
        return true;
    }
    let [a, b, c] = mesh.corners(h.triangle()).map(|v| t.point(v));
    !in_circle_perturbed(a, b, c, t.point(mesh.apex(beyond)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{ConstrainedDelaunay, DomainRule, Pslg};

    /// A square with a hole in it and a forced edge, which is Delaunay or not.
    #[test]
    fn what_is_not_delaunay_is_triangulated_anew() {
        let points = [(0.0, 0.0), (3.0, 0.0), (4.0, 4.0), (0.0, 3.0)];
        let free = crate::triangulate(points).unwrap();
        for (diagonal, is_kept) in [([1, 3], true), ([0, 2], false)] {
            let mut pslg = Pslg::from_points(points);
            pslg.add_segment(diagonal[0], diagonal[1]);
            let t = ConstrainedDelaunay::new().triangulate(pslg).unwrap();
            let found = of_vertices(t.triangulation(), &()).unwrap();
            assert_eq!(matches!(found, Cow::Borrowed(_)), is_kept);
            assert_eq!(found.hash(), free.hash());
        }
    }

    /// Of a square one diagonal is the right one, though both are Delaunay.
    #[test]
    fn ties_count() {
        let points = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)];
        let kept = [[0, 2], [1, 3]].map(|[a, b]| {
            let mut pslg = Pslg::from_points(points);
            pslg.add_segment(a, b);
            let t = ConstrainedDelaunay::new().triangulate(pslg).unwrap();
            matches!(of_vertices(t.triangulation(), &()), Ok(Cow::Borrowed(_)))
        });
        assert_eq!(kept, [false, true]);
    }

    /// What was carved away is looked at, too.
    #[test]
    fn carved_faces_count() {
        let points = [(0.0, 0.0), (8.0, 0.0), (8.0, 8.0), (0.0, 8.0), (4.0, 1.0)];
        let mut pslg = Pslg::from_points(points);
        pslg.add_ring([0, 4, 1, 2, 3]);
        let domain = ConstrainedDelaunay::new().domain(DomainRule::Carve);
        let t = domain.triangulate(pslg).unwrap();
        assert!(t.triangulation().mesh().triangles().count() > t.triangulation().num_triangles());
        let found = of_vertices(t.triangulation(), &()).unwrap();
        assert!(matches!(found, Cow::Borrowed(_)));
    }
}
