//! What has been done up to any step, without counting again from the first: the counts are kept now and then.
//!
//! *Cost*: a look at each step at the beginning; afterwards at most [`STRIDE`] steps are counted, some µs; a position
//! is sought by halving, some twenty counts.

use super::Player;
use super::clock::Times;
use crate::{Trouble, json};
use delone::{Log, Observer, Step, Tally};
use serde::Serialize;
use wasm_bindgen::prelude::wasm_bindgen;

/// Steps between two counts that are kept: counted again in a few µs.
const STRIDE: usize = 1 << 12;

/// The counts of a run after each [`STRIDE`] steps, and its times.
pub(super) struct Ledger {
    kept: Vec<Tally>,
    /// Unknown for runs that have been read from files.
    times: Option<Times>,
}

/// What work is measured by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Unit {
    Steps,
    Predicates,
    Milliseconds,
}

impl Unit {
    fn named(name: &str) -> Result<Self, Trouble> {
        match name {
            "steps" => Ok(Self::Steps),
            "predicates" => Ok(Self::Predicates),
            "milliseconds" => Ok(Self::Milliseconds),
            _ => Err(Trouble::asked(format!(
                "no unit of work is called {name:?}; there are steps, predicates, milliseconds"
            ))),
        }
    }
}

impl Ledger {
    /// Counts all steps.
    pub fn new(log: &Log, times: Option<Times>) -> Self {
        let mut tally = Tally::default();
        let mut kept = Vec::with_capacity(log.steps.len() / STRIDE + 1);
        for stretch in log.steps.chunks(STRIDE) {
            kept.push(tally);
            stretch.iter().for_each(|&step| tally.observe(step));
        }
        kept.push(tally);
        Self { kept, times }
    }

    /// Counts what the first `position` steps have done.
    pub fn tally_at(&self, steps: &[Step], position: usize) -> Tally {
        let position = position.min(steps.len());
        let nearest = (position / STRIDE).min(self.kept.len() - 1);
        let mut tally = self.kept[nearest];
        let rest = &steps[nearest * STRIDE..position];
        rest.iter().for_each(|&step| tally.observe(step));
        tally
    }

    /// Tells how much the first `position` steps have used, `None` if that is not known.
    fn used(&self, steps: &[Step], position: usize, unit: Unit) -> Option<f64> {
        match unit {
            Unit::Steps => Some(position as f64),
            Unit::Predicates => Some(self.tally_at(steps, position).predicates() as f64),
            Unit::Milliseconds => Some(self.times.as_ref()?.at(position)),
        }
    }

    /// Finds the last position that has used no more than `amount`.
    fn position_at(&self, steps: &[Step], unit: Unit, amount: f64) -> Option<usize> {
        // What is used never becomes less, so the last such position is found by halving.
        let (mut low, mut high) = (0, steps.len());
        while low < high {
            let middle = high - (high - low) / 2;
            match self.used(steps, middle, unit)? <= amount {
                true => low = middle,
                false => high = middle - 1,
            }
        }
        self.used(steps, low, unit).map(|_| low)
    }
}

/// Counts, with keys in camel case as everywhere here.
#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Counts {
    steps: u64,
    orientation_tests: u64,
    circle_tests: u64,
    ties: u64,
    walk_steps: u64,
    flips: u64,
    edges_created: u64,
    edges_deleted: u64,
    triangles_created: u64,
    triangles_deleted: u64,
    vertices_created: u64,
    pushed: u64,
    first_conflicts: Option<u64>,
    last_conflicts: Option<u64>,
}

impl From<Tally> for Counts {
    fn from(tally: Tally) -> Self {
        Self {
            steps: tally.steps,
            orientation_tests: tally.orientation_tests,
            circle_tests: tally.circle_tests,
            ties: tally.ties,
            walk_steps: tally.walk_steps,
            flips: tally.flips,
            edges_created: tally.edges_created,
            edges_deleted: tally.edges_deleted,
            triangles_created: tally.triangles_created,
            triangles_deleted: tally.triangles_deleted,
            vertices_created: tally.vertices_created,
            pushed: tally.pushed,
            first_conflicts: tally.first_conflicts,
            last_conflicts: tally.last_conflicts,
        }
    }
}

