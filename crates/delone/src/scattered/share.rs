//! Shares data out among a few triangles so that each holds enough, if that is possible.

/// Most triangles among which is shared.
pub(super) const MOST_PARTS: usize = 4;

/// The parts in which a datum may be: bit k for part k.
pub(super) type Parts = u8;

/// Chooses a part for each datum, out of those in which it may be, so that each of `parts` parts holds at least
/// `least` data; `None` if no choice does that.
///
/// A datum goes to the lowest part that still needs it and can have it without leaving another short for good; once
/// all have enough, to the lowest in which it may be.
///
/// Whether a choice exists is Hall's condition: together, any parts have enough data that may be in one of them.
///
/// *Cost*: O(n).
pub(super) fn share(options: &[Parts], parts: usize, least: usize) -> Option<Vec<u8>> {
    debug_assert!(parts <= MOST_PARTS && options.iter().all(|o| *o != 0 && *o < 1 << parts));
    let mut open = Open::new(options, parts, least);
    if !open.can_be_met() {
        return None;
    }
    // Data without a choice first: what the others must make up for is known then.
    for part in 0..parts {
        let sure = open.data[1 << part];
        open.needs[part] = open.needs[part].saturating_sub(sure);
        open.data[1 << part] = 0;
    }
    let choices = options.iter().map(|&options| match options.count_ones() {
        1 => options.trailing_zeros() as u8,
        _ => open.give(options),
    });
    Some(choices.collect())
}

/// Tells whether [`share`] finds a choice.
pub(super) fn can_share(
    options: impl IntoIterator<Item = Parts>,
    parts: usize,
    least: usize,
) -> bool {
    let mut open = Open::empty(parts, least);
    options.into_iter().for_each(|o| open.data[o as usize] += 1);
    open.can_be_met()
}

/// What is still to be given, and to whom.
struct Open {
    parts: usize,
    /// How many data each part still needs.
    needs: [usize; MOST_PARTS],
    /// How many data there are for each set of parts.
    data: [usize; 1 << MOST_PARTS],
}

impl Open {
    fn empty(parts: usize, least: usize) -> Self {
        let mut needs = [0; MOST_PARTS];
        needs[..parts].fill(least);
        Self {
            parts,
            needs,
            data: [0; 1 << MOST_PARTS],
        }
    }

    fn new(options: &[Parts], parts: usize, least: usize) -> Self {
        let mut open = Self::empty(parts, least);
        options.iter().for_each(|&o| open.data[o as usize] += 1);
        open
    }

    /// Hall's condition.
    fn can_be_met(&self) -> bool {
        (1..1usize << self.parts).all(|set| {
            let needed: usize = (0..self.parts)
                .filter(|part| set >> part & 1 != 0)
                .map(|part| self.needs[part])
                .sum();
            let may = |options: &usize| options & set != 0;
            let there: usize = (1..1usize << self.parts)
                .filter(may)
                .map(|o| self.data[o])
                .sum();
            there >= needed
        })
    }

    /// Gives a datum that may be in any of the parts `options` to one of them.
    fn give(&mut self, options: Parts) -> u8 {
        self.data[options as usize] -= 1;
        let may = (0..self.parts).filter(|part| options >> part & 1 != 0);
        for part in may.filter(|&part| self.needs[part] > 0).collect::<Vec<_>>() {
            self.needs[part] -= 1;
            if self.can_be_met() {
                return part as u8;
            }
            self.needs[part] += 1;
        }
        options.trailing_zeros() as u8
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// All choices, one after the other.
    fn naive(options: &[Parts], parts: usize, least: usize) -> bool {
        fn place(options: &[Parts], held: &mut [usize], least: usize) -> bool {
            let Some((&first, rest)) = options.split_first() else {
                return held.iter().all(|&held| held >= least);
            };
            (0..held.len()).any(|part| {
                if first >> part & 1 == 0 {
                    return false;
                }
                held[part] += 1;
                let found = place(rest, held, least);
                held[part] -= 1;
                found
            })
        }
        place(options, &mut vec![0; parts], least)
    }

    proptest! {
        #[test]
        fn shares_out_if_and_only_if_that_is_possible(
            parts in 1usize..=4, least in 0usize..4, raw in prop::collection::vec(1u8..16, 0..9),
        ) {
            let fit = |o: &u8| (o & ((1u8 << parts) - 1)).max(1);
            let options: Vec<_> = raw.iter().map(fit).collect();
            let shared = share(&options, parts, least);
            prop_assert_eq!(shared.is_some(), naive(&options, parts, least));
            prop_assert_eq!(shared.is_some(), can_share(options.iter().copied(), parts, least));
            if let Some(shared) = shared {
                let mut held = vec![0; parts];
                for (part, options) in shared.iter().zip(&options) {
                    prop_assert!(options >> part & 1 != 0);
                    held[*part as usize] += 1;
                }
                prop_assert!(held.iter().all(|&held| held >= least));
            }
        }
    }
}
