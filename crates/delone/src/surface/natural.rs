//! Natural neighbours: whose cells a point would take a part of, and how much of it.
//!
//! Insert a point p, in thought only. With its neighbours v₀, v₁ … counter-clockwise, the
//! circumcentres cᵢ of p vᵢ vᵢ₊₁ are the corners of its Voronoi cell, and those of the triangles that
//! it would destroy are corners of the cells as they are.
//!
//! - *Sibson* weighs vᵢ by the area that p takes from its cell (Sibson 1980). The signed areas are
//!   summed along the edges of the pieces: those of the new cell, those between rim and old
//!   circumcentres, and the old Voronoi edges (as Watson 1992 does along triangles; along pieces no
//!   edge within the cavity needs a circle with p, with which it may be collinear). The gradient of an
//!   area is that of its only side that moves, |cᵢ₋₁cᵢ|/|p vᵢ| · ((cᵢ₋₁ + cᵢ)/2 − p) (Piper 1993).
//! - *Laplace* (non-Sibsonian, Belikov et al. 1997; Hiyoshi and Sugihara 2000) weighs it by the length
//!   of the side that their cells share, over their distance: half the cotangents of the two angles
//!   that see p vᵢ.
//!
//! Both sum to 1, are never negative, and give p back as the mean of its neighbours: linear functions
//! are reproduced. Where `f64` is not enough, near flat triangles at the hull mostly, weights are computed
//! again with twice the bits: where determinants or sums cancel by more than [`MOST_CANCELLED`], or the
//! last law is missed by more than 2⁻⁴⁰. Where even those miss it (p within 10⁻²⁰ of an edge of the hull,
//! say) the linear weights of the triangle are taken, to which both tend there.
//!
//! In a domain, neighbours are those of the *constrained* Delaunay triangulation with p: nobody takes
//! anything through a segment. All laws but one hold there too: behind the end of a segment, a weight
//! of Sibson may be negative.

use super::cavity::Cavity;
use super::ground::{Place, Spot};
use super::interpolant::linear_shares;
use super::number::{Frame, Number, Vector, cross, cross_gross, dot, minus, plus};
use super::{Cursor, Ground};
use crate::predicates::{Double, in_circle_perturbed};
use crate::{Error, HalfEdgeId, Point, TriangleId, VertexId};

/// How many times larger than a determinant or a sum its terms may be in `f64`: ten bits.
const MOST_CANCELLED: f64 = 1024.0;

/// How neighbours are weighed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Weighing {
    /// By the area that the point would take from their Voronoi cells: smooth except at vertices.
    #[default]
    Sibson,
    /// By the side that their cells would share, over the distance: continuous, with bends at
    /// circumcircles, and faster.
    Laplace,
}

/// Neighbours with their weights, in `Scratch` while a question is answered.
#[derive(Clone, Debug, Default)]
pub(super) struct Scratch {
    cavity: Cavity,
    plain: Room<f64>,
    pub weights: Weights,
}

/// A vertex, its weight, and the gradient of the weight where asked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Weight {
    pub vertex: VertexId,
    pub share: f64,
    pub gradient: [f64; 2],
}

pub(super) type Weights = Vec<Weight>;

/// The natural neighbours of any point.
///
/// ```
/// use delone::surface::{NaturalNeighbors, Weighing};
/// let corners = [(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)];
/// let t = delone::triangulate(corners)?;
/// let neighbors = NaturalNeighbors::new(&t)?;
/// let weights = neighbors.weights((1.0, 1.0).into(), Weighing::Sibson).expect("inside");
/// assert!(weights.iter().all(|(_, weight)| *weight == 0.25));
/// assert_eq!(weights.len(), 4);
/// # Ok::<(), delone::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct NaturalNeighbors<'t> {
    ground: Ground<'t>,
}

