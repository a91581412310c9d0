//! Two numbers side by side: one lane for the left hull, one for the right.
//!
//! On x86-64 these are SSE2 registers, part of every such processor; elsewhere plain arrays, with
//! the same results bit for bit.

use std::ops::{Add, BitAnd, Mul, Sub};

#[cfg(not(target_arch = "x86_64"))]
use plain as lanes;
#[cfg(target_arch = "x86_64")]
use sse2 as lanes;

/// Two lanes of `f64`.
#[derive(Clone, Copy)]
pub(super) struct Pair(lanes::Lanes);

impl Pair {
    #[inline(always)]
    pub fn new(left: f64, right: f64) -> Self {
        Self(lanes::new(left, right))
    }

    #[inline(always)]
    pub fn both(value: f64) -> Self {
        Self::new(value, value)
    }

    #[inline(always)]
    pub fn left(self) -> f64 {
        lanes::get(self.0)[0]
    }

    #[inline(always)]
    pub fn right(self) -> f64 {
        lanes::get(self.0)[1]
    }

    #[inline(always)]
    pub fn abs(self) -> Self {
        Self(lanes::abs(self.0))
    }

    /// Marks the lanes in which this is greater; never with NaN.
    #[inline(always)]
    pub fn exceeds(self, other: Self) -> Mask {
        Mask(lanes::exceeds(self.0, other.0))
    }
}

/// A mark in each lane.
#[derive(Clone, Copy)]
pub(super) struct Mask(lanes::Marks);

impl Mask {
    /// Bit 0: the left lane is marked; bit 1: the right one.
    #[inline(always)]
    pub fn bits(self) -> u32 {
        lanes::bits(self.0)
    }
}

impl Mask {
    /// Keeps the marks of lanes that `other` does not mark.
    #[inline(always)]
    pub fn except(self, other: Self) -> Self {
        Self(lanes::except(self.0, other.0))
    }
}

impl BitAnd for Mask {
    type Output = Self;

    #[inline(always)]
    fn bitand(self, other: Self) -> Self {
        Self(lanes::and(self.0, other.0))
    }
}

impl Add for Pair {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self(lanes::add(self.0, other.0))
    }
}

impl Sub for Pair {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self(lanes::sub(self.0, other.0))
    }
}

impl Mul for Pair {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self(lanes::mul(self.0, other.0))
    }
}

#[cfg(target_arch = "x86_64")]
mod sse2 {
    use std::arch::x86_64::*;

    pub type Lanes = __m128d;
    pub type Marks = __m128d;

    // SAFETY, of every block here: SSE2 is part of x86-64, and no instruction touches memory.

    #[inline(always)]
    pub fn new(left: f64, right: f64) -> Lanes {
        // SAFETY: see above.
        unsafe { _mm_set_pd(right, left) }
    }

    #[inline(always)]
    pub fn get(a: Lanes) -> [f64; 2] {
        // SAFETY: see above.
        unsafe { [_mm_cvtsd_f64(a), _mm_cvtsd_f64(_mm_unpackhi_pd(a, a))] }
    }

    #[inline(always)]
    pub fn abs(a: Lanes) -> Lanes {
        // SAFETY: see above.
        unsafe { _mm_andnot_pd(_mm_set1_pd(-0.0), a) }
    }

    #[inline(always)]
    pub fn exceeds(a: Lanes, b: Lanes) -> Marks {
        // SAFETY: see above.
        unsafe { _mm_cmpgt_pd(a, b) }
    }

    #[inline(always)]
    pub fn and(a: Marks, b: Marks) -> Marks {
        // SAFETY: see above.
        unsafe { _mm_and_pd(a, b) }
    }

    #[inline(always)]
    pub fn except(a: Marks, b: Marks) -> Marks {
        // SAFETY: see above.
        unsafe { _mm_andnot_pd(b, a) }
    }

    #[inline(always)]
    pub fn bits(a: Marks) -> u32 {
        // SAFETY: see above.
        unsafe { _mm_movemask_pd(a) as u32 }
    }

