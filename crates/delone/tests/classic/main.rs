//! The classical algorithms: all against one suite, and each against its own text.

mod chapter;
mod scene;
mod suite;
mod sweeps;
