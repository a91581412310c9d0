//! Going to any step of a run quickly: scenes are kept on the way, and the way begins at the nearest.
//!
//! *Cost*: the first way to the end takes every step, a fraction of a µs each; afterwards few ways are longer than
//! half a stride, which is a 64th of the run or 4096 steps, or up to a 4th of the run if scenes are large. *Memory*:
//! that of the scenes kept, some 100 MB unless a few are larger than that.

use delone::{Log, NoSuchStep, Scene};
use std::collections::BTreeMap;

/// Steps that are taken sooner than a scene is copied.
const NEAR: usize = 1 << 12;

/// How many vertices all kept scenes may have together.
const ROOM: usize = 1 << 19;

/// A scene of a run, and some others to begin at.
pub(super) struct Tape {
    scene: Scene,
    /// How many steps have been taken.
    position: usize,
    /// Scenes, by how many steps have been taken.
    kept: BTreeMap<usize, Scene>,
    stride: usize,
}

impl Tape {
    /// Begins before the first step.
    pub fn new(log: &Log) -> Self {
        let scenes = (ROOM / (log.points.len() + 1)).clamp(4, 64);
        Self {
            scene: log.first_scene(),
            position: 0,
            kept: BTreeMap::from([(0, log.first_scene())]),
            stride: log.steps.len().div_ceil(scenes).max(NEAR),
        }
    }

    /// Returns the scene.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// Tells how many steps have been taken.
    pub fn position(&self) -> usize {
        self.position
    }

    /// Goes to where `target` steps have been taken.
    ///
    /// # Errors
    /// If a step does not fit; then it stands before it.
    pub fn seek(&mut self, log: &Log, target: usize) -> Result<(), NoSuchStep> {
        let target = target.min(log.steps.len());
        self.jump(target);
        while self.position < target {
            self.scene.apply(log.steps[self.position].event)?;
            self.position += 1;
            self.keep();
        }
        while self.position > target {
            self.scene.revert(log.steps[self.position - 1].event)?;
            self.position -= 1;
        }
        Ok(())
    }

    /// Goes to the kept scene that is nearest, if that is much nearer.
    fn jump(&mut self, target: usize) {
        let before = self.kept.range(..=target).next_back();
        let after = self.kept.range(target..).next();
        let all = before.into_iter().chain(after);
        let Some((&at, scene)) = all.min_by_key(|&(at, _)| at.abs_diff(target)) else {
            return;
        };
        if at.abs_diff(target) + NEAR < self.position.abs_diff(target) {
            self.scene.clone_from(scene);
            self.position = at;
        }
    }

    fn keep(&mut self) {
        let is_due = self.position.is_multiple_of(self.stride);
        if is_due && !self.kept.contains_key(&self.position) {
            self.kept.insert(self.position, self.scene.clone());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use delone::classic::{Algorithm, Input};

    fn log() -> Log {
        let points = (0..900u32).map(|i| [i * 7919 % 1009, i * i % 997].map(f64::from));
        let input = Input::from_points(points);
        let mut log = Log::new("incremental", input.pslg.points.clone());
        let run = Algorithm::Incremental.observe(&input, &mut log);
        run.expect("a run");
        log
    }

    #[test]
    fn every_way_leads_to_the_same_scene() {
        let log = log();
        let steps = log.steps.len();
        assert!(steps > 4 * NEAR, "only {steps} steps");
        let mut tape = Tape::new(&log);
        let places = [
            steps,
            0,
            steps / 2,
            steps / 3,
            steps / 2 + 1,
            steps,
            1,
            steps / 5,
        ];
        for place in places {
            tape.seek(&log, place).expect("a step that fits");
            let mut scene = log.first_scene();
            for step in &log.steps[..place] {
                scene.apply(step.event).expect("a step that fits");
            }
            assert_eq!((tape.position(), tape.scene()), (place, &scene));
        }
        assert!(tape.kept.len() > 3);
        tape.seek(&log, usize::MAX).expect("the end");
        assert_eq!(tape.position(), steps);
    }

    #[test]
    fn a_step_that_does_not_fit_stops_it() {
        let mut log = log();
        let last = *log.steps.last().expect("steps");
        log.steps.truncate(10);
        let vertex = delone::VertexId::new(5_000_000);
        let missing = delone::Event::VertexDeleted {
            vertex,
            at: log.points[0],
        };
        log.steps.push(delone::Step {
            event: missing,
            ..last
        });
        let mut tape = Tape::new(&log);
        tape.seek(&log, 11).unwrap_err();
        assert_eq!(tape.position(), 10);
        tape.seek(&log, 0).expect("back");
    }
}
