//! A small random generator whose stream never changes with a dependency's version.
//!
//! SplitMix64 (Steele, Lea, Flood 2014): one addition and two multiplications a number, good
//! enough for test points and not for anything secret. The transcendental functions come from the
//! pure-Rust `libm`, so the same seed gives the same bits on every machine.

use std::f64::consts::TAU;

/// A stream of random numbers fixed by its seed.
#[derive(Clone, Debug)]
pub struct Random {
    state: u64,
}

impl Random {
    /// Starts the stream of `seed`.
    pub fn new(seed: u64) -> Self {
        Self { state: seed }
    }

    /// Starts the stream of `seed` for the sample called `name`: two samples never share a stream.
    pub(crate) fn named(name: &str, seed: u64) -> Self {
        let salt = name.bytes().fold(0, |hash: u64, byte| {
            hash.wrapping_mul(257) + u64::from(byte)
        });
        Self::new(Self::new(seed).bits() ^ salt)
    }

    /// Draws 64 random bits.
    pub fn bits(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.state ^ (self.state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Draws uniformly from [0, 1), a multiple of 2⁻⁵³.
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 * (0.5f64).powi(53)
    }

    /// Draws uniformly from [`low`, `high`).
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// Draws uniformly from 0..`bound`; the bias is below `bound` / 2⁶⁴.
    pub fn below(&mut self, bound: usize) -> usize {
        ((u128::from(self.bits()) * bound as u128) >> 64) as usize
    }

    /// Draws a point of the standard normal distribution in the plane (Box and Muller).
    pub fn normal_pair(&mut self) -> [f64; 2] {
        // 1 − u is never zero, so the logarithm is finite.
        let radius = (-2.0 * libm::log(1.0 - self.unit())).sqrt();
        self.on_circle(radius)
    }

    /// Draws a point of the circle of `radius` about the origin; it lies on it up to rounding.
    pub fn on_circle(&mut self, radius: f64) -> [f64; 2] {
        let angle = TAU * self.unit();
        [radius * libm::cos(angle), radius * libm::sin(angle)]
    }

    /// Puts `items` into random order (Fisher and Yates).
    pub fn shuffle<T>(&mut self, items: &mut [T]) {
        for i in (1..items.len()).rev() {
            items.swap(i, self.below(i + 1));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Random;

    #[test]
    fn stream_is_the_published_one() {
        // First outputs of SplitMix64 for seed 1234567, from the reference implementation.
        let mut random = Random::new(1_234_567);
        assert_eq!(random.bits(), 6_457_827_717_110_365_317);
        assert_eq!(random.bits(), 3_203_168_211_198_807_973);
    }

    #[test]
    fn draws_stay_in_range() {
        let mut random = Random::new(7);
        for _ in 0..10_000 {
            assert!((0.0..1.0).contains(&random.unit()));
            assert!(random.below(13) < 13);
            assert!(random.normal_pair().iter().all(|c| c.is_finite()));
        }
    }

    #[test]
    fn shuffling_permutes() {
        let mut items: Vec<usize> = (0..1000).collect();
        Random::new(3).shuffle(&mut items);
        assert!(!items.is_sorted());
        items.sort_unstable();
        assert!(items.iter().copied().eq(0..1000));
    }
}
