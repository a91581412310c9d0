//! Splines: piecewise rational curves over knots, cut into Bézier curves.
//!
//! The control points of the piece over a span are values of the spline's blossom (Ramshaw, *Blossoms are polar
//! forms*, 1989), by de Boor's recursion.

use super::{Outline, Piece, project};
use crate::Problem;

/// Highest degree of a spline.
const MAX_DEGREE: usize = 24;

/// A spline in space.
#[derive(Clone, Debug, Default)]
pub(crate) struct Spline {
    pub degree: usize,
    pub knots: Vec<f64>,
    /// Control points and their weights.
    pub control: Vec<[f64; 4]>,
}

impl Spline {
    /// Cuts the spline at its knots.
    ///
    /// # Errors
    /// If degree, knots and control points do not fit, or a weight is not positive.
    ///
    /// *Cost*: O(d³) a span, of degree d.
    pub fn outline(&self) -> Result<Outline, Problem> {
        self.validate().map_err(Problem::Other)?;
        let (d, n) = (self.degree, self.control.len());
        let weighted = self
            .control
            .iter()
            .map(|&[x, y, z, w]| [x * w, y * w, z * w, w]);
        let weighted: Vec<_> = weighted.collect();
        let mut outline: Option<Outline> = None;
        for span in (d..n).filter(|&i| self.knots[i] < self.knots[i + 1]) {
            let of_span = &weighted[span - d..=span];
            let control: Vec<_> = (0..=d).map(|j| self.blossom(of_span, span, j)).collect();
            let outline = outline.get_or_insert_with(|| Outline::new(project(control[0])));
            let to = project(control[d]);
            outline.pieces.push((Piece::Bezier(control), to));
        }
        outline.ok_or_else(|| Problem::Other("all knots of the spline are the same".to_owned()))
    }

    fn validate(&self) -> Result<(), String> {
        let (d, n, knots) = (self.degree, self.control.len(), self.knots.len());
        if !(1..=MAX_DEGREE).contains(&d) {
            return Err(format!(
                "a spline of degree {d}; 1 to {MAX_DEGREE} are possible"
            ));
        }
        if n <= d || knots != n + d + 1 {
            return Err(format!(
                "a spline of degree {d} with {n} control points and {knots} knots; there must be more \
                 control points than the degree, and {} knots",
                n + d + 1
            ));
        }
        if let Some(i) = (1..knots).find(|&i| is_out_of_order(self.knots[i - 1], self.knots[i])) {
            let [a, b] = [self.knots[i - 1], self.knots[i]];
            return Err(format!(
                "knot {i} of the spline, {b}, is less than the one before, {a}"
            ));
        }
        if let Some(i) = (d + 1..n).find(|&i| i + d < n && self.knots[i] == self.knots[i + d]) {
            let knot = self.knots[i];
            return Err(format!(
                "the spline is torn: its knot {knot} stands there more than {d} times"
            ));
        }
        match self
            .control
            .iter()
            .find(|c| is_out_of_order(f64::MIN_POSITIVE, c[3]))
        {
            Some([.., weight]) => Err(format!("a weight of the spline is {weight}, not positive")),
            None => Ok(()),
        }
    }

    /// Returns the blossom over a span at its end, `j` times, and its beginning for the rest.
    fn blossom(&self, of_span: &[[f64; 4]], span: usize, j: usize) -> [f64; 4] {
        let d = self.degree;
        let mut points = of_span.to_vec();
        for r in 1..=d {
            let at = if r <= j {
                self.knots[span + 1]
            } else {
                self.knots[span]
            };
            for m in (r..=d).rev() {
                let i = span - d + m;
                let [low, high] = [self.knots[i], self.knots[i + d + 1 - r]];
                let part = (at - low) / (high - low);
                points[m] =
                    [0, 1, 2, 3].map(|k| (1.0 - part) * points[m - 1][k] + part * points[m][k]);
            }
        }
        points[d]
    }
}

/// Tells whether numbers do not rise, or one of them is none.
fn is_out_of_order(low: f64, high: f64) -> bool {
    low.partial_cmp(&high).is_none_or(std::cmp::Ordering::is_gt)
}
