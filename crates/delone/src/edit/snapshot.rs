//! A live triangulation as it is, handed out like the result of a builder.

use super::{ConstraintId, LiveTriangulation};
use crate::constrained::hand_out_draft;
use crate::pslg::Chains;
use crate::{ConstrainedTriangulation, VertexId};

/// A triangulation as it was at some moment, without gaps in its numbers.
#[derive(Clone, Debug)]
pub struct Snapshot {
    /// The triangulation; its segments are the constraints.
    pub triangulation: ConstrainedTriangulation,
    /// For each of its vertices the live one, ascending.
    pub vertices: Vec<VertexId>,
    /// For each of its segments the constraint, ascending.
    pub constraints: Vec<ConstraintId>,
}

impl LiveTriangulation {
    /// Copies the triangulation as it is now, with vertices and constraints numbered from 0 on.
    ///
    /// ```
    /// use delone::edit::LiveTriangulation;
    /// let mut live = LiveTriangulation::new();
    /// for (x, y) in [(0.0, 0.0), (9.0, 9.0), (1.0, 0.0), (0.0, 1.0)] {
    ///     live.insert((x, y))?;
    /// }
    /// live.remove(1.into())?;
    /// let snapshot = live.snapshot();
    /// assert_eq!(snapshot.triangulation.triangulation().num_triangles(), 1);
    /// assert_eq!(snapshot.vertices, [0, 2, 3].map(Into::into));
    /// # Ok::<(), delone::edit::EditError>(())
    /// ```
    ///
    /// *Cost*: linear in the vertices, and in the degrees of those along constraints.
    pub fn snapshot(&self) -> Snapshot {
        let vertices: Vec<VertexId> = self.vertices().collect();
        let constraints: Vec<ConstraintId> = self.constraints().collect();
        let names = self.names_without_gaps(&vertices);
        let name = |v: VertexId| names[v.index()];
        let mut segments = Vec::with_capacity(constraints.len());
        let mut chains = Chains::default();
        for (i, &id) in constraints.iter().enumerate() {
            let chain = self.chain(id).expect("bug: a constraint that was listed");
            segments.push([chain[0], chain[chain.len() - 1]].map(name));
            if chain.len() > 2 {
                chains.push(i, chain.into_iter().map(name));
            }
        }
        let points = vertices.iter().map(|&v| self.draft.point(v)).collect();
        Snapshot {
            triangulation: hand_out_draft(&self.draft, names, points, segments, chains),
            vertices,
            constraints,
        }
    }
}
