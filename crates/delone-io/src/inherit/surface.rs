//! The input as a surface, linear in every triangle of its constrained triangulation.
//!
//! Where each vertex lies is found by walking there from a neighbour in the refined mesh whose place
//! is known, a few triangles each. In a constrained triangulation a walk that always takes the first
//! separating edge may run in circles; so where it looks first changes from step to step, and it ends
//! (Devillers, Pion and Teillaud, *Walking in a triangulation*, 2002: the stochastic walk).

use crate::{Error, cancel, unrefined};
use delone::predicates::{Orientation, orient2d};
use delone::{
    ConstrainedDelaunay, ConstrainedTriangulation, HalfEdgeId, Point, TriangleId, Triangulation,
    VertexId, Watch,
};
use std::collections::VecDeque;

/// The constrained triangulation before refinement, and the triangle in it of every vertex after it.
pub(super) struct Surface {
    before: Triangulation,
    /// Unknown for duplicates alone.
    triangle_of: Vec<Option<TriangleId>>,
}

impl Surface {
    /// Triangulates the first `num_vertices` vertices of `after` with the pieces of `chains` between them, and
    /// finds the others in it. There must be three vertices that are not on one line.
    pub fn before<'c>(
        after: &ConstrainedTriangulation,
        num_vertices: usize,
        chains: impl Iterator<Item = &'c [VertexId]>,
        watch: &dyn Watch,
    ) -> Result<Self, Error> {
        let points = &after.triangulation().points()[..num_vertices];
        let drawing = unrefined::drawing(points, chains);
        let before = ConstrainedDelaunay::new().watch(watch).triangulate(drawing);
        let before = before.map_err(|error| match error {
            delone::Error::Cancelled => Error::Cancelled,
            other => Error::BadMesh(other.to_string()),
        })?;
        let mut surface = Self {
            before: before.into_triangulation(),
            triangle_of: vec![None; after.triangulation().points().len()],
        };
        surface.find_all(after.triangulation(), watch)?;
        Ok(surface)
    }

    /// Finds the triangles of all vertices, from the known ones outwards.
    fn find_all(&mut self, after: &Triangulation, watch: &dyn Watch) -> Result<(), Error> {
        let mut queue = VecDeque::new();
        for v in (0..self.before.points().len()).map(VertexId::new) {
            let mut star = self.before.star(v).map(|h| h.triangle());
            let found = star.find(|&t| !self.before.mesh().is_ghost(t));
            self.triangle_of[v.index()] = found;
            queue.extend(found.map(|t| (v, t)));
        }
        let mut dice = 0;
        let mut asked = 0;
        while let Some((v, known)) = queue.pop_front() {
            cancel::check(watch, asked)?;
            asked += 1;
            for u in after.star(v).map(|h| after.mesh().dest(h)) {
                if !u.is_infinite() && self.triangle_of[u.index()].is_none() {
                    let found = self.walk(known, after.point(u), &mut dice);
                    self.triangle_of[u.index()] = Some(found);
                    queue.push_back((u, found));
                }
            }
        }
        Ok(())
    }

    /// Walks to the triangle that holds `goal`, or to one at the hull if it lies beyond.
    fn walk(&self, from: TriangleId, goal: Point, dice: &mut u32) -> TriangleId {
        let mesh = self.before.mesh();
        let mut t = from;
        loop {
            *dice = dice.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
            let mut half_edges = t.half_edges();
            half_edges.rotate_left((*dice >> 16) as usize % 3);
            let mut separating = half_edges.into_iter().filter(|&h| self.separates(h, goal));
            match separating.next().map(|h| mesh.twin(h).triangle()) {
                Some(next) if !mesh.is_ghost(next) => t = next,
                _ => return t,
            }
        }
    }

    /// Tells whether `goal` lies beyond the edge of `h`, seen from its triangle.
    fn separates(&self, h: HalfEdgeId, goal: Point) -> bool {
        let mesh = self.before.mesh();
        let [a, b] = [mesh.origin(h), mesh.dest(h)].map(|v| self.before.point(v));
        orient2d(a, b, goal) == Orientation::Right
    }

    /// Interpolates linearly at vertex `v`, whose position is `at`; `values` are those of the vertices
    /// before refinement.
    ///
    /// # Panics
    /// If `v` is a duplicate.
    pub fn interpolate(&self, v: VertexId, at: Point, values: &[f64]) -> f64 {
        let t = self.triangle_of[v.index()].expect("bug: a vertex of no triangle");
        let corners = self.before.mesh().corners(t);
        let values = corners.map(|c| values[c.index()]);
        if values[0] == values[1] && values[1] == values[2] {
            return values[0];
        }
        let shares = shares(corners.map(|c| self.before.point(c)), at);
        let terms = values
            .iter()
            .zip(shares)
            .map(|(value, share)| value * share);
        terms.sum()
    }
}

