//! The seeds of holes and regions, and what the segments enclose.
//!
//! Those on segments are found first, exactly. The others are asked of the domain as triangulation finds it,
//! with crossings split. *Cost*: that of triangulating the domain.

use super::graph::Graph;
use super::trouble::{Kind, Trouble};
use crate::constrained::{ConstrainedDelaunay, Warning};
use crate::parallel::Workers;
use crate::pslg::{Nearby, Scratch};
use crate::{DomainRule, Error, Point, Pslg, Seed, SegmentPolicy, Watch};
use std::collections::BTreeMap;

/// What is found, by kind.
type Found = BTreeMap<Kind, Vec<Trouble>>;

/// Finds what is wrong with the seeds, and domains that enclose nothing; the latter and where seeds lie only
/// if the domain may be asked.
pub(super) fn examine(
    pslg: &Pslg,
    graph: &Graph,
    rule: DomainRule,
    asks: bool,
    workers: Workers,
    watch: &dyn Watch,
) -> Result<Found, Error> {
    let mut found = Found::new();
    let has_seeds = !(pslg.holes.is_empty() && pslg.regions.is_empty());
    if !has_seeds && (rule == DomainRule::Hull || pslg.segments.is_empty()) {
        return Ok(found);
    }
    let mut asked = Asked::new(pslg);
    asked.drop_those_on_segments(graph, workers, &mut found);
    if !asks {
        return Ok(found);
    }
    loop {
        let builder = ConstrainedDelaunay::new().domain(rule);
        let builder = builder.crossings(SegmentPolicy::Split).watch(watch);
        match builder.triangulate(asked.pslg.clone()) {
            Ok(result) => {
                let warnings = result.warnings().iter();
                warnings.for_each(|warning| asked.tell(warning, pslg, &mut found));
                return Ok(found);
            }
            // On a piece of a segment that rounding has moved.
            Err(Error::SeedOnSegment { seed, segment, at }) => {
                add(
                    &mut found,
                    Kind::SeedOnSegment,
                    on_segment(asked.name(seed), segment, at),
                );
                asked.drop(seed);
            }
            // Told already, and there is no domain then.
            Err(Error::OpenPolygon { .. }) => return Ok(found),
            Err(error) => return Err(error),
        }
    }
}

/// A drawing with some of its seeds.
struct Asked {
    pslg: Pslg,
    /// The seeds that are left, by their numbers in the input.
    holes: Vec<usize>,
    regions: Vec<usize>,
}

impl Asked {
    fn new(pslg: &Pslg) -> Self {
        Self {
            holes: (0..pslg.holes.len()).collect(),
            regions: (0..pslg.regions.len()).collect(),
            pslg: pslg.clone(),
        }
    }

    /// What the input calls a seed.
    fn name(&self, seed: Seed) -> Seed {
        match seed {
            Seed::Hole(i) => Seed::Hole(self.holes[i]),
            Seed::Region(i) => Seed::Region(self.regions[i]),
        }
    }

    fn drop(&mut self, seed: Seed) {
        match seed {
            Seed::Hole(i) => {
                self.holes.remove(i);
                self.pslg.holes.remove(i);
            }
            Seed::Region(i) => {
                self.regions.remove(i);
                self.pslg.regions.remove(i);
            }
        }
    }

    fn drop_those_on_segments(&mut self, graph: &Graph, workers: Workers, found: &mut Found) {
        let segments = Nearby::of_segments(graph.points, &graph.ends, workers);
        let mut scratch = Scratch::default();
        let mut is_free = |seed: Seed, at: Point| {
            let mut on: Option<u32> = None;
            segments.segments_within(at, 0.0, &mut scratch, |s| {
                let name = graph.names[s as usize];
                on = Some(on.map_or(name, |first| first.min(name)));
            });
            let trouble = on.map(|segment| on_segment(seed, segment as usize, at));
            trouble.is_none_or(|trouble| {
                add(found, Kind::SeedOnSegment, trouble);
                false
            })
        };
        let (holes, regions) = (self.pslg.holes.clone(), self.pslg.regions.clone());
        self.holes.retain(|&i| is_free(Seed::Hole(i), holes[i]));
        self.regions
            .retain(|&i| is_free(Seed::Region(i), regions[i].at));
        self.pslg.holes = self.holes.iter().map(|&i| holes[i]).collect();
        self.pslg.regions = self.regions.iter().map(|&i| regions[i]).collect();
    }

    /// Translates what triangulation has to say.
    fn tell(&self, warning: &Warning, input: &Pslg, found: &mut Found) {
        let (kind, seeds, at) = match *warning {
            Warning::Empty => (Kind::Nothing, vec![], None),
            Warning::HoleOutside { hole, at } => (
                Kind::SeedOutside,
                vec![self.name(Seed::Hole(hole))],
                Some(at),
            ),
            Warning::RegionOutside { region, at } => (
                Kind::SeedOutside,
                vec![self.name(Seed::Region(region))],
                Some(at),
            ),
            Warning::RegionTwice { region, first } => {
                let seeds = [region, first].map(|i| self.name(Seed::Region(i)));
                let at = input.regions[self.regions[region]].at;
                (Kind::SeedTwice, seeds.into(), Some(at))
            }
        };
        let trouble = Trouble {
            seeds,
            at,
            ..Trouble::default()
        };
        add(found, kind, trouble);
    }
}

fn add(found: &mut Found, kind: Kind, trouble: Trouble) {
    found.entry(kind).or_default().push(trouble);
}

fn on_segment(seed: Seed, segment: usize, at: Point) -> Trouble {
    Trouble {
        segments: vec![segment],
        seeds: vec![seed],
        at: Some(at),
        ..Trouble::default()
    }
}
