//! The holes of a result, each by a point in it, whatever rule has carved them.

use super::ConstrainedTriangulation;
use crate::predicates::{Orientation, orient2d};
use crate::{Point, TriangleId};

impl ConstrainedTriangulation {
    /// Returns a point in each hole: in each part of the convex hull that was carved away and that
    /// segments separate from the outside. With these seeds [`DomainRule::Carve`](crate::DomainRule::Carve)
    /// yields the same domain, whatever rule this one is from.
    ///
    /// A hole so narrow that no `f64` point lies in it is left out. *Cost*: linear.
    pub fn hole_seeds(&self) -> Vec<Point> {
        let mesh = self.triangulation.mesh();
        let mut seen = vec![false; mesh.num_faces()];
        for ghost in mesh.ghosts() {
            self.visit(ghost, &mut seen);
        }
        let carved = (self.triangulation.num_triangles()..mesh.num_faces()).map(TriangleId::new);
        let holes = carved.map(|t| self.visit(t, &mut seen));
        holes.filter_map(|hole| self.seed_of(&hole)).collect()
    }

    /// Lists the faces that no segment separates from `start`, if it has not been seen before.
    fn visit(&self, start: TriangleId, seen: &mut [bool]) -> Vec<TriangleId> {
        let mesh = self.triangulation.mesh();
        let mut list = Vec::new();
        if !std::mem::replace(&mut seen[start.index()], true) {
            list.push(start);
        }
        let mut next = 0;
        while let Some(&t) = list.get(next) {
            next += 1;
            for h in t
                .half_edges()
                .into_iter()
                .filter(|&h| !self.is_constrained(h))
            {
                let neighbor = mesh.twin(h).triangle();
                if !std::mem::replace(&mut seen[neighbor.index()], true) {
                    list.push(neighbor);
                }
            }
        }
        list
    }

    /// Finds a point inside of one of some triangles, the largest first.
    fn seed_of(&self, hole: &[TriangleId]) -> Option<Point> {
        let corners = |&t: &TriangleId| {
            let corners = self.triangulation.mesh().corners(t);
            corners.map(|v| self.triangulation.point(v))
        };
        let area = |[a, b, c]: [Point; 3]| (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        let largest = hole
            .iter()
            .map(corners)
            .max_by(|&s, &t| area(s).total_cmp(&area(t)));
        let mut candidates = largest.into_iter().chain(hole.iter().map(corners));
        candidates.find_map(centre)
    }
}

/// Returns the centre of a triangle, if rounding leaves it inside.
fn centre([a, b, c]: [Point; 3]) -> Option<Point> {
    let third = |a: f64, b: f64, c: f64| a / 3.0 + b / 3.0 + c / 3.0;
    let p = Point::new(third(a.x, b.x, c.x), third(a.y, b.y, c.y));
    let is_inside = [[a, b], [b, c], [c, a]]
        .iter()
        .all(|&[from, to]| orient2d(from, to, p) == Orientation::Left);
    is_inside.then_some(p)
}

#[cfg(test)]
mod tests {
    use crate::{ConstrainedDelaunay, DomainRule, Pslg};

    /// An outline that is not convex, with a hole, an island in it, and a hole in that.
    #[test]
    fn seeds_carve_what_parity_did() {
        let mut pslg = Pslg::from_points([(0.0, 0.0), (20.0, 0.0), (20.0, 20.0), (9.0, 19.0)]);
        pslg.add_ring([0, 1, 2, 3]);
        for half in [4.0, 3.0, 1.0] {
            let first = pslg.points.len() as u32;
            let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
            let place = |(x, y): (f64, f64)| crate::Point::new(12.0 + half * x, 8.0 + half * y);
            pslg.points.extend(corners.map(place));
            pslg.add_ring(first..first + 4);
        }
        let build = |pslg: &Pslg, rule| {
            let builder = ConstrainedDelaunay::new().domain(rule);
            builder.triangulate(pslg.clone()).unwrap()
        };
        let by_parity = build(&pslg, DomainRule::EvenOdd);
        pslg.holes = by_parity.hole_seeds();
        assert_eq!(pslg.holes.len(), 2);
        let by_seeds = build(&pslg, DomainRule::Carve);
        assert!(by_seeds.warnings().is_empty());
        let hash = |t: &crate::ConstrainedTriangulation| t.triangulation().hash();
        assert_eq!(hash(&by_seeds), hash(&by_parity));
        assert_eq!(by_seeds.hole_seeds().len(), 2);
        assert!(build(&pslg, DomainRule::Hull).hole_seeds().len() == 2);
    }
}
