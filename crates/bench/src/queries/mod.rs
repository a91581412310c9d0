//! Queries and edits: where points lie, what is nearest to them, cells, values between vertices, and vertices
//! that come, go and move; by ours and its peers.
//!
//! - [`question`]: what is asked, in four rooms; [`input`]: about which points; [`edits`]: what is edited;
//!   [`bounds`]: what cells are clipped to.
//! - [`engine`]: who is asked; a file or folder each: [`ours`], [`spade`], [`kiddo`], [`rstar`], [`voronoice`],
//!   [`voronator`]; SciPy answers in Python.
//! - [`job`]: what a child process is asked and what it answers.
//! - [`plan`]: which cells are checked and timed, in which order; [`report`]: the tables.
//!
//! The discipline is that of the whole crate: fresh processes that take turns, a check before the clock. As
//! many points are asked about as there are, of the same kind and another seed, in random order. Building
//! and asking are timed apart, but for Voronoi diagrams.

pub mod bounds;
pub mod edits;
pub mod engine;
pub mod input;
pub mod job;
pub mod kiddo;
pub mod ours;
pub mod plan;
pub mod question;
pub mod report;
pub mod rstar;
pub mod spade;
pub mod voronator;
pub mod voronoice;
