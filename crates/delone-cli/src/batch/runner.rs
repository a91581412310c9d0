//! The files are worked on, several at once, and told of in their order.

use super::Unit;
use super::table::{Row, table};
use crate::exit::Failure;
use crate::files;
use crate::interrupt;
use crate::job;
use crate::progress::Files;
use crate::voice::{self, Kept};
use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, mpsc};
use std::time::{Duration, Instant};

/// How the files are worked on.
pub struct Run {
    /// How many at once.
    pub jobs: Option<u16>,
    /// What becomes of the results.
    pub results: Results,
    /// Whether nothing is said but errors.
    pub quiet: bool,
}

/// What becomes of the results of files, which are lines of JSON, or words for people.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Results {
    /// Rows of a table for people.
    Table,
    /// JSON, with the names of the files in front.
    Json,
    /// Printed as they are.
    AsTheyAre,
}

impl Results {
    /// Asks for JSON, or for a table.
    pub fn tabled(json: bool) -> Self {
        match json {
            true => Self::Json,
            false => Self::Table,
        }
    }
}

/// What has become of a file.
struct Done {
    file: String,
    outputs: Vec<PathBuf>,
    result: Result<(), Failure>,
    kept: Kept,
    took: Duration,
}

impl Run {
    /// Works on all files, and says what has become of them.
    ///
    /// Machines have as many threads as they have: of few files each gets several, of many each gets one.
    pub fn all(&self, units: Vec<Unit>) -> Result<(), Failure> {
        let total = units.len();
        let cores = job::threads(None);
        let jobs = job::threads(self.jobs).min(total).max(1);
        let threads = (cores / jobs).max(1);
        let bar = Files::new(total, self.quiet);
        let queue = Mutex::new(units.into_iter().enumerate());
        let is_over = AtomicBool::new(false);
        let (sender, receiver) = mpsc::channel();

        let told = std::thread::scope(|scope| {
            for _ in 0..jobs {
                let sender = sender.clone();
                scope.spawn(|| work(&queue, threads, &is_over, sender));
            }
            // So that the channel ends with the last of the workers.
            drop(sender);
            let told = self.tell(receiver, &bar);
            is_over.store(true, Ordering::SeqCst);
            told
        });
        bar.finish();
        let (rows, code) = told?;
        if interrupt::is_requested() {
            return Err(Failure::Cancelled);
        }
        if !self.quiet && self.results == Results::Table {
            voice::say(&table(&rows));
        }
        match code {
            0 => Ok(()),
            code => Err(Failure::SomeFailed(code)),
        }
    }

    /// Tells of the files in their order; returns rows for a table, and the worst exit code.
    fn tell(
        &self,
        receiver: mpsc::Receiver<(usize, Done)>,
        bar: &Files,
    ) -> Result<(Vec<Row>, u8), Failure> {
        let mut waiting = BTreeMap::new();
        let mut rows = Vec::new();
        let mut worst = 0;
        for (i, done) in receiver {
            bar.count(&done.file);
            waiting.insert(i, done);
            while let Some(done) = waiting.remove(&rows.len()) {
                if matches!(done.result, Err(Failure::Cancelled)) {
                    return Err(Failure::Cancelled);
                }
                let code = done.result.as_ref().map_or_else(Failure::code, |()| 0);
                worst = worst.max(code);
                let mut printed = Ok(());
                bar.above(|| printed = self.tell_of(&done));
                printed?;
                rows.push(Row::of(&done.file, &done.kept.results, code, done.took));
            }
        }
        Ok((rows, worst))
    }

    fn tell_of(&self, done: &Done) -> Result<(), Failure> {
        if !self.quiet {
            done.kept.notes.iter().for_each(|line| voice::say(line));
        }
        if let Some(failure) = done.result.as_ref().err().filter(|f| !f.is_told()) {
            failure.tell(Some(&done.file));
        }
        let mut lines = done.kept.results.iter();
        match self.results {
            Results::Table => Ok(()),
            Results::Json => lines
                .filter_map(|line| done.with_names(line))
                .try_for_each(|line| files::print(&line)),
            Results::AsTheyAre => lines.try_for_each(|line| files::print(line)),
        }
    }
}

impl Done {
    /// Puts the names of the files in front of the keys of a JSON object.
    fn with_names(&self, json: &str) -> Option<String> {
        let keys = json.strip_prefix('{')?;
        let outputs = self.outputs.iter().map(|path| path.display().to_string());
        let outputs = outputs.collect::<Vec<_>>();
        let names = serde_json::json!({ "file": self.file, "outputs": outputs }).to_string();
        let names = names.strip_suffix('}')?;
        let comma = if keys == "}" { "" } else { "," };
        Some(format!("{names}{comma}{keys}"))
    }
}

/// Takes one file after the other, until none is left, somebody cancels, or nobody listens.
fn work(
    queue: &Mutex<impl Iterator<Item = (usize, Unit)>>,
    threads: usize,
    is_over: &AtomicBool,
    sender: mpsc::Sender<(usize, Done)>,
) {
    while !interrupt::is_requested() && !is_over.load(Ordering::SeqCst) {
        let next = queue.lock().expect("bug: a queue panicked").next();
        let Some((i, unit)) = next else { return };
        if sender.send((i, one(unit, threads))).is_err() {
            return;
        }
    }
}

/// Works on one file; not even a bug stops the others.
fn one(unit: Unit, threads: usize) -> Done {
    let Unit {
        file,
        outputs,
        work,
        ..
    } = unit;
    let start = Instant::now();
    let (result, kept) = voice::keeping(|| {
        catch_unwind(AssertUnwindSafe(|| work(threads))).unwrap_or_else(|_| {
            let bug = "a bug, which has said something of its own above; please report the input";
            Err(Failure::NotReached(format!("{file}: {bug}")))
        })
    });
    Done {
        outputs: outputs.names(),
        file,
        result,
        kept,
        took: start.elapsed(),
    }
}
