//! Pictures of surfaces: cells in colours, shaded by their slopes, contour lines, and a legend.
//!
//! The shading is that of a surface lit from the upper left, 45 degrees high, made so steep that its mean
//! slope is about one third whatever the units; flat cells keep their colour.

use super::glyphs::{self, Stroke};
use super::sheet::{Anchor, Shape, Sheet};
use super::{Color, INK, PAPER, Page, View, even_scale, require_size};
use crate::target::Output;
use crate::{Error, Relief, ReliefOptions, cancel, png, svg};
use base64::prelude::{BASE64_STANDARD, Engine};
use delone::surface::{Contour, Raster, round_levels};
use delone::{Phase, Point, Watch};
use tiny_skia::{Pixmap, PremultipliedColorU8};

/// Root of the mean squared slope that is shown.
const SHOWN_SLOPE: f64 = 0.35;

/// Every so many levels a line is thicker.
const INDEX: f64 = 5.0;

/// Size of letters, of the legend and on lines: digits are seven times as high.
const TEXT: f32 = 2.1;
const LABEL: f32 = 1.5;

/// Writes a picture of pixels.
pub(crate) fn write_png(
    out: &mut Output<'_>,
    relief: Relief<'_>,
    options: &ReliefOptions,
    watch: &dyn Watch,
) -> Result<(), Error> {
    let file = out.file().to_owned();
    let scene = Scene::new(&file, relief, options, watch)?;
    let mut page = scene.paint()?;
    png::draw_sheet(&mut page, &scene.sheet());
    out.many_bytes(&scene.pack(&page)?)
}

/// Writes lines and letters over an embedded picture of the cells.
pub(crate) fn write_svg(
    out: &mut Output<'_>,
    relief: Relief<'_>,
    options: &ReliefOptions,
    watch: &dyn Watch,
) -> Result<(), Error> {
    let file = out.file().to_owned();
    let scene = Scene::new(&file, relief, options, watch)?;
    let [width, height] = scene.view.page;
    out.text(format_args!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\">\n\
         <title>{} contour lines</title>\n\
         <rect width=\"100%\" height=\"100%\" fill=\"{}\"/>\n",
        relief.contours.len(),
        PAPER.hex()
    ))?;
    if relief.raster.is_some() {
        let image = BASE64_STANDARD.encode(scene.pack(&scene.paint()?)?);
        out.text(format_args!(
            "<image width=\"{width}\" height=\"{height}\" href=\"data:image/png;base64,"
        ))?;
        out.many_bytes(image.as_bytes())?;
        out.text(format_args!("\"/>\n"))?;
    }
    svg::write_sheet(out, &scene.sheet(), &INK.hex())?;
    out.text(format_args!("</svg>\n"))
}

/// Where everything lies on the page.
struct Scene<'a> {
    file: &'a str,
    relief: Relief<'a>,
    options: &'a ReliefOptions,
    watch: &'a dyn Watch,
    view: View,
    unit: f32,
    /// The values that the scale of colours covers, if there is one.
    range: Option<[f64; 2]>,
}

impl<'a> Scene<'a> {
    fn new(
        file: &'a str,
        relief: Relief<'a>,
        options: &'a ReliefOptions,
        watch: &'a dyn Watch,
    ) -> Result<Self, Error> {
        require_size(file, &options.picture)?;
        let range = relief.raster.and_then(Raster::range);
        let legend = options.picture.legend && range.is_some();
        let page = Page::new(options.picture.size as f32, legend);
        let corners = relief.raster.map_or(Vec::new(), |r| corners(r).to_vec());
        let lines = relief.contours.iter().flat_map(|line| &line.points);
        let points: Vec<Point> = corners.into_iter().chain(lines.copied()).collect();
        Ok(Self {
            file,
            relief,
            options,
            watch,
            view: View::new(&points, &page),
            unit: page.unit,
            range,
        })
    }

    fn pack(&self, page: &Pixmap) -> Result<Vec<u8>, Error> {
        png::pack(page, self.file, || cancel::check(self.watch, 0))
    }

