//! Delone and its crates.io peers on the same points: one command, one table.
//!
//! - [`distributions`]: the point sets, fixed by name, count and seed.
//! - [`engines`]: the contenders, one file each.
//! - [`measure`]: time and memory of one triangulation inside a process.
//! - [`job`]: what a child process does; [`process`]: how it is run and what becomes of it.
//! - [`plan`]: which cells are checked and timed, in which order.
//! - [`report`]: tables in Markdown, everything in JSON; [`machine`]: what they must state.
//!
//! **Discipline.** Every triangulation that counts as *fresh* has a process of its own, on the same
//! points for all engines; some warm-up processes are discarded, the median of the others counts,
//! and the engines take turns so that a slow minute of the machine hits all of them. *Repeated*
//! means several triangulations in one process, each of new points, the median counts. Before
//! anything is timed, every engine's result is compared with the number of triangles that Euler
//! demands ([`expected`]). Nothing is pinned to a core and no priority is changed.

pub mod engines;
pub mod expected;
pub mod job;
pub mod machine;
pub mod measure;
pub mod plan;
pub mod process;
pub mod report;
pub mod stats;
pub mod table;

pub use delone_samples as distributions;
