//! The second step: vertices beside edges split them.

use super::{MOST_ROUNDS, Work, grouped};
use crate::Point;
use crate::predicates::is_near_segment;
use crate::pslg::{Nearby, Scratch};

impl Work<'_> {
    /// Lets vertices split the edges that they lie beside, until there are none. Tells whether any did; `None`
    /// if the watch cancelled.
    pub(super) fn bend(&mut self) -> Option<bool> {
        let mut is_bent = false;
        for _ in 0..MOST_ROUNDS {
            if !self.bend_once()? {
                break;
            }
            is_bent = true;
        }
        Some(is_bent)
    }

    fn bend_once(&mut self) -> Option<bool> {
        let mut splits = self.splits()?;
        if splits.is_empty() {
            return Some(false);
        }
        let mut splits = grouped(&mut splits);
        for ([a, b], inner) in &mut splits {
            let [p, q] = [*a, *b].map(|v| self.points[v as usize]);
            let along = |v: &u32| share([p, q], self.points[*v as usize]);
            let by_place = |u: &u32, v: &u32| {
                let [s, t] = [u, v].map(|v| self.points[*v as usize]);
                s.lex_cmp(&t)
            };
            inner.sort_by(|u, v| along(u).total_cmp(&along(v)).then_with(|| by_place(u, v)));
        }
        self.lengthen(|ends| {
            let found = splits.binary_search_by_key(&ends, |&(ends, _)| ends);
            found.ok().map(|i| &splits[i].1[..])
        });
        Some(true)
    }

    /// Lists the edges that are to be split, with the vertices that do it.
    fn splits(&self) -> Option<Vec<([u32; 2], u32)>> {
        let mut owned = self.edges();
        let owned = grouped(&mut owned);
        let edges: Vec<[u32; 2]> = owned.iter().map(|&(ends, _)| ends).collect();
        let near = Nearby::of_segments(&self.points, &edges, self.workers);
        let mut scratch = Scratch::default();
        let mut splits = Vec::new();
        for (i, v) in self.vertices().into_iter().enumerate() {
            if i.is_multiple_of(1 << 8) && self.watch.is_cancelled() {
                return None;
            }
            near.segments_beside(v, self.tolerance, &mut scratch, |e| {
                let (ends, owners) = &owned[e as usize];
                if self.may_pass(owners, v) {
                    splits.push((*ends, v));
                }
            });
        }
        Some(splits)
    }

    /// Tells whether segments may go through a vertex: it is within the tolerance of all of them.
    pub(super) fn may_pass(&self, segments: &[u32], v: u32) -> bool {
        let p = self.points[v as usize];
        let mut all = segments.iter();
        all.all(|&s| is_near_segment(self.whole[s as usize], self.tolerance, p))
    }
}

/// How far along a segment a place lies, rounded; halved so that nothing overflows.
fn share([a, b]: [Point; 2], p: Point) -> f64 {
    let half = |q: Point| [q.x / 2.0 - a.x / 2.0, q.y / 2.0 - a.y / 2.0];
    let ([x, y], [u, v]) = (half(b), half(p));
    let size = x.abs().max(y.abs()).max(f64::MIN_POSITIVE);
    x / size * (u / size) + y / size * (v / size)
}
