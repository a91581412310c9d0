//! Exit codes, and the failures that lead to them.
//!
//! The codes are part of the program's interface: scripts rely on them, so a number never changes
//! its meaning. Under `--json` failures are told as objects, too: [`Told`].

use crate::interrupt;
use crate::voice;
use serde::Serialize;
use std::path::Path;
use std::process::ExitCode;
use std::sync::atomic::{AtomicBool, Ordering};

static CANCELLED: AtomicBool = AtomicBool::new(false);

/// What `--help` says about exit codes.
pub const HELP: &str = "\
Exit codes:
  0    done
  1    the check failed: the file is not the triangulation it claims to be, or misses a bound
       that it was checked against without an excuse
  2    usage: an option or argument is wrong
  3    bad input: a file is missing, malformed or cannot be triangulated
  4    not reached: the work could not be finished or its result not written; of a mesh, triangles
       are not as asked and the input is no excuse (the mesh is written)
  5    troubles: `delone doctor` has found errors or warnings, or some are left after a repair
  130  cancelled by Ctrl-C (143 by SIGTERM, 129 by SIGHUP); nothing half-written is left behind
Of several files the code is the largest of all. With --json, what goes wrong is an object on one line of
standard error: error (in words), kind (usage, bad_input, not_reached, cancelled), code, and where they
are known file and line (null otherwise).";

/// Why a command did not end with exit code 0.
#[derive(Debug, thiserror::Error)]
pub enum Failure {
    /// The check ran and found defects; they have been reported already.
    #[error("the check failed")]
    CheckFailed,
    /// A drawing has errors or deserves warnings; they have been reported already.
    #[error("the drawing has troubles")]
    Troubles,
    /// Some of several files could not be checked; each has been reported already.
    #[error("not every file could be checked")]
    NotAllRead,
    /// Some files of a batch failed, the worst with this code; each has been reported already.
    #[error("not every file went well")]
    SomeFailed(u8),
    /// Options or arguments contradict each other or do not fit the input.
    #[error("{0}")]
    Usage(String),
    /// An input is missing, malformed or cannot be triangulated.
    #[error("{0}")]
    BadInput(String),
    /// The work was asked for rightly but could not be finished.
    #[error("{0}")]
    NotReached(String),
    /// The user asked to stop.
    #[error("cancelled")]
    Cancelled,
    /// The reader of standard output went away: it has what it wanted.
    #[error("standard output was closed")]
    BrokenPipe,
}

impl Failure {
    /// Returns the exit code.
    pub fn code(&self) -> u8 {
        match self {
            Self::BrokenPipe => 0,
            Self::CheckFailed => 1,
            Self::Usage(_) => 2,
            Self::BadInput(_) | Self::NotAllRead => 3,
            Self::NotReached(_) => 4,
            Self::Troubles => 5,
            Self::SomeFailed(code) => *code,
            Self::Cancelled => interrupt::exit_code(),
        }
    }

    /// Tells whether nothing is left to say.
    pub fn is_told(&self) -> bool {
        use Failure::*;
        matches!(
            self,
            CheckFailed | NotAllRead | Troubles | SomeFailed(_) | BrokenPipe
        )
    }

    /// Tells the user on standard error, unless nothing is left to say.
    pub fn report(&self) -> ExitCode {
        match self {
            _ if self.is_told() => {}
            // The work and the listener for Ctrl-C may both come here.
            Self::Cancelled if CANCELLED.swap(true, Ordering::SeqCst) => {}
            _ => self.tell(None),
        }
        self.code().into()
    }

    /// Says what went wrong; `file` is whose work it was, if the words do not name another.
    pub fn tell(&self, file: Option<&str>) {
        if voice::is_json() {
            let told = Told::of(self, file);
            let json = serde_json::to_string(&told).expect("bug: strings always serialise");
            return voice::say(&json);
        }
        voice::error(&self.to_string());
        if matches!(self, Self::Usage(_)) && file.is_none() {
            voice::say("\nFor more, try '--help'.");
        }
    }
}

/// A failure as programs read it.
#[derive(Serialize)]
pub struct Told {
    error: String,
    kind: &'static str,
    code: u8,
    file: Option<String>,
    line: Option<u64>,
}

impl Told {
    /// Takes file and line from the words, which begin with them wherever they are known.
    fn of(failure: &Failure, file: Option<&str>) -> Self {
        let error = failure.to_string();
        let (named, line) = place(&error).unzip();
        Self {
            kind: match failure {
                Failure::Usage(_) => "usage",
                Failure::BadInput(_) | Failure::NotAllRead => "bad_input",
                Failure::Cancelled => "cancelled",
                _ => "not_reached",
            },
            code: failure.code(),
            file: named.or(file).map(str::to_owned),
            line: line.flatten(),
            error,
        }
    }
}

/// Finds the file, and the line of it, that words begin with: `map.poly:3: …`, `cannot read map.poly: …`.
fn place(words: &str) -> Option<(&str, Option<u64>)> {
    if let Some(rest) = words.strip_prefix("cannot read ") {
        return rest.split_once(": ").map(|(file, _)| (file, None));
    }
    let (mut head, _) = words.split_once(": ")?;
    let mut line = None;
    // What follows the name is a line, or a line and a column.
    while let Some((rest, number)) = head.rsplit_once(':') {
        let Ok(number) = number.parse() else { break };
        (head, line) = (rest, Some(number));
    }
    let is_file = head == "-" || Path::new(head).is_file();
    is_file.then_some((head, line))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn failures_name_file_and_line_if_their_words_do() {
        for (words, expected) in [
            ("-:3: a number is needed", Some(("-", Some(3)))),
            ("-:3:14: a number is needed", Some(("-", Some(3)))),
            ("-: truncated", Some(("-", None))),
            ("cannot read a.csv: no such file", Some(("a.csv", None))),
            ("--levels: numbers are needed", None),
            ("two outputs want it", None),
        ] {
            assert_eq!(place(words), expected, "{words}");
        }
        let told = Told::of(&Failure::BadInput("-:7: what".to_owned()), Some("b.csv"));
        assert_eq!((told.code, told.line), (3, Some(7)));
        assert_eq!(told.file.as_deref(), Some("-"));
        let told = Told::of(&Failure::Usage("what".to_owned()), Some("b.csv"));
        assert_eq!((told.kind, told.file.as_deref()), ("usage", Some("b.csv")));
    }
}
