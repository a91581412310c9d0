//! What a step does, in a few words.

use delone::predicates::{CircleSide, Orientation};
use delone::{Event, Failure, Queue, Stage};

/// Says what happens. Numbers of vertices are left to the drawing.
pub(super) fn words(event: Event) -> &'static str {
    match event {
        Event::VertexCreated { .. } => "a vertex is added",
        Event::VertexDeleted { .. } => "a vertex is removed",
        Event::VertexMoved { .. } => "a vertex moves",
        Event::EdgeCreated { .. } => "an edge is created",
        Event::EdgeDeleted { .. } => "an edge is deleted",
        Event::EdgeLocked { .. } => "an edge becomes a constraint",
        Event::EdgeUnlocked { .. } => "an edge is no constraint any more",
        Event::TriangleCreated { .. } => "a triangle is created",
        Event::TriangleDeleted { .. } => "a triangle is deleted",
        Event::EdgeFlipped { .. } => "the edge is flipped",
        Event::FrontEntered { .. } => "a vertex enters the front",
        Event::FrontLeft { .. } => "a vertex leaves the front",
        Event::SweptTo { .. } => "the sweep goes on",
        Event::Pushed { queue, .. } => pushed(queue),
        Event::Popped { queue, .. } => popped(queue),
        Event::DatumReassigned { .. } => "a point counts for another triangle",
        Event::ClusterMoved { .. } => "the center of a cluster moves",
        Event::PointConsidered { .. } => "it is this point's turn",
        Event::SegmentConsidered { .. } => "it is this segment's turn",
        Event::TriangleConsidered { .. } => "it is this triangle's turn",
        Event::EdgeExamined { .. } => "is this edge locally Delaunay?",
        Event::WalkStepped { .. } => "the walk crosses an edge",
        Event::TriangleVisited { .. } => "the search visits a triangle",
        Event::PointLocated { at: Some(_), .. } => "the point is found here",
        Event::PointLocated { at: None, .. } => "the point lies outside",
        Event::RayCast { is_visible, .. } => match is_visible {
            true => "nothing is in the way",
            false => "something is in the way",
        },
        Event::OrientationTested { answer, .. } => match answer {
            Orientation::Left => "orientation: left",
            Orientation::Right => "orientation: right",
            Orientation::Collinear => "orientation: on the line",
        },
        Event::CircleTested {
            answer, is_inside, ..
        } => circle(answer, is_inside),
        Event::ConflictsCounted { .. } => "conflicts are counted",
        Event::InsideTested { is_inside, .. } => match is_inside {
            true => "the triangle belongs to the domain",
            false => "the triangle lies outside of the domain",
        },
        Event::SetDivided { .. } => "the points are divided",
        Event::ClusterSplit { .. } => "a cluster is divided",
        Event::TangentFound { .. } => "the lower common tangent",
        Event::Encroached { .. } => "a vertex lies too close to a segment",
        Event::SegmentSplit { .. } => "an edge is divided",
        Event::CircumcenterProposed { .. } => "a place for a vertex is proposed",
        Event::CircumcenterRejected { .. } => "that place is rejected",
        Event::CoverAccepted { .. } => "every triangle holds enough data",
        Event::CoverRejected { .. } => "this triangle holds too few data",
        Event::OuterReduced { edge: Some(_) } => "the outer polygon loses an edge",
        Event::OuterReduced { edge: None } => "the outer polygon becomes a triangle",
        Event::PlaceTried { .. } => "would a vertex here leave enough?",
        Event::DivisionFailed { .. } => "no vertex divides this triangle",
        Event::PrintFailed { failure } => failed(failure),
        Event::StageEnded { stage, .. } => ended(stage),
        Event::TakenBack { .. } => "what follows is taken back",
        _ => "",
    }
}

fn circle(answer: CircleSide, is_inside: bool) -> &'static str {
    match (answer, is_inside) {
        (CircleSide::Inside, _) => "circle test: inside",
        (CircleSide::Outside, _) => "circle test: outside",
        (CircleSide::On, true) => "circle test: a tie, counts as inside",
        (CircleSide::On, false) => "circle test: a tie, counts as outside",
    }
}

fn pushed(queue: Queue) -> &'static str {
    match queue {
        Queue::Suspects => "an edge is suspect now",
        Queue::Search => "seen, and still to be visited",
        Queue::Cavity => "the triangle is in conflict",
        Queue::Events => "an event is expected",
        Queue::Crossings => "an edge crosses the segment",
        _ => "something waits",
    }
}

fn popped(queue: Queue) -> &'static str {
    match queue {
        Queue::Suspects => "the next suspect edge",
        Queue::Search => "the next one of the search",
        Queue::Cavity => "the next triangle in conflict",
        Queue::Events => "an expected event",
        Queue::Crossings => "the next crossing edge",
        _ => "the next one that waits",
    }
}

fn failed(failure: Failure) -> &'static str {
    match failure {
        Failure::SeesNothing(_) => "the print fails: sees nothing",
        Failure::SeesOne(_) => "the print fails: a spike",
        Failure::SeesSeveralRuns(_) => "the print fails: several runs",
        Failure::SegmentLost(_) => "the print fails: a segment is lost",
        _ => "the print fails",
    }
}

fn ended(stage: Stage) -> &'static str {
    match stage {
        Stage::Triangulation => "done: the points are triangulated",
        Stage::SplitEdges => "done: segments are divided",
        Stage::Sweep => "done: the sweep",
        Stage::StripHelpers => "done: helper points are removed",
        Stage::InsertSegments => "done: segments are inserted",
        Stage::InsideTest => "done: the domain is cut out",
        Stage::Flips => "done: flips",
        Stage::Lattice => "done: a lattice is sown",
        Stage::Refinement => "done: refinement",
        Stage::Smoothing => "done: smoothing",
        Stage::ShortenEdges => "done: long edges are bisected",
        Stage::OpenTriangles => "done: skinny triangles are opened",
        Stage::Repair => "done: repairs",
        Stage::OuterPolygon => "done: the outer polygon",
        Stage::Clusters => "done: centers of clusters",
        Stage::DivideEdges => "done: vertices on edges",
        Stage::DivideTriangles => "done: vertices in triangles",
        _ => "done: a stage",
    }
}
