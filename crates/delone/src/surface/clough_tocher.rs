//! The smooth surface of cubics.
//!
//! Every triangle is split at its centroid S into three, with a cubic over each (Clough and Tocher
//! 1965). Ordinates of the Bézier net of the part over Vᵢ Vⱼ S, from values and gradients at the corners:
//!
//! ```text
//!                 Vk
//!                /|\           on the edge:  iii = fᵢ,  iij = fᵢ + gᵢ·(Vⱼ − Vᵢ)/3, …
//!               / | \          spoke:        iis = (iii + iij + iik)/3, in one plane
//!              /  S  \         within:       ijs, such that the derivative across the edge is linear along it
//!             / ·   · \        centre:       iss = (iis + ijs + iks)/3,  sss = (iss + jss + kss)/3
//!            Vi ─────── Vj
//! ```
//!
//! The derivative perpendicular to an edge, linear along it, is determined by its ends, so neighbours
//! agree on it: the surface is continuously differentiable. Quadratics come back if gradients are
//! theirs.

use super::ground::Spot;
use super::interpolant::{linear_shares, share_gradients, slope, value_at};
use super::number::dot;
use super::{Cursor, Gradients, Interpolant, Jet, Samples};
use crate::{Error, Point, TriangleId};

/// The smooth surface of cubics, three to a triangle (Clough and Tocher 1965), with given or estimated
/// gradients at the vertices.
///
/// Continuously differentiable within the ground, across segments, too. Where numbers overflow, the value is that of
/// [`Linear`](super::Linear).
///
/// ```
/// use delone::surface::{CloughTocher, Estimate, Gradients, Interpolant, Samples};
/// let t = delone::triangulate([(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0), (1.0, 1.0)])?;
/// let samples = Samples::new(&t, [0.0, 0.0, 0.0, 0.0, 8.0])?;
/// let gradients = Gradients::estimate(&samples, Estimate::LeastBending, &())?;
/// let surface = CloughTocher::new(&samples, &gradients)?;
/// assert_eq!(surface.value((1.0, 1.0).into()), Some(8.0));
/// let top = surface.value_and_gradient((1.0, 1.0).into()).expect("inside");
/// assert!(top.gradient.iter().all(|slope| slope.abs() < 1e-4)); // a round hill top
/// # Ok::<(), delone::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct CloughTocher<'a> {
    samples: &'a Samples<'a>,
    gradients: &'a Gradients,
}

impl<'a> CloughTocher<'a> {
    /// Makes the surface.
    ///
    /// # Errors
    /// [`Error::ValuesMissing`] unless there is a gradient for each point.
    pub fn new(samples: &'a Samples<'a>, gradients: &'a Gradients) -> Result<Self, Error> {
        gradients.require_for(samples)?;
        Ok(Self { samples, gradients })
    }

    /// Evaluates at shares of the corners of triangle `t`.
    fn jet(&self, t: TriangleId, shares: [f64; 3]) -> Jet {
        let ground = self.samples.ground();
        let corners = ground.mesh().corners(t);
        let points = ground.corners(t);
        let values = corners.map(|v| self.samples.value(v));
        let gradients = corners.map(|v| self.gradients.at(v));
        let net = Net::new(points, values, gradients);
        let (value, changes) = net.evaluate(shares);
        let directions = share_gradients(points);
        let gradient = [0, 1].map(|axis| {
            // Changes are relative to the first share: a common part has no effect, for shares sum to 1.
            let [a, b] = [1, 2].map(|k| (changes[k] - changes[0]) * directions[k][axis]);
            a + b
        });
        Jet { value, gradient }
    }
}

impl Interpolant for CloughTocher<'_> {
    fn value_near(&self, p: Point, cursor: &mut Cursor) -> Option<f64> {
        self.jet_near(p, cursor).map(|jet| jet.value)
    }

    fn jet_near(&self, p: Point, cursor: &mut Cursor) -> Option<Jet> {
        let ground = self.samples.ground();
        let place = ground.place(p, &mut cursor.near)?;
        if let Spot::Vertex(v) = place.spot {
            return Some(Jet {
                value: self.samples.value(v),
                gradient: self.gradients.at(v),
            });
        }
        let shares = linear_shares(&ground, place, p).map(|(_, share)| share);
        let mut jet = self.jet(place.triangle, shares);
        if !jet.value.is_finite() {
            jet.value = value_at(self.samples, place, p);
        }
        if !jet.gradient.iter().all(|c| c.is_finite()) {
            jet.gradient = slope(self.samples, place.triangle);
        }
        Some(jet)
    }
}

