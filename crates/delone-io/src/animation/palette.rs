//! A palette for drawings: few colours cover large areas, and many between them cover edges.
//!
//! Colours are put into boxes of 8 × 8 × 8; the boxes with most pixels each give their mean. So the plain
//! areas keep their colours, and the rest is off by less than the eye notices.

use crate::picture::PAPER;
use tiny_skia::PremultipliedColorU8;

/// The number that stands for a pixel that stays as it was.
pub(super) const TRANSPARENT: u8 = u8::MAX;

/// Bits of a component that tell the box.
const BITS: u32 = 5;

const BOXES: usize = 1 << (3 * BITS);

/// Pixels seen, and the colours chosen of them.
pub(super) struct Palette {
    /// Per box: how many pixels, and the sums of their components.
    seen: Vec<[u64; 4]>,
    colors: Vec<[u8; 3]>,
    /// Per box, the nearest color.
    nearest: Vec<u8>,
}

impl Default for Palette {
    fn default() -> Self {
        Self {
            seen: vec![[0; 4]; BOXES],
            colors: Vec::new(),
            nearest: Vec::new(),
        }
    }
}

impl Palette {
    /// Takes the pixels of a frame into account.
    pub fn learn(&mut self, pixels: &[PremultipliedColorU8]) {
        for pixel in pixels {
            let color = [pixel.red(), pixel.green(), pixel.blue()];
            let sums = &mut self.seen[box_of(color)];
            sums[0] += 1;
            (0..3).for_each(|k| sums[k + 1] += u64::from(color[k]));
        }
    }

    /// Chooses the colours.
    pub fn choose(&mut self) {
        let mut boxes: Vec<_> = (0..BOXES).filter(|&i| self.seen[i][0] > 0).collect();
        boxes.sort_by_key(|&i| (std::cmp::Reverse(self.seen[i][0]), i));
        boxes.truncate(usize::from(TRANSPARENT));
        let mean = |&i: &usize| {
            let [number, r, g, b] = self.seen[i];
            [r, g, b].map(|sum| ((sum + number / 2) / number) as u8)
        };
        self.colors = boxes.iter().map(mean).collect();
        if self.colors.is_empty() {
            self.colors.push(PAPER.bytes());
        }
        self.nearest = (0..BOXES).map(|i| self.find(middle_of(i))).collect();
        for (number, &i) in boxes.iter().enumerate() {
            self.nearest[i] = number as u8;
        }
    }

    fn find(&self, color: [u8; 3]) -> u8 {
        let distance = |other: &[u8; 3]| -> i32 {
            let squares = (0..3).map(|k| (i32::from(color[k]) - i32::from(other[k])).pow(2));
            squares.sum()
        };
        let numbers = 0..self.colors.len();
        let nearest = numbers.min_by_key(|&i| distance(&self.colors[i]));
        nearest.map_or(0, |i| i as u8)
    }

    /// Returns the number of the colour nearest to a pixel.
    pub fn nearest(&self, pixel: PremultipliedColorU8) -> u8 {
        self.nearest[box_of([pixel.red(), pixel.green(), pixel.blue()])]
    }

    /// Returns the colours as a file holds them, with one that stands for none.
    pub fn bytes(&self) -> Vec<u8> {
        let mut bytes = self.colors.as_flattened().to_vec();
        bytes.resize(3 * (usize::from(TRANSPARENT) + 1), 0);
        bytes
    }
}

fn box_of(color: [u8; 3]) -> usize {
    let part = |k: usize| usize::from(color[k] >> (8 - BITS)) << (k as u32 * BITS);
    part(0) | part(1) | part(2)
}

fn middle_of(i: usize) -> [u8; 3] {
    [0, 1, 2].map(|k| {
        let part = i >> (k * BITS) & ((1 << BITS) - 1);
        ((part << (8 - BITS)) + (1 << (7 - BITS))) as u8
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pixel([r, g, b]: [u8; 3]) -> PremultipliedColorU8 {
        PremultipliedColorU8::from_rgba(r, g, b, u8::MAX).expect("opaque")
    }

    #[test]
    fn plain_areas_keep_their_colours() {
        let mut palette = Palette::default();
        let plain = [[255, 255, 255], [23, 26, 38], [255, 158, 28]];
        for color in plain {
            palette.learn(&[pixel(color); 100_000]);
        }
        for i in 0..=u8::MAX {
            for j in 0..4 {
                palette.learn(&[pixel([i, 64 * j, 255 - i])]);
            }
        }
        palette.choose();
        let bytes = palette.bytes();
        assert_eq!(bytes.len(), 768);
        for color in plain {
            let number = usize::from(palette.nearest(pixel(color)));
            assert_eq!(bytes[3 * number..][..3], color);
        }
        for rare in [[0, 0, 255], [128, 64, 127], [3, 250, 3]] {
            assert_ne!(palette.nearest(pixel(rare)), TRANSPARENT);
        }
    }
}
