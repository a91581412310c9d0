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

use super::bounds::{Bounds, Shape};
use super::canvas::Canvas;
use super::lines::Lines;
use super::patch::{Face, Patch};
use super::refiner::Refiner;
use super::{Outcome, Refinement};
use crate::predicates::{Orientation, orient2d};
use crate::{HalfEdgeId, Phase, Point, TriangleId, VertexId};
use std::time::Instant;

/// The squared sine of 30 degrees. Whatever the bound, an angle below stays the smallest one around only
/// if it grows.
const MODEST: f64 = 0.25;

/// Moves shorter than this part of the shortest edge, squared, are not worth the work.
const SHORTEST_MOVE: f64 = 1e-6;

/// Steps between two looks at clock and watch.
const STRIDE: usize = 1 << 10;

/// Moves free vertices to better places, as often as asked for and as the time allows; tells if the
/// watch has cancelled. `sown` says of the vertices that were there when refinement began which are free.
pub(super) fn smooth(
    refiner: &mut Refiner,
    sown: &[bool],
    refinement: &Refinement,
    start: Instant,
) -> Option<Outcome> {
    if refinement.smoothing == 0 {
        return None;
    }
    let (watch, time) = (refinement.watch, refinement.budget.time);
    let mut smoother = Smoother::new(&mut refiner.canvas, &refiner.lines, sown, &refiner.bounds);
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
                if time.is_some_and(|time| start.elapsed() >= time) {
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
    None
}

/// What some triangles are like.
#[derive(Clone, Debug)]
struct Worth {
    /// The sum over triangles of area divided by squared lengths of edges.
    quality: f64,
    /// The squared sine of the smallest angle.
    sine: f64,
    /// How many break a bound.
    broken: usize,
    /// By how much the worst of them is too large.
    oversize: f64,
    /// Vertices too close to a segment of their triangle, each before the ends of that.
    encroached: Vec<[VertexId; 3]>,
}

/// Moves vertices of a canvas.
struct Smoother<'a> {
    canvas: &'a mut Canvas,
    bounds: &'a Bounds<'a>,
    free: Vec<VertexId>,
    /// A half-edge that starts at each vertex.
    spokes: Vec<HalfEdgeId>,
    /// Whether a vertex has found no better place, and nothing around it has changed since.
    settled: Vec<bool>,
    has_sizes: bool,
    patch: Patch,
}

