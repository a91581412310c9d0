//! How a number changes over a run, as a few points of a curve.

use super::Player;
use crate::Trouble;
use delone::{Event, Log};
use wasm_bindgen::prelude::wasm_bindgen;

/// Pairs that one bucket keeps: first, last, lowest and highest.
const KEPT: usize = 4;

/// A number that changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Curve {
    Conflicts,
    Triangles,
    Edges,
    Vertices,
    Flips,
    Predicates,
    Queue,
    MinAngle,
}

/// A value, and how many steps have been taken when it begins to hold.
type Sample = (usize, f64);

impl Curve {
    const ALL: [(&'static str, Self); 8] = [
        ("conflicts", Self::Conflicts),
        ("triangles", Self::Triangles),
        ("edges", Self::Edges),
        ("vertices", Self::Vertices),
        ("flips", Self::Flips),
        ("predicates", Self::Predicates),
        ("queue", Self::Queue),
        ("minAngle", Self::MinAngle),
    ];

    /// Finds a curve by its name.
    pub fn named(name: &str) -> Result<Self, Trouble> {
        let found = Self::ALL.iter().find(|(known, _)| *known == name);
        found.map(|&(_, curve)| curve).ok_or_else(|| {
            let names = Self::ALL.map(|(name, _)| name).join(", ");
            Trouble::asked(format!("no curve is called {name:?}; there are {names}"))
        })
    }

    /// Returns its value before the first step, if it is known.
    fn first(self, log: &Log) -> Option<f64> {
        match self {
            Self::Conflicts | Self::MinAngle => None,
            Self::Vertices => Some(log.points.len() as f64),
            _ => Some(0.0),
        }
    }

    /// Returns its value after an event that tells or changes it.
    fn after(self, value: Option<f64>, event: &Event) -> Option<f64> {
        match (self, event) {
            (Self::Conflicts, &Event::ConflictsCounted { conflicts }) => Some(conflicts as f64),
            (Self::MinAngle, Event::StageEnded { min_angle, .. }) => {
                min_angle.map(|angle| angle.to_degrees())
            }
            _ => Some(value? + self.change(event)?),
        }
    }

    fn change(self, event: &Event) -> Option<f64> {
        match (self, event) {
            (Self::Triangles, Event::TriangleCreated { .. })
            | (Self::Edges, Event::EdgeCreated { .. })
            | (Self::Vertices, Event::VertexCreated { .. })
            | (Self::Flips, Event::EdgeFlipped { .. })
            | (Self::Predicates, Event::OrientationTested { .. } | Event::CircleTested { .. })
            | (Self::Queue, Event::Pushed { .. }) => Some(1.0),
            (Self::Triangles, Event::TriangleDeleted { .. })
            | (Self::Edges, Event::EdgeDeleted { .. })
            | (Self::Vertices, Event::VertexDeleted { .. })
            | (Self::Queue, Event::Popped { .. }) => Some(-1.0),
            _ => None,
        }
    }

    /// Visits its values in a run, each from where it begins to hold.
    pub fn samples(self, log: &Log) -> impl Iterator<Item = Sample> {
        let mut value = self.first(log);
        let first = value.map(|value| (0, value));
        let told = (1..).zip(&log.steps).filter_map(move |(position, step)| {
            let after = self.after(value, &step.event)?;
            value = Some(after);
            Some((position, after))
        });
        first.into_iter().chain(told)
    }

    /// Lists its values; if they are more than `limit`, first, last, lowest and highest of equal stretches of the
    /// run. None if nothing ever tells or changes it.
    fn drawn(self, log: &Log, limit: usize) -> Vec<Sample> {
        let samples = || self.samples(log);
        let is_told = samples().any(|(position, _)| position > 0);
        if !is_told {
            return Vec::new();
        }
        if samples().count() <= limit {
            return samples().collect();
        }
        thinned(samples(), log.steps.len(), limit / KEPT)
    }
}

/// Keeps first, last, lowest and highest sample of each of some equal stretches.
fn thinned(samples: impl Iterator<Item = Sample>, length: usize, buckets: usize) -> Vec<Sample> {
    let bucket = |position: usize| (position as u64 * buckets as u64) / (length as u64 + 1);
    let mut kept = Vec::with_capacity(KEPT * buckets);
    let mut current: Option<(u64, [Sample; KEPT])> = None;
    for sample in samples {
        let of = bucket(sample.0);
        match &mut current {
            Some((known, extremes)) if *known == of => widen(extremes, sample),
            _ => {
                current
                    .into_iter()
                    .for_each(|(_, done)| put(&mut kept, done));
                current = Some((of, [sample; KEPT]));
            }
        }
    }
    current
        .into_iter()
        .for_each(|(_, done)| put(&mut kept, done));
    kept
}

fn widen([_, lowest, highest, last]: &mut [Sample; KEPT], sample: Sample) {
    if sample.1 < lowest.1 {
        *lowest = sample;
    }
    if sample.1 > highest.1 {
        *highest = sample;
    }
    *last = sample;
}

fn put(kept: &mut Vec<Sample>, mut extremes: [Sample; KEPT]) {
    extremes.sort_by_key(|&(position, _)| position);
    kept.extend(extremes);
    kept.dedup_by_key(|&mut (position, _)| position);
}

#[wasm_bindgen]
impl Player {
    /// Returns how a number changes over the whole run, as pairs: a position, and the value that holds from there
    /// on. Numbers are `"conflicts"` (Φ, in small runs of some algorithms), `"triangles"`, `"edges"`,
    /// `"vertices"`, `"flips"` and `"predicates"` so far, `"queue"` (all that waits anywhere) and `"minAngle"` (in
    /// degrees, where stages tell it). Empty if it is never told and never changes.
    ///
    /// If there are more than `limit` pairs, at least 4, then of equal stretches of the run only the first, the
    /// last, the lowest and the highest.
    pub fn curve(&self, name: &str, limit: Option<u32>) -> Result<Vec<f64>, Trouble> {
        let limit = limit.map_or(usize::MAX, |limit| limit as usize);
        if limit < KEPT {
            let message = format!("a curve of {limit} pairs shows nothing: ask for {KEPT} or more");
            return Err(Trouble::asked(message));
        }
        let samples = Curve::named(name)?.drawn(&self.recording.log, limit);
        let pairs = samples.into_iter();
        Ok(pairs.flat_map(|(at, value)| [at as f64, value]).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::Drawing;

    fn run(algorithm: &str, preset: &str) -> Player {
        let drawing = Drawing::preset(preset, 40, 1).expect("a preset");
        Player::run(algorithm, &drawing, None, None).expect("a run")
    }

    fn curve(player: &Player, name: &str, limit: Option<u32>) -> Vec<[f64; 2]> {
        let flat = player.curve(name, limit).expect("a curve");
        flat.as_chunks().0.to_vec()
    }

    /// What a scene says, step by step, is what the curve says.
    #[test]
    fn curves_are_those_of_the_scenes() {
        for (algorithm, preset) in [
            ("incremental", "uniform"),
            ("thesis", "thesis"),
            ("greedy-flips", "grid"),
            ("flip-list", "cocircular"),
            ("bowyer-watson", "collinear"),
        ] {
            let mut player = run(algorithm, preset);
            let curves =
                ["triangles", "edges", "vertices", "queue"].map(|name| curve(&player, name, None));
            for position in 0..=player.length() {
                player.seek(position).expect("a step that fits");
                let scene = player.scene();
                let queues = ["suspects", "search", "cavity", "events", "crossings"];
                let waiting = queues.map(|queue| player.waiting(queue).expect("a queue").len() / 3);
                let expected = [
                    scene.triangles().count(),
                    scene.edges().count(),
                    scene.vertices().count(),
                    waiting.iter().sum(),
                ];
                for (curve, expected) in curves.iter().zip(expected) {
                    let known = curve
                        .iter()
                        .rev()
                        .find(|pair| pair[0] <= f64::from(position));
                    let agrees = known.is_none_or(|pair| pair[1] == expected as f64);
                    assert!(agrees, "{algorithm} at {position}");
                }
            }
        }
    }

    #[test]
    fn curves_end_with_what_the_run_has_done() {
        let player = run("greedy-flips", "uniform");
        let tally = player.ledger.tally_at(player.steps(), usize::MAX);
        let last = |name| curve(&player, name, None).last().map(|pair| pair[1]);
        assert_eq!(last("flips"), Some(tally.flips as f64));
        assert_eq!(last("predicates"), Some(tally.predicates() as f64));
        assert_eq!(last("conflicts"), tally.last_conflicts.map(|n| n as f64));
        assert_eq!(last("conflicts"), Some(0.0));
        assert_eq!(last("vertices"), None);
        let angles = curve(&run("thesis", "thesis"), "minAngle", None);
        assert!(!angles.is_empty() && angles.iter().all(|pair| (0.0..=60.0).contains(&pair[1])));
    }

    #[test]
    fn thin_curves_keep_what_stands_out() {
        let player = run("incremental", "uniform");
        let all = curve(&player, "queue", None);
        for limit in [4, 7, 40, 401] {
            let thin = curve(&player, "queue", Some(limit));
            assert!(thin.len() <= limit as usize && thin.len() > limit as usize / 8);
            assert!(thin.is_sorted_by(|p, q| p[0] < q[0]), "in order, each once");
            assert!(thin.iter().all(|pair| all.contains(pair)));
            assert_eq!(
                [thin[0], thin[thin.len() - 1]],
                [all[0], all[all.len() - 1]]
            );
            let highest =
                |curve: &[[f64; 2]]| curve.iter().fold(0.0, |most: f64, pair| most.max(pair[1]));
            assert_eq!(highest(&thin), highest(&all));
        }
        assert_eq!(curve(&player, "queue", Some(all.len() as u32)), all);
        player.curve("queue", Some(3)).expect_err("too few");
        let error = player.curve("conflict", None).expect_err("no such curve");
        assert!(error.to_string().contains("conflicts, triangles"));
    }

    #[test]
    fn what_never_happens_has_no_curve() {
        let nothing = Drawing::new(&[], &[], &[]).expect("nothing");
        let player = Player::run("incremental", &nothing, None, None).expect("a run");
        for (name, _) in Curve::ALL {
            assert!(player.curve(name, None).expect(name).is_empty(), "{name}");
        }
    }
}
