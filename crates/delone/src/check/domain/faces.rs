//! The faces of the planar graph.
//!
//! Cycles of darts are joined where they bound one face: the cycle around the leftmost place of
//! anything lies in the face above the edge below that place, or in the outer face if there is none.
//! By induction from left to right this joins the outer cycle of every part of the graph to the rest
//! of the face around it, and nothing else.
//!
//! *Cost*: near linear.

use super::graph::{Dart, Graph};
use super::sweep::Below;
use super::union::Union;
use crate::Error;
use crate::pace::Pace;

/// The number of a face.
pub(super) type Face = u32;

/// The face outside of everything.
pub(super) const OUTER: Face = 0;

/// Which face lies where.
pub(super) struct Faces {
    count: usize,
    /// The face to the left of each dart.
    left: Vec<Face>,
}

impl Faces {
    pub fn find(graph: &Graph, below: &Below, pace: &mut Pace) -> Result<Self, Error> {
        let (mut left, cycles) = graph.cycles(pace)?;
        // Cycle c is element c + 1, the outer face element 0.
        let mut union = Union::new(cycles + 1);
        let above = |left: &[u32], edge: Option<usize>| {
            edge.map_or(OUTER, |e| 1 + left[Dart::rightward(e).index()])
        };
        for place in graph.places.all() {
            pace.step()?;
            let (right, others) = graph.halves(place);
            // The sector that looks to the left lies left of the uppermost dart.
            if let (Some(&upper), []) = (right.last(), others) {
                let around = above(&left, below.places[place as usize]);
                union.join(around, 1 + left[upper.index()]);
            }
        }
        let faces = union.classes();
        for cycle in &mut left {
            pace.step()?;
            *cycle = faces.of(1 + *cycle);
        }
        Ok(Self {
            count: faces.count(),
            left,
        })
    }

    pub fn count(&self) -> usize {
        self.count
    }

    /// Returns the face to the left of a dart.
    pub fn left(&self, dart: Dart) -> Face {
        self.left[dart.index()]
    }

    /// Returns the face above an edge, or below everything.
    pub fn above(&self, edge: Option<usize>) -> Face {
        edge.map_or(OUTER, |edge| self.left(Dart::rightward(edge)))
    }
}
