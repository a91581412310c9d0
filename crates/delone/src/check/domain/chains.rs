//! Each segment is a chain of subsegments.
//!
//! From the first end of a segment, a step leads along a subsegment that [goes on](Corridor::goes_on)
//! to a place that is [near](Corridor::is_near). If the place is on the segment and a subsegment runs
//! along it, that step is taken. Else, with a bend in sight, the steps that differ least in direction
//! are tried; only where these lead nowhere, all others. Steps never turn back, and no place is
//! passed twice.
//!
//! Where segments run beside each other within the drift, rounding leaves several ways, and the chain
//! that is found need not be the one that was meant. A subsegment on any of the ways counts as part
//! of the segment, and so what depends on chains being told apart, the even–odd rule, may be judged
//! wrong between them: whoever knows the chains should [say so](super::DomainMesh::with_chains).
//! Only the chains of the hull are known for sure: to the right of them there is nothing.
//!
//! *Cost*: O(log d) for a step from a place with d subsegments, O(d) for one along the hull; more only where
//! segments run beside each other within the drift, and all attempts beyond these together are limited by
//! the size of the graph.

use super::bends::Bends;
use super::drift::Corridor;
use super::graph::{Dart, Graph};
use super::places::Place;
use crate::pace::Pace;
use crate::predicates::{Orientation, orient2d};
use crate::{Error, VertexId};

/// Darts that are tried just because they are there, for each dart and place of the graph: far more
/// than a right mesh needs, and a limit for wrong ones with many segments from one place.
const PATIENCE: usize = 64;

/// The chains that a builder claims: for each segment its vertices.
pub(super) type Claimed<'a> = &'a dyn Fn(usize) -> &'a [VertexId];

/// The chain that is claimed for a segment, if one is.
pub(super) type Claim<'c, 'a> = &'c dyn Fn(usize) -> Option<&'a [VertexId]>;

/// The chains of all segments, as darts from their first ends to their second.
pub(super) struct Chains {
    /// Where the chain of each segment begins, and where the last one ends.
    starts: Vec<usize>,
    darts: Vec<Dart>,
    pub bends: Bends,
    /// For each edge the first segment that it is a part of, or could be where rounding leaves several
    /// ways.
    pub owners: Vec<Option<u32>>,
    /// Segments that have no chain, with the place that was reached last.
    pub broken: Vec<(usize, Place)>,
}

impl Chains {
    /// Finds the chain of every segment, or follows those that are claimed; the first `num_drawn` are
    /// drawn, the others are the edges of the hull, counter-clockwise.
    pub fn find(
        graph: &Graph,
        segments: &[[VertexId; 2]],
        num_drawn: usize,
        claimed: Claim,
        is_refined: bool,
        pace: &mut Pace,
    ) -> Result<Self, Error> {
        let mut finder = Finder::new(graph, is_refined);
        for (index, ends) in segments.iter().enumerate() {
            pace.step()?;
            let ends = ends.map(|v| graph.places.of(v));
            let track = Track::new(graph, ends, is_refined);
            let broken = match (index < num_drawn).then(|| claimed(index)) {
                Some(Some(chain)) => finder.accept(&track, chain, pace)?,
                Some(None) => finder.search(&track, pace)?,
                None => finder.go_round(&track, pace)?,
            };
            match broken {
                Some(place) => finder.chains.broken.push((index, place)),
                None => finder.keep(index, &track),
            }
            finder.chains.starts.push(finder.chains.darts.len());
        }
        finder.look_closer(&segments[..num_drawn], claimed, pace)?;
        Ok(finder.chains)
    }

    /// Visits the subsegments that are part of no segment.
    pub fn stray(&self, graph: &Graph) -> impl Iterator<Item = usize> {
        let edges = graph.edges().iter().zip(&self.owners).enumerate();
        edges
            .filter(|(_, (edge, owner))| edge.is_subsegment && owner.is_none())
            .map(|(edge, _)| edge)
    }

    /// Returns the darts along a segment.
    pub fn of(&self, segment: usize) -> &[Dart] {
        &self.darts[self.starts[segment]..self.starts[segment + 1]]
    }

    /// Visits the segments with their chains.
    pub fn iter(&self) -> impl Iterator<Item = &[Dart]> {
        (0..self.starts.len() - 1).map(|segment| self.of(segment))
    }
}

/// One segment that is being followed.
struct Track {
    ends: [Place; 2],
    corridor: Corridor,
}

impl Track {
    fn new(graph: &Graph, ends: [Place; 2], is_refined: bool) -> Self {
        let [from, to] = ends.map(|end| graph.places.at(end));
        Self {
            ends,
            corridor: Corridor::new(from, to, is_refined),
        }
    }

    /// Tells whether a chain that has come to the origin of `dart` may go on along it.
    fn permits(&self, graph: &Graph, dart: Dart) -> bool {
        let [p, q] = [graph.origin(dart), graph.dest(dart)].map(|end| graph.places.at(end));
        graph.edges()[dart.edge()].is_subsegment
            && self.corridor.goes_on(p, q)
            && self.corridor.is_near(p, q)
    }
}

