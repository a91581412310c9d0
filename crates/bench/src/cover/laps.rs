//! How long each algorithm takes: the ends of stages, as an observer hears of them.
//!
//! It says that nobody listens, and yet looks at what it is told: so nothing is kept for it, and what is told takes
//! a few nanoseconds.

use delone::{Event, Observer, Stage, Step};
use serde::{Deserialize, Serialize};
use std::time::Instant;

/// A stop watch.
#[derive(Debug)]
pub struct Laps {
    start: Instant,
    ends: [Option<Instant>; 2],
}

/// Seconds that each algorithm took.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Stages {
    /// A: putting the data in order, the outer polygon, and centers of clusters.
    pub a: f64,
    /// B: vertices on edges.
    pub b: f64,
    /// C: vertices in triangles; and handing out the result.
    pub c: f64,
}

impl Laps {
    /// Starts the watch.
    #[expect(
        clippy::new_without_default,
        reason = "a watch that runs is no default"
    )]
    pub fn new() -> Self {
        Self {
            start: Instant::now(),
            ends: [None; 2],
        }
    }

    /// Stops it.
    pub fn stop(&self) -> Stages {
        let a = self.ends[0].unwrap_or(self.start);
        let b = self.ends[1].unwrap_or(a);
        Stages {
            a: (a - self.start).as_secs_f64(),
            b: (b - a).as_secs_f64(),
            c: b.elapsed().as_secs_f64(),
        }
    }
}

impl Observer for Laps {
    fn observe(&mut self, Step { event, .. }: Step) {
        if let Event::StageEnded { stage, .. } = event {
            match stage {
                Stage::Clusters => self.ends[0] = Some(Instant::now()),
                Stage::DivideEdges => self.ends[1] = Some(Instant::now()),
                _ => {}
            }
        }
    }

    fn is_watching(&self) -> bool {
        false
    }

    fn tell(&mut self, line: u16, event: impl FnOnce() -> Event) {
        let event = event();
        self.observe(Step { line, event });
    }
}

#[cfg(test)]
mod tests {
    use super::Laps;
    use delone::scattered::Cover;

    #[test]
    fn every_algorithm_ends_and_the_result_is_the_same() {
        let data = (0..500).map(|i| (f64::from(i * 37 % 101), f64::from(i * 59 % 97)));
        let mut laps = Laps::new();
        let cover = Cover::new(5).observe(data.clone(), &mut laps).unwrap();
        assert_eq!(cover, Cover::new(5).cover(data).unwrap());
        assert!(laps.ends.iter().all(Option::is_some));
        let stages = laps.stop();
        assert!(stages.a > 0.0 && stages.b > 0.0 && stages.c > 0.0);
    }
}
