//! Splitting work over threads, or not: the one place that knows about `rayon`.

use std::ops::Range;

/// Where work may run: on the current thread, or on those of the surrounding `rayon` pool.
///
/// Results never depend on the number of threads.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Workers {
    threads: usize,
}

impl Workers {
    /// The current thread alone.
    pub const ONE: Self = Self { threads: 1 };

    /// Those of the surrounding pool.
    pub fn around() -> Self {
        #[cfg(feature = "rayon")]
        return Self {
            threads: rayon::current_num_threads(),
        };
        #[cfg(not(feature = "rayon"))]
        Self::ONE
    }

    /// Runs two tasks, at once if there are threads for it.
    #[inline]
    pub fn join<A: Send, B: Send>(
        self,
        a: impl FnOnce() -> A + Send,
        b: impl FnOnce() -> B + Send,
    ) -> (A, B) {
        #[cfg(feature = "rayon")]
        if self.threads > 1 {
            return rayon::join(a, b);
        }
        (a(), b())
    }

    /// Runs `work` on every job and returns the results in the order of the jobs.
    pub fn map<J: Send, R: Send>(
        self,
        jobs: Vec<J>,
        work: impl Fn(J) -> R + Send + Sync,
    ) -> Vec<R> {
        #[cfg(feature = "rayon")]
        if self.threads > 1 && jobs.len() > 1 {
            use rayon::prelude::*;
            return jobs.into_par_iter().with_max_len(1).map(work).collect();
        }
        jobs.into_iter().map(work).collect()
    }

    /// Cuts `0..n` into ranges, each long enough to be handed over, one of them if there is one thread, and
    /// runs `work` on each; the results are in order, or the first error.
    pub fn ranges<R: Send, E: Send>(
        self,
        n: usize,
        work: impl Fn(Range<usize>) -> Result<R, E> + Send + Sync,
    ) -> Result<Vec<R>, E> {
        let len = self.chunk_len(n, 4);
        let starts = (0..n).step_by(len);
        let ranges = starts.map(|start| start..n.min(start + len));
        self.map(ranges.collect(), work).into_iter().collect()
    }

    /// Returns the length of the chunks in which `n` elements are shared out, `per_thread` a thread.
    pub fn chunk_len(self, n: usize, per_thread: usize) -> usize {
        /// Below this, handing work over costs more than doing it; Miri is to see small work handed over.
        const LEAST: usize = if cfg!(miri) { 8 } else { 1 << 14 };
        if self.threads == 1 {
            return n.max(1);
        }
        n.div_ceil(self.threads * per_thread).max(LEAST)
    }
}

/// Puts lists together that [`ranges`](Workers::ranges) has made; a single one stays where it is.
pub(crate) fn joined<T: Copy>(mut lists: Vec<Vec<T>>) -> Vec<T> {
    match &mut lists[..] {
        [list] => std::mem::take(list),
        lists => lists.concat(),
    }
}

/// Runs `work` with all that it asks of the library on so many threads, unless a number of threads is set
/// there.
///
/// Functions without a setting for threads, such as [`Voronoi::new`](crate::voronoi::Voronoi::new), run on
/// those of the surrounding `rayon` pool, or else on as many as the machine has. 0 counts as 1. Without the
/// feature `rayon` there is but the caller's thread. Results do not depend on it.
///
/// ```
/// use delone::voronoi::Voronoi;
/// let t = delone::triangulate([(0.0, 0.0), (4.0, 0.0), (2.0, 3.0)])?;
/// let voronoi = delone::on_threads(2, || Voronoi::new(&t, &()))??;
/// assert_eq!(voronoi.edges().len(), 3);
/// # Ok::<(), delone::Error>(())
/// ```
///
/// # Errors
/// [`Error::Threads`](crate::Error::Threads) if so many threads cannot be started.
///
/// *Cost*: some 50 µs a thread, which is started and ends with the call, unless the surrounding pool is as
/// large.
pub fn on_threads<R: Send>(
    threads: usize,
    work: impl FnOnce() -> R + Send,
) -> Result<R, crate::Error> {
    #[cfg(feature = "rayon")]
    return with_pool(threads.clamp(1, MOST_THREADS), |_| work());
    #[cfg(not(feature = "rayon"))]
    {
        let _ = threads;
        Ok(work())
    }
}

/// Runs `work` with the workers that `threads` asks for: `None` stands for all of the surrounding
/// pool, a number for a pool of that size, made for this call.
#[cfg(feature = "rayon")]
pub(crate) fn with_workers<R: Send>(
    threads: Option<usize>,
    work: impl FnOnce(Workers) -> R + Send,
) -> Result<R, crate::Error> {
    match threads {
        None => Ok(work(Workers::around())),
        Some(0 | 1) => Ok(work(Workers::ONE)),
        Some(threads) => with_pool(threads.min(MOST_THREADS), work),
    }
}

/// No machine gains from more threads, and starting them by the ten thousand stalls any.
#[cfg(feature = "rayon")]
const MOST_THREADS: usize = 1024;

/// Runs `work` in a pool of so many threads.
///
/// Outside of all pools the surrounding one is that of the machine. To ask how large it is starts it, with a thread for
/// each core: too much for whoever wants but one.
#[cfg(feature = "rayon")]
fn with_pool<R: Send>(
    threads: usize,
    work: impl FnOnce(Workers) -> R + Send,
) -> Result<R, crate::Error> {
    let is_inside = rayon::current_thread_index().is_some();
    let is_worth_asking = threads > 1 || is_inside;
    match threads {
        // The surrounding pool is the pool asked for: no need to start another.
        threads if is_worth_asking && threads == rayon::current_num_threads() => {
            Ok(work(Workers { threads }))
        }
        threads => {
            let pool = rayon::ThreadPoolBuilder::new()
                .num_threads(threads)
                .build()
                .map_err(|reason| crate::Error::Threads {
                    threads,
                    reason: reason.to_string(),
                })?;
            // The pool may be smaller than asked for.
            let threads = pool.current_num_threads();
            Ok(pool.install(|| work(Workers { threads })))
        }
    }
}

/// Runs `work` on the current thread: without the feature `rayon` there are no others.
#[cfg(not(feature = "rayon"))]
pub(crate) fn with_workers<R: Send>(
    _threads: Option<usize>,
    work: impl FnOnce(Workers) -> R + Send,
) -> Result<R, crate::Error> {
    Ok(work(Workers::ONE))
}
