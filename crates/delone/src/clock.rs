//! How long work has taken, for budgets of time.
//!
//! Where the machine has no clock that the standard library knows, in the browser's `wasm32-unknown-unknown`, no
//! time passes: budgets of time are never used up there, and whoever knows the time cancels by a
//! [`Watch`](crate::Watch) instead.

use std::time::Duration;
#[cfg(not(all(target_family = "wasm", target_os = "unknown")))]
use std::time::Instant;

/// A clock that has been started.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Clock {
    #[cfg(not(all(target_family = "wasm", target_os = "unknown")))]
    start: Instant,
}

#[cfg(not(all(target_family = "wasm", target_os = "unknown")))]
impl Clock {
    /// Starts at zero.
    pub fn start() -> Self {
        let start = Instant::now();
        Self { start }
    }

    /// Returns how long ago it was started.
    pub fn elapsed(&self) -> Duration {
        self.start.elapsed()
    }
}

#[cfg(all(target_family = "wasm", target_os = "unknown"))]
impl Clock {
    /// Starts at zero.
    pub fn start() -> Self {
        Self {}
    }

    /// Returns how long ago it was started: nobody knows.
    pub fn elapsed(&self) -> Duration {
        Duration::ZERO
    }
}
