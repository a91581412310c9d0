//! The sweep: is the graph planar, and what lies below each part of it?
//!
//! A line sweeps over the places from left to right, tilted a little so that places with equal x
//! come one by one from below; edges under the line are kept in their order along it (Shamos and
//! Hoey 1976). Two edges are tested when they become neighbours, and the sweep ends at the first
//! defect.
//!
//! *Why that is enough.* Let q be the leftmost point (by x, then y) that two edges share though it
//! is no end of both, or that is a place inside an edge. Left of q the order is sound. If q is a
//! place, an edge that it lies inside is under the line and found when q is looked up. If not, the
//! edges through q are neighbours just before it, and were tested when they became so. Edges that
//! leave one place in one direction are neighbours in its star. So without a defect edges share only
//! ends, and the order has been sound throughout: the edge found below a place is the first one that
//! a ray straight down meets.
//!
//! *Cost*: O(log n) comparisons a dart or place.

use super::graph::{Dart, Graph};
use super::places::Place;
use crate::pace::Pace;
use crate::predicates::{Orientation, orient2d};
use crate::{Error, Point};
use std::cmp::Ordering;
use std::collections::BTreeSet;
use std::ops::Bound::{Excluded, Unbounded};

/// Where a seed lies in the graph.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Spot {
    /// Upon a place.
    On(Place),
    /// Inside an edge.
    Inside(usize),
    /// In the face above an edge, or below all.
    Above(Option<usize>),
}

/// What keeps a graph from being planar.
#[derive(Clone, Copy, Debug)]
pub(super) enum Conflict {
    /// Two edges cross, or overlap from a common end on.
    Edges([usize; 2]),
    /// A place lies inside an edge.
    Place(Place, usize),
}

/// What a sweep finds in a planar graph.
pub(super) struct Below {
    /// For each place the edge below it, or `None`; meaningful for places without darts to the left.
    pub places: Vec<Option<usize>>,
    /// For each seed where it lies.
    pub seeds: Vec<Spot>,
}

/// Sweeps over the graph and over seeds.
pub(super) fn sweep(
    graph: &Graph,
    seeds: &[Point],
    pace: &mut Pace,
) -> Result<Result<Below, Conflict>, Error> {
    let mut order: Vec<usize> = (0..seeds.len()).collect();
    super::sort::sort(&mut order, pace, |&i, &j| seeds[i].lex_cmp(&seeds[j]))?;
    let mut line = Line {
        graph,
        edges: BTreeSet::new(),
    };
    let mut below = Below {
        places: vec![None; graph.places.len()],
        seeds: vec![Spot::Above(None); seeds.len()],
    };
    let mut order = order.into_iter().peekable();
    for place in graph.places.all() {
        let at = graph.places.at(place);
        while let Some(seed) = order.next_if(|&i| seeds[i].lex_cmp(&at).is_le()) {
            pace.step()?;
            below.seeds[seed] = if seeds[seed] == at {
                Spot::On(place)
            } else {
                line.spot(seeds[seed])
            };
        }
        pace.step()?;
        match line.pass(place, pace)? {
            Ok(edge) => below.places[place as usize] = edge,
            Err(conflict) => return Ok(Err(conflict)),
        }
    }
    // Seeds to the right of everything keep lying above nothing.
    Ok(Ok(below))
}

/// The edges under the sweep line.
struct Line<'a> {
    graph: &'a Graph<'a>,
    edges: BTreeSet<Strand>,
}

impl Line<'_> {
    /// Moves over a place and returns the edge below it.
    fn pass(
        &mut self,
        place: Place,
        pace: &mut Pace,
    ) -> Result<Result<Option<usize>, Conflict>, Error> {
        let (right, left) = self.graph.halves(place);
        for &dart in left {
            pace.step()?;
            self.edges.remove(&self.strand(dart));
        }
        let probe = Strand::probe(self.graph.places.at(place));
        if let Some(strand) = self.edges.get(&probe) {
            return Ok(Err(Conflict::Place(place, strand.edge as usize)));
        }
        let [below, above] = self.neighbours(&probe);
        let strands: Vec<Strand> = right.iter().map(|&d| self.strand(d)).collect();
        let column = below.iter().chain(&strands).chain(&above);
        for (lower, upper) in column.clone().zip(column.skip(1)) {
            pace.step()?;
            if lower.overlaps(upper) || lower.crosses(upper) {
                let edges = [lower, upper].map(|s| s.edge as usize);
                return Ok(Err(Conflict::Edges(edges)));
            }
        }
        self.edges.extend(strands);
        Ok(Ok(below.map(|s| s.edge as usize)))
    }

    /// Finds where a point lies that is no place.
    fn spot(&self, at: Point) -> Spot {
        let probe = Strand::probe(at);
        match self.edges.get(&probe) {
            Some(strand) => Spot::Inside(strand.edge as usize),
            None => Spot::Above(self.neighbours(&probe)[0].map(|s| s.edge as usize)),
        }
    }

    /// Returns the edges below and above a point that lies on none.
    fn neighbours(&self, probe: &Strand) -> [Option<Strand>; 2] {
        let below = self.edges.range((Unbounded, Excluded(probe))).next_back();
        let above = self.edges.range((Excluded(probe), Unbounded)).next();
        [below, above].map(Option::<&Strand>::copied)
    }

    fn strand(&self, dart: Dart) -> Strand {
        let [left, right] = self.graph.edges()[dart.edge()].ends;
        Strand {
            left: self.graph.places.at(left),
            right: self.graph.places.at(right),
            edge: dart.edge() as u32,
        }
    }
}

/// An edge under the line, or a single point to be looked up among them, ordered from below.
#[derive(Clone, Copy, Debug)]
struct Strand {
    left: Point,
    right: Point,
    edge: u32,
}

impl Strand {
    fn probe(at: Point) -> Self {
        Self {
            left: at,
            right: at,
            edge: u32::MAX,
        }
    }

    fn side(&self, p: Point) -> Orientation {
        orient2d(self.left, self.right, p)
    }

    /// Tells whether both begin at one point and run in one direction.
    fn overlaps(&self, other: &Self) -> bool {
        self.left == other.left && self.side(other.right) == Orientation::Collinear
    }

    /// Tells whether a point inside both is common to them, and no more.
    fn crosses(&self, other: &Self) -> bool {
        let parts = |s: &Self, t: &Self| {
            let sides = [s.side(t.left), s.side(t.right)];
            !sides.contains(&Orientation::Collinear) && sides[0] != sides[1]
        };
        parts(self, other) && parts(other, self)
    }

    /// Compares with a strand that begins at the same place or later, while this one lasts.
    fn cmp_later(&self, later: &Self) -> Ordering {
        let side = match self.side(later.left) {
            Orientation::Collinear => self.side(later.right),
            side => side,
        };
        match side {
            Orientation::Left => Ordering::Less,
            Orientation::Right => Ordering::Greater,
            Orientation::Collinear => Ordering::Equal,
        }
    }
}

/// A total order for as long as strands under the line share only ends; a probe must lie right of
/// where they begin, and equals those that it lies on.
impl Ord for Strand {
    fn cmp(&self, other: &Self) -> Ordering {
        if self.edge == other.edge {
            Ordering::Equal
        } else if self.left.lex_cmp(&other.left).is_le() {
            self.cmp_later(other)
        } else {
            other.cmp_later(self).reverse()
        }
    }
}

impl PartialOrd for Strand {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Strand {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Strand {}
