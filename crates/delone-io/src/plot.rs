//! Measurements as lines in panels, beside each other: `.svg` and `.png`.
//!
//! Both axes are logarithmic, so what grows like a power of the size is a straight line whose slope is the
//! exponent. A line may have a band around it: how far to trust it.

use crate::picture::sheet::{Anchor, Sheet};
use crate::picture::{Color, INK, PAPER};
use crate::points::unsupported;
use crate::target::{Output, Staging};
use crate::{Error, Format, Target, png, svg};
use delone::Watch;
use quick_xml::escape::escape;
use std::path::PathBuf;
use tiny_skia::Pixmap;

/// Extent of a panel, its margins (left, top, right, bottom) and the height of a row of the legend, in
/// pixels of the usual size.
const PANEL: [f32; 2] = [520.0, 430.0];
const MARGINS: [f32; 4] = [84.0, 70.0, 20.0, 60.0];
const LEGEND: f32 = 34.0;

/// Sizes of text, as multiples of a seventh of the height of digits.
const TITLE: f32 = 2.2;
const TEXT: f32 = 1.7;

/// Colours of lines: told apart by people who see red and green alike, too (after Okabe and Ito).
pub(crate) const COLORS: [Color; 8] = [
    Color([0.000, 0.447, 0.698]),
    Color([0.835, 0.369, 0.000]),
    Color([0.000, 0.620, 0.451]),
    Color([0.800, 0.475, 0.655]),
    Color([0.337, 0.706, 0.914]),
    Color([0.902, 0.624, 0.000]),
    Color([0.353, 0.353, 0.353]),
    Color([0.580, 0.404, 0.235]),
];

/// A panel: several lines over the same axes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Panel {
    /// What is measured.
    pub title: String,
    /// The lines.
    pub curves: Vec<Curve>,
}

/// A line of measurements.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Curve {
    /// What the legend calls it; lines of the same name in several panels have the same colour.
    pub name: String,
    /// Sizes and measurements, by size; what is not positive is left out.
    pub points: Vec<[f64; 2]>,
    /// For each point how far its measurement may be off, either way; empty: no band.
    pub half_widths: Vec<f64>,
}

/// Draws panels beside each other; `sizes` names what they have as abscissa.
///
/// ```
/// use delone_io::{Curve, Panel, Target, write_plot};
/// # let folder = tempfile::tempdir()?;
/// let curve = Curve {
///     name: "sort".to_owned(),
///     points: vec![[10.0, 33.0], [100.0, 664.0], [1000.0, 9966.0]],
///     ..Curve::default()
/// };
/// let panel = Panel { title: "comparisons".to_owned(), curves: vec![curve] };
/// let target = Target::from_arg(folder.path().join("plot.svg"), None);
/// assert_eq!(write_plot(&[target], &[panel], "n", &())?.len(), 1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// If a target is no `.svg` or `.png`, writing fails, or the watch cancels.
pub fn write_plot(
    targets: &[Target],
    panels: &[Panel],
    sizes: &str,
    watch: &dyn Watch,
) -> Result<Vec<PathBuf>, Error> {
    let plot = Plot::new(panels, sizes);
    let mut staging = Staging::new(targets.len() as u64, watch);
    for target in targets {
        let format = target.format()?;
        if !format.is_picture() {
            return Err(unsupported(
                target,
                format,
                "show a plot",
                Format::is_picture,
            ));
        }
        staging.write(target.path.as_deref(), |out| match format {
            Format::Svg => plot.write_svg(out),
            _ => plot.write_png(out),
        })?;
    }
    staging.commit()
}

/// Everything, drawn.
struct Plot {
    extent: [f32; 2],
    sheet: Sheet,
    words: String,
}

impl Plot {
    fn new(panels: &[Panel], sizes: &str) -> Self {
        let names = names(panels);
        let rows = names.len().div_ceil(panels.len().max(1) * 2);
        let [width, height] = PANEL;
        let extent = [
            width * panels.len().max(1) as f32,
            height + LEGEND * rows as f32 + 20.0,
        ];
        let mut sheet = Sheet::default();
        for (i, panel) in panels.iter().enumerate() {
            let axes = Axes::new(panel, [width * i as f32, 0.0]);
            axes.draw(&mut sheet, &panel.title, sizes);
            for curve in &panel.curves {
                axes.draw_curve(&mut sheet, curve, color(&names, &curve.name));
            }
        }
        draw_legend(&mut sheet, &names, extent);
        Self {
            extent,
            sheet,
            words: in_words(panels, sizes),
        }
    }

    fn write_svg(&self, out: &mut Output<'_>) -> Result<(), Error> {
        let [width, height] = self.extent;
        out.text(format_args!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\">\n\
             <desc>{}</desc>\n\
             <rect width=\"100%\" height=\"100%\" fill=\"{}\"/>\n",
            escape(&self.words),
            PAPER.hex()
        ))?;
        svg::write_sheet(out, &self.sheet, &INK.hex())?;
        out.text(format_args!("</svg>\n"))
    }

    fn write_png(&self, out: &mut Output<'_>) -> Result<(), Error> {
        let [width, height] = self.extent.map(|v| v.ceil() as u32);
        let mut page = Pixmap::new(width, height).ok_or_else(|| Error::Picture {
            file: out.file().to_owned(),
            reason: "there are too many panels".to_owned(),
        })?;
        page.fill(tiny_skia::Color::WHITE);
        png::draw_sheet(&mut page, &self.sheet);
        let bytes = png::pack(&page, out.file(), || Ok(()))?;
        out.many_bytes(&bytes)
    }
}

