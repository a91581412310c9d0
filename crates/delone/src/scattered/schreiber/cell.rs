//! The points of a cluster, and what is measured of them.

use super::rows::{Rows, square};

/// A cluster without its center.
#[derive(Clone, Debug, Default)]
pub(super) struct Cell {
    /// Its points, by number.
    pub members: Vec<u32>,
    /// The sum of their weights.
    pub weight: f64,
    /// The weighted mean of the squares of their distances from the center; 0 without points.
    pub error: f64,
    /// The axis along which the weighted sum of squares is largest; the first of them.
    pub axis: usize,
    /// The largest square of a distance from the center.
    pub radius: f64,
}

impl Cell {
    /// Makes a cluster of points that is still to be measured.
    pub fn of(members: Vec<u32>) -> Self {
        Self {
            members,
            ..Self::default()
        }
    }

    /// Measures how far the points are from the center.
    pub fn measure<const D: usize>(&mut self, rows: &Rows<'_, D>, center: &[f64]) {
        let heaviest = heaviest(rows, &self.members);
        let mut sums = vec![0.0; center.len()];
        let mut shares = 0.0;
        (self.weight, self.radius) = (0.0, 0.0);
        for &point in &self.members {
            let (row, weight) = (rows.row(point), rows.weight(point));
            let share = weight / heaviest;
            self.weight += weight;
            shares += share;
            for ((sum, x), t) in sums.iter_mut().zip(row).zip(center) {
                *sum += share * ((x - t) * (x - t));
            }
            self.radius = self.radius.max(square(row, center));
        }
        let all: f64 = sums.iter().sum();
        self.error = if shares > 0.0 { all / shares } else { 0.0 };
        // Of equal sums the first, which `max_by` would not take.
        let largest = |best: usize, k: usize| if sums[k] > sums[best] { k } else { best };
        self.axis = (0..sums.len()).fold(0, largest);
    }

    /// Takes out the points beyond a plane through the center, normal to the axis of largest deviation, and says
    /// where it is: not empty if the error is not 0.
    ///
    /// A mean may round to the largest coordinate; the plane then goes through the largest but one.
    pub fn cut<const D: usize>(&mut self, rows: &Rows<'_, D>, center: &[f64]) -> (f64, Vec<u32>) {
        let coordinate = |point: u32| rows.row(point)[self.axis];
        let all = || self.members.iter().map(|&point| coordinate(point));
        let last = all().fold(f64::NEG_INFINITY, f64::max);
        let before = || {
            all()
                .filter(|&x| x < last)
                .fold(f64::NEG_INFINITY, f64::max)
        };
        let at = match center[self.axis] {
            t if t < last => t,
            _ => before(),
        };
        let (near, far) = self.members.iter().partition(|&&p| coordinate(p) <= at);
        self.members = near;
        (at, far)
    }
}

/// Returns the weighted mean of points, which must be some, axis by axis in the order of their numbers.
///
/// It is measured from the first of them, and weights by the largest, so that no offset and no unit spoils it; and
/// it lies in the box around the points, as rounding alone would not ensure.
pub(super) fn mean<const D: usize>(rows: &Rows<'_, D>, members: &[u32]) -> Vec<f64> {
    let heaviest = heaviest(rows, members);
    let first = rows.row(members[0]);
    let mut sums = vec![0.0; first.len()];
    let (mut low, mut high) = (first.to_vec(), first.to_vec());
    let mut shares = 0.0;
    for &point in members {
        let share = rows.weight(point) / heaviest;
        shares += share;
        for (k, &x) in rows.row(point).iter().enumerate() {
            sums[k] += share * (x - first[k]);
            low[k] = low[k].min(x);
            high[k] = high[k].max(x);
        }
    }
    // All weights may have become 0.
    let shares = if shares > 0.0 { shares } else { 1.0 };
    let axes = sums.iter().enumerate();
    axes.map(|(k, sum)| (first[k] + sum / shares).clamp(low[k], high[k]))
        .collect()
}

/// Returns the largest weight of points; not 0, though those far below the largest of all may have become so.
fn heaviest<const D: usize>(rows: &Rows<'_, D>, members: &[u32]) -> f64 {
    let weights = members.iter().map(|&point| rows.weight(point));
    weights.fold(f64::MIN_POSITIVE, f64::max)
}
