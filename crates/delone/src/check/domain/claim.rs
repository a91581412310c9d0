//! The claim that is verified: points, triangles, subsegments, and what else is said about them.

use super::chains::Claimed;
#[cfg(doc)]
use crate::DomainRule;
use crate::{Point, VertexId};

/// What is claimed to be the constrained Delaunay triangulation of a domain.
#[derive(Clone, Copy)]
pub struct DomainMesh<'a> {
    pub(super) points: &'a [Point],
    pub(super) triangles: &'a [[VertexId; 3]],
    pub(super) subsegments: &'a [[VertexId; 2]],
    pub(super) chains: Option<Claimed<'a>>,
    pub(super) is_refined: bool,
}

impl<'a> DomainMesh<'a> {
    /// Takes the points of the input, followed by those that were added; the triangles of the domain;
    /// and the constrained edges, those outside the domain included.
    pub fn new(
        points: &'a [Point],
        triangles: &'a [[VertexId; 3]],
        subsegments: &'a [[VertexId; 2]],
    ) -> Self {
        Self {
            points,
            triangles,
            subsegments,
            chains: None,
            is_refined: false,
        }
    }

    /// Claims that the mesh was refined, so that it may have Steiner points.
    ///
    /// Under [`DomainRule::Hull`] the edges of the convex hull of the input's points are segments then,
    /// and subsegments their pieces; where they are named, they are numbered behind those of the input,
    /// counter-clockwise from the lexicographically smallest point, each from one point on the hull to the
    /// next. Their chains need no claim.
    pub fn refined(self) -> Self {
        Self {
            is_refined: true,
            ..self
        }
    }

    /// Claims for each segment the chain of its vertices, from its first end to its second, which
    /// will be verified; a segment without length has one.
    ///
    /// Without this, chains are found by the verifier. Where segments run beside each other within a few
    /// units in the last place, it takes one that fits, which need not be the one that was meant; with
    /// [`DomainRule::EvenOdd`] a right mesh may be found wrong then.
    pub fn with_chains(self, chains: &'a dyn Fn(usize) -> &'a [VertexId]) -> Self {
        Self {
            chains: Some(chains),
            ..self
        }
    }
}
