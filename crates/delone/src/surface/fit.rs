//! Gradients by least squares: the quadratic about a point that comes closest to values around.

use super::least_squares::{LeastSquares, Row};
use super::number::{Frame, Vector, dot};
use crate::Point;

/// Terms of a quadratic through the value at the point: x, y, x², xy, y².
const TERMS: usize = 5;

/// Part of the largest diagonal entry below which a column counts as a combination of those before.
const LEAST: f64 = 1e-7;

/// Room for the rows of one fit.
#[derive(Default)]
pub(super) struct Fit {
    equations: LeastSquares<TERMS>,
}

impl Fit {
    /// Returns the gradient at `p` of the quadratic through the value there that comes closest to the values
    /// `around`, weighted by one over the distance; of the plane, if they do not determine a quadratic;
    /// zero if not even that.
    pub fn gradient(
        &mut self,
        p: Point,
        value: f64,
        around: impl Iterator<Item = (Point, f64)> + Clone,
    ) -> [f64; 2] {
        let frame = Frame::alike(p, around.clone().map(|(q, _)| q));
        let rows = &mut self.equations.rows;
        rows.clear();
        rows.extend(around.map(|(q, other)| {
            let [x, y]: Vector<f64> = frame.vector(q);
            let weight = 1.0 / dot([x, y], [x, y]).sqrt();
            let terms = [x, y, x * x, x * y, y * y].map(|c| c * weight);
            let value = (other - value) * weight;
            Row { terms, value }
        }));
        let rows = rows.clone();
        let solution = self.solve(TERMS).or_else(|| {
            self.equations.rows = rows;
            self.solve(2)
        });
        let [x, y, ..] = solution.unwrap_or_default();
        [x * frame.scale[0], y * frame.scale[1]]
    }

    /// Solves for the first `terms` coefficients, if they are determined; the rows are used up.
    fn solve(&mut self, terms: usize) -> Option<[f64; TERMS]> {
        if self.equations.rows.len() < terms {
            return None;
        }
        let diagonal = self.equations.reduce(terms);
        let largest = diagonal.iter().fold(0.0, |m: f64, d| m.max(d.abs()));
        // False for NaN, too.
        let is_determined = diagonal[..terms].iter().all(|d| d.abs() > LEAST * largest);
        is_determined.then(|| self.equations.substitute(terms, diagonal))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn gradient(around: &[(f64, f64)], f: impl Fn(f64, f64) -> f64) -> [f64; 2] {
        let value = f(1.0, 2.0);
        let around = around.iter().map(|&(x, y)| (Point::new(x, y), f(x, y)));
        Fit::default().gradient(Point::new(1.0, 2.0), value, around)
    }

    fn require(found: [f64; 2], expected: [f64; 2]) {
        let is_near = |k: usize| (found[k] - expected[k]).abs() < 1e-12;
        assert!(is_near(0) && is_near(1), "{found:?} {expected:?}");
    }

    #[test]
    fn quadratics_are_fitted_exactly() {
        let around = [
            (0., 0.),
            (2., 1.),
            (1., 3.),
            (-1., 2.),
            (3., 3.),
            (0., 4.),
            (2., 0.),
        ];
        let found = gradient(&around, |x, y| 3.0 + x - y + x * x - 2.0 * x * y + y * y);
        require(found, [1.0 + 2.0 - 4.0, -1.0 - 2.0 + 4.0]);
    }

    #[test]
    fn too_few_points_make_a_plane_and_a_row_nothing() {
        let found = gradient(&[(0., 0.), (2., 1.), (1., 3.)], |x, y| 5.0 * x - y);
        require(found, [5.0, -1.0]);
        let row = gradient(&[(0., 2.), (2., 2.), (3., 2.)], |x, _| x);
        require(row, [0.0, 0.0]);
    }

    /// Four cross-shaped neighbours say nothing about xy: their quadratic is not determined.
    #[test]
    fn what_is_not_determined_is_left_to_a_plane() {
        let cross = [(0., 2.), (2., 2.), (1., 1.), (1., 3.), (3., 2.)];
        let found = gradient(&cross, |x, y| 2.0 * x + 4.0 * y);
        require(found, [2.0, 4.0]);
    }
}
