//! Wall time of the phases of a command, by name.

use crate::exit::Failure;
use crate::files;
use crate::timing::timed;
use crate::voice;
use crate::words::{duration, wrote};
use serde::{Serialize, Serializer};
use std::path::PathBuf;
use std::time::Duration;

/// How long each phase took, in the order in which they ran.
#[derive(Default)]
pub struct Phases(Vec<(&'static str, Duration)>);

impl Phases {
    /// Does some work, and remembers how long it took.
    pub fn time<T>(
        &mut self,
        name: &'static str,
        work: impl FnOnce() -> Result<T, Failure>,
    ) -> Result<T, Failure> {
        let (result, took) = timed(work)?;
        self.0.push((name, took));
        Ok(result)
    }

    /// Writes files, all of which appear or none, and remembers how long it took.
    pub fn write<T>(&mut self, work: impl FnOnce() -> Result<T, Failure>) -> Result<T, Failure> {
        self.time("write", || files::in_one_commit(work))
    }

    /// Tells people, after some lines of the command's own, how long it took, and which files there are.
    pub fn summarise(&self, lines: &[String], written: &[PathBuf]) {
        lines.iter().for_each(|line| voice::say(line));
        voice::say(&self.in_words());
        if let Some(files) = wrote(written) {
            voice::say(&files);
        }
    }

    /// Says it to people: `read 2.1 ms, triangulate 41 ms`.
    fn in_words(&self) -> String {
        let phases = self.0.iter();
        let words = phases.map(|(name, took)| format!("{name} {}", duration(*took)));
        words.collect::<Vec<_>>().join(", ")
    }
}

impl Serialize for Phases {
    /// Writes a map of seconds.
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(name, took)| (name, took.as_secs_f64())))
    }
}
