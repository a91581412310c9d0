//! The classical algorithms: all against one suite, and each against its own text.

mod edge_flip;
mod suite;
mod thesis;
