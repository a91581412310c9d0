//! Cancellation within loops.

use crate::Error;
use delone::Watch;

/// Rounds between two looks at the watch: well below a millisecond of work.
const ROUNDS_PER_POLL: usize = 4096;

/// Fails once the watch has cancelled; asks it in one of many rounds.
pub(crate) fn check(watch: &dyn Watch, round: usize) -> Result<(), Error> {
    if round.is_multiple_of(ROUNDS_PER_POLL) && watch.is_cancelled() {
        return Err(Error::Cancelled);
    }
    Ok(())
}
