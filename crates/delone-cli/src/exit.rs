//! Exit codes, and the failures that lead to them.
//!
//! The codes are part of the program's interface: scripts rely on them, so a number never changes
//! its meaning.

use crate::interrupt;
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
  130  cancelled by Ctrl-C (143 by SIGTERM, 129 by SIGHUP); nothing half-written is left behind";

/// Why a command did not end with exit code 0.
#[derive(Debug, thiserror::Error)]
pub enum Failure {
    /// The check ran and found defects; they have been reported already.
    #[error("the check failed")]
    CheckFailed,
    /// Some of several files could not be checked; each has been reported already.
    #[error("not every file could be checked")]
    NotAllRead,
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
            Self::Cancelled => interrupt::exit_code(),
        }
    }

    /// Tells the user on standard error, unless nothing is left to say.
    pub fn report(&self) -> ExitCode {
        match self {
            Self::CheckFailed | Self::NotAllRead | Self::BrokenPipe => {}
            // The work and the listener for Ctrl-C may both come here.
            Self::Cancelled if CANCELLED.swap(true, Ordering::SeqCst) => {}
            Self::Usage(_) => eprintln!("error: {self}\n\nFor more, try '--help'."),
            _ => eprintln!("error: {self}"),
        }
        self.code().into()
    }
}
