//! Surfaces, against definitions that are slow and obvious.

mod contour;
mod franke;
mod interpolants;
mod local_fits;
mod natural;
mod oracle;
mod support;
