//! Divide and conquer over points in curve order.
//!
//! The sorted keys are the cuts (see [`Frame`]): a range of points is halved where the highest bit
//! in which its keys differ changes. n points have exactly 2n − 2 faces, ghosts included, even if
//! they are collinear; a range `lo..hi` owns the slots `2 lo..2 hi` and always leaves its last two
//! free, and a merge at `mid` takes the left part's two. So the parts never share a slot, and run
//! in parallel without locks; the tree depends on the keys alone, and so do the slots.

use super::frame::{Axis, Frame};
use super::group::{merge_equal, sort_few, sort_in_own_box};
use super::knit::{HullVertex, merge};
use super::leaf::{self, Hull, is_below, is_left_of};
use super::parallel::Workers;
use super::sheet::Sheet;
use crate::{Phase, Watch};
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

/// Ranges up to this size run on one thread and are not interrupted.
const TASK: usize = 1 << 13;
/// Groups of equal keys up to this size are cut in lexicographic order, larger ones get new keys.
const LEXICOGRAPHIC: usize = 12;

/// One run of divide and conquer.
pub(super) struct Divide<'a, const FILTERED: bool> {
    pub sheet: Sheet,
    pub watch: &'a dyn Watch,
    pub workers: Workers,
    /// Counts the points of finished tasks.
    pub done: AtomicU64,
    /// Counts the duplicates met.
    pub duplicates: AtomicU64,
}

