//! Each segment is a chain of subsegments.
//!
//! From the first end of a segment, a step leads along a subsegment that [goes on](Corridor::goes_on)
//! to a place that is [near](Corridor::is_near). If the place is on the segment and a subsegment
//! runs along it, that is the only step: pieces on one line are cut alike. Else, with a bend in
//! sight, the steps that differ least in direction are tried first, and all others only if those
//! lead nowhere. Steps never turn back, and no place is passed twice.
//!
//! Where rounding has left several ways, the chain that is found need not be the one that was meant:
//! whoever knows the chains should [say so](super::DomainMesh::with_chains).
//!
//! *Cost*: O(log d) for a step from a place with d subsegments; O(d) where a bend is far from the
//! direction of its segment, or a segment has no chain.

use super::super::pace::Pace;
use super::bends::Bends;
use super::drift::Corridor;
use super::graph::{Dart, Graph};
use super::places::Place;
use crate::{Error, VertexId};

/// The chains that a builder claims: for each segment its vertices.
pub(super) type Claimed<'a> = &'a dyn Fn(usize) -> &'a [VertexId];

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
    /// Finds the chain of every segment, or follows those that are claimed.
    pub fn find(
        graph: &Graph,
        segments: &[[VertexId; 2]],
        claimed: Option<Claimed>,
        pace: &mut Pace,
    ) -> Result<Self, Error> {
        let mut finder = Finder::new(graph);
        for (index, ends) in segments.iter().enumerate() {
            pace.step()?;
            let ends = ends.map(|v| graph.places.of(v));
            let track = Track::new(graph, ends);
            let broken = match claimed {
                Some(claimed) => finder.accept(&track, claimed(index), pace)?,
                None => finder.search(&track, pace)?,
            };
            match broken {
                Some(place) => finder.chains.broken.push((index, place)),
                None => finder.keep(index, &track),
            }
            finder.chains.starts.push(finder.chains.darts.len());
        }
        Ok(finder.chains)
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
    fn new(graph: &Graph, ends: [Place; 2]) -> Self {
        let [from, to] = ends.map(|end| graph.places.at(end));
        Self {
            ends,
            corridor: Corridor::new(from, to),
        }
    }

    /// Tells whether a chain that has come to the origin of `dart` may go on along it.
    fn permits(&self, graph: &Graph, dart: Dart) -> bool {
        let [p, q] = [graph.origin(dart), graph.dest(dart)].map(|end| graph.places.at(end));
        graph.edges()[dart.edge()].is_subsegment
            && self.corridor.goes_on(p, q)
            && self.corridor.is_near(q)
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
    chains: Chains,
    /// The darts of the chain at hand; with several ways, of all of them.
    tried: Vec<Dart>,
    /// The chain at hand.
    found: Vec<Dart>,
    ahead: Vec<Dart>,
    passed: Vec<bool>,
    /// For each place that was passed, the dart by which it was reached.
    arrived_by: Vec<Dart>,
}

impl<'a> Finder<'a> {
    fn new(graph: &'a Graph<'a>) -> Self {
        let num_places = graph.places.len();
        Self {
            graph,
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
            arrived_by: vec![Dart::rightward(0); num_places],
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

    /// Looks for the chain of a segment; if there is none, returns the place that was reached last.
    fn search(&mut self, track: &Track, pace: &mut Pace) -> Result<Option<Place>, Error> {
        let [from, to] = track.ends;
        self.tried.clear();
        self.found.clear();
        if from == to {
            return Ok(None);
        }
        let mut reached = self.walk(track, Steps::Straight, pace)?;
        if reached != to {
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

    /// Goes all ways that `steps` permit; returns the end if one leads there, else the last place.
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
        Ok(reached)
    }

    /// Puts the steps from a place upon the stack, the best one on top.
    fn look_ahead(
        &mut self,
        at: Place,
        track: &Track,
        steps: Steps,
        pace: &mut Pace,
    ) -> Result<(), Error> {
        let graph = self.graph;
        let star = graph.star(at);
        let to = track.ends[1];
        let turn = |dart: &Dart| graph.turn(at, graph.dest(*dart), to);
        let ahead = star.partition_point(|dart| turn(dart).is_lt());
        let permitted = |dart: &&Dart| track.permits(graph, **dart);
        let straight = star.get(ahead).filter(|dart| turn(dart).is_eq());
        if let Some(&straight) = straight.filter(permitted)
            && track.corridor.is_on_line(graph.places.at(at))
        {
            self.ahead.push(straight);
            return Ok(());
        }
        if steps == Steps::All {
            for dart in star {
                pace.step()?;
                self.ahead.extend(Some(*dart).filter(|d| permitted(&d)));
            }
            return Ok(());
        }
        let counter_clockwise = star[ahead..].iter().chain(&star[..ahead]);
        let clockwise = star[..ahead].iter().rev().chain(star[ahead..].iter().rev());
        let first = self.ahead.len();
        self.ahead.extend(counter_clockwise.take_while(permitted));
        self.ahead.extend(clockwise.take_while(permitted));
        let is_on_line = |d: &Dart| track.corridor.is_on_line(graph.places.at(graph.dest(*d)));
        self.ahead[first..].sort_by_key(is_on_line);
        Ok(())
    }

    /// Keeps what was found for a segment; one without length passes nothing.
    fn keep(&mut self, segment: usize, track: &Track) {
        let Chains { bends, owners, .. } = &mut self.chains;
        if !self.tried.is_empty() {
            bends.pass(self.graph, track.ends[0], track.ends, &track.corridor);
        }
        for &dart in &self.tried {
            owners[dart.edge()].get_or_insert(segment as u32);
            let place = self.graph.dest(dart);
            bends.pass(self.graph, place, track.ends, &track.corridor);
        }
        for &dart in &self.found {
            let place = self.graph.dest(dart);
            if !track.corridor.is_on_line(self.graph.places.at(place)) {
                bends.bend(segment, place);
            }
        }
        self.chains.darts.extend(&self.found);
    }
}
