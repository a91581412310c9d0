//! Finding steps: breakpoints, forwards and backwards.

use super::curve::Curve;
use super::named::{has_vertex, is_edge, items};
use super::{Player, seeking};
use crate::Trouble;
use delone::{Log, Stage, VertexId};
use serde::Deserialize;
use wasm_bindgen::prelude::wasm_bindgen;

/// A condition as it is written: one of its keys, and a bound for a curve.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
struct Written {
    kind: Option<String>,
    line: Option<u16>,
    vertex: Option<u32>,
    edge: Option<[u32; 2]>,
    curve: Option<String>,
    below: Option<f64>,
    above: Option<f64>,
    stage: Option<Stage>,
}

/// What a step may be.
#[derive(Clone, Debug, PartialEq)]
enum Condition {
    Kind(String),
    Line(u16),
    Vertex(VertexId),
    Edge([VertexId; 2]),
    /// One of these positions, sorted: where a curve comes to where it was not before.
    Crossing(Vec<usize>),
    Stage(Stage),
}

impl Written {
    /// Says what is meant, in this run.
    fn read(self, log: &Log) -> Result<Condition, Trouble> {
        let vertex = |v: u32| VertexId::new(v as usize);
        let mut all = Vec::new();
        if let Some(kind) = self.kind {
            all.push(Condition::kind(&kind)?);
        }
        all.extend(self.line.map(Condition::Line));
        all.extend(self.vertex.map(|v| Condition::Vertex(vertex(v))));
        all.extend(self.edge.map(|ends| Condition::Edge(ends.map(vertex))));
        all.extend(self.stage.map(Condition::Stage));
        let curve = self.curve.as_deref().map(Curve::named).transpose()?;
        match (curve, self.below, self.above) {
            (None, None, None) => {}
            (Some(curve), Some(bound), None) => {
                all.push(Condition::crossing(curve, log, |value| value < bound));
            }
            (Some(curve), None, Some(bound)) => {
                all.push(Condition::crossing(curve, log, |value| value > bound));
            }
            _ => all.clear(),
        }
        match (all.pop(), all.is_empty()) {
            (Some(condition), true) => Ok(condition),
            _ => Err(Trouble::asked(
                "a condition has one of the keys kind, line, vertex, edge, stage; or curve and below; or curve and above",
            )),
        }
    }
}

impl Condition {
    fn kind(kind: &str) -> Result<Self, Trouble> {
        seeking::require_known(kind)?;
        Ok(Self::Kind(kind.to_owned()))
    }

    /// Finds where a curve comes to where it was not before.
    fn crossing(curve: Curve, log: &Log, is_beyond: impl Fn(f64) -> bool) -> Self {
        let mut was_beyond = false;
        let samples = curve.samples(log).filter(|&(_, value)| {
            let is_beyond = is_beyond(value);
            let was_beyond = std::mem::replace(&mut was_beyond, is_beyond);
            is_beyond && !was_beyond
        });
        Self::Crossing(samples.map(|(position, _)| position).collect())
    }

    /// Tells whether the step before a position is so.
    fn is_met(&self, log: &Log, end: usize) -> bool {
        let step = &log.steps[end - 1];
        let names = |is_it: &dyn Fn(delone::Item) -> bool| items(&step.event).any(is_it);
        match self {
            Self::Kind(kind) => seeking::is(&log.steps, end, kind),
            Self::Line(line) => step.line == *line,
            Self::Vertex(v) => names(&|item| has_vertex(item, *v)),
            Self::Edge(edge) => names(&|item| is_edge(item, *edge)),
            Self::Crossing(positions) => positions.binary_search(&end).is_ok(),
            Self::Stage(wanted) => {
                matches!(step.event, delone::Event::StageEnded { stage, .. } if stage == *wanted)
            }
        }
    }
}

