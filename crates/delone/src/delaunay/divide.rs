//! Divide and conquer over points in curve order.
//!
//! The sorted keys are the cuts (see [`Frame`]): a range of points is halved where the highest bit
//! in which its keys differ changes. n points have exactly 2n − 2 faces, ghosts included, even if
//! they are collinear; a range `lo..hi` owns the slots `2 lo..2 hi` and always leaves its last two
//! free, and a merge at `mid` takes the left part's two. So the parts never share a slot, and run
//! in parallel without locks; the tree depends on the keys alone, and so do the slots.

use super::group::{Regrouped, merge_equal, sort_in_own_box, sort_lexicographically};
use super::knit::{HullVertex, merge};
use super::leaf::{self, Hull, is_below, is_left_of};
use super::sheet::Sheet;
use super::witness::{Deed, Witness};
use crate::order::{Axis, Frame};
use crate::parallel::Workers;
use crate::{Phase, Watch};
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering::Relaxed};

/// Ranges up to this size run on one thread and are not interrupted; fewer points where every sign
/// may need big integers, and where Miri is to see threads with few points.
const fn task_size(filtered: bool) -> usize {
    match filtered {
        _ if cfg!(miri) => 1 << 3,
        true => 1 << 13,
        false => 1 << 8,
    }
}
/// Groups of equal keys up to this size are cut in lexicographic order, larger ones get new keys.
const LEXICOGRAPHIC: usize = 12;
/// After so many boxes within boxes a group is cut in lexicographic order whatever its size. Each box
/// zooms in by a factor of at least 512, so this is for magnitudes that span the range of `f64`;
/// without it the depth of the recursion would grow with that range.
const GENERATIONS: u32 = 8;

/// One run of divide and conquer.
pub(super) struct Divide<'a, W, const FILTERED: bool> {
    pub sheet: Sheet,
    pub watch: &'a dyn Watch,
    pub workers: Workers,
    pub witness: W,
    /// Counts the points of finished tasks.
    pub done: AtomicU64,
    /// Whether equal points have been merged.
    pub has_merged: AtomicBool,
}

