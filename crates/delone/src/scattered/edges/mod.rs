//! Where on a segment a vertex goes, so that the triangles there hold enough (chapter 3.36).
//!
//! `plot` is the triangle or quadrilateral that is divided, with its data, `rounding` says which points stand for places
//! on an edge of the outline, `rim` which others of its edges are near, `bisection` tries places, and `forecast` knows of most of them beforehand how that
//! ends.

mod bisection;
mod forecast;
mod plot;
mod rim;
mod rounding;

pub(super) use bisection::{Found, Listener, search};
pub(super) use plot::Plot;
pub(super) use rim::Rim;
pub(super) use rounding::is_free;

#[cfg(test)]
mod tests;
