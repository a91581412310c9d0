//! Putting a diagram together: its edges from those of the mesh, then the sides of each cell from the star
//! of its site. Both are done in ranges, on several threads, and joined in order; so numbers are those that
//! one thread gives.
//!
//! Sites come in the order in which the mesh names them, not in that of their numbers: the mesh runs along a
//! curve, so the star of a site lies near that of the one before, and what is made of it does, too.

use super::diagram::{AT_INFINITY, DualEdge, side};
use crate::memory::reserve;
use crate::pace::{Pace, Strides};
use crate::parallel::{Workers, joined};
use crate::{Error, HalfEdgeId, Mesh, TriangleId, VertexId};
use std::ops::Range;

/// Marks half-edges of the mesh without an edge of the diagram.
const NO_EDGE: u32 = u32::MAX;

/// The edges, and for each half-edge of the mesh that precedes its twin its own.
pub(super) struct Edges {
    pub edges: Vec<DualEdge>,
    of_half_edge: Vec<u32>,
}

impl Edges {
    /// Lists the edges in the order of the half-edges.
    pub fn of(mesh: &Mesh, dual: &[u32], workers: Workers, pace: &Pace) -> Result<Self, Error> {
        let lists = workers.ranges(mesh.num_faces(), |faces| {
            Self::of_faces(mesh, dual, faces, pace.strides())
        })?;
        let (mut edges, mut numbers) = (Vec::new(), Vec::new());
        let mut before = 0;
        for mut list in lists {
            let belated = list.of_half_edge.iter_mut().filter(|e| **e != NO_EDGE);
            belated.for_each(|edge| *edge += before);
            before += list.edges.len() as u32;
            edges.push(list.edges);
            numbers.push(list.of_half_edge);
        }
        Ok(Self {
            edges: joined(edges),
            of_half_edge: joined(numbers),
        })
    }

    /// Lists those of some faces, numbered from 0.
    fn of_faces(
        mesh: &Mesh,
        dual: &[u32],
        faces: Range<usize>,
        mut strides: Strides,
    ) -> Result<Self, Error> {
        let mut list = Self {
            edges: reserve(3 * faces.len() / 2),
            of_half_edge: reserve(3 * faces.len()),
        };
        for t in faces.map(TriangleId::new) {
            strides.step()?;
            for h in t.half_edges() {
                let edge = edge_of(mesh, dual, h);
                list.of_half_edge.push(match edge {
                    Some(_) => list.edges.len() as u32,
                    None => NO_EDGE,
                });
                list.edges.extend(edge);
            }
        }
        Ok(list)
    }

    /// Lists the sides of the cells of some sites.
    pub fn around(
        &self,
        mesh: &Mesh,
        visits: &Visits,
        ranks: Range<usize>,
        mut strides: Strides,
    ) -> Result<Sides, Error> {
        let mut list = Sides {
            ends: Vec::with_capacity(ranks.len()),
            sides: reserve(6 * ranks.len()),
        };
        for rank in ranks {
            strides.step()?;
            let from = list.sides.len();
            let star = visits.first(rank).into_iter().flat_map(|h| mesh.star(h));
            let mut is_whole = true;
            list.sides.extend(star.filter_map(|h| {
                let side = self.side(mesh, h);
                is_whole &= side.is_some();
                side
            }));
            // Beside infinity there is a half-edge without an edge.
            if !is_whole {
                self.begin_at_infinity(&mut list.sides[from..]);
            }
            list.ends.push(list.sides.len() as u32);
        }
        Ok(list)
    }

    /// Returns the side that a half-edge has at its origin.
    #[inline]
    fn side(&self, mesh: &Mesh, h: HalfEdgeId) -> Option<u32> {
        let twin = mesh.twin(h);
        let edge = self.of_half_edge[h.min(twin).index()];
        (edge != NO_EDGE).then(|| 2 * edge + u32::from(twin < h))
    }

    /// Turns a cell until its first side begins at infinity, if one does.
    fn begin_at_infinity(&self, sides: &mut [u32]) {
        let begins_there = |&number: &u32| {
            let side = side(number);
            let end = usize::from(side.is_reversed);
            self.edges[side.edge as usize].ends[end] == AT_INFINITY
        };
        let first = sides.iter().position(begins_there);
        sides.rotate_left(first.unwrap_or(0));
    }
}

/// Makes the edge that crosses that of a half-edge, unless it has no length or belongs to the twin.
#[inline]
fn edge_of(mesh: &Mesh, dual: &[u32], h: HalfEdgeId) -> Option<DualEdge> {
    let twin = mesh.twin(h);
    let sites = [mesh.origin(h), mesh.dest(h)];
    if twin < h || sites.iter().any(|v| v.is_infinite()) {
        return None;
    }
    // Turning counter-clockwise about the origin, the face to the left of `h` comes later.
    let ends = [twin, h].map(|h| dual[h.triangle().index()]);
    (ends[0] != ends[1] || ends[0] == AT_INFINITY).then_some(DualEdge { sites, ends })
}

/// The sides of several cells, and where those of each end.
pub(super) struct Sides {
    ends: Vec<u32>,
    sides: Vec<u32>,
}

impl Sides {
    /// Puts lists together, and finds for each site where its sides begin and end.
    pub fn joined(lists: Vec<Self>, order: &[VertexId]) -> (Vec<[u32; 2]>, Vec<u32>) {
        let mut ranges = vec![[0; 2]; order.len()];
        let mut all = Vec::new();
        let mut sites = order.iter();
        let mut before = 0;
        for list in lists {
            let mut start = before;
            for (end, site) in list.ends.into_iter().zip(&mut sites) {
                ranges[site.index()] = [start, before + end];
                start = before + end;
            }
            before += list.sides.len() as u32;
            all.push(list.sides);
        }
        (ranges, joined(all))
    }
}

/// The sites in the order in which their cells are made.
pub(super) struct Visits {
    /// First those in the mesh, then the others.
    pub order: Vec<VertexId>,
    /// For each site in the mesh a half-edge that begins there, in that order.
    first: Vec<HalfEdgeId>,
}

impl Visits {
    /// Takes sites as the mesh names them, from its end to its beginning.
    pub fn of(mesh: &Mesh, num_sites: usize) -> Self {
        let mut visits = Self {
            order: Vec::with_capacity(num_sites),
            first: Vec::with_capacity(num_sites),
        };
        let mut is_seen = vec![false; num_sites];
        for h in (0..3 * mesh.num_faces()).rev().map(HalfEdgeId::new) {
            let origin = mesh.origin(h);
            if !origin.is_infinite() && !is_seen[origin.index()] {
                is_seen[origin.index()] = true;
                visits.order.push(origin);
                visits.first.push(h);
            }
        }
        let others = (0..num_sites).filter(|&site| !is_seen[site]);
        visits.order.extend(others.map(VertexId::new));
        visits
    }

    /// Returns a half-edge that begins at the site of a rank.
    fn first(&self, rank: usize) -> Option<HalfEdgeId> {
        self.first.get(rank).copied()
    }
}
