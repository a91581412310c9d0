//! The classical algorithms: all against one suite, and each against its own text.

mod polygons;
mod printed_sweep;
mod suite;
mod sweep;
