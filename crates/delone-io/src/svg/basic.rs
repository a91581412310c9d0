//! The basic shapes: rectangles, circles, ellipses, lines, polylines, polygons; and paths.

use super::path::{self, Numbers};
use super::transform::{self, Length};
use super::tree::Element;
use crate::Problem;
use crate::curve::{Arc, Outline};
use std::f64::consts::FRAC_PI_2;

/// What an element draws.
pub(super) enum Basic {
    Outlines(Vec<Outline>),
    /// Something as large as a part of the view: a background.
    Background,
}

/// Makes the outlines of an element, if it is one that draws some.
pub(super) fn draw(element: &Element) -> Result<Option<Basic>, Problem> {
    let outlines = match &element.name[..] {
        b"path" => path::parse(element.get("d").unwrap_or_default())?,
        b"polyline" | b"polygon" => polyline(element)?.into_iter().collect(),
        b"line" | b"rect" | b"circle" | b"ellipse" => {
            let names = [
                "x1", "y1", "x2", "y2", "x", "y", "width", "height", "cx", "cy", "r", "rx", "ry",
            ];
            let lengths = Lengths::read(element, &names)?;
            let Some(lengths) = lengths else {
                return Ok(Some(Basic::Background));
            };
            match &element.name[..] {
                b"line" => Some(line(&lengths)),
                b"rect" => rectangle(&lengths),
                _ => ellipse(&lengths),
            }
            .into_iter()
            .collect()
        }
        _ => return Ok(None),
    };
    Ok(Some(Basic::Outlines(outlines)))
}

/// The lengths of an element.
struct Lengths(Vec<(&'static str, f64)>);

impl Lengths {
    /// Reads those that are there; none if one of them is a part of the view.
    fn read(element: &Element, names: &[&'static str]) -> Result<Option<Self>, Problem> {
        let mut all = Vec::new();
        for name in names {
            match element.get(name) {
                None | Some(b"auto") => {}
                Some(text) => match transform::length(text)? {
                    Length::Units(value) => all.push((*name, value)),
                    Length::Percent => return Ok(None),
                },
            }
        }
        Ok(Some(Self(all)))
    }

    fn given(&self, name: &str) -> Option<f64> {
        self.0.iter().find(|(n, _)| *n == name).map(|(_, v)| *v)
    }

    fn get(&self, name: &str) -> f64 {
        self.given(name).unwrap_or(0.0)
    }
}

fn line(lengths: &Lengths) -> Outline {
    let [x1, y1, x2, y2] = ["x1", "y1", "x2", "y2"].map(|name| lengths.get(name));
    let mut outline = Outline::new([x1, y1, 0.0]);
    outline.line([x2, y2, 0.0]);
    outline
}

/// Makes a polyline or polygon, if it has points.
fn polyline(element: &Element) -> Result<Option<Outline>, Problem> {
    let numbers = Numbers::all(element.get("points").unwrap_or_default())?;
    if !numbers.len().is_multiple_of(2) {
        let text = format!("{} numbers are no points of two each", numbers.len());
        return Err(Problem::Other(text));
    }
    let mut places = numbers.chunks_exact(2).map(|p| [p[0], p[1], 0.0]);
    let Some(first) = places.next() else {
        return Ok(None);
    };
    let mut outline = Outline::new(first);
    places.for_each(|place| outline.line(place));
    outline.is_closed = element.name == b"polygon";
    Ok(Some(outline))
}

/// Makes a rectangle, if it is one of an area; with round corners, if it has radii.
fn rectangle(lengths: &Lengths) -> Option<Outline> {
    let [x, y, width, height] = ["x", "y", "width", "height"].map(|name| lengths.get(name));
    if !(width > 0.0 && height > 0.0) {
        return None;
    }
    // A radius that is not given is like the other.
    let [rx, ry] = [lengths.given("rx"), lengths.given("ry")];
    let rx_of = rx.or(ry).unwrap_or(0.0).clamp(0.0, 0.5 * width);
    let ry_of = ry.or(rx).unwrap_or(0.0).clamp(0.0, 0.5 * height);
    let [right, bottom] = [x + width, y + height];
    let is_round = rx_of > 0.0 && ry_of > 0.0;
    let [rx, ry] = if is_round { [rx_of, ry_of] } else { [0.0; 2] };
    let mut outline = Outline::new([x + rx, y, 0.0]);
    outline.is_closed = true;
    // Each side, and the corner behind it: its center, and from which of its axes it begins.
    let corners = [
        ([right - rx, y], [right - rx, y + ry], 3, [right, y + ry]),
        (
            [right, bottom - ry],
            [right - rx, bottom - ry],
            0,
            [right - rx, bottom],
        ),
        ([x + rx, bottom], [x + rx, bottom - ry], 1, [x, bottom - ry]),
        ([x, y + ry], [x + rx, y + ry], 2, [x + rx, y]),
    ];
    for ([ax, ay], [cx, cy], quarter, [bx, by]) in corners {
        if outline.end() != [ax, ay, 0.0] {
            outline.line([ax, ay, 0.0]);
        }
        if is_round {
            let mut arc = Arc::whole([cx, cy, 0.0], [rx, 0.0, 0.0], [0.0, ry, 0.0]);
            arc.start = f64::from(quarter) * FRAC_PI_2;
            arc.sweep = FRAC_PI_2;
            outline.arc(arc, [bx, by, 0.0]);
        }
    }
    Some(outline)
}

/// Makes a circle or an ellipse, if it has a radius.
fn ellipse(lengths: &Lengths) -> Option<Outline> {
    let [cx, cy, r] = ["cx", "cy", "r"].map(|name| lengths.get(name));
    let [rx, ry] = ["rx", "ry"].map(|name| lengths.given(name));
    let [rx, ry] = [rx.or(ry).unwrap_or(r), ry.or(rx).unwrap_or(r)];
    if !(rx > 0.0 && ry > 0.0) {
        return None;
    }
    let arc = Arc::whole([cx, cy, 0.0], [rx, 0.0, 0.0], [0.0, ry, 0.0]);
    let mut outline = Outline::new([cx + rx, cy, 0.0]);
    outline.arc(arc, outline.start);
    outline.is_closed = true;
    Some(outline)
}
