//! The hole that a new vertex tears into the triangulation, and how it is filled.
//!
//! The faces in conflict with a point, those whose circle contains it, hang together across edges that
//! are not constrained, and around the point they are star-shaped: the Bowyer–Watson insertion, which
//! keeps a constrained triangulation constrained Delaunay if the search stops at segments. The search
//! needs no location: it begins at any face in conflict that the point sees. If it sees none of them,
//! it does not lie to the left of all edges of the rim; the edge that hides it is constrained.
//!
//! No vertex vanishes, so the faces form a tree, the search needs no marks, and depth first it meets the
//! rim counter-clockwise. n edges of the rim enclose n − 2 faces.

use super::canvas::{Canvas, Traits};
use crate::{HalfEdgeId, Point, TriangleId, VertexId};

/// Faces in conflict with a point, and the edges around them.
#[derive(Clone, Debug, Default)]
pub(super) struct Cavity {
    pub faces: Vec<TriangleId>,
    /// Counter-clockwise.
    pub rim: Vec<Rim>,
    stack: Vec<HalfEdgeId>,
}

/// An edge of the rim.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rim {
    /// Its half-edge in the face beyond, which stays.
    pub outer: HalfEdgeId,
    /// Where it starts, with the cavity to its left.
    pub origin: VertexId,
    /// Traits of the face of the cavity; of its constraints only whether the edge is, as bit 0.
    pub traits: Traits,
    pub region: u32,
}

impl Rim {
    #[inline]
    pub fn is_constrained(&self) -> bool {
        self.traits.is_constrained(0)
    }
}

impl Cavity {
    /// Finds the cavity of `p`, beginning at face `t`, which must be in conflict.
    pub fn dig(&mut self, canvas: &Canvas, t: TriangleId, p: Point) {
        self.faces.clear();
        self.rim.clear();
        self.faces.push(t);
        let [a, b, c] = t.half_edges();
        self.stack.extend([c, b, a]);
        self.explore(canvas, p);
    }

    /// Finds the cavity of `p`, which lies on the edge of `h` or so near to it that both its faces are
    /// in conflict, and which will split this edge.
    pub fn dig_both(&mut self, canvas: &Canvas, h: HalfEdgeId, p: Point) {
        self.faces.clear();
        self.rim.clear();
        let g = canvas.mesh.twin(h);
        self.faces.extend([h.triangle(), g.triangle()]);
        self.stack.extend([g.prev(), g.next(), h.prev(), h.next()]);
        self.explore(canvas, p);
    }

    /// Goes on from the half-edges on the stack.
    #[inline]
    fn explore(&mut self, canvas: &Canvas, p: Point) {
        while let Some(h) = self.stack.pop() {
            let outer = canvas.mesh.twin(h);
            let traits = canvas.traits(h.triangle());
            let is_constrained = traits.is_constrained(h.slot());
            if !is_constrained && canvas.conflicts(outer.triangle(), p) {
                self.faces.push(outer.triangle());
                self.stack.push(outer.prev());
                self.stack.push(outer.next());
            } else {
                self.rim.push(Rim {
                    outer,
                    origin: canvas.mesh.origin(h),
                    traits: Traits(traits.0 & Traits::OUTSIDE | u8::from(is_constrained)),
                    region: canvas.region(h.triangle()),
                });
            }
        }
    }

    /// Fills the cavity with triangles around vertex `v`. Afterwards `faces[i]` is the one upon `rim[i]`:
    /// its corners are v and the ends of that edge.
    ///
    /// *Ids invalidated*: all half-edges in the cavity.
    pub fn fill(&mut self, canvas: &mut Canvas, v: VertexId) {
        while self.faces.len() < self.rim.len() {
            self.faces.push(canvas.push_face());
        }
        debug_assert_eq!(
            self.faces.len(),
            self.rim.len(),
            "bug: a cavity with vertices in it"
        );
        let n = self.rim.len();
        let mut before = self.faces[n - 1].half_edges()[1];
        for (i, (&t, rim)) in self.faces.iter().zip(&self.rim).enumerate() {
            let dest = self.rim[if i + 1 == n { 0 } else { i + 1 }].origin;
            let [base, incoming, outgoing] = t.half_edges();
            canvas.mesh.replace_face(t, [v, rim.origin, dest]);
            canvas.mesh.bond(base, rim.outer);
            canvas.mesh.bond(outgoing, before);
            canvas.traits[t.index()] = rim.traits;
            if let Some(region) = canvas.region_of.get_mut(t.index()) {
                *region = rim.region;
            }
            before = incoming;
        }
    }
}
