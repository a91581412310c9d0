//! Surfaces, against definitions that are slow and obvious.

mod contour;
mod interpolants;
mod natural;
mod oracle;
mod support;
