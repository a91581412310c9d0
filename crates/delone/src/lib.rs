//! Exact, canonical Delaunay triangulation of points in the plane.
//!
//! A point set has exactly *one* triangulation here: duplicates are merged, every predicate is
//! exact, and points on a common circle are told apart by a symbolic perturbation that depends on
//! coordinates alone. Builder, number of threads and order of the input do not change the set of
//! triangles.
//!
//! ```
//! let t = delone::triangulate([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (0.5, 0.4)])?;
//! assert_eq!(t.num_triangles(), 4);
//! # Ok::<(), delone::Error>(())
//! ```

pub mod check;
pub mod delaunay;
mod error;
mod hash;
pub mod locate;
pub mod mesh;
mod point;
pub mod predicates;
mod triangulation;
mod watch;

pub use delaunay::{Delaunay, triangulate};
pub use error::Error;
pub use hash::{TriangulationHash, hash_triangles};
pub use mesh::{HalfEdgeId, Mesh, TriangleId, VertexId};
pub use point::Point;
pub use triangulation::{Duplicate, Triangulation};
pub use watch::{Phase, Watch};
