//! The constrained Delaunay triangulation: which triangles see no point inside their circles.
//!
//! A triangle belongs to it if no segment enters its interior, no point lies in it, and every point
//! inside its perturbed circle is hidden behind segments from all of its interior. O(n⁴ m) and more.
//!
//! *Hidden*, exactly: look from the point p at the triangle. The directions from p to all points
//! divide the view into cones without points. A segment that enters such a cone spans it, and
//! spanning segments do not cross, so within a cone they have an order: p sees the triangle there
//! unless a segment lies before the triangle's near edge, or on it.

use super::{distinct, sorted, triples};
use delone::predicates::{Orientation, in_circle_perturbed, orient2d};
use delone::{Point, VertexId};
use std::cmp::Ordering;

/// Lists the triangles of the constrained Delaunay triangulation: counter-clockwise, lowest index
/// first, sorted; those of the whole convex hull.
///
/// Of equal points only the first counts, and only such are ends of segments. Segments must meet at
/// shared ends only and run through no point; they may repeat.
pub fn naive_constrained(points: &[Point], segments: &[[VertexId; 2]]) -> Vec<[VertexId; 3]> {
    let graph = Graph {
        points,
        vertices: distinct(points),
        segments: segments.iter().map(|s| s.map(VertexId::index)).collect(),
    };
    sorted(triples(points, &graph.vertices).filter(|&t| graph.has_triangle(t)))
}

struct Graph<'a> {
    points: &'a [Point],
    vertices: Vec<usize>,
    segments: Vec<[usize; 2]>,
}

impl Graph<'_> {
    fn has_triangle(&self, triangle: [usize; 3]) -> bool {
        let mut others = self.vertices.iter().filter(|v| !triangle.contains(v));
        self.is_free(triangle)
            && others.all(|&p| !self.is_inside(triangle, p) || self.is_hidden(triangle, p))
    }

    /// Tells whether the closed triangle contains no further point and its interior no segment.
    fn is_free(&self, triangle: [usize; 3]) -> bool {
        let mut others = self.vertices.iter().filter(|v| !triangle.contains(v));
        let contains = |p: usize| {
            edges(triangle)
                .iter()
                .all(|&[a, b]| self.turn(a, b, p) != Orientation::Right)
        };
        // Without points in it, what enters the interior leaves across an edge.
        let enters = |s: &[usize; 2]| edges(triangle).iter().any(|&e| self.cross(*s, e));
        !others.any(|&p| contains(p)) && !self.segments.iter().any(enters)
    }

    fn is_inside(&self, triangle: [usize; 3], p: usize) -> bool {
        let [a, b, c] = triangle.map(|v| self.points[v]);
        in_circle_perturbed(a, b, c, self.points[p])
    }

    /// Tells whether `p`, outside of the triangle, sees none of its interior.
    fn is_hidden(&self, triangle: [usize; 3], p: usize) -> bool {
        let near = |&[a, b]: &[usize; 2]| self.turn(a, b, p) == Orientation::Right;
        let near: Vec<_> = edges(triangle).into_iter().filter(near).collect();
        near.iter().all(|&edge| {
            let directions = self.directions(p, edge);
            let mut cones = directions.windows(2);
            cones.all(|cone| self.is_covered(p, edge, [cone[0], cone[1]]))
        })
    }

    /// Lists one point for each direction in which `p` sees points, from end to end of the near
    /// edge, counter-clockwise.
    fn directions(&self, p: usize, [a, b]: [usize; 2]) -> Vec<usize> {
        // The edge turns right as seen from p, so its view goes from b to a.
        let is_between = |&&v: &&usize| {
            self.turn(p, b, v) == Orientation::Left && self.turn(p, v, a) == Orientation::Left
        };
        let mut between: Vec<_> = self.vertices.iter().filter(is_between).copied().collect();
        between.sort_by(|&u, &v| match self.turn(p, u, v) {
            Orientation::Left => Ordering::Less,
            Orientation::Collinear => Ordering::Equal,
            Orientation::Right => Ordering::Greater,
        });
        between.dedup_by(|v, u| self.turn(p, *u, *v) == Orientation::Collinear);
        [vec![b], between, vec![a]].concat()
    }

    /// Tells whether a segment spans the cone at `p` in front of the near edge, or is that edge.
    fn is_covered(&self, p: usize, edge: [usize; 2], cone: [usize; 2]) -> bool {
        let hides = |&s: &[usize; 2]| {
            same(s, edge) || (self.spans(p, s, cone) && self.is_before(p, s, edge))
        };
        self.segments.iter().any(hides)
    }

    fn spans(&self, p: usize, [q, r]: [usize; 2], cone: [usize; 2]) -> bool {
        let [from, to] = match self.turn(p, q, r) {
            Orientation::Left => [q, r],
            Orientation::Right => [r, q],
            Orientation::Collinear => return false,
        };
        let is_in_view = |v: usize| {
            self.turn(p, from, v) != Orientation::Right && self.turn(p, v, to) != Orientation::Right
        };
        cone.into_iter().all(is_in_view)
    }

    /// Of a segment and an edge that span a common cone at `p`, are not the same and do not cross,
    /// tells whether the segment is nearer to `p`.
    fn is_before(&self, p: usize, [q, r]: [usize; 2], [a, b]: [usize; 2]) -> bool {
        let of_edge = self.turn(a, b, p);
        let sides = [q, r].map(|v| self.turn(a, b, v));
        if sides.iter().all(|&s| s != of_edge.reversed()) {
            return true;
        }
        if sides.iter().all(|&s| s != of_edge) {
            return false;
        }
        // The segment's ends lie on both sides of the edge's line, so the edge on one of the segment's.
        let of_segment = self.turn(q, r, p);
        [a, b].iter().all(|&v| self.turn(q, r, v) != of_segment)
    }

    /// Tells whether two edges cross in the interior of both.
    fn cross(&self, [a, b]: [usize; 2], [c, d]: [usize; 2]) -> bool {
        let parts =
            |s: Orientation, t: Orientation| s != Orientation::Collinear && s == t.reversed();
        parts(self.turn(a, b, c), self.turn(a, b, d))
            && parts(self.turn(c, d, a), self.turn(c, d, b))
    }

    fn turn(&self, a: usize, b: usize, c: usize) -> Orientation {
        orient2d(self.points[a], self.points[b], self.points[c])
    }
}

