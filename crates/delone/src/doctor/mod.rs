//! What is wrong with a drawing, and its repair.
//!
//! [`Doctor::examine`] finds [everything](Kind) that may keep a drawing from being the domain that was meant,
//! and says how bad it is. Signs are exact, as are comparisons of distances with the tolerance, which is the
//! only one, stated, and zero unless it is asked for.
//!
//! ```
//! use delone::Pslg;
//! use delone::doctor::{Doctor, Kind};
//!
//! // A square that does not close by a hundredth.
//! let corners = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0), (0.0, 0.01)];
//! let mut square = Pslg::from_points(corners);
//! square.add_polyline([0, 1, 2, 3, 4]);
//! let found = Doctor::new().examine(&square)?;
//! assert_eq!(found.count_of(Kind::UnclosedRing), 1);
//! assert_eq!(found.suggestion, Some(0.01));
//!
//! let repair = Doctor::new().tolerance(0.01).repair(&square)?;
//! assert_eq!(repair.moved().count(), 1);
//! assert_eq!(repair.pslg.points.len(), 4);
//! assert!(Doctor::new().tolerance(0.01).examine(&repair.pslg)?.is_healthy());
//! # Ok::<(), delone::Error>(())
//! ```

mod corners;
mod examine;
mod graph;
mod lines;
mod near;
mod repair;
mod rings;
mod scale;
mod seeds;
mod trouble;

pub use repair::{Bent, Moved, Repair};
pub use trouble::{Diagnosis, Kind, Severity, Trouble};

use crate::{DomainRule, Error, Pslg, Watch};

/// Examines drawings, and repairs them.
#[derive(Clone, Copy)]
pub struct Doctor<'w> {
    tolerance: f64,
    limit: usize,
    rule: DomainRule,
    watch: &'w dyn Watch,
}

impl Default for Doctor<'_> {
    fn default() -> Self {
        Self::new()
    }
}

impl<'w> Doctor<'w> {
    /// Makes one of no tolerance, who lists the first hundred of each kind and keeps the convex hull.
    pub fn new() -> Self {
        Self {
            tolerance: 0.0,
            limit: 100,
            rule: DomainRule::Hull,
            watch: &(),
        }
    }

    /// Takes what is at most so far apart, in units of the coordinates, for a near miss, and mends it.
    pub fn tolerance(mut self, tolerance: f64) -> Self {
        self.tolerance = tolerance;
        self
    }

    /// Lists the first so many of each kind; all are counted.
    pub fn limit(mut self, limit: usize) -> Self {
        self.limit = limit;
        self
    }

    /// Says which triangles would belong to the domain: where seeds may lie depends on it.
    pub fn domain(mut self, rule: DomainRule) -> Self {
        self.rule = rule;
        self
    }

    /// Reports progress to a watch, and lets it cancel.
    pub fn watch<'v>(self, watch: &'v dyn Watch) -> Doctor<'v> {
        let Self {
            tolerance,
            limit,
            rule,
            ..
        } = self;
        Doctor {
            tolerance,
            limit,
            rule,
            watch,
        }
    }

    /// Finds what is wrong.
    ///
    /// # Errors
    /// [`Error::BadChoice`] if the tolerance is negative or not finite; those of [`Pslg::facts`]; polygons that
    /// are no ranges of segments, seeds that are not finite and areas that are not positive.
    ///
    /// *Cost*: in practice O(n log n + k) for k troubles, many of which are only counted; where segments should
    /// enclose something, that includes a triangulation.
    pub fn examine(&self, pslg: &Pslg) -> Result<Diagnosis, Error> {
        self.require_tolerance()?;
        examine::examine(self, pslg)
    }

    /// Makes a clean drawing: nothing meets but at common ends, and what is within the tolerance is one.
    ///
    /// See [`Repair`] for what is changed, and by how much. Without tolerance no point moves.
    ///
    /// # Errors
    /// Those of [`examine`](Self::examine).
    ///
    /// *Cost*: in practice O(n log n + k) a round, of which there are two or three.
    pub fn repair(&self, pslg: &Pslg) -> Result<Repair, Error> {
        self.require_tolerance()?;
        repair::repair(self, pslg)
    }

    fn require_tolerance(&self) -> Result<(), Error> {
        match self.tolerance >= 0.0 && self.tolerance.is_finite() {
            true => Ok(()),
            false => Err(Error::BadChoice {
                what: "the tolerance",
                given: self.tolerance,
                must: "it must be zero or more, and finite",
            }),
        }
    }
}
