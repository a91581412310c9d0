//! Polynomials over a triangle by Bernstein's basis.
//!
//! With λ the shares of the corners in a point, the basis of degree k has a member
//! k!/(i! j! l!) · λ₀ⁱ λ₁ʲ λ₂ˡ for each i + j + l = k. In the triangle they are at least 0 and sum to 1: the
//! polynomial stays between its least and its largest coefficient there. They are listed with i falling, then j:
//!
//! ```text
//!          0           corner 0
//!        1   2
//!      3   4   5
//!    6   7   8   9
//!  corner 1     corner 2         degree 3
//! ```
//!
//! *Cost*: O(k³) by de Casteljau's scheme, O(k²) for a list of basis values. *Papers*: Farin, *Triangular
//! Bernstein–Bézier patches* (1986).

/// Largest degree.
pub(super) const MOST_DEGREE: usize = 5;

/// Most coefficients of a polynomial.
const MOST_TERMS: usize = terms(MOST_DEGREE);

/// Counts the coefficients of a polynomial in two variables.
pub(super) const fn terms(degree: usize) -> usize {
    (degree + 1) * (degree + 2) / 2
}

/// Returns one over the least singular value of the matrix of the basis at infinitely many points spread evenly over
/// the triangle, divided by the root of their number: √((2k + 2)!/2)/k!.
///
/// The squares are the eigenvalues of the operator that maps a function to its Bernstein–Durrmeyer polynomial, over
/// the number of coefficients (Derriennic, *On multivariate approximation by
/// Bernstein-type polynomials*, 1985).
pub(super) fn ideal(degree: usize) -> f64 {
    let factorial = |n: usize| (1..=n).map(|i| i as f64).product::<f64>();
    (factorial(2 * degree + 2) / 2.0).sqrt() / factorial(degree)
}

/// Where the row of coefficient `(row, 0)` begins.
const fn start(row: usize) -> usize {
    row * (row + 1) / 2
}

/// Returns the basis at a point with such shares; there must be `T` members.
pub(super) fn basis<const T: usize>(degree: usize, shares: [f64; 3]) -> [f64; T] {
    debug_assert_eq!(T, terms(degree));
    let mut basis = [0.0; T];
    basis[0] = 1.0;
    for rows in 1..=degree {
        let mut raised = [0.0; T];
        for row in 0..rows {
            for k in 0..=row {
                let member = basis[start(row) + k];
                raised[start(row) + k] += shares[0] * member;
                raised[start(row + 1) + k] += shares[1] * member;
                raised[start(row + 1) + k + 1] += shares[2] * member;
            }
        }
        basis = raised;
    }
    basis
}

/// Goes through de Casteljau's scheme down to a plane, by its values at the corners: it has the value of the
/// polynomial at the point, and is steep by its slope there divided by the degree.
fn collapse(coefficients: &[f64], degree: usize, shares: [f64; 3]) -> [f64; 3] {
    debug_assert_eq!(coefficients.len(), terms(degree));
    if degree == 0 {
        return [coefficients[0]; 3];
    }
    let mut left = [0.0; MOST_TERMS];
    left[..coefficients.len()].copy_from_slice(coefficients);
    for rows in (2..=degree).rev() {
        // In place: what is read lies at or behind what is written.
        for row in 0..rows {
            for k in 0..=row {
                let beyond = start(row + 1) + k;
                let three = [left[start(row) + k], left[beyond], left[beyond + 1]];
                left[start(row) + k] = mean(three, shares);
            }
        }
    }
    [left[0], left[1], left[2]]
}

/// Returns the value at a point with such shares.
pub(super) fn value(coefficients: &[f64], degree: usize, shares: [f64; 3]) -> f64 {
    match degree {
        0 => coefficients[0],
        _ => mean(collapse(coefficients, degree, shares), shares),
    }
}

/// Returns how much the value rises, at a point with such shares, towards corners 1 and 2 as seen from corner 0.
pub(super) fn rises(coefficients: &[f64], degree: usize, shares: [f64; 3]) -> [f64; 2] {
    let [a, b, c] = collapse(coefficients, degree, shares);
    [b - a, c - a].map(|rise| degree as f64 * rise)
}

