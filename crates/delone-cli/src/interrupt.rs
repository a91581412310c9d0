//! Ctrl-C: a flag that long work polls, and a way out where polling is slow or impossible.
//!
//! Reading, triangulating, checking, drawing and writing ask [`is_requested`] every few
//! milliseconds and clean up after themselves. A read from standard input or a write to a full pipe
//! may block for ever, though. So after a short grace the listener itself removes the temporary files and
//! ends the process, whatever the other threads are doing.

use crate::exit::Failure;
use crate::progress;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::sleep;
use std::time::Duration;

static REQUESTED: AtomicBool = AtomicBool::new(false);

/// How long work may take to notice the flag by itself.
const GRACE: Duration = Duration::from_millis(40);

/// Listens for Ctrl-C (and for requests to terminate or hang up) from now on.
pub fn listen() {
    let listening = ctrlc::set_handler(|| {
        REQUESTED.store(true, Ordering::SeqCst);
        sleep(GRACE);
        delone_io::discard_unfinished_files();
        progress::wipe();
        Failure::Cancelled.report();
        std::process::exit(Failure::Cancelled.code().into());
    });
    // Without a handler Ctrl-C ends the process at once, which is no reason to refuse the work.
    drop(listening);
}

/// Tells whether the user asked to stop.
pub fn is_requested() -> bool {
    REQUESTED.load(Ordering::SeqCst)
}
