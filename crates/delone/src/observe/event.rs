//! The vocabulary: what algorithms do, and what they look at.

use crate::predicates::{CircleSide, Orientation};
use crate::{Angle, Point, VertexId};

/// What happens in a step. Edges and triangles are named by their vertices, triangles counter-clockwise;
/// the vertex at infinity does not occur.
///
/// The first group changes the [scene](super::Scene); each of these has a [reverse](Self::reversed). All others
/// change nothing: they tell what is looked at.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "kebab-case")
)]
#[non_exhaustive]
pub enum Event {
    // ----- What changes the scene
    /// A vertex appears that was not in the input.
    VertexCreated {
        /// Its number: the next one that is free.
        vertex: VertexId,
        /// Where it lies.
        at: Point,
    },
    /// A vertex disappears; nothing hangs on it any more.
    VertexDeleted {
        /// Its number: the last one.
        vertex: VertexId,
        /// Where it lay.
        at: Point,
    },
    /// A vertex on which nothing hangs goes elsewhere.
    VertexMoved {
        /// Its number.
        vertex: VertexId,
        /// Where it lay.
        from: Point,
        /// Where it lies.
        to: Point,
    },
    /// An edge appears, with no triangle on either side yet.
    EdgeCreated {
        /// Its ends.
        edge: [VertexId; 2],
    },
    /// An edge disappears, with no triangle on either side any more.
    EdgeDeleted {
        /// Its ends.
        edge: [VertexId; 2],
    },
    /// An edge becomes a constraint: it must stay.
    EdgeLocked {
        /// Its ends.
        edge: [VertexId; 2],
    },
    /// An edge is no constraint any more.
    EdgeUnlocked {
        /// Its ends.
        edge: [VertexId; 2],
    },
    /// A triangle appears between three edges.
    TriangleCreated {
        /// Its corners.
        triangle: [VertexId; 3],
    },
    /// A triangle disappears; its edges stay.
    TriangleDeleted {
        /// Its corners.
        triangle: [VertexId; 3],
    },
    /// One diagonal of a quadrilateral takes the place of the other, and two triangles that of two.
    EdgeFlipped {
        /// The ends of the edge that goes.
        from: [VertexId; 2],
        /// The ends of the edge that comes.
        to: [VertexId; 2],
    },
    /// A vertex gets a place on the front: of a plane sweep, a sweep circle, a beach line.
    FrontEntered {
        /// The number of the place; a vertex may have several.
        place: u32,
        /// The vertex.
        vertex: VertexId,
        /// The place before it; `None`: it is the first.
        after: Option<u32>,
    },
    /// A place on the front is given up.
    FrontLeft {
        /// The number of the place.
        place: u32,
        /// Its vertex.
        vertex: VertexId,
        /// The place before it; `None`: it was the first.
        after: Option<u32>,
    },
    /// The sweep line or circle has come to another position.
    SweptTo {
        /// Where it was; `None`: nowhere yet.
        from: Option<Sweep>,
        /// Where it is; `None`: it is over.
        to: Option<Sweep>,
    },
    /// Something begins to wait to be looked at.
    Pushed {
        /// In which queue.
        queue: Queue,
        /// What.
        item: Item,
    },
    /// Something does not wait any more.
    Popped {
        /// In which queue.
        queue: Queue,
        /// What.
        item: Item,
    },
    /// A datum now counts for another triangle.
    DatumReassigned {
        /// The datum.
        datum: VertexId,
        /// The triangle that held it.
        from: Option<[VertexId; 3]>,
        /// The triangle that holds it.
        to: Option<[VertexId; 3]>,
    },
    /// The center of a cluster appears, moves or disappears.
    ClusterMoved {
        /// The number of the cluster.
        cluster: u32,
        /// Where it was.
        from: Option<Point>,
        /// Where it is.
        to: Option<Point>,
    },

