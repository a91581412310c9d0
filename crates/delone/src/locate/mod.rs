//! Point location by walking.
//!
//! Where mesh and geometry meet: [`locate`] asks the mesh for neighbours and
//! [`orient2d`](crate::predicates::orient2d) for signs.

mod walk;

pub use walk::{Location, locate};
