//! Do the triangles cover the domain, and nothing else?

use super::super::{Defect, Verifier, adjacency::Adjacency};
use super::area::Area;
use super::graph::Graph;
use crate::{Error, HalfEdgeId, Point};

/// Where edges of the graph are edges of triangles.
pub(super) struct Borders {
    /// For each dart the half-edge that runs along it.
    beside: Vec<Option<HalfEdgeId>>,
    /// For each half-edge whether it is part of a segment.
    is_constrained: Vec<bool>,
    /// Half-edges without twins.
    count: usize,
}

impl Borders {
    /// Looks half-edges up in the graph; reports those without twins that are not in it.
    pub fn find(
        verifier: &mut Verifier,
        graph: &Graph,
        adjacency: &Adjacency,
    ) -> Result<Self, Error> {
        let mut borders = Self {
            beside: vec![None; graph.num_darts()],
            is_constrained: vec![false; adjacency.num_half_edges()],
            count: 0,
        };
        for h in adjacency.half_edges() {
            verifier.pace.step()?;
            let is_border = adjacency.twin(h).is_none();
            borders.count += usize::from(is_border);
            let ends = [adjacency.origin(h), adjacency.dest(h)];
            let [origin, dest] = ends.map(|v| graph.places.of(v));
            if let Some(dart) = graph.find(origin, dest) {
                borders.beside[dart.index()] = Some(h);
                borders.is_constrained[h.index()] = graph.edges()[dart.edge()].is_subsegment;
            } else if is_border {
                let edge = ends.map(|v| verifier.corner(v));
                let triangle = h.triangle();
                verifier.defects.push(Defect::OpenEdge { edge, triangle });
            }
        }
        Ok(borders)
    }

    pub fn is_constrained(&self, h: HalfEdgeId) -> bool {
        self.is_constrained[h.index()]
    }

    /// Counts the edges with one triangle.
    pub fn count(&self) -> usize {
        self.count
    }

    /// Requires a triangle on every side of an edge that belongs to the domain, and none elsewhere.
    pub fn check(
        &self,
        verifier: &mut Verifier,
        graph: &Graph,
        area: &Area,
        holes: &[Point],
    ) -> Result<(), Error> {
        for dart in graph.darts() {
            verifier.pace.step()?;
            let half_edge = self.beside[dart.index()];
            if area.is_left_of(dart) == half_edge.is_some() {
                continue;
            }
            let edge = graph.corners(dart);
            let triangle = half_edge.map(HalfEdgeId::triangle);
            verifier
                .defects
                .push(match (triangle, area.hole_left_of(dart)) {
                    (None, _) => Defect::Uncovered { edge },
                    (Some(triangle), None) => Defect::OutsideDomain { edge, triangle },
                    (Some(triangle), Some(hole)) => Defect::FilledHole {
                        hole,
                        at: holes[hole],
                        edge,
                        triangle,
                    },
                });
        }
        Ok(())
    }
}
