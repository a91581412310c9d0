//! Surfaces over a triangulation: interpolants, gradients, rasters and contour lines.
//!
//! ```text
//! Triangulation ────────────┐            ┌─ Linear ───────────────┐
//! ConstrainedTriangulation ─┴─> Samples ─┼─ NaturalNeighbor ──────┼─> value, gradient at a point
//!                    values ──> │        │  NaturalNeighbors      │   Evaluation: many points, a Raster
//!                               │        ├─ SmoothNaturalNeighbor ┤
//!                               ├─> Gradients ─ CloughTocher ─────┘
//!                               └─> contours
//! DataTriangulation, values ────────────── LocalFits ────────> the same
//! ```
//!
//! | surface | smooth | stays within the values | cost of a value, questions in order |
//! |---|---|---|---|
//! | [`Linear`] | continuous | yes | the walk |
//! | [`NaturalNeighbor`], Laplace | continuous; bends at circumcircles | yes | the walk, and some 0.2 µs |
//! | [`NaturalNeighbor`], Sibson | but for tips at the vertices | yes | the walk, and some 0.3 µs |
//! | [`SmoothNaturalNeighbor`] | but for the border | no | the walk, and some 0.4 µs |
//! | [`CloughTocher`] | everywhere | no | the walk, and some 0.1 µs |
//! | [`LocalFits`] | within triangles; jumps at edges | no, nor goes through them | a look into a tree |
//!
//! Where a point lies, which triangles a cavity has and which edges a line crosses is decided exactly; values,
//! weights and gradients are rounded. All of them depend on the triangulation, the values and the point alone. A
//! surface ends where the ground does: outside of the hull, in holes, and beyond the border of a domain it has no
//! value; segments within a domain are walls for natural neighbours and nothing to the others. Without triangles
//! (all points on one line) there is no surface.
//!
//! *Papers*: Sibson, *A vector identity for the Dirichlet tessellation* (1980) and *A brief description of natural
//! neighbour interpolation* (1981); Watson, *Contouring* (1992); Piper, *Properties of local coordinates based on
//! Dirichlet tessellations* (1993); Belikov et al., *The non-Sibsonian interpolation* (1997); Hiyoshi and Sugihara,
//! *Voronoi-based interpolation with higher continuity* (2000); Clough and Tocher, *Finite element stiffness
//! matrices for analysis of plate bending* (1965); Nielson, *A method for interpolating scattered data based upon a
//! minimum norm network* (1983); Renka and Cline, *A triangle-based C¹ interpolation method* (1984); Davydov and
//! Zeilfelder, *Scattered data fitting by direct extension of local polynomials to bivariate splines* (2004).
//!
//! *Does not* extrapolate, or fill between contour lines. Only [`LocalFits`] smooths noise, by as much as its degree and
//! the number of data in a triangle make it.

mod adjacency;
mod cavity;
mod clough_tocher;
mod contour;
mod evaluation;
mod fit;
mod gradients;
mod ground;
mod interpolant;
mod least_squares;
mod levels;
mod natural;
mod number;
mod polynomials;
mod raster;
mod samples;
mod sibson;

pub use clough_tocher::CloughTocher;
pub use contour::{Contour, contours};
pub use evaluation::Evaluation;
pub use gradients::{Estimate, Gradients};
pub use ground::Ground;
pub use interpolant::{Cursor, Interpolant, Jet, Linear};
pub use levels::{levels_every, round_levels};
pub use natural::{NaturalNeighbors, Weighing};
pub use polynomials::{
    FitOptions, FitSummary, LocalFit, LocalFits, Polynomial, average_equal_data,
};
pub use raster::{Grid, Raster};
pub use samples::{Samples, average_duplicates};
pub use sibson::{NaturalNeighbor, SmoothNaturalNeighbor};