/// Which steps are tried.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Steps {
    /// Those next to the direction of the segment, up to the first that is not permitted.
    Straight,
    /// Whatever is permitted.
    All,
}

struct Finder<'a> {
    graph: &'a Graph<'a>,
    is_refined: bool,
    chains: Chains,
    /// The darts of the chain at hand; with several ways, of all of them.
    tried: Vec<Dart>,
    /// The chain at hand.
    found: Vec<Dart>,
    ahead: Vec<Dart>,
    passed: Vec<bool>,
    /// From which places the end is known to be reached; nowhere but while ways are told from others.
    leads: Vec<bool>,
    /// For each place that was passed, the dart by which it was reached.
    arrived_by: Vec<Dart>,
    /// How many darts may still be tried just because they are there.
    patience: usize,
}

impl<'a> Finder<'a> {
    fn new(graph: &'a Graph<'a>, is_refined: bool) -> Self {
        let num_places = graph.places.len();
        Self {
            graph,
            is_refined,
            chains: Chains {
                starts: vec![0],
                darts: Vec::new(),
                bends: Bends::new(num_places),
                owners: vec![None; graph.edges().len()],
                broken: Vec::new(),
            },
            tried: Vec::new(),
            found: Vec::new(),
            ahead: Vec::new(),
            passed: vec![false; num_places],
            leads: vec![false; num_places],
            arrived_by: vec![Dart::rightward(0); num_places],
            patience: PATIENCE * (graph.num_darts() + num_places),
        }
    }

    /// Follows a claimed chain and returns where it ceases to be one, if it does.
    fn accept(
        &mut self,
        track: &Track,
        chain: &[VertexId],
        pace: &mut Pace,
    ) -> Result<Option<Place>, Error> {
        self.tried.clear();
        self.found.clear();
        let places = self.graph.places;
        let mut at = track.ends[0];
        let mut chain = chain.iter().map(|&v| places.get(v));
        if chain.next() != Some(Some(at)) {
            return Ok(Some(at));
        }
        for place in chain {
            pace.step()?;
            let dart = place.and_then(|place| self.graph.find(at, place));
            let Some(dart) = dart.filter(|&d| track.permits(self.graph, d)) else {
                return Ok(Some(at));
            };
            self.found.push(dart);
            at = self.graph.dest(dart);
        }
        self.tried.extend(&self.found);
        Ok((at != track.ends[1]).then_some(at))
    }

    /// Follows an edge of the hull, which has nothing to its right: at each place the first step from
    /// there is its own. Returns where there is none, if it does not come to its end.
    fn go_round(&mut self, track: &Track, pace: &mut Pace) -> Result<Option<Place>, Error> {
        let graph = self.graph;
        self.tried.clear();
        self.found.clear();
        let [mut at, to] = track.ends;
        while at != to {
            let mut first: Option<Dart> = None;
            for &dart in graph.star(at) {
                pace.step()?;
                // Steps that go on are less than half a turn apart.
                let is_before = |other: Dart| {
                    let [at, other, this] =
                        [at, graph.dest(other), graph.dest(dart)].map(|p| graph.places.at(p));
                    orient2d(at, other, this) == Orientation::Right
                };
                if first.is_none_or(is_before) && track.permits(graph, dart) {
                    first = Some(dart);
                }
            }
            let Some(first) = first else {
                return Ok(Some(at));
            };
            self.found.push(first);
            at = graph.dest(first);
        }
        self.tried.extend(&self.found);
        Ok(None)
    }

    /// Looks for the chain of a segment; if there is none, returns the place that was reached last.
    fn search(&mut self, track: &Track, pace: &mut Pace) -> Result<Option<Place>, Error> {
        let [from, to] = track.ends;
        self.tried.clear();
        self.found.clear();
        if from == to {
            return Ok(None);
        }
        let mut reached = self.walk(track, Steps::Straight, pace)?;
        if reached != to && self.patience > 0 {
            reached = self.walk(track, Steps::All, pace)?;
        }
        if reached != to {
            return Ok(Some(reached));
        }
        let mut at = to;
        while at != from {
            pace.step()?;
            let dart = self.arrived_by[at as usize];
            self.found.push(dart);
            at = self.graph.origin(dart);
        }
        self.found.reverse();
        Ok(None)
    }

    /// Looks for all ways of the segments whose chains nobody claims, if some subsegments are part of
    /// none yet.
    fn look_closer(
        &mut self,
        segments: &[[VertexId; 2]],
        claimed: Claim,
        pace: &mut Pace,
    ) -> Result<(), Error> {
        if self.chains.stray(self.graph).next().is_none() {
            return Ok(());
        }
        for (segment, ends) in segments.iter().enumerate() {
            pace.step()?;
            let ends = ends.map(|v| self.graph.places.of(v));
            let track = Track::new(self.graph, ends, self.is_refined);
            // What crosses nothing has no other ways.
            let has_ways = self.chains.of(segment).len() > 1 && claimed(segment).is_none();
            if has_ways && self.patience > 0 {
                self.walk(&track, Steps::All, pace)?;
                self.own(segment, &track);
            }
        }
        Ok(())
    }

