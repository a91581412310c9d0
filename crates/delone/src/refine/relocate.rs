//! Moving a vertex instead of adding another.
//!
//! Where a head start has filled the domain with triangles as large as they may be, a new vertex among them
//! makes angles of 30 degrees and less; if these are too small, one calls for the next, until nothing of
//! the lattice is left. So before a skinny triangle there is opened, its corners are moved, if some place
//! makes fewer triangles break a bound: to the mean of the circumcenters around it, weighted by area (as in
//! [`smooth`](super::smooth)), or to the mean of its neighbours.
//!
//! Each move leaves fewer triangles that break a bound, so between two insertions there are finitely many;
//! and it keeps the distances that insertions keep, so there is an end of these, too.

use super::code;
use super::lines::distance;
use super::refiner::Refiner;
use super::worth::Worth;
use crate::{HalfEdgeId, Observer, Point, TriangleId};

impl<O: Observer> Refiner<'_, O> {
    /// Moves a corner of triangle `t` to where fewer triangles break a bound; tells whether there is such a
    /// place.
    pub(super) fn relocate(&mut self, t: TriangleId) -> bool {
        let spokes = t.half_edges().map(HalfEdgeId::next);
        spokes.into_iter().any(|spoke| self.relocate_origin(spoke))
    }

    fn relocate_origin(&mut self, spoke: HalfEdgeId) -> bool {
        let v = self.canvas.mesh.origin(spoke);
        if !self.is_sown(v) {
            return false;
        }
        let spacing = self.gradation() * self.base[v.index()];
        self.places(spoke).into_iter().any(|place| {
            let place = self.canvas.placed(place);
            let floor = spacing.max(self.canvas.closest(place));
            self.keeps_off(spoke, place, floor) && self.move_to(spoke, place)
        })
    }

    /// Lists places that may be better for the vertex from which `spoke` starts.
    fn places(&self, spoke: HalfEdgeId) -> [Point; 3] {
        let mesh = &self.canvas.mesh;
        let at = self.canvas.point(mesh.origin(spoke));
        let to = |h| {
            let p = self.canvas.point(mesh.dest(h));
            [p.x - at.x, p.y - at.y]
        };
        let toward_centers = toward_centers(mesh.star(spoke).map(|h| [to(h), to(h.next())]));
        let (mut sum, mut degree) = ([0.0; 2], 0.0);
        for [x, y] in mesh.star(spoke).map(to) {
            sum = [sum[0] + x, sum[1] + y];
            degree += 1.0;
        }
        let toward_neighbors = sum.map(|s| s / degree);
        let ways = [
            toward_centers,
            toward_neighbors,
            toward_centers.map(|d| 0.5 * d),
        ];
        ways.map(|[dx, dy]| Point::new(at.x + dx, at.y + dy))
    }

    /// Tells whether a place is no closer than `floor` to the neighbours of a vertex that shall go there.
    fn keeps_off(&self, spoke: HalfEdgeId, place: Point, floor: f64) -> bool {
        let mesh = &self.canvas.mesh;
        let mut neighbors = mesh.star(spoke).map(|h| mesh.dest(h));
        // Written so that a place that is none is refused.
        neighbors.all(|v| distance(self.canvas.point(v), place) >= floor)
    }

    /// Moves the vertex from which `spoke` starts, unless as many triangles break a bound afterwards.
    fn move_to(&mut self, spoke: HalfEdgeId, place: Point) -> bool {
        let has_less_broken = |before: &Worth, after: &Worth| {
            after.broken < before.broken && after.encroaches_nothing_new(before)
        };
        let mut patch = std::mem::take(&mut self.patch);
        let v = self.canvas.mesh.origin(spoke);
        let from = self.canvas.point(v);
        let (canvas, bounds) = (&mut self.canvas, &self.bounds);
        let is_moved = patch.try_move(canvas, bounds, spoke, place, has_less_broken);
        if is_moved {
            self.teller.at(code::MOVE);
            self.teller.tell_move(&self.canvas, v, from, patch.faces());
            for face in patch.faces() {
                self.reexamine(face.id);
            }
        }
        self.patch = patch;
        is_moved
    }
}

/// Returns the way from a vertex to the mean of the circumcenters of its triangles, weighted by area, given
/// the ways to the two other corners of each.
///
/// There optimal Delaunay triangulations have their vertices (Chen and Holst 2011).
pub(super) fn toward_centers(triangles: impl Iterator<Item = [[f64; 2]; 2]>) -> [f64; 2] {
    let (mut sum, mut doubled_area) = ([0.0; 2], 0.0);
    for [[bx, by], [cx, cy]] in triangles {
        let [b, c] = [bx * bx + by * by, cx * cx + cy * cy];
        // The circumcenter, times four times the area.
        sum[0] += cy * b - by * c;
        sum[1] += bx * c - cx * b;
        doubled_area += bx * cy - by * cx;
    }
    sum.map(|s| s / (2.0 * doubled_area))
}