impl<W: Witness, const FILTERED: bool> Divide<'_, W, FILTERED> {
    /// Triangulates the points at positions `lo..hi`; `None` if the watch cancelled.
    pub fn run(&self, lo: usize, hi: usize, frame: &Frame) -> Option<Hull> {
        if hi - lo <= task_size(FILTERED) {
            return self.task(lo, hi, frame);
        }
        let Some((mid, axis)) = self.cut(lo, hi, frame) else {
            return self.run_group(lo, hi, frame);
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
        self.report(hi - lo);
        Some(hull)
    }

    /// Tells the watch that so many more points are finished.
    fn report(&self, points: usize) {
        let done = self.done.fetch_add(points as u64, Relaxed) + points as u64;
        let total = u64::from(self.sheet.infinite());
        self.watch.progress(Phase::Triangulate, done, total);
    }

    fn solve(&self, lo: usize, hi: usize, frame: &Frame) -> Hull {
        match hi - lo {
            1 => return Hull::of_point(lo as u32),
            2 if self.sheet.point(lo as u32) != self.sheet.point(lo as u32 + 1) => {
                return leaf::edge(self.sheet, lo as u32, self.witness);
            }
            3 => {
                if let Some(hull) = leaf::triangle::<FILTERED>(self.sheet, lo as u32, self.witness)
                {
                    return hull;
                }
            }
            4 => {
                if let Some(hull) = leaf::quadruple::<FILTERED>(self.sheet, lo as u32, self.witness)
                {
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
            None => self.solve_group(lo, hi, frame),
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
        let axis = frame.axis(bit);
        self.tell_cut(above, hi, axis);
        Some((above, axis))
    }

    /// Tells that the points from `mid` on are cut off.
    #[inline(always)]
    fn tell_cut(&self, mid: usize, hi: usize, axis: Axis) {
        if W::IS_WATCHING {
            let place = |&v: &u32| {
                let p = self.sheet.point(v);
                match axis {
                    Axis::X => p.x,
                    Axis::Y => p.y,
                }
            };
            let behind = mid as u32..hi as u32;
            let first = behind.min_by(|v, w| place(v).total_cmp(&place(w)));
            let first = self.sheet.name(first.expect("bug: a cut halves"));
            self.witness.tell(Deed::Cut { axis, first });
        }
    }

    /// Merges the parts before and after `mid`.
    #[inline]
    fn conquer(&self, left: Hull, right: Hull, mid: usize, axis: Axis) -> Hull {
        let free = [6 * mid as u32 - 6, 6 * mid as u32 - 3];
        let (inner_left, inner_right) = match axis {
            Axis::X => (left.right, right.left),
            Axis::Y => (left.top, right.bottom),
        };
        let seam = merge::<_, FILTERED>(self.sheet, inner_left, inner_right, free, self.witness);
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

    /// Runs a large range whose keys are all equal.
    #[cold]
    fn run_group(&self, lo: usize, hi: usize, frame: &Frame) -> Option<Hull> {
        let hull = if self.is_last(lo, hi, frame) {
            self.solve_lexicographically(lo, hi)
        } else {
            match self.regroup(lo, hi, frame, self.workers, self.watch)? {
                Regrouped::Sorted(frame) => return self.run(lo, hi, &frame),
                Regrouped::Equal => self.solve_equal(lo, hi),
            }
        };
        self.report(hi - lo);
        Some(hull)
    }

    /// Solves a range whose keys are all equal.
    #[cold]
    #[inline(never)]
    fn solve_group(&self, lo: usize, hi: usize, frame: &Frame) -> Hull {
        if self.is_last(lo, hi, frame) {
            return self.solve_lexicographically(lo, hi);
        }
        match self.regroup(lo, hi, frame, Workers::ONE, &()) {
            Some(Regrouped::Sorted(frame)) => self.solve(lo, hi, &frame),
            _ => self.solve_equal(lo, hi),
        }
    }

    /// Whether a group of equal keys gets no more keys of its own.
    fn is_last(&self, lo: usize, hi: usize, frame: &Frame) -> bool {
        hi - lo <= LEXICOGRAPHIC || frame.generation == GENERATIONS
    }

    /// Gives a group of equal keys keys of their own, in its own bounding box.
    fn regroup(
        &self,
        lo: usize,
        hi: usize,
        frame: &Frame,
        workers: Workers,
        watch: &dyn Watch,
    ) -> Option<Regrouped> {
        // SAFETY: this subproblem owns lo..hi, and the slices end with this function.
        let (points, keys) = unsafe { self.sheet.group(lo, hi) };
        let mut regrouped = sort_in_own_box(points, keys, workers, watch)?;
        if let Regrouped::Sorted(own) = &mut regrouped {
            own.generation = frame.generation + 1;
        }
        Some(regrouped)
    }

    /// Solves points that are all equal, and merged into the first.
    fn solve_equal(&self, lo: usize, hi: usize) -> Hull {
        self.retire(lo + 1, hi);
        Hull::of_point(lo as u32)
    }

    /// Merges equal points and cuts the others in the order of x, then y.
    fn solve_lexicographically(&self, lo: usize, hi: usize) -> Hull {
        let distinct = {
            // SAFETY: this subproblem owns lo..hi, and the slices end with this block.
            let (points, keys) = unsafe { self.sheet.group(lo, hi) };
            sort_lexicographically(points, keys);
            merge_equal(points, keys)
        };
        self.retire(lo + distinct, hi);
        self.solve_sorted(lo, lo + distinct)
    }

    /// Notes that the positions `from..to` are duplicates and empties their slots, except the last two
    /// before `2 to`, which belong to the next merge.
    fn retire(&self, from: usize, to: usize) {
        if from < to {
            self.has_merged.store(true, Relaxed);
        }
        for slot in 2 * from - 2..2 * to - 2 {
            self.sheet.kill(3 * slot as u32);
        }
    }

    /// Solves points in lexicographic order without duplicates by halving.
    fn solve_sorted(&self, lo: usize, hi: usize) -> Hull {
        match hi - lo {
            1 => Hull::of_point(lo as u32),
            2 => leaf::edge(self.sheet, lo as u32, self.witness),
            n => {
                let mid = lo + n / 2;
                self.tell_cut(mid, hi, Axis::X);
                let left = self.solve_sorted(lo, mid);
                let right = self.solve_sorted(mid, hi);
                self.conquer(left, right, mid, Axis::X)
            }
        }
    }
}
