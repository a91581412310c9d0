//! Colours: a scale of even steps to the eye, and the few others.
//!
//! The scale runs from dark violet through blue and green to light yellow, as the well-known ones
//! do, but is made by formula: lightness and hue grow evenly in the OKLab space (B. Ottosson, *A
//! perceptual color space for image processing*, 2020).

/// A colour of the screen (sRGB), each channel from 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Color(pub [f32; 3]);

/// The background.
pub(crate) const PAPER: Color = Color([1.0, 1.0, 1.0]);

/// Lines, dots and letters.
pub(crate) const INK: Color = Color([0.09, 0.10, 0.15]);

impl Color {
    /// Returns the channels as amounts of light, which may be averaged.
    pub fn to_light(self) -> [f32; 3] {
        self.0.map(|c| match c {
            0.0..=0.04045 => c / 12.92,
            _ => ((c + 0.055) / 1.055).powf(2.4),
        })
    }

    /// Makes a colour from amounts of light; what the screen cannot show is clipped.
    pub fn from_light(light: [f32; 3]) -> Self {
        Self(light.map(|l| match l.clamp(0.0, 1.0) {
            l @ 0.0..=0.003_130_8 => l * 12.92,
            l => 1.055 * l.powf(1.0 / 2.4) - 0.055,
        }))
    }

    /// Returns the channels from 0 to 255.
    pub fn bytes(self) -> [u8; 3] {
        self.0.map(|c| (c * 255.0).round() as u8)
    }

    /// Returns the colour as CSS writes it.
    pub fn hex(self) -> String {
        let [r, g, b] = self.bytes();
        format!("#{r:02x}{g:02x}{b:02x}")
    }
}

/// Returns the colour at `t` from 0 (bad) to 1 (good).
pub(crate) fn scale(t: f32) -> Color {
    // Least colourful in the dark and in the blue, where the screen has little room.
    at(t, 0.105 + 0.055 * t)
}

/// Returns the colour at `t` from 0 (low) to 1 (high), paler than [`scale`]: no component is cut off
/// anywhere. Where one is, and then begins to rise, an even slope seems to have an edge.
pub(crate) fn even_scale(t: f32) -> Color {
    at(t, even_chroma(t))
}

fn even_chroma(t: f32) -> f32 {
    0.085 + 0.07 * t * t
}

/// Returns the colour at `t` of the scales, from dark violet to light yellow.
fn at(t: f32, chroma: f32) -> Color {
    Color::from_light(light_at(t, chroma))
}

/// Returns red, green and blue of that colour as light, beyond 0 to 1 where no screen can show it.
fn light_at(t: f32, chroma: f32) -> [f32; 3] {
    let lightness = 0.30 + 0.62 * t;
    let hue = (310.0 - 205.0 * t).to_radians();
    let (a, b) = (chroma * hue.cos(), chroma * hue.sin());
    let l = (lightness + 0.396_337_78 * a + 0.215_803_76 * b).powi(3);
    let m = (lightness - 0.105_561_346 * a - 0.063_854_17 * b).powi(3);
    let s = (lightness - 0.089_484_18 * a - 1.291_485_5 * b).powi(3);
    [
        4.076_741_7 * l - 3.307_711_6 * m + 0.230_969_94 * s,
        -1.268_438 * l + 2.609_757_4 * m - 0.341_319_4 * s,
        -0.004_196_086_3 * l - 0.703_418_6 * m + 1.707_614_7 * s,
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_of_the_even_scale_is_cut_off() {
        for i in 0..=1000 {
            let t = i as f32 / 1000.0;
            let light = light_at(t, even_chroma(t));
            assert!(
                light.iter().all(|l| (0.0..=1.0).contains(l)),
                "{t}: {light:?}"
            );
        }
    }
}
