//! Histograms with axes.

use crate::picture::domain::REGION_COLORS;
use crate::picture::sheet::{Anchor, Sheet};
use crate::picture::{Color, INK, scale};
use crate::unmet::{bound, degrees};
use crate::words::count;
use delone::Quality;
use delone::check::{LogHistogram, Statistics};

/// Colour of what was asked for.
const ASKED: Color = REGION_COLORS[0];

/// Colour of bars that stand for no angle.
const PLAIN: f32 = 0.38;

/// Most bars of a histogram of lengths or areas.
const MOST_BARS: usize = 48;

/// Share of an axis that a number takes.
const ROOM: f32 = 0.1;

/// Size of letters, and of those of a title.
const TEXT: f32 = 1.9;
const TITLE: f32 = 2.4;

/// A histogram, its places given as shares of the axis.
pub(super) struct Chart {
    pub title: &'static str,
    pub subtitle: &'static str,
    bars: Vec<Bar>,
    ticks: Vec<(f32, String)>,
    asked: Option<(f32, String)>,
}

struct Bar {
    range: [f32; 2],
    count: usize,
    color: Color,
}

impl Chart {
    /// Shows the angles of all triangles.
    pub fn of_angles(found: &Statistics, asked: &Quality) -> Self {
        let goodness = |angle: f32| (angle / 60.0).min((180.0 - angle) / 120.0);
        Self {
            title: "Angles",
            subtitle: "three of each triangle, in degrees",
            bars: bars_of_degrees(&found.angles, 3, |angle| scale(goodness(angle))),
            ..Self::of_degrees(180, asked)
        }
    }

    /// Shows the smallest angle of each triangle.
    pub fn of_smallest_angles(found: &Statistics, asked: &Quality) -> Self {
        Self {
            title: "Smallest angles",
            subtitle: "one of each triangle, in degrees",
            bars: bars_of_degrees(&found.min_angles, 1, |angle| scale(angle / 60.0)),
            ..Self::of_degrees(60, asked)
        }
    }

    /// Shows the lengths of edges.
    pub fn of_edges(found: &Statistics, asked: &Quality) -> Self {
        Self {
            title: "Edges",
            subtitle: "by length, in units of the coordinates",
            ..Self::of_sizes(&found.edges, asked.max_edge)
        }
    }

    /// Shows the areas of triangles.
    pub fn of_areas(found: &Statistics, asked: &Quality) -> Self {
        Self {
            title: "Areas",
            subtitle: "of triangles, in squared units of the coordinates",
            ..Self::of_sizes(&found.areas, asked.max_area)
        }
    }

    /// Makes the axis of a chart of degrees.
    fn of_degrees(most: u32, asked: &Quality) -> Self {
        let at = |angle: f64| (angle / f64::from(most)) as f32;
        let ticks = (0..=6).map(|i| i * most / 6);
        let asked = asked.min_angle.map(|angle| angle.to_degrees());
        Self {
            title: "",
            subtitle: "",
            bars: Vec::new(),
            ticks: ticks
                .map(|angle| (at(f64::from(angle)), format!("{angle}°")))
                .collect(),
            asked: asked.map(|angle| (at(angle), format!("asked {}", degrees(angle)))),
        }
    }

    /// Makes a chart with a logarithmic axis.
    fn of_sizes(histogram: &LogHistogram, asked: Option<f64>) -> Self {
        let counts = histogram.counts();
        let merged = counts.len().div_ceil(MOST_BARS).next_power_of_two();
        let starts = (0..counts.len()).step_by(merged);
        let ends = starts.clone().map(|i| (i + merged).min(counts.len()));
        let sums: Vec<([f64; 2], usize)> = starts
            .zip(ends)
            .map(|(start, end)| {
                let range = [histogram.bounds(start)[0], histogram.bounds(end - 1)[1]];
                (range, counts[start..end].iter().sum())
            })
            .collect();
        let axis = LogAxis::new(&sums, asked);
        let bar = |&(range, count): &([f64; 2], usize)| Bar {
            range: range.map(|size: f64| axis.at(size)),
            count,
            color: scale(PLAIN),
        };
        let asked = asked.map(|size| (axis.at(size), format!("asked {}", bound(size))));
        Self {
            title: "",
            subtitle: "",
            bars: sums.iter().map(bar).collect(),
            ticks: axis.ticks(),
            asked: asked.filter(|(at, _)| (0.0..=1.0).contains(at)),
        }
    }

