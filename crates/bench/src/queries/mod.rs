//! Queries: where points lie, and what is nearest to them, by ours and its peers.
//!
//! - [`question`]: what is asked; [`engine`]: who is asked, one file each: [`ours`], [`spade`], [`kiddo`],
//!   [`rstar`].
//! - [`job`]: what a child process is asked and what it answers.
//! - [`plan`]: which cells are checked and timed, in which order; [`report`]: the tables.
//!
//! The discipline is that of the whole crate: fresh processes that take turns, a check before the clock. As
//! many points are asked about as there are, of the same kind and another seed, in random order. Building
//! and asking are timed apart.

pub mod engine;
pub mod job;
pub mod kiddo;
pub mod ours;
pub mod plan;
pub mod question;
pub mod report;
pub mod rstar;
pub mod spade;