    /// Goes all ways that `steps` permit, and forgets those that do not lead to the end; returns the end if
    /// one does, else the last place.
    fn walk(&mut self, track: &Track, steps: Steps, pace: &mut Pace) -> Result<Place, Error> {
        let [from, to] = track.ends;
        self.tried.clear();
        let mut reached = from;
        self.look_ahead(from, track, steps, pace)?;
        while let Some(dart) = self.ahead.pop() {
            pace.step()?;
            let at = self.graph.dest(dart);
            self.tried.push(dart);
            if self.passed[at as usize] {
                continue;
            }
            self.passed[at as usize] = true;
            self.arrived_by[at as usize] = dart;
            if reached != to {
                reached = at;
            }
            if at != to {
                self.look_ahead(at, track, steps, pace)?;
            }
        }
        for &dart in &self.tried {
            pace.step()?;
            self.passed[self.graph.dest(dart) as usize] = false;
        }
        self.forget_dead_ends(track);
        Ok(reached)
    }

    /// Forgets the steps that were tried and do not lead to the end.
    fn forget_dead_ends(&mut self, track: &Track) {
        let Self {
            graph,
            tried,
            leads,
            ..
        } = self;
        let follow = |steps: &[Dart]| graph.dest(steps[0]) == graph.origin(steps[1]);
        let ends = tried.last().map(|&dart| graph.dest(dart));
        if ends == Some(track.ends[1]) && tried.windows(2).all(follow) {
            return;
        }
        // All steps go on, so the farthest know first.
        tried.sort_by(|&d, &e| {
            let [d, e] = [d, e].map(|dart| graph.places.at(graph.origin(dart)));
            track.corridor.compare_ways(e, d)
        });
        leads[track.ends[1] as usize] = true;
        let passed = std::mem::take(tried);
        tried.extend(passed.iter().filter(|&&dart| {
            let does_lead = leads[graph.dest(dart) as usize];
            leads[graph.origin(dart) as usize] |= does_lead;
            does_lead
        }));
        for dart in passed {
            leads[graph.origin(dart) as usize] = false;
        }
        leads[track.ends[1] as usize] = false;
    }

    /// Puts the steps from a place upon the stack.
    fn look_ahead(
        &mut self,
        at: Place,
        track: &Track,
        steps: Steps,
        pace: &mut Pace,
    ) -> Result<(), Error> {
        if steps == Steps::Straight {
            self.look_straight(at, track);
            return Ok(());
        }
        let star = self.graph.star(at);
        self.patience = self.patience.saturating_sub(star.len());
        for &dart in star {
            pace.step()?;
            if track.permits(self.graph, dart) {
                self.ahead.push(dart);
            }
        }
        Ok(())
    }

    /// Puts the steps next to the direction of a segment upon the stack, the best one on top: all of
    /// them may be tried, but the first one that comes to a place decides about the chain.
    fn look_straight(&mut self, at: Place, track: &Track) {
        let graph = self.graph;
        let star = graph.star(at);
        let permitted = |dart: &&Dart| track.permits(graph, **dart);
        let is_on_line = |place: Place| track.corridor.is_on_line(graph.places.at(place));
        let turn = |dart: &Dart| graph.turn(at, graph.dest(*dart), track.ends[1]);
        let first = star.partition_point(|dart| turn(dart).is_lt());
        let straight = star.get(first).filter(|dart| turn(dart).is_eq());
        if let Some(&straight) = straight.filter(permitted)
            && is_on_line(at)
        {
            self.ahead.push(straight);
            return;
        }
        let (before, after) = star.split_at(first);
        let counter_clockwise = after.iter().chain(before);
        let clockwise = before.iter().rev().chain(after.iter().rev());
        let new = self.ahead.len();
        self.ahead.extend(counter_clockwise.take_while(permitted));
        self.ahead.extend(clockwise.take_while(permitted));
        self.ahead[new..].sort_by_key(|&dart| is_on_line(graph.dest(dart)));
    }

    /// Keeps what was found for a segment; one without length passes nothing.
    fn keep(&mut self, segment: usize, track: &Track) {
        self.own(segment, track);
        for &dart in &self.found {
            let place = self.graph.dest(dart);
            if !track.corridor.is_on_line(self.graph.places.at(place)) {
                self.chains.bends.bend(segment, place);
            }
        }
        self.chains.darts.extend(&self.found);
    }

    /// Notes that a segment passes, or may pass, where it was tried.
    fn own(&mut self, segment: usize, track: &Track) {
        let Chains { bends, owners, .. } = &mut self.chains;
        if !self.tried.is_empty() {
            bends.pass(self.graph, track.ends[0], track.ends, &track.corridor);
        }
        for &dart in &self.tried {
            owners[dart.edge()].get_or_insert(segment as u32);
            let place = self.graph.dest(dart);
            bends.pass(self.graph, place, track.ends, &track.corridor);
        }
    }
}
