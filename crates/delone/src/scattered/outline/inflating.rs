//! The outer polygon of 3.27: the hull of the data, blown up, without corners that are not needed.
//!
//! One round, counter-clockwise, deletes the middle of three consecutive points when all data lie strictly left
//! of the line from the first to the third; the same first one goes on then. The text leaves the order open. Short
//! edges go that way, which would make small triangles.
//!
//! *Cost*: O(h log h) for h points on the hull's boundary.

use super::hull::{Hull, strict_hull};
use crate::Point;
use crate::predicates::Orientation;
use crate::scattered::extent::Extent;

/// Blows the hull up, by `factor` about the mean of its points. Returns a strictly convex polygon, or `None` if
/// that of rounded points does not contain the data.
pub(super) fn inflated(hull: &Hull, factor: f64) -> Option<Vec<Point>> {
    let scaled = scaled(hull.points(), factor)?;
    let corners = strict_hull(&without_needless(hull, &scaled));
    let sides = corners.iter().zip(corners.iter().cycle().skip(1));
    let mut sides = sides.map(|(&a, &b)| hull.rightmost_side([a, b]));
    let contains_all = corners.len() > 2 && sides.all(|side| side != Orientation::Right);
    contains_all.then_some(corners)
}

/// Scales points about their mean; `None` if one would be beyond the largest number.
fn scaled(points: &[Point], factor: f64) -> Option<Vec<Point>> {
    if factor == 1.0 {
        return Some(points.to_vec());
    }
    let all = || points.iter().copied();
    let mean = Extent::of(all())?.mean(all());
    let scale = |c: f64, mean: f64| factor * (c - mean) + mean + 0.0;
    let scaled = all().map(|p| Point::new(scale(p.x, mean.x), scale(p.y, mean.y)));
    let scaled: Vec<Point> = scaled.collect();
    scaled.iter().all(Point::is_finite).then_some(scaled)
}

/// Goes round once, and leaves out what is not needed.
fn without_needless(hull: &Hull, points: &[Point]) -> Vec<Point> {
    let count = points.len();
    let mut next: Vec<usize> = (1..count).chain([0]).collect();
    let mut is_kept = vec![true; count];
    let mut left = count;
    let mut first = 0;
    while left > 3 {
        let middle = next[first];
        let third = next[middle];
        if hull.rightmost_side([points[first], points[third]]) == Orientation::Left {
            next[first] = third;
            is_kept[middle] = false;
            left -= 1;
        } else {
            first = middle;
        }
        // The list is extended by its first two.
        if middle == 0 {
            break;
        }
    }
    let kept = points.iter().zip(is_kept).filter(|(_, is_kept)| *is_kept);
    kept.map(|(&p, _)| p).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::predicates::orient2d;
    use crate::scattered::samples;
    use delone_testkit::generate::Kind;

    /// As the text says it, testing all data.
    fn naive(data: &[Point], points: &[Point]) -> Vec<Point> {
        let mut list: Vec<usize> = (0..points.len()).collect();
        let mut i = 0;
        while i < list.len() && list.len() > 3 {
            let [a, b] = [i, i + 2].map(|k| points[list[k % list.len()]]);
            let middle = (i + 1) % list.len();
            if data.iter().all(|&p| orient2d(a, b, p) == Orientation::Left) {
                list.remove(middle);
                if middle == 0 {
                    break;
                }
            } else {
                i += 1;
            }
        }
        list.into_iter().map(|k| points[k]).collect()
    }

    #[test]
    fn a_round_deletes_what_the_naive_one_deletes() {
        let mut deleted = 0;
        for (kind, seed) in Kind::ALL
            .into_iter()
            .flat_map(|k| (0..8).map(move |s| (k, s)))
        {
            let data = samples(kind, 6 + 9 * seed as usize, seed);
            let Some(hull) = Hull::of(&data) else {
                continue;
            };
            for factor in [1.0, 1.001, 1.1, 2.0] {
                let Some(scaled) = scaled(hull.points(), factor) else {
                    continue;
                };
                let kept = without_needless(&hull, &scaled);
                assert_eq!(kept, naive(&data, &scaled), "{kind:?} {seed} {factor}");
                deleted += scaled.len() - kept.len();
            }
        }
        assert!(deleted > 100, "{deleted}");
    }

    #[test]
    fn a_square_keeps_its_corners() {
        let square = [
            [0.0, 0.0],
            [2.0, 0.0],
            [2.0, 2.0],
            [0.0, 2.0],
            [1.0, 0.0],
            [1.0, 2.0],
        ];
        let square = square.map(Point::from);
        let hull = Hull::of(&square).expect("a square");
        let corners = |factor: f64| inflated(&hull, factor).expect("room");
        let expected = [[2.0, 2.0], [0.0, 2.0], [0.0, 0.0], [2.0, 0.0]];
        assert_eq!(corners(1.0), expected.map(Point::from));
        let expected = [[3.0, 3.0], [-1.0, 3.0], [-1.0, -1.0], [3.0, -1.0]];
        assert_eq!(corners(2.0), expected.map(Point::from));
    }
}
