//! The triangles in the order of their data, and the place j up to which Algorithm B has come.
//!
//! The text keeps a list and sorts it anew. Here are two sorted sets, the j − 1 triangles before the place and all
//! others, and a triangle that changes costs O(log m).

use crate::TriangleId;
use std::cmp::Reverse;
use std::collections::BTreeSet;

/// Those that hold more come first, of equal ones the lowest number.
type Key = (Reverse<usize>, TriangleId);

/// All triangles, in order, and a place among them.
#[derive(Default)]
pub(super) struct Ranking {
    /// How many data each holds; by number, `None` for ghosts.
    counts: Vec<Option<usize>>,
    /// How many triangles are to be before the place.
    passed: usize,
    before: BTreeSet<Key>,
    after: BTreeSet<Key>,
}

impl Ranking {
    /// Notes how many data a triangle, new or known, holds now. The place stays: if triangles come or go before it,
    /// it is that of another triangle then.
    pub fn set(&mut self, t: TriangleId, count: usize) {
        if self.counts.len() <= t.index() {
            self.counts.resize(t.index() + 1, None);
        }
        let key = (Reverse(count), t);
        if let Some(old) = self.counts[t.index()].replace(count) {
            let old = (Reverse(old), t);
            if !self.before.remove(&old) {
                self.after.remove(&old);
            }
        }
        match self.before.last() {
            Some(last) if key < *last => self.before.insert(key),
            _ => self.after.insert(key),
        };
        self.balance();
    }

    /// Returns the triangle at the place, and how many data it holds.
    pub fn current(&self) -> Option<(TriangleId, usize)> {
        self.after.first().map(|&(Reverse(count), t)| (t, count))
    }

    /// Goes on to the next place.
    pub fn pass(&mut self) {
        self.passed += 1;
        self.balance();
    }

    fn balance(&mut self) {
        while self.before.len() < self.passed {
            let Some(first) = self.after.pop_first() else {
                return;
            };
            self.before.insert(first);
        }
        while self.before.len() > self.passed {
            self.after.extend(self.before.pop_last());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_place_is_that_in_the_sorted_list(
            steps in prop::collection::vec((0usize..12, 0usize..6, any::<bool>()), 1..60),
        ) {
            let mut ranking = Ranking::default();
            let mut list: Vec<Option<usize>> = vec![None; 12];
            let mut passed = 0;
            for (t, count, passes) in steps {
                list[t] = Some(count);
                ranking.set(TriangleId::new(t), count);
                if passes && ranking.current().is_some() {
                    ranking.pass();
                    passed += 1;
                }
                let known = list.iter().enumerate();
                let mut sorted: Vec<_> = known
                    .filter_map(|(t, &count)| Some((Reverse(count?), TriangleId::new(t))))
                    .collect();
                sorted.sort();
                let expected = sorted.get(passed).map(|&(Reverse(count), t)| (t, count));
                prop_assert_eq!(ranking.current(), expected);
            }
        }
    }
}
