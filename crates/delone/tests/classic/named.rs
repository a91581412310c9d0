//! Which vertices an event names.

use delone::{Event, Failure, Item, VertexId};

/// Lists the vertices that an event names.
///
/// # Panics
/// If it is one that this does not know.
pub fn named(event: Event) -> Vec<VertexId> {
    match event {
        Event::VertexCreated { vertex, .. }
        | Event::VertexDeleted { vertex, .. }
        | Event::VertexMoved { vertex, .. }
        | Event::FrontEntered { vertex, .. }
        | Event::FrontLeft { vertex, .. }
        | Event::PointConsidered { vertex } => vec![vertex],
        Event::EdgeCreated { edge }
        | Event::EdgeDeleted { edge }
        | Event::EdgeLocked { edge }
        | Event::EdgeUnlocked { edge }
        | Event::EdgeExamined { edge }
        | Event::WalkStepped { edge }
        | Event::TangentFound { edge }
        | Event::SegmentConsidered { segment: edge }
        | Event::RayCast { ray: edge, .. } => edge.to_vec(),
        Event::TriangleCreated { triangle }
        | Event::TriangleDeleted { triangle }
        | Event::TriangleConsidered { triangle }
        | Event::TriangleVisited { triangle }
        | Event::InsideTested { triangle, .. }
        | Event::CoverRejected { triangle, .. }
        | Event::DivisionFailed { triangle }
        | Event::CircumcenterProposed { triangle, .. } => triangle.to_vec(),
        Event::OuterReduced { edge } => edge.into_iter().flatten().collect(),
        Event::EdgeFlipped { from, to } => [from, to].concat(),
        Event::Pushed { item, .. } | Event::Popped { item, .. } => of_item(item),
        Event::PointLocated { vertex, at } => with(at.map_or(Vec::new(), of_item), vertex),
        Event::DatumReassigned { datum, from, to } => {
            with([from, to].into_iter().flatten().flatten().collect(), datum)
        }
        Event::OrientationTested { line, point, .. } => with(line.to_vec(), point),
        Event::CircleTested {
            triangle, point, ..
        } => with(triangle.to_vec(), point),
        Event::Encroached { segment, by } => with(segment.to_vec(), by),
        // Its vertex may be the next to appear.
        Event::SegmentSplit { edge, .. } => edge.to_vec(),
        Event::CircumcenterRejected { triangle, edge } => [&triangle[..], &edge].concat(),
        Event::PrintFailed { failure } => of_failure(failure),
        // The first that goes, if any: there may be none of this number.
        Event::TakenBack { .. } => Vec::new(),
        Event::SweptTo { .. }
        | Event::ClusterMoved { .. }
        | Event::ClusterSplit { .. }
        | Event::ConflictsCounted { .. }
        | Event::SetDivided { .. }
        | Event::CoverAccepted { .. }
        | Event::PlaceTried { .. }
        | Event::StageEnded { .. } => Vec::new(),
        other => panic!("which vertices does it name? {other:?}"),
    }
}

fn with(mut vertices: Vec<VertexId>, vertex: VertexId) -> Vec<VertexId> {
    vertices.push(vertex);
    vertices
}

fn of_item(item: Item) -> Vec<VertexId> {
    match item {
        Item::Vertex(v) => vec![v],
        Item::Edge(edge) => edge.to_vec(),
        Item::Triangle(triangle) => triangle.to_vec(),
    }
}

fn of_failure(failure: Failure) -> Vec<VertexId> {
    match failure {
        Failure::SeesNothing(v) | Failure::SeesOne(v) | Failure::SeesSeveralRuns(v) => vec![v],
        Failure::SegmentLost(segment) => segment.to_vec(),
        Failure::Overlaps(triangle) => triangle.to_vec(),
        other => panic!("which vertices does it name? {other:?}"),
    }
}
