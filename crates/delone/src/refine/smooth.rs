//! Smoothing: free vertices move to better places, and edges are flipped after them.
//!
//! Each pass takes the free vertices one after the other to where the optimal Delaunay triangulation
//! wants them: to the mean of the circumcenters of their triangles, weighted by area (Chen and Holst,
//! *Efficient mesh optimization schemes based on optimal Delaunay triangulations*, 2011). The move is
//! kept if the triangles that it changes become better on average (in area divided by the sum of squared
//! edges) and no bound is broken for it; else half of it is tried; else the vertex stays. Vertices of the
//! input and on segments never move.
//!
//! Taking the vertices one after the other, not all at once, keeps the mesh the canonical constrained
//! Delaunay triangulation after each move, so a move can be judged by what it really leads to. It is as
//! deterministic, for the order of vertices is that of refinement.
//!
//! *Cost*: about 2 µs a vertex and pass, and what a sizing field takes. The first pass does most of the
//! good: on a square with a hole it lifts the mean of the smallest angles from 45.5° to 48.5°, nine more
//! lift it to 50.2°. *Does not* make triangles that
//! break a bound obey it, though it may happen.

use super::bounds::Bounds;
use super::canvas::Canvas;
use super::code;
use super::lines::{Lines, distance};
use super::patch::Patch;
use super::refiner::Refiner;
use super::relocate::toward_centers;
use super::telling::Teller;
use super::worth::Worth;
use super::{Outcome, Refinement};
use crate::clock::Clock;
use crate::{HalfEdgeId, Observer, Phase, Point, Stage, TriangleId, VertexId};

/// Moves shorter than this part of the shortest edge, squared, are not worth the work.
const SHORTEST_MOVE: f64 = 1e-6;

/// Steps between two looks at clock and watch.
const STRIDE: usize = 1 << 10;

/// Moves free vertices to better places, as often as asked for and as the time allows; tells if the
/// watch has cancelled. `sown` says of the vertices that were there when refinement began which are free.
pub(super) fn smooth(
    refiner: &mut Refiner<impl Observer>,
    refinement: &Refinement,
    clock: Clock,
) -> Option<Outcome> {
    if refinement.smoothing == 0 {
        return None;
    }
    let (watch, time) = (refinement.watch, refinement.budget.time);
    let mut smoother = Smoother::new(
        &mut refiner.canvas,
        &refiner.lines,
        &refiner.sown,
        &refiner.bounds,
        &mut refiner.teller,
    );
    let free = smoother.num_free();
    let total = (free as u64).saturating_mul(refinement.smoothing as u64);
    let mut done = 0;
    for _ in 0..refinement.smoothing {
        let mut moved = false;
        for i in 0..free {
            if i % STRIDE == 0 {
                if watch.is_cancelled() {
                    return Some(Outcome::Cancelled);
                }
                if time.is_some_and(|time| clock.elapsed() >= time) {
                    return None;
                }
                watch.progress(Phase::Smooth, done + i as u64, total);
            }
            moved |= smoother.improve(i);
        }
        if !moved {
            break;
        }
        done += free as u64;
    }
    watch.progress(Phase::Smooth, total, total);
    refiner.teller.end(code::SMOOTH, Stage::Smoothing);
    None
}

/// Moves vertices of a canvas.
struct Smoother<'a, 'o, O> {
    canvas: &'a mut Canvas,
    bounds: &'a Bounds<'a>,
    free: Vec<VertexId>,
    /// A half-edge that starts at each vertex.
    spokes: Vec<HalfEdgeId>,
    /// Whether a vertex has found no better place, and nothing around it has changed since.
    settled: Vec<bool>,
    patch: Patch,
    teller: &'a mut Teller<'o, O>,
}

impl<'a, 'o, O: Observer> Smoother<'a, 'o, O> {
    fn new(
        canvas: &'a mut Canvas,
        lines: &Lines,
        sown: &[bool],
        bounds: &'a Bounds<'a>,
        teller: &'a mut Teller<'o, O>,
    ) -> Self {
        teller.at(code::SMOOTH);
        let all = (0..canvas.points.len()).map(VertexId::new);
        let is_free = |&v: &VertexId| match sown.get(v.index()) {
            Some(&is_sown) => is_sown,
            None => lines.of_vertex(v).is_none(),
        };
        let mut smoother = Self {
            free: all.filter(is_free).collect(),
            spokes: vec![HalfEdgeId::new(0); canvas.points.len()],
            settled: vec![false; canvas.points.len()],
            patch: Patch::default(),
            canvas,
            bounds,
            teller,
        };
        for t in (0..smoother.canvas.mesh.num_faces()).map(TriangleId::new) {
            smoother.note_spokes(t);
        }
        smoother
    }

    /// Counts the vertices that may move.
    fn num_free(&self) -> usize {
        self.free.len()
    }

    /// Takes the `i`-th free vertex to a better place; tells whether there was one.
    fn improve(&mut self, i: usize) -> bool {
        let v = self.free[i];
        if self.settled[v.index()] {
            return false;
        }
        let from = self.canvas.point(v);
        let is_better = self.way(v).is_some_and(|[dx, dy]| {
            let part = |share: f64| Point::new(from.x + share * dx, from.y + share * dy);
            let places = [1.0, 0.5].map(|share| self.canvas.placed(part(share)));
            places.into_iter().any(|to| self.try_move(v, to))
        });
        self.settled[v.index()] = !is_better;
        is_better
    }

    /// Returns how far the best place is away; `None` if that is not worth the work.
    fn way(&self, v: VertexId) -> Option<[f64; 2]> {
        let (mesh, at) = (&self.canvas.mesh, self.canvas.point(v));
        let to = |h| {
            let p = self.canvas.point(mesh.dest(h));
            [p.x - at.x, p.y - at.y]
        };
        let star = || mesh.star(self.spokes[v.index()]);
        let way = toward_centers(star().map(|h| [to(h), to(h.next())]));
        let neighbors = star().map(|h| distance(self.canvas.point(mesh.dest(h)), at));
        let shortest = neighbors.fold(f64::INFINITY, f64::min);
        let squared = way[0] * way[0] + way[1] * way[1];
        // Written so that what is no number is no way.
        (squared > SHORTEST_MOVE * shortest * shortest && squared < f64::INFINITY).then_some(way)
    }

    /// Moves a vertex, unless that makes the mesh worse.
    fn try_move(&mut self, v: VertexId, to: Point) -> bool {
        let spoke = self.spokes[v.index()];
        let is_better = |before: &Worth, after: &Worth| after.is_better_than(before);
        let (canvas, bounds) = (&mut *self.canvas, self.bounds);
        let from = canvas.point(v);
        if !self.patch.try_move(canvas, bounds, spoke, to, is_better) {
            return false;
        }
        self.teller.tell_move(canvas, v, from, self.patch.faces());
        for i in 0..self.patch.faces().len() {
            let t = self.patch.faces()[i].id;
            self.note_spokes(t);
            for v in self.canvas.mesh.corners(t) {
                self.settled[v.index()] = false;
            }
        }
        true
    }

    fn note_spokes(&mut self, t: TriangleId) {
        for h in t.half_edges() {
            let v = self.canvas.mesh.origin(h);
            if !v.is_infinite() {
                self.spokes[v.index()] = h;
            }
        }
    }
}
