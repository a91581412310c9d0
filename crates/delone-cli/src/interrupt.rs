//! Ctrl-C: a flag that long work polls, and a way out where polling is slow or impossible.
//!
//! Reading, triangulating, checking, drawing and writing ask [`is_requested`] every few
//! milliseconds and clean up after themselves. A read from standard input or a write to a full pipe
//! may block for ever, though. So after a short grace the listener itself removes the temporary files and
//! ends the process, whatever the other threads are doing.
//!
//! Where Ctrl-C is the usual way to end, as of a server, the command says so: then it is no failure.
//!
//! Requests to terminate or hang up are heeded in the same way. Signals that were ignored when the
//! program started, as `nohup` and background jobs of scripts want it, stay ignored.

use crate::exit::Failure;
use crate::progress;
#[cfg(unix)]
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU8, Ordering};
use std::thread::sleep;
use std::time::Duration;

/// Number of the signal of Ctrl-C.
const INTERRUPT: u8 = 2;

/// The signal that asked to stop; 0 if none has.
static REQUESTED: AtomicU8 = AtomicU8::new(0);

/// Whether Ctrl-C is how the program is meant to end.
static EXPECTED: AtomicBool = AtomicBool::new(false);

/// How long work may take to notice the flag by itself.
///
/// Of the 100 ms that are promised, the system wants up to 60 to take back the memory of millions of points.
const GRACE: Duration = Duration::from_millis(20);

/// Listens for Ctrl-C (and for requests to terminate or hang up) from now on.
#[cfg(unix)]
pub fn listen() {
    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};
    use signal_hook::iterator::Signals;
    // A file that grows beyond what `ulimit -f` allows is an error of that file, not the end of the process, which
    // would leave temporary files. Nobody asks for the flag: that there is a handler is enough.
    drop(signal_hook::flag::register(libc::SIGXFSZ, Arc::default()));
    let heeded = [SIGHUP, SIGINT, SIGTERM].into_iter();
    // Without a listener signals end the process at once, which is no reason to refuse the work.
    let Ok(mut signals) = Signals::new(heeded.filter(|&s| !is_ignored(s))) else {
        return;
    };
    std::thread::spawn(move || {
        if let Some(signal) = signals.forever().next() {
            stop(u8::try_from(signal).unwrap_or(INTERRUPT));
        }
    });
}

/// Tells whether whoever started this process wants the signal to be ignored.
#[cfg(unix)]
fn is_ignored(signal: libc::c_int) -> bool {
    let mut action = std::mem::MaybeUninit::<libc::sigaction>::zeroed();
    // SAFETY: `action` is valid for writes, all-zero bytes are a valid `sigaction`, and a null
    // pointer for the new action changes nothing.
    unsafe {
        libc::sigaction(signal, std::ptr::null(), action.as_mut_ptr()) == 0
            && action.assume_init().sa_sigaction == libc::SIG_IGN
    }
}

/// Listens for Ctrl-C (and for requests to terminate or hang up) from now on.
#[cfg(not(unix))]
pub fn listen() {
    let listening = ctrlc::set_handler(|| stop(INTERRUPT));
    // Without a handler Ctrl-C ends the process at once, which is no reason to refuse the work.
    drop(listening);
}

/// Takes Ctrl-C, from now on, for the usual way to end: with exit code 0.
pub fn expect() {
    EXPECTED.store(true, Ordering::SeqCst);
}

/// Ends the process: by its own way out if it takes that soon.
fn stop(signal: u8) {
    REQUESTED.store(signal, Ordering::SeqCst);
    sleep(GRACE);
    delone_io::discard_unfinished_files();
    progress::wipe();
    if signal == INTERRUPT && EXPECTED.load(Ordering::SeqCst) {
        std::process::exit(0);
    }
    Failure::Cancelled.report();
    std::process::exit(Failure::Cancelled.code().into());
}

/// Tells whether the user asked to stop.
pub fn is_requested() -> bool {
    REQUESTED.load(Ordering::SeqCst) != 0
}

/// Returns the exit code of a process that was asked to stop, as shells count: 128 and the signal.
pub fn exit_code() -> u8 {
    match REQUESTED.load(Ordering::SeqCst) {
        0 => 128 + INTERRUPT,
        signal => 128 + signal,
    }
}
