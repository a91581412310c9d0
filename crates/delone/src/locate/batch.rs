//! Many queries at once: in the order of a space-filling curve, so that each begins where the one before
//! has ended and what it reads is still at hand, and on several threads.

use crate::memory::reserve;
use crate::order::{Frame, Radix, sorted_keys};
use crate::parallel::{Workers, with_workers};
use crate::{Error, Phase, Point, Watch};
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

/// Queries that are answered in a row, and between two looks at the watch; few where Miri is to see threads.
const RUN: usize = if cfg!(miri) { 1 << 3 } else { 1 << 12 };

/// Refuses a point with a coordinate that is NaN or infinite.
pub(crate) fn check_finite(points: &[Point]) -> Result<(), Error> {
    match points.iter().position(|p| !p.is_finite()) {
        None => Ok(()),
        Some(index) => {
            let Point { x, y } = points[index];
            Err(Error::NotFinite { index, x, y })
        }
    }
}

/// Where what is asked about lies: queries outside of it are sorted as if they were at its border.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Spread {
    bounds: [[f64; 2]; 2],
}

impl Spread {
    /// Spreads queries over the box around `points`, of which there is at least one.
    pub fn around<'p>(points: impl IntoIterator<Item = &'p Point>) -> Self {
        let none = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
        let bounds = points.into_iter().fold(none, |[min, max], p| {
            [
                [min[0].min(p.x), min[1].min(p.y)],
                [max[0].max(p.x), max[1].max(p.y)],
            ]
        });
        Self { bounds }
    }

    /// Answers the query at each of `points`, and returns the answers in their order. The watch is told of
    /// the phase. Points that are not finite get their turn, too.
    ///
    /// `answer` gets what it left behind the time before, at first what `begin` returns, and the point. What
    /// it answers must not depend on what was left behind.
    pub fn answer<S, A: Send>(
        &self,
        points: &[Point],
        threads: Option<usize>,
        (watch, phase): (&dyn Watch, Phase),
        begin: impl Fn() -> S + Sync,
        answer: impl Fn(&mut S, Point) -> A + Sync,
    ) -> Result<Vec<A>, Error> {
        let answers = with_workers(threads, |workers| {
            let keys = self.sorted(points, workers, watch)?;
            let done = AtomicU64::new(0);
            let mut answers = reserve(points.len());
            let places = Places(answers.as_mut_ptr());
            let is_answered = workers.map(keys.chunks(RUN).collect(), |keys: &[u64]| {
                if watch.is_cancelled() {
                    return false;
                }
                let mut state = begin();
                // All at once: they lie far from each other in memory.
                let asked: Vec<Point> = indices(keys).map(|i| points[i]).collect();
                for (i, p) in indices(keys).zip(asked) {
                    let answer = answer(&mut state, p);
                    // SAFETY: the keys hold each index of `points` once, and there is room for as many.
                    unsafe { places.put(i, answer) };
                }
                let run = keys.len() as u64;
                let done = done.fetch_add(run, Relaxed) + run;
                watch.progress(phase, done, points.len() as u64);
                true
            });
            if is_answered.contains(&false) {
                let answered = keys.chunks(RUN).zip(is_answered).filter(|run| run.1);
                for i in answered.flat_map(|(keys, _)| indices(keys)) {
                    // SAFETY: the run of this place has written it, and nobody reads it any more.
                    unsafe { places.drop(i) };
                }
                return None;
            }
            // SAFETY: every place has been written.
            unsafe { answers.set_len(points.len()) };
            Some(answers)
        })?;
        answers.ok_or(Error::Cancelled)
    }

    /// Sorts queries along the curve; their numbers are the low halves. `None` if the watch cancelled.
    fn sorted(&self, points: &[Point], workers: Workers, watch: &dyn Watch) -> Option<Vec<u64>> {
        let radix = Radix::for_points(points.len());
        let [min, max] = self.bounds;
        let frame = Frame::new(min, max, radix.bits);
        let key = |p: Point| {
            // NaN stays, and has key 0.
            let [x, y] = [p.x.clamp(min[0], max[0]), p.y.clamp(min[1], max[1])];
            frame.key(Point::new(x, y))
        };
        sorted_keys(points, key, radix, workers, watch)
    }
}

/// Returns the numbers of the queries that have these keys.
fn indices(keys: &[u64]) -> impl Iterator<Item = usize> {
    keys.iter().map(|&key| key as u32 as usize)
}

/// Where several threads put answers, each to places of its own.
struct Places<A>(*mut A);
// SAFETY: every thread writes its own places only, and what it writes may be sent.
unsafe impl<A: Send> Sync for Places<A> {}

impl<A> Places<A> {
    /// # Safety
    /// `place` must be inside the target, and nobody else may write it.
    #[inline(always)]
    unsafe fn put(&self, place: usize, answer: A) {
        // SAFETY: as promised by the caller.
        unsafe { self.0.add(place).write(answer) }
    }

    /// # Safety
    /// An answer must have been put at `place`, and nobody may read it afterwards.
    unsafe fn drop(&self, place: usize) {
        // SAFETY: as promised by the caller.
        unsafe { self.0.add(place).drop_in_place() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::Arc;

    /// Cancels when the first answers are there.
    struct Hasty(AtomicU64);

    impl Watch for Hasty {
        fn progress(&self, phase: Phase, done: u64, _: u64) {
            if phase == Phase::Query {
                self.0.store(done, Relaxed);
            }
        }

        fn is_cancelled(&self) -> bool {
            self.0.load(Relaxed) > 0
        }
    }

    #[test]
    fn answers_in_vain_are_dropped() {
        let points = vec![Point::new(0.0, 0.0); 2 * RUN];
        let answer = Arc::new(());
        for threads in [1, 2] {
            let answers = Spread::around(&points).answer(
                &points,
                Some(threads),
                (&Hasty(0.into()), Phase::Query),
                || (),
                |(), _| answer.clone(),
            );
            // On two threads both runs may have begun.
            assert!(threads == 2 || answers.is_err());
            drop(answers);
            assert_eq!(Arc::strong_count(&answer), 1);
        }
    }
}
