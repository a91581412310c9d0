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
//! structure is a closed sphere and every half-edge has a twin.

mod half_edge;
mod ids;

pub use half_edge::Mesh;
pub use ids::{HalfEdgeId, TriangleId, VertexId};
