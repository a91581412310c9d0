//! Putting a diagram together: its edges from those of the mesh, then the sides of each cell from the star
//! of its site. Both are done in ranges, on several threads, and joined in order; so numbers are those that
//! one thread gives.

use super::diagram::{AT_INFINITY, DualEdge, side};
use crate::pace::{Pace, Strides};
use crate::parallel::{Workers, joined};
use crate::{Error, HalfEdgeId, Mesh, TriangleId};
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
            edges: Vec::with_capacity(3 * faces.len() / 2),
            of_half_edge: Vec::with_capacity(3 * faces.len()),
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

    /// Lists the sides of some cells, given for each a half-edge that begins at its site.
    pub fn around(
        &self,
        mesh: &Mesh,
        outgoing: &[Option<HalfEdgeId>],
        mut strides: Strides,
    ) -> Result<Sides, Error> {
        let mut list = Sides {
            starts: Vec::with_capacity(outgoing.len() + 1),
            sides: Vec::with_capacity(6 * outgoing.len()),
        };
        for start in outgoing {
            strides.step()?;
            let from = list.sides.len();
            list.starts.push(from as u32);
            let star = start.iter().flat_map(|&h| mesh.star(h));
            let sides = star.filter_map(|h| self.side(mesh, h));
            list.sides.extend(sides);
            self.begin_at_infinity(&mut list.sides[from..]);
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

/// The sides of several cells, and where those of each begin.
pub(super) struct Sides {
    starts: Vec<u32>,
    sides: Vec<u32>,
}

impl Sides {
    /// Puts lists together, and adds where the last one ends.
    pub fn joined(lists: Vec<Self>) -> (Vec<u32>, Vec<u32>) {
        let (mut all_starts, mut all_sides) = (Vec::new(), Vec::new());
        let mut before = 0;
        for mut list in lists {
            list.starts.iter_mut().for_each(|start| *start += before);
            before += list.sides.len() as u32;
            all_starts.push(list.starts);
            all_sides.push(list.sides);
        }
        let mut starts = joined(all_starts);
        starts.push(before);
        (starts, joined(all_sides))
    }
}

/// Finds for each vertex a half-edge that begins there.
pub(super) fn outgoing(mesh: &Mesh, num_sites: usize) -> Vec<Option<HalfEdgeId>> {
    let mut table = vec![None; num_sites];
    for h in mesh.half_edges() {
        let origin = mesh.origin(h);
        if !origin.is_infinite() {
            table[origin.index()] = Some(h);
        }
    }
    table
}