    /// Says in words what the chart shows.
    pub fn in_words(&self) -> String {
        let most = self.bars.iter().max_by_key(|bar| bar.count);
        let bars = self.bars.iter().filter(|bar| bar.count > 0).count();
        let highest = count(most.map_or(0, |bar| bar.count));
        format!(
            "{} {}: {bars} bars, the highest {highest}",
            self.title, self.subtitle
        )
    }

    /// Draws the chart.
    pub fn draw(&self, sheet: &mut Sheet, corner: [f32; 2], extent: [f32; 2], unit: f32) {
        let [x, y] = corner;
        sheet.text(
            self.title,
            [x, y + 20.0 * unit],
            TITLE * unit,
            Anchor::Start,
            INK,
        );
        let below = [x, y + 42.0 * unit];
        sheet.text(self.subtitle, below, TEXT * unit, Anchor::Start, INK);
        let plot = Plot {
            left: x + 62.0 * unit,
            right: x + extent[0] - 28.0 * unit,
            top: y + 88.0 * unit,
            bottom: y + extent[1] - 34.0 * unit,
            unit,
        };
        let highest = self.bars.iter().map(|bar| bar.count).max().unwrap_or(0);
        if highest == 0 {
            let middle = [
                (plot.left + plot.right) / 2.0,
                (plot.top + plot.bottom) / 2.0,
            ];
            sheet.text("nothing to count", middle, TEXT * unit, Anchor::Middle, INK);
            return;
        }
        plot.draw_heights(sheet, highest);
        for bar in &self.bars {
            plot.draw_bar(sheet, bar, highest);
        }
        plot.draw_axis(sheet, &self.ticks);
        if let Some((at, text)) = &self.asked {
            plot.draw_bound(sheet, *at, text);
        }
    }
}

fn bars_of_degrees(counts: &[usize], width: usize, color: impl Fn(f32) -> Color) -> Vec<Bar> {
    let at = |angle: usize| angle as f32 / counts.len() as f32;
    let bars = counts.chunks(width).enumerate();
    bars.map(|(i, counts)| Bar {
        range: [at(i * width), at((i + 1) * width)],
        count: counts.iter().sum(),
        color: color((i as f32 + 0.5) * width as f32),
    })
    .collect()
}

/// The area of the bars, in pixels.
struct Plot {
    left: f32,
    right: f32,
    top: f32,
    bottom: f32,
    unit: f32,
}

impl Plot {
    fn across(&self, share: f32) -> f32 {
        self.left + (self.right - self.left) * share
    }

    fn up(&self, share: f32) -> f32 {
        self.bottom - (self.bottom - self.top) * share
    }

    /// Draws a faint line, with its number, at a few even counts.
    fn draw_heights(&self, sheet: &mut Sheet, highest: usize) {
        let step = even_step(highest);
        for level in (step..=highest).step_by(step) {
            let y = self.up((level as f64 / highest as f64) as f32);
            let line = [[self.left, y], [self.right, y]];
            sheet.line(line, 1.2 * self.unit, INK, 0.16);
            let end = [self.left - 8.0 * self.unit, y + 3.5 * TEXT * self.unit];
            sheet.text(&compact(level), end, TEXT * self.unit, Anchor::End, INK);
        }
    }

    fn draw_bar(&self, sheet: &mut Sheet, bar: &Bar, highest: usize) {
        if bar.count == 0 {
            return;
        }
        let [left, right] = bar.range.map(|share| self.across(share));
        // What there is, even if it is little, can be seen.
        let least = 1.6 * self.unit;
        let height = (self.bottom - self.up((bar.count as f64 / highest as f64) as f32)).max(least);
        let width = ((right - left) * 0.86).max(0.5 * self.unit);
        let corner = [left, self.bottom - height];
        sheet.bar(corner, [width, height], bar.color);
    }

