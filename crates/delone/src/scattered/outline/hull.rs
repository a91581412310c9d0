//! The hull of the data, as 3.17 lists it: all points on its boundary, counter-clockwise from the rightmost.
//!
//! Two chains of points sorted by (x, y) (Andrew, *Another efficient algorithm for convex hulls in two
//! dimensions*, 1979). Along each chain the directions of edges turn counter-clockwise, within half a circle; so
//! the point that is farthest to the right of a direction is found by bisection.

use crate::Point;
use crate::predicates::{Orientation, orient2d, turning};

/// The points on the boundary of a convex hull that is no segment.
#[derive(Clone, Debug)]
pub(super) struct Hull {
    /// From the rightmost, of several the topmost, counter-clockwise, and that one again at the end.
    ring: Vec<Point>,
    /// Where among them the leftmost is, of several the lowest.
    leftmost: usize,
}

impl Hull {
    /// Finds the hull; `None` if all points lie on one line. *Cost*: O(n log n).
    pub fn of(points: &[Point]) -> Option<Self> {
        let mut sorted = points.to_vec();
        sorted.sort_unstable_by(Point::lex_cmp);
        sorted.dedup();
        let is_dent = |side| side == Orientation::Right;
        let above = chain(sorted.iter().rev().copied(), |p| p, is_dent);
        let below = chain(sorted.iter().copied(), |p| p, is_dent);
        // On one line nothing is a dent.
        if above.len().min(below.len()) == sorted.len() {
            return None;
        }
        let leftmost = above.len() - 1;
        let ring = above.into_iter().chain(below.into_iter().skip(1)).collect();
        Some(Self { ring, leftmost })
    }

    /// Returns the points, each once.
    pub fn points(&self) -> &[Point] {
        &self.ring[..self.ring.len() - 1]
    }

    /// Tells on which side of the line from `a` to `b` that point lies that is farthest to the right, so that
    /// all are strictly left of it, or left of it or on it. *Cost*: O(log h).
    pub fn rightmost_side(&self, [a, b]: [Point; 2]) -> Orientation {
        let chain = match a.lex_cmp(&b).is_lt() {
            true => &self.ring[self.leftmost..],
            false => &self.ring[..=self.leftmost],
        };
        // Edges that lead to the right come first.
        let (mut first, mut last) = (0, chain.len() - 1);
        while first < last {
            let middle = first.midpoint(last);
            match turning([a, b], [chain[middle], chain[middle + 1]]) {
                Orientation::Right => first = middle + 1,
                _ => last = middle,
            }
        }
        orient2d(a, b, chain[first])
    }
}

/// Finds the strictly convex hull of places, counter-clockwise from the one that is listed first among its
/// corners. Fewer than three if they lie on one line.
pub(super) fn strict_hull(places: &[Point]) -> Vec<Point> {
    let at = |i: usize| places[i];
    let mut sorted: Vec<usize> = (0..places.len()).collect();
    sorted.sort_by(|&i, &j| at(i).lex_cmp(&at(j)));
    sorted.dedup_by(|i, kept| at(*i) == at(*kept));
    let is_dent = |side| side != Orientation::Left;
    let mut ring = chain(sorted.iter().rev().copied(), at, is_dent);
    ring.pop();
    ring.extend(chain(sorted.into_iter(), at, is_dent));
    ring.pop();
    let first = (0..ring.len()).min_by_key(|&k| ring[k]).unwrap_or(0);
    ring.rotate_left(first);
    ring.into_iter().map(at).collect()
}

/// Deletes dents from sorted items: the middle of three on the wrong side.
fn chain<T: Copy>(
    sorted: impl Iterator<Item = T>,
    at: impl Fn(T) -> Point,
    is_dent: impl Fn(Orientation) -> bool,
) -> Vec<T> {
    let mut chain: Vec<T> = Vec::new();
    for c in sorted {
        while let [.., a, b] = chain[..]
            && is_dent(orient2d(at(a), at(b), at(c)))
        {
            chain.pop();
        }
        chain.push(c);
    }
    chain
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scattered::samples;
    use delone_testkit::generate::Kind;

    /// Whether a point is on the boundary: all others lie in a closed half-plane.
    fn is_on_boundary(points: &[Point], p: Point) -> bool {
        let others = || points.iter().filter(|&&q| q != p);
        others().any(|&q| others().all(|&r| orient2d(p, q, r) != Orientation::Right))
    }

    #[test]
    fn all_points_on_the_boundary_are_listed_in_the_order_of_the_text() {
        for (kind, seed) in Kind::ALL
            .into_iter()
            .flat_map(|k| (0..6).map(move |s| (k, s)))
        {
            let mut points = samples(kind, 3 + 7 * seed as usize, seed);
            let hull = Hull::of(&points);
            points.sort_by(Point::lex_cmp);
            points.dedup();
            let is_line = points
                .windows(3)
                .all(|w| orient2d(w[0], w[1], w[2]) == Orientation::Collinear);
            assert_eq!(hull.is_none(), is_line);
            let Some(hull) = hull else { continue };
            let listed = hull.points();
            assert_eq!(listed.first(), points.last());
            for (i, &p) in listed.iter().enumerate() {
                let q = listed[(i + 1) % listed.len()];
                assert!(
                    points
                        .iter()
                        .all(|&r| orient2d(p, q, r) != Orientation::Right)
                );
            }
            let mut sorted = listed.to_vec();
            sorted.sort_by(Point::lex_cmp);
            points.retain({
                let all = points.clone();
                move |&p| is_on_boundary(&all, p)
            });
            assert_eq!(sorted, points, "{kind:?}");
        }
    }

    #[test]
    fn the_rightmost_point_decides_for_all() {
        for (kind, seed) in Kind::ALL
            .into_iter()
            .flat_map(|k| (0..4).map(move |s| (k, s)))
        {
            let points = samples(kind, 40, seed);
            let Some(hull) = Hull::of(&points) else {
                continue;
            };
            for (&a, &b) in points.iter().zip(&samples(kind, 40, seed + 100)) {
                let all = |wanted: fn(Orientation) -> bool| {
                    points.iter().all(|&p| wanted(orient2d(a, b, p)))
                };
                let side = hull.rightmost_side([a, b]);
                assert_eq!(side == Orientation::Left, all(|s| s == Orientation::Left));
                assert_eq!(side != Orientation::Right, all(|s| s != Orientation::Right));
            }
        }
    }

    #[test]
    fn strict_hulls_have_no_straight_corners_and_keep_the_first() {
        let at = |x, y| Point::new(x, y);
        let places = [
            at(1.0, 0.0),
            at(2.0, 0.0),
            at(2.0, 1.0),
            at(2.0, 2.0),
            at(0.0, 2.0),
            at(0.0, 0.0),
        ];
        let corners = [at(2.0, 0.0), at(2.0, 2.0), at(0.0, 2.0), at(0.0, 0.0)];
        assert_eq!(strict_hull(&places), corners);
        assert!(strict_hull(&[at(0.0, 0.0), at(1.0, 1.0), at(2.0, 2.0)]).len() < 3);
        assert!(strict_hull(&[at(0.0, 0.0); 4]).len() < 3);
        assert!(strict_hull(&[]).is_empty());
    }
}