    // ----- What is looked at
    /// It is this point's turn.
    PointConsidered {
        /// Its vertex.
        vertex: VertexId,
    },
    /// A segment's turn has come to be inserted.
    SegmentConsidered {
        /// Its ends.
        segment: [VertexId; 2],
    },
    /// It is this triangle's turn.
    TriangleConsidered {
        /// Its corners.
        triangle: [VertexId; 3],
    },
    /// An edge is looked at: is it locally Delaunay?
    EdgeExamined {
        /// Its ends.
        edge: [VertexId; 2],
    },
    /// A walk has stepped over an edge.
    WalkStepped {
        /// The edge, directed: the walk comes from its left.
        edge: [VertexId; 2],
    },
    /// A walk, or a search, has come to this triangle.
    TriangleVisited {
        /// Its corners.
        triangle: [VertexId; 3],
    },
    /// A point has been found.
    PointLocated {
        /// Its vertex.
        vertex: VertexId,
        /// In which triangle, on which edge or vertex; `None`: outside.
        at: Option<Item>,
    },
    /// Someone looks from one vertex to another.
    RayCast {
        /// From where, to where.
        ray: [VertexId; 2],
        /// Whether nothing is in the way.
        is_visible: bool,
    },
    /// On which side of a line does a point lie?
    OrientationTested {
        /// The line.
        line: [VertexId; 2],
        /// The point.
        point: VertexId,
        /// The answer.
        answer: Orientation,
    },
    /// On which side of the [circle](super::Scene::circle) through three points does a fourth lie?
    CircleTested {
        /// The three, counter-clockwise.
        triangle: [VertexId; 3],
        /// The fourth.
        point: VertexId,
        /// The answer. `On`: cocircular, decided by the perturbation.
        answer: CircleSide,
        /// Whether it counts as inside, once the perturbation has decided.
        is_inside: bool,
    },
    /// So many pairs of a triangle and a point in its circle are left.
    ConflictsCounted {
        /// Φ.
        conflicts: u64,
    },
    /// Does a triangle belong to the domain?
    InsideTested {
        /// Its corners.
        triangle: [VertexId; 3],
        /// How many edges of the rings the ray from its centroid crosses.
        crossings: u32,
        /// The answer.
        is_inside: bool,
    },
    /// A set of points is cut in two.
    SetDivided {
        /// How, and where.
        cut: Cut,
    },
    /// A cluster falls into two.
    ClusterSplit {
        /// The number of the cluster, and that of the new one.
        clusters: [u32; 2],
        /// Where it is cut.
        cut: Cut,
    },
    /// Two triangulations are about to be joined along their lower common tangent.
    TangentFound {
        /// Its ends, left and right.
        edge: [VertexId; 2],
    },
    /// A vertex lies too close to a segment.
    Encroached {
        /// The ends of the segment.
        segment: [VertexId; 2],
        /// The vertex.
        by: VertexId,
    },
    /// An edge is about to be divided at a new vertex.
    SegmentSplit {
        /// Its ends.
        edge: [VertexId; 2],
        /// The vertex, which may be the next to appear.
        vertex: VertexId,
    },
    /// A triangle is to be opened by a new vertex at its circumcenter, or at another place in its circle.
    CircumcenterProposed {
        /// Its corners.
        triangle: [VertexId; 3],
        /// That place, rounded.
        at: Point,
    },
    /// It is not: this edge is divided instead.
    CircumcenterRejected {
        /// The corners of the triangle.
        triangle: [VertexId; 3],
        /// The ends of the edge.
        edge: [VertexId; 2],
    },
    /// Every triangle holds enough data: the triangulation is good.
    CoverAccepted {
        /// How many triangles there are.
        triangles: u32,
    },
    /// A triangle holds too few data: the triangulation is no good.
    CoverRejected {
        /// Its corners.
        triangle: [VertexId; 3],
        /// How many it holds.
        data: u32,
    },
    /// An edge of the outer polygon is about to shrink to the point where its neighbours' lines meet; or else, if
    /// there is none, the polygon is to become a triangle.
    OuterReduced {
        /// Its ends.
        edge: Option<[VertexId; 2]>,
    },
    /// A place for a new vertex is tried.
    PlaceTried {
        /// Where it is, rounded.
        at: Point,
        /// How many data the new triangles would hold, data between two counted for both; 0 beyond the last one.
        counts: [u32; 4],
    },
    /// No vertex is found that divides a triangle.
    DivisionFailed {
        /// Its corners.
        triangle: [VertexId; 3],
    },
    /// An algorithm replayed as it was printed goes wrong here.
    PrintFailed {
        /// How.
        failure: Failure,
    },
    /// A part of the work is done.
    StageEnded {
        /// Which.
        stage: Stage,
        /// The smallest angle of the mesh, as far as it is known then.
        min_angle: Option<Angle>,
    },
    /// The work has not come to a good end: what follows takes it back.
    TakenBack {
        /// The first vertex that goes.
        from: VertexId,
    },
}

/// Something that waits, or has been found.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "kebab-case")
)]
pub enum Item {
    /// A vertex.
    Vertex(VertexId),
    /// An edge, by its ends.
    Edge([VertexId; 2]),
    /// A triangle, or three points whose circle matters, by its corners.
    Triangle([VertexId; 3]),
}

/// Where things wait.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "kebab-case")
)]
#[non_exhaustive]
pub enum Queue {
    /// Edges that may not be locally Delaunay: marked edges, suspects on a stack.
    Suspects,
    /// Faces and edges that a search has seen and not yet visited.
    Search,
    /// Triangles in conflict with the new point.
    Cavity,
    /// Events that a sweep expects: circles.
    Events,
    /// Edges that cross a segment.
    Crossings,
}

