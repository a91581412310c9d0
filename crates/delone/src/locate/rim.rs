//! What lies around a triangulation: the edges of the convex hull, and rows of collinear vertices. Both
//! are found by binary search, since both may be everything there is.

use super::Location;
use crate::predicates::{Orientation, orient2d};
use crate::{HalfEdgeId, Mesh, Point};

/// The edges of the convex hull, counter-clockwise from its lexicographically smallest vertex.
#[derive(Clone, Debug)]
pub(super) struct Rim {
    /// Finite half-edges of ghosts; each ends at the vertex where its edge begins, seen from inside.
    edges: Vec<HalfEdgeId>,
}

impl Rim {
    /// Collects the hull, given the finite half-edge of a ghost.
    pub fn new(mesh: &Mesh, points: &[Point], first: HalfEdgeId) -> Self {
        let mut edges: Vec<_> = mesh.hull(first).collect();
        let at = |i: usize| points[mesh.dest(edges[i]).index()];
        let smallest = (0..edges.len()).min_by(|&i, &j| at(i).lex_cmp(&at(j)));
        edges.rotate_left(smallest.unwrap_or(0));
        Self { edges }
    }

    /// Visits the vertices of the hull.
    pub fn vertices<'p>(
        &self,
        mesh: &Mesh,
        points: &'p [Point],
    ) -> impl Iterator<Item = &'p Point> {
        self.edges
            .iter()
            .map(move |&h| &points[mesh.dest(h).index()])
    }

    /// Returns the half-edge that sees `p`, which lies outside: the one where the segment from `p` to the
    /// first vertex enters the hull; if that is at a vertex, the first one there that sees `p`.
    ///
    /// ```text
    ///           4 ─── 3          The vertices after 0, which is a proper corner, are sorted by their
    ///         ╱       │          angles there, and at its first and last edge several may share one.
    ///        0        │  p       Those that have p on their left come first.
    ///         ╲       │
    ///           1 ─── 2
    /// ```
    ///
    /// *Cost*: O(log h) for h edges.
    pub fn towards(&self, mesh: &Mesh, points: &[Point], p: Point) -> HalfEdgeId {
        let at = |i: usize| points[mesh.dest(self.edges[i]).index()];
        let sees = |i: usize| {
            let [a, b] = [at(i), at((i + 1) % self.edges.len())];
            orient2d(a, b, p) == Orientation::Right
        };
        let last = self.edges.len() - 1;
        if let Some(i) = [0, last].into_iter().find(|&i| sees(i)) {
            return self.edges[i];
        }
        let side = |i: usize| orient2d(at(0), at(i), p);
        let left = count_while(last, |i| side(i) == Orientation::Left);
        let not_right = count_while(last, |i| side(i) != Orientation::Right);
        // Between vertices `left` and `left + 1`; or through the latter; or along the first edge and on.
        let candidates = if left == 0 {
            [not_right; 2]
        } else {
            [left, left + 1]
        };
        let seen = candidates.into_iter().find(|&i| sees(i));
        self.edges[seen.expect("bug: the point is not outside")]
    }
}

/// Counts how many of 1..=`last` come before the first that fails `holds`, all after it failing, too.
fn count_while(last: usize, holds: impl Fn(usize) -> bool) -> usize {
    let (mut low, mut high) = (0, last);
    while low < high {
        let middle = (low + high).div_ceil(2);
        if holds(middle) {
            low = middle;
        } else {
            high = middle - 1;
        }
    }
    low
}

/// The edges of a triangulation whose vertices all lie on one line, in lexicographic order.
#[derive(Clone, Debug)]
pub(super) struct Row {
    /// Half-edges from the smaller to the larger end.
    edges: Vec<HalfEdgeId>,
}

impl Row {
    /// Collects the row.
    pub fn new(mesh: &Mesh, points: &[Point]) -> Self {
        let ends = |h: HalfEdgeId| [mesh.origin(h), mesh.dest(h)].map(|v| points[v.index()]);
        let ghosts = mesh.ghosts().map(|t| mesh.hull_edge_of(t));
        let mut edges: Vec<_> = ghosts
            .filter(|&h| ends(h)[0].lex_cmp(&ends(h)[1]).is_lt())
            .collect();
        edges.sort_unstable_by(|&g, &h| ends(g)[0].lex_cmp(&ends(h)[0]));
        Self { edges }
    }

    /// Finds where `p` lies.
    ///
    /// *Cost*: O(log n).
    pub fn locate(&self, mesh: &Mesh, points: &[Point], p: Point) -> Location {
        let ends = |h: HalfEdgeId| [mesh.origin(h), mesh.dest(h)].map(|v| points[v.index()]);
        let first = self.edges[0];
        let [a, b] = ends(first);
        match orient2d(a, b, p) {
            Orientation::Left => return Location::Outside(first),
            Orientation::Right => return Location::Outside(mesh.twin(first)),
            Orientation::Collinear => {}
        }
        let before = self
            .edges
            .partition_point(|&h| ends(h)[1].lex_cmp(&p).is_lt());
        let Some(&h) = self.edges.get(before) else {
            return Location::Beyond(self.edges[before - 1].next());
        };
        let [a, b] = ends(h);
        if p == b {
            Location::Vertex(mesh.dest(h))
        } else if p == a {
            Location::Vertex(mesh.origin(h))
        } else if p.lex_cmp(&a).is_lt() {
            Location::Beyond(mesh.twin(h).next())
        } else {
            Location::Edge(h.min(mesh.twin(h)))
        }
    }
}
