//! The few characters that pictures need, as strokes, so that SVG and PNG look alike without a
//! font.
//!
//! Each is a path of moves, lines and cubic curves with absolute coordinates; the base line is
//! y = 0, y down, digits are 7 high.

/// Returns the strokes of a character and how far to the next it is; others are blank.
fn glyph(character: char) -> (&'static str, f32) {
    match character {
        '0' => (
            "M4.4 -3.5C4.4 -1.6 3.5 0 2.3 0C1.1 0 .2 -1.6 .2 -3.5C.2 -5.4 1.1 -7 2.3 -7C3.5 -7 4.4 -5.4 4.4 -3.5",
            5.9,
        ),
        '1' => ("M.9 -5.8L2.6 -7L2.6 0", 5.9),
        '2' => (
            "M.4 -5.2C.4 -6.3 1.2 -7 2.3 -7C3.4 -7 4.2 -6.2 4.2 -5.1C4.2 -4 3.4 -3.2 .3 0L4.4 0",
            5.9,
        ),
        '3' => (
            "M.5 -5.6C.8 -6.5 1.5 -7 2.3 -7C3.3 -7 4.1 -6.3 4.1 -5.4C4.1 -4.4 3.3 -3.8 1.9 -3.8C3.4 -3.8 4.3 -3 4.3 -1.9C4.3 -.8 3.4 0 2.3 0C1.3 0 .5 -.5 .2 -1.5",
            5.9,
        ),
        '4' => ("M3.4 0L3.4 -7L.1 -1.9L4.6 -1.9", 5.9),
        '5' => (
            "M4 -7L1 -7L.7 -4C1.2 -4.4 1.7 -4.6 2.2 -4.6C3.5 -4.6 4.4 -3.6 4.4 -2.3C4.4 -1 3.5 0 2.2 0C1.2 0 .5 -.5 .2 -1.3",
            5.9,
        ),
        '6' => (
            "M3.4 -7L.6 -3.6C.3 -3.2 .1 -2.7 .1 -2.2C.1 -1 1.1 0 2.3 0C3.5 0 4.5 -1 4.5 -2.2C4.5 -3.4 3.5 -4.4 2.3 -4.4C1.5 -4.4 .9 -4.1 .5 -3.5",
            5.9,
        ),
        '7' => ("M.3 -7L4.4 -7L1.7 0", 5.9),
        '8' => (
            "M2.3 -3.8C1.2 -3.8 .5 -4.5 .5 -5.4C.5 -6.3 1.2 -7 2.3 -7C3.4 -7 4.1 -6.3 4.1 -5.4C4.1 -4.5 3.4 -3.8 2.3 -3.8C1 -3.8 .2 -3 .2 -1.9C.2 -.8 1 0 2.3 0C3.6 0 4.4 -.8 4.4 -1.9C4.4 -3 3.6 -3.8 2.3 -3.8",
            5.9,
        ),
        '9' => (
            "M1.2 0L4 -3.4C4.3 -3.8 4.5 -4.3 4.5 -4.8C4.5 -6 3.5 -7 2.3 -7C1.1 -7 .1 -6 .1 -4.8C.1 -3.6 1.1 -2.6 2.3 -2.6C3.1 -2.6 3.7 -2.9 4.1 -3.5",
            5.9,
        ),
        '-' => ("M.4 -2.9L3.6 -2.9", 5.2),
        '.' => ("M.5 -.1L.6 -.1", 2.4),
        '°' => (
            "M2.2 -6.1C2.2 -5.6 1.8 -5.2 1.3 -5.2C.8 -5.2 .4 -5.6 .4 -6.1C.4 -6.6 .8 -7 1.3 -7C1.8 -7 2.2 -6.6 2.2 -6.1",
            3.0,
        ),
        'a' => (
            "M4.8 -4.8L4.8 0M4.8 -2.4C4.8 -1.1 3.7 0 2.4 0C1.1 0 0 -1.1 0 -2.4C0 -3.7 1.1 -4.8 2.4 -4.8C3.7 -4.8 4.8 -3.7 4.8 -2.4",
            6.5,
        ),
        'c' => (
            "M4.4 -1.1C4 -.4 3.3 0 2.4 0C1.1 0 0 -1.1 0 -2.4C0 -3.7 1.1 -4.8 2.4 -4.8C3.3 -4.8 4 -4.4 4.4 -3.7",
            5.9,
        ),
        'e' => (
            "M.1 -2.5L4.7 -2.5C4.7 -3.8 3.7 -4.8 2.4 -4.8C1.1 -4.8 0 -3.7 0 -2.4C0 -1.1 1.1 0 2.4 0C3.3 0 4 -.4 4.5 -1.2",
            6.2,
        ),
        'g' => (
            "M4.8 -4.8L4.8 0C4.8 1.4 3.8 2.2 2.4 2.2C1.4 2.2 .7 1.9 .2 1.2M4.8 -2.4C4.8 -1.1 3.7 0 2.4 0C1.1 0 0 -1.1 0 -2.4C0 -3.7 1.1 -4.8 2.4 -4.8C3.7 -4.8 4.8 -3.7 4.8 -2.4",
            6.5,
        ),
        'i' => ("M.1 -4.8L.1 0M.1 -6.8L.1 -6.7", 1.9),
        'l' => ("M.1 -7L.1 0", 1.9),
        'm' => (
            "M0 -4.8L0 0M0 -2.8C0 -4 .8 -4.8 1.8 -4.8C2.9 -4.8 3.5 -4 3.5 -2.8L3.5 0M3.5 -2.8C3.5 -4 4.3 -4.8 5.3 -4.8C6.4 -4.8 7 -4 7 -2.8L7 0",
            8.6,
        ),
        'n' => (
            "M0 -4.8L0 0M0 -2.6C0 -4 .9 -4.8 2.1 -4.8C3.3 -4.8 4.1 -4 4.1 -2.6L4.1 0",
            5.8,
        ),
        'o' => (
            "M4.8 -2.4C4.8 -1.1 3.7 0 2.4 0C1.1 0 0 -1.1 0 -2.4C0 -3.7 1.1 -4.8 2.4 -4.8C3.7 -4.8 4.8 -3.7 4.8 -2.4",
            6.5,
        ),
        'r' => ("M0 -4.8L0 0M0 -2.6C0 -4 .8 -4.8 2 -4.8L2.4 -4.7", 3.7),
        's' => (
            "M3.2 -4C2.9 -4.5 2.4 -4.8 1.7 -4.8C.8 -4.8 .2 -4.3 .2 -3.6C.2 -2.1 3.5 -2.9 3.5 -1.3C3.5 -.5 2.8 0 1.8 0C1 0 .3 -.3 0 -1",
            4.9,
        ),
        't' => (
            "M1.2 -6.5L1.2 -1.3C1.2 -.4 1.7 0 2.6 0M0 -4.8L2.5 -4.8",
            4.0,
        ),
        _ => ("", 3.0),
    }
}