/// Weighs three values with shares.
fn mean(values: [f64; 3], shares: [f64; 3]) -> f64 {
    shares[0] * values[0] + shares[1] * values[1] + shares[2] * values[2]
}

#[cfg(test)]
mod tests {
    use super::super::singular::extremes;
    use super::*;
    use crate::surface::least_squares::{LeastSquares, Row};

    /// Members by the formula, in the order of the list.
    fn naive(degree: usize, shares: [f64; 3]) -> Vec<f64> {
        let factorial = |n: usize| (1..=n).product::<usize>() as f64;
        let mut members = Vec::new();
        for row in 0..=degree {
            for l in 0..=row {
                let powers = [degree - row, row - l, l];
                let product = |i: usize| shares[i].powi(powers[i] as i32) / factorial(powers[i]);
                members.push(factorial(degree) * product(0) * product(1) * product(2));
            }
        }
        members
    }

    fn check<const T: usize>(degree: usize) {
        let coefficients: Vec<f64> = (0..T).map(|i| ((i * 7 + 3) % 11) as f64 - 4.0).collect();
        for shares in [[0.2, 0.3, 0.5], [1.0, 0.0, 0.0], [1.75, -2.0, 1.25]] {
            let (members, expected) = (basis::<T>(degree, shares), naive(degree, shares));
            let near = |a: f64, b: f64| (a - b).abs() < 1e-11;
            assert!(members.iter().zip(&expected).all(|(&a, &b)| near(a, b)));
            let at = |shares| {
                let terms = naive(degree, shares).into_iter().zip(&coefficients);
                terms.map(|(b, c)| b * c).sum::<f64>()
            };
            assert!(near(value(&coefficients, degree, shares), at(shares)));
            let step = 1e-6;
            let [a, b, c] = shares;
            let towards = [[a - step, b + step, c], [a - step, b, c + step]];
            let from = [[a + step, b - step, c], [a + step, b, c - step]];
            let found = rises(&coefficients, degree, shares);
            for k in 0..2 {
                let expected = (at(towards[k]) - at(from[k])) / (2.0 * step);
                assert!((found[k] - expected).abs() < 1e-4, "{degree} {found:?}");
            }
        }
    }

    #[test]
    fn members_values_and_slopes_are_those_of_the_formula() {
        check::<1>(0);
        check::<3>(1);
        check::<6>(2);
        check::<10>(3);
        check::<15>(4);
        check::<21>(5);
    }

    /// Midpoints of many small triangles are spread evenly enough.
    #[test]
    fn ideal_is_the_limit() {
        let n = 60;
        let cells = (0..n).flat_map(|i| (0..n - i).map(move |j| (i, j)));
        let at = |(i, j): (i32, i32), part: f64| {
            let [a, b] = [i, j].map(|i| (f64::from(i) + part) / f64::from(n));
            [1.0 - a - b, a, b]
        };
        let lower = cells.clone().map(|cell| at(cell, 1.0 / 3.0));
        let upper = cells
            .filter(|(i, j)| i + j + 1 < n)
            .map(|cell| at(cell, 2.0 / 3.0));
        let rows = lower.chain(upper).map(|shares| Row {
            terms: basis::<10>(3, shares),
            value: 0.0,
        });
        let mut equations = LeastSquares {
            rows: rows.collect(),
        };
        let count = equations.rows.len() as f64;
        let diagonal = equations.reduce(10);
        let [largest, least] = extremes(equations.triangle(diagonal)).expect("finite");
        assert!((count.sqrt() / least / ideal(3) - 1.0).abs() < 1e-2);
        assert!((largest / (count / 10.0).sqrt() - 1.0).abs() < 1e-2);
    }

    #[test]
    fn constants_stay_constant_even_if_shares_do_not_sum_to_1() {
        assert_eq!(value(&[0.1], 0, [f64::NAN; 3]), 0.1);
        assert_eq!(basis::<1>(0, [f64::NAN; 3]), [1.0]);
    }
}
