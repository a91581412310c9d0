//! Surfaces of natural neighbours: the mean of the values around, and Sibson's blend of their tangent
//! planes.

use super::interpolant::slope;
use super::natural::Weight;
use super::number::{blend, dot};
use super::{Cursor, Gradients, Interpolant, Jet, NaturalNeighbors, Samples, Weighing};
use crate::{Error, Point, VertexId};

/// The surface that is the mean of the natural neighbours' values.
///
/// Never above the highest of them, nor below the lowest; linear functions come back. Smooth except at
/// the vertices ([Sibson](Weighing::Sibson)), where it has tips, or except on the circumcircles of triangles
/// ([Laplace](Weighing::Laplace)). At vertices, and on borders and segments, the gradient is that of
/// [`Linear`](super::Linear).
///
/// ```
/// use delone::surface::{Interpolant, NaturalNeighbor, Samples, Weighing};
/// let t = delone::triangulate([(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0), (1.0, 1.0)])?;
/// let samples = Samples::new(&t, [0.0, 0.0, 0.0, 0.0, 8.0])?;
/// let surface = NaturalNeighbor::new(&samples, Weighing::Sibson)?;
/// assert_eq!(surface.value((1.0, 1.0).into()), Some(8.0));
/// assert_eq!(surface.value((1.0, 0.0).into()), Some(0.0));
/// assert!(surface.value((1.0, 0.5).into()).is_some_and(|v| 3.0 < v && v < 5.0));
/// # Ok::<(), delone::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct NaturalNeighbor<'a> {
    samples: &'a Samples<'a>,
    neighbors: NaturalNeighbors<'a>,
    weighing: Weighing,
}

impl<'a> NaturalNeighbor<'a> {
    /// Makes the surface.
    ///
    /// # Errors
    /// [`Error::NotDelaunay`] as [`NaturalNeighbors::new`].
    pub fn new(samples: &'a Samples<'a>, weighing: Weighing) -> Result<Self, Error> {
        Ok(Self {
            samples,
            neighbors: NaturalNeighbors::new(samples.ground())?,
            weighing,
        })
    }
}

/// Returns the mean of the neighbours' values.
fn mean(samples: &Samples<'_>, weights: &[Weight]) -> f64 {
    blend(weights.iter().map(|w| (w.share, samples.value(w.vertex))))
}

impl Interpolant for NaturalNeighbor<'_> {
    fn value_near(&self, p: Point, cursor: &mut Cursor) -> Option<f64> {
        self.neighbors.find(p, self.weighing, false, cursor)?;
        Some(mean(self.samples, &cursor.scratch.weights))
    }

    fn jet_near(&self, p: Point, cursor: &mut Cursor) -> Option<Jet> {
        let (place, is_smooth) = self.neighbors.find(p, self.weighing, true, cursor)?;
        let weights = &cursor.scratch.weights;
        let gradient = match is_smooth {
            true => sum_of_gradients(weights, |v| self.samples.value(v)),
            false => slope(self.samples, place.triangle),
        };
        Some(Jet {
            value: mean(self.samples, weights),
            gradient,
        })
    }
}

/// Returns the gradient of the mean of `value` under weights that change.
fn sum_of_gradients(weights: &[Weight], value: impl Fn(VertexId) -> f64) -> [f64; 2] {
    // The gradients sum to zero; relative to one of the values their sum is rounded less.
    let base = weights.first().map_or(0.0, |w| value(w.vertex));
    weights.iter().fold([0.0; 2], |sum, w| {
        let rise = value(w.vertex) - base;
        [0, 1].map(|k| sum[k] + rise * w.gradient[k])
    })
}

/// Sibson's smooth surface: natural neighbours blend tangent planes, and there are no tips.
///
/// With S the mean of values, ξ that of the tangent planes under weights λᵢ/dᵢ, dᵢ the distances, it
/// is (αS + βξ)/(α + β) with α = Σλᵢdᵢ / Σ(λᵢ/dᵢ) and β = Σλᵢdᵢ² (Sibson 1981). Given true
/// gradients, spherical quadratics a + b·p + c|p|² come back, and linear functions of course. On borders
/// and segments only the ends of the edge count, and the gradient is that of [`Linear`](super::Linear); so
/// it is where numbers overflow.
#[derive(Clone, Copy, Debug)]
pub struct SmoothNaturalNeighbor<'a> {
    samples: &'a Samples<'a>,
    gradients: &'a Gradients,
    neighbors: NaturalNeighbors<'a>,
}

