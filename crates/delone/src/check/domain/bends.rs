//! Why a chain may leave its segment: because segments cross there, or have crossed nearby, or because
//! refinement has split it there.

use super::drift::Corridor;
use super::graph::Graph;
use super::places::Place;

/// Where chains meet, and where they lie off their segments.
pub(super) struct Bends {
    /// For each place the ends of the first segment whose chain passes.
    first: Vec<Option<[Place; 2]>>,
    is_crossing: Vec<bool>,
    /// Segments with the places of their chains that do not lie on them, ascending by segment.
    bent: Vec<(usize, Place)>,
}

impl Bends {
    pub fn new(num_places: usize) -> Self {
        Self {
            first: vec![None; num_places],
            is_crossing: vec![false; num_places],
            bent: Vec::new(),
        }
    }

    /// Notes that the chain of a segment passes `place`.
    pub fn pass(&mut self, graph: &Graph, place: Place, ends: [Place; 2], corridor: &Corridor) {
        if self.is_crossing[place as usize] {
            return;
        }
        let first = self.first[place as usize].get_or_insert(ends);
        // Segments on the line of the first one do not cross it, nor each other.
        let is_on_line = |&end: &Place| corridor.is_on_line(graph.places.at(end));
        self.is_crossing[place as usize] = !first.iter().all(is_on_line);
    }

    /// Notes that `place`, on the chain of a segment, does not lie on it.
    pub fn bend(&mut self, segment: usize, place: Place) {
        self.bent.push((segment, place));
    }

    /// Tells whether the chain of a segment passes a place.
    pub fn is_passed(&self, place: Place) -> bool {
        self.first[place as usize].is_some()
    }

    /// Tells whether chains of segments on different lines meet at a place: there alone a vertex may
    /// have been added.
    pub fn is_crossing(&self, place: Place) -> bool {
        self.is_crossing[place as usize]
    }

    /// Visits the segments that are bent without reason, with a place each.
    ///
    /// A piece of a segment can be bent onto a point where nothing crosses, but only after a crossing
    /// has bent it first. Steiner points are a reason of their own.
    pub fn unfounded(
        &self,
        is_steiner: impl Fn(Place) -> bool,
    ) -> impl Iterator<Item = (usize, Place)> {
        let groups = self.bent.chunk_by(|a, b| a.0 == b.0);
        groups
            .filter(|group| !group.iter().any(|&(_, place)| self.is_crossing(place)))
            .filter_map(move |group| group.iter().copied().find(|&(_, place)| !is_steiner(place)))
    }
}