    #[inline(always)]
    pub fn add(a: Lanes, b: Lanes) -> Lanes {
        // SAFETY: see above.
        unsafe { _mm_add_pd(a, b) }
    }

    #[inline(always)]
    pub fn sub(a: Lanes, b: Lanes) -> Lanes {
        // SAFETY: see above.
        unsafe { _mm_sub_pd(a, b) }
    }

    #[inline(always)]
    pub fn mul(a: Lanes, b: Lanes) -> Lanes {
        // SAFETY: see above.
        unsafe { _mm_mul_pd(a, b) }
    }
}

/// Used where there is no SSE2, and held against it by a test.
#[cfg(any(test, not(target_arch = "x86_64")))]
mod plain {
    pub type Lanes = [f64; 2];
    pub type Marks = u32;

    #[inline(always)]
    pub fn new(left: f64, right: f64) -> Lanes {
        [left, right]
    }

    #[inline(always)]
    pub fn get(a: Lanes) -> [f64; 2] {
        a
    }

    #[inline(always)]
    pub fn abs(a: Lanes) -> Lanes {
        a.map(f64::abs)
    }

    #[inline(always)]
    pub fn exceeds(a: Lanes, b: Lanes) -> Marks {
        u32::from(a[0] > b[0]) | u32::from(a[1] > b[1]) << 1
    }

    #[inline(always)]
    pub fn and(a: Marks, b: Marks) -> Marks {
        a & b
    }

    #[inline(always)]
    pub fn except(a: Marks, b: Marks) -> Marks {
        a & !b
    }

    #[inline(always)]
    pub fn bits(a: Marks) -> u32 {
        a
    }

    #[inline(always)]
    pub fn add(a: Lanes, b: Lanes) -> Lanes {
        [a[0] + b[0], a[1] + b[1]]
    }

    #[inline(always)]
    pub fn sub(a: Lanes, b: Lanes) -> Lanes {
        [a[0] - b[0], a[1] - b[1]]
    }

    #[inline(always)]
    pub fn mul(a: Lanes, b: Lanes) -> Lanes {
        [a[0] * b[0], a[1] * b[1]]
    }
}

#[cfg(all(test, target_arch = "x86_64"))]
mod tests {
    use super::{plain, sse2};

    #[test]
    fn both_kinds_of_lanes_agree() {
        let values = [
            0.0,
            -0.0,
            1.5,
            -2.25,
            1e-300,
            -1e300,
            f64::INFINITY,
            f64::NAN,
        ];
        for a in values {
            for b in values {
                let (s, t) = (sse2::new(a, b), sse2::new(b, 1.0));
                let (p, q) = (plain::new(a, b), plain::new(b, 1.0));
                let same = |s: sse2::Lanes, p: plain::Lanes| {
                    let [s, p] = [sse2::get(s), plain::get(p)];
                    s.iter()
                        .zip(p)
                        .all(|(s, p)| s.to_bits() == p.to_bits() || s.is_nan() && p.is_nan())
                };
                assert!(same(s, p) && same(sse2::abs(s), plain::abs(p)));
                assert!(same(sse2::add(s, t), plain::add(p, q)));
                assert!(same(sse2::sub(s, t), plain::sub(p, q)));
                assert!(same(sse2::mul(s, t), plain::mul(p, q)));
                let [above, below] = [sse2::exceeds(s, t), sse2::exceeds(t, s)];
                let [over, under] = [plain::exceeds(p, q), plain::exceeds(q, p)];
                assert_eq!(sse2::bits(above), plain::bits(over));
                assert_eq!(
                    sse2::bits(sse2::and(above, below)),
                    plain::bits(plain::and(over, under))
                );
                assert_eq!(
                    sse2::bits(sse2::except(above, below)),
                    plain::bits(plain::except(over, under))
                );
                assert_eq!(sse2::bits(sse2::and(above, above)), plain::bits(over));
            }
        }
    }
}
