//! What is to be visited: places, distances in whole numbers, and neighbours, numbered along the first
//! tour so that neighbours in the plane are neighbours in memory.

use crate::proximity::Proximity;
use crate::proximity::ruler::Ruler;
use crate::{HalfEdgeId, Point, VertexId};

/// Where a tour may begin and end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Closed,
    /// From site 0 to anywhere.
    From,
    /// From anywhere to anywhere.
    Free,
}

/// One unit of distance is so small a part of the extent.
const UNITS: f64 = (1_u64 << 58) as f64;

/// Less than any two distances together: who goes from site 0 to nowhere is never to change that.
const TIE: i64 = -(1 << 61);

/// The sites of a tour. Site i is the i-th of the first tour; if the tour is open, there is one more,
/// nowhere, which is next to both ends, and thus every tour is closed.
pub(super) struct Sites {
    names: Vec<VertexId>,
    points: Vec<Point>,
    ruler: Ruler,
    kind: Kind,
    /// Where in `neighbors` those of each site begin.
    starts: Vec<u32>,
    /// The neighbours in the triangulation, nearest first.
    neighbors: Vec<u32>,
}

impl Sites {
    /// `sorted` holds all edges, shortest first.
    pub fn new(
        proximity: &Proximity,
        names: Vec<VertexId>,
        sorted: &[HalfEdgeId],
        kind: Kind,
    ) -> Self {
        let points: Vec<Point> = names.iter().map(|&v| proximity.point(v)).collect();
        let mut site_of = vec![0; proximity.triangulation.points().len()];
        for (site, v) in (0..).zip(&names) {
            site_of[v.index()] = site;
        }
        let edges = || {
            let ends = sorted.iter().map(|&h| proximity.ends(h));
            ends.map(|ends| ends.map(|v| site_of[v.index()]))
        };
        let (starts, neighbors) = adjacency(names.len(), edges);
        Self {
            ruler: Ruler::new(points.iter().copied()),
            names,
            points,
            kind,
            starts,
            neighbors,
        }
    }

    /// Counts the sites, nowhere included.
    pub fn len(&self) -> usize {
        self.points.len() + usize::from(self.kind != Kind::Closed)
    }

    /// Counts the sites without nowhere.
    pub fn num_places(&self) -> usize {
        self.points.len()
    }

    /// Returns where a site lies relative to the first one, in units of distance, rounded.
    pub fn place(&self, site: u32) -> [f64; 2] {
        let vector = self
            .ruler
            .vector(self.points[0], self.points[site as usize]);
        vector.map(|c| c * UNITS)
    }

    /// Returns for each site how far its surroundings are: the mean distance of its two nearest neighbours
    /// in the triangulation.
    pub fn scales(&self) -> Vec<f64> {
        let scale = |site: u32| {
            let nearest = self.neighbors(site).iter().take(2);
            let sum: i64 = nearest.map(|&other| self.distance(site, other)).sum();
            sum as f64 / 2.0
        };
        (0..self.num_places() as u32).map(scale).collect()
    }

    /// Returns the vertex at a site; nowhere has none.
    pub fn name(&self, site: u32) -> Option<VertexId> {
        self.names.get(site as usize).copied()
    }

    pub fn kind(&self) -> Kind {
        self.kind
    }

    /// Returns the neighbours of a site, nearest first.
    #[inline]
    pub fn neighbors(&self, site: u32) -> &[u32] {
        let range = |i: usize| {
            self.starts
                .get(i)
                .map_or(self.neighbors.len(), |&s| s as usize)
        };
        let site = site as usize;
        &self.neighbors[range(site)..range(site + 1)]
    }

    /// Returns the distance of two sites: at most 2⁵⁹, so that a few of them may be added.
    #[inline]
    pub fn distance(&self, a: u32, b: u32) -> i64 {
        match (self.points.get(a as usize), self.points.get(b as usize)) {
            (Some(&p), Some(&q)) => (self.ruler.distance(p, q) * UNITS) as i64,
            _ if self.kind == Kind::From && (a == 0 || b == 0) => TIE,
            _ => 0,
        }
    }

    /// Sums up a tour from its first site to its last, and if it is closed, back.
    pub fn length(&self, order: &[u32]) -> i128 {
        let steps = order.windows(2).map(|w| self.distance(w[0], w[1]));
        let length: i128 = steps.map(i128::from).sum();
        match (order, self.kind) {
            ([first, .., last], Kind::Closed) => length + i128::from(self.distance(*last, *first)),
            _ => length,
        }
    }

    /// Turns a sum of distances into the units of the coordinates.
    pub fn restored(&self, length: i128) -> f64 {
        self.ruler.restored(length as f64 / UNITS)
    }

    /// Turns sites into vertices.
    pub fn named(&self, order: Vec<u32>) -> Vec<VertexId> {
        order
            .into_iter()
            .map(|site| self.names[site as usize])
            .collect()
    }
}

/// Lists for each of `n` sites the other ends of its edges, in the order of the edges, and where the
/// lists begin.
fn adjacency<E: Iterator<Item = [u32; 2]>>(
    n: usize,
    edges: impl Fn() -> E,
) -> (Vec<u32>, Vec<u32>) {
    let mut starts = vec![0_u32; n + 1];
    for [a, b] in edges() {
        starts[a as usize + 1] += 1;
        starts[b as usize + 1] += 1;
    }
    for i in 0..n {
        starts[i + 1] += starts[i];
    }
    let mut neighbors = vec![0; starts[n] as usize];
    let mut next = starts.clone();
    for [a, b] in edges() {
        for (from, to) in [(a, b), (b, a)] {
            neighbors[next[from as usize] as usize] = to;
            next[from as usize] += 1;
        }
    }
    (starts, neighbors)
}
