//! Counting all and listing the first.

/// How many there are, and the first of them.
#[derive(Clone, Debug, PartialEq)]
pub struct Listed<T> {
    /// How many there are.
    pub count: u64,
    /// The first of them, ascending.
    pub first: Vec<T>,
}

impl<T> Default for Listed<T> {
    fn default() -> Self {
        let first = Vec::new();
        Self { count: 0, first }
    }
}

/// Counts all that is added and keeps the least `limit` of it.
pub(crate) struct First<K> {
    limit: usize,
    count: u64,
    kept: Vec<K>,
}

impl<K: Ord> First<K> {
    pub fn new(limit: usize) -> Self {
        let kept = Vec::new();
        Self {
            limit,
            count: 0,
            kept,
        }
    }

    pub fn of(limit: usize, all: impl Iterator<Item = K>) -> Self {
        let mut first = Self::new(limit);
        all.for_each(|key| first.add(key));
        first
    }

    pub fn add(&mut self, key: K) {
        self.count += 1;
        self.kept.push(key);
        // Sorted once in a while, each key costs O(log limit).
        if self.kept.len() > self.limit.max(32).saturating_mul(2) {
            self.shorten();
        }
    }

    fn shorten(&mut self) {
        self.kept.sort_unstable();
        self.kept.truncate(self.limit);
    }

    /// Adds what another one has counted.
    pub fn join(&mut self, other: Self) {
        let count = self.count + other.count;
        other.kept.into_iter().for_each(|key| self.add(key));
        self.count = count;
    }

    pub fn listed<T>(mut self, describe: impl FnMut(K) -> T) -> Listed<T> {
        self.shorten();
        Listed {
            count: self.count,
            first: self.kept.into_iter().map(describe).collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_least_are_kept_and_all_are_counted() {
        for limit in [0, 1, 7, 100, 2000, usize::MAX] {
            let mut first = First::of(limit, (0..500).map(|i| i * 37 % 500));
            first.join(First::of(limit, (500..1000).rev()));
            let listed = first.listed(|i| i);
            assert_eq!(listed.count, 1000);
            assert_eq!(listed.first, (0..limit.min(1000)).collect::<Vec<_>>());
        }
    }
}
