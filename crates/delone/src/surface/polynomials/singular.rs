//! Singular values of small matrices by one-sided Jacobi rotations.
//!
//! Columns are rotated against each other until all are perpendicular; their lengths then are the singular values.
//!
//! *Cost*: some five to ten sweeps of T² pairs of T numbers. *Ends*: after 40 sweeps, which none is known to need. *Papers*:
//! Hestenes, *Inversion of matrices by biorthogonalization and related results* (1958); Demmel and Veselić,
//! *Jacobi's method is more accurate than QR* (1992).

/// Most sweeps.
const SWEEPS: usize = 40;

/// Cosine of the angle between two columns below which they are perpendicular.
const PERPENDICULAR: f64 = 1e-15;

/// Returns the largest and the least singular value of the matrix with such columns; `None` if an entry, or the
/// square of one, is not finite.
pub(super) fn extremes<const T: usize>(mut columns: [[f64; T]; T]) -> Option<[f64; 2]> {
    let squares = columns.as_flattened().iter().map(|c| c * c);
    if !squares.sum::<f64>().is_finite() {
        return None;
    }
    for _ in 0..SWEEPS {
        if !sweep(&mut columns) {
            break;
        }
    }
    let lengths = columns.map(|column| dot(&column, &column).sqrt());
    let largest = lengths.iter().fold(0.0_f64, |a, &b| a.max(b));
    let least = lengths.iter().fold(f64::INFINITY, |a, &b| a.min(b));
    Some([largest, least])
}

/// Rotates each pair of columns that is not perpendicular; tells whether there was one.
fn sweep<const T: usize>(columns: &mut [[f64; T]; T]) -> bool {
    let mut any = false;
    for p in 0..T {
        for q in p + 1..T {
            let (before, behind) = columns.split_at_mut(q);
            any |= make_perpendicular(&mut before[p], &mut behind[0]);
        }
    }
    any
}

/// Rotates two columns, unless they are perpendicular already.
fn make_perpendicular<const T: usize>(a: &mut [f64; T], b: &mut [f64; T]) -> bool {
    let (aa, bb, ab) = (dot(a, a), dot(b, b), dot(a, b));
    if ab.abs() <= PERPENDICULAR * aa.sqrt() * bb.sqrt() {
        return false;
    }
    let zeta = (bb - aa) / (2.0 * ab);
    let tangent = zeta.signum() / (zeta.abs() + zeta.hypot(1.0));
    let cosine = 1.0 / tangent.hypot(1.0);
    let sine = cosine * tangent;
    for (x, y) in a.iter_mut().zip(b) {
        (*x, *y) = (cosine * *x - sine * *y, sine * *x + cosine * *y);
    }
    true
}

fn dot<const T: usize>(a: &[f64; T], b: &[f64; T]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_values_are_found() {
        let [largest, least] = extremes([[3.0, 0.0], [4.0, 5.0]]).expect("finite");
        assert!((largest - 45.0_f64.sqrt()).abs() < 1e-14);
        assert!((least - 5.0_f64.sqrt()).abs() < 1e-14);
        assert_eq!(extremes([[-7.0]]), Some([7.0, 7.0]));
        let [_, least] = extremes([[1.0, 2.0, 3.0], [2.0, 4.0, 6.0], [1.0, 0.0, 0.0]]).expect("");
        assert!(least < 1e-14);
        assert_eq!(extremes([[0.0; 3]; 3]), Some([0.0, 0.0]));
        assert_eq!(extremes([[f64::NAN, 0.0], [0.0, 1.0]]), None);
        assert_eq!(extremes([[1e200, 0.0], [0.0, 1.0]]), None);
    }

    /// Hilbert's matrix: the product of all singular values is the determinant, 1/6048000 for four rows.
    #[test]
    fn hilberts_matrix() {
        let row = |i: usize| [0, 1, 2, 3].map(|j| 1.0 / (i + j + 1) as f64);
        let [largest, least] = extremes([0, 1, 2, 3].map(row)).expect("finite");
        assert!((largest / least / 15_513.738_738_929 - 1.0).abs() < 1e-9);
    }
}
