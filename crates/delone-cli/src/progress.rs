//! Progress of long work on the terminal, and the way back for Ctrl-C.

use crate::interrupt;
use delone::{Phase, Watch};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::IsTerminal;
use std::sync::Mutex;
use std::time::{Duration, Instant};

/// Work shorter than this draws no bar: a flicker tells nobody anything.
const PATIENCE: Duration = Duration::from_millis(300);

/// Shows one bar on standard error for the phase that is under way, if that is a terminal.
pub struct Progress {
    bar: ProgressBar,
    quiet: bool,
    phase: Mutex<Option<Phase>>,
    started: Instant,
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
        let bar = ProgressBar::with_draw_target(None, target);
        let style = ProgressStyle::with_template("{msg:13} {wide_bar:.cyan/dim} {percent:>3} %");
        bar.set_style(style.expect("bug: bad template"));
        Self {
            bar,
            quiet,
            phase: Mutex::new(None),
            started: Instant::now(),
        }
    }

    /// Tells people what the result will lack, unless they want quiet.
    pub fn note(&self, notes: &[String]) {
        if !self.quiet {
            let say = || notes.iter().for_each(|note| eprintln!("note: {note}"));
            self.bar.suspend(say);
        }
    }

    /// Takes the bar off the screen, so that other messages may be written.
    pub fn finish(&self) {
        self.bar.finish_and_clear();
    }

    fn enter(&self, phase: Phase) {
        let mut current = self.phase.lock().expect("bug: a bar panicked");
        if *current != Some(phase) {
            *current = Some(phase);
            self.bar.set_message(label(phase));
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
        if self.bar.is_hidden() || self.started.elapsed() < PATIENCE {
            return;
        }
        self.enter(phase);
        self.bar.set_length(total);
        self.bar.set_position(done);
    }

    fn is_cancelled(&self) -> bool {
        interrupt::is_requested()
    }
}

/// Shows progress, and hears of no interrupt.
pub struct Unstoppable<'p>(pub &'p Progress);

impl Watch for Unstoppable<'_> {
    fn progress(&self, phase: Phase, done: u64, total: u64) {
        self.0.progress(phase, done, total);
    }
}

/// Wipes the line on which another thread may have left a bar, if standard error is a terminal.
pub fn wipe() {
    if std::io::stderr().is_terminal() {
        eprint!("\r\x1b[2K");
    }
}

fn label(phase: Phase) -> &'static str {
    match phase {
        Phase::Read => "reading",
        Phase::Sort => "sorting",
        Phase::Triangulate => "triangulating",
        Phase::Node => "crossings",
        Phase::Constrain => "constraining",
        Phase::Carve => "carving",
        Phase::Refine => "refining",
        Phase::Smooth => "smoothing",
        Phase::Export => "renumbering",
        Phase::Voronoi => "cells",
        Phase::Relax => "relaxing",
        Phase::Proximity => "relating",
        Phase::Tour => "touring",
        Phase::Cluster => "clustering",
        Phase::Cover => "covering",
        Phase::Query => "querying",
        Phase::Interpolate => "evaluating",
        Phase::Contour => "contouring",
        Phase::Check => "checking",
        Phase::Draw => "drawing",
        Phase::Write => "writing",
        _ => "working",
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
}
