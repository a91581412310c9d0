//! Morton keys: a bounding box cut into cells, and the order of the cells along the Z-curve.
//!
//! Keys are monotone in x and in y: where two keys first differ in a bit of one axis, the points
//! are strictly ordered in that axis. So the sorted keys *are* a hierarchy of cuts, each by a
//! vertical or horizontal line that no point touches (G. M. Morton 1966; Tropf & Herzog 1981).

use crate::Point;

/// The axis along which a cut separates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Axis {
    /// The left part has smaller x.
    X,
    /// The lower part has smaller y.
    Y,
}

/// Turns points of one bounding box into keys, and bits of keys into axes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Frame {
    /// How many boxes this one lies in: a group of equal keys gets a frame of its own.
    pub generation: u32,
    /// For each axis one half if a difference of two coordinates might overflow, else one.
    half: [f64; 2],
    origin: [f64; 2],
    /// Cells per unit, in two factors: one alone could leave the range of `f64`.
    scale: [[f64; 2]; 2],
    /// Bits that interleave: 2 · min(bits of x, bits of y).
    interleaved: u32,
    /// The axis of the odd ones among them: the longer side of a cell.
    odd: Axis,
    /// The axis of the bits above them: the longer side of the box.
    long: Axis,
}

/// Adding this to a number below 2³² leaves the number, rounded, in the low 32 bits.
const TO_INTEGER: f64 = (1u64 << 52) as f64;

impl Frame {
    /// Cuts the box from `min` to `max` into 2^`bits` cells, as square as the bits allow.
    ///
    /// `bits` is at most 32.
    pub fn new(min: [f64; 2], max: [f64; 2], bits: u32) -> Self {
        // Axis by axis: halving small coordinates could make different ones equal.
        let half = [0, 1].map(|k| {
            let largest = f64::max(min[k].abs(), max[k].abs());
            if largest > power_of_two(1000) {
                0.5
            } else {
                1.0
            }
        });
        let origin = [0, 1].map(|k| half[k] * min[k]);
        let extent = [0, 1].map(|k| half[k] * max[k] - origin[k]);
        let (x_bits, odd) = share_of_x(extent, bits as i32);
        let y_bits = bits as i32 - x_bits;
        Self {
            generation: 0,
            half,
            origin,
            scale: [factors(extent[0], x_bits), factors(extent[1], y_bits)],
            interleaved: 2 * x_bits.min(y_bits) as u32,
            odd,
            long: if x_bits >= y_bits { Axis::X } else { Axis::Y },
        }
    }

    /// The key of a point in the box.
    #[inline(always)]
    pub fn key(&self, p: Point) -> u32 {
        let x = self.cell(p.x, 0);
        let y = self.cell(p.y, 1);
        let half = self.interleaved / 2;
        let low = ((1u64 << half) - 1) as u32;
        let odd = u32::from(self.odd == Axis::X);
        let mixed = spread(x & low) << odd | spread(y & low) << (1 - odd);
        // Only the longer side has bits above those that interleave.
        let high = u64::from(x | y) >> half << self.interleaved;
        high as u32 | mixed
    }

    #[inline(always)]
    fn cell(&self, c: f64, axis: usize) -> u32 {
        let t =
            (self.half[axis] * c - self.origin[axis]) * self.scale[axis][0] * self.scale[axis][1];
        (t + TO_INTEGER).to_bits() as u32
    }

    /// The axis that a bit of the key cuts.
    #[inline(always)]
    pub fn axis(&self, bit: u32) -> Axis {
        if bit >= self.interleaved {
            self.long
        } else if (bit % 2 == 1) == (self.odd == Axis::X) {
            Axis::X
        } else {
            Axis::Y
        }
    }
}

/// Spreads the low 16 bits to the even positions.
#[inline(always)]
fn spread(v: u32) -> u32 {
    let v = (v | v << 8) & 0x00ff_00ff;
    let v = (v | v << 4) & 0x0f0f_0f0f;
    let v = (v | v << 2) & 0x3333_3333;
    (v | v << 1) & 0x5555_5555
}

/// The binary exponent of a positive number: −1074 for the least subnormal.
pub(crate) fn exponent(value: f64) -> i32 {
    let bits = value.to_bits() & !(1 << 63);
    match (bits >> 52) as i32 {
        0 => -1011 - bits.leading_zeros() as i32,
        biased => biased - 1023,
    }
}

