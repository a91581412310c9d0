//! What a verification of a cover comes to.

use super::super::Defects;
use super::{SpecialCase, SpecialCause};
use crate::TriangulationHash;
use std::fmt;

/// The outcome of a verification of a cover that ran to its end.
#[derive(Clone, Debug, PartialEq)]
#[must_use = "a verdict may say that the cover is wrong"]
pub enum CoverVerdict {
    /// The triangles lie side by side, and each holds enough of the data.
    Right(CoverCertificate),
    /// Not so; here is why.
    Wrong(Defects),
}

impl CoverVerdict {
    /// Takes the certificate, or the defects as an error.
    ///
    /// # Errors
    /// The defects, if it is wrong.
    pub fn into_result(self) -> Result<CoverCertificate, Defects> {
        match self {
            Self::Right(certificate) => Ok(certificate),
            Self::Wrong(defects) => Err(defects),
        }
    }
}

/// The numbers of a cover that has been proven right.
///
/// Angles and the area are rounded; nothing is decided by them.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct CoverCertificate {
    /// Vertices.
    pub vertices: usize,
    /// Triangles.
    pub triangles: usize,
    /// Edges.
    pub edges: usize,
    /// Edges with one triangle.
    pub border_edges: usize,
    /// Data, equal ones counted once.
    pub data: usize,
    /// Data that equal an earlier one.
    pub duplicates: usize,
    /// How many data every triangle was to hold at least: d.
    pub least: usize,
    /// Fewest data that a triangle holds.
    pub fewest: usize,
    /// Most data that a triangle holds.
    pub most: usize,
    /// Mean number of data that triangles hold.
    pub mean: f64,
    /// Number of triangles by how many data they hold: entry k counts those that hold k.
    pub histogram: Vec<usize>,
    /// The triangles that hold more than 3d − 1, ascending.
    pub special: Vec<SpecialCase>,
    /// Smallest angle, in degrees.
    pub min_angle: f64,
    /// Largest angle, in degrees.
    pub max_angle: f64,
    /// Sum of the areas of the triangles, in squared units of the coordinates.
    pub area: f64,
    /// The name of the set of triangles.
    pub hash: TriangulationHash,
}

impl CoverCertificate {
    /// What has been proven, with exact arithmetic; one clause each.
    pub const PROVEN: [&'static str; 6] = [
        "every triangle turns strictly counter-clockwise, and every vertex is a corner",
        "every edge has two triangles, one on either side, or is an edge of the border",
        "the triangles cover what one simple polygon encloses without gap or overlap",
        "every datum lies in the closed triangle that holds it",
        "equal data are held by the same triangle and counted once",
        "every triangle holds enough data, and those that hold too many are listed",
    ];

    /// Counts the triangles that hold more than 3d − 1 data without an excuse.
    pub fn unexcused(&self) -> usize {
        let causes = self.special.iter().map(|case| case.cause);
        causes.filter(|&c| c == SpecialCause::Unexcused).count()
    }
}

impl fmt::Display for CoverCertificate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "a cover {} of {} data: {} duplicates, {} vertices, {} triangles, {} edges, {} of them on the border; \
             {} to {} data a triangle, {:.2} in the mean, at least {} asked",
            self.hash,
            self.data,
            self.duplicates,
            self.vertices,
            self.triangles,
            self.edges,
            self.border_edges,
            self.fewest,
            self.most,
            self.mean,
            self.least,
        )?;
        match (self.special.len(), self.unexcused()) {
            (0, _) => Ok(()),
            (all, 0) => write!(f, "; {all} special cases"),
            (all, unexcused) => write!(f, "; {all} special cases, {unexcused} of them unexcused"),
        }
    }
}