/// A command of a path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Stroke {
    Move([f32; 2]),
    Line([f32; 2]),
    Cubic([[f32; 2]; 3]),
}

/// Returns the strokes of a line of text that begins at `start`; digits are 7 `scale` high.
pub(crate) fn strokes(text: &str, start: [f32; 2], scale: f32) -> Vec<Stroke> {
    let mut pen = start[0];
    let mut strokes = Vec::new();
    for (path, advance) in text.chars().map(glyph) {
        let place = |p: [f32; 2]| [pen + p[0] * scale, start[1] + p[1] * scale];
        strokes.extend(parse(path).into_iter().map(|stroke| match stroke {
            Stroke::Move(p) => Stroke::Move(place(p)),
            Stroke::Line(p) => Stroke::Line(place(p)),
            Stroke::Cubic(points) => Stroke::Cubic(points.map(place)),
        }));
        pen += advance * scale;
    }
    strokes
}

/// Returns the width of a line of text.
pub(crate) fn width(text: &str, scale: f32) -> f32 {
    text.chars().map(|c| glyph(c).1 * scale).sum()
}

fn parse(path: &str) -> Vec<Stroke> {
    let commands = path.split_inclusive(|c: char| c.is_ascii_alphabetic());
    // Split so, each piece ends with the letter of the next: letters first, then numbers.
    let letters = path.chars().filter(char::is_ascii_alphabetic);
    let numbers = commands.skip(1).map(|piece| {
        let piece = piece.trim_end_matches(|c: char| c.is_ascii_alphabetic());
        let numbers: Vec<f32> = piece.split(' ').filter_map(|n| n.parse().ok()).collect();
        numbers
    });
    letters
        .zip(numbers)
        .filter_map(|(letter, n)| match (letter, n.as_slice()) {
            ('M', &[x, y]) => Some(Stroke::Move([x, y])),
            ('L', &[x, y]) => Some(Stroke::Line([x, y])),
            ('C', &[a, b, c, d, x, y]) => Some(Stroke::Cubic([[a, b], [c, d], [x, y]])),
            _ => None,
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::{glyph, parse};

    #[test]
    fn every_glyph_is_read_in_full() {
        for character in "0123456789-.° smallest angle segment crossing region".chars() {
            let path = glyph(character).0;
            let letters = path.chars().filter(char::is_ascii_alphabetic).count();
            assert_eq!(parse(path).len(), letters, "{character}");
        }
    }
}
