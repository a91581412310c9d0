//! The domain: faces that the rule takes in, less those with a hole's seed.

use super::chains::Chains;
use super::faces::{Face, Faces};
use super::graph::{Dart, Graph};
use super::places::Place;
use super::rule;
use super::sweep::{Below, Spot};
use super::union::Union;
use crate::pace::Pace;
use crate::{DomainRule, Error, Point, Pslg, Seed};

/// Which side of what belongs to the domain.
pub(super) struct Area {
    faces: Faces,
    belongs: Vec<bool>,
    /// The hole that each face is, if a seed lies in it.
    hole: Vec<Option<u32>>,
    /// The region that each face is, if a seed lies in it: the first one.
    region: Vec<Option<u32>>,
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
            region: vec![None; faces.count()],
            belongs,
            faces,
        };
        let segment_of = |dart: Dart| {
            let edge = graph.edges()[dart.edge()];
            let owner = || chains.owners[dart.edge()].expect("bug: a stray subsegment") as usize;
            let owner = edge.is_subsegment.then(owner);
            owner.filter(|&segment| segment < input.segments.len())
        };
        for (&spot, seed) in below.seeds.iter().zip(seeds(input)) {
            pace.step()?;
            let face = area.face_at(graph, below, spot, segment_of);
            let face = face.map_err(|segment| Error::SeedOnSegment {
                seed,
                at: seed_at(input, seed),
                segment,
            })?;
            area.note(face as usize, seed);
        }
        Ok(area)
    }

    /// Notes that a seed lies in a face.
    fn note(&mut self, face: usize, seed: Seed) {
        match seed {
            Seed::Hole(hole) => {
                self.belongs[face] = false;
                self.hole[face] = Some(hole as u32);
            }
            Seed::Region(region) => {
                self.region[face].get_or_insert(region as u32);
            }
        }
    }

    /// Returns the face that a seed stands for, or the segment that it lies on.
    ///
    /// Upon an edge that only closes the hull, it is the face inside.
    fn face_at(
        &self,
        graph: &Graph,
        below: &Below,
        spot: Spot,
        segment_of: impl Fn(Dart) -> Option<usize>,
    ) -> Result<Face, usize> {
        let inner = |dart: Dart| self.faces.left(dart).max(self.faces.left(dart.twin()));
        let edges = match spot {
            Spot::Above(edge) => return Ok(self.faces.above(edge)),
            Spot::On(place) if graph.star(place).is_empty() => {
                return Ok(self.faces.above(below.places[place as usize]));
            }
            Spot::On(place) => graph.star(place),
            Spot::Inside(edge) => &[Dart::rightward(edge)],
        };
        match edges.iter().find_map(|&dart| segment_of(dart)) {
            Some(segment) => Err(segment),
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

    /// Returns the region to the left of a dart, if a seed lies in it.
    pub fn region_left_of(&self, dart: Dart) -> Option<usize> {
        self.region[self.faces.left(dart) as usize].map(|region| region as usize)
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

/// Visits the seeds of holes, then those of regions, as they are listed for the sweep.
fn seeds(input: &Pslg) -> impl Iterator<Item = Seed> {
    let holes = (0..input.holes.len()).map(Seed::Hole);
    holes.chain((0..input.regions.len()).map(Seed::Region))
}

fn seed_at(input: &Pslg, seed: Seed) -> Point {
    match seed {
        Seed::Hole(hole) => input.holes[hole],
        Seed::Region(region) => input.regions[region].at,
    }
}