/// The names of all lines, each once.
fn names(panels: &[Panel]) -> Vec<&str> {
    let mut names: Vec<&str> = Vec::new();
    for curve in panels.iter().flat_map(|panel| &panel.curves) {
        if !names.contains(&curve.name.as_str()) {
            names.push(&curve.name);
        }
    }
    names
}

fn color(names: &[&str], name: &str) -> Color {
    let place = names.iter().position(|known| *known == name);
    COLORS[place.unwrap_or(0) % COLORS.len()]
}

/// The colour of a band beside that of its line.
fn paler(Color(channels): Color) -> Color {
    Color(channels.map(|c| 1.0 - 0.25 * (1.0 - c)))
}

/// Says what is shown, for those who cannot see it.
fn in_words(panels: &[Panel], sizes: &str) -> String {
    let panels = panels.iter().map(|panel| {
        let curves = panel.curves.iter().filter_map(|curve| {
            let [size, value] = curve.points.last()?;
            Some(format!("{}: {value} at {sizes} = {size}", curve.name))
        });
        format!(
            "{}. {}.",
            panel.title,
            curves.collect::<Vec<_>>().join("; ")
        )
    });
    panels.collect::<Vec<_>>().join(" ")
}

/// Puts names and colours below the panels, in two columns a panel.
fn draw_legend(sheet: &mut Sheet, names: &[&str], [width, height]: [f32; 2]) {
    let columns = (width / PANEL[0]) as usize * 2;
    for (i, name) in names.iter().enumerate() {
        let (row, column) = (i / columns, i % columns);
        let x = 30.0 + column as f32 * PANEL[0] / 2.0;
        let y = PANEL[1] + 8.0 + LEGEND * row as f32;
        debug_assert!(y < height);
        sheet.line([[x, y], [x + 30.0, y]], 3.2, color(names, name), 1.0);
        let at = [x + 40.0, y + 3.5 * TEXT];
        sheet.text(name, at, TEXT, Anchor::Start, INK);
    }
}

/// The axes of a panel: logarithms to base 10 of both ends, and where these lie.
struct Axes {
    corner: [f32; 2],
    x: [f64; 2],
    y: [f64; 2],
}

impl Axes {
    /// Makes room for all points.
    fn new(panel: &Panel, corner: [f32; 2]) -> Self {
        let points = || panel.curves.iter().flat_map(drawn);
        let ends = |k: usize| {
            let logs = points().map(|(p, _)| p[k].log10());
            let (low, high) = logs.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| {
                (low.min(v), high.max(v))
            });
            match low <= high {
                true if high - low < 0.3 => [low - 0.15, high + 0.15],
                true => [low, high],
                false => [0.0, 1.0],
            }
        };
        let [low, high] = ends(1);
        let room = 0.04 * (high - low);
        Self {
            corner,
            x: ends(0),
            y: [low - room, high + room],
        }
    }

    fn place(&self, [x, y]: [f64; 2]) -> [f32; 2] {
        let share = |v: f64, [low, high]: [f64; 2]| {
            ((v.log10() - low) / (high - low)).clamp(0.0, 1.0) as f32
        };
        let [left, top, right, bottom] = self.frame();
        [
            left + (right - left) * share(x, self.x),
            bottom - (bottom - top) * share(y, self.y),
        ]
    }

    /// Left, top, right and bottom of the lines.
    fn frame(&self) -> [f32; 4] {
        let [x, y] = self.corner;
        let [left, top, right, bottom] = MARGINS;
        [
            x + left,
            y + top,
            x + PANEL[0] - right,
            y + PANEL[1] - bottom,
        ]
    }

    fn draw(&self, sheet: &mut Sheet, title: &str, sizes: &str) {
        let [left, top, right, bottom] = self.frame();
        sheet.text(title, [left, top - 24.0], TITLE, Anchor::Start, INK);
        for (at, name) in ticks(self.y) {
            let [_, y] = self.place([1.0, at]);
            sheet.line([[left, y], [right, y]], 1.1, INK, 0.16);
            let end = [left - 8.0, y + 3.5 * TEXT];
            sheet.text(&name, end, TEXT, Anchor::End, INK);
        }
        sheet.line([[left, bottom], [right, bottom]], 1.5, INK, 1.0);
        for (at, name) in ticks(self.x) {
            let [x, _] = self.place([at, 1.0]);
            sheet.line([[x, bottom], [x, bottom + 6.0]], 1.5, INK, 1.0);
            sheet.text(&name, [x, bottom + 24.0], TEXT, Anchor::Middle, INK);
        }
        let below = [(left + right) / 2.0, bottom + 46.0];
        sheet.text(sizes, below, TEXT, Anchor::Middle, INK);
    }

    fn draw_curve(&self, sheet: &mut Sheet, curve: &Curve, color: Color) {
        let drawn: Vec<_> = drawn(curve).collect();
        for pair in drawn.windows(2) {
            if curve.half_widths.is_empty() {
                continue;
            }
            // What reaches down to zero reaches below any axis.
            let least = 10f64.powf(self.y[0]);
            let edge = |(p, half): ([f64; 2], f64), sign: f64| {
                self.place([p[0], (p[1] + sign * half).max(least)])
            };
            let corners = vec![
                edge(pair[0], -1.0),
                edge(pair[1], -1.0),
                edge(pair[1], 1.0),
                edge(pair[0], 1.0),
            ];
            sheet.area(corners, paler(color));
        }
        for pair in drawn.windows(2) {
            sheet.line(
                [pair[0], pair[1]].map(|(p, _)| self.place(p)),
                2.6,
                color,
                1.0,
            );
        }
        for (p, _) in drawn {
            let [x, y] = self.place(p);
            sheet.disc([x, y], 3.6, color);
        }
    }
}