impl<'t> NaturalNeighbors<'t> {
    /// Makes sure that every edge is locally Delaunay, or a constraint or border.
    ///
    /// # Errors
    /// [`Error::NotDelaunay`] names an edge that is not: the triangles of a domain need their
    /// constraints.
    ///
    /// *Cost*: one in-circle test an edge.
    pub fn new(ground: impl Into<Ground<'t>>) -> Result<Self, Error> {
        let ground = ground.into();
        let mesh = ground.mesh();
        let half_edges = (0..3 * ground.triangulation().num_triangles()).map(HalfEdgeId::new);
        for h in half_edges {
            let twin = mesh.twin(h);
            if h < twin && !ground.is_wall(h) {
                let [a, b, c] = ground.corners(h.triangle());
                if in_circle_perturbed(a, b, c, ground.triangulation().point(mesh.apex(twin))) {
                    let edge = [mesh.origin(h), mesh.dest(h)];
                    return Err(Error::NotDelaunay { edge });
                }
            }
        }
        Ok(Self { ground })
    }

    /// Returns what the neighbours are sought in.
    pub fn ground(&self) -> Ground<'t> {
        self.ground
    }

    /// Returns the neighbours of a point with their weights, counter-clockwise; `None` outside.
    ///
    /// The weights sum to 1 up to rounding. A vertex is its own and only neighbour; on the border, and
    /// on a segment, the two ends of the edge are.
    ///
    /// *Cost*: a walk from far away, and some 50 ns for each neighbour.
    pub fn weights(&self, p: Point, weighing: Weighing) -> Option<Vec<(VertexId, f64)>> {
        self.weights_near(p, weighing, &mut Cursor::default())
    }

    /// As [`weights`](Self::weights), beginning at the cursor.
    pub fn weights_near(
        &self,
        p: Point,
        weighing: Weighing,
        cursor: &mut Cursor,
    ) -> Option<Vec<(VertexId, f64)>> {
        self.find(p, weighing, false, cursor)?;
        let weights = cursor.scratch.weights.iter();
        Some(weights.map(|w| (w.vertex, w.share)).collect())
    }

    /// Leaves the weights of `p` in the cursor. Their gradients are found if asked for, and if there are
    /// any: `true` then.
    pub(super) fn find(
        &self,
        p: Point,
        weighing: Weighing,
        with_gradients: bool,
        cursor: &mut Cursor,
    ) -> Option<(Place, bool)> {
        let place = self.ground.place(p, &mut cursor.near)?;
        let scratch = &mut cursor.scratch;
        let is_within = match place.spot {
            Spot::Vertex(_) => false,
            Spot::Edge(h) => !self.ground.is_wall(h),
            Spot::Face => true,
        };
        if is_within && scratch.weigh(&self.ground, p, place.triangle, weighing, with_gradients) {
            return Some((place, true));
        }
        scratch.weights.clear();
        let shares = linear_shares(&self.ground, place, p).into_iter();
        let shares = shares.filter(|(_, share)| *share > 0.0);
        scratch.weights.extend(shares.map(|(vertex, share)| Weight {
            vertex,
            share,
            gradient: [0.0; 2],
        }));
        Some((place, false))
    }
}

impl Scratch {
    /// Finds the weights of `p` in the interior of `triangle` or of an edge of it; false if even double
    /// precision does not suffice.
    fn weigh(
        &mut self,
        ground: &Ground<'_>,
        p: Point,
        triangle: TriangleId,
        weighing: Weighing,
        with_gradients: bool,
    ) -> bool {
        let Self {
            cavity,
            plain,
            weights,
        } = self;
        cavity.dig(ground, p, triangle);
        let points = ground.triangulation().points();
        let rim = cavity.rim.iter().map(|rim| points[rim.vertex.index()]);
        let frame = Frame::alike(p, rim);
        let job = Job {
            ground,
            cavity,
            frame,
            weighing,
            with_gradients,
        };
        job.run(plain, weights) || job.run(&mut Room::<Double>::default(), weights)
    }
}

