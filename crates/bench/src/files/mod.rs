//! Files: what it takes to write meshes and to read meshes and clouds of points, in every format that can.
//!
//! - [`engine`]: who writes and reads; [`job`]: what a child process is asked and what it answers.
//! - [`plan`]: what is written and read, in which order; [`report`]: the tables.
//!
//! The mesh is the triangulation of uniform points. Files lie in a folder for temporary files: where that is on a disk, its cache is measured,
//! not the disk. Everybody reads what Delone has written, and the numbers of points and triangles must agree.

pub mod engine;
pub mod job;
pub mod plan;
pub mod report;
