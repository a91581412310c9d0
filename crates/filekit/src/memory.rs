//! Counts memory, of all threads together.

use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

/// Bytes that all of a program may take at once; who asks for more ends the program, as a computer would.
pub const LIMIT: usize = 2 << 30;

/// The allocator of every program with this crate in it.
#[global_allocator]
static COUNTING: Counting = Counting;

static NOW: AtomicUsize = AtomicUsize::new(0);
static PEAK: AtomicUsize = AtomicUsize::new(0);

struct Counting;

impl Counting {
    fn grown(bytes: usize) {
        let now = NOW.fetch_add(bytes, Relaxed).saturating_add(bytes);
        if now > LIMIT {
            // Printing may allocate: forget what was asked for.
            NOW.store(0, Relaxed);
            eprintln!("more than {LIMIT} bytes at once: {bytes} are asked for");
            std::process::abort();
        }
        PEAK.fetch_max(now, Relaxed);
    }

    fn shrunk(bytes: usize) {
        NOW.fetch_sub(bytes, Relaxed);
    }
}

// SAFETY: the system's allocator does all the work.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        Self::grown(layout.size());
        // SAFETY: as the caller promises.
        unsafe { System.alloc(layout) }
    }

    // What is zeroed need not be touched by the system, but it is asked for all the same.
    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        Self::grown(layout.size());
        // SAFETY: as the caller promises.
        unsafe { System.alloc_zeroed(layout) }
    }

    unsafe fn dealloc(&self, place: *mut u8, layout: Layout) {
        Self::shrunk(layout.size());
        // SAFETY: as the caller promises.
        unsafe { System.dealloc(place, layout) }
    }

    unsafe fn realloc(&self, place: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        Self::grown(size);
        Self::shrunk(layout.size());
        // SAFETY: as the caller promises.
        unsafe { System.realloc(place, layout, size) }
    }
}

/// Measures the memory that something takes beyond what was taken before.
#[derive(Clone, Copy, Debug)]
pub struct Meter {
    before: usize,
}

impl Meter {
    /// Begins to measure; one at a time.
    pub fn start() -> Self {
        let before = NOW.load(Relaxed);
        PEAK.store(before, Relaxed);
        Self { before }
    }

    /// Returns the most bytes since then.
    pub fn peak(self) -> usize {
        PEAK.load(Relaxed).saturating_sub(self.before)
    }
}
