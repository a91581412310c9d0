//! The side of the page: title, pseudocode with the line that runs, what the step does, counters.
//!
//! Numbers are marks of single digits, so that only digits that change make new ones.

use super::mark::{Form, Look, Mark, spot, tenths};
use crate::Recording;
use crate::picture::glyphs;
use delone::{Observer, Tally};

/// Height of a line of code in pixels of the usual size, if there is room.
const LEADING: f32 = 27.0;

/// Size of letters of code: digits are seven times as high.
const CODE: f32 = 2.05;

/// Width for the numbers of lines.
const NUMBERS: f32 = 30.0;

/// Width of a blank that indents, for letters of size 1.
const INDENT: f32 = 6.0;

/// Width of a digit of size 1.
const DIGIT: f32 = 5.9;

/// Pieces of the bar that shows how far the work has come.
const PIECES: usize = 100;

/// Rows of counters.
const ROWS: usize = 8;

/// A counter: what is counted, and how often.
type Counter = (&'static str, fn(&Tally) -> u64);

const COUNTERS: [Counter; 10] = [
    ("conflicts", |t| t.last_conflicts.unwrap_or(0)),
    ("triangles", |t| {
        t.triangles_created.saturating_sub(t.triangles_deleted)
    }),
    ("edges", |t| t.edges_created.saturating_sub(t.edges_deleted)),
    ("flips", |t| t.flips),
    ("circle tests", |t| t.circle_tests),
    ("ties among them", |t| t.ties),
    ("orientation tests", |t| t.orientation_tests),
    ("steps of walks", |t| t.walk_steps),
    ("vertices added", |t| t.vertices_created),
    ("queued", |t| t.pushed),
];

/// What there is to say of a frame.
pub(super) struct Caption {
    /// The line that runs; 0: none.
    pub line: usize,
    /// What the step does.
    pub words: &'static str,
    /// How many steps have been taken.
    pub played: usize,
    pub tally: Tally,
}

/// The side of the page, laid out.
pub(super) struct Panel {
    /// Left, top, width, height: of the whole, and of what is written on.
    whole: [f32; 4],
    inner: [f32; 4],
    unit: f32,
    title: String,
    source: String,
    code: Vec<String>,
    /// Size of letters, and height of a line, of code.
    size: f32,
    leading: f32,
    counters: Vec<Counter>,
    steps: usize,
    /// What is said if not all steps are shown.
    note: String,
}

impl Panel {
    /// Lays out a panel in the given place (left, top, width, height).
    pub fn new(recording: &Recording, whole: [f32; 4], unit: f32, note: String) -> Self {
        let [left, top, width, height] = whole;
        let margin = 26.0 * unit;
        let inner = [
            left + margin,
            top + margin,
            width - 2.0 * margin,
            height - 2.0 * margin,
        ];
        let counters = counters(recording);
        let code: Vec<_> = recording.code.iter().map(|line| start(line)).collect();
        let rest = 260.0 + 27.0 * counters.len() as f32;
        let room = (inner[3] - rest * unit).max(0.2 * inner[3]);
        let leading = (LEADING * unit).min(room / code.len().max(1) as f32);
        let width = |line: &String| indent(line) + glyphs::width(line.trim_start(), 1.0);
        let widest = code.iter().map(width).fold(1.0, f32::max);
        let size = (CODE * unit)
            .min(leading / LEADING * 2.3)
            .min((inner[2] - NUMBERS * unit) / widest)
            .max(1.15 * unit);
        Self {
            whole,
            inner,
            unit,
            title: start(&recording.title),
            source: start(&recording.source),
            code,
            size,
            leading,
            counters,
            steps: recording.log.steps.len(),
            note,
        }
    }

    /// Lists what every frame shows.
    pub fn fixed(&self) -> Vec<Mark> {
        let [left, _, width, _] = self.inner;
        let unit = self.unit;
        let [x, y, across, down] = self.whole;
        let mut marks = vec![bar(Look::Panel, [x, y], [across, down])];
        let mut write = |look, text: &str, at, size: f32, least: f32, room| {
            let (text, size) = fit(text, size * unit, least * unit, room);
            marks.push(words(look, &text, at, size));
        };
        let line = |y: f32| [left, self.inner[1] + y * unit];
        write(Look::Strong, &self.title, line(22.0), 3.1, 2.0, width);
        write(Look::Faint, &self.source, line(52.0), 1.8, 1.35, width);
        let numbers = NUMBERS * unit;
        for (i, text) in self.code.iter().enumerate() {
            let base = self.code_base(i);
            let number = (i + 1).to_string();
            let right = left + 0.55 * numbers;
            let start = right - glyphs::width(&number, 0.8 * self.size);
            marks.push(words(Look::Faint, &number, [start, base], 0.8 * self.size));
            let at = left + numbers + indent(text) * self.size;
            // A little more room than it was fitted to, for what is rounded.
            let room = left + width + unit - at;
            let (text, size) = fit(text.trim_start(), self.size, self.size, room);
            marks.push(words(Look::Plain, &text, [at, base], size));
        }
        for (i, (name, _)) in self.counters.iter().enumerate() {
            let at = [left, self.counter_base(i)];
            marks.push(words(Look::Faint, name, at, 1.9 * unit));
        }
        marks.extend(self.foot());
        marks
    }

    /// Lists what belongs to one frame.
    pub fn changing(&self, caption: &Caption) -> Vec<Mark> {
        let [left, _, width, _] = self.inner;
        let unit = self.unit;
        let mut marks = Vec::new();
        if (1..=self.code.len()).contains(&caption.line) {
            let base = self.code_base(caption.line - 1);
            let top = base - 3.5 * self.size - 0.5 * self.leading;
            let corner = [left - 10.0 * unit, top];
            marks.push(bar(
                Look::Running,
                corner,
                [width + 20.0 * unit, self.leading],
            ));
        }
        if !caption.words.is_empty() {
            let at = [left, self.words_base()];
            let (text, size) = fit(caption.words, 2.3 * unit, 1.7 * unit, width);
            marks.push(words(Look::Strong, &text, at, size));
        }
        for (i, (_, count)) in self.counters.iter().enumerate() {
            let end = [left + width, self.counter_base(i)];
            marks.extend(digits(count(&caption.tally), end, 1.9 * unit));
        }
        let size = 1.9 * unit;
        let gap = glyphs::width(&self.total(), size);
        let end = [left + width - gap, self.foot_base()];
        marks.extend(digits(caption.played as u64, end, size));
        let done = caption.played * PIECES / self.steps.max(1);
        marks.extend((0..done).map(|i| self.piece(i)));
        marks
    }

    /// The foot: note, total, and the track of the bar.
    fn foot(&self) -> Vec<Mark> {
        let [left, _, width, _] = self.inner;
        let unit = self.unit;
        let size = 1.9 * unit;
        let total = self.total();
        let start = left + width - glyphs::width(&total, size);
        let track = [width, 5.0 * unit];
        let mut marks = vec![
            words(Look::Faint, &total, [start, self.foot_base()], size),
            bar(Look::Track, [left, self.track_top()], track),
        ];
        let said = if self.note.is_empty() {
            "step"
        } else {
            &self.note
        };
        let (note, size) = fit(said, size, 1.2 * unit, 0.62 * width);
        marks.push(words(Look::Faint, &note, [left, self.foot_base()], size));
        marks
    }

    fn total(&self) -> String {
        format!(" / {}", self.steps)
    }

    fn piece(&self, i: usize) -> Mark {
        let [left, _, width, _] = self.inner;
        let at = |i: usize| left + width * i as f32 / PIECES as f32;
        // From the left end, so that there are no seams.
        let extent = [at(i + 1) - left, 5.0 * self.unit];
        bar(Look::Progress, [left, self.track_top()], extent)
    }

    fn bottom(&self) -> f32 {
        self.inner[1] + self.inner[3]
    }

    fn track_top(&self) -> f32 {
        self.bottom() - 5.0 * self.unit
    }

    fn foot_base(&self) -> f32 {
        self.bottom() - 20.0 * self.unit
    }

    fn code_base(&self, i: usize) -> f32 {
        self.inner[1] + 100.0 * self.unit + i as f32 * self.leading
    }

    fn words_base(&self) -> f32 {
        self.code_base(self.code.len()) + 22.0 * self.unit
    }

    fn counter_base(&self, i: usize) -> f32 {
        let below = (self.counters.len() - 1 - i) as f32;
        self.foot_base() - (42.0 + 27.0 * below) * self.unit
    }
}

/// Chooses the counters that count something.
fn counters(recording: &Recording) -> Vec<Counter> {
    let mut tally = Tally::default();
    let mut seen = [false; COUNTERS.len()];
    for &step in &recording.log.steps {
        tally.observe(step);
        for (seen, (_, count)) in seen.iter_mut().zip(COUNTERS) {
            *seen |= count(&tally) > 0;
        }
    }
    let counting = COUNTERS.into_iter().zip(seen).filter(|&(_, seen)| seen);
    counting.map(|(counter, _)| counter).take(ROWS).collect()
}

/// How far a line of code is indented, in letters of size 1.
fn indent(line: &str) -> f32 {
    INDENT * (line.len() - line.trim_start().len()) as f32
}

/// The beginning of a text: more than any page is wide.
fn start(text: &str) -> String {
    text.chars().take(200).collect()
}

/// Makes a text fit: smaller letters, and if that is not enough, fewer.
pub(super) fn fit(text: &str, size: f32, least: f32, room: f32) -> (String, f32) {
    let width = glyphs::width(text, 1.0).max(f32::MIN_POSITIVE);
    let fitting = room / width;
    if fitting >= least {
        return (text.to_owned(), size.min(fitting));
    }
    let mut kept = text.to_owned();
    while !kept.is_empty() && glyphs::width(&kept, least) + glyphs::width("...", least) > room {
        kept.pop();
    }
    (kept + "...", least)
}

/// A line of text that begins at a place.
pub(super) fn words(look: Look, text: &str, at: [f32; 2], size: f32) -> Mark {
    let form = Form::Text {
        start: spot(at),
        size: (size * 1000.0).round() as i32,
        text: text.into(),
    };
    Mark { look, form }
}

/// A number that ends at a place, a mark for each digit, all of one width.
fn digits(number: u64, [right, base]: [f32; 2], size: f32) -> Vec<Mark> {
    let text = number.to_string();
    let places = text.chars().rev().enumerate();
    places
        .map(|(i, digit)| {
            let at = right - (i + 1) as f32 * DIGIT * size;
            words(Look::Plain, &digit.to_string(), [at, base], size)
        })
        .collect()
}

fn bar(look: Look, corner: [f32; 2], extent: [f32; 2]) -> Mark {
    let form = Form::Bar {
        corner: spot(corner),
        extent: extent.map(tenths),
    };
    Mark { look, form }
}
