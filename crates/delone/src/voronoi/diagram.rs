//! The diagram as a structure: vertices, edges, and for each site the edges around its cell.
//!
//! ```text
//!          · to            An edge runs so that the site that is named first lies to its left.
//!     left | right         Around a cell come the edges counter-clockwise; behind one that ends at
//!          · from          infinity comes one that begins there.
//! ```
//!
//! It is made from a mesh and the dual vertex of each of its faces, and does not ask what distance is:
//! circumcenters of a Delaunay triangulation make a Voronoi diagram, power centers of a regular one a
//! power diagram. What depends on that is a [`Metric`].

use super::assembly::{Edges, Sides, Visits};
use crate::pace::Pace;
use crate::parallel::Workers;
use crate::predicates::{
    Weighted, bisector_place, compare_distances, compare_meetings, compare_power_meetings,
    compare_powers, power_place, towards,
};
use crate::{Error, Mesh, Point, VertexId};
use std::cmp::Ordering;

/// Stands for the end of an edge at infinity, and for the dual vertex of a ghost.
pub(crate) const AT_INFINITY: u32 = u32::MAX;

/// How far sites are from points, and what follows from it. All but [`place`](Self::place) is exact.
pub(crate) trait Metric: Sync {
    /// Compares how far `p` is from two sites.
    fn compare(&self, p: Point, a: VertexId, b: VertexId) -> Ordering;

    /// Tells whether a way leads from one site towards another, so that the other one is nearer in the end.
    fn towards(&self, way: [Point; 2], a: VertexId, b: VertexId) -> Ordering;

    /// Compares where a way comes to be as near to `a` as to `site`, and where as near to `b`, both of
    /// which it leads towards.
    fn compare_meetings(
        &self,
        way: [Point; 2],
        site: VertexId,
        a: VertexId,
        b: VertexId,
    ) -> Ordering;

    /// Finds the point of a segment that is equally far from two sites, rounded.
    fn place(&self, way: [Point; 2], a: VertexId, b: VertexId) -> Point;
}

/// The distance itself.
pub(crate) struct Euclidean<'a>(pub &'a [Point]);

impl Metric for Euclidean<'_> {
    #[inline]
    fn compare(&self, p: Point, a: VertexId, b: VertexId) -> Ordering {
        compare_distances(p, self.0[a.index()], self.0[b.index()])
    }

    #[inline]
    fn towards(&self, way: [Point; 2], a: VertexId, b: VertexId) -> Ordering {
        towards(way, [a, b].map(|v| self.0[v.index()]))
    }

    fn compare_meetings(
        &self,
        way: [Point; 2],
        site: VertexId,
        a: VertexId,
        b: VertexId,
    ) -> Ordering {
        let [site, a, b] = [site, a, b].map(|v| self.0[v.index()]);
        compare_meetings(way, site, a, b)
    }

    fn place(&self, way: [Point; 2], a: VertexId, b: VertexId) -> Point {
        bisector_place(way, self.0[a.index()], self.0[b.index()])
    }
}

/// The power of sites with weights.
pub(crate) struct Power<'a> {
    pub points: &'a [Point],
    pub weights: &'a [f64],
}

impl Power<'_> {
    #[inline]
    pub fn site(&self, v: VertexId) -> Weighted {
        Weighted {
            point: self.points[v.index()],
            weight: self.weights[v.index()],
        }
    }
}

impl Metric for Power<'_> {
    #[inline]
    fn compare(&self, p: Point, a: VertexId, b: VertexId) -> Ordering {
        compare_powers(p, self.site(a), self.site(b))
    }

    /// Weights move bisectors, but do not turn them.
    #[inline]
    fn towards(&self, way: [Point; 2], a: VertexId, b: VertexId) -> Ordering {
        Euclidean(self.points).towards(way, a, b)
    }

    fn compare_meetings(
        &self,
        way: [Point; 2],
        site: VertexId,
        a: VertexId,
        b: VertexId,
    ) -> Ordering {
        compare_power_meetings(way, self.site(site), self.site(a), self.site(b))
    }

    fn place(&self, way: [Point; 2], a: VertexId, b: VertexId) -> Point {
        power_place(way, self.site(a), self.site(b))
    }
}

/// An edge between the cells of two sites.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct DualEdge {
    /// The sites to the left and to the right of it.
    pub sites: [VertexId; 2],
    /// The vertices where it begins and ends, or [`AT_INFINITY`].
    pub ends: [u32; 2],
}

/// An edge as a side of a cell, counter-clockwise around its site.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Side {
    pub edge: u32,
    /// Whether the site lies to the right of the edge, which is then run through backwards.
    pub is_reversed: bool,
}

/// Cells, each the part of the plane of one site.
#[derive(Clone, Debug, Default)]
pub(crate) struct Diagram {
    pub vertices: Vec<Point>,
    pub edges: Vec<DualEdge>,
    /// All sites, so that those near each other in the list are most often near each other in the plane.
    pub order: Vec<VertexId>,
    /// Where the sides of each cell begin in `sides`, and where they end.
    ranges: Vec<[u32; 2]>,
    /// Twice the edge, one more if it is reversed; cell by cell in the `order`.
    sides: Vec<u32>,
}

impl Diagram {
    /// Puts cells together: `dual` names for each face of the mesh its dual vertex, [`AT_INFINITY`] for
    /// ghosts. Where both faces beside an edge of the mesh have the same, there is no dual edge.
    pub fn new(
        mesh: &Mesh,
        num_sites: usize,
        vertices: Vec<Point>,
        dual: &[u32],
        workers: Workers,
        pace: &Pace,
    ) -> Result<Self, Error> {
        let (edges, visits) = workers.join(
            || Edges::of(mesh, dual, workers, pace),
            || Visits::of(mesh, num_sites),
        );
        let edges = edges?;
        let lists = workers.ranges(num_sites, |ranks| {
            edges.around(mesh, &visits, ranks, pace.strides())
        })?;
        let (ranges, sides) = Sides::joined(lists, &visits.order);
        Ok(Self {
            vertices,
            edges: edges.edges,
            order: visits.order,
            ranges,
            sides,
        })
    }

    /// Visits the sides of a cell, counter-clockwise; if one begins at infinity, such a one first.
    #[inline]
    pub fn sides(&self, site: VertexId) -> impl ExactSizeIterator<Item = Side> + Clone + '_ {
        let [start, end] = self.ranges[site.index()];
        self.sides[start as usize..end as usize]
            .iter()
            .map(|&number| side(number))
    }

    /// Returns where a side begins and ends, as seen from its cell.
    #[inline]
    pub fn ends(&self, side: Side) -> [u32; 2] {
        let [from, to] = self.edges[side.edge as usize].ends;
        if side.is_reversed {
            [to, from]
        } else {
            [from, to]
        }
    }

    /// Returns the site beyond a side.
    #[inline]
    pub fn beyond(&self, side: Side) -> VertexId {
        let [left, right] = self.edges[side.edge as usize].sites;
        if side.is_reversed { left } else { right }
    }
}

#[inline]
pub(super) fn side(number: u32) -> Side {
    Side {
        edge: number >> 1,
        is_reversed: number & 1 == 1,
    }
}