    fn draw_axis(&self, sheet: &mut Sheet, ticks: &[(f32, String)]) {
        let unit = self.unit;
        let line = [[self.left, self.bottom], [self.right, self.bottom]];
        sheet.line(line, 1.6 * unit, INK, 1.0);
        for (at, text) in ticks {
            let x = self.across(*at);
            let tick = [[x, self.bottom], [x, self.bottom + 6.0 * unit]];
            sheet.line(tick, 1.6 * unit, INK, 1.0);
            let middle = [x, self.bottom + 26.0 * unit];
            sheet.text(text, middle, TEXT * unit, Anchor::Middle, INK);
        }
    }

    fn draw_bound(&self, sheet: &mut Sheet, at: f32, text: &str) {
        let unit = self.unit;
        let x = self.across(at);
        let top = self.top - 12.0 * unit;
        sheet.line([[x, self.bottom], [x, top]], 2.6 * unit, ASKED, 1.0);
        let (start, anchor) = match at > 0.5 {
            true => (x - 8.0 * unit, Anchor::End),
            false => (x + 8.0 * unit, Anchor::Start),
        };
        sheet.text(text, [start, top + 8.0 * unit], TEXT * unit, anchor, ASKED);
    }
}

/// A logarithmic axis.
struct LogAxis {
    /// Logarithms to base 10 of its ends.
    ends: [f64; 2],
}

impl LogAxis {
    /// Makes room for all bars, and for what was asked for unless it is far away.
    fn new(bars: &[([f64; 2], usize)], asked: Option<f64>) -> Self {
        // The least bin begins at zero.
        let least = f64::from_bits(1);
        let low = bars.first().map_or(1.0, |(range, _)| range[0].max(least));
        let high = bars.last().map_or(10.0, |(range, _)| range[1]);
        let mut ends = [low, high].map(|size| size.min(f64::MAX).log10());
        let room = 0.25 * (ends[1] - ends[0]).max(0.5);
        if let Some(asked) = asked.map(f64::log10) {
            if (ends[0] - room..ends[0]).contains(&asked) {
                ends[0] = asked;
            }
            if (ends[1]..ends[1] + room).contains(&asked) {
                ends[1] = asked;
            }
        }
        Self { ends }
    }

    fn at(&self, size: f64) -> f32 {
        let [low, high] = self.ends;
        ((size.log10() - low) / (high - low)) as f32
    }

    /// Chooses up to seven round numbers: all digits, or 1, 2, 5, or powers of ten, or some of these.
    fn ticks(&self) -> Vec<(f32, String)> {
        let digits: [&[u32]; 3] = [&[1, 2, 3, 4, 5, 6, 7, 8, 9], &[1, 2, 5], &[1]];
        let sets = digits.map(|digits| self.round_numbers(digits));
        let fits = |set: &&Vec<f64>| set.len() <= 7 && self.are_apart(set);
        let chosen = sets.iter().find(fits).unwrap_or(&sets[2]);
        let every = chosen.len().div_ceil(7).max(1);
        let chosen = chosen.iter().step_by(every);
        chosen.map(|&size| (self.at(size), bound(size))).collect()
    }

    /// Tells whether numbers have room beside each other.
    fn are_apart(&self, sizes: &[f64]) -> bool {
        let mut pairs = sizes.windows(2);
        pairs.all(|pair| self.at(pair[1]) - self.at(pair[0]) >= ROOM)
    }

    fn round_numbers(&self, digits: &[u32]) -> Vec<f64> {
        let decades = self.ends[0].floor() as i32..=self.ends[1].floor() as i32;
        let numbers = decades.flat_map(|decade| {
            let number = move |digit: &u32| format!("{digit}e{decade}").parse().unwrap_or(0.0);
            digits.iter().map(number)
        });
        numbers
            .filter(|&number| (0.0..=1.0).contains(&self.at(number)))
            .collect()
    }
}

/// Chooses the distance of lines: 1, 2 or 5 times a power of ten, such that there are two to four.
fn even_step(highest: usize) -> usize {
    let mut power = 1usize;
    loop {
        for factor in [1, 2, 5] {
            let step = power.saturating_mul(factor);
            if highest / step <= 4 {
                return step;
            }
        }
        power = power.saturating_mul(10);
    }
}

