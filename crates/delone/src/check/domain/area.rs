//! The domain: faces that the rule takes in, less those with a hole's seed.

use super::chains::Chains;
use super::faces::{Face, Faces};
use super::graph::{Dart, Graph};
use super::places::Place;
use super::rule;
use super::sweep::{Below, Spot};
use super::union::Union;
use crate::pace::Pace;
use crate::{DomainRule, Error, Pslg, Seed};

/// Which side of what belongs to the domain.
pub(super) struct Area {
    faces: Faces,
    belongs: Vec<bool>,
    /// The hole that each face is, if a seed lies in it.
    hole: Vec<Option<u32>>,
}

impl Area {
    pub fn find(
        input: &Pslg,
        domain: DomainRule,
        graph: &Graph,
        below: &Below,
        chains: &Chains,
        pace: &mut Pace,
    ) -> Result<Self, Error> {
        let faces = Faces::find(graph, below, pace)?;
        let belongs = rule::take(input, domain, graph, &faces, chains, pace)?;
        let mut area = Self {
            hole: vec![None; faces.count()],
            belongs,
            faces,
        };
        for (hole, &spot) in below.seeds.iter().enumerate() {
            pace.step()?;
            let on_segment = |edge: usize| Error::SeedOnSegment {
                seed: Seed::Hole(hole),
                at: input.holes[hole],
                segment: chains.owners[edge].expect("bug: a stray subsegment") as usize,
            };
            let face = area.face_at(graph, below, spot).map_err(on_segment)?;
            area.belongs[face as usize] = false;
            area.hole[face as usize] = Some(hole as u32);
        }
        Ok(area)
    }

    /// Returns the face that a seed stands for, or the subsegment that it lies on.
    ///
    /// Upon an edge that only closes the hull, it is the face inside.
    fn face_at(&self, graph: &Graph, below: &Below, spot: Spot) -> Result<Face, usize> {
        let inner = |dart: Dart| self.faces.left(dart).max(self.faces.left(dart.twin()));
        let is_subsegment = |dart: &&Dart| graph.edges()[dart.edge()].is_subsegment;
        let edges = match spot {
            Spot::Above(edge) => return Ok(self.faces.above(edge)),
            Spot::On(place) if graph.star(place).is_empty() => {
                return Ok(self.faces.above(below.places[place as usize]));
            }
            Spot::On(place) => graph.star(place),
            Spot::Inside(edge) => &[Dart::rightward(edge)],
        };
        match edges.iter().find(is_subsegment) {
            Some(dart) => Err(dart.edge()),
            None => Ok(inner(edges[0])),
        }
    }

    /// Tells whether the domain lies to the left of a dart.
    pub fn is_left_of(&self, dart: Dart) -> bool {
        self.belongs[self.faces.left(dart) as usize]
    }

    /// Returns the hole to the left of a dart, if a seed lies in it.
    pub fn hole_left_of(&self, dart: Dart) -> Option<usize> {
        self.hole[self.faces.left(dart) as usize].map(|hole| hole as usize)
    }

    /// Tells whether a place lies in the domain or on its boundary.
    pub fn touches(&self, graph: &Graph, below: &Below, place: Place) -> bool {
        match graph.star(place) {
            [] => self.belongs[self.faces.above(below.places[place as usize]) as usize],
            star => star.iter().any(|&dart| self.is_left_of(dart)),
        }
    }

    /// Counts the parts of the domain that hang together across edges, and likewise its holes.
    pub fn count_parts(&self, graph: &Graph, pace: &mut Pace) -> Result<[usize; 2], Error> {
        let mut union = Union::new(self.faces.count());
        for edge in 0..graph.edges().len() {
            pace.step()?;
            let dart = Dart::rightward(edge);
            if self.is_left_of(dart) == self.is_left_of(dart.twin()) {
                union.join(self.faces.left(dart), self.faces.left(dart.twin()));
            }
        }
        let parts = union.classes();
        let mut is_domain = vec![false; parts.count()];
        for (face, &belongs) in self.belongs.iter().enumerate() {
            pace.step()?;
            is_domain[parts.of(face as u32) as usize] = belongs;
        }
        let components = is_domain.iter().filter(|&&d| d).count();
        // The outer face and what hangs together with it is no hole.
        Ok([components, is_domain.len() - components - 1])
    }
}