/// Finds the next position after `from`, or the last before it, behind a step that meets one of the conditions.
fn find(log: &Log, conditions: &[Condition], from: usize, backwards: bool) -> Option<u32> {
    let is_met = |&end: &usize| conditions.iter().any(|c| c.is_met(log, end));
    let steps = log.steps.len();
    let found = match backwards {
        false => (from.saturating_add(1)..=steps).find(is_met),
        true => (1..from.min(steps + 1)).rev().find(is_met),
    };
    found.map(|position| position as u32)
}

#[wasm_bindgen]
impl Player {
    /// Finds the next position after `from`, or backwards the last before it, at which a step has just been taken
    /// that meets one of some conditions; `undefined` if there is none.
    ///
    /// `conditions` is JSON, an array of objects:
    /// - `{kind}`: that of an event (`"edge-flipped"` …), or one of `"flip"`, `"insertion"`, `"test"`, `"change"`,
    ///   `"stage"`, `"line"` (the first step of another line), `"result"` (the end);
    /// - `{line}`: this line of the pseudocode runs;
    /// - `{vertex}`, `{edge: [a, b]}`: the event names this vertex, be it as a corner, or this edge;
    /// - `{curve, below}`, `{curve, above}`: a number, named as for `curve`, has become less or more than this, and
    ///   was not before;
    /// - `{stage}`: this stage has ended, named as in events (`"flips"`, `"clusters"` …).
    ///
    /// *Cost*: a few ns for each step on the way; for a curve, for each step of the run.
    pub fn search(
        &self,
        conditions: &str,
        from: u32,
        backwards: bool,
    ) -> Result<Option<u32>, Trouble> {
        let written: Vec<Written> = serde_json::from_str(conditions)
            .map_err(|error| Trouble::asked(format!("conditions: {error}")))?;
        let log = &self.recording.log;
        let conditions = written.into_iter().map(|written| written.read(log));
        let conditions = conditions.collect::<Result<Vec<_>, _>>()?;
        Ok(find(log, &conditions, from as usize, backwards))
    }

    /// Searches forwards for a kind of steps.
    pub fn next(&self, kind: &str, from: u32) -> Result<Option<u32>, Trouble> {
        let wanted = [Condition::kind(kind)?];
        Ok(find(&self.recording.log, &wanted, from as usize, false))
    }

