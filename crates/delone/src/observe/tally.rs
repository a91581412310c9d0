//! Counting.

use super::{Event, Observer, Step};

/// How often what has happened.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Tally {
    /// Steps of any kind.
    pub steps: u64,
    /// Orientation tests.
    pub orientation_tests: u64,
    /// Circle tests.
    pub circle_tests: u64,
    /// Circle tests that were ties, decided by the perturbation.
    pub ties: u64,
    /// Edges stepped over while walking, and triangles and vertices visited while searching.
    pub walk_steps: u64,
    /// Flips.
    pub flips: u64,
    /// Edges created, flips not counted.
    pub edges_created: u64,
    /// Edges deleted, flips not counted.
    pub edges_deleted: u64,
    /// Triangles created, flips not counted.
    pub triangles_created: u64,
    /// Triangles deleted, flips not counted.
    pub triangles_deleted: u64,
    /// Vertices created.
    pub vertices_created: u64,
    /// Things that have waited in a queue.
    pub pushed: u64,
    /// Φ when it was counted first: pairs of a triangle and a point in its circle.
    pub first_conflicts: Option<u64>,
    /// Φ when it was counted last.
    pub last_conflicts: Option<u64>,
}

impl Tally {
    /// Returns how many predicates were asked.
    pub fn predicates(&self) -> u64 {
        self.orientation_tests + self.circle_tests
    }
}

impl Observer for Tally {
    fn observe(&mut self, step: Step) {
        self.steps += 1;
        match step.event {
            Event::OrientationTested { .. } => self.orientation_tests += 1,
            Event::CircleTested { answer, .. } => {
                self.circle_tests += 1;
                self.ties += u64::from(answer == crate::predicates::CircleSide::On);
            }
            Event::WalkStepped { .. } | Event::TriangleVisited { .. } => self.walk_steps += 1,
            Event::EdgeFlipped { .. } => self.flips += 1,
            Event::EdgeCreated { .. } => self.edges_created += 1,
            Event::EdgeDeleted { .. } => self.edges_deleted += 1,
            Event::TriangleCreated { .. } => self.triangles_created += 1,
            Event::TriangleDeleted { .. } => self.triangles_deleted += 1,
            Event::VertexCreated { .. } => self.vertices_created += 1,
            Event::Pushed { .. } => self.pushed += 1,
            Event::ConflictsCounted { conflicts } => {
                self.first_conflicts.get_or_insert(conflicts);
                self.last_conflicts = Some(conflicts);
            }
            _ => {}
        }
    }
}
