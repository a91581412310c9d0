//! Covers of data: what it takes to lay triangles around scattered data so that each holds d to 3d − 1 of them.
//!
//! - [`subject`]: which data, made or from a file.
//! - [`laps`]: how long each of Algorithms A, B and C takes.
//! - [`job`]: what a child process is asked and what it answers; [`facts`]: what its cover is like.
//! - [`plan`]: which data are checked and timed, in which order; [`report`]: the tables and the plot.
//!
//! The discipline is that of the whole crate: fresh processes, a check before the clock. The check is
//! [`delone::check::verify_cover`], which shares nothing with the builders but predicates. There is no peer: no
//! other program is known that makes such triangulations.

pub mod facts;
pub mod job;
pub mod laps;
pub mod plan;
pub mod report;
pub mod subject;
