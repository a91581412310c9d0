//! Readers of others, kept from doing harm.

use crate::{Error, Place, Problem};
use std::cell::Cell;
use std::panic::{AssertUnwindSafe, catch_unwind};

thread_local! {
    /// How many readers of others are at work on this thread, one within the other.
    static AT_WORK: Cell<u32> = const { Cell::new(0) };
}

/// Tells whether this thread is within a reader that is not ours, whose panics become errors.
///
/// The hook for panics that a program installs should then be silent: what went wrong is said by the error. This
/// library never touches the hook.
///
/// ```
/// let usual = std::panic::take_hook();
/// std::panic::set_hook(Box::new(move |panic| {
///     if !delone_io::is_reading_with_others() {
///         usual(panic);
///     }
/// }));
/// ```
pub fn is_reading_with_others() -> bool {
    AT_WORK.get() > 0
}

/// Calls a reader that is not ours, and answers a panic in it with an error.
#[allow(dead_code, reason = "the readers of others are optional")]
pub(crate) fn call<T>(
    file: &str,
    reader: &'static str,
    read: impl FnOnce() -> Result<T, Error>,
) -> Result<T, Error> {
    AT_WORK.set(AT_WORK.get() + 1);
    let outcome = catch_unwind(AssertUnwindSafe(read));
    AT_WORK.set(AT_WORK.get() - 1);
    outcome.unwrap_or_else(|_| {
        let text = format!("the reader of {reader} cannot cope with this file; is it broken?");
        Err(Error::Malformed {
            file: file.to_owned(),
            place: Place::File,
            problem: Problem::Other(text),
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panic_becomes_an_error_and_is_known_to_be_one() {
        let outcome: Result<(), _> = call("a.laz", "LAZ", || {
            assert!(is_reading_with_others());
            // Unlike a panic, this calls no hook.
            std::panic::resume_unwind(Box::new("broken"))
        });
        let message = outcome.expect_err("a panic").to_string();
        let expected = "a.laz: the reader of LAZ cannot cope with this file; is it broken?";
        assert!(message.contains(expected), "{message}");
        assert!(!is_reading_with_others());
    }
}
