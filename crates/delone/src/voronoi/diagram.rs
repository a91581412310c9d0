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

use crate::pace::Pace;
use crate::predicates::{
    Weighted, bisector_place, compare_distances, compare_meetings, compare_power_meetings,
    compare_powers, power_place, towards,
};
use crate::{Error, HalfEdgeId, Mesh, Point, VertexId};
use std::cmp::Ordering;

/// Stands for the end of an edge at infinity, and for the dual vertex of a ghost.
pub(crate) const AT_INFINITY: u32 = u32::MAX;

/// How far sites are from points, and what follows from it. All but [`place`](Self::place) is exact.
pub(crate) trait Metric {
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
    /// Where the sides of each cell begin in `sides`, and their end.
    starts: Vec<u32>,
    /// Twice the edge, one more if it is reversed.
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
        pace: &mut Pace,
    ) -> Result<Self, Error> {
        let mut diagram = Self {
            vertices,
            starts: Vec::with_capacity(num_sites + 1),
            ..Self::default()
        };
        let side_of = diagram.add_edges(mesh, dual, pace)?;
        let outgoing = outgoing(mesh, num_sites);
        for start in outgoing {
            pace.step()?;
            diagram.starts.push(diagram.sides.len() as u32);
            let from = diagram.sides.len();
            let star = start.into_iter().flat_map(|h| mesh.star(h));
            let sides = star.map(|h| side_of[h.index()]);
            diagram.sides.extend(sides.filter(|&side| side != NO_SIDE));
            diagram.begin_at_infinity(from);
        }
        diagram.starts.push(diagram.sides.len() as u32);
        Ok(diagram)
    }

    /// Lists the edges, and for each half-edge of the mesh that has one its side at the origin.
    fn add_edges(&mut self, mesh: &Mesh, dual: &[u32], pace: &mut Pace) -> Result<Vec<u32>, Error> {
        let mut side_of = vec![NO_SIDE; 3 * mesh.num_faces()];
        for h in mesh.half_edges() {
            let twin = mesh.twin(h);
            let sites = [mesh.origin(h), mesh.dest(h)];
            if twin < h || sites.iter().any(|v| v.is_infinite()) {
                continue;
            }
            pace.step()?;
            // Turning counter-clockwise about the origin, the face to the left of `h` comes later.
            let ends = [twin, h].map(|h| dual[h.triangle().index()]);
            if ends[0] != ends[1] || ends[0] == AT_INFINITY {
                let side = 2 * self.edges.len() as u32;
                side_of[h.index()] = side;
                side_of[twin.index()] = side + 1;
                self.edges.push(DualEdge { sites, ends });
            }
        }
        Ok(side_of)
    }

    /// Turns the last cell, whose sides begin at `from`, until its first side begins at infinity, if
    /// one does.
    fn begin_at_infinity(&mut self, from: usize) {
        let sides = from..self.sides.len();
        let first = sides.clone().position(|i| {
            let [start, _] = self.ends(side(self.sides[i]));
            start == AT_INFINITY
        });
        self.sides[sides].rotate_left(first.unwrap_or(0));
    }

    /// Visits the sides of a cell, counter-clockwise; if one begins at infinity, such a one first.
    #[inline]
    pub fn sides(&self, site: VertexId) -> impl ExactSizeIterator<Item = Side> + Clone + '_ {
        let range = self.starts[site.index()] as usize..self.starts[site.index() + 1] as usize;
        self.sides[range].iter().map(|&number| side(number))
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

/// Marks half-edges of the mesh without an edge of the diagram.
const NO_SIDE: u32 = u32::MAX;

#[inline]
fn side(number: u32) -> Side {
    Side {
        edge: number >> 1,
        is_reversed: number & 1 == 1,
    }
}

/// Finds for each vertex a half-edge that begins there.
fn outgoing(mesh: &Mesh, num_sites: usize) -> Vec<Option<HalfEdgeId>> {
    let mut table = vec![None; num_sites];
    for h in mesh.half_edges() {
        let origin = mesh.origin(h);
        if !origin.is_infinite() {
            table[origin.index()] = Some(h);
        }
    }
    table
}
