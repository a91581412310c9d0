//! Tells of most places on a segment beforehand whether they are good.
//!
//! As the vertex v goes along the segment from P to Q, the spoke to the corner L beside it sweeps over the data on that
//! side, and each changes from the triangle at Q to the one at P when the spoke meets it: at
//!
//! ```text
//!           L                β = f / (f − g),   f = |LP, Lp|,  g = |LQ, Lp| (determinants).
//!          / \\
//!         /   \p\            So the triangle at P is short before the d-th smallest β of a side, and the one at
//!        /     \  \          Q behind the d-th largest. If that crosses over there is no good place.
//!       P ----- v - Q
//! ```
//!
//! *Exact*: each β is an interval that contains the true one, and whatever rounding v does to it; what lies within is
//! not known. The bound of a determinant is that of the filter of [`orient2d`](crate::predicates::orient2d); overflow
//! gives an infinite one, and underflow is below what is added to it.
//!
//! *Cost*: O(n), and a few operations for each place.

use super::bisection::Verdict;
use super::plot::Plot;
use crate::Point;
use crate::predicates::ORIENT2D_BOUND;

/// Places up to 2 to the power of this from an end are not judged: rounding turns the way from there to the end too far.
const NEAREST: i32 = -26;

/// By how much a coordinate may be off in a place on a segment, relative to the larger one of its ends: half a unit for
/// rounding, and two for moving it outward, would be 5 · 2⁻⁵³.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// Between which places it is known how things stand.
#[derive(Debug)]
pub(super) struct Forecast {
    /// Before the first the start is short, from the second on it is not.
    start: [f64; 2],
    /// Up to the first the end is not short, beyond the second it is.
    end: [f64; 2],
}

impl Forecast {
    /// Finds out where the parts of a plot hold fewer than `least`.
    pub fn new(plot: &Plot, least: usize) -> Self {
        let mut whole = Self {
            start: [f64::NEG_INFINITY; 2],
            end: [f64::INFINITY; 2],
        };
        let [start, end] = plot.segment();
        for (k, far) in plot.far_corners().enumerate() {
            let sign = [1.0, -1.0][k];
            let corner = Corner { start, end, far };
            let is_alone = plot.num_parts() == 2;
            let mut side = Side::default();
            for &p in plot.data {
                let beside = if is_alone {
                    1.0
                } else {
                    sign * corner.beside(p)
                };
                if beside >= 0.0 {
                    side.push(corner.meeting(p), beside > 0.0);
                }
            }
            whole = whole.and(&side.forecast(least));
        }
        whole
    }

    /// What holds for both sides of the segment together: a part of either may be short.
    fn and(self, other: &Self) -> Self {
        let both =
            |a: [f64; 2], b: [f64; 2], of: fn(f64, f64) -> f64| [of(a[0], b[0]), of(a[1], b[1])];
        Self {
            start: both(self.start, other.start, f64::max),
            end: both(self.end, other.end, f64::min),
        }
    }

    /// Tells whether it is known that a search that tries fewer than so many places finds none.
    pub fn is_hopeless(&self, bisections: u32) -> bool {
        self.start[0] > self.end[1] && bisections <= NEAREST.unsigned_abs()
    }

    /// Judges place `b`, for which `at` stands, if its verdict is known.
    pub fn judge(&self, plot: &Plot, b: f64, at: Point) -> Option<Verdict> {
        let nearest = 2_f64.powi(NEAREST);
        if !(nearest..=1.0 - nearest).contains(&b) || !plot.is_proper(at) {
            return None;
        }
        let known = |is_short, is_not| (is_short || is_not).then_some(is_short);
        let start = known(b < self.start[0], b >= self.start[1])?;
        let end = known(b > self.end[1], b <= self.end[0])?;
        (start || end).then(|| Verdict::short([start, end]))
    }
}

/// When the data on one side change triangles: intervals.
#[derive(Default)]
struct Side {
    low: Vec<f64>,
    high: Vec<f64>,
    /// Those of data that may also be on the other side.
    doubtful: Vec<[f64; 2]>,
}

impl Side {
    fn push(&mut self, [low, high]: [f64; 2], is_sure: bool) {
        if is_sure {
            self.low.push(low);
            self.high.push(high);
        } else {
            self.doubtful.push([low, high]);
        }
    }

    fn forecast(mut self, least: usize) -> Forecast {
        let enough_at_start = smallest(&mut self.high, least);
        let enough_at_end = largest(&mut self.low, least);
        self.low.extend(self.doubtful.iter().map(|&[low, _]| low));
        self.high
            .extend(self.doubtful.iter().map(|&[_, high]| high));
        Forecast {
            start: [smallest(&mut self.low, least), enough_at_start],
            end: [enough_at_end, largest(&mut self.high, least)],
        }
    }
}

/// The k-th smallest of some values; infinite if there are fewer.
fn smallest(values: &mut [f64], k: usize) -> f64 {
    if values.len() < k {
        return f64::INFINITY;
    }
    *values.select_nth_unstable_by(k - 1, f64::total_cmp).1
}

/// The k-th largest of some values; infinite if there are fewer.
fn largest(values: &mut [f64], k: usize) -> f64 {
    if values.len() < k {
        return f64::NEG_INFINITY;
    }
    let place = values.len() - k;
    *values.select_nth_unstable_by(place, f64::total_cmp).1
}

/// A segment and a corner beside it.
struct Corner {
    start: Point,
    end: Point,
    far: Point,
}

impl Corner {
    /// On which side of the segment `p` lies, positive for left: for sure, and wherever on it v is; 0 if that is not
    /// known.
    fn beside(&self, p: Point) -> f64 {
        let (s, error) = determinant(self.start, self.end, p);
        let shift = self.shift(self.start, p).max(self.shift(self.end, p));
        // Nearest to an end, v off by `shift` turns the way there by so much.
        let margin = 2_f64.powi(1 - NEAREST) * (error + shift);
        if s.abs() > margin { s } else { 0.0 }
    }

    /// Where v is when the spoke meets `p`.
    fn meeting(&self, p: Point) -> [f64; 2] {
        let (f, f_error) = determinant(self.far, self.start, p);
        let (g, g_error) = determinant(self.far, self.end, p);
        let whole = f - g;
        let error = f_error + g_error + self.shift(self.far, p);
        // β is off by at most 2 (f_error + g_error) / whole, and rounding v changes it by 8/7 of shift / whole.
        let radius = 4.0 * (error / whole.abs() + f64::EPSILON);
        let middle = f / whole;
        if radius < 0.5 && middle.is_finite() {
            [middle - radius, middle + radius]
        } else {
            [f64::NEG_INFINITY, f64::INFINITY]
        }
    }

    /// By how much rounding v changes the determinant of v, `from` and `p` at most.
    fn shift(&self, from: Point, p: Point) -> f64 {
        // Below the normal numbers, units are no smaller than there.
        let unit = |a: f64, b: f64| ROUNDING * a.abs().max(b.abs()).max(f64::MIN_POSITIVE);
        let (x, y) = (
            unit(self.start.x, self.end.x),
            unit(self.start.y, self.end.y),
        );
        x * (p.y - from.y).abs() + y * (p.x - from.x).abs()
    }
}

/// The determinant of `ab` and `ac`, and a bound of its error.
fn determinant(a: Point, b: Point, c: Point) -> (f64, f64) {
    let left = (b.x - a.x) * (c.y - a.y);
    let right = (b.y - a.y) * (c.x - a.x);
    let error = ORIENT2D_BOUND * (left.abs() + right.abs()) + f64::MIN_POSITIVE;
    (left - right, error)
}
