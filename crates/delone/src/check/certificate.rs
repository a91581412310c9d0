//! What a verification comes to.

use super::Defects;
use crate::TriangulationHash;
use std::fmt;

/// The outcome of a verification that ran to its end.
#[derive(Clone, Debug, PartialEq)]
#[must_use = "a verdict may say that the triangulation is wrong"]
pub enum Verdict {
    /// It is the canonical Delaunay triangulation.
    Right(Certificate),
    /// It is not; here is why.
    Wrong(Defects),
}

impl Verdict {
    /// Takes the certificate, or the defects as an error.
    ///
    /// # Errors
    /// The defects, if it is wrong.
    pub fn into_result(self) -> Result<Certificate, Defects> {
        match self {
            Self::Right(certificate) => Ok(certificate),
            Self::Wrong(defects) => Err(defects),
        }
    }
}

/// The numbers of a triangulation that has been proven right.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Certificate {
    /// Points given, duplicates included.
    pub points: usize,
    /// Distinct points.
    pub vertices: usize,
    /// Points that are equal to a vertex and are none themselves.
    pub duplicates: usize,
    /// Triangles.
    pub triangles: usize,
    /// Edges; if all points lie on one line, the edges from each to the next.
    pub edges: usize,
    /// Edges on the boundary of the convex hull; on one line, all edges.
    pub hull_edges: usize,
    /// The name of the set of triangles.
    pub hash: TriangulationHash,
}

impl Certificate {
    /// What has been proven, with exact arithmetic; one clause each.
    pub const PROVEN: [&'static str; 5] = [
        "every triangle turns strictly counter-clockwise",
        "every edge has two triangles, one on either side, or is an edge of the convex hull",
        "the triangles cover the convex hull without gap or overlap",
        "every point is a corner or equal to exactly one that is",
        "every edge is locally Delaunay under the symbolic perturbation",
    ];
}

impl fmt::Display for Certificate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "the canonical Delaunay triangulation {} of {} points: {} vertices, {} duplicates, \
             {} triangles, {} edges, {} of them on the hull",
            self.hash,
            self.points,
            self.vertices,
            self.duplicates,
            self.triangles,
            self.edges,
            self.hull_edges,
        )
    }
}
