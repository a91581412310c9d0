//! Spatial order: Morton keys and a stable radix sort, so that neighbours in the plane become
//! neighbours in memory, whether they are points of an input or questions about one.

mod frame;

pub(crate) use frame::{Axis, Frame, exponent, split_power};

use crate::memory::reserve;
use crate::parallel::Workers;
use crate::{Point, Watch};
use std::mem::MaybeUninit;

/// Elements between two looks at the watch.
const BLOCK: usize = 1 << 18;
/// Up to this size a comparison sort is as fast as clearing the histograms; Miri is to see both ways.
const FEW: usize = if cfg!(miri) { 1 << 5 } else { 1 << 10 };

/// Sorts the keys that `key` gives to `points`, equal ones by index, with room for one more; the key
/// is the high half, the index the low half. `None` if the watch cancelled.
///
/// *Cost*: O(n) time, 16 bytes a point.
pub(crate) fn sorted_keys(
    points: &[Point],
    key: impl Fn(Point) -> u32 + Sync,
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
        fill(keys, points, first, &key, radix.digit_at(0))
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
    key_of: impl Fn(Point) -> u32,
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
            key.write(u64::from(key_of(p)) << 32 | index);
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

/// How keys are sorted: the number of their bits, and of the bits sorted in one pass.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Radix {
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
    use crate::parallel::with_workers;

    fn scattered(n: u32) -> Vec<Point> {
        let mix = |i: u32| f64::from(i.wrapping_mul(2_654_435_761) % 1009);
        (0..n)
            .map(|i| Point::new(mix(i), mix(i ^ 0x5555)))
            .collect()
    }

    fn sorted(points: &[Point], threads: usize) -> Vec<u64> {
        let radix = Radix::for_points(points.len());
        let frame = Frame::new([0.0; 2], [1008.0; 2], radix.bits);
        with_workers(Some(threads), |workers| {
            sorted_keys(points, |p| frame.key(p), radix, workers, &())
        })
        .unwrap()
        .unwrap()
    }

    #[test]
    fn keys_come_sorted_and_each_index_once() {
        for n in [1, 7, 1000, 1025, 9000, 50_000] {
            let keys = sorted(&scattered(n), 1);
            assert!(
                keys.is_sorted(),
                "{n}: equal keys stay in the order of their indices"
            );
            let mut indices: Vec<u32> = keys.iter().map(|&key| key as u32).collect();
            indices.sort_unstable();
            assert!(indices.into_iter().eq(0..n));
        }
    }

    #[test]
    fn threads_do_not_change_the_order() {
        let points = scattered(100_000);
        assert_eq!(sorted(&points, 1), sorted(&points, 3));
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
}
