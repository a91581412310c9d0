//! A run, kept.

use super::{NoSuchStep, Observer, Scene, Step};
use crate::Point;

/// All steps of a run, and the points that there were before the first: enough to play it on a [`Scene`].
///
/// A run that starts from a triangulation lays it out first, in steps of line 0.
///
/// *Memory*: some 70 bytes a step.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Log {
    /// The [name](crate::classic::About::name) of the algorithm.
    pub algorithm: String,
    /// The points of the input, duplicates included: vertex `i` is point `i`.
    pub points: Vec<Point>,
    /// The steps.
    pub steps: Vec<Step>,
}

impl Log {
    /// Begins with points, and nothing between them.
    pub fn new(algorithm: &str, points: impl Into<Vec<Point>>) -> Self {
        Self {
            algorithm: algorithm.to_owned(),
            points: points.into(),
            ..Self::default()
        }
    }

    /// Returns the scene before the first step.
    pub fn first_scene(&self) -> Scene {
        Scene::new(self.points.iter().copied())
    }

    /// Plays all steps, and returns the scene after the last.
    ///
    /// # Errors
    /// If a step does not fit what those before it have made.
    pub fn last_scene(&self) -> Result<Scene, NoSuchStep> {
        let mut scene = self.first_scene();
        for step in &self.steps {
            scene.apply(step.event)?;
        }
        Ok(scene)
    }
}

impl Observer for Log {
    fn observe(&mut self, step: Step) {
        self.steps.push(step);
    }

    fn wants_conflicts(&self) -> bool {
        true
    }
}
