//! Limits of the work.

use std::time::Duration;

/// How far refinement may go. Whatever stops it, the mesh is valid and constrained Delaunay.
///
/// ```
/// use delone::{Angle, Budget, Outcome, Pslg, Quality, Refinement};
/// let points = [(0.0, 0.0), (9.0, 0.0), (0.0, 1.0)];
/// let quality = Quality { max_edge: Some(0.01), ..Quality::default() };
/// let budget = Budget { vertices: Some(1000), ..Budget::default() };
/// let refined = Refinement::new(quality).budget(budget).mesh(Pslg::from_points(points))?;
/// assert_eq!(refined.report.outcome, Outcome::BudgetExhausted);
/// assert_eq!(refined.mesh.triangulation().num_vertices(), 1000);
/// # Ok::<(), delone::Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Budget {
    /// Largest number of vertices of the mesh, those of the input included; kept exactly, unless the input
    /// has more.
    pub vertices: Option<usize>,
    /// Longest time for refinement. The mesh then depends on the speed of the machine.
    /// Nothing is limited where the standard library knows no clock, as in a browser.
    pub time: Option<Duration>,
}
