//! Constraints: which vertices each joins, and which of them run along each edge.

use super::slots::Slots;
use crate::VertexId;
use std::collections::BTreeSet;
use std::fmt;

/// A constraint of a live triangulation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct ConstraintId(u32);

impl ConstraintId {
    /// Makes the id of number `index`.
    ///
    /// # Panics
    /// If that does not fit 32 bits.
    pub fn new(index: usize) -> Self {
        Self(u32::try_from(index).expect("ids have 32 bits"))
    }

    /// Returns the number: live constraints have small ones, so tables can be indexed by it.
    pub const fn index(self) -> usize {
        self.0 as usize
    }
}

impl fmt::Display for ConstraintId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(&self.0, f)
    }
}

/// All constraints. Where they run geometrically is the mesh's business.
#[derive(Clone, Debug, Default)]
pub(super) struct Constraints {
    slots: Slots,
    ends: Vec<[VertexId; 2]>,
    /// Each edge with each constraint that runs along it.
    along: BTreeSet<(Edge, ConstraintId)>,
}

/// An edge by its ends, the lower number first.
type Edge = [VertexId; 2];

fn undirected([a, b]: [VertexId; 2]) -> Edge {
    [a.min(b), a.max(b)]
}

impl Constraints {
    /// Begins with constraints, given by their chains.
    pub fn new(chains: &[Vec<VertexId>]) -> Self {
        let ends = |chain: &Vec<VertexId>| [chain[0], chain[chain.len() - 1]];
        let edges = chains.iter().enumerate().flat_map(|(i, chain)| {
            let edges = chain.windows(2).map(|pair| undirected([pair[0], pair[1]]));
            edges.map(move |edge| (edge, ConstraintId::new(i)))
        });
        Self {
            slots: Slots::new(vec![true; chains.len()]),
            ends: chains.iter().map(ends).collect(),
            along: edges.collect(),
        }
    }

    /// Adds a constraint, which runs along no edge yet.
    pub fn add(&mut self, ends: [VertexId; 2]) -> ConstraintId {
        let id = ConstraintId(self.slots.take());
        if id.index() == self.ends.len() {
            self.ends.push(ends);
        }
        self.ends[id.index()] = ends;
        id
    }

    /// Removes a constraint, which runs along no edge any more.
    pub fn remove(&mut self, id: ConstraintId) {
        self.slots.give_back(id.0);
    }

    /// Returns the ends of a constraint.
    pub fn ends(&self, id: ConstraintId) -> Option<[VertexId; 2]> {
        self.slots.is_used(id.0).then(|| self.ends[id.index()])
    }

    pub fn count(&self) -> usize {
        self.slots.count()
    }

    /// Visits the constraints, ascending.
    pub fn ids(&self) -> impl Iterator<Item = ConstraintId> + '_ {
        self.slots.ids().map(ConstraintId)
    }

    /// Visits the constraints along an edge, ascending.
    pub fn along(&self, edge: [VertexId; 2]) -> impl Iterator<Item = ConstraintId> + '_ {
        let edge = undirected(edge);
        let range = (edge, ConstraintId(0))..=(edge, ConstraintId(u32::MAX));
        self.along.range(range).map(|&(_, id)| id)
    }

    /// Lets a constraint run along an edge.
    pub fn attach(&mut self, edge: [VertexId; 2], id: ConstraintId) {
        self.along.insert((undirected(edge), id));
    }

    /// Lets a constraint run along an edge no more; true if no other does.
    pub fn detach(&mut self, edge: [VertexId; 2], id: ConstraintId) -> bool {
        self.along.remove(&(undirected(edge), id));
        self.along(edge).next().is_none()
    }

    /// Replaces the edge `ab` by `av` and `vb`.
    pub fn split(&mut self, [a, b]: [VertexId; 2], v: VertexId) {
        let along: Vec<_> = self.along([a, b]).collect();
        for id in along {
            self.detach([a, b], id);
            self.attach([a, v], id);
            self.attach([v, b], id);
        }
    }

    /// Replaces the edges `av` and `vb` by `ab`.
    pub fn merge(&mut self, [a, b]: [VertexId; 2], v: VertexId) {
        let along: Vec<_> = self.along([a, v]).collect();
        for id in along {
            self.detach([a, v], id);
            self.detach([v, b], id);
            self.attach([a, b], id);
        }
    }
}
