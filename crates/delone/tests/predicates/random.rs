//! A small generator (splitmix64), so that failures repeat.

pub struct Random(pub u64);

impl Random {
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Draws from `low..=high`.
    pub fn within(&mut self, low: i64, high: i64) -> i64 {
        low + (self.bits() % (high - low + 1).cast_unsigned()).cast_signed()
    }

    /// Draws from [0, 1).
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Draws from (−1, 1).
    pub fn signed(&mut self) -> f64 {
        2.0 * self.unit() - 1.0
    }

    /// Draws a power of two with an exponent from `low..=high`, all within the normal numbers.
    pub fn power(&mut self, low: i64, high: i64) -> f64 {
        2_f64.powi(self.within(low, high) as i32)
    }

    pub fn pick<T: Copy>(&mut self, from: &[T]) -> T {
        from[(self.bits() % from.len() as u64) as usize]
    }

    /// Draws among all finite numbers.
    pub fn finite(&mut self) -> f64 {
        loop {
            let x = f64::from_bits(self.bits());
            if x.is_finite() {
                return x;
            }
        }
    }

    /// Moves a number by up to two units in the last place.
    pub fn jitter(&mut self, x: f64) -> f64 {
        match self.within(-2, 2) {
            -2 => x.next_down().next_down(),
            -1 => x.next_down(),
            0 => x,
            1 => x.next_up(),
            _ => x.next_up().next_up(),
        }
    }
}
