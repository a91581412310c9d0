//! Surfaces over a triangulation: interpolants, gradients, rasters and contour lines.

mod adjacency;
mod cavity;
mod clough_tocher;
mod fit;
mod gradients;
mod ground;
mod interpolant;
mod natural;
mod number;
mod samples;
mod sibson;

pub use clough_tocher::CloughTocher;
pub use gradients::{Estimate, Gradients};
pub use ground::Ground;
pub use interpolant::{Cursor, Interpolant, Jet, Linear};
pub use natural::{NaturalNeighbors, Weighing};
pub use samples::{Samples, average_duplicates};
pub use sibson::{NaturalNeighbor, SmoothNaturalNeighbor};
