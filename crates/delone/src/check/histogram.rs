//! Counts of positive numbers of any magnitude, in bins whose widths grow with the numbers.
//!
//! Sixteen bins to every doubling: their borders are the powers of the sixteenth root of two, rounded to
//! eight binary digits behind the point, so that the leading bits of a number find its bin.

/// Counts of positive numbers, sixteen bins to every doubling.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct LogHistogram {
    /// Number of the first bin: its binary exponent, shifted, and which of the sixteen it is.
    first: usize,
    counts: Vec<usize>,
    outside: usize,
}

/// Bins to every doubling.
const BINS: usize = 16;

/// Binary digits behind the point that tell the bin.
const DIGITS: u32 = 8;

/// Bits of a number behind those digits.
const REST: u32 = f64::MANTISSA_DIGITS - 1 - DIGITS;

/// The digits at which bins begin: 256 (2^(k/16) − 1), rounded.
const STARTS: [u8; BINS] = [
    0, 11, 23, 36, 48, 62, 76, 91, 106, 122, 139, 156, 175, 194, 214, 234,
];

/// The bin for each value of the digits.
const BIN_OF: [u8; 1 << DIGITS] = {
    let mut table = [0; 1 << DIGITS];
    let mut bin = 0;
    let mut digits = 0;
    while digits < table.len() {
        if bin + 1 < BINS && digits >= STARTS[bin + 1] as usize {
            bin += 1;
        }
        table[digits] = bin as u8;
        digits += 1;
    }
    table
};

impl LogHistogram {
    /// Counts a number.
    pub fn add(&mut self, number: f64) {
        let is_inside = number > 0.0 && number.is_finite();
        if !is_inside {
            self.outside += 1;
            return;
        }
        let leading = (number.to_bits() >> REST) as usize;
        let digits = leading % (1 << DIGITS);
        let bin = (leading >> DIGITS) * BINS + usize::from(BIN_OF[digits]);
        match bin
            .checked_sub(self.first)
            .and_then(|i| self.counts.get_mut(i))
        {
            Some(count) => *count += 1,
            None => self.add_beyond(bin),
        }
    }

    /// Counts a number in a bin that there is not yet.
    #[cold]
    fn add_beyond(&mut self, bin: usize) {
        if self.counts.is_empty() {
            self.first = bin;
        }
        let before = self.first.saturating_sub(bin);
        self.counts.splice(..0, (0..before).map(|_| 0));
        self.first -= before;
        let i = bin - self.first;
        self.counts.resize(self.counts.len().max(i + 1), 0);
        self.counts[i] += 1;
    }

    /// Returns the counts of all bins from that of the smallest number to that of the largest, ascending.
    pub fn counts(&self) -> &[usize] {
        &self.counts
    }

    /// Returns the borders of bin `i` of [`counts`](Self::counts): the numbers that it counts are at least
    /// the first and less than the second.
    pub fn bounds(&self, i: usize) -> [f64; 2] {
        [i, i + 1].map(|i| {
            let bin = (self.first + i) as u64;
            let exponent = bin / BINS as u64;
            let digits = u64::from(STARTS[(bin % BINS as u64) as usize]);
            f64::from_bits((exponent << DIGITS | digits) << REST)
        })
    }

    /// Counts the numbers that have no bin: zero, infinity, and what is no number.
    pub fn outside(&self) -> usize {
        self.outside
    }

    /// Counts all numbers.
    pub fn total(&self) -> usize {
        self.counts.iter().sum::<usize>() + self.outside
    }
}

#[cfg(test)]
mod tests {
    use super::{BINS, LogHistogram, STARTS};

    #[test]
    fn bins_grow_evenly() {
        for (k, &start) in STARTS.iter().enumerate() {
            let exact = 256.0 * ((k as f64 / BINS as f64).exp2() - 1.0);
            assert!((exact - f64::from(start)).abs() <= 0.5, "{k}: {exact}");
        }
    }

    #[test]
    fn every_number_lies_between_the_borders_of_its_bin() {
        let mut number = 5e-324;
        while number < f64::MAX {
            let mut histogram = LogHistogram::default();
            histogram.add(number);
            assert_eq!(histogram.counts(), [1]);
            let [low, high] = histogram.bounds(0);
            assert!(low <= number && number < high, "{low} {number} {high}");
            number *= 1.7;
        }
    }

    #[test]
    fn bins_appear_on_both_sides() {
        let mut histogram = LogHistogram::default();
        for number in [8.0, 1.0, 2.0, 8.1, 64.0, 1.0] {
            histogram.add(number);
        }
        let counts = histogram.counts();
        assert_eq!(counts.len(), 6 * BINS + 1);
        let at = [0, 1, 3, 6].map(|octave| counts[octave * BINS]);
        assert_eq!((at, histogram.total()), ([2, 1, 2, 1], 6));
        assert_eq!(histogram.bounds(3 * BINS)[0], 8.0);
    }

    #[test]
    fn what_has_no_logarithm_is_counted_outside() {
        let mut histogram = LogHistogram::default();
        for number in [0.0, -0.0, f64::INFINITY, f64::NAN, 1.0] {
            histogram.add(number);
        }
        assert_eq!((histogram.outside(), histogram.total()), (4, 5));
    }
}
