//! The two conditions of theorem 3.39: what must not lie on edges.
//!
//! A datum on an open edge of the triangle lies in the sub-triangle there and in no other, wherever the new vertex
//! is; one on two edges, their common corner included but not their other ends, not in the third. So the
//! conditions are necessary; with 3d data they are sufficient for a point with real coordinates, also if each datum
//! counts once ([`PointSearch`](super::PointSearch) finds it).

use super::super::Cause;
use super::parts::Division;
use crate::predicates::{Orientation, orient2d};
use crate::{Point, VertexId};

/// Tells why no vertex can open a triangle, if so; the ids are those of its corners.
///
/// The lowest edge (opposite corner 0, 1, 2) comes first, then the lowest common end.
///
/// *Cost*: O(m).
pub(in crate::scattered) fn conditions(
    corners: [Point; 3],
    ids: [VertexId; 3],
    data: &[Point],
    least: usize,
) -> Result<(), Cause> {
    let name = |obstacle: Obstacle| match obstacle {
        Obstacle::Edge { opposite, data } => Cause::Edge {
            edge: [1, 2].map(|k| ids[(opposite + k) % 3]),
            data,
        },
        Obstacle::TwoEdges { corner, data } => Cause::TwoEdges {
            corner: ids[corner],
            data,
        },
    };
    obstacle(&Division::new(corners, data, least)).map_or(Ok(()), |found| Err(name(found)))
}

/// Tells whether both conditions hold.
pub(super) fn hold(division: &Division) -> bool {
    obstacle(division).is_none()
}

/// A condition that does not hold, with the number of data on an edge or two.
enum Obstacle {
    Edge { opposite: usize, data: usize },
    TwoEdges { corner: usize, data: usize },
}

fn obstacle(division: &Division) -> Option<Obstacle> {
    let (all, least) = (division.data.len(), division.least);
    let (open, at_corners) = on_boundary(division);
    let edge = |opposite: usize| {
        let data = open[opposite];
        ((all - data) / 2 < least).then_some(Obstacle::Edge { opposite, data })
    };
    let two_edges = |corner: usize| {
        let data = open[(corner + 1) % 3] + open[(corner + 2) % 3] + at_corners[corner];
        (all - data < least).then_some(Obstacle::TwoEdges { corner, data })
    };
    (0..3).find_map(edge).or_else(|| (0..3).find_map(two_edges))
}

/// Counts the data on the open edge opposite each corner, and at each corner.
fn on_boundary(division: &Division) -> ([usize; 3], [usize; 3]) {
    let (mut open, mut at_corners) = ([0; 3], [0; 3]);
    let corners = division.corners;
    for &p in division.data {
        let is_on = |k: usize| {
            orient2d(corners[(k + 1) % 3], corners[(k + 2) % 3], p) == Orientation::Collinear
        };
        if let Some(k) = corners.iter().position(|&corner| corner == p) {
            at_corners[k] += 1;
        } else if let Some(k) = (0..3).find(|&k| is_on(k)) {
            open[k] += 1;
        }
    }
    (open, at_corners)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn obstacles_are_named() {
        let corners = [(0.0, 0.0), (8.0, 0.0), (0.0, 8.0)].map(Point::from);
        let ids = [7, 5, 9].map(VertexId::new);
        let why = |data: &[(f64, f64)], least| {
            let data: Vec<Point> = data.iter().map(|&p| p.into()).collect();
            conditions(corners, ids, &data, least)
        };
        let inside = [(1.0, 1.0), (2.0, 1.0), (1.0, 2.0)];
        assert_eq!(why(&inside, 1), Ok(()));
        // Two on the bottom, of three: corners do not count.
        let bottom = [(1.0, 0.0), (2.0, 0.0), (1.0, 1.0)];
        let edge = [ids[0], ids[1]];
        assert_eq!(why(&bottom, 1), Err(Cause::Edge { edge, data: 2 }));
        assert_eq!(why(&[(0.0, 0.0), (8.0, 0.0), (1.0, 1.0)], 1), Ok(()));
        // One on each leg, and the corner between them.
        let legs = [(1.0, 0.0), (0.0, 1.0), (0.0, 0.0)];
        let corner = ids[0];
        assert_eq!(why(&legs, 1), Err(Cause::TwoEdges { corner, data: 3 }));
        assert_eq!(why(&[legs[0], legs[1], (8.0, 0.0)], 1), Ok(()));
    }
}
