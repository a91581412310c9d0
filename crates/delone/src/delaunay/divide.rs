//! Divide and conquer over points in curve order.
//!
//! The sorted keys are the cuts (see [`Frame`]): a range of points is halved where the highest bit
//! in which its keys differ changes. n points have exactly 2n − 2 faces, ghosts included, even if
//! they are collinear; a range `lo..hi` owns the slots `2 lo..2 hi` and always leaves its last two
//! free, and a merge at `mid` takes the left part's two. So the parts never share a slot, and run
//! in parallel without locks; the tree depends on the keys alone, and so do the slots.

use super::frame::{Axis, Frame};
use super::group::{merge_equal, sort_few, sort_in_own_box};
use super::knit::{HullVertex, NONE, is_left, merge};
use super::parallel::Workers;
use super::sheet::Sheet;
use crate::{Phase, Point, Watch};
use std::cmp::Ordering;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

/// Ranges up to this size run on one thread and are not interrupted.
const TASK: usize = 1 << 13;
/// Groups of equal keys up to this size are cut in lexicographic order, larger ones get new keys.
const LEXICOGRAPHIC: usize = 12;

/// The four extreme hull vertices; ties are broken as in the frame turned by the cut:
/// leftmost and rightmost by (x, y), lowest and topmost by (y, −x).
#[derive(Clone, Copy)]
pub(super) struct Hull {
    left: HullVertex,
    right: HullVertex,
    bottom: HullVertex,
    top: HullVertex,
}

impl Hull {
    /// The ghost of some hull edge; `None` if there is only one point.
    pub fn ghost(&self) -> Option<u32> {
        Some(self.left.ghost).filter(|&ghost| ghost != NONE)
    }
}

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
            1 => self.point(lo as u32),
            2 => self.pair_or_duplicate(lo),
            3 => self.triple(lo),
            _ => match self.cut(lo, hi, frame) {
                Some((mid, axis)) => {
                    let left = self.solve(lo, mid, frame);
                    let right = self.solve(mid, hi, frame);
                    self.conquer(left, right, mid, axis)
                }
                None => self.solve_group(lo, hi),
            },
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
        let from_left = |v: HullVertex| HullVertex {
            ghost: if v.vertex == seam.lower[0] {
                seam.bottom
            } else {
                v.ghost
            },
            ..v
        };
        let from_right = |v: HullVertex| HullVertex {
            ghost: if v.vertex == seam.upper[1] {
                seam.top
            } else {
                v.ghost
            },
            ..v
        };
        let pick = |l: HullVertex, r: HullVertex, left_wins: bool| {
            if left_wins {
                from_left(l)
            } else {
                from_right(r)
            }
        };
        let by_x = |l: HullVertex, r: HullVertex| self.by_x(l.vertex, r.vertex).is_lt();
        let by_y = |l: HullVertex, r: HullVertex| self.by_y(l.vertex, r.vertex).is_lt();
        match axis {
            Axis::X => Hull {
                left: from_left(left.left),
                right: from_right(right.right),
                bottom: pick(left.bottom, right.bottom, by_y(left.bottom, right.bottom)),
                top: pick(left.top, right.top, by_y(right.top, left.top)),
            },
            Axis::Y => Hull {
                left: pick(left.left, right.left, by_x(left.left, right.left)),
                right: pick(left.right, right.right, by_x(right.right, left.right)),
                bottom: from_left(left.bottom),
                top: from_right(right.top),
            },
        }
    }

    #[inline(always)]
    fn by_x(&self, a: u32, b: u32) -> Ordering {
        self.sheet.point(a).lex_cmp(&self.sheet.point(b))
    }

    #[inline(always)]
    fn by_y(&self, a: u32, b: u32) -> Ordering {
        let turned = |v: u32| {
            let p = self.sheet.point(v);
            Point::new(p.y, -p.x)
        };
        turned(a).lex_cmp(&turned(b))
    }

    fn point(&self, vertex: u32) -> Hull {
        let v = HullVertex {
            vertex,
            ghost: NONE,
        };
        Hull {
            left: v,
            right: v,
            bottom: v,
            top: v,
        }
    }

    fn pair_or_duplicate(&self, lo: usize) -> Hull {
        let (a, b) = (lo as u32, lo as u32 + 1);
        if self.sheet.point(a) == self.sheet.point(b) {
            return self.solve_group(lo, lo + 2);
        }
        self.pair(lo)
    }

    /// Two ghosts, one on each side of the edge.
    #[inline]
    fn pair(&self, lo: usize) -> Hull {
        let (a, b) = (lo as u32, lo as u32 + 1);
        let there = 6 * a;
        let back = there + 3;
        self.sheet.set_ghost(there, a, b);
        self.sheet.set_ghost(back, b, a);
        self.sheet.bond(there, back);
        self.sheet.link_ghosts(there, back);
        self.sheet.link_ghosts(back, there);
        let a = HullVertex {
            vertex: a,
            ghost: there,
        };
        let b = HullVertex {
            vertex: b,
            ghost: back,
        };
        let (left, right) = if self.by_x(a.vertex, b.vertex).is_lt() {
            (a, b)
        } else {
            (b, a)
        };
        let (bottom, top) = if self.by_y(a.vertex, b.vertex).is_lt() {
            (a, b)
        } else {
            (b, a)
        };
        Hull {
            left,
            right,
            bottom,
            top,
        }
    }

    /// A triangle and its three ghosts.
    #[inline]
    fn triple(&self, lo: usize) -> Hull {
        let v = lo as u32;
        if is_left::<FILTERED>(self.sheet, v, v + 1, v + 2) {
            self.triangle(v, [v, v + 1, v + 2])
        } else if is_left::<FILTERED>(self.sheet, v, v + 2, v + 1) {
            self.triangle(v, [v, v + 2, v + 1])
        } else {
            self.solve_group(lo, lo + 3)
        }
    }

    #[inline]
    fn triangle(&self, lo: u32, corners: [u32; 3]) -> Hull {
        let inner = 6 * lo;
        self.sheet.set_face(inner, corners);
        let ghost = |k: u32| inner + 3 * (k + 1);
        for k in 0..3 {
            // Ghost k lies beyond the half-edge that starts at corner k.
            let [a, b] = [corners[k as usize], corners[(k as usize + 1) % 3]];
            self.sheet.set_ghost(ghost(k), a, b);
            self.sheet.bond(ghost(k), inner + (k + 2) % 3);
            self.sheet.link_ghosts(ghost(k), ghost((k + 1) % 3));
        }
        let v = [0, 1, 2].map(|k| HullVertex {
            vertex: corners[k as usize],
            ghost: ghost(k),
        });
        let min = |less: &dyn Fn(u32, u32) -> bool| {
            let m = if less(v[1].vertex, v[0].vertex) {
                v[1]
            } else {
                v[0]
            };
            if less(v[2].vertex, m.vertex) { v[2] } else { m }
        };
        Hull {
            left: min(&|a, b| self.by_x(a, b).is_lt()),
            right: min(&|a, b| self.by_x(a, b).is_gt()),
            bottom: min(&|a, b| self.by_y(a, b).is_lt()),
            top: min(&|a, b| self.by_y(a, b).is_gt()),
        }
    }

    /// Solves a range whose keys are all equal, or whose three points lie on a line.
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
                Some(self.point(lo as u32))
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
            1 => self.point(lo as u32),
            2 => self.pair(lo),
            n => {
                let mid = lo + n / 2;
                let left = self.solve_sorted(lo, mid);
                let right = self.solve_sorted(mid, hi);
                self.conquer(left, right, mid, Axis::X)
            }
        }
    }
}
