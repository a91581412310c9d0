//! A refined mesh with its report, and what its triangles are like, for those who ask.

use super::Report;
use crate::ConstrainedTriangulation;
use crate::check::{self, Statistics};
use std::sync::OnceLock;

/// A refined mesh, and what it is like.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct RefinedMesh {
    /// The mesh: vertices that were added come behind those of the input and the crossings.
    pub mesh: ConstrainedTriangulation,
    /// What was reached.
    pub report: Report,
    /// Measuring takes as long as a good part of the refinement, and not everybody asks.
    statistics: OnceLock<Statistics>,
}

impl RefinedMesh {
    pub(super) fn new(mesh: ConstrainedTriangulation, report: Report) -> Self {
        Self {
            mesh,
            report,
            statistics: OnceLock::new(),
        }
    }

    /// Returns what the triangles are like: extremes, means and histograms of angles, edges and areas.
    ///
    /// They are measured when first asked for. Whoever puts another mesh into [`mesh`](Self::mesh) after
    /// that still gets those of the one before; [`check::statistics`] measures any.
    ///
    /// *Cost*: the first time that of [`check::statistics`], then none.
    pub fn statistics(&self) -> &Statistics {
        let t = self.mesh.triangulation();
        self.statistics
            .get_or_init(|| check::statistics(t.points(), t.triangles()))
    }
}
