//! Wall time of a phase.

use crate::exit::Failure;
use std::time::{Duration, Instant};

/// Does some work and tells how long it took.
pub fn timed<T>(work: impl FnOnce() -> Result<T, Failure>) -> Result<(T, Duration), Failure> {
    let start = Instant::now();
    work().map(|result| (result, start.elapsed()))
}
