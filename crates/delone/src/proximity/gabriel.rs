//! The Gabriel graph (Gabriel and Sokal, *A new statistical approach to geographic variation analysis*,
//! 1969).

use super::Proximity;
use crate::predicates::{CircleSide, in_diametral_circle};
use crate::{Error, HalfEdgeId, VertexId};

impl Proximity<'_> {
    /// Lists the edges of the Gabriel graph: those pairs of vertices with no other point in or on the
    /// circle of which they are a diameter. Lower end first, sorted.
    ///
    /// A point on the circle counts, so that the graph does not depend on how ties of the triangulation
    /// are broken.
    ///
    /// # Errors
    /// [`Error::Cancelled`].
    ///
    /// *Cost*: O(n) tests, and sorting.
    pub fn gabriel_graph(&self) -> Result<Vec<[VertexId; 2]>, Error> {
        let mut pace = self.pace();
        let mut edges = Vec::new();
        for h in self.half_edges() {
            pace.step()?;
            if self.is_gabriel(h) {
                edges.push(self.undirected(h));
            }
        }
        edges.sort_unstable();
        pace.finish();
        Ok(edges)
    }

    /// Tells whether no point lies in or on the diametral circle of an edge. Who does sees the edge under
    /// at least a right angle, and on either side the apex of the triangle sees it under the largest.
    pub(super) fn is_gabriel(&self, h: HalfEdgeId) -> bool {
        let mesh = self.triangulation.mesh();
        let [a, b] = self.end_points(h);
        let is_free = |h| {
            let apex = mesh.apex(h);
            apex.is_infinite() || in_diametral_circle(a, b, self.point(apex)) == CircleSide::Outside
        };
        is_free(h) && is_free(mesh.twin(h))
    }
}
