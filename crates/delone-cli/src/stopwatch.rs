//! Where the time of one long call goes, as told by the progress that it reports.

use delone::{Phase, Watch};
use std::sync::Mutex;
use std::time::{Duration, Instant};

/// Passes everything on to another watch and sums up the time of the phases that it is asked about.
///
/// A phase lasts from its first report to the first report of another one.
pub struct Stopwatch<'w> {
    inner: &'w dyn Watch,
    laps: Mutex<Laps>,
}

struct Laps {
    current: Option<Phase>,
    since: Instant,
    constrain: Duration,
    carve: Duration,
}

impl Laps {
    /// Ends the lap of the current phase and begins that of `next`.
    fn turn(&mut self, next: Option<Phase>) {
        let now = Instant::now();
        let lap = now - self.since;
        match self.current {
            Some(Phase::Node | Phase::Constrain) => self.constrain += lap,
            Some(Phase::Carve) => self.carve += lap,
            _ => {}
        }
        (self.current, self.since) = (next, now);
    }
}

impl<'w> Stopwatch<'w> {
    /// Starts.
    pub fn new(inner: &'w dyn Watch) -> Self {
        let laps = Laps {
            current: None,
            since: Instant::now(),
            constrain: Duration::ZERO,
            carve: Duration::ZERO,
        };
        Self {
            inner,
            laps: Mutex::new(laps),
        }
    }

    /// Stops, and returns how long segments were inserted, crossings included, and how long the
    /// domain was looked for.
    pub fn stop(self) -> [Duration; 2] {
        let mut laps = self.laps.into_inner().expect("bug: a stopwatch panicked");
        laps.turn(None);
        [laps.constrain, laps.carve]
    }
}

impl Watch for Stopwatch<'_> {
    fn progress(&self, phase: Phase, done: u64, total: u64) {
        let mut laps = self.laps.lock().expect("bug: a stopwatch panicked");
        if laps.current != Some(phase) {
            laps.turn(Some(phase));
        }
        drop(laps);
        self.inner.progress(phase, done, total);
    }

    fn is_cancelled(&self) -> bool {
        self.inner.is_cancelled()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::thread::sleep;

    #[test]
    fn time_goes_to_the_phase_that_reports() {
        let stopwatch = Stopwatch::new(&());
        let pause = Duration::from_millis(4);
        for phase in [
            Phase::Triangulate,
            Phase::Node,
            Phase::Constrain,
            Phase::Node,
            Phase::Carve,
            Phase::Export,
        ] {
            stopwatch.progress(phase, 0, 2);
            sleep(pause);
            stopwatch.progress(phase, 1, 2);
        }
        let [constrain, carve] = stopwatch.stop();
        assert!(constrain >= 3 * pause && carve >= pause);
        // Neither Triangulate nor Export counts for anything.
        assert!(constrain + carve < 1000 * pause);
    }

    #[test]
    fn without_segments_there_is_nothing_to_count() {
        let stopwatch = Stopwatch::new(&());
        stopwatch.progress(Phase::Sort, 1, 1);
        assert_eq!(stopwatch.stop(), [Duration::ZERO; 2]);
        assert!(!Stopwatch::new(&()).is_cancelled());
    }
}
