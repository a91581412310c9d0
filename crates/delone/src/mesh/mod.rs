//! Topology: half-edges, three to a triangle, and nothing about coordinates.
//!
//! Triangle `t` owns the half-edges `3t`, `3t + 1` and `3t + 2`, counter-clockwise; half-edge
//! `3t + k` lies *opposite* corner `k`. So `corner[h]` is the apex that `h` sees, and row `t` of
//! the corners and of the twins is at once the row of an `.ele` and of a `.neigh` file (and of
//! SciPy's `simplices` and `neighbors`): neighbour `k` lies opposite corner `k`.
//!
//! ```text
//!            corner k = apex(h)
//!              /\
//!   prev(h)   /  \   next(h)          h = 3t + k runs from origin to dest,
//!            /    \                   the triangle lies to its left
//!   origin  /__h___\  dest
//! ```
//!
//! The unbounded face is made of *ghost* triangles that share one vertex at infinity, so the
//! structure is a closed sphere and every half-edge has a twin. V distinct vertices, V ≥ 2, have
//! exactly 2V − 2 faces; if all lie in a row, every face is a ghost and each edge has one on either
//! side.
//!
//! Nobody else writes twins: a builder either works through the edits ([`Mesh::seed`],
//! [`Mesh::split_face`], [`Mesh::split_edge`], [`Mesh::open_edge`], [`Mesh::flip`],
//! [`Mesh::remove_degree_three`], [`Mesh::contract`]) or hands over whole rows. [`Mesh::validate`] checks the result.

mod edit;
mod half_edge;
mod ids;
mod validate;

pub use edit::Moved;
pub use half_edge::Mesh;
pub use ids::{HalfEdgeId, TriangleId, VertexId};
pub use validate::TopologyError;
