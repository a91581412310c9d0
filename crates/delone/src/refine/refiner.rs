//! The loop: take the worst element, propose a point, ask what it conflicts with; then insert it, split
//! the segment that is in its way, or leave the element alone.
//!
//! Here is what is looked at and what waits; what is done about it stands in [`insertion`](super::insertion) and
//! [`splitting`](super::splitting).

use super::Locked;
use super::bounds::{Bounds, Shape};
use super::candidates::Candidates;
use super::canvas::{Canvas, Traits};
use super::cavity::Cavity;
use super::lines::Lines;
use super::patch::Patch;
use super::queue::Queue;
use super::telling::Teller;
use crate::{HalfEdgeId, Observer, Point, TriangleId, VertexId};
use std::collections::VecDeque;

/// Vertices that are to improve angles keep at least this part of the local feature size away from all
/// others.
const GRADATION: f64 = 1.0 / 16.0;

/// The same if segments must not be split: then vertices have to crowd before long ones.
const GRADATION_LOCKED: f64 = 1.0 / 256.0;

/// A refinement under way.
pub(super) struct Refiner<'a, O> {
    pub canvas: Canvas,
    pub lines: Lines,
    pub bounds: Bounds<'a>,
    pub locked: Locked,
    pub candidates: Candidates,
    /// For each vertex the feature size of where its ancestors come from.
    pub base: Vec<f64>,
    pub encroached: VecDeque<Encroached>,
    pub oversized: Queue,
    pub skinny: Queue,
    /// The cavity of the best candidate so far, and of the one that is looked at.
    pub best: Cavity,
    pub spare: Cavity,
    /// Whether vertices that were there at the beginning are of a lattice.
    pub sown: Vec<bool>,
    pub has_lattice: bool,
    pub patch: Patch,
    pub teller: Teller<'a, O>,
}

/// A subsegment that has to be split.
#[derive(Clone, Copy, Debug)]
pub(super) struct Encroached {
    pub half_edge: HalfEdgeId,
    pub ends: [VertexId; 2],
}

/// What came of a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Step {
    /// A vertex was added.
    Added,
    /// An element was left as it is, or had vanished.
    Passed,
    /// Nothing is left to do.
    Finished,
}

impl<'a, O: Observer> Refiner<'a, O> {
    pub fn new(
        canvas: Canvas,
        sown: Vec<bool>,
        bounds: Bounds<'a>,
        locked: Locked,
        teller: Teller<'a, O>,
    ) -> Self {
        let base = feature_sizes(&canvas);
        let mut refiner = Self {
            candidates: Candidates::new(bounds.min_angle),
            lines: Lines::new(canvas.points.len()),
            canvas,
            bounds,
            locked,
            base,
            encroached: VecDeque::new(),
            oversized: Queue::new(),
            skinny: Queue::new(),
            best: Cavity::default(),
            spare: Cavity::default(),
            has_lattice: sown.contains(&true),
            sown,
            patch: Patch::default(),
            teller,
        };
        let faces = (0..refiner.canvas.mesh.num_faces()).map(TriangleId::new);
        for t in faces {
            if !refiner.canvas.traits(t).is_outside() {
                refiner.examine(t, true);
            }
        }
        refiner
    }

    pub fn num_vertices(&self) -> usize {
        self.canvas.points.len()
    }

    /// Tells whether nothing waits any more.
    pub fn is_finished(&self) -> bool {
        self.encroached.is_empty() && self.oversized.len() == 0 && self.skinny.len() == 0
    }

    /// Estimates how many vertices are still to come.
    pub fn backlog(&self) -> usize {
        self.encroached.len() + self.oversized.len() + self.skinny.len() / 2
    }

    /// Treats one element.
    #[inline]
    pub fn step(&mut self) -> Step {
        if let Some(subsegment) = self.encroached.pop_front() {
            return self.relieve(subsegment);
        }
        if let Some((t, corners)) = self.oversized.pop() {
            return self.shrink(t, corners);
        }
        if let Some((t, corners)) = self.skinny.pop() {
            return self.improve(t, corners);
        }
        Step::Finished
    }

