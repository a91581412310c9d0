//! The rectangle that cells are clipped to, and what they come to.

/// The cells that are compared have all their corners farther from the border than this part of the width: far
/// enough for whoever does not clip, and at no border of lattices.
const MARGIN: f64 = 0.0731;

/// A cover may differ from the rectangle by this part.
const SLACK: f64 = 1e-9;

/// A rectangle along the axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Its least coordinates.
    pub low: [f64; 2],
    /// Its greatest.
    pub high: [f64; 2],
}

impl Bounds {
    /// Returns the smallest around points.
    pub fn of(points: &[[f64; 2]]) -> Self {
        let extreme = |start, pick: fn(f64, f64) -> f64| {
            [0, 1].map(|k| points.iter().map(|p| p[k]).fold(start, pick))
        };
        Self {
            low: extreme(f64::INFINITY, f64::min),
            high: extreme(f64::NEG_INFINITY, f64::max),
        }
    }

    /// Returns its width and height.
    pub fn sides(&self) -> [f64; 2] {
        [0, 1].map(|k| self.high[k] - self.low[k])
    }

    /// Returns where a point lies, in parts of width and height.
    pub fn share(&self, p: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|k| (p[k] - self.low[k]) / self.sides()[k])
    }

    /// Tells whether a point lies well within.
    fn is_amid(&self, p: [f64; 2]) -> bool {
        self.share(p)
            .iter()
            .all(|u| (MARGIN..1.0 - MARGIN).contains(u))
    }

    /// Sums up the areas of the cells amid.
    pub fn sum_amid<P: AsRef<[[f64; 2]]>>(&self, cells: impl Iterator<Item = P>) -> f64 {
        let is_amid = |cell: &P| cell.as_ref().iter().all(|&p| self.is_amid(p));
        cells.filter(is_amid).map(|cell| area(cell.as_ref())).sum()
    }

    /// Fails unless cells cover the rectangle.
    ///
    /// # Errors
    /// Says which part they cover.
    pub fn require_cover<P: AsRef<[[f64; 2]]>>(
        &self,
        cells: impl Iterator<Item = P>,
    ) -> Result<(), String> {
        let [width, height] = self.sides();
        let covered = cells.map(|cell| area(cell.as_ref())).sum::<f64>() / (width * height);
        if (covered - 1.0).abs() <= SLACK {
            Ok(())
        } else {
            Err(format!("the cells come to {covered} of the rectangle"))
        }
    }
}

/// Returns the area of a polygon, whichever way it runs.
fn area(polygon: &[[f64; 2]]) -> f64 {
    let Some(&[x, y]) = polygon.first() else {
        return 0.0;
    };
    let next = polygon.iter().cycle().skip(1);
    let sides = polygon.iter().zip(next);
    let doubled = sides.map(|(p, q)| (p[0] - x) * (q[1] - y) - (p[1] - y) * (q[0] - x));
    0.5 * doubled.sum::<f64>().abs()
}

#[cfg(test)]
mod tests {
    use super::{Bounds, area};

    #[test]
    fn cells_cover_the_rectangle_or_not() {
        let bounds = Bounds::of(&[[1.0, 1.0], [3.0, 2.0]]);
        let left = [[1.0, 1.0], [2.0, 1.0], [2.0, 2.0], [1.0, 2.0]];
        let right = left.map(|[x, y]| [x + 1.0, y]);
        let mirrored = right.map(|[x, y]| [5.0 - x, y]);
        assert_eq!(area(&left), 1.0);
        assert_eq!(bounds.require_cover([left, right].iter()), Ok(()));
        assert_eq!(bounds.require_cover([left, mirrored].iter()), Ok(()));
        let complaint = bounds.require_cover([left].iter()).unwrap_err();
        assert!(complaint.contains("0.5"), "{complaint}");
    }

    #[test]
    fn cells_near_the_border_are_not_compared() {
        let bounds = Bounds::of(&[[0.0, 0.0], [10.0, 10.0]]);
        let amid = [[4.0, 4.0], [6.0, 4.0], [6.0, 6.0]];
        let beside = amid.map(|[x, y]| [x - 4.0, y]);
        assert_eq!(bounds.sum_amid([amid, beside].iter()), 2.0);
    }
}
