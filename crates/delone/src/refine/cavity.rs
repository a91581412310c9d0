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
//!
//! All arithmetic is relative to the point. An edge that the search comes to brings its ends along, and
//! their cross product; of the face beyond only the apex is new, and the two cross products with it
//! serve its in-circle test, then its edges, and in the end whoever wants to know what triangles the
//! rim would make with the point.

use super::canvas::{Canvas, Traits};
use crate::predicates::in_circle_relative;
use crate::{HalfEdgeId, Point, TriangleId, VertexId};

/// Faces in conflict with a point, and the edges around them.
#[derive(Clone, Debug, Default)]
pub(super) struct Cavity {
    pub faces: Vec<TriangleId>,
    /// Counter-clockwise.
    pub rim: Vec<Rim>,
    /// How many of the faces wait because of their smallest angle.
    pub skinny: i32,
    /// Edges of the faces found so far, which bound them clockwise from the last one on.
    stack: Vec<Rim>,
}

/// An edge of the rim, with the cavity to its left.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rim {
    /// Its half-edge in the face beyond, which stays.
    pub outer: HalfEdgeId,
    /// Where it starts.
    pub origin: VertexId,
    /// One more than the region of the face of the cavity, or 0.
    pub region: u32,
    /// Traits of the face of the cavity; of its constraints only whether the edge is, as bit 0.
    pub traits: Traits,
    /// The origin as the point sees it.
    pub from: Sight,
    /// The cross product of origin and destination, as the point sees them.
    pub cross: f64,
}

/// A vertex relative to a point; not a number if the vertex is infinite.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sight {
    pub x: f64,
    pub y: f64,
    /// The squared distance.
    pub square: f64,
}

impl Sight {
    #[inline]
    fn of(canvas: &Canvas, v: VertexId, p: Point) -> Self {
        let infinite = Point::new(f64::NAN, f64::NAN);
        let q = *canvas.points.get(v.index()).unwrap_or(&infinite);
        let [x, y] = [q.x - p.x, q.y - p.y];
        Self {
            x,
            y,
            square: x * x + y * y,
        }
    }

    #[inline]
    fn cross(self, other: Self) -> f64 {
        self.x * other.y - self.y * other.x
    }
}

impl Rim {
    #[inline]
    pub fn is_constrained(&self) -> bool {
        self.traits.is_constrained(0)
    }

    /// Describes the edge of `h`, in a face with these traits.
    #[inline]
    fn inside(
        canvas: &Canvas,
        h: HalfEdgeId,
        traits: Traits,
        origin: VertexId,
        from: Sight,
        cross: f64,
    ) -> Self {
        let is_constrained = traits.is_constrained(h.slot());
        Self {
            outer: canvas.mesh.twin(h),
            origin,
            region: canvas.region(h.triangle()),
            traits: Traits(traits.0 & Traits::OUTSIDE | u8::from(is_constrained)),
            from,
            cross,
        }
    }
}

impl Cavity {
    /// Finds the cavity of `p`, beginning at face `t`, which must be in conflict.
    pub fn dig(&mut self, canvas: &Canvas, t: TriangleId, p: Point) {
        self.begin(canvas, &[t]);
        let [a, b, c] = t.half_edges();
        self.enclose(canvas, [a, b, c], p);
        self.explore(canvas, p);
    }

    /// Finds the cavity of `p`, which lies on the edge of `h` or so near to it that both its faces are
    /// in conflict, and which will split this edge.
    pub fn dig_both(&mut self, canvas: &Canvas, h: HalfEdgeId, p: Point) {
        let g = canvas.mesh.twin(h);
        self.begin(canvas, &[h.triangle(), g.triangle()]);
        self.enclose(canvas, [h.next(), h.prev(), g.next(), g.prev()], p);
        self.explore(canvas, p);
    }

    fn begin(&mut self, canvas: &Canvas, faces: &[TriangleId]) {
        self.faces.clear();
        self.rim.clear();
        self.faces.extend(faces);
        let skinny = faces.iter().filter(|&&t| canvas.traits(t).is_skinny());
        self.skinny = skinny.count() as i32;
    }

    /// Begins with these half-edges as bounds, counter-clockwise.
    fn enclose<const N: usize>(&mut self, canvas: &Canvas, half_edges: [HalfEdgeId; N], p: Point) {
        let origins = half_edges.map(|h| canvas.mesh.origin(h));
        let sights = origins.map(|v| Sight::of(canvas, v, p));
        for i in (0..N).rev() {
            let h = half_edges[i];
            let traits = canvas.traits(h.triangle());
            let cross = sights[i].cross(sights[(i + 1) % N]);
            let edge = Rim::inside(canvas, h, traits, origins[i], sights[i], cross);
            self.stack.push(edge);
        }
    }

    /// Goes on from the edges on the stack.
    #[inline]
    fn explore(&mut self, canvas: &Canvas, p: Point) {
        // Where the last edge on the stack ends.
        let start = self.stack[self.stack.len() - 1].from;
        while let Some(edge) = self.stack.pop() {
            if edge.is_constrained() {
                self.rim.push(edge);
                continue;
            }
            let [a, b] = [edge.from, self.stack.last().map_or(start, |next| next.from)];
            let t = edge.outer.triangle();
            let apex = canvas.mesh.apex(edge.outer);
            let c = Sight::of(canvas, apex, p);
            let [ac, cb] = [a.cross(c), c.cross(b)];
            let side = in_circle_relative([b.square, a.square, c.square], [ac, cb, -edge.cross]);
            let conflicts = match side {
                Some(side) => side.is_gt(),
                None => canvas.conflicts(t, p),
            };
            if !conflicts {
                self.rim.push(edge);
                continue;
            }
            let traits = canvas.traits(t);
            self.faces.push(t);
            self.skinny += i32::from(traits.is_skinny());
            let [next, previous] = [edge.outer.next(), edge.outer.prev()];
            let far = Rim::inside(canvas, previous, traits, apex, c, cb);
            let near = Rim::inside(canvas, next, traits, edge.origin, a, ac);
            self.stack.extend([far, near]);
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
