//! A closed tour as an array, whose parts can be reversed.

/// A cyclic order of the numbers below n.
pub(super) struct Cycle {
    order: Vec<u32>,
    /// Where each number stands.
    places: Vec<u32>,
}

impl Cycle {
    /// The order 0, 1, … n − 1.
    pub fn new(n: usize) -> Self {
        Self::of((0..n as u32).collect())
    }

    /// A permutation of the numbers below its length.
    pub fn of(order: Vec<u32>) -> Self {
        let mut places = vec![0; order.len()];
        for (place, &v) in (0..).zip(&order) {
            places[v as usize] = place;
        }
        Self { order, places }
    }

    /// Returns what stands at place `i`.
    #[inline]
    pub fn at(&self, i: usize) -> u32 {
        self.order[i]
    }

    /// Returns the neighbour of `a`, forwards or backwards.
    #[inline]
    pub fn next(&self, a: u32, forward: bool) -> u32 {
        let (i, last) = (self.places[a as usize], self.order.len() as u32 - 1);
        let j = match (forward, i) {
            (true, i) if i == last => 0,
            (true, i) => i + 1,
            (false, 0) => last,
            (false, i) => i - 1,
        };
        self.order[j as usize]
    }

    /// Replaces the edges ab and cd by ac and bd.
    ///
    /// ```text
    ///     a → b ┄┄┄ c → d       the part from b to c is reversed,
    ///     a → c ┄┄┄ b → d       or all the rest, whichever is shorter
    /// ```
    ///
    /// In one of the two directions b must follow a and d follow c.
    pub fn flip(&mut self, [a, b, c, d]: [u32; 4]) {
        let (first, last) = if self.next(a, true) == b {
            (b, c)
        } else {
            (a, d)
        };
        let [i, j] = [first, last].map(|v| self.places[v as usize] as usize);
        let n = self.order.len();
        let inner = (j + n - i) % n + 1;
        if 2 * inner <= n {
            self.reverse(i, j, inner);
        } else {
            self.reverse((j + 1) % n, (i + n - 1) % n, n - inner);
        }
    }

    /// Counts the vertices that [`flip`](Self::flip) moves if the edge at `b` and the one at `c` go.
    #[inline]
    pub fn cost(&self, b: u32, c: u32) -> usize {
        let [i, j] = [b, c].map(|v| self.places[v as usize]);
        let between = i.abs_diff(j) as usize;
        between.min(self.order.len() - between)
    }

    /// Reverses `len` entries from the `i`-th to the `j`-th, past the end of the array if need be.
    fn reverse(&mut self, mut i: usize, mut j: usize, len: usize) {
        let n = self.order.len();
        for _ in 0..len / 2 {
            self.order.swap(i, j);
            self.places[self.order[i] as usize] = i as u32;
            self.places[self.order[j] as usize] = j as u32;
            i = if i + 1 == n { 0 } else { i + 1 };
            j = if j == 0 { n - 1 } else { j - 1 };
        }
    }

    /// Lists the order from `first` on, in that direction.
    pub fn from(&self, first: u32, forward: bool) -> Vec<u32> {
        let along = std::iter::successors(Some(first), |&v| Some(self.next(v, forward)));
        along.take(self.order.len()).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every flip of every pair of edges, against the definition.
    #[test]
    fn flips_exchange_two_edges() {
        let n = 7;
        for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
            for forward in [true, false] {
                let mut cycle = Cycle::new(n as usize);
                // A turned cycle, so that parts run past the end of the array.
                cycle.flip([0, 1, 4, 5]);
                let [a, c] = [i, j];
                let [b, d] = [a, c].map(|v| cycle.next(v, forward));
                if a == c || b == c || a == d {
                    continue;
                }
                let mut edges = edges_of(&cycle);
                edges.retain(|e| ![[a, b], [c, d]].map(sorted).contains(e));
                edges.extend([[a, c], [b, d]].map(sorted));
                edges.sort();
                cycle.flip([a, b, c, d]);
                assert_eq!(edges_of(&cycle), edges, "{a} {b} {c} {d}");
            }
        }
    }

    fn sorted(mut edge: [u32; 2]) -> [u32; 2] {
        edge.sort();
        edge
    }

    fn edges_of(cycle: &Cycle) -> Vec<[u32; 2]> {
        let order = cycle.from(0, true);
        let mut edges: Vec<_> = (0..order.len())
            .map(|i| sorted([order[i], order[(i + 1) % order.len()]]))
            .collect();
        edges.sort();
        edges
    }
}
