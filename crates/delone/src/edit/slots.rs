//! Ids that are given out, given back, and given out again: the one given back last comes first.
//!
//! So taking back what has been done, in reverse order, gives every id back to whoever had it.

/// Which ids are in use.
#[derive(Clone, Debug, Default)]
pub(super) struct Slots {
    is_used: Vec<bool>,
    free: Vec<u32>,
}

impl Slots {
    /// Begins with the ids for which `is_used` holds; of the others the lowest is given out first.
    pub fn new(is_used: Vec<bool>) -> Self {
        let ids = 0..is_used.len() as u32;
        let free = ids.rev().filter(|&id| !is_used[id as usize]).collect();
        Self { is_used, free }
    }

    /// Gives out an id.
    pub fn take(&mut self) -> u32 {
        match self.free.pop() {
            Some(id) => {
                self.is_used[id as usize] = true;
                id
            }
            None => {
                self.is_used.push(true);
                self.is_used.len() as u32 - 1
            }
        }
    }

    /// Takes an id back.
    pub fn give_back(&mut self, id: u32) {
        debug_assert!(self.is_used(id), "bug: {id} was not in use");
        self.is_used[id as usize] = false;
        self.free.push(id);
    }

    /// Tells whether an id is in use.
    pub fn is_used(&self, id: u32) -> bool {
        self.is_used.get(id as usize).copied().unwrap_or(false)
    }

    /// Counts the ids in use.
    pub fn count(&self) -> usize {
        self.is_used.len() - self.free.len()
    }

    /// Visits the ids in use, ascending.
    pub fn ids(&self) -> impl Iterator<Item = u32> + '_ {
        (0..self.is_used.len() as u32).filter(|&id| self.is_used(id))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ids_come_back_in_reverse_order() {
        let mut slots = Slots::new(vec![true, false, true, false]);
        assert_eq!([0; 3].map(|_| slots.take()), [1, 3, 4]);
        slots.give_back(0);
        slots.give_back(4);
        assert_eq!(
            (slots.count(), slots.is_used(4), slots.is_used(9)),
            (3, false, false)
        );
        assert!(slots.ids().eq([1, 2, 3]));
        assert_eq!([0; 3].map(|_| slots.take()), [4, 0, 5]);
    }
}
