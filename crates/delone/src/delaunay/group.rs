//! Points that share a sort key: sorted among themselves, equal ones merged.
//!
//! `keys[i]` holds a key in its high half and the point's index in its low half. A point merged
//! into another gets NaN coordinates and the other's index in place of its key.

use super::input::Extent;
use crate::order::{Frame, Radix, sorted_keys};
use crate::parallel::Workers;
use crate::{Point, Watch};

const INDEX: u64 = 0xffff_ffff;

/// Groups up to this size are sorted by insertion.
const FEW: usize = 16;

/// Sorts points by x, then y, then index.
///
/// *Cost*: O(m log m) for m points.
pub(super) fn sort_lexicographically(points: &mut [Point], keys: &mut [u64]) {
    if points.len() <= FEW {
        return sort_few(points, keys);
    }
    let mut pairs: Vec<_> = points.iter().copied().zip(keys.iter().copied()).collect();
    pairs.sort_unstable_by(|(p, a), (q, b)| p.lex_cmp(q).then((a & INDEX).cmp(&(b & INDEX))));
    for ((point, key), pair) in points.iter_mut().zip(keys).zip(pairs) {
        (*point, *key) = pair;
    }
}

fn sort_few(points: &mut [Point], keys: &mut [u64]) {
    let rank = |p: Point, key: u64| ([p.x, p.y], key & INDEX);
    for end in 1..points.len() {
        let mut i = end;
        while i > 0 && rank(points[i], keys[i]) < rank(points[i - 1], keys[i - 1]) {
            points.swap(i, i - 1);
            keys.swap(i, i - 1);
            i -= 1;
        }
    }
}

/// Moves the first of each run of equal points to the front, in order, merges the others into
/// them and returns the number of distinct points.
pub(super) fn merge_equal(points: &mut [Point], keys: &mut [u64]) -> usize {
    let mut distinct = 1;
    for i in 1..points.len() {
        if points[i] == points[distinct - 1] {
            points[i] = Point::new(f64::NAN, f64::NAN);
            keys[i] = keys[distinct - 1] << 32 | keys[i] & INDEX;
        } else {
            points.swap(i, distinct);
            keys.swap(i, distinct);
            distinct += 1;
        }
    }
    distinct
}

/// What became of a group that was looked at in its own bounding box.
pub(super) enum Regrouped {
    /// Its points have fresh keys in this frame and are sorted by them, equal keys in the old order.
    Sorted(Frame),
    /// All its points are equal, and have been merged into the first.
    Equal,
}

/// Gives points fresh keys in their own bounding box and sorts by them; `None` if the watch
/// cancelled.
///
/// *Cost*: O(m) for m points, 40 bytes each.
pub(super) fn sort_in_own_box(
    points: &mut [Point],
    keys: &mut [u64],
    workers: Workers,
    watch: &dyn Watch,
) -> Option<Regrouped> {
    let Extent { min, max, .. } = Extent::of(points);
    if min == max {
        merge_equal(points, keys);
        return Some(Regrouped::Equal);
    }
    let radix = Radix::for_points(points.len());
    let frame = Frame::new(min, max, radix.bits);
    let order = sorted_keys(points, |p| frame.key(p), radix, workers, watch)?;
    let (old_points, old_keys) = (points.to_vec(), keys.to_vec());
    for (i, key) in order.into_iter().enumerate() {
        let from = (key & INDEX) as usize;
        points[i] = old_points[from];
        keys[i] = key & !INDEX | old_keys[from] & INDEX;
    }
    debug_assert!(
        keys[0] >> 32 < keys[keys.len() - 1] >> 32,
        "bug: no progress"
    );
    Some(Regrouped::Sorted(frame))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn group(coordinates: &[(f64, f64)]) -> (Vec<Point>, Vec<u64>) {
        let points = coordinates.iter().map(|&c| Point::from(c)).collect();
        let keys = (0..coordinates.len() as u64)
            .map(|i| 77 << 32 | i)
            .collect();
        (points, keys)
    }

    #[test]
    fn equal_points_merge_into_the_lowest_index() {
        let (mut points, mut keys) =
            group(&[(1.0, 2.0), (0.0, 0.0), (1.0, 2.0), (0.0, 0.0), (1.0, 2.0)]);
        sort_lexicographically(&mut points, &mut keys);
        assert_eq!(merge_equal(&mut points, &mut keys), 2);
        assert_eq!(points[..2], [Point::new(0.0, 0.0), Point::new(1.0, 2.0)]);
        assert_eq!([keys[0] & INDEX, keys[1] & INDEX], [1, 0]);
        let mut merged: Vec<_> = keys[2..].iter().map(|k| (k & INDEX, k >> 32)).collect();
        merged.sort_unstable();
        assert_eq!(merged, [(2, 0), (3, 1), (4, 0)]);
        assert!(points[2..].iter().all(|p| p.x.is_nan()));
    }

    #[test]
    fn a_box_of_its_own_tells_close_points_apart() {
        let close: Vec<_> = (0..40)
            .map(|i| (1.0 + f64::from(i * 7 % 40) * f64::EPSILON, 1.0))
            .collect();
        let (mut points, mut keys) = group(&close);
        let sorted = sort_in_own_box(&mut points, &mut keys, Workers::ONE, &());
        assert!(matches!(sorted, Some(Regrouped::Sorted(_))));
        assert!(points.is_sorted_by(|p, q| p.x < q.x));
        assert!(keys.is_sorted_by_key(|k| k >> 32));
        let (mut points, mut keys) = group(&[(3.0, 4.0); 20]);
        let equal = sort_in_own_box(&mut points, &mut keys, Workers::ONE, &());
        assert!(matches!(equal, Some(Regrouped::Equal)));
    }
}
