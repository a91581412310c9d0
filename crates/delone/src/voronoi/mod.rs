//! The Voronoi diagram: for each point the part of the plane that is nearer to it than to any other;
//! cells clipped to boxes and polygons, what they amount to, and Lloyd's relaxation.
//!
//! ```text
//! Triangulation ── dual ──> Voronoi ── trace, overlay ──> Clipped ── measure ──> areas, centroids …
//!                                      Domain ──┘            └── lloyd ──> points, evenly spread
//! ```
//!
//! The diagram is the dual of the Delaunay triangulation. Its structure is exact: vertices are the
//! circumcenters, *one* for all triangles on one circle (which `in_circle` says, with no tolerance), so
//! the four cells around a square of a grid meet in one vertex and no edge has length zero unless
//! rounding makes it so. Positions of vertices are [rounded
//! correctly](crate::predicates::circumcenter). Two points have an edge that is a line, as do points
//! that all lie on one line; one point has the whole plane; an equal point has the cell of the one that
//! stands for it.
//!
//! [Clipping](Voronoi::clip) follows the boundary of a [`Domain`] from cell to cell, and puts the parts
//! together from where it crosses the edges. Every step of that is exact, and what crosses an edge is the
//! same for both its cells; so areas of clipped cells add up to that of the domain, up to rounding, however
//! degenerate the two lie to each other. A polygon need not be
//! convex, and cells may come in several parts with holes. A part whose area rounds to nothing is left out.
//!
//! *Cost*: O(n) for the diagram, about 0.7 µs a site; clipping O(n log n + k log k + b), in practice linear
//! in n, for k crossings, where b counts, for each segment of the boundary, the sides of the cells that it
//! passes: about 0.3 µs a site and 1 µs a crossing. A cell of very many sides in which very many segments lie
//! is therefore slow, and so is one with very many parts and holes. Cells are made and kept in the order of
//! the mesh, whatever that of the sites: near ones are near in memory. Only the boundary of the domain and
//! levels (`levels.rs`) are followed by one thread alone; two take two thirds of the time. The result is the
//! same for any number, which [`on_threads`](crate::on_threads) sets.
//!
//! Sites may have weights: the [power diagram](Voronoi::weighted) is cut and clipped alike.
//!
//! G. Voronoi, *Nouvelles applications des paramètres continus à la théorie des formes quadratiques*
//! (1908); F. Aurenhammer, *Voronoi diagrams* (1991); S. P. Lloyd, *Least squares quantization in PCM*
//! (1982); Q. Du, V. Faber, M. Gunzburger, *Centroidal Voronoi tessellations* (1999). Tracing and
//! matching are the work of K. Weiler and P. Atherton, *Hidden surface removal using polygon area
//! sorting* (1977), made proof against rounding by levels.

mod assembly;
mod clipped;
mod cut;
mod diagram;
mod domain;
mod dual;
mod levels;
mod lloyd;
mod measure;
mod overlay;
mod parts;
mod power;
mod result;
mod trace;

pub use clipped::Clipped;
pub use domain::Domain;
pub use lloyd::{Lloyd, Relaxed};
pub use measure::Measure;
pub use parts::Part;
pub use result::{Cell, CellSide, Edge, Line, Voronoi};
