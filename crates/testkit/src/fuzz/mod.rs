//! Cases and checks for fuzzing: small inputs, dense in degeneracy, built in several ways.
//!
//! The programs `fuzz-points`, `fuzz-segments`, `fuzz-edit`, `fuzz-refine` and `fuzz-cover` run millions of cases in one process, as a
//! [`Campaign`]; the targets of `fuzz/` let a coverage-guided fuzzer choose the input.

mod campaign;
pub mod cover;
pub mod edit;
pub mod points;
pub mod refine;
pub mod segments;

pub use campaign::{Campaign, Options, Subject};

use delone::Point;
use std::fmt::Write as _;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// What a fuzzer tries.
pub trait Case: Clone + Default + Send {
    /// Lists the cases with one part less.
    fn smaller(&self) -> Vec<Self>;

    /// Writes the case as Rust source, exactly: Rust prints the shortest decimal that reads back
    /// alike.
    fn as_source(&self) -> String;
}

/// Drops parts as long as `fails` holds for the rest, and returns what is left.
pub fn shrink<C: Case>(case: &C, fails: impl Fn(&C) -> bool) -> C {
    let mut left = case.clone();
    while let Some(fewer) = left.smaller().into_iter().find(&fails) {
        left = fewer;
    }
    left
}

/// Lists the slices with one item less.
fn without_one<T: Clone>(items: &[T]) -> impl Iterator<Item = Vec<T>> {
    (0..items.len()).map(|i| [&items[..i], &items[i + 1..]].concat())
}

/// Turns a panic into a failure.
fn guarded(check: impl FnOnce() -> Result<(), String>) -> Result<(), String> {
    catch_unwind(AssertUnwindSafe(check)).unwrap_or_else(|_| Err("panicked".to_owned()))
}

/// Writes points as a Rust array, a line each.
fn array(points: &[Point]) -> String {
    let mut source = "[\n".to_owned();
    for Point { x, y } in points {
        let _ = writeln!(source, "    ({x:?}, {y:?}),");
    }
    source + "]"
}
