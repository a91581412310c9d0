//! The classical algorithms: all against one suite, and each against its own text.

mod chapter;
mod edge_flip;
mod scene;
mod suite;
mod sweeps;
mod thesis;
