//! What a picture shows of data and the triangles that hold them: light where there are few, dark where there are
//! many, red with a heavy outline where there are too many; and the data as dots.
//!
//! In the legend a bar for each number, or for a few, is as long as there are triangles that hold so many.

use super::domain::REGION_COLORS;
use super::legend::{self, ENTRY, Entry, Sample, TEXT, add_entry};
use super::sheet::{Anchor, Sheet};
use super::{CLASSES, Color, EdgeClass, INK, Scene, even_scale};
use crate::words::counted;
use crate::{Counts, Error};

/// The class of colour of triangles that hold too many.
pub(super) const TOO_MANY: usize = CLASSES;

/// The ends of the scale on the even one: not so dark that dots cannot be seen.
const ENDS: [f32; 2] = [0.98, 0.36];

/// Most bars of the histogram.
const MOST_BARS: usize = 30;

/// Most height of a bar, in pixels of the usual size.
const BAR: f32 = 40.0;

/// Width of the outline of triangles that hold too many, in pixels of the usual size.
const OUTLINE: f32 = 4.0;

/// Returns the class of colour of a triangle that holds so many.
pub(super) fn class(held: usize, [least, most]: [usize; 2]) -> u8 {
    if held > most {
        return TOO_MANY as u8;
    }
    let place = held.saturating_sub(least) as f64 / (most - least).max(1) as f64;
    (place * (CLASSES - 1) as f64).round() as u8
}

/// Returns the colour of a class.
pub(super) fn color(class: usize) -> Color {
    if class == TOO_MANY {
        return REGION_COLORS[0];
    }
    let [few, many] = ENDS;
    even_scale(few + (many - few) * class as f32 / (CLASSES - 1) as f32)
}

/// How the numbers are put into bars.
struct Bars {
    range: [usize; 2],
    number: usize,
}

impl Bars {
    fn new(range: [usize; 2]) -> Self {
        let number = (range[1] - range[0]).min(MOST_BARS - 1) + 1;
        Self { range, number }
    }

    /// Returns which bar counts a triangle that holds so many; `None`: it holds too many.
    fn of(&self, held: usize) -> Option<usize> {
        let [least, most] = self.range;
        let above = held.saturating_sub(least) as u128;
        let bar = above * self.number as u128 / ((most - least) as u128 + 1);
        (held <= most).then_some(bar as usize)
    }

    /// Counts the triangles of each bar, and those that hold too many.
    fn count(&self, counts: &Counts<'_>) -> (Vec<usize>, usize) {
        let (mut bars, mut too_many) = (vec![0; self.number], 0);
        for &held in counts.held {
            match self.of(held) {
                Some(bar) => bars[bar] += 1,
                None => too_many += 1,
            }
        }
        (bars, too_many)
    }

    /// Lists the numbers that are written beside the scale: both ends, and round ones between them.
    fn ticks(&self) -> Vec<usize> {
        let [least, most] = self.range;
        let powers = (0..20).map(|k| 10usize.saturating_pow(k));
        let mut steps = powers.flat_map(|power| [1, 2, 5].map(|m: usize| m.saturating_mul(power)));
        let step = steps.find(|&step| (most - least) / step <= 7);
        let step = step.unwrap_or(usize::MAX);
        let first = (least / step * step).saturating_add(step);
        let next = |tick: &usize| tick.checked_add(step);
        let round = std::iter::successors(Some(first), next).take_while(|&tick| tick < most);
        let half = step.div_ceil(2);
        let is_apart = |&tick: &usize| tick - least >= half && most - tick >= half;
        let mut ticks = vec![least];
        ticks.extend(round.filter(is_apart));
        ticks.push(most);
        ticks.dedup();
        ticks
    }
}

impl Scene<'_> {
    /// Returns the outlines of triangles that hold too many data.
    pub fn outlined(&self) -> Result<Option<EdgeClass>, Error> {
        if self.mesh.counts.is_none() {
            return Ok(None);
        }
        let mut edges = Vec::new();
        for (t, &[a, b, c]) in self.mesh.triangles.iter().enumerate() {
            self.check_now_and_then(t)?;
            if usize::from(self.classes[t]) == TOO_MANY {
                edges.extend([[a, b], [b, c], [c, a]].map(|ends| ends.map(|v| self.place(v))));
            }
        }
        // Thinner, if there are many.
        let width = OUTLINE / (1.0 + edges.len() as f32 / 600.0);
        Ok(Some(EdgeClass {
            width: width.max(0.4) * self.unit,
            opacity: 1.0,
            edges,
        }))
    }
}

