//! What can be wrong with an edit. Nothing has changed then.

use super::ConstraintId;
use crate::{Point, VertexId};

/// Why an edit was refused.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum EditError {
    /// A coordinate is NaN or infinite.
    #[error("a vertex cannot lie at ({}, {}): coordinates must be finite", at.x, at.y)]
    NotFinite {
        /// The point given.
        at: Point,
    },
    /// More vertices than 32-bit half-edge ids can number.
    #[error("one triangulation holds at most {limit} vertices")]
    TooManyVertices {
        /// Largest number of vertices in one triangulation.
        limit: usize,
    },
    /// There is no such vertex, or none any more.
    #[error("there is no vertex {vertex}")]
    NoVertex {
        /// The id given.
        vertex: VertexId,
    },
    /// There is no such constraint, or none any more.
    #[error("there is no constraint {constraint}")]
    NoConstraint {
        /// The id given.
        constraint: ConstraintId,
    },
    /// A vertex was to be moved to where another one lies.
    #[error("vertex {vertex} lies at ({}, {}) already", at.x, at.y)]
    Occupied {
        /// The vertex that lies there.
        vertex: VertexId,
        /// The point given.
        at: Point,
    },
    /// A vertex was to be removed that is an end of a constraint.
    #[error("vertex {vertex} is an end of constraint {constraint}; remove that first")]
    IsEnd {
        /// The vertex.
        vertex: VertexId,
        /// The constraint of lowest id that ends there.
        constraint: ConstraintId,
    },
    /// A vertex was to be removed, or moved away, in which two constraints cross.
    #[error(
        "constraints {} and {} cross in vertex {vertex}; remove one of them first",
        constraints[0], constraints[1]
    )]
    Crossroads {
        /// The vertex.
        vertex: VertexId,
        /// Two constraints that run through it in different directions.
        constraints: [ConstraintId; 2],
    },
    /// A constraint was to join a vertex to itself.
    #[error("a constraint cannot join vertex {vertex} to itself")]
    NoLength {
        /// The vertex.
        vertex: VertexId,
    },
    /// A constraint, added or moved with its end, would cross another one in a point that is no vertex.
    #[error(
        "a constraint from vertex {} to {} would cross constraint {crossed} at ({}, {})",
        ends[0], ends[1], at.x, at.y
    )]
    Crossing {
        /// The ends of the constraint that cannot be.
        ends: [VertexId; 2],
        /// The one in its way, the first after the first end (of several there, that of lowest id).
        crossed: ConstraintId,
        /// Where they would cross, rounded.
        at: Point,
    },
}
