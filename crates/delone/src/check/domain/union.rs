//! Disjoint sets (union–find with halved paths).

/// A partition of `0..n`, joined step by step.
pub(super) struct Union {
    parents: Vec<u32>,
}

impl Union {
    pub fn new(n: usize) -> Self {
        Self {
            parents: (0..n as u32).collect(),
        }
    }

    pub fn join(&mut self, a: u32, b: u32) {
        let [a, b] = [a, b].map(|i| self.root(i));
        // The smaller number wins, so element 0 stays the root of its set.
        self.parents[a.max(b) as usize] = a.min(b);
    }

    fn root(&mut self, mut i: u32) -> u32 {
        while self.parents[i as usize] != i {
            let grandparent = self.parents[self.parents[i as usize] as usize];
            self.parents[i as usize] = grandparent;
            i = grandparent;
        }
        i
    }

    /// Numbers the sets by their smallest elements.
    pub fn classes(mut self) -> Classes {
        let mut count = 0;
        let mut of = vec![0; self.parents.len()];
        for i in 0..of.len() {
            let root = self.root(i as u32) as usize;
            if root == i {
                of[i] = count;
                count += 1;
            } else {
                of[i] = of[root];
            }
        }
        Classes {
            of,
            count: count as usize,
        }
    }
}

/// The sets of a partition.
pub(super) struct Classes {
    of: Vec<u32>,
    count: usize,
}

impl Classes {
    /// Returns the set of an element.
    pub fn of(&self, i: u32) -> u32 {
        self.of[i as usize]
    }

    /// Counts the sets.
    pub fn count(&self) -> usize {
        self.count
    }
}
