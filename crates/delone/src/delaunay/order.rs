//! Spatial order: Morton keys, a stable radix sort, and the points themselves moved, so that
//! neighbours in the plane become neighbours in memory.

use super::frame::{Frame, split_power};
use crate::memory::reserve;
use crate::parallel::Workers;
use crate::{Phase, Point, Watch};
use std::mem::MaybeUninit;

/// Elements between two looks at the watch.
const BLOCK: usize = 1 << 18;
/// Up to this size a comparison sort is as fast as clearing the histograms.
const FEW: usize = 1 << 10;

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
    let mut keys = sorted_keys(points, frame, radix, workers, watch)?;
    watch.progress(Phase::Sort, 1, 2);
    let points = gather(points, &keys, scale, workers, watch)?;
    keys.push(u64::MAX);
    watch.progress(Phase::Sort, 2, 2);
    Some(Ordered { points, keys })
}

/// Sorts the keys of `points` in `frame`, equal ones by index, with room for one more; the key is
/// the high half, the index the low half. `None` if the watch cancelled.
pub(super) fn sorted_keys(
    points: &[Point],
    frame: &Frame,
    radix: Radix,
    workers: Workers,
    watch: &dyn Watch,
) -> Option<Vec<u64>> {
    let n = points.len();
    let chunk = workers.chunk_len(n, 1);
    let mut keys = reserve::<u64>(n + 1);
    let jobs = keys.spare_capacity_mut()[..n]
        .chunks_mut(chunk)
        .zip(points.chunks(chunk))
        .zip((0..).step_by(chunk))
        .collect();
    let counts = workers.map(jobs, |((keys, points), first)| {
        fill(keys, points, first, frame, radix.digit_at(0))
    });
    // SAFETY: the jobs have written the first n keys.
    unsafe { keys.set_len(n) };
    if n <= FEW {
        keys.sort_unstable();
        Some(keys)
    } else {
        radix_sort(keys, radix, counts, workers, watch)
    }
}

/// Fills in the keys of the points from index `first` on, and counts their digits.
fn fill(
    keys: &mut [MaybeUninit<u64>],
    points: &[Point],
    first: u64,
    frame: &Frame,
    digit: Digit,
) -> Vec<u32> {
    let mut counts = vec![0; digit.buckets];
    // Small blocks: a key is counted while it is still in the first-level cache.
    for ((keys, points), first) in keys
        .chunks_mut(512)
        .zip(points.chunks(512))
        .zip((first..).step_by(512))
    {
        for ((key, &p), index) in keys.iter_mut().zip(points).zip(first..) {
            key.write(u64::from(frame.key(p)) << 32 | index);
        }
        // SAFETY: the loop has written all keys of this block.
        digit.count(unsafe { keys.assume_init_ref() }, &mut counts);
    }
    counts
}

/// Sorts by the low `bits` of the high halves, equal ones in their order. `None` if the watch
/// cancelled.
///
/// *Cost*: O(n), in as many passes as the bits ask for; 8 bytes an element.
pub(crate) fn sort_by_high_half(
    mut keys: Vec<u64>,
    bits: u32,
    workers: Workers,
    watch: &dyn Watch,
) -> Option<Vec<u64>> {
    if keys.len() <= FEW {
        keys.sort_by_key(|key| key >> 32);
        return Some(keys);
    }
    let radix = Radix::of_bits(bits.max(1));
    let digit = radix.digit_at(0);
    let chunk = workers.chunk_len(keys.len(), 1);
    let counts = workers.map(keys.chunks(chunk).collect(), |keys| digit.counts(keys));
    radix_sort(keys, radix, counts, workers, watch)
}

/// Sorts by the low bits of the high halves, stably, and leaves room for one more. `counts` holds, a
/// chunk each, how often each value of the first digit occurs.
fn radix_sort(
    mut keys: Vec<u64>,
    radix: Radix,
    mut counts: Vec<Vec<u32>>,
    workers: Workers,
    watch: &dyn Watch,
) -> Option<Vec<u64>> {
    let n = keys.len();
    let chunk = workers.chunk_len(n, 1);
    let mut sorted = reserve::<u64>(n + 1);
    for k in 0..radix.passes() {
        let digit = radix.digit_at(k);
        if k > 0 {
            counts = workers.map(keys.chunks(chunk).collect(), |keys| digit.counts(keys));
        }
        let jobs = keys.chunks(chunk).zip(places(counts)).collect();
        scatter(
            jobs,
            &mut sorted.spare_capacity_mut()[..n],
            digit,
            workers,
            watch,
        )?;
        // SAFETY: every key has been put in its place, and the places are 0..n.
        unsafe { sorted.set_len(n) };
        counts = Vec::new();
        std::mem::swap(&mut keys, &mut sorted);
        sorted.clear();
    }
    Some(keys)
}

/// A digit of a key: which bucket a counting pass puts it in.
#[derive(Clone, Copy)]
struct Digit {
    shift: u32,
    buckets: usize,
}

impl Digit {
    #[inline(always)]
    fn of(self, key: u64) -> usize {
        (key >> self.shift) as usize & (self.buckets - 1)
    }

    fn counts(self, keys: &[u64]) -> Vec<u32> {
        let mut counts = vec![0; self.buckets];
        self.count(keys, &mut counts);
        counts
    }

    fn count(self, keys: &[u64], counts: &mut [u32]) {
        for &key in keys {
            counts[self.of(key)] += 1;
        }
    }
}

