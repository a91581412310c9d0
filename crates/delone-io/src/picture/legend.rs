//! The legend: the scale of colours with degrees, and beside it how many triangles have which
//! angle; below it what the segments, crossings and regions of a domain look like.

use super::domain::REGION_COLORS;
use super::sheet::{Anchor, Sheet};
use super::{Color, INK, Scene, scale};

/// Bars of the histogram: two degrees each.
const BARS: usize = 30;

/// Most regions that are listed.
const MAX_REGIONS: usize = 8;

/// Height of an entry below the scale, in pixels of the usual size.
pub(super) const ENTRY: f32 = 32.0;

/// Least height of the scale.
const LEAST_SCALE: f32 = 180.0;

/// Lays the legend out beside the drawing.
pub(super) fn legend(scene: &Scene<'_>) -> Sheet {
    let unit = scene.unit;
    let entries = entries(scene);
    let [corner, extent] = scene.view.drawing;
    let below = match entries.len() {
        0 => 0.0,
        n => (n as f32 + 1.0) * ENTRY * unit,
    };
    let least = LEAST_SCALE * unit;
    let height = (extent[1] - below)
        .max(least.min(extent[1]))
        .min(560.0 * unit);
    let top = corner[1] + ((extent[1] - height - below) / 2.0).max(0.0);
    let mut sheet = Sheet::default();
    let right = corner[0] + extent[0];
    add_scale(&mut sheet, scene, [right + 88.0 * unit, top], height);
    for (i, entry) in entries.iter().enumerate() {
        let y = top + height + (i as f32 + 1.5) * ENTRY * unit;
        add_entry(&mut sheet, unit, entry, [right + 30.0 * unit, y]);
    }
    sheet
}

/// Adds the scale of angles and the histogram.
fn add_scale(sheet: &mut Sheet, scene: &Scene<'_>, [left, top]: [f32; 2], height: f32) {
    let unit = scene.unit;
    let at = |share: f32| top + height * (1.0 - share);
    let step = height / BARS as f32;
    for (i, share) in scene.histogram::<BARS>().into_iter().enumerate().rev() {
        let color = scale((i as f32 + 0.5) / BARS as f32);
        let y = at((i + 1) as f32 / BARS as f32);
        // Down to the foot, so that the next colour covers it and no seam can show.
        sheet.bar([left, y], [16.0 * unit, at(0.0) - y], color);
        let histogram = [left + 22.0 * unit, y];
        sheet.bar(histogram, [64.0 * unit * share, step * 0.84], color);
    }
    for degrees in (0..=60).step_by(10) {
        let y = at(degrees as f32 / 60.0);
        let tick = [[left - 8.0 * unit, y], [left - 2.0 * unit, y]];
        sheet.line(tick, 1.6 * unit, INK, 1.0);
        let text = format!("{degrees}°");
        let end = [left - 12.0 * unit, y + 3.5 * TEXT * unit];
        sheet.text(&text, end, TEXT * unit, Anchor::End, INK);
    }
    let title = title_baselines(top, unit);
    for (text, y) in ["smallest", "angle"].into_iter().zip(title) {
        sheet.text(text, [left, y], TEXT * unit, Anchor::Start, INK);
    }
}

/// Adds a sample and what it means; `y` is the middle of the line.
pub(super) fn add_entry(sheet: &mut Sheet, unit: f32, entry: &Entry, [x, y]: [f32; 2]) {
    let width = 30.0 * unit;
    let mut bar = |height: f32, color| sheet.bar([x, y - height / 2.0], [width, height], color);
    match entry.sample {
        Sample::Line(height) => bar(height, INK),
        Sample::Area(color) => bar(16.0 * unit, color),
        Sample::Ring(radius) => sheet.ring([x + width / 2.0, y], radius),
        Sample::Dot(radius) => sheet.disc([x + width / 2.0, y], radius, INK),
        Sample::Blank | Sample::Nothing => {}
    }
    let indent = match entry.sample {
        Sample::Nothing => 0.0,
        _ => 42.0 * unit,
    };
    let start = [x + indent, y + 3.0 * TEXT * unit];
    sheet.text(&entry.text, start, TEXT * unit, Anchor::Start, INK);
}

/// Size of letters: digits are seven times as high.
pub(crate) const TEXT: f32 = 2.1;

/// A line of the legend below the scale.
pub(super) struct Entry {
    pub sample: Sample,
    pub text: String,
}

/// What stands before the text of an entry.
pub(super) enum Sample {
    /// A line of this width.
    Line(f32),
    /// A ring of this radius.
    Ring(f32),
    /// A dot of this radius.
    Dot(f32),
    Area(Color),
    /// Room, but nothing in it.
    Blank,
    Nothing,
}

/// Lists what else there is in the picture.
fn entries(scene: &Scene<'_>) -> Vec<Entry> {
    let entry = |sample, text: &str| Entry {
        sample,
        text: text.to_owned(),
    };
    let mut entries = Vec::new();
    if scene.num_segments() > 0 {
        entries.push(entry(Sample::Line(3.6 * scene.unit), "segment"));
    }
    if let Some((_, radius)) = scene.crossings() {
        entries.push(entry(Sample::Ring(radius), "crossing"));
    }
    let regions = scene.regions();
    if !regions.is_empty() {
        entries.push(entry(Sample::Nothing, "region"));
    }
    let colors = REGION_COLORS.into_iter().cycle();
    for (&attribute, color) in regions.iter().zip(colors).take(MAX_REGIONS) {
        entries.push(entry(Sample::Area(color), &short(attribute)));
    }
    if regions.len() > MAX_REGIONS {
        entries.push(entry(Sample::Nothing, "..."));
    }
    entries
}

/// Writes a number in few characters.
fn short(number: f64) -> String {
    let text = number.to_string();
    if text.len() <= 8 {
        return text;
    }
    format!("{number:.2e}")
}

/// Returns the baselines of the title's two lines above a scale that begins at `top`: on the page
/// even if the drawing is flat, and never upon each other.
pub(super) fn title_baselines(top: f32, unit: f32) -> [f32; 2] {
    let first = (top - 52.0 * unit).max(20.0 * unit);
    [first, first + 22.0 * unit]
}

#[cfg(test)]
mod tests {
    use super::super::view::{Page, View};
    use super::title_baselines;
    use delone::Point;

    #[test]
    fn lines_of_the_title_keep_apart_in_flat_pictures() {
        let page = Page::new(800.0, true);
        let points = [(0.0, 0.0), (100.0, 0.0), (50.0, 10.0)].map(Point::from);
        let top = View::new(&points, &page).drawing[0][1];
        let [first, second] = title_baselines(top, page.unit);
        assert!(first >= 20.0 * page.unit, "on the page");
        assert!(second - first >= 22.0 * page.unit, "apart");
        assert!(second < top, "above the scale");
    }
}
