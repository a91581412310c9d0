//! Progress of long work on the terminal, and the way back for Ctrl-C.

mod pace;

use crate::voice;
use crate::words::{bytes, duration};
use crate::{interrupt, memory};
use delone::{Phase, Watch};
use indicatif::{ProgressBar, ProgressDrawTarget};
use std::io::IsTerminal;
use std::sync::Mutex;
use std::time::{Duration, Instant};

/// Work shorter than this draws no bar: a flicker tells nobody anything.
const PATIENCE: Duration = Duration::from_millis(300);

/// Phases shorter than this are not worth a word.
const WORTH_TELLING: Duration = Duration::from_micros(100);

/// Shows one bar on standard error for the phase that is under way, if that is a terminal: how far it is,
/// how fast, and how long it will take. Tells afterwards how long each phase took, if that is wanted.
pub struct Progress {
    bar: ProgressBar,
    quiet: bool,
    laps: Mutex<Laps>,
    is_timed: bool,
    started: Instant,
}

/// Phases and their time.
#[derive(Default)]
struct Laps {
    current: Option<(Phase, Instant)>,
    /// Phases in the order in which they began, their time and the units that they went through.
    all: Vec<(Phase, Duration, u64)>,
    is_told: bool,
}

impl Laps {
    /// Takes a report, and tells whether it begins another phase.
    fn enter(&mut self, phase: Phase, done: u64) -> bool {
        let is_turn = self.current.is_none_or(|(current, _)| current != phase);
        if is_turn {
            self.leave();
            self.current = Some((phase, Instant::now()));
            if !self.all.iter().any(|(known, ..)| *known == phase) {
                self.all.push((phase, Duration::ZERO, 0));
            }
        }
        if let Some((.., units)) = self.all.iter_mut().find(|(known, ..)| *known == phase) {
            *units = done.max(*units);
        }
        is_turn
    }

    /// Ends the phase that is under way.
    fn leave(&mut self) {
        let Some((phase, since)) = self.current.take() else {
            return;
        };
        let known = self.all.iter_mut().find(|(known, ..)| *known == phase);
        if let Some((_, took, _)) = known {
            *took += since.elapsed();
        }
    }

    /// Says how long the phases took, once.
    fn in_words(&mut self) -> Vec<String> {
        self.leave();
        if std::mem::replace(&mut self.is_told, true) {
            return Vec::new();
        }
        let worth = |(_, took, _): &&(Phase, Duration, u64)| *took >= WORTH_TELLING;
        let say = |&(phase, took, units): &(Phase, Duration, u64)| {
            let rate = pace::rate(phase, units, took);
            let rate = rate.map_or_else(String::new, |rate| format!(", {rate}"));
            format!("{}: {}{rate}", pace::label(phase), duration(took))
        };
        let memory = memory::peak_rss_bytes();
        let memory = memory.map(|most| format!("memory: {} at most so far", bytes(most)));
        let phases = self.all.iter().filter(worth).map(say);
        phases.chain(memory).collect()
    }
}

impl Progress {
    /// Makes a bar that appears once the work takes long; never if `quiet`.
    pub fn new(quiet: bool) -> Self {
        // indicatif hides bars on its own when standard error is no terminal.
        let target = if quiet {
            ProgressDrawTarget::hidden()
        } else {
            ProgressDrawTarget::stderr()
        };
        Self {
            bar: ProgressBar::with_draw_target(None, target),
            quiet,
            laps: Mutex::default(),
            is_timed: voice::is_verbose() && !quiet,
            started: Instant::now(),
        }
    }

    /// Tells people what the result will lack, unless they want quiet.
    pub fn note(&self, notes: &[String]) {
        self.tell(|| notes.iter().for_each(|note| voice::note(note)));
    }

    /// Tells people what only some of them want to know.
    pub fn detail(&self, line: impl FnOnce() -> String) {
        if voice::is_verbose() {
            self.tell(|| voice::say(&line()));
        }
    }

    fn tell(&self, say: impl FnOnce()) {
        // What is kept is said later, or not, as somebody else decides.
        if !self.quiet || voice::keeps() {
            self.bar.suspend(say);
        }
    }

    /// Takes the bar off the screen, so that other messages may be written, and says how long the phases
    /// took if that is wanted.
    pub fn finish(&self) {
        self.bar.finish_and_clear();
        if self.is_timed {
            let lines = self.laps.lock().expect("bug: a bar panicked").in_words();
            lines.iter().for_each(|line| voice::say(line));
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.finish();
    }
}

impl Watch for Progress {
    fn progress(&self, phase: Phase, done: u64, total: u64) {
        let is_shown = !self.bar.is_hidden() && self.started.elapsed() >= PATIENCE;
        if !is_shown && !self.is_timed {
            return;
        }
        let mut laps = self.laps.lock().expect("bug: a bar panicked");
        let is_turn = laps.enter(phase, done);
        drop(laps);
        if is_shown {
            if is_turn || self.bar.length().is_none() {
                self.bar.set_style(pace::style(phase));
                self.bar.set_message(pace::label(phase));
                self.bar.reset_elapsed();
            }
            self.bar.set_length(total);
            self.bar.set_position(done);
        }
    }

    fn is_cancelled(&self) -> bool {
        interrupt::is_requested()
    }
}

/// A bar for the files of a batch.
pub struct Files(ProgressBar);

impl Files {
    /// Makes a bar for so many files; none is seen if `quiet`.
    pub fn new(total: usize, quiet: bool) -> Self {
        let target = match quiet {
            true => ProgressDrawTarget::hidden(),
            false => ProgressDrawTarget::stderr(),
        };
        let bar = ProgressBar::with_draw_target(Some(total as u64), target);
        bar.set_style(pace::of_files());
        bar.enable_steady_tick(Duration::from_millis(100));
        Self(bar)
    }

    /// Counts one more file, the one of this name.
    pub fn count(&self, name: &str) {
        self.0.set_message(name.to_owned());
        self.0.inc(1);
    }

    /// Says something above the bar.
    pub fn above(&self, say: impl FnOnce()) {
        self.0.suspend(say);
    }

    /// Takes the bar off the screen.
    pub fn finish(&self) {
        self.0.finish_and_clear();
    }
}

/// Wipes the line on which another thread may have left a bar, if standard error is a terminal.
pub fn wipe() {
    if std::io::stderr().is_terminal() {
        eprint!("\r\x1b[2K");
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_quiet_bar_takes_every_call_and_draws_nothing() {
        let progress = Progress::new(true);
        progress.progress(Phase::Sort, 3, 2);
        progress.progress(Phase::Write, 0, 0);
        assert!(progress.bar.is_hidden());
        assert!(!progress.is_cancelled());
    }

    #[test]
    fn phases_are_told_once_however_often_they_take_turns() {
        let mut laps = Laps::default();
        let turns = [Phase::Read, Phase::Sort, Phase::Sort, Phase::Read];
        let is_turn = turns.map(|phase| {
            let is_turn = laps.enter(phase, 1_000_000);
            std::thread::sleep(2 * WORTH_TELLING);
            is_turn
        });
        assert_eq!(is_turn, [true, true, false, true]);
        let lines = laps.in_words();
        let phases = lines.iter().filter(|line| !line.starts_with("memory"));
        assert_eq!(phases.count(), 2, "{lines:?}");
        assert!(lines[0].starts_with("reading: ") && lines[0].ends_with("B/s"));
        assert!(lines[1].starts_with("sorting: "), "{lines:?}");
        assert_eq!(laps.in_words(), Vec::<String>::new());
    }
}
