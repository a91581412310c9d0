//! The polynomial of one triangle.

use super::around::Rings;
use super::bernstein::{basis, ideal, terms, value};
use super::report::{LocalFit, size};
use super::singular::extremes;
use crate::Point;
use crate::surface::least_squares::{LeastSquares, Row};
use crate::surface::number::signed_shares;

/// Largest ratio of singular values at which enough of the sixteen digits are left: about ten. Far data seen from a
/// narrow triangle exceed it.
const MOST_RATIO: f64 = 1e6;

/// What a fit is made of.
pub(super) struct Task<'a> {
    pub corners: [Point; 3],
    pub data: &'a [Point],
    /// Of the size of 1, about 0.
    pub values: &'a [f64],
    pub max_condition: f64,
    pub max_rings: usize,
}

/// A polynomial, and how it came about.
pub(super) struct Solved {
    /// One for each term of `fit.degree`, in Bernstein's basis.
    pub coefficients: Vec<f64>,
    pub fit: LocalFit,
}

impl Task<'_> {
    /// Fits a polynomial of degree `most`, to data of more and more rings of neighbours; if that will not do, of
    /// lower degree, again with the data of the triangle first. The mean of its own data is the last resort.
    pub fn solve(&self, own: &Rings<'_>, most: usize) -> Solved {
        let tried = (1..=most).rev().find_map(|degree| {
            let mut rings = own.clone();
            (0..=self.max_rings).find_map(|number| {
                let there_is = number == 0 || rings.widen();
                there_is
                    .then(|| self.try_degree(degree, &rings, number))
                    .flatten()
            })
        });
        let mean = || self.try_terms::<1>(0, own, 0);
        tried.or_else(mean).expect("bug: a triangle without data")
    }

    fn try_degree(&self, degree: usize, rings: &Rings<'_>, number: usize) -> Option<Solved> {
        match degree {
            1 => self.try_terms::<3>(degree, rings, number),
            2 => self.try_terms::<6>(degree, rings, number),
            3 => self.try_terms::<10>(degree, rings, number),
            4 => self.try_terms::<15>(degree, rings, number),
            5 => self.try_terms::<21>(degree, rings, number),
            _ => None,
        }
    }

    /// Fits a polynomial of `T` terms, if there are data enough and they determine it well.
    fn try_terms<const T: usize>(
        &self,
        degree: usize,
        rings: &Rings<'_>,
        number: usize,
    ) -> Option<Solved> {
        debug_assert_eq!(T, terms(degree));
        let data = rings.data();
        if data.len() < T {
            return None;
        }
        let shares = data.iter().map(|v| {
            let shares = signed_shares(self.corners, self.data[v.index()]);
            // Makes the terms NaN, but for the constant.
            shares.unwrap_or([f64::NAN; 3])
        });
        let shares: Vec<[f64; 3]> = shares.collect();
        let rows = shares.iter().zip(data).map(|(&shares, v)| Row {
            terms: basis::<T>(degree, shares),
            value: self.values[v.index()],
        });
        let mut equations = LeastSquares {
            rows: rows.collect(),
        };
        let diagonal = equations.reduce(T);
        let [largest, least] = extremes(equations.triangle(diagonal))?;
        let condition = (data.len() as f64).sqrt() / least / ideal(degree);
        // False for NaN, too.
        let is_good = condition <= self.max_condition && largest <= MOST_RATIO * least;
        if degree > 0 && !is_good {
            return None;
        }
        let coefficients = equations.substitute(T, diagonal);
        let differences = data.iter().zip(&shares).map(|(v, &shares)| {
            let value = value(&coefficients, degree, shares);
            self.values[v.index()] - value
        });
        let [rms, max] = size(differences);
        Some(Solved {
            coefficients: coefficients.to_vec(),
            fit: LocalFit {
                degree,
                rings: number,
                data: data.len(),
                condition,
                rms,
                max,
            },
        })
    }
}