/// The Bézier ordinates over one triangle. Edge k lies opposite corner k and runs from corner k + 1 to
/// corner k + 2.
struct Net {
    values: [f64; 3],
    /// On edge k, a third from its start and a third from its end.
    edges: [[f64; 2]; 3],
    /// A third from corner k to the centre, and two thirds.
    spokes: [[f64; 2]; 3],
    /// Within the part along edge k.
    within: [f64; 3],
    center: f64,
}

impl Net {
    fn new(points: [Point; 3], values: [f64; 3], gradients: [[f64; 2]; 3]) -> Self {
        let vector = |from: usize, to: usize| {
            let [a, b] = [points[from], points[to]];
            [b.x - a.x, b.y - a.y]
        };
        let near =
            |from: usize, to: usize| values[from] + dot(gradients[from], vector(from, to)) / 3.0;
        let edges = [0, 1, 2].map(|k| {
            let [i, j] = ends(k);
            [near(i, j), near(j, i)]
        });
        let first = [0, 1, 2].map(|k| {
            let [i, j] = ends(k);
            (values[k] + near(k, i) + near(k, j)) / 3.0
        });
        let within = [0, 1, 2].map(|k| {
            let [i, j] = ends(k);
            let [iij, ijj] = edges[k];
            let foot = foot(vector(i, j), vector(i, k));
            let bend = [values[i] + ijj - 2.0 * iij, iij + values[j] - 2.0 * ijj];
            (first[i] + first[j] - (1.0 - foot) * bend[0] - foot * bend[1]) / 2.0
        });
        let second = [0, 1, 2].map(|k| {
            let [i, j] = ends(k);
            (first[k] + within[i] + within[j]) / 3.0
        });
        Self {
            values,
            edges,
            spokes: [0, 1, 2].map(|k| [first[k], second[k]]),
            within,
            center: second.iter().sum::<f64>() / 3.0,
        }
    }

    /// Returns the value, and its change by each of the three shares.
    ///
    /// The smallest share tells the part; there, by de Casteljau's algorithm.
    fn evaluate(&self, shares: [f64; 3]) -> (f64, [f64; 3]) {
        let k = smallest(shares);
        let [i, j] = ends(k);
        let [u, v, w] = [
            shares[i] - shares[k],
            shares[j] - shares[k],
            3.0 * shares[k],
        ];
        let ([iij, ijj], [iis, iss], [jjs, jss]) = (self.edges[k], self.spokes[i], self.spokes[j]);
        let [iii, jjj, ijs, sss] = [self.values[i], self.values[j], self.within[k], self.center];
        let mix = |a: f64, b: f64, c: f64| u * a + v * b + w * c;
        let [ii, ij, is] = [mix(iii, iij, iis), mix(iij, ijj, ijs), mix(iis, ijs, iss)];
        let [jj, js, ss] = [mix(ijj, jjj, jjs), mix(ijs, jjs, jss), mix(iss, jss, sss)];
        let [a, b, c] = [mix(ii, ij, is), mix(ij, jj, js), mix(is, js, ss)];
        let mut changes = [0.0; 3];
        changes[i] = 3.0 * a;
        changes[j] = 3.0 * b;
        // The share of corner k counts three times for the centre, and once against i and j.
        changes[k] = 3.0 * (3.0 * c - a - b);
        (mix(a, b, c), changes)
    }
}

/// Returns the ends of edge k.
fn ends(k: usize) -> [usize; 2] {
    [(k + 1) % 3, (k + 2) % 3]
}

/// Tells how far along an edge the foot of the perpendicular from the centroid lies.
fn foot(edge: [f64; 2], to_apex: [f64; 2]) -> f64 {
    let size = edge[0].abs().max(edge[1].abs());
    let unit = edge.map(|c| c / size);
    let along = dot(unit, to_apex) / size / dot(unit, unit);
    // The centroid is the mean of the ends, at 0 and at 1, and the apex.
    (1.0 + along) / 3.0
}

fn smallest(shares: [f64; 3]) -> usize {
    let [a, b, c] = shares;
    if a <= b && a <= c {
        0
    } else if b <= c {
        1
    } else {
        2
    }
}
