//! Nearest neighbours: the nearest vertex, the k nearest, all within a radius.
//!
//! [`Nearest`] searches the graph of a Delaunay triangulation, exactly. Let f be the squared distance to
//! the point asked about, less the point's own square: at the vertices that is their lift to the paraboloid
//! less a linear function, and the piecewise linear interpolation of it over *any* Delaunay triangulation is
//! convex, whichever way cocircular points are triangulated. A local minimum is the minimum, and what lies
//! below a height is connected, vertex by vertex and edge by edge. So
//!
//! - whoever goes to a nearer neighbour as long as there is one ends at a nearest vertex, and all equally
//!   near ones are reached from it through each other (greedy routing; Bose and Morin, *Online routing in
//!   triangulations*, 2004);
//! - the i-th nearest is a neighbour of one of those before it, or as near as one of them and connected by
//!   such (Dickerson, Drysdale and Sack, *Simple algorithms for enumerating interpoint distances and finding k
//!   nearest neighbors*, 1992);
//! - a disc is flooded from its nearest vertex.
//!
//! *Exact*: distances are compared as they are, not as they round; equal ones are ordered by index.
//!
//! *Cost*: 50 bytes a vertex, for points and neighbours in an order that keeps neighbours together; the
//! search begins as in [`locate`](crate::locate), with a descent of O(log n) comparisons to a vertex nearby,
//! and goes on, in practice, for a few vertices. Nothing is proven but O(n).
//!
//! *Does not* know of segments or domains: distances are those of the plane, and points that were carved
//! away count like others. Constraints may keep a triangulation from being Delaunay; then that of its points
//! is built. What is nearest to each vertex needs no search:
//! [`Proximity::nearest_neighbors`](crate::proximity::Proximity::nearest_neighbors).

mod few;
mod graph;
mod index;
mod search;
mod seen;

pub use index::Nearest;