fn edges([a, b, c]: [usize; 3]) -> [[usize; 2]; 3] {
    [[a, b], [b, c], [c, a]]
}

fn same([a, b]: [usize; 2], other: [usize; 2]) -> bool {
    other == [a, b] || other == [b, a]
}

#[cfg(test)]
mod tests {
    use super::super::{naive_delaunay, naive_noding};
    use super::*;
    use crate::generate::{Kind, Random};
    use std::collections::{BTreeMap, BTreeSet};

    #[test]
    fn without_segments_it_is_the_delaunay_triangulation() {
        for seed in 0..50 {
            let points = Kind::Lattice { side: 4 }.points(9, seed);
            assert_eq!(naive_constrained(&points, &[]), naive_delaunay(&points));
        }
    }

    #[test]
    fn a_segment_changes_what_it_hides() {
        let points = [(0.0, 0.0), (4.0, -1.0), (8.0, 0.0), (4.0, 1.0)].map(Point::from);
        let triangles = |segments: &[[u32; 2]]| {
            let segments: Vec<_> = segments.iter().map(|s| s.map(VertexId::from)).collect();
            let found = naive_constrained(&points, &segments).into_iter();
            found.map(|t| t.map(|v| v.raw())).collect::<Vec<_>>()
        };
        assert_eq!(triangles(&[]), [[0, 1, 3], [1, 2, 3]]);
        assert_eq!(triangles(&[[2, 0]]), [[0, 1, 2], [0, 2, 3]]);
    }

    /// Euler's count, segments as edges, and no edge that ought to be flipped.
    #[test]
    fn it_is_a_triangulation_and_locally_delaunay() {
        for seed in 0..300 {
            let mut random = Random::new(seed);
            let kind = random.choose(&[Kind::Lattice { side: 4 }, Kind::UlpLattice, Kind::Cross]);
            let points = kind.points(8, seed);
            let segments: Vec<_> = (0..random.below(5))
                .map(|_| [0; 2].map(|_| VertexId::new(random.below(8))))
                .collect();
            let noding = naive_noding(&points, &segments);
            assert_sound(&noding.points, &noding.edges());
        }
    }

    fn assert_sound(points: &[Point], segments: &[[VertexId; 2]]) {
        let triangles = naive_constrained(points, segments);
        let mut apexes = BTreeMap::new();
        for &[a, b, c] in &triangles {
            for (edge, apex) in [([a, b], c), ([b, c], a), ([c, a], b)] {
                assert_eq!(apexes.insert(edge, apex), None, "{points:?} {segments:?}");
            }
        }
        let vertices = distinct(points).len();
        let hull = apexes
            .keys()
            .filter(|&&[a, b]| !apexes.contains_key(&[b, a]));
        let hull = hull.count();
        if hull > 0 {
            assert_eq!(
                triangles.len() + hull + 2,
                2 * vertices,
                "{points:?} {segments:?}"
            );
        }
        let fixed: BTreeSet<_> = segments
            .iter()
            .flat_map(|&[a, b]| [[a, b], [b, a]])
            .collect();
        let is_edge =
            |&[a, b]: &[VertexId; 2]| apexes.contains_key(&[a, b]) || apexes.contains_key(&[b, a]);
        assert!(
            hull == 0 || fixed.iter().all(is_edge),
            "{points:?} {segments:?}"
        );
        for (&[a, b], &c) in &apexes {
            if let Some(&d) = apexes.get(&[b, a]).filter(|_| !fixed.contains(&[a, b])) {
                let [a, b, c, d] = [a, b, c, d].map(|v| points[v.index()]);
                assert!(!in_circle_perturbed(a, b, c, d), "{points:?} {segments:?}");
            }
        }
    }
}
