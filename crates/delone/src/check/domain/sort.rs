//! Sorting that can be cancelled.

use crate::Error;
use crate::pace::Pace;
use std::cmp::Ordering;

/// Items that are sorted in one go: some ten thousand comparisons.
const RUN: usize = 1 << 10;

/// Sorts `items`, asking the watch now and then. Equal items come in any order.
///
/// *Cost*: n log n comparisons; a copy of the items if there are more than a thousand.
pub(super) fn sort<T: Copy>(
    items: &mut Vec<T>,
    pace: &mut Pace,
    compare: impl Fn(&T, &T) -> Ordering,
) -> Result<(), Error> {
    for run in items.chunks_mut(RUN) {
        pace.step()?;
        run.sort_unstable_by(&compare);
    }
    let mut length = RUN;
    while length < items.len() {
        let mut merged = Vec::with_capacity(items.len());
        for pair in items.chunks(2 * length) {
            let (left, right) = pair.split_at(length.min(pair.len()));
            merge(left, right, &mut merged, pace, &compare)?;
        }
        *items = merged;
        length *= 2;
    }
    Ok(())
}

fn merge<T: Copy>(
    mut left: &[T],
    mut right: &[T],
    merged: &mut Vec<T>,
    pace: &mut Pace,
    compare: impl Fn(&T, &T) -> Ordering,
) -> Result<(), Error> {
    while let ([l, ls @ ..], [r, rs @ ..]) = (left, right) {
        pace.step()?;
        if compare(r, l).is_lt() {
            merged.push(*r);
            right = rs;
        } else {
            merged.push(*l);
            left = ls;
        }
    }
    merged.extend_from_slice(left);
    merged.extend_from_slice(right);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Phase;

    #[test]
    fn sorts_as_the_standard_library_does() {
        for n in [0, 1, RUN, RUN + 1, 5 * RUN + 7] {
            let mut items: Vec<u64> = (0..n as u64).map(|i| i * 7_919 % 4_099).collect();
            let mut expected = items.clone();
            expected.sort_unstable();
            sort(&mut items, &mut Pace::new(&(), Phase::Check, 1), u64::cmp).unwrap();
            assert_eq!(items, expected);
        }
    }
}
