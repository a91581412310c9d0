//! What a verification comes to.

use super::Defects;
use crate::TriangulationHash;
use std::fmt;

/// The outcome of a verification that ran to its end.
#[derive(Clone, Debug, PartialEq)]
#[must_use = "a verdict may say that the triangulation is wrong"]
pub enum Verdict {
    /// It is the canonical Delaunay triangulation, of points or of a domain.
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
    /// Edges on the boundary of the convex hull, or of the domain; for bare points on one line, all
    /// edges.
    pub hull_edges: usize,
    /// What else there is to a domain; `None` for bare points.
    pub domain: Option<DomainNumbers>,
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

/// The numbers of a domain whose triangulation has been proven right.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct DomainNumbers {
    /// Vertices added where segments cross.
    pub added: usize,
    /// Steiner points on segments; 0 unless the mesh is said to be refined.
    pub on_segments: usize,
    /// Steiner points on no segment; likewise.
    pub free: usize,
    /// Distinct points that lie outside the domain, so that no triangle has them.
    pub carved: usize,
    /// Constrained edges, those outside the domain included.
    pub subsegments: usize,
    /// Parts of the domain that hang together across edges.
    pub components: usize,
    /// Parts outside the domain that the domain encloses, likewise.
    pub holes: usize,
}

impl DomainNumbers {
    /// What has been proven of a domain, with exact arithmetic; one clause each.
    pub const PROVEN: [&'static str; 7] = [
        "every triangle turns strictly counter-clockwise",
        "every segment is a chain of subsegments, which meet at ends only and are part of a segment",
        "every added vertex lies where segments cross",
        "every edge has two triangles, one on either side, or bounds the domain",
        "the triangles cover the domain without gap or overlap, and nothing else",
        "every point in the domain is a corner or equal to exactly one that is",
        "every other edge is locally Delaunay under the symbolic perturbation",
    ];

    /// What has been proven of a refined mesh: the same, but that it may have Steiner points.
    pub const PROVEN_REFINED: [&'static str; 7] = {
        let mut proven = Self::PROVEN;
        proven[2] = "every other vertex lies where segments cross, or is a Steiner point that triangles have, on a \
                     segment as near as rounding allows or on none";
        proven
    };
}

impl Certificate {
    /// Says that this is about a domain.
    pub(super) fn of_domain(self, numbers: DomainNumbers) -> Self {
        Self {
            domain: Some(numbers),
            ..self
        }
    }
}

impl fmt::Display for DomainNumbers {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{} subsegments, {} added vertices, {} components, {} holes, {} points outside",
            self.subsegments, self.added, self.components, self.holes, self.carved,
        )?;
        match [self.on_segments, self.free] {
            [0, 0] => Ok(()),
            [on, free] => write!(f, ", {on} Steiner points on segments and {free} elsewhere"),
        }
    }
}

impl fmt::Display for Certificate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (kind, border) = match self.domain {
            None => ("Delaunay", "hull"),
            Some(_) => ("constrained Delaunay", "boundary"),
        };
        write!(
            f,
            "the canonical {kind} triangulation {} of {} points: {} vertices, {} duplicates, \
             {} triangles, {} edges, {} of them on the {border}",
            self.hash,
            self.points,
            self.vertices,
            self.duplicates,
            self.triangles,
            self.edges,
            self.hull_edges,
        )?;
        let domain = |numbers| write!(f, "; {numbers}");
        self.domain.as_ref().map_or(Ok(()), domain)
    }
}
