//! Lines that end: rings that were not closed, ends that hang beside something, and what tolerance would
//! mend that.
//!
//! *Cost*: that of a few looks around every open end, up to a sixteenth of its segment wide.

use super::graph::Graph;
use super::near::distance;
use super::trouble::Trouble;
use crate::parallel::Workers;
use crate::predicates::length_up;
use crate::pslg::{Nearby, Scratch};
use crate::{VertexId, Watch};

/// A gap of at most this share of the segment at it looks like a mistake; larger ones may be meant.
const SLIP: f64 = 1.0 / 16.0;

/// What lines that end are told by.
pub(super) struct Lines {
    /// Lines whose ends are near to each other.
    pub unclosed: Vec<Trouble>,
    /// The largest gap that looks like a mistake.
    gap: f64,
}

/// Follows all lines that end; `None` if the watch cancelled.
pub(super) fn examine(
    graph: &Graph,
    tolerance: f64,
    workers: Workers,
    watch: &dyn Watch,
) -> Option<Lines> {
    let ends: Vec<u32> = graph
        .vertices()
        .filter(|&v| graph.around(v).len() == 1)
        .collect();
    let mut lines = Lines {
        unclosed: Vec::new(),
        gap: 0.0,
    };
    for (i, &v) in ends.iter().enumerate() {
        if i.is_multiple_of(1 << 8) && watch.is_cancelled() {
            return None;
        }
        lines.follow(graph, v, tolerance);
    }
    if !ends.is_empty() {
        lines.look_around(graph, &ends, workers, watch)?;
    }
    Some(lines)
}

impl Lines {
    /// Returns a tolerance that closes the gaps, if there are some: the largest, rounded up to two digits.
    pub fn suggestion(&self) -> Option<f64> {
        (self.gap > 0.0 && self.gap.is_finite()).then(|| rounded_up(self.gap))
    }

    /// Follows a line from its end; each is told from its lower end.
    fn follow(&mut self, graph: &Graph, from: u32, tolerance: f64) {
        let (mut v, mut s) = (from, graph.around(from)[0]);
        let (mut longest, mut count, first) = (0.0_f64, 0, s);
        loop {
            longest = longest.max(length_up(graph.places(s)));
            count += 1;
            v = graph.opposite(s, v);
            match *graph.around(v) {
                [a, b] => s = if a == s { b } else { a },
                _ => break,
            }
        }
        if graph.around(v).len() != 1 || v < from {
            return;
        }
        let [p, q] = [from, v].map(|v| graph.at(v));
        let gap = length_up([p, q]);
        if count < 2 || !(gap <= tolerance || (count > 2 && gap < longest / 2.0)) {
            return;
        }
        if gap <= tolerance || gap <= longest * SLIP {
            self.gap = self.gap.max(gap);
        }
        let mut segments = [first, s].map(|s| graph.names[s as usize] as usize);
        segments.sort_unstable();
        self.unclosed.push(Trouble {
            points: [from, v].map(VertexId::from).into(),
            segments: segments.into(),
            at: Some(p),
            to: Some(q),
            size: Some(gap),
            ..Trouble::default()
        });
    }

    /// Looks for what open ends may have missed: anything near, for the length of their segment.
    fn look_around(
        &mut self,
        graph: &Graph,
        ends: &[u32],
        workers: Workers,
        watch: &dyn Watch,
    ) -> Option<()> {
        let segments = Nearby::of_segments(graph.points, &graph.ends, workers);
        let mut scratch = Scratch::default();
        for (i, &v) in ends.iter().enumerate() {
            if i.is_multiple_of(1 << 8) && watch.is_cancelled() {
                return None;
            }
            let own = graph.around(v)[0];
            let reach = length_up(graph.places(own)) * SLIP;
            if !reach.is_finite() {
                continue;
            }
            let mut nearest = f64::INFINITY;
            // From near to far, so that long segments side by side are not all looked at.
            for radius in radii(reach) {
                segments.segments_within(graph.at(v), radius, &mut scratch, |s| {
                    let is_apart = !graph.ends[s as usize].contains(&v)
                        && !graph.ends[s as usize].contains(&graph.opposite(own, v));
                    if is_apart {
                        nearest = nearest.min(distance(graph.places(s), graph.at(v)));
                    }
                });
                if nearest.is_finite() {
                    break;
                }
            }
            if nearest.is_finite() {
                self.gap = self.gap.max(nearest);
            }
        }
        Some(())
    }
}

/// Radii that end with `reach`, each four times the one before.
fn radii(reach: f64) -> impl Iterator<Item = f64> {
    const STEPS: i32 = 10;
    (0..=STEPS).map(move |k| reach * 4_f64.powi(k - STEPS))
}

/// Rounds up to two digits.
fn rounded_up(x: f64) -> f64 {
    let nearest = format!("{x:.1e}");
    let Some(below) = nearest.parse().ok().filter(|&nearest: &f64| nearest < x) else {
        return nearest.parse().map_or(x, |up: f64| up.min(f64::MAX));
    };
    // The next number of two digits: 4.4e-7 is followed by 45e-8.
    let next = nearest.split_once('e').and_then(|(digits, exponent)| {
        let tenths: u32 = digits.replace('.', "").parse().ok()?;
        let exponent: i32 = exponent.parse().ok()?;
        format!("{}e{}", tenths + 1, exponent - 1).parse().ok()
    });
    next.unwrap_or(below).max(x).min(f64::MAX)
}

#[cfg(test)]
mod tests {
    use super::rounded_up;

    #[test]
    fn tolerances_are_round_and_enough() {
        for (x, expected) in [
            (0.01, 0.01),
            (0.0123, 0.013),
            (0.0991, 0.1),
            (4.44e-7, 4.5e-7),
        ] {
            assert_eq!(rounded_up(x), expected, "{x}");
        }
        for i in 1..5000 {
            let x = f64::from(i) * 0.001_237;
            assert!(rounded_up(x) >= x && rounded_up(x) <= 1.11 * x, "{x}");
        }
        assert_eq!(rounded_up(5e-324), 5e-324);
        assert_eq!(rounded_up(f64::MAX), f64::MAX);
    }
}