impl<const FILTERED: bool> Divide<'_, FILTERED> {
    /// Triangulates the points at positions `lo..hi`; `None` if the watch cancelled.
    pub fn run(&self, lo: usize, hi: usize, frame: &Frame) -> Option<Hull> {
        if hi - lo <= TASK {
            return self.task(lo, hi, frame);
        }
        let Some((mid, axis)) = self.cut(lo, hi, frame) else {
            return self.regroup(lo, hi, |frame| self.run(lo, hi, frame));
        };
        let (left, right) = self
            .workers
            .join(|| self.run(lo, mid, frame), || self.run(mid, hi, frame));
        let (left, right) = (left?, right?);
        Some(self.conquer(left, right, mid, axis))
    }

    fn task(&self, lo: usize, hi: usize, frame: &Frame) -> Option<Hull> {
        if self.watch.is_cancelled() {
            return None;
        }
        let hull = self.solve(lo, hi, frame);
        let done = self.done.fetch_add((hi - lo) as u64, Relaxed) + (hi - lo) as u64;
        let total = u64::from(self.sheet.infinite());
        self.watch.progress(Phase::Triangulate, done, total);
        Some(hull)
    }

    fn solve(&self, lo: usize, hi: usize, frame: &Frame) -> Hull {
        match hi - lo {
            1 => return Hull::of_point(lo as u32),
            2 if self.sheet.point(lo as u32) != self.sheet.point(lo as u32 + 1) => {
                return leaf::edge(self.sheet, lo as u32);
            }
            3 => {
                if let Some(hull) = leaf::triangle::<FILTERED>(self.sheet, lo as u32) {
                    return hull;
                }
            }
            4 => {
                if let Some(hull) = leaf::quadruple::<FILTERED>(self.sheet, lo as u32) {
                    return hull;
                }
            }
            _ => {}
        }
        match self.cut(lo, hi, frame) {
            Some((mid, axis)) => {
                let left = self.solve(lo, mid, frame);
                let right = self.solve(mid, hi, frame);
                self.conquer(left, right, mid, axis)
            }
            None => self.solve_group(lo, hi),
        }
    }

    /// Finds where the highest differing bit of the keys changes; `None` if all keys are equal.
    #[inline]
    fn cut(&self, lo: usize, hi: usize, frame: &Frame) -> Option<(usize, Axis)> {
        let (first, last) = (self.sheet.key(lo), self.sheet.key(hi - 1));
        let bit = (first ^ last).checked_ilog2()?;
        let (mut below, mut above) = (lo, hi - 1);
        while above - below > 1 {
            let mid = below + (above - below) / 2;
            if self.sheet.key(mid) >> bit & 1 == 0 {
                below = mid;
            } else {
                above = mid;
            }
        }
        Some((above, frame.axis(bit)))
    }

    /// Merges the parts before and after `mid`.
    #[inline]
    fn conquer(&self, left: Hull, right: Hull, mid: usize, axis: Axis) -> Hull {
        let free = [6 * mid as u32 - 6, 6 * mid as u32 - 3];
        let (inner_left, inner_right) = match axis {
            Axis::X => (left.right, right.left),
            Axis::Y => (left.top, right.bottom),
        };
        let seam = merge::<FILTERED>(self.sheet, inner_left, inner_right, free);
        // A tangent's end keeps its place on the hull, but its hull edge is a new one.
        let from_left = |v: HullVertex| {
            let ghost = if v.vertex == seam.lower[0] {
                seam.bottom
            } else {
                v.ghost
            };
            HullVertex { ghost, ..v }
        };
        let from_right = |v: HullVertex| {
            let ghost = if v.vertex == seam.upper[1] {
                seam.top
            } else {
                v.ghost
            };
            HullVertex { ghost, ..v }
        };
        let pick = |left_wins: bool, l: HullVertex, r: HullVertex| {
            HullVertex::select(left_wins, from_left(l), from_right(r))
        };
        let by_x = |a: HullVertex, b: HullVertex| is_left_of(self.sheet, a.vertex, b.vertex);
        let by_y = |a: HullVertex, b: HullVertex| is_below(self.sheet, a.vertex, b.vertex);
        match axis {
            Axis::X => Hull {
                left: from_left(left.left),
                right: from_right(right.right),
                bottom: pick(by_y(left.bottom, right.bottom), left.bottom, right.bottom),
                top: pick(by_y(right.top, left.top), left.top, right.top),
            },
            Axis::Y => Hull {
                left: pick(by_x(left.left, right.left), left.left, right.left),
                right: pick(by_x(right.right, left.right), left.right, right.right),
                bottom: from_left(left.bottom),
                top: from_right(right.top),
            },
        }
    }

    /// Solves a range whose keys are all equal.
    #[cold]
    #[inline(never)]
    fn solve_group(&self, lo: usize, hi: usize) -> Hull {
        if hi - lo <= LEXICOGRAPHIC {
            let distinct = self.sort_lexicographically(lo, hi);
            self.retire(lo + distinct, hi);
            return self.solve_sorted(lo, lo + distinct);
        }
        self.regroup(lo, hi, |frame| Some(self.solve(lo, hi, frame)))
            .expect("solve is not cancelled")
    }

    /// Gives a group of equal keys keys of their own, in its own bounding box, and goes on with
    /// them; if all its points are equal, they are merged.
    #[cold]
    #[inline(never)]
    fn regroup(
        &self,
        lo: usize,
        hi: usize,
        go_on: impl FnOnce(&Frame) -> Option<Hull>,
    ) -> Option<Hull> {
        let frame = {
            // SAFETY: this subproblem owns lo..hi, and the slices end with this block.
            let (points, keys) = unsafe { self.sheet.group(lo, hi) };
            let frame = sort_in_own_box(points, keys);
            if frame.is_none() {
                merge_equal(points, keys);
            }
            frame
        };
        match frame {
            Some(frame) => go_on(&frame),
            None => {
                self.retire(lo + 1, hi);
                Some(Hull::of_point(lo as u32))
            }
        }
    }

    /// Sorts by x, then y, then index; moves the first of equal points to the front and returns
    /// the number of distinct ones.
    fn sort_lexicographically(&self, lo: usize, hi: usize) -> usize {
        // SAFETY: this subproblem owns lo..hi, and the slices end with this function.
        let (points, keys) = unsafe { self.sheet.group(lo, hi) };
        sort_few(points, keys);
        merge_equal(points, keys)
    }

    /// Counts the positions `from..to` as duplicates and empties their slots, except the last two
    /// before `2 to`, which belong to the next merge.
    fn retire(&self, from: usize, to: usize) {
        self.duplicates.fetch_add((to - from) as u64, Relaxed);
        for slot in 2 * from - 2..2 * to - 2 {
            self.sheet.kill(3 * slot as u32);
        }
    }

    /// Solves points in lexicographic order without duplicates by halving.
    fn solve_sorted(&self, lo: usize, hi: usize) -> Hull {
        match hi - lo {
            1 => Hull::of_point(lo as u32),
            2 => leaf::edge(self.sheet, lo as u32),
            n => {
                let mid = lo + n / 2;
                let left = self.solve_sorted(lo, mid);
                let right = self.solve_sorted(mid, hi);
                self.conquer(left, right, mid, Axis::X)
            }
        }
    }
}
