//! Disjoint sets.

/// Disjoint sets of the numbers below n: union by size, paths halved (Tarjan and van Leeuwen, *Worst-case
/// analysis of set union algorithms*, 1984).
pub(super) struct Forest {
    /// The parent of a number; a root has the size of its set, complemented.
    links: Vec<u32>,
}

/// Links from here on are sizes, complemented. Half of all numbers are more than ids can name.
const ROOT: u32 = 1 << 31;

impl Forest {
    /// Makes `n` sets of one number each.
    pub fn new(n: usize) -> Self {
        Self { links: vec![!1; n] }
    }

    /// Returns the number that stands for the set of `i`.
    pub fn find(&mut self, i: usize) -> usize {
        let mut i = i as u32;
        loop {
            let parent = self.links[i as usize];
            if parent >= ROOT {
                return i as usize;
            }
            let above = self.links[parent as usize];
            if above >= ROOT {
                return parent as usize;
            }
            self.links[i as usize] = above;
            i = above;
        }
    }

    /// Joins the sets of two numbers; `false` if they are one already.
    pub fn join(&mut self, i: usize, j: usize) -> bool {
        let (i, j) = (self.find(i), self.find(j));
        if i == j {
            return false;
        }
        let [size_i, size_j] = [i, j].map(|k| !self.links[k]);
        let (small, large) = if size_i < size_j { (i, j) } else { (j, i) };
        self.links[small] = large as u32;
        self.links[large] = !(size_i + size_j);
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sets_are_joined_once() {
        let mut forest = Forest::new(6);
        assert!(forest.join(0, 1) && forest.join(2, 3) && forest.join(1, 3));
        assert!(!forest.join(0, 2));
        assert_eq!(forest.find(0), forest.find(3));
        assert_ne!(forest.find(4), forest.find(5));
        let root = forest.find(2);
        assert_eq!(!forest.links[root], 4);
    }
}
