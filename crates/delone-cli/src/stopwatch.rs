//! Where the time of one long call goes, as told by the progress that it reports.

use delone::{Phase, Watch};
use std::sync::Mutex;
use std::time::{Duration, Instant};

/// Passes everything on to another watch and sums up the time of the phases that it is asked about.
///
/// A phase lasts from its first report to the first report of another one; refining and smoothing last
/// on while what they have made is handed out.
pub struct Stopwatch<'w> {
    inner: &'w dyn Watch,
    laps: Mutex<Laps>,
}

struct Laps {
    current: Option<Phase>,
    since: Instant,
    constrain: Duration,
    carve: Duration,
    refine: Duration,
    smooth: Duration,
}

impl Laps {
    /// Tells whether a report from `phase` begins a new lap.
    fn is_turn(&self, phase: Phase) -> bool {
        let refines = |phase| matches!(phase, Phase::Refine | Phase::Smooth);
        self.current != Some(phase) && (refines(phase) || !self.current.is_some_and(refines))
    }

    /// Ends the lap of the current phase and begins that of `next`.
    fn turn(&mut self, next: Option<Phase>) {
        let now = Instant::now();
        let lap = now - self.since;
        match self.current {
            Some(Phase::Node | Phase::Constrain) => self.constrain += lap,
            Some(Phase::Carve) => self.carve += lap,
            Some(Phase::Refine) => self.refine += lap,
            Some(Phase::Smooth) => self.smooth += lap,
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
            refine: Duration::ZERO,
            smooth: Duration::ZERO,
        };
        Self {
            inner,
            laps: Mutex::new(laps),
        }
    }

    /// Stops, and returns how long segments were inserted, crossings included, how long the domain was
    /// looked for, how long it was refined, and smoothed.
    pub fn stop(self) -> [Duration; 4] {
        let mut laps = self.laps.into_inner().expect("bug: a stopwatch panicked");
        laps.turn(None);
        [laps.constrain, laps.carve, laps.refine, laps.smooth]
    }
}

impl Watch for Stopwatch<'_> {
    fn progress(&self, phase: Phase, done: u64, total: u64) {
        let mut laps = self.laps.lock().expect("bug: a stopwatch panicked");
        if laps.is_turn(phase) {
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
            Phase::Refine,
            Phase::Smooth,
            Phase::Refine,
            Phase::Export,
        ] {
            stopwatch.progress(phase, 0, 2);
            sleep(pause);
            stopwatch.progress(phase, 1, 2);
        }
        let [constrain, carve, refine, smooth] = stopwatch.stop();
        assert!(constrain >= 3 * pause && carve >= pause);
        assert!(refine >= 3 * pause && smooth >= pause);
        // Triangulate counts for nothing, and Export for what was refined.
        assert!(constrain + carve + refine + smooth < 1000 * pause);
    }

    #[test]
    fn without_segments_there_is_nothing_to_count() {
        let stopwatch = Stopwatch::new(&());
        stopwatch.progress(Phase::Sort, 1, 1);
        assert_eq!(stopwatch.stop(), [Duration::ZERO; 4]);
        assert!(!Stopwatch::new(&()).is_cancelled());
    }
}
