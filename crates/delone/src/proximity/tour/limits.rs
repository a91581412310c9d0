//! When to stop, and where to kick.

use crate::clock::Clock;
use crate::pace::Pace;
use crate::{Error, Phase, Watch};
use std::time::Duration;

/// Looks at sites between two looks at the clock.
const STRIDE: u64 = 1 << 8;

/// A budget of moves and time.
pub(super) struct Limits<'w> {
    moves: u64,
    time: Option<Duration>,
    clock: Clock,
    pace: Pace<'w>,
    looks: u64,
    pub is_spent: bool,
}

impl<'w> Limits<'w> {
    /// Moves, and the time since the clock was started, are limited; `work` is how many sites will be looked at, as far as that can be guessed.
    pub fn new(
        moves: Option<u64>,
        time: Option<Duration>,
        clock: Clock,
        work: u64,
        watch: &'w dyn Watch,
    ) -> Self {
        Self {
            moves: moves.unwrap_or(u64::MAX),
            time,
            clock,
            pace: Pace::new(watch, Phase::Tour, work),
            looks: 0,
            is_spent: false,
        }
    }

    /// Tells whether one more site may be looked at, after so many moves.
    pub fn allows(&mut self, moves: u64) -> Result<bool, Error> {
        self.pace.step()?;
        self.looks += 1;
        let is_late = |time| self.looks.is_multiple_of(STRIDE) && self.clock.elapsed() >= time;
        self.is_spent |= moves >= self.moves || self.time.is_some_and(is_late);
        Ok(!self.is_spent)
    }
}

/// A sequence of numbers that are as good as random, and always the same (splitmix64, Steele, Lea and
/// Flood 2014).
pub(super) struct Random(pub u64);

impl Random {
    /// Draws a number below `bound`.
    pub fn below(&mut self, bound: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((u128::from(z ^ (z >> 31)) * bound as u128) >> 64) as usize
    }
}
