//! Which steps make a frame, and how long it is shown.

use super::{AnimationOptions, Pace, ShownSteps};
use delone::{Event, Log};

/// Most frames a second: browsers show no more of a GIF.
pub(super) const FASTEST: f64 = 50.0;

/// Seconds for which the last frame stays.
const REST: f64 = 2.0;

/// Share of the whole for which the last frame stays, if that is less.
const REST_SHARE: f64 = 0.15;

/// The frames of an animation: how many steps have been played in each.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Plan {
    pub ends: Vec<usize>,
    /// How many there would be without a limit.
    pub wanted: usize,
    /// Seconds from one frame to the next.
    pub interval: f64,
    /// Seconds for which the last one stays longer.
    pub rest: f64,
}

/// A frame.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frame {
    /// How many steps have been played.
    pub end: usize,
    /// Whether it is the last: what has become of it all.
    pub is_result: bool,
}

impl Plan {
    /// Chooses the frames of a moving picture.
    pub fn new(log: &Log, options: &AnimationOptions) -> Self {
        let all = ends(log, options.shown);
        let wanted = all.len();
        let most = options.max_frames.max(2);
        match options.pace {
            Pace::PerSecond(rate) => Self {
                ends: evenly(all, most),
                wanted,
                interval: 1.0 / rate,
                rest: REST,
            },
            Pace::InSeconds(total) => {
                let rest = REST.min(REST_SHARE * total);
                let fitting = ((total - rest) * FASTEST) as usize;
                let ends = evenly(all, most.min(fitting.max(2)));
                Self {
                    interval: (total - rest) / ends.len() as f64,
                    ends,
                    wanted,
                    rest,
                }
            }
        }
    }

    /// Chooses the frames of a filmstrip.
    pub fn strip(log: &Log, options: &AnimationOptions) -> Self {
        if !options.moments.is_empty() {
            return Self::at(&options.moments, log.steps.len());
        }
        let all = match options.strip.at_stages {
            true => stages(log),
            false => ends(log, options.shown),
        };
        Self {
            wanted: all.len(),
            ends: evenly(all, options.strip.frames),
            interval: 1.0,
            rest: 0.0,
        }
    }

    /// Takes frames that somebody has chosen, and the result.
    fn at(moments: &[usize], steps: usize) -> Self {
        let mut ends: Vec<_> = moments.iter().map(|&end| end.min(steps)).collect();
        ends.sort_unstable();
        ends.push(steps);
        Self {
            wanted: ends.len(),
            ends,
            interval: 1.0,
            rest: 0.0,
        }
    }

    /// Visits the frames.
    pub fn frames(&self) -> impl Iterator<Item = Frame> + '_ {
        let last = self.ends.len() - 1;
        let numbered = self.ends.iter().enumerate();
        numbered.map(move |(i, &end)| Frame {
            end,
            is_result: i == last,
        })
    }

    /// Returns when a frame begins.
    pub fn begin(&self, frame: usize) -> f64 {
        frame as f64 * self.interval
    }

    /// Returns how long it all takes.
    pub fn total(&self) -> f64 {
        self.begin(self.ends.len()) + self.rest
    }
}

/// Lists how many steps have been played in each frame: first what there is before any line runs, at last
/// all, twice: with what the last step did, and the result alone.
fn ends(log: &Log, shown: ShownSteps) -> Vec<usize> {
    let steps = || log.steps.iter().enumerate();
    let first = steps().find(|(_, step)| step.line != 0);
    let mut ends = vec![first.map_or(log.steps.len(), |(i, _)| i)];
    let shows = |event: Event| match shown {
        ShownSteps::All => true,
        ShownSteps::Changes => changes_drawing(event),
    };
    let frames = steps().filter(|(_, step)| step.line != 0 && shows(step.event));
    ends.extend(frames.map(|(i, _)| i + 1));
    let last = ends.len() - 1;
    if last == 0 && ends[0] < log.steps.len() {
        ends.push(log.steps.len());
    } else {
        // What follows the last frame is part of it.
        ends[last] = log.steps.len();
    }
    if last > 0 {
        ends.push(log.steps.len());
    }
    ends
}

fn changes_drawing(event: Event) -> bool {
    let is_unseen = matches!(
        event,
        Event::Pushed { .. } | Event::Popped { .. } | Event::DatumReassigned { .. }
    );
    event.changes_scene() && !is_unseen
}

/// Lists how many steps have been played when a stage ends, and at last.
fn stages(log: &Log) -> Vec<usize> {
    let steps = log.steps.iter().enumerate();
    let ending = steps.filter(|(_, step)| matches!(step.event, Event::StageEnded { .. }));
    let mut ends: Vec<_> = ending.map(|(i, _)| i + 1).collect();
    if ends.last() != Some(&log.steps.len()) {
        ends.push(log.steps.len());
    }
    ends
}

/// Keeps at most so many, the first and the last among them, evenly spread.
fn evenly(all: Vec<usize>, most: usize) -> Vec<usize> {
    if all.len() <= most {
        return all;
    }
    let last = all.len() - 1;
    if most < 2 {
        return vec![all[last]];
    }
    // In 128 bits, for the product of two numbers may have so many.
    let at = |i: usize| (i as u128 * last as u128 / (most - 1) as u128) as usize;
    (0..most).map(|i| all[at(i)]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use delone::{Queue, Step, VertexId};

    fn log(lines: &[u16]) -> Log {
        let edge = [0, 1].map(VertexId::new);
        let (queue, item) = (Queue::Suspects, delone::Item::Edge(edge));
        let steps = lines.iter().map(|&line| Step {
            line,
            event: match line {
                7 => Event::Pushed { queue, item },
                8 => Event::EdgeExamined { edge },
                _ => Event::EdgeCreated { edge },
            },
        });
        Log {
            steps: steps.collect(),
            ..Log::new("", [])
        }
    }

    #[test]
    fn what_is_laid_out_is_no_frame() {
        let all = |lines| ends(&log(lines), ShownSteps::All);
        assert_eq!(all(&[]), [0]);
        assert_eq!(all(&[0, 0]), [2]);
        assert_eq!(all(&[0, 0, 1]), [2, 3, 3]);
        assert_eq!(all(&[1, 0, 2, 0]), [0, 1, 4, 4]);
        let changes = |lines| ends(&log(lines), ShownSteps::Changes);
        assert_eq!(changes(&[0, 1, 7, 8, 2, 8]), [1, 2, 6, 6]);
        assert_eq!(changes(&[8, 8]), [0, 2]);
    }

    #[test]
    fn a_strip_has_the_moments_that_are_asked_for() {
        let options = AnimationOptions {
            moments: vec![7, 3, 99],
            ..AnimationOptions::default()
        };
        let plan = Plan::strip(&log(&[1; 20]), &options);
        assert_eq!(plan.ends, [3, 7, 20, 20]);
    }

    #[test]
    fn frames_are_spread_evenly_from_the_first_to_the_last() {
        assert_eq!(evenly((0..11).collect(), 3), [0, 5, 10]);
        assert_eq!(evenly((0..11).collect(), 11).len(), 11);
        assert_eq!(evenly((0..11).collect(), 1), [10]);
        let options = AnimationOptions {
            max_frames: 10,
            pace: Pace::InSeconds(3.0),
            ..AnimationOptions::default()
        };
        let plan = Plan::new(&log(&[1; 100]), &options);
        assert_eq!((plan.ends.len(), plan.wanted), (10, 102));
        assert_eq!((plan.ends[0], plan.ends[9]), (0, 100));
        assert!((plan.total() - 3.0).abs() < 1e-9);
    }
}