/// Tells how much of a point in the triangle abc belongs to each corner: at least 0, and 1 together.
fn shares([a, b, c]: [Point; 3], at: Point) -> [f64; 3] {
    let half = |to: Point| [to.x * 0.5 - at.x * 0.5, to.y * 0.5 - at.y * 0.5];
    let vectors = [a, b, c].map(half);
    // Shares do not depend on the scale of either axis, and scaled so no product overflows.
    let largest = |axis: usize| {
        let sizes = vectors.iter().map(|v| v[axis].abs());
        sizes.fold(f64::MIN_POSITIVE, f64::max)
    };
    let scale = [largest(0), largest(1)];
    let [u, v, w] = vectors.map(|[x, y]| [x / scale[0], y / scale[1]]);
    let doubled_area = |p: [f64; 2], q: [f64; 2]| (p[0] * q[1] - p[1] * q[0]).max(0.0);
    let areas = [doubled_area(v, w), doubled_area(w, u), doubled_area(u, v)];
    let sum: f64 = areas.iter().sum();
    if sum > 0.0 {
        areas.map(|area| area / sum)
    } else {
        [1.0 / 3.0; 3]
    }
}

#[cfg(test)]
mod tests {
    use super::shares;
    use delone::Point;

    type Pair = (f64, f64);

    fn of(corners: [Pair; 3], at: Pair) -> [f64; 3] {
        shares(corners.map(Point::from), Point::from(at))
    }

    fn require(corners: [Pair; 3], at: Pair, expected: [f64; 3]) {
        let shares = of(corners, at);
        let is_near = |(a, b): (&f64, &f64)| (a - b).abs() < 1e-15;
        assert!(shares.iter().zip(&expected).all(is_near), "{shares:?}");
    }

    #[test]
    fn shares_are_barycentric_at_any_size() {
        let [o, x, y] = [(0.0, 0.0), (4.0, 0.0), (0.0, 4.0)];
        require([o, x, y], (1.0, 2.0), [0.25, 0.25, 0.5]);
        require([o, x, y], x, [0.0, 1.0, 0.0]);
        require([o, x, y], (2.0, 0.0), [0.5, 0.5, 0.0]);
        let huge = 1e308;
        let wide = [(-huge, -huge), (huge, -huge), (-huge, huge)];
        require(wide, (-huge, 0.0), [0.5, 0.0, 0.5]);
        let narrow = [o, (1e-300, 0.0), (0.0, 4e200)];
        require(narrow, (2.5e-301, 2e200), [0.25, 0.25, 0.5]);
    }

    #[test]
    fn beyond_an_edge_shares_stay_shares() {
        let [a, b, c] = of([(0.0, 0.0), (4.0, 0.0), (0.0, 4.0)], (2.0, -1e-9));
        assert!(a >= 0.0 && b >= 0.0 && c == 0.0 && (a + b - 1.0).abs() < 1e-15);
        let flat = of([(0.0, 0.0), (1.0, 0.0), (2.0, 0.0)], (1.0, 0.0));
        assert_eq!(flat, [1.0 / 3.0; 3]);
    }
}
