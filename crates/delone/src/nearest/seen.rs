//! A set of vertices that one search has seen.

/// Numbers in open addressing; empty again at the price of what it held, not of all vertices.
#[derive(Debug, Default)]
pub(super) struct Seen {
    /// A power of two of them, at most half of them taken; none before the first is.
    slots: Vec<u32>,
    taken: usize,
}

const FREE: u32 = u32::MAX;
/// Slots at first.
const FEW: usize = 128;
/// Slots that are kept for the next search.
const MANY: usize = 4096;

impl Seen {
    /// Forgets all.
    pub fn clear(&mut self) {
        if self.slots.len() > MANY {
            *self = Self::default();
        } else if self.taken > 0 {
            self.slots.fill(FREE);
            self.taken = 0;
        }
    }

    /// Adds a vertex; tells whether it is new.
    #[inline]
    pub fn insert(&mut self, v: u32) -> bool {
        if 2 * self.taken >= self.slots.len() {
            self.grow();
        }
        let place = self.place(v);
        let is_new = self.slots[place] == FREE;
        self.slots[place] = v;
        self.taken += usize::from(is_new);
        is_new
    }

    /// Finds where `v` is or would be.
    #[inline]
    fn place(&self, v: u32) -> usize {
        let mask = self.slots.len() - 1;
        let mut place = (u64::from(v).wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 32) as usize & mask;
        while self.slots[place] != FREE && self.slots[place] != v {
            place = (place + 1) & mask;
        }
        place
    }

    #[cold]
    fn grow(&mut self) {
        let slots = vec![FREE; FEW.max(2 * self.slots.len())];
        let before = std::mem::replace(&mut self.slots, slots);
        for v in before.into_iter().filter(|&v| v != FREE) {
            let place = self.place(v);
            self.slots[place] = v;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Seen;

    #[test]
    fn each_is_new_once_until_all_is_forgotten() {
        let mut seen = Seen::default();
        for count in [3, 5000, 100] {
            for round in 0..2 {
                assert!((0..count).all(|v| seen.insert(v * 64) == (round == 0)));
            }
            seen.clear();
        }
    }
}