    /// Searches backwards for a kind of steps.
    pub fn previous(&self, kind: &str, from: u32) -> Result<Option<u32>, Trouble> {
        let wanted = [Condition::kind(kind)?];
        Ok(find(&self.recording.log, &wanted, from as usize, true))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::Drawing;
    use delone::{Event, Step};

    fn run(algorithm: &str, preset: &str) -> Player {
        let drawing = Drawing::preset(preset, 40, 1).expect("a preset");
        Player::run(algorithm, &drawing, None, None).expect("a run")
    }

    /// All positions that a search finds, one after the other.
    fn found(player: &Player, conditions: &str) -> Vec<u32> {
        let go = |from, backwards| {
            player
                .search(conditions, from, backwards)
                .expect(conditions)
        };
        let forth: Vec<u32> = std::iter::successors(go(0, false), |&at| go(at, false)).collect();
        let end = player.length() + 1;
        let mut back: Vec<u32> = std::iter::successors(go(end, true), |&at| go(at, true)).collect();
        back.reverse();
        assert_eq!(forth, back, "{conditions}");
        forth
    }

    /// The positions behind steps of which something holds.
    fn expected(player: &Player, holds: impl Fn(&Step) -> bool) -> Vec<u32> {
        let numbered = (1..).zip(player.steps());
        numbered
            .filter(|(_, step)| holds(step))
            .map(|(at, _)| at)
            .collect()
    }

    #[test]
    fn steps_are_found_by_each_condition_in_both_directions() {
        let player = run("greedy-flips", "uniform");
        let flips = expected(&player, |s| matches!(s.event, Event::EdgeFlipped { .. }));
        assert!(!flips.is_empty());
        assert_eq!(found(&player, r#"[{"kind": "flip"}]"#), flips);
        let line = player.steps()[player.steps().len() / 2].line;
        let on_line = expected(&player, |s| s.line == line);
        assert_eq!(found(&player, &format!(r#"[{{"line": {line}}}]"#)), on_line);
        let Some(Step {
            event:
                Event::EdgeFlipped {
                    from: [a, b],
                    to: [c, _],
                },
            ..
        }) = player.steps().get(flips[0] as usize - 1).copied()
        else {
            panic!("no flip")
        };
        let [a, b, c] = [a, b, c].map(|v| v.index());
        for edge in [
            format!(r#"[{{"edge": [{a}, {b}]}}]"#),
            format!(r#"[{{"edge": [{b}, {a}]}}]"#),
        ] {
            assert!(found(&player, &edge).contains(&flips[0]));
        }
        assert!(found(&player, &format!(r#"[{{"vertex": {c}}}]"#)).contains(&flips[0]));
        assert!(found(&player, r#"[{"vertex": 4000000000}]"#).is_empty());
        assert!(found(&player, "[]").is_empty());
        let both = found(
            &player,
            &format!(r#"[{{"kind": "flip"}}, {{"line": {line}}}]"#),
        );
        let mut union = [flips, on_line].concat();
        union.sort_unstable();
        union.dedup();
        assert_eq!(both, union);
    }

    #[test]
    fn curves_stop_where_they_cross_a_bound() {
        let player = run("greedy-flips", "uniform");
        let curve = player.curve("conflicts", None).expect("a curve");
        let pairs = curve.as_chunks::<2>().0;
        let bound = pairs[0][1] / 2.0;
        let crosses = |window: &[[f64; 2]]| window[0][1] >= bound && window[1][1] < bound;
        let expected = pairs.windows(2).filter(|window| crosses(window));
        let expected: Vec<u32> = expected.map(|window| window[1][0] as u32).collect();
        assert!(!expected.is_empty());
        let conditions = format!(r#"[{{"curve": "conflicts", "below": {bound}}}]"#);
        assert_eq!(found(&player, &conditions), expected);
        // It begins with none: that is no crossing.
        assert!(found(&player, r#"[{"curve": "flips", "below": 1}]"#).is_empty());
        let first_flip = player.next("flip", 0).expect("a kind");
        let flipped = found(&player, r#"[{"curve": "flips", "above": 0}]"#);
        assert_eq!(
            Some(&flipped[..]),
            first_flip.as_ref().map(std::slice::from_ref)
        );
    }

    #[test]
    fn stages_are_found_by_name() {
        let player = run("thesis", "thesis");
        let ended = |step: &Step| match step.event {
            Event::StageEnded { stage, .. } => Some(stage),
            _ => None,
        };
        let stages: Vec<_> = player.steps().iter().filter_map(ended).collect();
        assert!(stages.len() > 2, "{stages:?}");
        for stage in stages {
            let name = serde_json::to_string(&stage).expect("JSON");
            let positions = expected(&player, |step| ended(step) == Some(stage));
            assert_eq!(
                found(&player, &format!(r#"[{{"stage": {name}}}]"#)),
                positions
            );
        }
    }

    #[test]
    fn unclear_conditions_are_refused() {
        let player = run("incremental", "grid");
        for bad in [
            "nonsense",
            r#"{"line": 3}"#,
            r#"[{"lines": 3}]"#,
            "[{}]",
            r#"[{"line": 3, "vertex": 2}]"#,
            r#"[{"curve": "flips"}]"#,
            r#"[{"curve": "flips", "below": 3, "above": 2}]"#,
            r#"[{"line": 3, "below": 3}]"#,
            r#"[{"curve": "flaps", "below": 3}]"#,
            r#"[{"kind": "flop"}]"#,
            r#"[{"stage": "flop"}]"#,
            r#"[{"edge": [3]}]"#,
        ] {
            player.search(bad, 0, false).expect_err(bad);
        }
    }
}
