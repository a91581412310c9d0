//! Delone and its crates.io peers on the same points and domains: one command, one table.
//!
//! - [`subject`]: what is triangulated, points or a domain, fixed by name, size and seed.
//! - [`engines`]: the contenders, one file each.
//! - [`measure`]: time and memory of one triangulation inside a process.
//! - [`job`]: what a child process does; [`process`]: how it is run and what becomes of it.
//! - [`plan`]: which cells are checked and timed, in which order.
//! - [`report`]: tables in Markdown, everything in JSON; [`machine`]: what they must state.
//! - [`refine`]: the same for refinement; [`queries`]: the same for queries, cells, surfaces and edits;
//!   [`cover`]: the same for covers of data; [`files`]: the same for files. All share [`effort`], [`peer`], [`workshop`], [`python`] and [`heading`].
//!
//! **Discipline.** Every triangulation that counts as *fresh* has a process of its own, on the same
//! input for all engines; some warm-up processes are discarded, the median of the others counts,
//! and the engines take turns so that a slow minute of the machine hits all of them. *Repeated*
//! means several triangulations in one process, each of new input, the median counts. Before
//! anything is timed, every engine's result is compared with the numbers of triangles and
//! constrained edges that there must be ([`expected`]). Nothing is pinned to a core and no priority is changed.

pub mod cover;
pub mod effort;
pub mod engines;
pub mod expected;
pub mod files;
pub mod heading;
pub mod job;
pub mod machine;
pub mod measure;
pub mod peer;
pub mod plan;
pub mod process;
pub mod python;
pub mod queries;
pub mod refine;
pub mod report;
pub mod stats;
pub mod subject;
pub mod table;
pub mod workshop;
