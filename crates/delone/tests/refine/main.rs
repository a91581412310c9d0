//! Refinement of what is nasty: every mesh and every report is judged, whatever was asked for.

mod acute;
mod options;
mod scales;
mod stops;
mod support;
mod tight;
