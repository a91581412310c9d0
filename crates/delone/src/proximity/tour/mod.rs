//! A short tour through all vertices: the travelling salesman's problem, not solved but bounded.
//!
//! 1. *Start* (`start.rs`): once around the minimum spanning tree, each vertex when it comes for the first
//!    time. At most twice as long as the tree, hence as the best tour (Rosenkrantz, Stearns and Lewis, *An
//!    analysis of several heuristics for the traveling salesman problem*, 1977).
//! 2. *Improve* (`improve.rs`): 2-opt (Croes 1958) and or-opt (Or 1976) moves that join a vertex to a
//!    neighbour in the triangulation, a queue of vertices to look at (Bentley, *Fast algorithms for
//!    geometric traveling salesman problems*, 1992), until none is left; then kicks, each undone unless
//!    moves make something better of it; or until the budget is spent.
//! 3. *Bound* (`bound.rs`), if asked for: no tour is shorter.
//!
//! *Rounded.* Distances are whole multiples of 2⁻⁵⁸ of the extent; every move makes the sum of these
//! integers smaller, so the work ends, and the result is the same on every machine. Vertices closer than
//! that cost nothing.
//!
//! *Cost*: start O(n log n). A move reverses a part of the tour, at most 50,000 vertices, so tours of
//! millions take longer a vertex than those of thousands. The bound takes 30 spanning trees and a search.

mod bound;
mod cycle;
mod improve;
mod limits;
mod sites;
mod spanning;
mod start;

use super::Proximity;
use crate::clock::Clock;
use crate::{Error, VertexId};
use improve::Improvement;
use limits::Limits;
use sites::Sites;
use std::time::Duration;

/// How to plan a tour.
///
/// ```
/// use delone::proximity::{Proximity, Tour};
/// let corners = [(0.0, 0.0), (2.0, 1.0), (2.0, 0.0), (0.0, 1.0), (1.0, 0.0), (1.0, 1.0)];
/// let t = delone::triangulate(corners)?;
/// let (proximity, tour) = (Proximity::new(&t, &())?, Tour::new().start(1));
/// let route = tour.plan(&proximity)?;
/// assert_eq!(route.order, [1, 2, 4, 0, 3, 5].map(Into::into));
/// assert_eq!(route.length, 6.0);
/// assert_eq!(route.ratio(tour.lower_bound(&proximity)?), 1.0); // there is no shorter one
/// # Ok::<(), delone::Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default)]
pub struct Tour {
    is_open: bool,
    start: Option<VertexId>,
    moves: Option<u64>,
    kicks: Option<u64>,
    time: Option<Duration>,
}

/// A tour.
#[derive(Clone, Debug, PartialEq)]
pub struct Route {
    /// The vertices as they are visited, each once; a closed tour returns to the first one.
    pub order: Vec<VertexId>,
    /// The length, rounded.
    pub length: f64,
    /// How many moves were made, undone ones included.
    pub moves: u64,
    /// Whether all was tried, rather than the budget spent.
    pub is_settled: bool,
}

impl Route {
    /// Returns length by [lower bound](Tour::lower_bound), 1 if both are zero: the tour is at most so many
    /// times as long as the shortest.
    pub fn ratio(&self, lower_bound: f64) -> f64 {
        if self.length == lower_bound {
            1.0
        } else {
            self.length / lower_bound
        }
    }
}

impl Tour {
    /// Plans a closed tour from the first vertex, until no move makes it shorter.
    pub fn new() -> Self {
        Self::default()
    }

    /// Does not return to the start; without a [start](Self::start) both ends are free.
    pub fn open(self) -> Self {
        Self {
            is_open: true,
            ..self
        }
    }

    /// Starts at this vertex.
    pub fn start(self, v: impl Into<VertexId>) -> Self {
        Self {
            start: Some(v.into()),
            ..self
        }
    }

    /// Stops after so many moves. 0 leaves the tour around the spanning tree.
    pub fn moves(self, moves: u64) -> Self {
        Self {
            moves: Some(moves),
            ..self
        }
    }

    /// Tries so many kicks, each at another place, when no move is left: small changes that are undone
    /// unless moves make something better of them. As many as there are vertices by default, and ten times
    /// as many make it better still.
    pub fn kicks(self, kicks: u64) -> Self {
        Self {
            kicks: Some(kicks),
            ..self
        }
    }

    /// Stops moving after this time, if the standard library knows a clock. The tour then depends on the speed of
    /// the machine.
    pub fn time(self, time: Duration) -> Self {
        Self {
            time: Some(time),
            ..self
        }
    }

    /// Plans a tour through all vertices; of equal points the first is visited.
    ///
    /// # Errors
    /// [`Error::NoSuchVertex`] if the start does not exist; [`Error::Cancelled`].
    pub fn plan(self, proximity: &Proximity) -> Result<Route, Error> {
        let clock = Clock::start();
        let Some(sites) = self.sites(proximity)? else {
            return Ok(Route {
                order: Vec::new(),
                length: 0.0,
                moves: 0,
                is_settled: true,
            });
        };
        let mut improvement = Improvement::new(&sites);
        let kicks = self.kicks.unwrap_or(sites.len() as u64);
        let work = 4 * (sites.len() as u64).saturating_add(kicks.saturating_mul(4));
        let mut limits = Limits::new(self.moves, self.time, clock, work, proximity.watch);
        let is_settled = improvement.run(&mut limits, kicks)?;
        let moves = improvement.moves;
        let order = improvement.into_order();
        let length = sites.length(&order);
        Ok(Route {
            length: sites.restored(length),
            order: sites.named(order),
            moves,
            is_settled,
        })
    }

    /// Finds a length that no tour of this kind, with this start, falls short of, up to rounding. Budgets do
    /// not matter.
    ///
    /// # Errors
    /// Those of [`plan`](Self::plan).
    ///
    /// *Cost*: 30 spanning trees and a search, about as long as planning.
    pub fn lower_bound(self, proximity: &Proximity) -> Result<f64, Error> {
        let Some(sites) = self.sites(proximity)? else {
            return Ok(0.0);
        };
        let bound = match improve::shortest(&sites) {
            Some(best) => sites.length(&best),
            None => bound::lower_bound(&sites, proximity.watch)?,
        };
        Ok(sites.restored(bound))
    }

    /// Takes the first tour, around the spanning tree; `None` if there is no vertex.
    fn sites(self, proximity: &Proximity) -> Result<Option<Sites>, Error> {
        let Some(start) = self.start_in(proximity)? else {
            return Ok(None);
        };
        let sorted = proximity.sorted_edges()?;
        let tree = proximity.tree_of(&sorted)?;
        let order = start::around(proximity, &tree, start)?;
        Ok(Some(Sites::new(proximity, order, &sorted, self.kind())))
    }

    /// The vertex to begin with; `None` if there is no vertex.
    fn start_in(self, proximity: &Proximity) -> Result<Option<VertexId>, Error> {
        let t = &proximity.triangulation;
        let points = t.points().len();
        match self.start {
            Some(vertex) if vertex.index() >= points => Err(Error::NoSuchVertex { vertex, points }),
            Some(vertex) => Ok(Some(t.representative(vertex))),
            // The first point is nobody's duplicate.
            None => Ok((points > 0).then(|| VertexId::new(0))),
        }
    }

    fn kind(self) -> sites::Kind {
        match (self.is_open, self.start) {
            (false, _) => sites::Kind::Closed,
            (true, Some(_)) => sites::Kind::From,
            (true, None) => sites::Kind::Free,
        }
    }
}
