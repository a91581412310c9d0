//! Refinement: ours and its peers, from the same outlines to meshes of the same quality.
//!
//! - [`goal`]: which outlines, and what is asked of the meshes.
//! - [`mesher`]: the contenders; [`ours`] and [`spade`] run in a child of this program, the others in
//!   Python, where they are installed.
//! - [`job`]: what a child is asked and what it answers; [`quality`]: what its mesh is like.
//! - [`plan`]: which cells are checked and timed, in which order.
//! - [`report`]: tables and JSON; [`targets`]: how the figures stand to what was aimed at.
//!
//! The discipline is that of the whole crate: fresh processes that take turns, a check before the
//! clock. What is timed leads from points and segments to the mesh: triangulation, carving and
//! refinement.

pub mod goal;
pub mod job;
pub mod mesher;
pub mod ours;
pub mod plan;
pub mod quality;
pub mod report;
pub mod spade;
pub mod targets;
