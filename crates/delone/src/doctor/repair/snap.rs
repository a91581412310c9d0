//! The first step: vertices move to centers.

use super::Work;
use crate::predicates::compare_distances;
use crate::pslg::{Nearby, Scratch};

impl Work<'_> {
    /// Moves every vertex to the nearest center within the tolerance; `None` if the watch cancelled.
    ///
    /// *Cost*: O(n log n + k) for k pairs within the tolerance.
    pub(super) fn snap(&mut self) -> Option<()> {
        let at = |v: u32| self.points[v as usize];
        let mut vertices = self.vertices();
        vertices.sort_unstable_by(|&u, &v| at(u).lex_cmp(&at(v)));
        let near = Nearby::of_points(&self.points, &vertices, self.workers);
        let mut scratch = Scratch::default();
        let mut is_center = vec![false; self.points.len()];
        for (i, &v) in vertices.iter().enumerate() {
            if i.is_multiple_of(1 << 8) && self.watch.is_cancelled() {
                return None;
            }
            let mut is_free = true;
            near.points_within(at(v), self.tolerance, &mut scratch, |u| {
                is_free &= !is_center[u as usize];
            });
            is_center[v as usize] = is_free;
        }
        let mut goals: Vec<u32> = (0..self.points.len() as u32).collect();
        for (i, &v) in vertices.iter().enumerate() {
            if i.is_multiple_of(1 << 8) && self.watch.is_cancelled() {
                return None;
            }
            if is_center[v as usize] {
                continue;
            }
            let mut nearest: Option<u32> = None;
            near.points_within(at(v), self.tolerance, &mut scratch, |u| {
                let is_nearer = |other: u32| {
                    let order = compare_distances(at(v), at(u), at(other));
                    order.then(at(u).lex_cmp(&at(other))).is_lt()
                };
                if is_center[u as usize] && nearest.is_none_or(is_nearer) {
                    nearest = Some(u);
                }
            });
            goals[v as usize] = nearest.expect("bug: neither a center nor near one");
        }
        for home in &mut self.home {
            *home = goals[*home as usize];
        }
        Some(())
    }
}
