//! The classical algorithms: all against one suite, and each against its own text.

mod chapter;
mod constrained;
mod edge_flip;
mod facts;
mod flips;
mod guide;
mod insertion;
mod lecture;
mod named;
mod polygons;
mod printed_sweep;
mod refinement;
mod scene;
mod small;
mod stopping;
mod suite;
mod sweep;
mod sweeps;
mod thesis;
