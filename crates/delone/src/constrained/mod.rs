//! The canonical constrained Delaunay triangulation of a domain.

mod result;

pub use result::{ConstrainedTriangulation, Origin, Warning};

use crate::{DomainRule, Error, Pslg, SegmentPolicy, Watch};

/// How to triangulate a domain.
#[derive(Clone, Copy)]
pub struct ConstrainedDelaunay<'w> {
    crossings: SegmentPolicy,
    domain: DomainRule,
    threads: Option<usize>,
    watch: &'w dyn Watch,
}

impl Default for ConstrainedDelaunay<'_> {
    fn default() -> Self {
        Self::new()
    }
}

impl<'w> ConstrainedDelaunay<'w> {
    /// Refuses crossings, keeps the convex hull, uses every thread of the machine, unwatched.
    pub fn new() -> Self {
        Self {
            crossings: SegmentPolicy::default(),
            domain: DomainRule::default(),
            threads: None,
            watch: &(),
        }
    }

    /// Chooses what to do where segments cross.
    pub fn crossings(self, policy: SegmentPolicy) -> Self {
        Self {
            crossings: policy,
            ..self
        }
    }

    /// Chooses which triangles belong to the domain.
    pub fn domain(self, rule: DomainRule) -> Self {
        Self {
            domain: rule,
            ..self
        }
    }

    /// Uses `threads` threads (0 means 1); the result is the same for any number.
    ///
    /// Without the feature `rayon` there is only the caller's thread.
    pub fn threads(self, threads: usize) -> Self {
        Self {
            threads: Some(threads),
            ..self
        }
    }

    /// Reports progress to `watch`, which may cancel.
    pub fn watch(self, watch: &'w dyn Watch) -> Self {
        Self { watch, ..self }
    }

    /// Triangulates a domain.
    pub fn triangulate(self, pslg: Pslg) -> Result<ConstrainedTriangulation, Error> {
        let _ = (self.crossings, self.domain, self.threads, self.watch);
        let _ = pslg;
        todo!()
    }
}
