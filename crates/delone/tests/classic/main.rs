//! The classical algorithms: all against one suite, and each against its own text.

mod facts;
mod flips;
mod insertion;
mod lecture;
mod small;
mod suite;