    /// Paints the cells on paper: every pixel has the colour of the cell that its centre lies in.
    fn paint(&self) -> Result<Pixmap, Error> {
        let [width, height] = self.view.page.map(|v| v as u32);
        let mut page = Pixmap::new(width, height).expect("bug: the page has a size");
        page.fill(tiny_skia::Color::WHITE);
        let (Some(raster), Some(range)) = (self.relief.raster, self.range) else {
            return Ok(page);
        };
        let light = self.options.shade.then(|| Light::on(raster));
        let [low, high] = corners(raster).map(|p| self.view.place(p));
        let grid = raster.grid();
        let cell = |pixel: usize, from: f32, to: f32, count: usize| {
            let share = (pixel as f32 + 0.5 - from) / (to - from);
            let index = (share * count as f32).floor();
            (0.0..count as f32)
                .contains(&index)
                .then_some(index as usize)
        };
        for (y, pixels) in page.pixels_mut().chunks_mut(width as usize).enumerate() {
            cancel::check(self.watch, 0)?;
            self.watch.progress(Phase::Draw, y as u64, height.into());
            let Some(row) = cell(y, high[1], low[1], grid.rows()) else {
                continue;
            };
            for (x, pixel) in pixels.iter_mut().enumerate() {
                let column = cell(x, low[0], high[0], grid.columns());
                let value = column.and_then(|column| raster.value(column, row));
                if let (Some(column), Some(value)) = (column, value) {
                    let color = even_scale(share(value, range));
                    let shade = light.as_ref().map_or(1.0, |l| l.shade(raster, column, row));
                    let [r, g, b] = shaded(color, shade).bytes();
                    *pixel =
                        PremultipliedColorU8::from_rgba(r, g, b, u8::MAX).expect("bug: opaque");
                }
            }
        }
        Ok(page)
    }

    /// Lays out lines and legend.
    fn sheet(&self) -> Sheet {
        let mut sheet = Sheet::default();
        let step = step(self.relief.contours);
        for line in self.relief.contours {
            self.add_line(&mut sheet, line, is_index(line.value, step));
        }
        if self.options.labels {
            for line in self.relief.contours {
                self.add_label(&mut sheet, line, is_index(line.value, step));
            }
        }
        if let (Some(range), true) = (self.range, self.options.picture.legend) {
            self.add_legend(&mut sheet, range);
        }
        sheet
    }

    fn add_line(&self, sheet: &mut Sheet, line: &Contour, is_index: bool) {
        let back = line.points.first().filter(|_| line.is_closed);
        let places = line.points.iter().chain(back).map(|&p| self.view.place(p));
        let stroke = |(i, place)| match i {
            0 => Stroke::Move(place),
            _ => Stroke::Line(place),
        };
        let (width, opacity) = if is_index { (2.4, 0.95) } else { (1.1, 0.75) };
        sheet.shapes.push(Shape::Lines {
            path: places.enumerate().map(stroke).collect(),
            width: width * self.unit,
            color: INK,
            opacity,
        });
    }

    /// Writes the level in the middle of a thick line, if there is room.
    fn add_label(&self, sheet: &mut Sheet, line: &Contour, is_index: bool) {
        let text = short(line.value);
        let size = LABEL * self.unit;
        let width = glyphs::width(&text, size);
        let length: f32 = line
            .points
            .windows(2)
            .map(|w| self.distance(w[0], w[1]))
            .sum();
        if !is_index || length < 6.0 * width {
            return;
        }
        let mut left = length / 2.0;
        for w in line.points.windows(2) {
            left -= self.distance(w[0], w[1]);
            if left <= 0.0 {
                let [x, y] = self.view.place(w[1]);
                let (across, down) = (width + 4.0 * size, 11.0 * size);
                sheet.bar([x - across / 2.0, y - down / 2.0], [across, down], PAPER);
                let base = [x, y + 3.5 * size];
                sheet.text(&text, base, size, Anchor::Middle, INK);
                return;
            }
        }
    }

    /// Returns how far apart two points are on the page.
    fn distance(&self, a: Point, b: Point) -> f32 {
        let [a, b] = [a, b].map(|p| self.view.place(p));
        (b[0] - a[0]).hypot(b[1] - a[1])
    }

    /// Adds the scale of colours with some round values.
    fn add_legend(&self, sheet: &mut Sheet, range: [f64; 2]) {
        const STEPS: usize = 128;
        let unit = self.unit;
        let [corner, extent] = self.view.drawing;
        let height = extent[1].min(560.0 * unit);
        let (left, top) = (
            corner[0] + extent[0] + 40.0 * unit,
            corner[1] + (extent[1] - height) / 2.0,
        );
        let at = |share: f32| top + height * (1.0 - share);
        for i in (0..STEPS).rev() {
            let y = at((i + 1) as f32 / STEPS as f32);
            let color = even_scale((i as f32 + 0.5) / STEPS as f32);
            // Down to the foot, so that the next colour covers it and no seam can show.
            sheet.bar([left, y], [20.0 * unit, at(0.0) - y], color);
        }
        for value in round_levels(8, range).unwrap_or_default() {
            let y = at(share(value, range));
            let tick = [[left + 22.0 * unit, y], [left + 28.0 * unit, y]];
            sheet.line(tick, 1.6 * unit, INK, 1.0);
            let start = [left + 32.0 * unit, y + 3.5 * TEXT * unit];
            sheet.text(&short(value), start, TEXT * unit, Anchor::Start, INK);
        }
    }
}

