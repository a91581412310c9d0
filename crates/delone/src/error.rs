//! What can go wrong in the library.

use crate::{Point, TriangleId, VertexId};
use std::fmt;
use std::ops::Range;

/// Why the library could not do what it was asked.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A coordinate is NaN or infinite.
    #[error("point {index} is ({x}, {y}): coordinates must be finite; remove or repair it")]
    NotFinite {
        /// Index of the point in the caller's numbering, from 0.
        index: usize,
        /// Its abscissa.
        x: f64,
        /// Its ordinate.
        y: f64,
    },
    /// More points than 32-bit half-edge ids can number.
    #[error(
        "{given} points given, but one triangulation holds at most {limit}; split the data into tiles"
    )]
    TooManyPoints {
        /// Number of points given.
        given: usize,
        /// Largest number of points in one triangulation.
        limit: usize,
    },
    /// A segment names a point that does not exist.
    #[error("segment {segment} names point {vertex}, but there are {points} points")]
    BadSegment {
        /// Index of the segment.
        segment: usize,
        /// The point it names.
        vertex: VertexId,
        /// Number of points.
        points: usize,
    },
    /// More segments than 32 bits can number.
    #[error("{given} segments given, but at most {limit} are possible; split the data into tiles")]
    TooManySegments {
        /// Number of segments given.
        given: usize,
        /// Largest number of segments.
        limit: usize,
    },
    /// Two segments cross in a point that is no vertex, and crossings are to be refused.
    #[error(
        "segments {} and {} cross at ({}, {}); repair them, or have crossings split",
        segments[0], segments[1], at.x, at.y
    )]
    Crossing {
        /// Indices of the segments: the lexicographically first pair that cross.
        segments: [usize; 2],
        /// Where they cross, rounded.
        at: Point,
    },
    /// The range of a polygon is not one of segments.
    #[error(
        "polygon {polygon} has segments {} to {}, but there are {segments}", range.start, range.end
    )]
    BadPolygon {
        /// Index of the polygon.
        polygon: usize,
        /// Its segments.
        range: Range<usize>,
        /// Number of segments.
        segments: usize,
    },
    /// The ranges of two polygons have segments in common.
    #[error("polygons {} and {} share segment {segment}; give each its own", polygons[0], polygons[1])]
    SharedSegment {
        /// Indices of the polygons.
        polygons: [usize; 2],
        /// Index of a segment that both have.
        segment: usize,
    },
    /// The largest area of a region is not a positive number.
    #[error("the largest area of region {region} is {max_area}: it must be positive, or left out")]
    BadArea {
        /// Index of the region.
        region: usize,
        /// The area given.
        max_area: f64,
    },
    /// A polygon is not closed.
    #[error(
        "polygon {polygon} is not closed: an odd number of its segments end in point {vertex} at ({}, {})",
        at.x, at.y
    )]
    OpenPolygon {
        /// Index of the polygon.
        polygon: usize,
        /// Where it is open.
        vertex: VertexId,
        /// The position of that point.
        at: Point,
    },
    /// The seed of a hole or region has a coordinate that is NaN or infinite.
    #[error("{seed} lies at ({}, {}): coordinates must be finite", at.x, at.y)]
    SeedNotFinite {
        /// Which seed.
        seed: Seed,
        /// Its position.
        at: Point,
    },
    /// The seed of a hole or region lies on a segment, so what it means is undecided.
    #[error(
        "{seed} at ({}, {}) lies on segment {segment}; move it into the hole or region it stands for",
        at.x, at.y
    )]
    SeedOnSegment {
        /// Which seed.
        seed: Seed,
        /// Its position.
        at: Point,
        /// Index of the segment.
        segment: usize,
    },
    /// A bound on the quality of triangles makes no sense.
    #[error("{given} was asked for as the {what}")]
    BadQuality {
        /// Which bound, and what it must be.
        what: &'static str,
        /// The value given.
        given: f64,
    },
    /// A sizing field has not one size for each point, or not one area for each triangle.
    #[error("{given} sizes given for {expected} {of}; each needs one")]
    SizesMissing {
        /// Number of sizes given.
        given: usize,
        /// Number of points or triangles.
        expected: usize,
        /// Points, or triangles.
        of: &'static str,
    },
    /// A size of a sizing field is not a positive finite number.
    #[error(
        "the size at point {index} is {given}: it must be positive and finite; repair or remove it"
    )]
    BadSize {
        /// Index of the point.
        index: usize,
        /// The size given.
        given: f64,
    },
    /// The weight of a point is NaN or infinite.
    #[error("the weight of point {index} is {weight}: it must be finite; repair or remove it")]
    BadWeight {
        /// Index of the point.
        index: usize,
        /// The weight given.
        weight: f64,
    },
    /// The weight of a point is not a positive finite number.
    #[error(
        "the weight of point {index} is {weight}: it must be positive and finite; repair it, or leave the point out"
    )]
    WeightNotPositive {
        /// Index of the point.
        index: usize,
        /// The weight given.
        weight: f64,
    },
    /// A radius or distance is negative or NaN, or infinite in a query for what lies within it.
    #[error("a radius of {given} cannot be used: it must not be negative, nor infinite in a query")]
    BadRadius {
        /// The radius given.
        given: f64,
    },
    /// A vertex was named that the triangulation does not have.
    #[error("vertex {vertex} does not exist: there are {points} points")]
    NoSuchVertex {
        /// The vertex named.
        vertex: VertexId,
        /// Number of points.
        points: usize,
    },
    /// A surface has not one value, or not one gradient, for each point.
    #[error("{given} {what} given for {expected} points; each needs one")]
    ValuesMissing {
        /// Number of values given.
        given: usize,
        /// Number of points.
        expected: usize,
        /// Values, or gradients.
        what: &'static str,
    },
    /// A value of a surface, or a gradient, is NaN or infinite.
    #[error("the {what} at point {vertex} is {given}: it must be finite; repair or remove it")]
    ValueNotFinite {
        /// The point.
        vertex: VertexId,
        /// The value given.
        given: f64,
        /// Value, or gradient.
        what: &'static str,
    },
    /// Two equal points have different values.
    #[error(
        "points {} and {} are equal, but their values are {} and {}; decide for one, or average them",
        vertices[0], vertices[1], values[0], values[1]
    )]
    ValuesDiffer {
        /// The points: the one that stands for both, and the other.
        vertices: [VertexId; 2],
        /// Their values.
        values: [f64; 2],
    },
    /// Natural neighbours are asked of triangles that are not Delaunay.
    #[error(
        "the edge from point {} to point {} is neither Delaunay nor known as a constraint; hand over the \
         constrained triangulation, not its triangles alone",
        edge[0], edge[1]
    )]
    NotDelaunay {
        /// The ends of an edge that is not.
        edge: [VertexId; 2],
    },
    /// A raster has no cells, or cells of no size.
    #[error("{what} of the raster is {given}: {must}")]
    BadGrid {
        /// What is wrong.
        what: &'static str,
        /// The number given.
        given: f64,
        /// What it must be.
        must: &'static str,
    },
    /// A level of contour lines, or the interval between them, makes no sense.
    #[error("the {what} of contour lines is {given}: {must}")]
    BadLevel {
        /// Level, interval, or number of levels.
        what: &'static str,
        /// The number given.
        given: f64,
        /// What it must be.
        must: &'static str,
    },
    /// A triangle names a point that does not exist.
    #[error("triangle {triangle} names point {vertex}, but there are {points} points")]
    BadTriangle {
        /// Index of the triangle.
        triangle: usize,
        /// The point it names.
        vertex: VertexId,
        /// Number of points.
        points: usize,
    },
    /// A triangle of a triangulation to begin with cannot be part of one.
    #[error("triangle {triangle} cannot be part of a triangulation to begin with: {why}")]
    BadStart {
        /// Index of the triangle.
        triangle: usize,
        /// What is wrong with it.
        why: &'static str,
    },
    /// Two triangles lie on the same side of an edge, or one has a corner twice.
    #[error(
        "triangles {} and {} lie on the same side of the edge from point {} to point {}; leave one out",
        triangles[0], triangles[1], edge[0], edge[1]
    )]
    SameSide {
        /// Indices of the triangles.
        triangles: [usize; 2],
        /// The ends of the edge.
        edge: [VertexId; 2],
    },
    /// A classical algorithm was given what it does not know.
    #[error(
        "the algorithm `{algorithm}` knows no {what}; leave that out, or take another algorithm"
    )]
    NotTaken {
        /// Its name.
        algorithm: &'static str,
        /// What it was given.
        what: &'static str,
    },
    /// A classical algorithm would add more vertices than it is meant for.
    #[error(
        "the algorithm `{algorithm}` would make more than {limit} vertices; ask for longer edges or smaller angles"
    )]
    TooManyVertices {
        /// Its name.
        algorithm: &'static str,
        /// Most vertices.
        limit: usize,
    },
    /// Something was asked of the thesis' strategy that it does not know.
    #[error("the strategy of the thesis has no {what}; use the default strategy, or do without")]
    NotInThesis {
        /// What was asked for.
        what: &'static str,
    },
    /// A triangle is to hold more data than there are.
    #[error(
        "a triangle is to hold at least {least} data, but there are {distinct} different ones; ask for fewer"
    )]
    TooFewData {
        /// Number of different data.
        distinct: usize,
        /// How many a triangle is to hold.
        least: usize,
    },
    /// All data lie on one line, so that no triangle holds them well.
    #[error(
        "all {distinct} different data lie on one line; a triangulation needs data that do not"
    )]
    CollinearData {
        /// Number of different data.
        distinct: usize,
    },
    /// A datum lies outside of the domain that was given.
    #[error(
        "datum {datum} at ({}, {}) lies outside of the domain; enlarge the domain, or leave it out", at.x, at.y
    )]
    DatumOutside {
        /// Index of the datum.
        datum: usize,
        /// Its position.
        at: Point,
    },
    /// A datum is said to be held by a triangle that cannot hold it.
    #[error("datum {datum} is said to be held by triangle {}, {why}", triangle.index())]
    BadHolder {
        /// Index of the datum.
        datum: usize,
        /// The triangle named.
        triangle: TriangleId,
        /// Why it cannot.
        why: &'static str,
    },
    /// In no triangulation that was tried of the domain that was given all triangles hold enough data.
    #[error(
        "the triangle ({}, {}), ({}, {}), ({}, {}) of the domain holds {data} data, but is to hold at least {least}; \
         ask for fewer, or give another domain or none",
        triangle[0].x, triangle[0].y, triangle[1].x, triangle[1].y, triangle[2].x, triangle[2].y
    )]
    DomainTooEmpty {
        /// The corners of a triangle that holds too few.
        triangle: [Point; 3],
        /// How many it holds.
        data: usize,
        /// How many it is to hold.
        least: usize,
    },
    /// The outline of a domain is no simple polygon.
    #[error("the domain is no simple polygon: {why}")]
    BadDomain {
        /// What is wrong.
        why: &'static str,
    },
    /// A number that an algorithm is told cannot be used.
    #[error("{what} is {given}: {must}")]
    BadChoice {
        /// What it is.
        what: &'static str,
        /// The number given.
        given: f64,
        /// What it must be.
        must: &'static str,
    },
    /// The caller's [`Watch`](crate::Watch) asked to stop.
    #[error("cancelled")]
    Cancelled,
    /// The threads asked for could not be started.
    #[error("could not start {threads} threads: {reason}")]
    Threads {
        /// Number of threads asked for.
        threads: usize,
        /// What the thread pool said.
        reason: String,
    },
}

/// A point that stands for the hole or region around it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Seed {
    /// The hole of this index.
    Hole(usize),
    /// The region of this index.
    Region(usize),
}

impl fmt::Display for Seed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Hole(i) => write!(f, "the point of hole {i}"),
            Self::Region(i) => write!(f, "the point of region {i}"),
        }
    }
}