impl<'a> Smoother<'a> {
    fn new(canvas: &'a mut Canvas, lines: &Lines, sown: &[bool], bounds: &'a Bounds<'a>) -> Self {
        let all = (0..canvas.points.len()).map(VertexId::new);
        let is_free = |&v: &VertexId| match sown.get(v.index()) {
            Some(&is_sown) => is_sown,
            None => lines.of_vertex(v).is_none(),
        };
        let mut smoother = Self {
            free: all.filter(is_free).collect(),
            spokes: vec![HalfEdgeId::new(0); canvas.points.len()],
            settled: vec![false; canvas.points.len()],
            has_sizes: bounds.has_sizes(),
            patch: Patch::new(canvas.mesh.num_faces()),
            canvas,
            bounds,
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
        let at = self.canvas.point(v);
        let (mut sum, mut doubled_area, mut shortest) = ([0.0; 2], 0.0, f64::INFINITY);
        for h in self.canvas.mesh.star(self.spokes[v.index()]) {
            let ends = [h, h.next()].map(|h| self.canvas.point(self.canvas.mesh.dest(h)));
            let [[bx, by], [cx, cy]] = ends.map(|p| [p.x - at.x, p.y - at.y]);
            let [b, c] = [bx * bx + by * by, cx * cx + cy * cy];
            // The circumcenter, times four times the area.
            sum[0] += cy * b - by * c;
            sum[1] += bx * c - cx * b;
            doubled_area += bx * cy - by * cx;
            shortest = b.min(shortest);
        }
        let way = sum.map(|s| s / (2.0 * doubled_area));
        let squared = way[0] * way[0] + way[1] * way[1];
        // Written so that what is no number is no way.
        (squared > SHORTEST_MOVE * shortest && squared < f64::INFINITY).then_some(way)
    }

    /// Moves a vertex, unless that makes the mesh worse.
    fn try_move(&mut self, v: VertexId, to: Point) -> bool {
        let spoke = self.spokes[v.index()];
        if !self.sees_its_star(spoke, to) {
            return false;
        }
        self.patch.begin(self.canvas, spoke);
        let from = std::mem::replace(&mut self.canvas.points[v.index()], to);
        self.patch.legalise(self.canvas);
        let before = self.worth(self.patch.faces().iter().copied());
        let after = self.patch.faces().iter();
        let after = self.worth(after.map(|face| Face::of(self.canvas, face.id)));
        if !after.is_better_than(&before) {
            self.canvas.points[v.index()] = from;
            self.patch.undo(self.canvas);
            return false;
        }
        for i in 0..self.patch.faces().len() {
            let t = self.patch.faces()[i].id;
            self.note_spokes(t);
            for v in self.canvas.mesh.corners(t) {
                self.settled[v.index()] = false;
            }
        }
        true
    }

    /// Tells whether all triangles around a vertex stay counter-clockwise if it goes there.
    fn sees_its_star(&self, spoke: HalfEdgeId, to: Point) -> bool {
        let mesh = &self.canvas.mesh;
        let mut rim = mesh.star(spoke).map(|h| self.canvas.ends(h.next()));
        rim.all(|ends| {
            let [a, b] = ends.map(|v| self.canvas.point(v));
            orient2d(a, b, to) == Orientation::Left
        })
    }

    fn note_spokes(&mut self, t: TriangleId) {
        for h in t.half_edges() {
            let v = self.canvas.mesh.origin(h);
            if !v.is_infinite() {
                self.spokes[v.index()] = h;
            }
        }
    }

    fn worth(&self, faces: impl Iterator<Item = Face>) -> Worth {
        let mut worth = Worth::default();
        for face in faces {
            let shape = Shape::of(face.points);
            let oversize = match self.has_sizes {
                true => self.bounds.oversize(face.points, &shape, face.region),
                false => 0.0,
            };
            let is_broken = oversize > 1.0 || self.bounds.is_skinny(shape.squares, shape.cross);
            worth.add(&shape, oversize, is_broken);
            worth.encroached.extend(self.encroached(&face));
        }
        worth
    }

    /// Lists the vertices of a triangle that are too close to the segment opposite, each before its ends.
    fn encroached(&self, face: &Face) -> impl Iterator<Item = [VertexId; 3]> {
        let segments = (0..3).filter(|&k| face.traits.is_constrained(k));
        let slots = segments.map(|k| [k, (k + 1) % 3, (k + 2) % 3]);
        let close = slots.filter(|&[k, i, j]| {
            let ends = [face.points[i], face.points[j]];
            self.bounds.encroaches(ends, face.points[k])
        });
        close.map(|slots| slots.map(|k| face.corners[k]))
    }
}

impl Default for Worth {
    /// Makes that of no triangles.
    fn default() -> Self {
        Self {
            quality: 0.0,
            sine: 1.0,
            broken: 0,
            oversize: 0.0,
            encroached: Vec::new(),
        }
    }
}

impl Worth {
    fn add(&mut self, shape: &Shape, oversize: f64, is_broken: bool) {
        let [a, b, c] = shape.squares;
        let [low, high] = [a.min(b), a.max(b)];
        self.quality += shape.cross / (a + b + c);
        self.sine = self
            .sine
            .min(shape.cross * shape.cross / (high * low.max(c)));
        self.broken += usize::from(is_broken);
        self.oversize = self.oversize.max(oversize);
    }

    /// Tells whether as many triangles are better on average, and none for the price of a bound.
    fn is_better_than(&self, before: &Self) -> bool {
        // With a margin, so that rounding makes no vertex wander for ever.
        self.quality > before.quality * (1.0 + 1e-9)
            && self.broken <= before.broken
            // One for another will not do: some cannot be avoided, others could be split no more.
            && self.encroached.iter().all(|e| before.encroached.contains(e))
            && self.sine >= before.sine.min(MODEST)
            && (self.broken == 0 || self.sine >= before.sine && self.oversize <= before.oversize)
    }
}