/// A positive number divided by the power of two below it.
fn mantissa(value: f64) -> f64 {
    let [a, b] = split_power(-exponent(value));
    value * a * b
}

/// Two factors whose product is 2^e, −2044 ≤ e ≤ 2046.
pub(crate) fn split_power(e: i32) -> [f64; 2] {
    [power_of_two(e / 2), power_of_two(e - e / 2)]
}

/// 2^e for −1022 ≤ e ≤ 1023.
pub(crate) fn power_of_two(e: i32) -> f64 {
    f64::from_bits(((e + 1023) as u64) << 52)
}

/// How many of the bits x gets, and which axis is cut first: cells stay within 1 : 2, and are always
/// cut across their longer side (cutting them lengthwise makes the whole triangulation a tenth slower).
fn share_of_x(extent: [f64; 2], bits: i32) -> (i32, Axis) {
    let [x, y] = match extent {
        [_, 0.0] => return (bits, Axis::X),
        [0.0, _] => return (0, Axis::Y),
        [x, y] => [x, y],
    };
    let is_wider = mantissa(x) >= mantissa(y);
    let doubled = bits + exponent(x) - exponent(y);
    let (x_bits, odd) = match (doubled % 2 != 0, is_wider) {
        (false, true) => (doubled / 2, Axis::X),
        (false, false) => (doubled / 2, Axis::Y),
        (true, true) => ((doubled + 1).div_euclid(2), Axis::Y),
        (true, false) => ((doubled - 1).div_euclid(2), Axis::X),
    };
    (x_bits.clamp(0, bits), odd)
}

/// Two factors whose product maps `0..=extent` to `0..=2^bits − 1`.
fn factors(extent: f64, bits: i32) -> [f64; 2] {
    if extent == 0.0 || bits == 0 {
        return [0.0, 0.0];
    }
    let first = power_of_two((-exponent(extent)).clamp(-1022, 1023));
    let cells = power_of_two(bits) - 1.0;
    [first, cells / (extent * first)]
}

#[cfg(test)]
mod tests {
    use super::*;

    const LADDER: [f64; 12] = [
        -f64::MAX,
        -1.0,
        -1e-300,
        -5e-324,
        0.0,
        5e-324,
        1e-323,
        2e-308,
        0.1,
        1.0,
        1.0 + f64::EPSILON,
        f64::MAX,
    ];

    #[test]
    fn exponents_of_normal_and_subnormal_numbers() {
        for e in -1022..1024 {
            assert_eq!(exponent(power_of_two(e)), e);
        }
        assert_eq!(exponent(5e-324), -1074);
        assert_eq!(exponent(1.5e-323), -1073);
    }

    /// Splitting must come to an end: the extremes of a box never share a cell, however small or
    /// large it is.
    #[test]
    fn the_corners_of_any_box_get_different_keys() {
        for (i, &a) in LADDER.iter().enumerate() {
            for &b in &LADDER[i + 1..] {
                for bits in [18, 24, 32] {
                    let along = LADDER
                        .iter()
                        .flat_map(|&m| [([a, m], [b, m]), ([m, a], [m, b])]);
                    for (min, max) in along.chain([([a, a], [b, b])]) {
                        let frame = Frame::new(min, max, bits);
                        let [low, high] = [min, max].map(|p| frame.key(Point::from(p)));
                        assert_eq!(low, 0);
                        assert!(high > 0 && u64::from(high) < 1 << bits, "{min:?} {max:?}");
                    }
                }
            }
        }
    }

    #[test]
    fn the_highest_differing_bit_tells_an_axis_that_separates() {
        for (width, height) in [(1.0, 1.0), (1e6, 1.0), (1.0, 1e6), (1e300, 1e-300)] {
            let frame = Frame::new([0.0, 0.0], [width, height], 32);
            let points: Vec<Point> = (0..40)
                .map(|i| {
                    Point::new(
                        width * f64::from(i * 37 % 41) / 41.0,
                        height * f64::from(i) / 40.0,
                    )
                })
                .collect();
            for p in &points {
                for q in &points {
                    let (a, b) = (frame.key(*p), frame.key(*q));
                    if a < b {
                        match frame.axis((a ^ b).ilog2()) {
                            Axis::X => assert!(p.x < q.x),
                            Axis::Y => assert!(p.y < q.y),
                        }
                    }
                }
            }
        }
    }
}
