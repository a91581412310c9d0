//! Points of any dimension with weights, at a size at which squares neither overflow nor vanish.

use crate::order::{exponent, split_power};
use crate::{Error, VertexId};
use std::borrow::Cow;

/// Numbers between 2^−300 and 2^300 are taken as they are.
const ORDINARY: i32 = 300;

/// Points as rows of coordinates, and their weights. The dimension is `D` if the compiler is to know it, which is
/// twice as fast; otherwise `D` is 0.
pub(super) struct Rows<'a, const D: usize> {
    dim: usize,
    coordinates: Cow<'a, [f64]>,
    /// What coordinates were multiplied with, as a power of two.
    power: i32,
    weights: Option<Cow<'a, [f64]>>,
    /// What weights were multiplied with, as a power of two.
    weight_power: i32,
}

impl<'a, const D: usize> Rows<'a, D> {
    /// Checks coordinates and weights, and brings them to an ordinary size.
    pub fn new(
        coordinates: &'a [f64],
        dim: usize,
        weights: Option<&'a [f64]>,
    ) -> Result<Self, Error> {
        debug_assert!(D == 0 || D == dim);
        check(coordinates, dim)?;
        if let Some(weights) = weights {
            check_weights(weights, coordinates.len() / dim)?;
        }
        let (coordinates, power) = ordinary(coordinates);
        let weights = weights.map(ordinary);
        let weight_power = weights.as_ref().map_or(0, |(_, power)| *power);
        Ok(Self {
            dim,
            coordinates,
            power,
            weights: weights.map(|(weights, _)| weights),
            weight_power,
        })
    }

    #[inline]
    pub fn dim(&self) -> usize {
        if D == 0 { self.dim } else { D }
    }

    pub fn len(&self) -> usize {
        self.coordinates.len() / self.dim
    }

    /// Returns the coordinates of a point.
    #[inline]
    pub fn row(&self, point: u32) -> &[f64] {
        let dim = self.dim();
        &self.coordinates[point as usize * dim..][..dim]
    }

    #[inline]
    pub fn weight(&self, point: u32) -> f64 {
        self.weights.as_ref().map_or(1.0, |w| w[point as usize])
    }

    /// Returns coordinates at the size at which they were given.
    pub fn given(&self, coordinates: &[f64]) -> Vec<f64> {
        times_power(coordinates, -self.power).collect()
    }

    /// Returns a square of a distance at the size at which coordinates were given.
    pub fn given_square(&self, square: f64) -> f64 {
        let [a, b] = split_power(-self.power);
        square * a * b * a * b
    }

    /// Returns a sum of weights at the size at which these were given.
    pub fn given_weight(&self, weight: f64) -> f64 {
        let [a, b] = split_power(-self.weight_power);
        weight * a * b
    }
}

/// Returns the square of the distance of two points, rounded: the one number that decides what is nearest.
#[inline]
pub(super) fn square(a: &[f64], b: &[f64]) -> f64 {
    let squares = a.iter().zip(b).map(|(a, b)| (a - b) * (a - b));
    squares.fold(0.0, |sum, square| sum + square)
}

/// Returns a number such that a center is no nearer to a point than the point's own is, and does not even round to
/// as near, if the square of the distance of both centers is larger; `own` is the square of the point's distance
/// from its own.
///
/// Let p be that distance, c that of the centers. The other one is at least c − p away, which is more than p if
/// c > 2p. Squares are rounded, by a relative error below ρ = (dim + 3)·2⁻⁵³, and one below dim·2⁻¹⁰⁷³ where they
/// underflow. If what is computed for c² is more than 4(1 + 16ρ)p² + τ, then c² > 4(1 + 12ρ)p² + τ/4, and
/// (c − p)² − p² = c(c² − 4p²)/(c + 2p) ≥ (c² − 4p²)/2 is more than 24ρp² + τ/8: more than rounding takes away.
#[inline]
pub(super) fn reach(own: f64, dim: usize) -> f64 {
    let rounding = (dim as f64 + 3.0) * (f64::EPSILON / 2.0);
    4.0 * own * (1.0 + 16.0 * rounding) + 1e-290
}

/// Checks that coordinates are finite, and rows as long as they should be.
fn check(coordinates: &[f64], dim: usize) -> Result<(), Error> {
    let given = coordinates.len();
    if dim == 0 || !given.is_multiple_of(dim) {
        let wrong = |what, given: usize, must| Error::BadChoice {
            what,
            given: given as f64,
            must,
        };
        return Err(match dim {
            0 => wrong("the dimension of points", dim, "it must be at least 1"),
            _ => wrong(
                "the number of coordinates",
                given,
                "it must be a multiple of the dimension",
            ),
        });
    }
    let (given, limit) = (given / dim, u32::MAX as usize);
    if given > limit {
        return Err(Error::TooManyPoints { given, limit });
    }
    match coordinates.iter().position(|x| !x.is_finite()) {
        Some(i) => Err(Error::ValueNotFinite {
            vertex: VertexId::new(i / dim),
            given: coordinates[i],
            what: "coordinate",
        }),
        None => Ok(()),
    }
}

/// Checks that there is a positive weight for each point.
fn check_weights(weights: &[f64], expected: usize) -> Result<(), Error> {
    let given = weights.len();
    if given != expected {
        return Err(Error::ValuesMissing {
            given,
            expected,
            what: "weights",
        });
    }
    let is_good = |w: f64| w > 0.0 && w < f64::INFINITY;
    match weights.iter().position(|&w| !is_good(w)) {
        Some(index) => Err(Error::WeightNotPositive {
            index,
            weight: weights[index],
        }),
        None => Ok(()),
    }
}

/// Returns numbers multiplied with a power of two such that the largest is of ordinary size, and that power.
fn ordinary(numbers: &[f64]) -> (Cow<'_, [f64]>, i32) {
    let largest = numbers.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
    let size = exponent(largest);
    if largest == 0.0 || (-ORDINARY..=ORDINARY).contains(&size) {
        return (numbers.into(), 0);
    }
    (times_power(numbers, -size).collect(), -size)
}

fn times_power(numbers: &[f64], power: i32) -> impl Iterator<Item = f64> + '_ {
    let [a, b] = split_power(power);
    numbers.iter().map(move |x| x * a * b)
}
