//! The classical algorithms: all against one suite, and each against its own text.

mod suite;
mod sweeps;