#[wasm_bindgen]
impl Player {
    /// Counts what the whole run has done, as JSON: `{steps, orientationTests, circleTests, ties, walkSteps, flips,
    /// edgesCreated, edgesDeleted, trianglesCreated, trianglesDeleted, verticesCreated, pushed, firstConflicts,
    /// lastConflicts}`.
    pub fn tally(&self) -> String {
        self.tally_at(u32::MAX)
    }

    /// Counts what the first `position` steps have done, as `tally` does; it takes a few µs anywhere.
    #[wasm_bindgen(js_name = tallyAt)]
    pub fn tally_at(&self, position: u32) -> String {
        let tally = self.ledger.tally_at(self.steps(), position as usize);
        json::write(&Counts::from(tally))
    }

    /// Finds the last position that has used no more than `amount` of a unit: `"steps"`, `"predicates"` or
    /// `"milliseconds"`, of the recording. So runs race: all are shown where they have used the same.
    ///
    /// A run that has been read from a file has no times.
    #[wasm_bindgen(js_name = positionAt)]
    pub fn position_at(&self, unit: &str, amount: f64) -> Result<u32, Trouble> {
        let unit = Unit::named(unit)?;
        let found = self.ledger.position_at(self.steps(), unit, amount);
        let found = found.ok_or_else(|| {
            Trouble::asked(
                "a run that was read from a file has no times: race by steps or predicates",
            )
        })?;
        Ok(found as u32)
    }

    /// Tells how much the whole run has used of a unit; `undefined` if that is not known.
    pub fn total(&self, unit: &str) -> Result<Option<f64>, Trouble> {
        let steps = self.steps();
        let unit = Unit::named(unit)?;
        Ok(self.ledger.used(steps, steps.len(), unit))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::Drawing;

    fn player() -> Player {
        let drawing = Drawing::preset("uniform", 300, 1).expect("points");
        Player::run("incremental", &drawing, None, None).expect("a run")
    }

    #[test]
    fn counts_up_to_a_position_are_those_of_its_steps() {
        let player = player();
        let steps = player.steps();
        assert!(steps.len() > 2 * STRIDE, "only {} steps", steps.len());
        let mut tally = Tally::default();
        for position in 0..=steps.len() {
            // All near the stretches' ends, and some others.
            if (position + 2) % STRIDE < 4 || position % 97 == 0 || position == steps.len() {
                assert_eq!(player.ledger.tally_at(steps, position), tally);
            }
            steps
                .get(position)
                .into_iter()
                .for_each(|&step| tally.observe(step));
        }
        assert_eq!(player.tally(), json::write(&Counts::from(tally)));
    }

    #[test]
    fn the_last_position_within_an_amount_is_found() {
        let player = player();
        let steps = player.steps();
        for unit in ["steps", "predicates", "milliseconds"] {
            let used = |position| {
                let used = player
                    .ledger
                    .used(steps, position, Unit::named(unit).expect(unit));
                used.expect("times")
            };
            let total = player.total(unit).expect(unit).expect("times");
            assert!(total > 0.0 && total == used(steps.len()), "{unit}");
            for share in [-1.0, 0.0, 0.1, 0.5, 0.77, 1.0, 2.0] {
                let amount = share * total;
                let found = player.position_at(unit, amount).expect(unit) as usize;
                assert!(found == 0 || used(found) <= amount, "{unit} {share}");
                assert!(
                    found == steps.len() || used(found + 1) > amount,
                    "{unit} {share}"
                );
            }
            assert_eq!(player.position_at(unit, f64::NAN).expect(unit), 0);
        }
        player.position_at("hours", 1.0).expect_err("no such unit");
    }

    #[test]
    fn a_run_from_a_file_has_no_times() {
        let drawing = Drawing::new(&[], &[], &[]).expect("nothing");
        let player = Player::run("incremental", &drawing, None, None).expect("a run");
        assert_eq!(
            player.total("steps").expect("a unit"),
            Some(player.length().into())
        );
        let files = player.save("run.dlog", None).expect("a log");
        let player = Player::from_log("run.dlog", &files[0].bytes()).expect("a run");
        assert_eq!(player.total("milliseconds").expect("a unit"), None);
        let error = player
            .position_at("milliseconds", 1.0)
            .expect_err("no times");
        assert!(error.to_string().contains("times"));
        assert_eq!(
            player.position_at("predicates", 1e9).expect("a unit"),
            player.length()
        );
    }
}
