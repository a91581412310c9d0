//! How the program speaks: results on standard output, everything else on standard error.
//!
//! Who works on one file of a batch is not heard at once: the words are kept, by thread, until the batch
//! says them, file by file in the order of the command line.

use std::cell::RefCell;
use std::io::Write;
use std::sync::atomic::{AtomicBool, Ordering};

static VERBOSE: AtomicBool = AtomicBool::new(false);
static JSON: AtomicBool = AtomicBool::new(false);

thread_local! {
    /// What this thread has said, if that is kept.
    static KEPT: RefCell<Option<Kept>> = const { RefCell::new(None) };
}

/// What has been said by whoever was not to be heard at once.
#[derive(Debug, Default, PartialEq, Eq)]
pub struct Kept {
    /// Lines for standard output.
    pub results: Vec<String>,
    /// Lines for people.
    pub notes: Vec<String>,
}

/// Settles how much is said, and whether failures are told as JSON.
pub fn settle(verbose: bool, json: bool) {
    VERBOSE.store(verbose, Ordering::SeqCst);
    JSON.store(json, Ordering::SeqCst);
}

/// Tells whether everything is to be said that may interest somebody.
pub fn is_verbose() -> bool {
    VERBOSE.load(Ordering::Relaxed)
}

/// Tells whether results are JSON, and failures with them.
pub fn is_json() -> bool {
    JSON.load(Ordering::Relaxed)
}

/// Does some work whose words are kept.
pub fn keeping<T>(work: impl FnOnce() -> T) -> (T, Kept) {
    KEPT.with_borrow_mut(|kept| *kept = Some(Kept::default()));
    let result = work();
    let kept = KEPT.with_borrow_mut(Option::take).unwrap_or_default();
    (result, kept)
}

/// Keeps a line if lines are kept here, and tells whether they are.
pub fn keep(line: &str, place: impl FnOnce(&mut Kept) -> &mut Vec<String>) -> bool {
    KEPT.with_borrow_mut(|kept| match kept {
        Some(kept) => {
            place(kept).push(line.to_owned());
            true
        }
        None => false,
    })
}

/// Tells whether lines are kept here.
pub fn keeps() -> bool {
    KEPT.with_borrow(Option::is_some)
}

/// Says a line to people; that nobody listens is no failure.
pub fn say(line: &str) {
    if !keep(line, |kept| &mut kept.notes) {
        let heard = writeln!(anstream::stderr().lock(), "{line}");
        drop(heard);
    }
}

/// Says what went wrong.
pub fn error(text: &str) {
    let style = anstyle::AnsiColor::Red.on_default().bold();
    say(&format!("{style}error:{style:#} {text}"));
}

/// Says what deserves a word.
pub fn note(text: &str) {
    let style = anstyle::AnsiColor::Yellow.on_default();
    say(&format!("{style}note:{style:#} {text}"));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_kept_by_thread_and_said_by_nobody() {
        let (seven, kept) = keeping(|| {
            say("a note");
            assert!(keep("{}", |kept| &mut kept.results));
            std::thread::scope(|scope| {
                scope.spawn(|| assert!(!keep("lost", |kept| &mut kept.results)));
            });
            7
        });
        let expected = Kept {
            results: vec!["{}".to_owned()],
            notes: vec!["a note".to_owned()],
        };
        assert_eq!((seven, kept), (7, expected));
        assert!(!keep("heard", |kept| &mut kept.notes));
    }
}
