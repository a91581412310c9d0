//! Least squares by Householder's reflections, with few columns and any number of rows.
//!
//! Normal equations would square the condition.
//!
//! *Cost*: O(rows · T²). *Does not* pivot: who needs to know how well the solution is determined looks at the
//! triangle that is left.

/// An equation: the terms, and what they are to sum to, each times its unknown.
#[derive(Clone, Copy, Debug)]
pub(super) struct Row<const T: usize> {
    pub terms: [f64; T],
    pub value: f64,
}

/// Equations for T unknowns, with room for more.
#[derive(Clone, Debug)]
pub(super) struct LeastSquares<const T: usize> {
    pub rows: Vec<Row<T>>,
}

impl<const T: usize> Default for LeastSquares<T> {
    fn default() -> Self {
        Self { rows: Vec::new() }
    }
}

impl<const T: usize> LeastSquares<T> {
    /// Turns the first `terms` columns, of which there are no more than rows, into a triangle and returns its
    /// diagonal; what is above it is in the rows.
    pub fn reduce(&mut self, terms: usize) -> [f64; T] {
        let mut diagonal = [0.0; T];
        for (k, entry) in diagonal.iter_mut().enumerate().take(terms) {
            *entry = self.reflect(k);
        }
        diagonal
    }

    /// Reflects the rows from `k` on so that column `k` vanishes below the diagonal; returns what stands on it.
    fn reflect(&mut self, k: usize) -> f64 {
        let rows = &mut self.rows[k..];
        let norm = rows
            .iter()
            .map(|row| row.terms[k] * row.terms[k])
            .sum::<f64>()
            .sqrt();
        let first = rows[0].terms[k];
        let diagonal = if first > 0.0 { -norm } else { norm };
        rows[0].terms[k] -= diagonal;
        let squared: f64 = rows.iter().map(|row| row.terms[k] * row.terms[k]).sum();
        if squared > 0.0 {
            for column in k + 1..T {
                let along: f64 = rows
                    .iter()
                    .map(|row| row.terms[k] * row.terms[column])
                    .sum();
                let factor = 2.0 * along / squared;
                rows.iter_mut()
                    .for_each(|row| row.terms[column] -= factor * row.terms[k]);
            }
            let along: f64 = rows.iter().map(|row| row.terms[k] * row.value).sum();
            let factor = 2.0 * along / squared;
            rows.iter_mut()
                .for_each(|row| row.value -= factor * row.terms[k]);
        }
        diagonal
    }

    /// Solves the triangular system of `terms` unknowns that [`reduce`](Self::reduce) has left.
    pub fn substitute(&self, terms: usize, diagonal: [f64; T]) -> [f64; T] {
        let mut solution = [0.0; T];
        for k in (0..terms).rev() {
            let row = &self.rows[k];
            let known: f64 = (k + 1..terms).map(|j| row.terms[j] * solution[j]).sum();
            solution[k] = (row.value - known) / diagonal[k];
        }
        solution
    }

    /// Returns the triangle that [`reduce`](Self::reduce) has left, column by column.
    pub fn triangle(&self, diagonal: [f64; T]) -> [[f64; T]; T] {
        let mut columns = [[0.0; T]; T];
        for (j, column) in columns.iter_mut().enumerate() {
            column[j] = diagonal[j];
            for (i, entry) in column.iter_mut().enumerate().take(j) {
                *entry = self.rows[i].terms[j];
            }
        }
        columns
    }
}
