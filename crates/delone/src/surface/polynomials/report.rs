//! What became of each triangle, and of all.

use super::bernstein::ideal;

/// How the polynomial of a triangle was found.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct LocalFit {
    /// Its degree: that asked for, or less.
    pub degree: usize,
    /// How many rings of neighbours lent their data; 0 if its own were enough.
    pub rings: usize,
    /// To how many data it was fitted.
    pub data: usize,
    /// How many times more than with data spread evenly over the triangle errors of values may show: see
    /// [`magnification`](Self::magnification).
    pub condition: f64,
    /// Root of the mean square of what the values differ from the polynomial at the data it was fitted to.
    pub rms: f64,
    /// The largest such difference, as a magnitude.
    pub max: f64,
}

impl LocalFit {
    /// Returns by how much errors of values may be magnified: if they change by some amount, in the root of the mean
    /// square, the polynomial changes by no more than this times as much anywhere in the triangle.
    ///
    /// It is the [condition](Self::condition) times 1, 3.5, 9.5, 24, 56, 129 for degrees 0 to 5.
    pub fn magnification(&self) -> f64 {
        self.condition * ideal(self.degree)
    }
}

/// What became of all triangles.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct FitSummary {
    /// How many triangles have a polynomial of each degree, from 0 to the one asked for.
    pub by_degree: Vec<usize>,
    /// How many triangles needed the data of so many rings of neighbours, from 0.
    pub by_rings: Vec<usize>,
    /// The largest condition.
    pub condition: f64,
    /// Root of the mean square of what the surface differs from the values, at all data, equal ones once.
    pub rms: f64,
    /// The largest such difference, as a magnitude.
    pub max: f64,
}

impl FitSummary {
    /// Counts the triangles with a polynomial of a lower degree than was asked for.
    pub fn num_lowered(&self) -> usize {
        let below = self.by_degree.len().saturating_sub(1);
        self.by_degree[..below].iter().sum()
    }

    /// Counts the triangles that needed data of neighbours.
    pub fn num_widened(&self) -> usize {
        self.by_rings.iter().skip(1).sum()
    }

    /// Summarises what became of triangles, of which `degree` was asked, and what differs at the data.
    pub(super) fn of(fits: &[LocalFit], degree: usize, differences: &[f64]) -> Self {
        let most = fits.iter().map(|fit| fit.rings).max().unwrap_or(0);
        let (mut by_degree, mut by_rings) = (vec![0; degree + 1], vec![0; most + 1]);
        for fit in fits {
            by_degree[fit.degree] += 1;
            by_rings[fit.rings] += 1;
        }
        let [rms, max] = size(differences.iter().copied());
        Self {
            by_degree,
            by_rings,
            condition: fits.iter().fold(0.0, |worst, fit| fit.condition.max(worst)),
            rms,
            max,
        }
    }
}

/// Returns the root of the mean square of numbers, and the largest magnitude; zeros for none.
pub(super) fn size(numbers: impl ExactSizeIterator<Item = f64> + Clone) -> [f64; 2] {
    let count = numbers.len().max(1) as f64;
    let max = numbers.clone().fold(0.0_f64, |max, n| max.max(n.abs()));
    if max == 0.0 {
        return [0.0; 2];
    }
    // As shares of the largest: squares could over- or underflow.
    let squares: f64 = numbers.map(|n| (n / max) * (n / max)).sum();
    [max * (squares / count).sqrt(), max]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_neither_over_nor_underflow() {
        assert_eq!(size([3.0, -4.0, 0.0, 0.0].into_iter()), [2.5, 4.0]);
        assert_eq!(size([-f64::MAX; 3].into_iter()), [f64::MAX; 2]);
        assert_eq!(size([1e-300; 3].into_iter()), [1e-300; 2]);
        assert_eq!(size([].into_iter()), [0.0; 2]);
    }
}
