//! Transforms, lengths and views: the attributes that say where something is.

use super::path::Numbers;
use crate::curve::Affine;
use crate::{Problem, scan};

/// Reads a list of transforms, of which the last is taken first.
pub(super) fn parse(text: &[u8]) -> Result<Affine, Problem> {
    let mut all = Affine::IDENTITY;
    let mut rest = text;
    loop {
        rest = rest.trim_ascii_start();
        while let Some(further) = rest.strip_prefix(b",") {
            rest = further.trim_ascii_start();
        }
        if rest.is_empty() || rest == b"none" {
            return Ok(all);
        }
        let open = memchr::memchr(b'(', rest);
        let close = memchr::memchr(b')', rest);
        let (Some(open), Some(close)) = (open, close) else {
            return Err(unknown(rest));
        };
        if close < open {
            return Err(unknown(rest));
        }
        let numbers = Numbers::all(&rest[open + 1..close])?;
        let map = function(rest[..open].trim_ascii(), &numbers).ok_or_else(|| unknown(rest))?;
        all = all.after(&map);
        rest = &rest[close + 1..];
    }
}

fn unknown(text: &[u8]) -> Problem {
    Problem::Other(format!(
        "transform {:?} is not understood; known are matrix of 6 numbers, translate and scale of 1 or 2, \
         rotate of 1 or 3, skewX and skewY",
        scan::show(text)
    ))
}

fn function(name: &[u8], numbers: &[f64]) -> Option<Affine> {
    let skew = |degrees: f64| {
        let [cos, sin] = crate::curve::unit(degrees);
        sin / cos
    };
    Some(match (name, numbers) {
        (b"matrix", &[a, b, c, d, e, f]) => Affine::plane([a, b, c, d, e, f]),
        (b"translate", &[x]) => Affine::shift([x, 0.0, 0.0]),
        (b"translate", &[x, y]) => Affine::shift([x, y, 0.0]),
        (b"scale", &[s]) => Affine::scale([s, s, 1.0]),
        (b"scale", &[x, y]) => Affine::scale([x, y, 1.0]),
        (b"rotate", &[degrees]) => Affine::turn(degrees),
        (b"rotate", &[degrees, x, y]) => Affine::shift([x, y, 0.0])
            .after(&Affine::turn(degrees))
            .after(&Affine::shift([-x, -y, 0.0])),
        (b"skewX", &[degrees]) => Affine::plane([1.0, 0.0, skew(degrees), 1.0, 0.0, 0.0]),
        (b"skewY", &[degrees]) => Affine::plane([1.0, skew(degrees), 0.0, 1.0, 0.0, 0.0]),
        _ => return None,
    })
}

/// A length of an attribute.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Length {
    /// In units of the user space.
    Units(f64),
    /// A part of the view, as backgrounds have it.
    Percent,
}

/// Reads a length with its unit; an inch has 96 pixels, which are the units.
pub(super) fn length(text: &[u8]) -> Result<Length, Problem> {
    let text = text.trim_ascii();
    let mut numbers = Numbers {
        data: text,
        position: 0,
    };
    let value = numbers.number()?;
    let factor = match text[numbers.position..].trim_ascii() {
        b"" | b"px" => 1.0,
        b"in" => 96.0,
        b"cm" => 96.0 / 2.54,
        b"mm" => 96.0 / 25.4,
        b"q" | b"Q" => 96.0 / 101.6,
        b"pt" => 96.0 / 72.0,
        b"pc" => 16.0,
        b"%" => return Ok(Length::Percent),
        unit => {
            return Err(Problem::Other(format!(
                "unit {:?} of a length is not understood; known are px, in, cm, mm, q, pt and pc",
                scan::show(unit)
            )));
        }
    };
    Ok(Length::Units(value * factor))
}

/// Makes the map from what a `viewBox` shows into a view of this size, by `preserveAspectRatio`.
pub(super) fn view_box(
    text: &[u8],
    [width, height]: [Option<f64>; 2],
    ratio: &[u8],
) -> Result<Affine, Problem> {
    let [x, y, w, h] = Numbers::all(text)?[..] else {
        let text = format!("viewBox {:?} is not four numbers", scan::show(text));
        return Err(Problem::Other(text));
    };
    // Views without a size, or of nothing, are not scaled.
    let factor = |size: Option<f64>, shown: f64| size.filter(|_| shown > 0.0).map(|s| s / shown);
    let factors = [factor(width, w), factor(height, h)];
    let [mut sx, mut sy] = match factors {
        [Some(sx), Some(sy)] => [sx, sy],
        [Some(s), None] | [None, Some(s)] => [s, s],
        [None, None] => [1.0, 1.0],
    };
    let mut shift = [0.0; 2];
    let ratio = String::from_utf8_lossy(ratio);
    let align = ratio.split_ascii_whitespace().next().unwrap_or("xMidYMid");
    if align != "none" {
        let s = match ratio.contains("slice") {
            true => sx.max(sy),
            false => sx.min(sy),
        };
        let part = |low: &str, high: &str| match align {
            _ if align.contains(low) => 0.0,
            _ if align.contains(high) => 1.0,
            _ => 0.5,
        };
        shift = [
            (sx - s) * w * part("xMin", "xMax"),
            (sy - s) * h * part("YMin", "YMax"),
        ];
        [sx, sy] = [s, s];
    }
    Ok(Affine::shift([shift[0], shift[1], 0.0])
        .after(&Affine::scale([sx, sy, 1.0]))
        .after(&Affine::shift([-x, -y, 0.0])))
}