/// Returns the lower left and the upper right corner of a raster.
fn corners(raster: &Raster) -> [Point; 2] {
    let grid = raster.grid();
    let (low, [dx, dy]) = (grid.low(), grid.cell());
    let extent = [grid.columns() as f64 * dx, grid.rows() as f64 * dy];
    [low, Point::new(low.x + extent[0], low.y + extent[1])]
}

/// Returns where in its range a value lies, from 0 to 1.
fn share(value: f64, [low, high]: [f64; 2]) -> f32 {
    let share = (value / 2.0 - low / 2.0) / (high / 2.0 - low / 2.0);
    if share.is_nan() { 0.5 } else { share as f32 }
}

/// Returns the least distance between two levels; zero if there is but one.
fn step(contours: &[Contour]) -> f64 {
    let mut values: Vec<f64> = contours.iter().map(|line| line.value).collect();
    values.sort_unstable_by(f64::total_cmp);
    values.dedup();
    let steps = values.windows(2).map(|w| w[1] - w[0]);
    steps.reduce(f64::min).unwrap_or(0.0)
}

/// Tells whether a level is among the thick ones.
fn is_index(value: f64, step: f64) -> bool {
    step > 0.0 && (value / step).round() % INDEX == 0.0
}

/// Writes a number in few characters.
fn short(value: f64) -> String {
    let rounded: f64 = format!("{value:.6e}").parse().unwrap_or(value);
    let text = rounded.to_string();
    match text.len() {
        0..=8 => text,
        _ => format!("{value:.2e}"),
    }
}

/// The light and how steep the surface is shown.
struct Light {
    /// By how much differences per cell are multiplied.
    steepness: [f64; 2],
}

impl Light {
    /// From where it comes: as far to the left as up, and 45 degrees high.
    const FROM: [f64; 3] = [-0.5, 0.5, std::f64::consts::FRAC_1_SQRT_2];

    fn on(raster: &Raster) -> Self {
        let [dx, dy] = raster.grid().cell();
        // Relative to one of the sides, so that the units do not matter.
        let plain = Self {
            steepness: [1.0, dx / dy],
        };
        let grid = raster.grid();
        let cells = (0..grid.rows()).flat_map(|row| (0..grid.columns()).map(move |c| (c, row)));
        let (mut sum, mut count) = (0.0, 0.0_f64);
        for (column, row) in cells {
            if let Some([p, q]) = plain.slope(raster, column, row) {
                sum += p * p + q * q;
                count += 1.0;
            }
        }
        let factor = SHOWN_SLOPE / (sum / count).sqrt();
        let factor = if factor.is_finite() { factor } else { 0.0 };
        Self {
            steepness: plain.steepness.map(|s| s * factor),
        }
    }

    /// Returns the slope of a cell to the right and upwards, from those of its neighbours that have values.
    fn slope(&self, raster: &Raster, column: usize, row: usize) -> Option<[f64; 2]> {
        let grid = raster.grid();
        let here = raster.value(column, row)?;
        let along = |back: Option<(usize, usize)>, ahead: Option<(usize, usize)>| {
            let value = |cell: Option<(usize, usize)>| cell.and_then(|(c, r)| raster.value(c, r));
            match (value(back), value(ahead)) {
                (Some(a), Some(b)) => b / 2.0 - a / 2.0,
                (Some(a), None) => here - a,
                (None, Some(b)) => b - here,
                (None, None) => 0.0,
            }
        };
        let right = (column + 1 < grid.columns()).then_some((column + 1, row));
        let left = column.checked_sub(1).map(|c| (c, row));
        let down = (row + 1 < grid.rows()).then_some((column, row + 1));
        let up = row.checked_sub(1).map(|r| (column, r));
        let slope = [along(left, right), along(down, up)];
        Some([0, 1].map(|k| slope[k] * self.steepness[k]))
    }

    /// Returns how much light a cell gets, a flat one 1.
    fn shade(&self, raster: &Raster, column: usize, row: usize) -> f32 {
        let Some([p, q]) = self.slope(raster, column, row) else {
            return 1.0;
        };
        let [x, y, z] = Self::FROM;
        let lit = (z - p * x - q * y) / (1.0 + p * p + q * q).sqrt();
        (lit / z).clamp(0.25, 1.6) as f32
    }
}

/// Returns a colour with more or less light on it.
fn shaded(color: Color, light: f32) -> Color {
    Color::from_light(color.to_light().map(|channel| channel * light))
}
