//! Runs of algorithms, and their files.

mod files;
mod steps;