/// Vectors from p, all in the scale of the frame.
#[derive(Clone, Debug)]
struct Room<N> {
    /// To the vertices of the rim.
    rim: Vec<Vector<N>>,
    /// From each vertex of the rim to the next.
    along: Vec<Vector<N>>,
    /// To the circumcentres with the edges of the rim.
    outer: Vec<Vector<N>>,
    /// To the circumcentres of the cavity's triangles.
    inner: Vec<Vector<N>>,
    /// The weights before they are divided by their sum, and their gradients.
    raw: Vec<(N, Vector<N>)>,
    /// Whether some determinant has cancelled too much.
    is_flat: bool,
    /// The magnitudes of the terms of all weights.
    gross: f64,
}

impl<N> Default for Room<N> {
    fn default() -> Self {
        Self {
            rim: Vec::new(),
            along: Vec::new(),
            outer: Vec::new(),
            inner: Vec::new(),
            raw: Vec::new(),
            is_flat: false,
            gross: 0.0,
        }
    }
}

struct Job<'a> {
    ground: &'a Ground<'a>,
    cavity: &'a Cavity,
    frame: Frame,
    weighing: Weighing,
    with_gradients: bool,
}

impl Job<'_> {
    /// Computes the weights; false if they are not what they must be.
    fn run<N: Number>(&self, room: &mut Room<N>, weights: &mut Weights) -> bool {
        self.look_around(room);
        match self.weighing {
            Weighing::Sibson => self.sibson(room),
            Weighing::Laplace => self.laplace(room),
        }
        let sum = self.share_out(&room.raw, weights);
        let is_precise = !room.is_flat && room.gross < MOST_CANCELLED * sum;
        (N::IS_WIDE || is_precise) && is_mean(&room.rim, weights)
    }

    /// Clears the room and finds the vectors to and along the rim.
    fn look_around<N: Number>(&self, room: &mut Room<N>) {
        let points = self.ground.triangulation().points();
        let rim = &self.cavity.rim;
        let at = |i: usize| points[rim[i % rim.len()].vertex.index()];
        room.rim.clear();
        room.along.clear();
        for i in 0..rim.len() {
            room.rim.push(self.frame.vector(at(i)));
            room.along.push(self.frame.between(at(i), at(i + 1)));
        }
        room.raw.clear();
        room.raw.resize(rim.len(), (N::ZERO, [N::ZERO; 2]));
        room.is_flat = false;
        room.gross = 0.0;
    }

    /// Sums up twice the areas that the point takes from the cells of its neighbours.
    fn sibson<N: Number>(&self, room: &mut Room<N>) {
        self.place_centers(room);
        let Room {
            rim,
            outer,
            inner,
            raw,
            gross,
            ..
        } = room;
        let n = rim.len();
        for i in 0..n {
            let (next, before) = ((i + 1) % n, (i + n - 1) % n);
            let side = cross_gross(outer[before], outer[i], gross);
            let spoke = cross_gross(outer[i], inner[self.cavity.rim[i].inner], gross);
            raw[i].0 = raw[i].0.add(side).add(spoke);
            raw[next].0 = raw[next].0.sub(spoke);
            if self.with_gradients {
                let along = minus(outer[i], outer[before]);
                // Twice the area changes with twice the middle.
                let ratio = cross(rim[i], along).div(dot(rim[i], rim[i]));
                let middle = plus(outer[i], outer[before]);
                raw[i].1 = middle.map(|c| c.mul(ratio));
            }
        }
        for link in &self.cavity.links {
            let [left, right] = link.sides.map(|t| inner[t]);
            let edge = cross_gross(right, left, gross);
            let [from, to] = link.ends;
            raw[from].0 = raw[from].0.add(edge);
            raw[to].0 = raw[to].0.sub(edge);
        }
    }

    /// Finds the circumcentres.
    fn place_centers<N: Number>(&self, room: &mut Room<N>) {
        room.outer.clear();
        room.inner.clear();
        for (&u, &d) in room.rim.iter().zip(&room.along) {
            let center = circumcenter(u, d, plus(plus(u, u), d), &mut room.is_flat);
            room.outer.push(center);
        }
        for &t in &self.cavity.triangles {
            let [a, b, c] = self.ground.corners(t);
            let [u, d, v] = [(a, b), (b, c), (a, c)].map(|(p, q)| self.frame.between(p, q));
            let center = circumcenter(u, d, plus(u, v), &mut room.is_flat);
            room.inner.push(plus(self.frame.vector(a), center));
        }
    }

    /// Sums up the cotangents of the angles that see the edges from the point to its neighbours.
    fn laplace<N: Number>(&self, room: &mut Room<N>) {
        let Room {
            rim,
            along,
            raw,
            is_flat,
            gross,
            ..
        } = room;
        let n = rim.len();
        for i in 0..n {
            let next = (i + 1) % n;
            let (a, b, along) = (rim[i], rim[next], along[i]);
            let area = determinant(a, along, is_flat);
            // How the area changes when the point moves.
            let turn = [N::ZERO.sub(along[1]), along[0]];
            let mut add = |of: usize, end: Vector<N>, along: Vector<N>| {
                let cotangent = dot(end, along).div(area);
                *gross += cotangent.value().abs();
                raw[of].0 = raw[of].0.add(cotangent);
                if self.with_gradients {
                    let change = plus(along, turn.map(|t| t.mul(cotangent)));
                    let change = change.map(|c| c.div(area));
                    raw[of].1 = minus(raw[of].1, change);
                }
            };
            add(i, b, along);
            add(next, a, along.map(|c| N::ZERO.sub(c)));
        }
    }

    /// Divides the weights by their sum, which is returned, and brings gradients to units of the
    /// coordinates.
    fn share_out<N: Number>(&self, raw: &[(N, Vector<N>)], weights: &mut Weights) -> f64 {
        let sum = raw.iter().fold(N::ZERO, |sum, (w, _)| sum.add(*w));
        let change = raw
            .iter()
            .fold([N::ZERO; 2], |sum, (_, gradient)| plus(sum, *gradient));
        let vertices = self.cavity.rim.iter().map(|rim| rim.vertex);
        weights.clear();
        weights.extend(vertices.zip(raw).map(|(vertex, (w, gradient))| {
            let share = w.div(sum);
            let gradient = [0, 1].map(|k| {
                let own = gradient[k].sub(share.mul(change[k])).div(sum);
                own.value() * self.frame.scale[k]
            });
            Weight {
                vertex,
                share: share.value(),
                gradient,
            }
        }));
        sum.value()
    }
}

