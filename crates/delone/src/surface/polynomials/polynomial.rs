//! One polynomial, as it is handed out.

use super::bernstein;
use crate::Point;
use crate::surface::Jet;
use crate::surface::interpolant::share_gradients;
use crate::surface::number::shares;

/// A polynomial over a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Polynomial<'f> {
    pub(super) corners: [Point; 3],
    pub(super) degree: usize,
    pub(super) coefficients: &'f [f64],
}

impl Polynomial<'_> {
    /// Returns the corners of the triangle.
    pub fn corners(&self) -> [Point; 3] {
        self.corners
    }

    /// Returns the degree.
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// Returns the coefficients in Bernstein's basis: of λ₀ᵏ, λ₀ᵏ⁻¹λ₁, λ₀ᵏ⁻¹λ₂, λ₀ᵏ⁻²λ₁², … times the multinomial
    /// coefficients, powers of λ₀ falling, then those of λ₁, where λᵢ is the share of corner i.
    pub fn coefficients(&self) -> &[f64] {
        self.coefficients
    }

    /// Returns value and gradient at a point of the triangle; one beyond an edge counts as on it.
    pub fn jet(&self, p: Point) -> Jet {
        let shares = shares(self.corners, p);
        let slopes = share_gradients(self.corners);
        let [right, left] = bernstein::rises(self.coefficients, self.degree, shares);
        Jet {
            value: bernstein::value(self.coefficients, self.degree, shares),
            gradient: [0, 1].map(|axis| right * slopes[1][axis] + left * slopes[2][axis]),
        }
    }

    /// Returns the value at a point of the triangle; one beyond an edge counts as on it.
    pub fn value(&self, p: Point) -> f64 {
        let shares = shares(self.corners, p);
        bernstein::value(self.coefficients, self.degree, shares)
    }
}
