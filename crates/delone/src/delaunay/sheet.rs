//! The working store of divide and conquer: points in curve order, and two triangle slots a point.
//!
//! Slots are written by several threads at once, each in its own slice, so access goes through raw
//! pointers. While merging, every ghost keeps the infinite vertex in corner 0:
//!
//! ```text
//!   ghost of hull edge a → b (the hull counter-clockwise)      handle g = 3 · slot
//!     corners  g: infinite   g+1: b   g+2: a
//!     twins    g: the hull edge's inner side
//!              g+1: the ghost before (its half-edge +2)   g+2: the ghost after (its half-edge +1)
//! ```

use crate::{HalfEdgeId, Point, VertexId};
use std::mem::MaybeUninit;

/// Marks a slot that holds neither triangle nor ghost: its point was a duplicate.
pub(super) const DEAD: u32 = u32::MAX;

/// Raw access to points and slots; copied freely between the threads of one triangulation.
///
/// # Safety
/// All methods rely on three invariants, which the builder keeps and debug builds assert:
/// vertices are below `num_points` or equal to it (the vertex at infinity, which has a sentinel
/// position), half-edges are below `num_half_edges`, and two threads never touch the same slot:
/// a subproblem on points `lo..hi` owns slots `2 lo..2 hi`, and twins never leave its slice.
#[derive(Clone, Copy)]
pub(super) struct Sheet {
    points: *mut Point,
    keys: *mut u64,
    corners: *mut u32,
    twins: *mut u32,
    num_points: u32,
}

// SAFETY: threads work on disjoint slices, see the invariants above.
unsafe impl Send for Sheet {}
// SAFETY: as for Send.
unsafe impl Sync for Sheet {}

impl Sheet {
    /// Borrows the arrays: n + 1 points and keys (the last one stands for infinity), 2n rows of
    /// corners and twins.
    ///
    /// # Safety
    /// The arrays must outlive every copy of the sheet, and nobody else may touch them meanwhile.
    pub unsafe fn new(
        points: &mut [Point],
        keys: &mut [u64],
        corners: &mut [MaybeUninit<[VertexId; 3]>],
        twins: &mut [MaybeUninit<[HalfEdgeId; 3]>],
    ) -> Self {
        let num_points = points.len() - 1;
        assert!(keys.len() > num_points && corners.len() >= 2 * num_points);
        assert!(twins.len() >= 2 * num_points);
        Self {
            points: points.as_mut_ptr(),
            keys: keys.as_mut_ptr(),
            corners: corners.as_mut_ptr().cast(),
            twins: twins.as_mut_ptr().cast(),
            num_points: num_points as u32,
        }
    }

    /// The vertex at infinity.
    #[inline(always)]
    pub fn infinite(self) -> u32 {
        self.num_points
    }

    #[inline(always)]
    fn check_half_edge(self, h: u32) {
        debug_assert!(h < 6 * self.num_points, "bug: half-edge {h} out of range");
    }

    #[inline(always)]
    pub fn point(self, v: u32) -> Point {
        debug_assert!(v <= self.num_points, "bug: vertex {v} out of range");
        // SAFETY: v is at most num_points, and the array holds one more.
        unsafe { *self.points.add(v as usize) }
    }

    #[inline(always)]
    pub fn corner(self, h: u32) -> u32 {
        self.check_half_edge(h);
        // SAFETY: h is in range.
        unsafe { *self.corners.add(h as usize) }
    }

    #[inline(always)]
    pub fn set_corner(self, h: u32, v: u32) {
        self.check_half_edge(h);
        // SAFETY: h is in range and in the caller's slice.
        unsafe { *self.corners.add(h as usize) = v }
    }

    #[inline(always)]
    pub fn twin(self, h: u32) -> u32 {
        self.check_half_edge(h);
        // SAFETY: h is in range.
        unsafe { *self.twins.add(h as usize) }
    }

    /// Makes `g` and `h` twins.
    #[inline(always)]
    pub fn bond(self, g: u32, h: u32) {
        self.check_half_edge(g);
        self.check_half_edge(h);
        // SAFETY: both are in range and in the caller's slice.
        unsafe {
            *self.twins.add(g as usize) = h;
            *self.twins.add(h as usize) = g;
        }
    }

    /// Writes one half-edge of a template.
    #[inline(always)]
    pub fn set_half_edge(self, h: u32, corner: u32, twin: u32) {
        self.set_corner(h, corner);
        // SAFETY: h was checked by `set_corner`, and is in the caller's slice.
        unsafe { *self.twins.add(h as usize) = twin }
    }

    /// Writes the corners of the face at handle `t`.
    #[inline(always)]
    pub fn set_face(self, t: u32, corners: [u32; 3]) {
        self.set_corner(t, corners[0]);
        self.set_corner(t + 1, corners[1]);
        self.set_corner(t + 2, corners[2]);
    }

    /// Makes the face at handle `t` the ghost of hull edge `a → b`.
    #[inline(always)]
    pub fn set_ghost(self, t: u32, a: u32, b: u32) {
        self.set_face(t, [self.infinite(), b, a]);
    }

    /// Links ghost `g` to the ghost `after` it around the hull.
    #[inline(always)]
    pub fn link_ghosts(self, g: u32, after: u32) {
        self.bond(g + 2, after + 1);
    }

    /// Marks the face at handle `t` as holding nothing; only its first corner says so.
    #[inline(always)]
    pub fn kill(self, t: u32) {
        self.set_corner(t, DEAD);
    }

    /// Moves the face at handle `from` into the empty slot at handle `to`.
    pub fn relocate(self, from: u32, to: u32) {
        for k in 0..3 {
            self.set_corner(to + k, self.corner(from + k));
            self.bond(to + k, self.twin(from + k));
        }
        self.kill(from);
    }

    /// The number of vertex `v` in the caller's numbering.
    #[inline(always)]
    pub fn name(self, v: u32) -> VertexId {
        debug_assert!(v < self.num_points);
        // SAFETY: v is in range.
        VertexId::from(unsafe { *self.keys.add(v as usize) } as u32)
    }

    /// The sort key of the point at position `i`, in the frame of its group.
    #[inline(always)]
    pub fn key(self, i: usize) -> u32 {
        debug_assert!(i < self.num_points as usize);
        // SAFETY: i is in range.
        (unsafe { *self.keys.add(i) } >> 32) as u32
    }

    /// The points and keys at positions `lo..hi`, to be reordered by the subproblem that owns them.
    ///
    /// # Safety
    /// The caller must own positions `lo..hi` and drop the slices before it calls anything else.
    #[allow(clippy::mut_from_ref)]
    pub unsafe fn group(&self, lo: usize, hi: usize) -> (&mut [Point], &mut [u64]) {
        debug_assert!(lo <= hi && hi <= self.num_points as usize);
        // SAFETY: in range, and owned by the caller alone.
        unsafe {
            (
                std::slice::from_raw_parts_mut(self.points.add(lo), hi - lo),
                std::slice::from_raw_parts_mut(self.keys.add(lo), hi - lo),
            )
        }
    }
}