/// Twice the area between two vectors; notes if that is small beside what it is the difference of.
#[inline(always)]
fn determinant<N: Number>(u: Vector<N>, v: Vector<N>, is_flat: &mut bool) -> N {
    let mut gross = 0.0;
    let area = cross_gross(u, v, &mut gross);
    *is_flat |= area.value().abs() * MOST_CANCELLED < gross;
    area
}

/// Returns the centre of the circle through the origin, `u` and `u + d`; `sum` is 2u + d. If `u` or `d`
/// is short the other may be long: nothing but what is flat cancels.
#[inline(always)]
fn circumcenter<N: Number>(
    u: Vector<N>,
    d: Vector<N>,
    sum: Vector<N>,
    is_flat: &mut bool,
) -> Vector<N> {
    let area = determinant(u, d, is_flat);
    let area = area.add(area);
    let (uu, rest) = (dot(u, u), dot(d, sum));
    [
        d[1].mul(uu).sub(u[1].mul(rest)).div(area),
        u[0].mul(rest).sub(d[0].mul(uu)).div(area),
    ]
}

/// Tells whether the origin is the weighted mean of the vertices of the rim, up to rounding.
fn is_mean<N: Number>(rim: &[Vector<N>], weights: &Weights) -> bool {
    const LEAST: f64 = 1.0 / (1_u64 << 40) as f64;
    let (mut mean, mut size) = ([0.0; 2], 0.0);
    for (v, weight) in rim.iter().zip(weights) {
        for k in 0..2 {
            let term = weight.share * v[k].value();
            mean[k] += term;
            size += term.abs();
        }
    }
    // False for NaN, too.
    mean[0].abs() + mean[1].abs() <= LEAST * size
}
