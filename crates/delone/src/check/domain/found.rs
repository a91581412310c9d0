//! What a verification knows of a mesh at its end, for those who look further.

use super::super::adjacency::Adjacency;
use super::area::Area;
use super::chains::Chains;
use super::cover::Borders;
use super::graph::Graph;
use super::places::Place;
use crate::{Point, Pslg, VertexId};

/// What has been found out about a mesh that is right.
pub(super) struct Found<'f> {
    pub input: &'f Pslg,
    pub points: &'f [Point],
    pub triangles: &'f [[VertexId; 3]],
    /// The segments of the input, and behind them the edges of its hull, if they are segments.
    pub segments: &'f [[VertexId; 2]],
    pub graph: &'f Graph<'f>,
    pub chains: &'f Chains,
    pub area: &'f Area,
    pub adjacency: &'f Adjacency<'f>,
    pub borders: &'f Borders,
}

impl Found<'_> {
    /// Visits the places of added vertices.
    pub fn added(&self) -> impl Iterator<Item = Place> {
        let added = self.input.points.len()..self.points.len();
        added.map(|v| self.graph.places.of(VertexId::new(v)))
    }

    /// Visits the places along a segment; none along one without length.
    pub fn places_along(&self, segment: usize) -> impl Iterator<Item = Place> {
        let darts = self.chains.of(segment);
        let first = darts.first().map(|&dart| self.graph.origin(dart));
        first
            .into_iter()
            .chain(darts.iter().map(|&dart| self.graph.dest(dart)))
    }
}