/// Where a set of points is cut.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "kebab-case")
)]
pub enum Cut {
    /// By a vertical line at this abscissa.
    Vertical(f64),
    /// By a horizontal line at this ordinate.
    Horizontal(f64),
}

/// Where a sweep is.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "kebab-case")
)]
pub enum Sweep {
    /// A vertical line at this abscissa.
    Vertical(f64),
    /// A horizontal line at this ordinate.
    Horizontal(f64),
    /// A circle.
    Circle {
        /// Its center.
        center: Point,
        /// Its radius.
        radius: f64,
    },
}

/// How an algorithm goes wrong that is replayed as it was printed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "kebab-case")
)]
#[non_exhaustive]
pub enum Failure {
    /// A vertex sees no vertex of the front, and is left out.
    SeesNothing(VertexId),
    /// A vertex sees a single vertex of the front: a spike.
    SeesOne(VertexId),
    /// A vertex sees several runs of the front; only one is used.
    SeesSeveralRuns(VertexId),
    /// A segment is no edge in the end.
    SegmentLost([VertexId; 2]),
    /// A triangle is clockwise, and there is no room to turn it: it lies upon others, and is left out.
    Overlaps([VertexId; 3]),
}

/// A part of an algorithm's work.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "kebab-case")
)]
#[non_exhaustive]
pub enum Stage {
    /// The points are triangulated.
    Triangulation,
    /// Segments are divided evenly, before there is a mesh.
    SplitEdges,
    /// The plane is swept.
    Sweep,
    /// Helper points are removed, and the hull is closed.
    StripHelpers,
    /// Segments are inserted.
    InsertSegments,
    /// Triangles outside of the domain are removed.
    InsideTest,
    /// Edges are flipped until all are locally Delaunay.
    Flips,
    /// A lattice of vertices is sown.
    Lattice,
    /// Bad triangles are refined, encroached segments split.
    Refinement,
    /// Vertices are moved to better places.
    Smoothing,
    /// Longest edges are bisected.
    ShortenEdges,
    /// Skinny triangles are opened.
    OpenTriangles,
    /// Edges that an order of events has left wrong, rounded or of equal ones, are flipped.
    Repair,
    /// The outer polygon is laid around the data.
    OuterPolygon,
    /// Centers of clusters are added.
    Clusters,
    /// Vertices are put on edges: Algorithm B.
    DivideEdges,
    /// Vertices are put into triangles: Algorithm C.
    DivideTriangles,
}

impl Event {
    /// Returns the event that undoes this one; what changes nothing is its own.
    pub fn reversed(self) -> Self {
        match self {
            Self::VertexCreated { vertex, at } => Self::VertexDeleted { vertex, at },
            Self::VertexDeleted { vertex, at } => Self::VertexCreated { vertex, at },
            Self::VertexMoved { vertex, from, to } => Self::VertexMoved {
                vertex,
                from: to,
                to: from,
            },
            Self::EdgeCreated { edge } => Self::EdgeDeleted { edge },
            Self::EdgeDeleted { edge } => Self::EdgeCreated { edge },
            Self::EdgeLocked { edge } => Self::EdgeUnlocked { edge },
            Self::EdgeUnlocked { edge } => Self::EdgeLocked { edge },
            Self::TriangleCreated { triangle } => Self::TriangleDeleted { triangle },
            Self::TriangleDeleted { triangle } => Self::TriangleCreated { triangle },
            Self::EdgeFlipped { from, to } => Self::EdgeFlipped { from: to, to: from },
            Self::FrontEntered {
                place,
                vertex,
                after,
            } => Self::FrontLeft {
                place,
                vertex,
                after,
            },
            Self::FrontLeft {
                place,
                vertex,
                after,
            } => Self::FrontEntered {
                place,
                vertex,
                after,
            },
            Self::SweptTo { from, to } => Self::SweptTo { from: to, to: from },
            Self::Pushed { queue, item } => Self::Popped { queue, item },
            Self::Popped { queue, item } => Self::Pushed { queue, item },
            Self::DatumReassigned { datum, from, to } => Self::DatumReassigned {
                datum,
                from: to,
                to: from,
            },
            Self::ClusterMoved { cluster, from, to } => Self::ClusterMoved {
                cluster,
                from: to,
                to: from,
            },
            other => other,
        }
    }

    /// Tells whether this changes the scene.
    pub fn changes_scene(self) -> bool {
        let may_be_its_own = matches!(
            self,
            Self::VertexMoved { .. }
                | Self::SweptTo { .. }
                | Self::DatumReassigned { .. }
                | Self::ClusterMoved { .. }
        );
        may_be_its_own || self.reversed() != self
    }
}
