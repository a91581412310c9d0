//! Breaks what is right.

/// Numbers that counts, indices and coordinates seldom are.
const NUMBERS: &[&str] = &[
    "0",
    "-1",
    "1",
    "2",
    "3",
    "7",
    "-0",
    "4294967295",
    "4294967296",
    "2147483648",
    "9007199254740993",
    "18446744073709551615",
    "99999999999999999999",
    "1e308",
    "1e309",
    "-1e-320",
    "nan",
    "inf",
    "0x10",
    "1e5",
    "1000000",
    "65535",
    "65536",
    "0.1",
    ".",
    "-",
    "1e",
    "",
];

/// The same as bytes.
const WORDS: &[u64] = &[
    0,
    1,
    2,
    3,
    127,
    128,
    255,
    256,
    0x7fff,
    0x8000,
    0xffff,
    0x7fff_ffff,
    0x8000_0000,
    0xffff_ffff,
    0x1_0000_0000,
    0x7fff_ffff_ffff_ffff,
    u64::MAX,
    0x7ff0_0000_0000_0000,
    0x7ff8_0000_0000_0000,
    0x7fef_ffff_ffff_ffff,
    0x4000_0000,
    0x0100_0000,
];

/// Deep nesting, and what else repeats.
const REPEATED: &[&str] = &[
    "(",
    "[",
    "{",
    "[[",
    "{\"a\":",
    "<a>",
    "<g>",
    "GEOMETRYCOLLECTION (",
    " ",
    "\n",
    "\0",
    "9",
    "0 0\n",
    "((",
    ",",
    ";",
];

/// Breaks files in many ways; the same ways for a seed on every machine.
#[derive(Clone, Debug)]
pub struct Breaker {
    state: u64,
}

impl Breaker {
    /// Makes the one of a seed.
    pub fn new(seed: u64) -> Self {
        Self { state: seed }
    }

    /// Draws 64 bits: SplitMix64, by Steele, Lea and Flood.
    pub fn bits(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.state ^ self.state >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ mixed >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ mixed >> 31
    }

    /// Draws a number below a bound, 0 if that is 0.
    pub fn below(&mut self, bound: usize) -> usize {
        match bound {
            0 => 0,
            bound => (self.bits() % bound as u64) as usize,
        }
    }

    fn choose<T: Copy>(&mut self, items: &[T]) -> T {
        items[self.below(items.len())]
    }

    /// Breaks a file in some places, mostly few; `other` lends pieces.
    pub fn break_file(&mut self, file: &mut Vec<u8>, other: &[u8]) {
        let times = 1 + self.bits().trailing_zeros().min(6);
        for _ in 0..times {
            self.break_once(file, other);
        }
    }

    fn break_once(&mut self, file: &mut Vec<u8>, other: &[u8]) {
        match self.below(16) {
            0 => self.flip(file),
            1 => self.replace_byte(file),
            2 => file.truncate(self.below(file.len() + 1)),
            3 => self.take_out(file),
            4 => self.double(file),
            5 => self.splice(file, other),
            6..=9 => self.edit_number(file),
            10..=12 => self.write_word(file),
            13 => self.repeat(file),
            14 => self.swap_lines(file),
            _ => self.nudge(file),
        }
    }

    fn flip(&mut self, file: &mut [u8]) {
        let bit = self.below(8);
        if let Some(byte) = self.place(file) {
            *byte ^= 1 << bit;
        }
    }

    fn replace_byte(&mut self, file: &mut [u8]) {
        let new = self.bits() as u8;
        if let Some(byte) = self.place(file) {
            *byte = new;
        }
    }

    /// Adds or takes a little: lengths and counts that are nearly right.
    fn nudge(&mut self, file: &mut [u8]) {
        let by = self.choose(&[1, 255, 2, 254, 16, 240]);
        if let Some(byte) = self.place(file) {
            *byte = byte.wrapping_add(by);
        }
    }

    /// Chooses a byte, half of the time near the beginning, where headers are.
    fn place<'f>(&mut self, file: &'f mut [u8]) -> Option<&'f mut u8> {
        let place = self.position(file.len());
        file.get_mut(place)
    }

    fn position(&mut self, length: usize) -> usize {
        match self.below(3) {
            0 => self.below(length.min(64)),
            1 => length.saturating_sub(1 + self.below(length.min(64))),
            _ => self.below(length),
        }
    }

    fn range(&mut self, length: usize) -> std::ops::Range<usize> {
        let start = self.position(length);
        let longest = self.choose(&[4, 16, 64, 1 << 20]);
        let end = start + self.below((length - start).min(longest) + 1);
        start..end
    }

    fn take_out(&mut self, file: &mut Vec<u8>) {
        let range = self.range(file.len());
        file.drain(range);
    }

    fn double(&mut self, file: &mut Vec<u8>) {
        let range = self.range(file.len());
        let piece = file[range.clone()].to_vec();
        file.splice(range.start..range.start, piece);
    }

    fn splice(&mut self, file: &mut Vec<u8>, other: &[u8]) {
        let piece = self.range(other.len());
        let place = self.range(file.len());
        file.splice(place, other[piece].iter().copied());
    }

    /// Puts another number where digits are.
    fn edit_number(&mut self, file: &mut Vec<u8>) {
        let from = self.position(file.len());
        let is_number = |b: &u8| b.is_ascii_digit() || b"+-.eE".contains(b);
        let Some(skipped) = file[from..].iter().position(u8::is_ascii_digit) else {
            return;
        };
        let start = from + skipped;
        let length = file[start..].iter().position(|b| !is_number(b));
        let end = length.map_or(file.len(), |length| start + length);
        let new = self.choose(NUMBERS);
        file.splice(start..end, new.bytes());
    }

    /// Puts a number of 1, 2, 4 or 8 bytes somewhere, of either endianness.
    fn write_word(&mut self, file: &mut [u8]) {
        let word = self.choose(WORDS);
        let size = self.choose(&[1, 2, 4, 4, 8, 8]);
        let aligned = self.bits() & 1 == 0;
        let mut start = self.position(file.len());
        if aligned {
            start -= start % size;
        }
        let mut bytes = word.to_le_bytes();
        if self.below(4) == 0 {
            bytes[..size].reverse();
        }
        for (to, from) in file[start..].iter_mut().zip(&bytes[..size]) {
            *to = *from;
        }
    }

    fn repeat(&mut self, file: &mut Vec<u8>) {
        let what = self.choose(REPEATED);
        let times = 1 << self.below(13);
        let place = self.position(file.len());
        file.splice(place..place, what.repeat(times).into_bytes());
    }

    fn swap_lines(&mut self, file: &mut Vec<u8>) {
        let mut lines: Vec<&[u8]> = file.split_inclusive(|&b| b == b'\n').collect();
        let [a, b] = [self.below(lines.len()), self.below(lines.len())];
        if a < lines.len() && b < lines.len() {
            lines.swap(a, b);
        }
        *file = lines.concat();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_seed_always_breaks_alike() {
        let broken = |seed| {
            let mut breaker = Breaker::new(seed);
            let mut file = b"3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n".to_vec();
            breaker.break_file(&mut file, b"other");
            file
        };
        assert_eq!(broken(7), broken(7));
        let kinds: std::collections::BTreeSet<_> = (0..200).map(broken).collect();
        assert!(kinds.len() > 150, "{}", kinds.len());
    }

    #[test]
    fn nothing_can_be_broken() {
        for seed in 0..500 {
            let mut file = Vec::new();
            Breaker::new(seed).break_file(&mut file, b"");
        }
    }
}
