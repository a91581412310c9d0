//! The planar graph of subsegments and hull edges: darts, stars and the cycles around faces.

use super::super::Corner;
use super::places::{Place, Places};
use super::sort::sort;
use crate::Error;
use crate::pace::Pace;
use crate::predicates::{Orientation, orient2d};
use std::cmp::Ordering;

/// An edge of the graph, run through in one direction: `2e` from left to right, `2e + 1` back.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Dart(u32);

impl Dart {
    /// The dart of `edge` that goes from left to right, so that its left side is above the edge.
    pub fn rightward(edge: usize) -> Self {
        Self(2 * edge as u32)
    }

    pub fn edge(self) -> usize {
        self.0 as usize / 2
    }

    pub fn index(self) -> usize {
        self.0 as usize
    }

    pub fn twin(self) -> Self {
        Self(self.0 ^ 1)
    }

    fn is_rightward(self) -> bool {
        self.0.is_multiple_of(2)
    }
}

/// An edge: its places, the left one first, and whether it is a subsegment or only closes the hull.
#[derive(Clone, Copy, Debug)]
pub(super) struct Edge {
    pub ends: [Place; 2],
    pub is_subsegment: bool,
}

/// Edges, and for each place the darts that leave it.
pub(super) struct Graph<'a> {
    pub places: &'a Places<'a>,
    /// Sorted by their ends.
    edges: Vec<Edge>,
    /// Where the star of each place begins, and where the last one ends.
    starts: Vec<u32>,
    /// Counter-clockwise from straight down: first the darts to the right, then those to the left.
    star: Vec<Dart>,
}

impl<'a> Graph<'a> {
    /// Arranges distinct edges, sorted by their ends.
    pub fn new(places: &'a Places<'a>, edges: Vec<Edge>, pace: &mut Pace) -> Result<Self, Error> {
        let mut graph = Self {
            places,
            starts: vec![0; places.len() + 1],
            star: vec![Dart(0); 2 * edges.len()],
            edges,
        };
        graph.distribute(pace)?;
        graph.sort_stars(pace)?;
        Ok(graph)
    }

    /// Puts every dart into the star of its origin.
    fn distribute(&mut self, pace: &mut Pace) -> Result<(), Error> {
        for edge in &self.edges {
            pace.step()?;
            for end in edge.ends {
                self.starts[end as usize + 1] += 1;
            }
        }
        for place in 1..self.starts.len() {
            self.starts[place] += self.starts[place - 1];
        }
        let mut next = self.starts.clone();
        for dart in self.darts() {
            pace.step()?;
            let slot = &mut next[self.origin(dart) as usize];
            self.star[*slot as usize] = dart;
            *slot += 1;
        }
        Ok(())
    }

    fn sort_stars(&mut self, pace: &mut Pace) -> Result<(), Error> {
        for place in self.places.all() {
            pace.step()?;
            let mut star = self.star(place).to_vec();
            sort(&mut star, pace, |&d, &e| {
                self.turn(place, self.dest(d), self.dest(e))
            })?;
            let first = self.starts[place as usize] as usize;
            self.star[first..first + star.len()].copy_from_slice(&star);
        }
        Ok(())
    }

    /// Compares two directions from `origin`, counter-clockwise from straight down.
    pub fn turn(&self, origin: Place, d: Place, e: Place) -> Ordering {
        (d < origin).cmp(&(e < origin)).then_with(|| {
            let [origin, d, e] = [origin, d, e].map(|p| self.places.at(p));
            match orient2d(origin, d, e) {
                Orientation::Left => Ordering::Less,
                Orientation::Right => Ordering::Greater,
                Orientation::Collinear => Ordering::Equal,
            }
        })
    }

    pub fn edges(&self) -> &[Edge] {
        &self.edges
    }

    pub fn num_darts(&self) -> usize {
        2 * self.edges.len()
    }

    pub fn darts(&self) -> impl Iterator<Item = Dart> + use<> {
        (0..self.num_darts() as u32).map(Dart)
    }

    pub fn origin(&self, dart: Dart) -> Place {
        self.edges[dart.edge()].ends[usize::from(!dart.is_rightward())]
    }

    pub fn dest(&self, dart: Dart) -> Place {
        self.origin(dart.twin())
    }

    /// Returns the ends of a dart as a defect names them.
    pub fn corners(&self, dart: Dart) -> [Corner; 2] {
        [self.origin(dart), self.dest(dart)].map(|end| self.places.corner(end))
    }

    /// Returns the darts that leave a place, counter-clockwise.
    pub fn star(&self, place: Place) -> &[Dart] {
        let [first, end] = [0, 1].map(|i| self.starts[place as usize + i] as usize);
        &self.star[first..end]
    }

    /// Returns the darts that leave a place to the right, and those that leave it to the left.
    pub fn halves(&self, place: Place) -> (&[Dart], &[Dart]) {
        let star = self.star(place);
        star.split_at(star.partition_point(|d| d.is_rightward()))
    }

    /// Returns the dart from one place to another.
    pub fn find(&self, origin: Place, dest: Place) -> Option<Dart> {
        let ends = [origin.min(dest), origin.max(dest)];
        let edge = self.edges.binary_search_by_key(&ends, |e| e.ends).ok()?;
        let dart = Dart::rightward(edge);
        Some(if origin < dest { dart } else { dart.twin() })
    }

    /// Numbers the cycles of darts that have one face to their left.
    ///
    /// Returns the cycle of every dart and the number of cycles.
    pub fn cycles(&self, pace: &mut Pace) -> Result<(Vec<u32>, usize), Error> {
        const NONE: u32 = u32::MAX;
        let next = self.successors(pace)?;
        let mut cycle_of = vec![NONE; self.num_darts()];
        let mut cycles = 0;
        for first in self.darts() {
            pace.step()?;
            if cycle_of[first.index()] != NONE {
                continue;
            }
            let mut dart = first;
            while cycle_of[dart.index()] == NONE {
                pace.step()?;
                cycle_of[dart.index()] = cycles;
                dart = next[dart.index()];
            }
            cycles += 1;
        }
        Ok((cycle_of, cycles as usize))
    }

    /// Finds for every dart the one that follows it around the face to its left: at its end, the one
    /// clockwise of its twin.
    fn successors(&self, pace: &mut Pace) -> Result<Vec<Dart>, Error> {
        let mut next = vec![Dart(0); self.num_darts()];
        for place in self.places.all() {
            let star = self.star(place);
            for (i, &dart) in star.iter().enumerate() {
                pace.step()?;
                let clockwise = if i == 0 { star.len() } else { i } - 1;
                next[dart.twin().index()] = star[clockwise];
            }
        }
        Ok(next)
    }
}
