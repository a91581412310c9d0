//! The third step: edges that cross are cut, and cuts near to something become one with it.

use super::{Work, compact, grouped};
use crate::VertexId;
use crate::predicates::compare_distances;
use crate::pslg::{Nearby, Scratch, node};
use std::ops::Range;

impl Work<'_> {
    /// Cuts all edges where they meet, and returns the vertices that are new; `None` if the watch cancelled.
    pub(super) fn node(&mut self) -> Option<Range<u32>> {
        let mut owned = self.edges();
        let owned = grouped(&mut owned);
        let edges: Vec<[VertexId; 2]> = owned
            .iter()
            .map(|(ends, _)| ends.map(VertexId::from))
            .collect();
        let vertices: Vec<VertexId> = self.vertices().into_iter().map(VertexId::from).collect();
        let noding = node(&self.points, &vertices, &edges, self.workers, self.watch)?;
        let first = self.points.len() as u32;
        let owner = |edge: u32| owned[edge as usize].1[0];
        let crossings = noding.crossings.iter().map(|pair| {
            let [s, t] = pair.map(owner);
            [s.min(t), s.max(t)]
        });
        self.crossings.extend(crossings);
        self.points.extend(noding.points);
        let mut inner: Vec<([u32; 2], Vec<u32>)> = Vec::new();
        for (edge, chain) in noding.chains.iter() {
            let ends = owned[edge].0;
            let mut chain: Vec<u32> = chain.iter().map(|v| v.raw()).collect();
            if chain.first() != Some(&ends[0]) {
                chain.reverse();
            }
            let last = chain.len() - 1;
            inner.push((ends, chain[1..last].to_vec()));
        }
        self.lengthen(|ends| {
            let found = inner.binary_search_by_key(&ends, |&(ends, _)| ends);
            found.ok().map(|i| &inner[i].1[..])
        });
        Some(first..self.points.len() as u32)
    }

    /// Merges new cuts with what is within the tolerance, by x, then y. Tells whether any was; `None` if the
    /// watch cancelled.
    pub(super) fn merge_cuts(&mut self, cuts: Range<u32>) -> Option<bool> {
        if cuts.is_empty() {
            return Some(false);
        }
        let at = |v: u32| self.points[v as usize];
        let vertices = self.vertices();
        let near = Nearby::of_points(&self.points, &vertices, self.workers);
        let through = self.through(&cuts);
        let mut goals: Vec<u32> = (0..self.points.len() as u32).collect();
        let mut scratch = Scratch::default();
        for (i, v) in cuts.clone().enumerate() {
            if i.is_multiple_of(1 << 8) && self.watch.is_cancelled() {
                return None;
            }
            let mut nearest: Option<u32> = None;
            near.points_within(at(v), self.tolerance, &mut scratch, |u| {
                // Of the new cuts, which are sorted, those before that have stayed.
                let is_settled = u < cuts.start || (u < v && goals[u as usize] == u);
                let is_nearer = |other: u32| {
                    let order = compare_distances(at(v), at(u), at(other));
                    order.then(at(u).lex_cmp(&at(other))).is_lt()
                };
                let segments = &through[(v - cuts.start) as usize];
                if is_settled && nearest.is_none_or(is_nearer) && self.may_pass(segments, u) {
                    nearest = Some(u);
                }
            });
            goals[v as usize] = nearest.unwrap_or(v);
        }
        let is_any = cuts.clone().any(|v| goals[v as usize] != v);
        for chain in &mut self.chains {
            let moved = chain.iter().map(|&v| goals[v as usize]);
            *chain = compact(moved.collect());
        }
        Some(is_any)
    }

    /// Lists the segments through each of the new cuts.
    fn through(&self, cuts: &Range<u32>) -> Vec<Vec<u32>> {
        let mut through = vec![Vec::new(); cuts.len()];
        for (s, chain) in (0..).zip(&self.chains) {
            for v in chain.iter().filter(|v| cuts.contains(v)) {
                through[(v - cuts.start) as usize].push(s);
            }
        }
        through
    }
}
