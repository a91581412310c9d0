//! The data: a set of points, along a space-filling curve.

use crate::delaunay::check_number;
use crate::locate::check_finite;
use crate::order::Frame;
use crate::predicates::{Orientation, orient2d};
use crate::{Duplicate, Error, Point, VertexId};

/// Different data, in an order that depends on their positions alone, neighbours in the plane next to each other.
#[derive(Clone, Debug)]
pub(super) struct Data {
    /// As they were given, −0.0 as 0.0.
    pub given: Vec<Point>,
    /// Which of the given equal an earlier one.
    pub duplicates: Vec<Duplicate>,
    /// The different ones. A *datum* is an index into this list.
    pub points: Vec<Point>,
    /// Which of the given each of them is.
    pub names: Vec<VertexId>,
}

impl Data {
    /// Sorts out the data.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::TooManyPoints`].
    ///
    /// *Cost*: O(l log l).
    pub fn new<P: Into<Point>>(given: impl IntoIterator<Item = P>) -> Result<Self, Error> {
        let given = given.into_iter().map(Into::into);
        let given: Vec<Point> = given.map(|p| Point::new(p.x + 0.0, p.y + 0.0)).collect();
        check_number(given.len())?;
        check_finite(&given)?;
        let mut order = along_curve(&given);
        let equal = |i: &usize, j: &usize| given[*i] == given[*j];
        let runs = order.chunk_by(equal);
        let mut duplicates: Vec<_> = runs
            .flat_map(|run| {
                let kept = VertexId::new(run[0]);
                let dropped = run[1..].iter().map(|&i| VertexId::new(i));
                dropped.map(move |dropped| Duplicate { dropped, kept })
            })
            .collect();
        duplicates.sort_unstable_by_key(|d| d.dropped);
        order.dedup_by(|j, i| given[*i] == given[*j]);
        Ok(Self {
            points: order.iter().map(|&i| given[i]).collect(),
            names: order.into_iter().map(VertexId::new).collect(),
            given,
            duplicates,
        })
    }

    /// Tells whether all lie on one line.
    pub fn are_collinear(&self) -> bool {
        let (Some(&first), Some(&last)) = (self.points.first(), self.points.last()) else {
            return true;
        };
        // The first and the last along the curve differ, if any two do.
        let is_beside = |&p: &Point| orient2d(first, last, p) != Orientation::Collinear;
        !self.points.iter().any(is_beside)
    }
}

/// Lists the points by their keys along the curve; equal keys by position, then by index.
fn along_curve(points: &[Point]) -> Vec<usize> {
    let none = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
    let [min, max] = points.iter().fold(none, |[min, max], p| {
        let min = [min[0].min(p.x), min[1].min(p.y)];
        [min, [max[0].max(p.x), max[1].max(p.y)]]
    });
    if points.is_empty() {
        return Vec::new();
    }
    let frame = Frame::new(min, max, u32::BITS);
    let keys = points.iter().enumerate().map(|(i, &p)| (frame.key(p), i));
    let mut keys: Vec<_> = keys.collect();
    keys.sort_unstable_by(|&(key, i), &(other, j)| {
        let by_position = || points[i].lex_cmp(&points[j]);
        key.cmp(&other).then_with(by_position).then(i.cmp(&j))
    });
    keys.into_iter().map(|(_, i)| i).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_order_depends_on_positions_alone() {
        let lattice = (0..100).map(|i| (f64::from(i % 10), f64::from(i / 10)));
        let mut points: Vec<_> = lattice.collect();
        let straight = Data::new(points.iter().copied()).unwrap();
        points.reverse();
        let reversed = Data::new(points).unwrap();
        assert_eq!(straight.points, reversed.points);
        assert!(!straight.are_collinear());
    }

    #[test]
    fn equal_data_are_one() {
        let data =
            Data::new([(1.0, 2.0), (0.0, 0.0), (1.0, 2.0), (-0.0, 0.0), (1.0, 2.0)]).unwrap();
        assert_eq!(data.points.len(), 2);
        let pairs: Vec<_> = data
            .duplicates
            .iter()
            .map(|d| (d.dropped.index(), d.kept.index()))
            .collect();
        assert_eq!(pairs, [(2, 0), (3, 1), (4, 0)]);
        assert!(data.are_collinear());
    }

    #[test]
    fn what_is_not_finite_is_named() {
        let error = Data::new([(0.0, 0.0), (f64::NAN, 1.0)]).unwrap_err();
        assert!(matches!(error, Error::NotFinite { index: 1, .. }));
    }

    #[test]
    fn a_row_is_known_at_any_scale() {
        for scale in [1e-300, 1.0, 1e300] {
            let row = (0..9).map(|i| (f64::from(i) * scale, f64::from(i) * scale));
            assert!(Data::new(row.clone()).unwrap().are_collinear());
            let beside = row.chain([(0.0, scale)]);
            assert!(!Data::new(beside).unwrap().are_collinear());
        }
    }
}