impl<'a> SmoothNaturalNeighbor<'a> {
    /// Makes the surface with the given gradients at vertices.
    ///
    /// # Errors
    /// [`Error::NotDelaunay`] as [`NaturalNeighbors::new`]; [`Error::ValuesMissing`] unless there is a
    /// gradient for each point.
    pub fn new(samples: &'a Samples<'a>, gradients: &'a Gradients) -> Result<Self, Error> {
        gradients.require_for(samples)?;
        Ok(Self {
            samples,
            gradients,
            neighbors: NaturalNeighbors::new(samples.ground())?,
        })
    }

    /// Blends the tangent planes of the neighbours; where numbers overflow, their values.
    fn blend(&self, p: Point, weights: &[Weight]) -> Jet {
        if let [w] = *weights {
            return constant(self.samples.value(w.vertex));
        }
        let mut sums = Sums::default();
        for w in weights {
            let value = self.samples.value(w.vertex);
            let slope = self.gradients.at(w.vertex);
            let v = self.samples.ground().triangulation().point(w.vertex);
            sums.add(w, value, slope, [p.x - v.x, p.y - v.y]);
        }
        let mut jet = sums.blend();
        if !jet.value.is_finite() {
            jet.value = mean(self.samples, weights);
        }
        jet
    }
}

/// The sums of Sibson's formula, each with its gradient.
struct Sums {
    /// Σλz, Σλ/d, Σλd, Σλd², Σ(λ/d)ζ.
    mean: Jet,
    inverse: Jet,
    distance: Jet,
    squared: Jet,
    planes: Jet,
}

impl Default for Sums {
    fn default() -> Self {
        let zero = constant(0.0);
        Self {
            mean: zero,
            inverse: zero,
            distance: zero,
            squared: zero,
            planes: zero,
        }
    }
}

impl Sums {
    /// Adds a neighbour; `from` is the vector from it to the point.
    fn add(&mut self, weight: &Weight, value: f64, slope: [f64; 2], from: [f64; 2]) {
        let share = Jet {
            value: weight.share,
            gradient: weight.gradient,
        };
        let squared = Jet {
            value: dot(from, from),
            gradient: from.map(|c| 2.0 * c),
        };
        let length = squared.value.sqrt();
        let distance = Jet {
            value: length,
            gradient: from.map(|c| c / length),
        };
        let plane = Jet {
            value: value + dot(slope, from),
            gradient: slope,
        };
        let near = quotient(share, distance);
        self.mean = sum(self.mean, product(share, constant(value)));
        self.inverse = sum(self.inverse, near);
        self.distance = sum(self.distance, product(share, distance));
        self.squared = sum(self.squared, product(share, squared));
        self.planes = sum(self.planes, product(near, plane));
    }

    fn blend(self) -> Jet {
        let alpha = quotient(self.distance, self.inverse);
        let beta = self.squared;
        let planes = quotient(self.planes, self.inverse);
        let above = sum(product(alpha, self.mean), product(beta, planes));
        quotient(above, sum(alpha, beta))
    }
}

fn constant(value: f64) -> Jet {
    Jet {
        value,
        gradient: [0.0; 2],
    }
}

fn sum(a: Jet, b: Jet) -> Jet {
    Jet {
        value: a.value + b.value,
        gradient: [0, 1].map(|k| a.gradient[k] + b.gradient[k]),
    }
}

fn product(a: Jet, b: Jet) -> Jet {
    Jet {
        value: a.value * b.value,
        gradient: [0, 1].map(|k| a.gradient[k] * b.value + a.value * b.gradient[k]),
    }
}

fn quotient(a: Jet, b: Jet) -> Jet {
    let value = a.value / b.value;
    Jet {
        value,
        gradient: [0, 1].map(|k| (a.gradient[k] - value * b.gradient[k]) / b.value),
    }
}

impl Interpolant for SmoothNaturalNeighbor<'_> {
    fn value_near(&self, p: Point, cursor: &mut Cursor) -> Option<f64> {
        self.neighbors.find(p, Weighing::Sibson, false, cursor)?;
        Some(self.blend(p, &cursor.scratch.weights).value)
    }

    fn jet_near(&self, p: Point, cursor: &mut Cursor) -> Option<Jet> {
        let (place, is_smooth) = self.neighbors.find(p, Weighing::Sibson, true, cursor)?;
        let mut jet = self.blend(p, &cursor.scratch.weights);
        if let [w] = cursor.scratch.weights[..] {
            jet.gradient = self.gradients.at(w.vertex);
        } else if !is_smooth || !jet.gradient.iter().all(|c| c.is_finite()) {
            jet.gradient = slope(self.samples, place.triangle);
        }
        Some(jet)
    }
}