/// Lays the legend out beside the drawing.
pub(super) fn legend(scene: &Scene<'_>, counts: &Counts<'_>) -> Sheet {
    let unit = scene.unit;
    let [corner, extent] = scene.view.drawing;
    let bars = Bars::new(counts.range);
    let (numbers, too_many) = bars.count(counts);
    let below = 3.0 * ENTRY * unit;
    let above = if too_many > 0 {
        1.8 * ENTRY * unit
    } else {
        0.0
    };
    let most = (BAR * bars.number as f32).min(560.0) * unit;
    let height = (extent[1] - below - above).max(90.0 * unit).min(most);
    let top = corner[1] + above + ((extent[1] - height - below - above) / 2.0).max(0.0);
    let left = corner[0] + extent[0] + 88.0 * unit;
    let chart = Chart {
        bars,
        unit,
        left,
        top,
        height,
        longest: numbers
            .iter()
            .copied()
            .max()
            .unwrap_or(0)
            .max(too_many)
            .max(1),
    };
    let mut sheet = Sheet::default();
    chart.draw(&mut sheet, &numbers);
    if too_many > 0 {
        chart.draw_too_many(&mut sheet, too_many);
    }
    let title = legend::title_baselines(top - above, unit);
    for (text, y) in ["data in a", "triangle"].into_iter().zip(title) {
        let start = [left - 40.0 * unit, y];
        sheet.text(text, start, TEXT * unit, Anchor::Start, INK);
    }
    let data = Entry {
        sample: match scene.dots() {
            Some((_, radius)) => Sample::Dot(radius),
            None => Sample::Blank,
        },
        text: counted(counts.data.len(), "datum", "data"),
    };
    let triangles = Entry {
        sample: Sample::Blank,
        text: counted(counts.held.len(), "triangle", "triangles"),
    };
    for (i, entry) in [data, triangles].iter().enumerate() {
        let y = top + height + (i as f32 + 1.5) * ENTRY * unit;
        let x = corner[0] + extent[0] + 20.0 * unit;
        add_entry(&mut sheet, unit, entry, [x, y]);
    }
    sheet
}

/// The scale with its bars.
struct Chart {
    bars: Bars,
    unit: f32,
    left: f32,
    top: f32,
    height: f32,
    /// Triangles of the longest bar.
    longest: usize,
}

impl Chart {
    fn draw(&self, sheet: &mut Sheet, numbers: &[usize]) {
        let bars = self.bars.number;
        let step = self.height / bars as f32;
        for (i, &triangles) in numbers.iter().enumerate() {
            let color = color(self.middle_class(i));
            let y = self.top + step * (bars - 1 - i) as f32;
            self.bar(sheet, y, step, triangles, color);
        }
        for held in self.bars.ticks() {
            let bar = self.bars.of(held).unwrap_or(0);
            let y = self.top + step * (bars as f32 - 0.5 - bar as f32);
            self.tick(sheet, y, &held.to_string());
        }
    }

    fn draw_too_many(&self, sheet: &mut Sheet, triangles: usize) {
        let height = (0.8 * ENTRY * self.unit).min(24.0 * self.unit);
        let y = self.top - 1.3 * height;
        self.bar(sheet, y, height, triangles, color(TOO_MANY));
        let [_, most] = self.bars.range;
        self.tick(sheet, y + height / 2.0, &format!(">{most}"));
    }

    /// A piece of the scale, and the bar beside it.
    fn bar(&self, sheet: &mut Sheet, y: f32, height: f32, triangles: usize, color: Color) {
        let unit = self.unit;
        // Some colours are nearly paper: so the bars have an edge.
        sheet.bar([self.left, y], [16.0 * unit, height], color);
        let length = 64.0 * unit * triangles as f32 / self.longest as f32;
        sheet.bar([self.left + 22.0 * unit, y], [length, 0.84 * height], color);
        if triangles > 0 {
            let edge = [self.left + 22.0 * unit + length, y];
            sheet.bar(edge, [1.2 * unit, 0.84 * height], INK);
        }
    }

    fn tick(&self, sheet: &mut Sheet, y: f32, text: &str) {
        let (unit, left) = (self.unit, self.left);
        let tick = [[left - 8.0 * unit, y], [left - 2.0 * unit, y]];
        sheet.line(tick, 1.6 * unit, INK, 1.0);
        let end = [left - 12.0 * unit, y + 3.5 * TEXT * unit];
        sheet.text(text, end, TEXT * unit, Anchor::End, INK);
    }

    /// Returns the class of colour in the middle of a bar.
    fn middle_class(&self, bar: usize) -> usize {
        let last = (self.bars.number - 1).max(1);
        (bar * (CLASSES - 1) + last / 2) / last
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_scale_has_its_ends_at_the_bounds() {
        for (least, most) in [(1, 2), (6, 17), (10, 29), (1000, 2999), (4, 4)] {
            let class = |held| class(held, [least, most]);
            assert_eq!(class(least), 0);
            assert_eq!(
                usize::from(class(most)),
                if least < most { CLASSES - 1 } else { 0 }
            );
            assert_eq!(usize::from(class(most + 1)), TOO_MANY);
            assert_eq!(class(0), 0);
        }
        let all: Vec<_> = (6..=18).map(|held| class(held, [6, 17])).collect();
        assert!(all.windows(2).all(|pair| pair[0] < pair[1]), "{all:?}");
    }

    #[test]
    fn every_number_has_a_bar_and_few_have_words() {
        for (least, most) in [(1, 2), (6, 17), (10, 29), (21, 62), (1000, 2999), (4, 4)] {
            let bars = Bars::new([least, most]);
            assert!(bars.number <= MOST_BARS);
            assert_eq!(
                [bars.of(least), bars.of(most)],
                [Some(0), Some(bars.number - 1)]
            );
            assert_eq!(bars.of(most + 1), None);
            let ticks = bars.ticks();
            assert!(ticks.len() <= 10, "{ticks:?}");
            assert!(ticks.windows(2).all(|pair| pair[0] < pair[1]), "{ticks:?}");
        }
        assert_eq!(Bars::new([6, 17]).ticks(), [6, 8, 10, 12, 14, 16, 17]);
        let huge = Bars::new([1, usize::MAX]);
        assert_eq!(huge.of(usize::MAX), Some(MOST_BARS - 1));
        assert!(huge.ticks().len() <= 10);
    }
}
