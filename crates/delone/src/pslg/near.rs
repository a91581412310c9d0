//! What is near a point: vertices or segments, found in a box tree.
//!
//! *Cost*: O(n log n) to build; a query in practice O(log n) and what it finds.

use super::boxes::{BoxTree, Stack};
use super::meeting::Ends;
use crate::Point;
use crate::parallel::Workers;
use crate::predicates::{CircleSide, in_diametral_circle, in_disc, is_near_segment};

/// Points, or segments between them, to be asked what is near.
pub(crate) struct Nearby<'a> {
    points: &'a [Point],
    ends: &'a [Ends],
    tree: BoxTree,
}

/// What queries keep at hand.
#[derive(Default)]
pub(crate) struct Scratch(Stack);

impl<'a> Nearby<'a> {
    /// Packs some of the points.
    pub fn of_points(points: &'a [Point], list: &[u32], workers: Workers) -> Self {
        let tree = BoxTree::new(list, |v| [points[v as usize]; 2], workers);
        let ends = &[];
        Self { points, ends, tree }
    }

    /// Packs segments between points.
    pub fn of_segments(points: &'a [Point], ends: &'a [Ends], workers: Workers) -> Self {
        let all: Vec<u32> = (0..ends.len() as u32).collect();
        let place = |s: u32| ends[s as usize].map(|v| points[v as usize]);
        let tree = BoxTree::new(&all, place, workers);
        Self { points, ends, tree }
    }

    /// Visits the points that are at most `radius` away from `p`.
    pub fn points_within(
        &self,
        p: Point,
        radius: f64,
        scratch: &mut Scratch,
        mut visit: impl FnMut(u32),
    ) {
        self.tree.near(p, radius, &mut scratch.0, |v| {
            if in_disc(p, radius, self.points[v as usize]) != CircleSide::Outside {
                visit(v);
            }
            true
        });
    }

    /// Visits the segments that are at most `radius` away from `p`.
    pub fn segments_within(
        &self,
        p: Point,
        radius: f64,
        scratch: &mut Scratch,
        mut visit: impl FnMut(u32),
    ) {
        self.tree.near(p, radius, &mut scratch.0, |s| {
            let ends = self.ends[s as usize].map(|v| self.points[v as usize]);
            if is_near_segment(ends, radius, p) {
                visit(s);
            }
            true
        });
    }

    /// Visits the segments that vertex `v` should split: it is at most `radius` away from them, and sees
    /// their ends at an angle of 90° or more, so that both parts are shorter than the whole.
    pub fn segments_beside(
        &self,
        v: u32,
        radius: f64,
        scratch: &mut Scratch,
        mut visit: impl FnMut(u32),
    ) {
        let p = self.points[v as usize];
        self.segments_within(p, radius, scratch, |s| {
            let [a, b] = self.ends[s as usize].map(|v| self.points[v as usize]);
            if p != a && p != b && in_diametral_circle(a, b, p) != CircleSide::Outside {
                visit(s);
            }
        });
    }
}
