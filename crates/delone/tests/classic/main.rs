//! The classical algorithms: all against one suite, and each against its own text.

mod chapter;
mod edge_flip;
mod polygons;
mod printed_sweep;
mod scene;
mod suite;
mod sweep;
mod sweeps;
mod thesis;
