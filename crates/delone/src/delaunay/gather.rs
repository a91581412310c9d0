//! The points of an input in the order of the curve, moved so that neighbours in the plane become
//! neighbours in memory.

use crate::memory::reserve;
use crate::order::{Frame, Radix, sorted_keys, split_power};
use crate::parallel::Workers;
use crate::{Phase, Point, Watch};
use std::mem::MaybeUninit;

/// Elements between two looks at the watch.
const BLOCK: usize = 1 << 18;

/// Points in curve order with their keys, each with one more element that stands for infinity.
pub(super) struct Ordered {
    pub points: Vec<Point>,
    /// The key in the high half, the caller's index in the low half.
    pub keys: Vec<u64>,
}

/// Where the point at infinity is put: beyond every ordinary point, and with a square that does not
/// overflow. No decision rests on it; it only lets the filter find most ghosts outside by itself.
const FAR: f64 = f64::from_bits((1023 + 400) << 52);

/// Orders `points` by their keys in `frame`, equal keys by index, and multiplies them by 2^`scale`;
/// `None` if the watch cancelled.
///
/// *Cost*: O(n) time, 24 bytes a point.
pub(super) fn order(
    points: &[Point],
    frame: &Frame,
    radix: Radix,
    scale: i32,
    workers: Workers,
    watch: &dyn Watch,
) -> Option<Ordered> {
    let mut keys = sorted_keys(points, |p| frame.key(p), radix, workers, watch)?;
    watch.progress(Phase::Sort, 1, 2);
    let points = gather(points, &keys, scale, workers, watch)?;
    keys.push(u64::MAX);
    watch.progress(Phase::Sort, 2, 2);
    Some(Ordered { points, keys })
}

/// Collects the points in the order of the keys.
fn gather(
    points: &[Point],
    keys: &[u64],
    scale: i32,
    workers: Workers,
    watch: &dyn Watch,
) -> Option<Vec<Point>> {
    let n = keys.len();
    let factors = split_power(scale);
    let mut ordered = reserve::<Point>(n + 1);
    let chunk = workers.chunk_len(n, 4).min(BLOCK);
    let jobs = ordered.spare_capacity_mut()[..n]
        .chunks_mut(chunk)
        .zip(keys.chunks(chunk))
        .collect();
    let finished = workers.map(
        jobs,
        |(ordered, keys): (&mut [MaybeUninit<Point>], &[u64])| {
            if watch.is_cancelled() {
                return None;
            }
            for (to, &key) in ordered.iter_mut().zip(keys) {
                let p = points[key as u32 as usize];
                // Adding zero turns −0.0 into 0.0.
                let place = |c: f64| c * factors[0] * factors[1] + 0.0;
                to.write(Point::new(place(p.x), place(p.y)));
            }
            Some(())
        },
    );
    finished.into_iter().collect::<Option<()>>()?;
    // SAFETY: the jobs have written the first n points.
    unsafe { ordered.set_len(n) };
    ordered.push(Point::new(FAR, FAR));
    Some(ordered)
}

#[cfg(test)]
mod tests {
    use super::super::input::Extent;
    use super::*;
    use crate::parallel::with_workers;

    fn ordered(points: &[Point]) -> Ordered {
        let extent = Extent::of(points);
        let radix = Radix::for_points(points.len());
        let frame = Frame::new(extent.min, extent.max, radix.bits);
        let order = |workers| order(points, &frame, radix, 0, workers, &());
        with_workers(Some(1), order).unwrap().unwrap()
    }

    #[test]
    fn points_come_with_their_keys() {
        let mix = |i: u32| f64::from(i.wrapping_mul(2_654_435_761) % 1009);
        let points: Vec<_> = (0..9000)
            .map(|i| Point::new(mix(i), mix(i ^ 0x5555)))
            .collect();
        let found = ordered(&points);
        for (p, key) in found.points.iter().zip(&found.keys[..points.len()]) {
            assert_eq!(*p, points[*key as u32 as usize]);
        }
    }

    #[test]
    fn negative_zero_becomes_zero() {
        let sorted = ordered(&[Point::new(-0.0, 1.0)]).points;
        assert!(sorted[0].x.is_sign_positive());
    }

    struct Impatient;
    impl Watch for Impatient {
        fn is_cancelled(&self) -> bool {
            true
        }
    }

    #[test]
    fn a_watch_can_cancel() {
        let points = vec![Point::new(0.0, 1.0); 5000];
        let result = crate::Delaunay::new().watch(&Impatient).triangulate(points);
        assert_eq!(result.unwrap_err(), crate::Error::Cancelled);
    }
}