/// Turns counts, a chunk each, into the places where each chunk's keys of each bucket begin.
fn places(mut counts: Vec<Vec<u32>>) -> Vec<Vec<u32>> {
    let mut next = 0;
    for bucket in 0..counts.first().map_or(0, Vec::len) {
        for counts in &mut counts {
            next += std::mem::replace(&mut counts[bucket], next);
        }
    }
    counts
}

/// One stable counting pass over a digit, each chunk to its own places.
fn scatter(
    jobs: Vec<(&[u64], Vec<u32>)>,
    to: &mut [MaybeUninit<u64>],
    digit: Digit,
    workers: Workers,
    watch: &dyn Watch,
) -> Option<()> {
    debug_assert_eq!(
        jobs.iter().map(|(keys, _)| keys.len()).sum::<usize>(),
        to.len()
    );
    let to = Places(to.as_mut_ptr().cast());
    let finished = workers.map(jobs, |(keys, mut places)| {
        for block in keys.chunks(BLOCK) {
            if watch.is_cancelled() {
                return None;
            }
            for &key in block {
                let place = &mut places[digit.of(key)];
                // SAFETY: the counts of all chunks and buckets cover 0..n once, and this chunk
                // has exactly as many keys of this digit as it has places.
                unsafe { to.put(*place as usize, key) };
                *place += 1;
            }
        }
        Some(())
    });
    finished.into_iter().collect()
}

/// The target of a scatter that several threads fill at disjoint places.
#[derive(Clone, Copy)]
struct Places(*mut u64);
// SAFETY: every thread writes its own places only.
unsafe impl Send for Places {}
// SAFETY: as for Send.
unsafe impl Sync for Places {}

impl Places {
    /// # Safety
    /// `place` must be inside the target, and no other thread may write it.
    #[inline(always)]
    unsafe fn put(self, place: usize, key: u64) {
        // SAFETY: as promised by the caller.
        unsafe { *self.0.add(place) = key }
    }
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

/// How keys are sorted: the number of their bits, and of the bits sorted in one pass.
#[derive(Clone, Copy, Debug)]
pub(super) struct Radix {
    pub bits: u32,
    digit: u32,
}

impl Radix {
    /// Chooses for `n` points: enough bits that few points share a cell, in as few passes as the
    /// caches allow (4096 write streams still do, in huge pages).
    pub fn for_points(n: usize) -> Self {
        let [bits, digit] = if n <= FEW {
            // Sorted by comparison, in no pass at all.
            [32, 0]
        } else if n < 1 << 13 {
            [18, 9]
        } else if n < 1 << 21 {
            [24, 12]
        } else {
            [32, 11]
        };
        Self { bits, digit }
    }

    /// Chooses for keys of so many bits the fewest passes of up to twelve of them.
    fn of_bits(bits: u32) -> Self {
        let digit = bits.div_ceil(bits.div_ceil(12));
        Self { bits, digit }
    }

    fn passes(self) -> u32 {
        self.bits.div_ceil(self.digit)
    }

    fn digit_at(self, pass: u32) -> Digit {
        Digit {
            shift: 32 + pass * self.digit,
            buckets: 1 << self.digit,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::delaunay::input::Extent;
    use crate::parallel::with_workers;

    fn scattered(n: u32) -> Vec<Point> {
        let mix = |i: u32| f64::from(i.wrapping_mul(2_654_435_761) % 1009);
        (0..n)
            .map(|i| Point::new(mix(i), mix(i ^ 0x5555)))
            .collect()
    }

    fn ordered(points: &[Point], threads: usize) -> Ordered {
        let extent = Extent::of(points);
        let radix = Radix::for_points(points.len());
        let frame = Frame::new(extent.min, extent.max, radix.bits);
        with_workers(Some(threads), |workers| {
            order(points, &frame, radix, 0, workers, &())
        })
        .unwrap()
        .unwrap()
    }

    #[test]
    fn keys_come_sorted_and_stable_with_their_points() {
        for n in [1, 7, 1000, 1025, 9000, 50_000] {
            let points = scattered(n);
            let Ordered {
                points: sorted,
                keys,
            } = ordered(&points, 1);
            assert!(
                keys.is_sorted(),
                "{n}: equal keys stay in the order of their indices"
            );
            for (p, key) in sorted.iter().zip(&keys[..n as usize]) {
                assert_eq!(*p, points[*key as u32 as usize]);
            }
        }
    }

    #[test]
    fn threads_do_not_change_the_order() {
        let points = scattered(100_000);
        assert_eq!(ordered(&points, 1).keys, ordered(&points, 3).keys);
    }

    #[test]
    fn high_halves_are_sorted_stably_whatever_their_bits() {
        for (n, bits) in [(0, 1), (500, 7), (5000, 1), (5000, 13), (70_000, 30)] {
            let key = |i: u64| (i.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> (64 - bits)) << 32 | i;
            let keys: Vec<u64> = (0..n).map(key).collect();
            let mut expected = keys.clone();
            expected.sort();
            for threads in [1, 3] {
                let sorted = with_workers(Some(threads), |workers| {
                    sort_by_high_half(keys.clone(), bits, workers, &())
                });
                assert_eq!(sorted.unwrap().unwrap(), expected);
            }
        }
    }

    #[test]
    fn negative_zero_becomes_zero() {
        let sorted = ordered(&[Point::new(-0.0, 1.0)], 1).points;
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
        let points = scattered(5000);
        let result = crate::Delaunay::new().watch(&Impatient).triangulate(points);
        assert_eq!(result.unwrap_err(), crate::Error::Cancelled);
    }
}
