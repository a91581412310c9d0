//! Splitting work over threads, or not: the one place that knows about `rayon`.

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

    /// Returns the length of the chunks in which `n` elements are shared out, `per_thread` a thread.
    pub fn chunk_len(self, n: usize, per_thread: usize) -> usize {
        /// Below this, handing work over costs more than doing it.
        const LEAST: usize = 1 << 14;
        if self.threads == 1 {
            return n.max(1);
        }
        n.div_ceil(self.threads * per_thread).max(LEAST)
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
        None => Ok(work(Workers {
            threads: rayon::current_num_threads(),
        })),
        Some(0 | 1) => Ok(work(Workers::ONE)),
        Some(threads) => with_pool(threads.min(MOST_THREADS), work),
    }
}

/// No machine gains from more threads, and starting them by the ten thousand stalls any.
#[cfg(feature = "rayon")]
const MOST_THREADS: usize = 1024;

/// Runs `work` in a pool of so many threads.
#[cfg(feature = "rayon")]
fn with_pool<R: Send>(
    threads: usize,
    work: impl FnOnce(Workers) -> R + Send,
) -> Result<R, crate::Error> {
    match threads {
        // The surrounding pool is the pool asked for: no need to start another.
        threads if threads == rayon::current_num_threads() => Ok(work(Workers { threads })),
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