/// Writes a round count shortly: `500`, `20k`, `1.5M`.
fn compact(n: usize) -> String {
    match n {
        0..10_000 => count(n),
        10_000..1_000_000 => format!("{}k", n as f64 / 1e3),
        1_000_000..1_000_000_000 => format!("{}M", n as f64 / 1e6),
        _ => format!("{}G", n as f64 / 1e9),
    }
}

#[cfg(test)]
mod tests {
    use super::{Chart, LogAxis, compact, even_step};
    use crate::picture::sheet::{Shape, Sheet};
    use delone::check::{LogHistogram, statistics};
    use delone::{Angle, Point, Quality, VertexId};

    #[test]
    fn lines_are_few_and_round() {
        for highest in [1, 4, 5, 9, 10, 99, 100, 12_345, 4_000_000_000] {
            let step = even_step(highest);
            let lines = highest / step;
            assert!((1..=4).contains(&lines), "{highest}: {step}");
        }
        assert_eq!(
            [2000, 50_000, 1_500_000, 2_000_000_000].map(compact),
            ["2,000", "50k", "1.5M", "2G"]
        );
    }

    #[test]
    fn axes_have_some_ticks_at_any_scale() {
        for (low, high) in [
            (0.9, 1.1),
            (1.0, 4.0),
            (1e-3, 1.0),
            (0.0055, 0.031),
            (1e-300, 1e300),
            (3e-320, 1e-310),
        ] {
            let axis = LogAxis::new(&[([low, high], 1)], None);
            let ticks = axis.ticks();
            assert!((1..=7).contains(&ticks.len()), "{low} {high}: {ticks:?}");
            let apart = ticks.windows(2).all(|pair| pair[1].0 - pair[0].0 > 0.099);
            assert!(apart, "{low} {high}: {ticks:?}");
        }
    }

    #[test]
    fn bars_sum_up_to_what_was_counted() {
        let points = [(0., 0.), (1., 0.), (0., 1.), (900., 800.)].map(Point::from);
        let triangles = [[0, 1, 2], [1, 3, 2]].map(|t| t.map(VertexId::new));
        let found = statistics(&points, &triangles);
        let asked = Quality {
            min_angle: Some(Angle::degrees(20.0)),
            max_edge: Some(1e9),
            ..Quality::default()
        };
        let sum = |chart: &Chart| chart.bars.iter().map(|bar| bar.count).sum::<usize>();
        assert_eq!(sum(&Chart::of_angles(&found, &asked)), 6);
        assert_eq!(sum(&Chart::of_smallest_angles(&found, &asked)), 2);
        assert_eq!(sum(&Chart::of_areas(&found, &asked)), 2);
        let edges = Chart::of_edges(&found, &asked);
        assert_eq!(sum(&edges), 5);
        assert!(edges.asked.is_none(), "far beyond the longest edge");
        let angle = Chart::of_angles(&found, &asked).asked;
        assert_eq!(angle, Some((20.0 / 180.0, "asked 20°".to_owned())));
    }

    #[test]
    fn bars_are_never_too_many() {
        let mut sizes = LogHistogram::default();
        for exponent in -300..300 {
            sizes.add(10f64.powi(exponent));
        }
        let chart = Chart::of_sizes(&sizes, None);
        assert!(chart.bars.len() <= super::MOST_BARS);
        assert_eq!(chart.bars.iter().map(|bar| bar.count).sum::<usize>(), 600);
    }

    #[test]
    fn counts_of_any_size_stay_on_the_page() {
        let mut found = statistics(&[], &[]);
        found.angles[60] = usize::MAX / 2;
        found.angles[90] = 1;
        let mut sheet = Sheet::default();
        let chart = Chart::of_angles(&found, &Quality::default());
        chart.draw(&mut sheet, [0.0; 2], [500.0, 400.0], 1.0);
        let bars = sheet.shapes.iter().filter_map(|shape| match shape {
            Shape::Bar { corner, extent, .. } => Some([corner[1], extent[1]]),
            _ => None,
        });
        let bars: Vec<_> = bars.collect();
        assert_eq!(bars.len(), 2);
        assert!(
            bars.iter()
                .all(|[top, height]| *top > 0.0 && *height >= 1.0),
            "{bars:?}"
        );
    }
}
