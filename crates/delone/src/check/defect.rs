//! What can be wrong with a triangulation, and where.

use crate::{Point, TriangleId, VertexId};
use std::fmt;
use std::mem::discriminant;

/// A vertex and where it lies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corner {
    /// The vertex.
    pub vertex: VertexId,
    /// Its position.
    pub at: Point,
}

impl Corner {
    /// Looks up where `vertex` lies.
    pub(super) fn new(points: &[Point], vertex: VertexId) -> Self {
        let at = points[vertex.index()];
        Self { vertex, at }
    }
}

impl fmt::Display for Corner {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Point { x, y } = self.at;
        write!(f, "{} ({x:?}, {y:?})", self.vertex)
    }
}

/// One reason why triangles are not the canonical Delaunay triangulation of some points.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Defect {
    /// More triangles than any triangulation can have.
    #[error("{given} triangles, but a triangulation has at most {limit}")]
    TooManyTriangles {
        /// Number of triangles given.
        given: usize,
        /// Most triangles that ids can name.
        limit: usize,
    },
    /// A corner names no point.
    #[error("triangle {} names vertex {corner}, but there are {points} points", .triangle.raw())]
    OutOfRange {
        /// The triangle.
        triangle: TriangleId,
        /// Its corner.
        corner: VertexId,
        /// Number of points.
        points: usize,
    },
    /// A triangle names the same vertex twice.
    #[error("triangle {} has vertex {corner} twice", .triangle.raw())]
    RepeatedCorner {
        /// The triangle.
        triangle: TriangleId,
        /// The repeated vertex.
        corner: Corner,
    },
    /// A triangle turns clockwise.
    #[error("triangle {} turns clockwise: {}", .triangle.raw(), list(.corners))]
    Clockwise {
        /// The triangle.
        triangle: TriangleId,
        /// Its corners.
        corners: [Corner; 3],
    },
    /// The corners of a triangle lie on one line.
    #[error("triangle {} is flat: {} lie on one line", .triangle.raw(), list(.corners))]
    Degenerate {
        /// The triangle.
        triangle: TriangleId,
        /// Its corners.
        corners: [Corner; 3],
    },
    /// A point is neither a corner nor equal to one.
    #[error("point {corner} is missing: no triangle has it or a duplicate of it as a corner")]
    MissingPoint {
        /// The point.
        corner: Corner,
    },
    /// An edge has more than two triangles.
    #[error("edge {} has {count} triangles, among them {} and {}",
        list(.edge), .triangles[0].raw(), .triangles[1].raw())]
    CrowdedEdge {
        /// The edge.
        edge: [Corner; 2],
        /// Two of the triangles.
        triangles: [TriangleId; 2],
        /// Number of triangles.
        count: usize,
    },
    /// Two triangles run through an edge in the same direction.
    #[error("triangles {} and {} lie on the same side of edge {}",
        .triangles[0].raw(), .triangles[1].raw(), list(.edge))]
    SameSide {
        /// The edge.
        edge: [Corner; 2],
        /// The triangles.
        triangles: [TriangleId; 2],
    },
    /// The circle of a triangle contains the apex beyond an edge, under the symbolic perturbation.
    #[error("edge {} between triangles {} and {} is not locally Delaunay: \
        the circle through it and {apex} contains {inside}",
        list(.edge), .triangles[0].raw(), .triangles[1].raw())]
    NotLocallyDelaunay {
        /// The edge, as the first triangle runs through it.
        edge: [Corner; 2],
        /// The triangles beside it.
        triangles: [TriangleId; 2],
        /// The third corner of the first triangle.
        apex: Corner,
        /// The third corner of the second triangle, inside the circle of the first.
        inside: Corner,
    },
    /// The boundary turns right, or back, so there is a gap at the hull.
    #[error("the boundary is not convex at {}: it comes from {} and goes to {}",
        .corners[1], .corners[0], .corners[2])]
    DentedHull {
        /// Three vertices that follow one another along the boundary.
        corners: [Corner; 3],
    },
    /// The boundary is not one closed cycle: there are holes or parts.
    #[error(
        "the edges with one triangle form {cycles} cycles, but the hull is one: \
        there are holes or separate parts"
    )]
    BoundaryCycles {
        /// Number of cycles.
        cycles: usize,
    },
    /// The boundary is convex but goes round several times: triangles overlap.
    #[error("the boundary turns {turns} times, so triangles overlap")]
    WindingBoundary {
        /// Number of full turns.
        turns: usize,
    },
    /// Two vertices lie at the same place; one of them should stand for both.
    #[error("{} and {} are equal, but both are corners", .corners[0], .corners[1])]
    SharedPosition {
        /// The vertices, the lower index first.
        corners: [Corner; 2],
    },
    /// The triangles around a vertex form several fans or cycles.
    #[error(
        "vertex {corner} has {triangles} triangles, but only {reached} hang together around it"
    )]
    SplitStar {
        /// The vertex.
        corner: Corner,
        /// Triangles in one fan or cycle.
        reached: usize,
        /// Triangles that have the vertex as a corner.
        triangles: usize,
    },
    /// There are no triangles, although the points do not lie on one line.
    #[error("there are no triangles, but {} do not lie on one line", list(.corners))]
    NoTriangles {
        /// Three points that could be corners.
        corners: [Corner; 3],
    },
}

fn list(corners: &[Corner]) -> String {
    let names: Vec<String> = corners.iter().map(Corner::to_string).collect();
    names.join(" – ")
}

/// All that is wrong with a triangulation: everything is counted, a few of each kind are kept.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Defects {
    listed: Vec<Defect>,
    total: usize,
}

impl Defects {
    /// Most defects of one kind that are kept.
    pub const LISTED_PER_KIND: usize = 8;

    pub(super) fn push(&mut self, defect: Defect) {
        self.total += 1;
        let alike = |d: &&Defect| discriminant(*d) == discriminant(&defect);
        if self.listed.iter().filter(alike).count() < Self::LISTED_PER_KIND {
            self.listed.push(defect);
        }
    }

    /// Counts the defects, listed or not.
    pub fn total(&self) -> usize {
        self.total
    }

    /// Returns the first few defects of each kind, in the order in which they were found.
    pub fn listed(&self) -> &[Defect] {
        &self.listed
    }

    /// Tells whether nothing is wrong.
    pub fn is_empty(&self) -> bool {
        self.total == 0
    }
}

impl fmt::Display for Defects {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, defect) in self.listed.iter().enumerate() {
            let newline = if i > 0 { "\n" } else { "" };
            write!(f, "{newline}{defect}")?;
        }
        match self.total - self.listed.len() {
            0 => Ok(()),
            more => write!(f, "\nand {more} more"),
        }
    }
}

impl std::error::Error for Defects {}
