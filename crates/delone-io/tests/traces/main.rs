//! Runs of algorithms: their files, and their animations.

mod animations;
mod files;
mod steps;
