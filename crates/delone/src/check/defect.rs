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

/// One reason why triangles are not the canonical Delaunay triangulation of some points or of a domain, or
/// not the cover of some data.
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
        "the edges with one triangle form {cycles} cycles, but the border is one: \
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
    /// There are fewer points than in the input.
    #[error("{given} points given, but the input has {expected}")]
    TooFewPoints {
        /// Number of points given.
        given: usize,
        /// Number of points of the input.
        expected: usize,
    },
    /// A point of the input has moved.
    #[error("point {corner} lies at ({:?}, {:?}) in the input", .expected.x, .expected.y)]
    MovedPoint {
        /// The point.
        corner: Corner,
        /// Where the input has it.
        expected: Point,
    },
    /// A vertex was added where there is a point already.
    #[error("vertex {added} was added, but {} lies there already", .first.vertex)]
    NotNew {
        /// The added vertex.
        added: Corner,
        /// The first point at the same place.
        first: Corner,
    },
    /// More subsegments than ids can name.
    #[error("{given} subsegments, but at most {limit} are possible")]
    TooManySubsegments {
        /// Number of subsegments given.
        given: usize,
        /// Largest number.
        limit: usize,
    },
    /// An end of a subsegment names no point.
    #[error("subsegment {subsegment} names vertex {vertex}, but there are {points} points")]
    SubsegmentOutOfRange {
        /// Index of the subsegment.
        subsegment: usize,
        /// The end.
        vertex: VertexId,
        /// Number of points.
        points: usize,
    },
    /// A subsegment has no length.
    #[error("subsegment {subsegment}, {}, has no length", list(.ends))]
    EmptySubsegment {
        /// Index of the subsegment.
        subsegment: usize,
        /// Its ends.
        ends: [Corner; 2],
    },
    /// The same subsegment is listed several times.
    #[error("subsegment {} is listed more than once", list(.edge))]
    RepeatedSubsegment {
        /// Its ends.
        edge: [Corner; 2],
    },
    /// Two subsegments cross or overlap.
    #[error("subsegments {} and {} cross or overlap", list(&.edges[0]), list(&.edges[1]))]
    CrossingSubsegments {
        /// The ends of each.
        edges: [[Corner; 2]; 2],
    },
    /// A vertex lies inside a subsegment.
    #[error("vertex {corner} lies inside subsegment {}", list(.edge))]
    VertexOnSubsegment {
        /// The vertex.
        corner: Corner,
        /// The subsegment.
        edge: [Corner; 2],
    },
    /// A segment of the input is no chain of subsegments.
    #[error("segment {segment}, {}, is no chain of subsegments: it ends at {reached}", list(.ends))]
    BrokenChain {
        /// Index of the segment.
        segment: usize,
        /// Its ends.
        ends: [Corner; 2],
        /// How far subsegments follow it.
        reached: Corner,
    },
    /// A segment is led over a vertex that does not lie on it, though nothing crosses it.
    #[error("segment {segment}, {}, is bent to {corner}, where no other crosses it", list(.ends))]
    BentChain {
        /// Index of the segment.
        segment: usize,
        /// Its ends.
        ends: [Corner; 2],
        /// The vertex.
        corner: Corner,
    },
    /// A subsegment is part of no segment.
    #[error("subsegment {} is part of no segment", list(.edge))]
    StraySubsegment {
        /// Its ends.
        edge: [Corner; 2],
    },
    /// A vertex was added where no segments cross.
    #[error("vertex {corner} was added where no two segments cross")]
    NeedlessVertex {
        /// The vertex.
        corner: Corner,
    },
    /// A Steiner point is in no triangle.
    #[error("vertex {corner} was added, but no triangle has it")]
    UnusedVertex {
        /// The vertex.
        corner: Corner,
    },
    /// An edge has one triangle but bounds nothing.
    #[error("edge {} of triangle {} has no other triangle, but does not bound the domain",
        list(.edge), .triangle.raw())]
    OpenEdge {
        /// The edge.
        edge: [Corner; 2],
        /// Its triangle.
        triangle: TriangleId,
    },
    /// The domain lies to the left of an edge, but no triangle does.
    #[error("the domain lies left of edge {}, but no triangle does", list(.edge))]
    Uncovered {
        /// The edge.
        edge: [Corner; 2],
    },
    /// A triangle lies to the left of an edge, but the domain does not.
    #[error("triangle {} lies left of edge {}, but the domain does not", .triangle.raw(), list(.edge))]
    OutsideDomain {
        /// The edge.
        edge: [Corner; 2],
        /// The triangle.
        triangle: TriangleId,
    },
    /// A triangle lies in a hole.
    #[error("triangle {}, left of edge {}, lies in hole {hole} of seed ({:?}, {:?})",
        .triangle.raw(), list(.edge), .at.x, .at.y)]
    FilledHole {
        /// Index of the hole.
        hole: usize,
        /// Its seed.
        at: Point,
        /// The edge.
        edge: [Corner; 2],
        /// The triangle.
        triangle: TriangleId,
    },
    /// A vertex is in no triangle.
    #[error("no triangle has vertex {corner}")]
    IdleVertex {
        /// The vertex.
        corner: Corner,
    },
    /// The border runs through a vertex more than once.
    #[error("the border runs through vertex {corner} {times} times")]
    PinchedBorder {
        /// The vertex.
        corner: Corner,
        /// How often.
        times: usize,
    },
    /// Two edges of the border cross or overlap.
    #[error("edges {} and {} of the border cross or overlap", list(&.edges[0]), list(&.edges[1]))]
    CrossingBorder {
        /// The ends of each.
        edges: [[Corner; 2]; 2],
    },
    /// A vertex lies inside an edge of the border.
    #[error("vertex {corner} lies inside edge {} of the border", list(.edge))]
    VertexOnBorder {
        /// The vertex.
        corner: Corner,
        /// The edge.
        edge: [Corner; 2],
    },
    /// Not every datum has a holder, or there are holders of nothing.
    #[error("there are {data} data, but {holders} holders")]
    HolderCount {
        /// Number of data.
        data: usize,
        /// Number of holders.
        holders: usize,
    },
    /// A datum is held by a triangle that does not exist.
    #[error("datum {datum} is held by triangle {}, but there are {triangles} triangles", .holder.raw())]
    HolderOutOfRange {
        /// Index of the datum.
        datum: usize,
        /// The triangle named.
        holder: TriangleId,
        /// Number of triangles.
        triangles: usize,
    },
    /// A datum does not lie in the closed triangle that holds it, or it is not finite.
    #[error("datum {datum} ({:?}, {:?}) does not lie in triangle {}, which holds it",
        .at.x, .at.y, .holder.raw())]
    OutsideHolder {
        /// Index of the datum.
        datum: usize,
        /// Where it lies.
        at: Point,
        /// The triangle.
        holder: TriangleId,
    },
    /// Equal data are held by different triangles.
    #[error("data {} and {} are equal, but triangles {} and {} hold them",
        .data[0], .data[1], .holders[0].raw(), .holders[1].raw())]
    DividedDatum {
        /// Indices of the data, the lower one first.
        data: [usize; 2],
        /// The triangle of each.
        holders: [TriangleId; 2],
    },
    /// A triangle holds too few data.
    #[error("triangle {} holds {held} data, fewer than {least}", .triangle.raw())]
    TooFewData {
        /// The triangle.
        triangle: TriangleId,
        /// How many it holds, equal ones once.
        held: usize,
        /// How many it must hold.
        least: usize,
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
