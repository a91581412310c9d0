//! Large arrays: zeroed by the system, in huge pages where it grants them.
//!
//! First touch of memory costs 0.3–0.4 ns a byte in pages of 4 KiB and a tenth of that in pages of
//! 2 MiB; at 100 bytes a point that is a good part of the whole triangulation.

use crate::{HalfEdgeId, Point, VertexId};
use std::alloc::{Layout, alloc_zeroed, handle_alloc_error};

/// Types for which all bits zero is a value.
///
/// # Safety
/// Implementers must be valid when every byte is zero.
pub(super) unsafe trait Zeroable: Copy {}
// SAFETY: an integer.
unsafe impl Zeroable for u32 {}
// SAFETY: an integer.
unsafe impl Zeroable for u64 {}
// SAFETY: two floats.
unsafe impl Zeroable for Point {}
// SAFETY: three integers.
unsafe impl Zeroable for [VertexId; 3] {}
// SAFETY: three integers.
unsafe impl Zeroable for [HalfEdgeId; 3] {}

/// Allocates `len` zeros without touching them.
pub(super) fn zeroed<T: Zeroable>(len: usize) -> Vec<T> {
    let layout = Layout::array::<T>(len).expect("bug: length checked by the caller");
    if layout.size() == 0 {
        return Vec::new();
    }
    // SAFETY: the layout has a size; the vector gets the very layout that was allocated, and
    // `Zeroable` vouches for the contents.
    let vec = unsafe {
        let start = alloc_zeroed(layout);
        if start.is_null() {
            handle_alloc_error(layout);
        }
        Vec::from_raw_parts(start.cast::<T>(), len, len)
    };
    advise_huge_pages(vec.as_ptr().cast(), layout.size());
    vec
}

/// Asks for huge pages where an array spans at least one.
#[cfg(target_os = "linux")]
fn advise_huge_pages(start: *const u8, size: usize) {
    const HUGE: usize = 2 << 20;
    if size < HUGE {
        return;
    }
    // Only whole pages inside the array, so that nobody else's memory is advised.
    let skip = start.align_offset(4096);
    let len = (size - skip) & !4095;
    // SAFETY: the range lies inside a live allocation, and advice does not change its contents.
    // A refusal is no error: the pages just stay small.
    unsafe {
        libc::madvise(start.add(skip).cast_mut().cast(), len, libc::MADV_HUGEPAGE);
    }
}

#[cfg(not(target_os = "linux"))]
fn advise_huge_pages(_start: *const u8, _size: usize) {}