    /// Looks at a new triangle of the domain, and lets it queue up if it is bad. `watches` says whether
    /// its edges may be encroached upon.
    #[inline]
    pub(super) fn examine(&mut self, t: TriangleId, watches: bool) {
        let corners = self.canvas.mesh.corners(t);
        let points = corners.map(|v| self.canvas.point(v));
        let traits = self.canvas.traits(t);
        if watches && traits.has_constraint() {
            self.watch_edges(t, points, traits);
        }
        let shape = Shape::of(points);
        if self.bounds.has_sizes() {
            let oversize = self.bounds.oversize(points, &shape, self.canvas.region(t));
            if oversize > 1.0 {
                self.oversized.push(1.0 / oversize, t, corners);
            }
        }
        if self.bounds.is_skinny(shape.squares, shape.cross) {
            self.canvas.set_skinny(t, true);
            self.skinny.push(shape.shortest().1, t, corners);
        }
    }

    #[cold]
    fn watch_edges(&mut self, t: TriangleId, points: [Point; 3], traits: Traits) {
        for h in t.half_edges() {
            let k = h.slot();
            let ends = [points[(k + 1) % 3], points[(k + 2) % 3]];
            if traits.is_constrained(k) && self.bounds.encroaches(ends, points[k]) {
                let ends = self.canvas.ends(h);
                self.encroached.push_back(Encroached { half_edge: h, ends });
            }
        }
    }

    /// Looks at the triangles that fill a cavity.
    pub(super) fn examine_all(&mut self, cavity: &Cavity) {
        for &t in &cavity.faces {
            if !self.canvas.traits(t).is_outside() {
                self.examine(t, true);
            }
        }
    }

    /// Looks at a triangle whose corners have changed or moved.
    pub(super) fn reexamine(&mut self, t: TriangleId) {
        self.canvas.set_skinny(t, false);
        if !self.canvas.traits(t).is_outside() {
            self.examine(t, true);
        }
    }

    /// Tells whether a vertex belongs to a lattice.
    pub(super) fn is_sown(&self, v: VertexId) -> bool {
        self.sown.get(v.index()) == Some(&true)
    }

    /// Lets a triangle queue up again if it has survived.
    pub(super) fn requeue(&mut self, t: TriangleId, corners: [VertexId; 3]) {
        if self.canvas.mesh.corners(t) == corners {
            self.examine(t, false);
        }
    }

    /// Returns which part of the feature size vertices keep away from others.
    pub(super) fn gradation(&self) -> f64 {
        match self.locked {
            Locked::Nothing => GRADATION,
            _ => GRADATION_LOCKED,
        }
    }

    /// Tells whether the subsegment of `h` must not be split.
    pub(super) fn is_locked(&self, h: HalfEdgeId) -> bool {
        match self.locked {
            Locked::Nothing => false,
            Locked::Boundary => {
                self.canvas.is_outside(h) != self.canvas.is_outside(self.canvas.mesh.twin(h))
            }
            Locked::Segments => true,
        }
    }

    /// Adds a vertex, whose causes have been said, at a line of the pseudocode.
    pub(super) fn push_vertex(&mut self, p: Point, base: f64, line: u16) -> VertexId {
        let v = VertexId::new(self.canvas.points.len());
        self.teller.at(line);
        self.teller.tell_vertex(v, p);
        self.canvas.points.push(p);
        self.base.push(base);
        v
    }
}

/// Estimates the local feature size at each vertex: its distance from the nearest vertex or subsegment that
/// it sees in the domain and does not belong to.
fn feature_sizes(canvas: &Canvas) -> Vec<f64> {
    let mut squares = vec![f64::INFINITY; canvas.points.len()];
    for (t, corners) in canvas.mesh.faces().iter().enumerate() {
        let t = TriangleId::new(t);
        let traits = canvas.traits(t);
        if traits.is_outside() {
            continue;
        }
        let shape = Shape::of(canvas.triangle(t));
        for k in 0..3 {
            let [next, previous] = [(k + 1) % 3, (k + 2) % 3];
            let mut least = shape.squares[next].min(shape.squares[previous]);
            if traits.is_constrained(k) {
                // If the foot of the height lies outside, the nearest point is an end.
                let [long, short] = [shape.squares[next], shape.squares[previous]];
                let base = shape.squares[k];
                if (long - short).abs() <= base {
                    least = least.min(shape.cross * shape.cross / base);
                }
            }
            let of_vertex = &mut squares[corners[k].index()];
            *of_vertex = of_vertex.min(least);
        }
    }
    squares.into_iter().map(f64::sqrt).collect()
}
