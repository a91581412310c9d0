//! The mesh while it is refined: points, faces, and what is known of each.

use crate::predicates::{Orientation, in_circle_perturbed, is_between, orient2d};
use crate::{HalfEdgeId, Mesh, Point, TriangleId, VertexId};

/// A constrained Delaunay triangulation that vertices go into, carved faces and ghosts included.
pub(super) struct Canvas {
    pub points: Vec<Point>,
    pub mesh: Mesh,
    /// What is known of each face.
    pub traits: Vec<Traits>,
    /// For each face one more than its region, or 0; empty if there are no regions.
    pub region_of: Vec<u32>,
    /// Coordinates are those of the input times this power of two.
    pub scale: f64,
}

/// No two vertices come closer than this many units in the last place: 2¹⁰ of them, as a fraction of the
/// larger coordinate.
const CLOSEST: f64 = 1024.0 * f64::EPSILON;

/// Nor closer than this, 2⁻²⁵⁰, so that squares of distances do not vanish.
const CLOSEST_OF_ALL: f64 = f64::from_bits((1023 - 250) << 52);

/// What is known of a face: bit k says that its half-edge k is constrained.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Traits(pub u8);

impl Traits {
    /// The face does not belong to the domain.
    pub const OUTSIDE: u8 = 1 << 3;
    /// The face waits in the queue because of its smallest angle.
    pub const SKINNY: u8 = 1 << 4;
    const EDGES: u8 = 0b111;

    #[inline]
    pub fn is_outside(self) -> bool {
        self.0 & Self::OUTSIDE != 0
    }

    #[inline]
    pub fn is_skinny(self) -> bool {
        self.0 & Self::SKINNY != 0
    }

    #[inline]
    pub fn is_constrained(self, slot: usize) -> bool {
        self.0 >> slot & 1 != 0
    }

    /// Tells whether any edge of the face is constrained.
    #[inline]
    pub fn has_constraint(self) -> bool {
        self.0 & Self::EDGES != 0
    }
}

impl Canvas {
    #[inline]
    pub fn point(&self, v: VertexId) -> Point {
        self.points[v.index()]
    }

    /// Returns the corners of a triangle, counter-clockwise.
    #[inline]
    pub fn triangle(&self, t: TriangleId) -> [Point; 3] {
        self.mesh.corners(t).map(|v| self.point(v))
    }

    #[inline]
    pub fn traits(&self, t: TriangleId) -> Traits {
        self.traits[t.index()]
    }

    #[inline]
    pub fn is_constrained(&self, h: HalfEdgeId) -> bool {
        self.traits(h.triangle()).is_constrained(h.slot())
    }

    #[inline]
    pub fn is_outside(&self, h: HalfEdgeId) -> bool {
        self.traits(h.triangle()).is_outside()
    }

    #[inline]
    pub fn ends(&self, h: HalfEdgeId) -> [VertexId; 2] {
        [self.mesh.origin(h), self.mesh.dest(h)]
    }

    /// Constrains the half-edge `h`, or sets it free; its twin is the caller's business.
    #[inline]
    pub fn set_constrained(&mut self, h: HalfEdgeId, is_constrained: bool) {
        let traits = &mut self.traits[h.triangle().index()].0;
        *traits = *traits & !(1 << h.slot()) | u8::from(is_constrained) << h.slot();
    }

    #[inline]
    pub fn set_skinny(&mut self, t: TriangleId, is_skinny: bool) {
        let traits = &mut self.traits[t.index()].0;
        *traits = *traits & !Traits::SKINNY | (u8::from(is_skinny) * Traits::SKINNY);
    }

    #[inline]
    pub fn region(&self, t: TriangleId) -> u32 {
        self.region_of.get(t.index()).copied().unwrap_or(0)
    }

    /// Tells whether face `t` has to go if `p` comes: its circle, under the perturbation, contains `p`.
    #[inline]
    pub fn conflicts(&self, t: TriangleId, p: Point) -> bool {
        let [a, b, c] = self.mesh.corners(t);
        if a.is_infinite() || b.is_infinite() || c.is_infinite() {
            return self.ghost_conflicts(t, p);
        }
        in_circle_perturbed(self.point(a), self.point(b), self.point(c), p)
    }

    /// A ghost has to go if `p` lies beyond its edge of the hull, or upon it.
    #[cold]
    fn ghost_conflicts(&self, t: TriangleId, p: Point) -> bool {
        // The edge has the hull to its right.
        let h = self.mesh.hull_edge_of(t);
        let [a, b] = self.ends(h).map(|v| self.point(v));
        match orient2d(a, b, p) {
            Orientation::Left => true,
            Orientation::Right => false,
            Orientation::Collinear => is_between(a, b, p),
        }
    }

    /// Returns how close to `p` another vertex may be added.
    #[inline]
    pub fn closest(&self, p: Point) -> f64 {
        let of_grid = CLOSEST_OF_ALL.max(1024.0 * f64::from_bits(1) * self.scale);
        (CLOSEST * p.x.abs().max(p.y.abs())).max(of_grid)
    }

    /// Returns the place next to `p` that the input's coordinates have a number for; −0.0 becomes 0.0.
    #[inline]
    pub fn placed(&self, p: Point) -> Point {
        let place = |c: f64| match self.scale > 1.0 {
            true => c / self.scale * self.scale + 0.0,
            false => c + 0.0,
        };
        Point::new(place(p.x), place(p.y))
    }

    /// Appends a face, whose corners and twins are still to be set.
    pub fn push_face(&mut self) -> TriangleId {
        self.traits.push(Traits(0));
        if !self.region_of.is_empty() {
            self.region_of.push(0);
        }
        self.mesh.push_face([VertexId::INFINITE; 3])
    }
}