/// The points that logarithms have a place for, with their half widths.
fn drawn(curve: &Curve) -> impl Iterator<Item = ([f64; 2], f64)> + '_ {
    let halves = curve
        .half_widths
        .iter()
        .copied()
        .chain(std::iter::repeat(0.0));
    let fits = |p: &[f64; 2]| p.iter().all(|v| v.is_finite() && *v > 0.0);
    curve
        .points
        .iter()
        .copied()
        .zip(halves)
        .filter(move |(p, _)| fits(p))
}

/// Powers of ten between two logarithms, not more than seven; if there are fewer than two, also 2 and 5
/// times one.
fn ticks([low, high]: [f64; 2]) -> Vec<(f64, String)> {
    let decades = low.floor() as i32..=high.floor() as i32;
    let all = |digits: &'static [u32]| {
        let numbers = decades.clone().flat_map(move |decade| {
            let number = move |digit: &u32| format!("{digit}e{decade}").parse().unwrap_or(1.0);
            digits.iter().map(number)
        });
        let is_between = |v: &f64| (low..=high).contains(&v.log10());
        numbers.filter(is_between).collect::<Vec<f64>>()
    };
    let scales: [(&[u32], usize); 3] = [(&[1], 3), (&[1, 3], 4), (&[1, 2, 5], 3)];
    let fitting = scales.into_iter().find_map(|(digits, least)| {
        let chosen = all(digits);
        (chosen.len() >= least).then_some(chosen)
    });
    let chosen = fitting.unwrap_or_else(|| all(&[1, 2, 3, 4, 5, 6, 7, 8, 9]));
    let every = chosen.len().div_ceil(7).max(1);
    let chosen = chosen.into_iter().step_by(every);
    chosen.map(|v| (v, shortly(v))).collect()
}

/// Writes a round number: `0.05`, `20`, `3k`, `1M`.
fn shortly(v: f64) -> String {
    match v {
        _ if !(1e-4..1e12).contains(&v) => format!("{v:e}"),
        _ if v >= 1e9 => format!("{}G", v / 1e9),
        _ if v >= 1e6 => format!("{}M", v / 1e6),
        _ if v >= 1e3 => format!("{}k", v / 1e3),
        _ => format!("{v}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_few_and_round() {
        let names = |ends| {
            ticks(ends)
                .into_iter()
                .map(|(_, name)| name)
                .collect::<Vec<_>>()
        };
        assert_eq!(names([2.0, 6.0]), ["100", "1k", "10k", "100k", "1M"]);
        assert_eq!(names([0.0, 1.0]), ["1", "2", "5", "10"]);
        assert!(names([-300.0, 300.0]).len() <= 7);
        assert_eq!(names([0.3, 2.7]), ["3", "10", "30", "100", "300"]);
        assert_eq!(names([2.1, 2.5]), ["200", "300"]);
    }

    #[test]
    fn every_point_lies_within_its_panel() {
        let curve = |points: &[[f64; 2]]| Curve {
            name: "c".to_owned(),
            points: points.to_vec(),
            half_widths: vec![1e9; points.len()],
        };
        for points in [
            &[[1.0, 1.0]][..],
            &[[1.0, 1.0], [1e6, 1e-9]],
            &[[0.0, -1.0], [f64::NAN, 2.0]],
            &[],
        ] {
            let panel = Panel {
                title: "t".to_owned(),
                curves: vec![curve(points)],
            };
            let plot = Plot::new(&[panel.clone(), panel], "n");
            let [width, height] = plot.extent;
            for shape in &plot.sheet.shapes {
                if let crate::picture::sheet::Shape::Area { corners, .. } = shape {
                    let inside = |p: &[f32; 2]| {
                        (0.0..=width).contains(&p[0]) && (0.0..=height).contains(&p[1])
                    };
                    assert!(corners.iter().all(inside), "{points:?}: {corners:?}");
                }
            }
        }
    }
}
