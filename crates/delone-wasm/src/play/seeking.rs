//! Steps by their kind.

use crate::Trouble;
use delone::{Event, Queue, Step};

/// The name of a kind of events, as logs write it.
pub(super) type Kind = &'static str;

/// Groups of kinds.
const GROUPS: &[&str] = &[
    "flip",
    "insertion",
    "test",
    "change",
    "stage",
    "line",
    "result",
];

/// Names the kind of an event.
pub(super) fn kind(event: &Event) -> Kind {
    match event {
        Event::VertexCreated { .. } => "vertex-created",
        Event::VertexDeleted { .. } => "vertex-deleted",
        Event::VertexMoved { .. } => "vertex-moved",
        Event::EdgeCreated { .. } => "edge-created",
        Event::EdgeDeleted { .. } => "edge-deleted",
        Event::EdgeLocked { .. } => "edge-locked",
        Event::EdgeUnlocked { .. } => "edge-unlocked",
        Event::TriangleCreated { .. } => "triangle-created",
        Event::TriangleDeleted { .. } => "triangle-deleted",
        Event::EdgeFlipped { .. } => "edge-flipped",
        Event::FrontEntered { .. } => "front-entered",
        Event::FrontLeft { .. } => "front-left",
        Event::SweptTo { .. } => "swept-to",
        Event::Pushed { .. } => "pushed",
        Event::Popped { .. } => "popped",
        Event::DatumReassigned { .. } => "datum-reassigned",
        Event::ClusterMoved { .. } => "cluster-moved",
        _ => look(event),
    }
}

fn look(event: &Event) -> Kind {
    match event {
        Event::PointConsidered { .. } => "point-considered",
        Event::SegmentConsidered { .. } => "segment-considered",
        Event::TriangleConsidered { .. } => "triangle-considered",
        Event::EdgeExamined { .. } => "edge-examined",
        Event::WalkStepped { .. } => "walk-stepped",
        Event::TriangleVisited { .. } => "triangle-visited",
        Event::PointLocated { .. } => "point-located",
        Event::RayCast { .. } => "ray-cast",
        Event::OrientationTested { .. } => "orientation-tested",
        Event::CircleTested { .. } => "circle-tested",
        Event::ConflictsCounted { .. } => "conflicts-counted",
        Event::InsideTested { .. } => "inside-tested",
        Event::SetDivided { .. } => "set-divided",
        Event::ClusterSplit { .. } => "cluster-split",
        Event::TangentFound { .. } => "tangent-found",
        Event::Encroached { .. } => "encroached",
        Event::SegmentSplit { .. } => "segment-split",
        Event::CircumcenterProposed { .. } => "circumcenter-proposed",
        Event::CircumcenterRejected { .. } => "circumcenter-rejected",
        Event::CoverAccepted { .. } => "cover-accepted",
        Event::CoverRejected { .. } => "cover-rejected",
        Event::OuterReduced { .. } => "outer-reduced",
        Event::PlaceTried { .. } => "place-tried",
        Event::DivisionFailed { .. } => "division-failed",
        Event::PrintFailed { .. } => "print-failed",
        Event::StageEnded { .. } => "stage-ended",
        Event::TakenBack { .. } => "taken-back",
        _ => "other",
    }
}

/// Tells whether the step before a position is of a kind.
pub(super) fn is(steps: &[Step], end: usize, wanted: &str) -> bool {
    let Step { line, event } = steps[end - 1];
    match wanted {
        "flip" => matches!(event, Event::EdgeFlipped { .. }),
        "insertion" => matches!(
            event,
            Event::PointConsidered { .. }
                | Event::SegmentConsidered { .. }
                | Event::VertexCreated { .. }
        ),
        "test" => matches!(
            event,
            Event::OrientationTested { .. }
                | Event::CircleTested { .. }
                | Event::InsideTested { .. }
        ),
        "change" => {
            let waits = matches!(event, Event::Pushed { .. } | Event::Popped { .. });
            event.changes_scene() && !waits
        }
        "stage" => matches!(event, Event::StageEnded { .. }),
        "line" => end < 2 || steps[end - 2].line != line,
        "result" => end == steps.len(),
        wanted => kind(&event) == wanted,
    }
}

/// Refuses what is no kind of steps.
pub(super) fn require_known(wanted: &str) -> Result<(), Trouble> {
    // Kinds of events are told by their hyphens: of a log, whichever it has, no other is ever found.
    let may_be_kind = wanted.contains('-') || ["pushed", "popped", "encroached"].contains(&wanted);
    match may_be_kind || GROUPS.contains(&wanted) {
        true => Ok(()),
        false => Err(Trouble::asked(format!(
            "no kind of step is called {wanted:?}; there are those of events and {}",
            GROUPS.join(", ")
        ))),
    }
}

/// Finds a queue by its name.
pub(super) fn queue(name: &str) -> Result<Queue, Trouble> {
    match name {
        "suspects" => Ok(Queue::Suspects),
        "search" => Ok(Queue::Search),
        "cavity" => Ok(Queue::Cavity),
        "events" => Ok(Queue::Events),
        "crossings" => Ok(Queue::Crossings),
        _ => Err(Trouble::asked(format!(
            "no queue is called {name:?}; there are suspects, search, cavity, events, crossings"
        ))),
    }
}
