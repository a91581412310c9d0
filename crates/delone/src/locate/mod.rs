//! Point location: the vertex, edge or triangle that a point lies on, or what it lies outside of.
//!
//! [`Locator`] answers for a whole [`Triangulation`](crate::Triangulation), be it bare, constrained, carved
//! or refined: it jumps to one of a sample of triangles and walks from there (Mücke, Saias and Zhu, *Fast
//! randomized point location without preprocessing in two- and three-dimensional Delaunay
//! triangulations*, 1999; the sample in a balanced tree, so that it follows clusters as well). [`locate`]
//! walks on a bare [`Mesh`](crate::Mesh) from a hint.
//!
//! *Exact*: every sign is, for every finite point; the jump rounds, and decides nothing. *Ends*: always, in
//! any triangulation of a convex hull, since a visibility walk that takes too long goes on as a straight one.
//! *Cost*: building takes about a tenth of triangulating and one and a half bytes a vertex (and four for each
//! vertex of the convex hull). A query is a descent of O(log n) comparisons, and a walk, in a Delaunay
//! triangulation in practice of a few triangles: a cell of the tree holds some 8 vertices, however they are
//! spread. No distribution is known to break that, but nothing is proven but O(n), which long thin
//! triangles of a domain may cost. What lies outside the hull, or in a row of collinear vertices, is found in
//! O(log n) besides.
//!
//! *Assumes* that the mesh is not changed. *Does not* insert, and does not say what is nearest: that is
//! [`nearest`](crate::nearest).

mod batch;
mod location;
mod locator;
mod rim;
mod tree;
mod walk;

pub(crate) use batch::{Spread, check_finite};
pub use location::Location;
pub use locator::Locator;
pub(crate) use tree::Tree;
pub use walk::locate;
