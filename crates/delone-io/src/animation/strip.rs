//! `.png`: a filmstrip, some frames in a grid, each with its step, its line and what happens.

use super::frames::Plan;
use super::mark::{Detail, Look, Mark};
use super::panel::{Caption, fit, words};
use super::pen::Pen;
use super::player::{Marks, Player, points_of};
use super::raster;
use crate::picture::{View, glyphs};
use crate::target::Output;
use crate::{Error, Recording, png};
use delone::Watch;
use tiny_skia::{Pixmap, PixmapPaint, Transform};

/// Width of a cell of usual size in pixels.
const CELL: f32 = 320.0;

/// Height of the head of the page, and of the words below a drawing, in pixels of the usual size.
const HEAD: f32 = 74.0;
const WORDS: f32 = 86.0;

/// Space around a drawing.
const MARGIN: f32 = 18.0;

/// Writes a filmstrip.
pub(super) fn write(
    out: &mut Output<'_>,
    recording: &Recording,
    plan: &Plan,
    size: u32,
    watch: &dyn Watch,
) -> Result<(), Error> {
    let grid = Grid::new(plan.ends.len(), size as f32);
    let file = out.file().to_owned();
    let points = points_of(&recording.log);
    let margin = MARGIN * grid.unit;
    let drawing = [[margin; 2], [grid.cell[0] - 2.0 * margin; 2]];
    let view = View::within(&points, grid.cell, drawing);
    let pen = Pen::new(view, 0.8 * grid.unit, points.len());
    let mut player = Player::new(&file, recording, &pen, None, watch);
    let mut page = pixmap(grid.page);
    let mut cell = pixmap([grid.cell[0]; 2]);
    draw_words(&mut page, &grid.head(recording), pen.detail);
    for (i, frame) in plan.frames().enumerate() {
        player.advance(frame)?;
        raster::draw(&mut cell, &player.marks, pen.detail);
        let [x, y] = grid.corner(i).map(|v| v as i32);
        let paint = PixmapPaint::default();
        page.draw_pixmap(x, y, cell.as_ref(), &paint, Transform::identity(), None);
        let below = grid.words(i, &player.caption(), recording);
        draw_words(&mut page, &below, pen.detail);
    }
    let packed = png::pack(&page, &file, || crate::cancel::check(watch, 0))?;
    out.many_bytes(&packed)
}

fn pixmap(size: [f32; 2]) -> Pixmap {
    let [width, height] = size.map(|v| (v as u32).max(1));
    let mut page = Pixmap::new(width, height).expect("bug: the page has a size");
    page.fill(tiny_skia::Color::WHITE);
    page
}

fn draw_words(page: &mut Pixmap, marks: &[Mark], detail: Detail) {
    let mut all = Marks::default();
    marks.iter().for_each(|mark| all.add(mark.clone()));
    raster::draw_upon(page, &all, detail);
}

/// Where the cells are.
struct Grid {
    columns: usize,
    page: [f32; 2],
    /// Extent of a cell, words included.
    cell: [f32; 2],
    unit: f32,
}

impl Grid {
    /// Lays out so many cells on a page whose longer side is given.
    fn new(cells: usize, size: f32) -> Self {
        // About four to three, and no more columns than those rows need.
        let wide = (cells as f32 * 4.0 / 3.0).sqrt().ceil() as usize;
        let rows = cells.div_ceil(wide);
        let columns = cells.div_ceil(rows);
        let usual = [columns as f32 * CELL, HEAD + rows as f32 * (CELL + WORDS)];
        let unit = size / usual[0].max(usual[1]);
        Self {
            columns,
            page: usual.map(|v| (v * unit).floor()),
            cell: [CELL * unit, (CELL + WORDS) * unit].map(f32::floor),
            unit,
        }
    }

    fn corner(&self, i: usize) -> [f32; 2] {
        let (row, column) = (i / self.columns, i % self.columns);
        [
            column as f32 * self.cell[0],
            (HEAD * self.unit + row as f32 * self.cell[1]).floor(),
        ]
    }

    /// Title and source.
    fn head(&self, recording: &Recording) -> Vec<Mark> {
        let unit = self.unit;
        let room = self.page[0] - 2.0 * MARGIN * unit;
        let line = |look, text: &str, y: f32, size: f32| {
            let cut: String = text.chars().take(200).collect();
            let (text, size) = fit(&cut, size * unit, 0.6 * size * unit, room);
            words(look, &text, [MARGIN * unit, y * unit], size)
        };
        vec![
            line(Look::Strong, &recording.title, 38.0, 3.2),
            line(Look::Faint, &recording.source, 64.0, 1.9),
        ]
    }

    /// The words below a drawing.
    fn words(&self, i: usize, caption: &Caption, recording: &Recording) -> Vec<Mark> {
        let unit = self.unit;
        let [left, top] = self.corner(i);
        let left = left + MARGIN * unit;
        let room = self.cell[0] - 2.0 * MARGIN * unit;
        let base = |y: f32| top + (CELL + y) * unit;
        let mut number = format!("{} / {}", caption.played, recording.log.steps.len());
        if let Some(conflicts) = caption.tally.last_conflicts {
            number = format!("{number}, Φ = {conflicts}");
        }
        let code = caption.line.checked_sub(1);
        let code = code.and_then(|line| recording.code.get(line));
        let code: String = code
            .map_or("", |line| line.trim_start())
            .chars()
            .take(200)
            .collect();
        let happens = match caption.words {
            "" => number,
            words => format!("{number}: {words}"),
        };
        let first = (Look::Strong, happens.as_str(), 14.0, 1.8);
        let code = rows(&code, 1.5 * unit, room);
        let code = code.into_iter().zip(0u8..);
        let code = code.map(|(row, i)| (Look::Faint, row, 36.0 + 18.0 * f32::from(i), 1.5));
        let fitted = std::iter::once(first).chain(code);
        let fitted = fitted.map(|(look, text, y, size)| {
            let (text, size) = fit(text, size * unit, 1.25 * unit, room);
            words(look, &text, [left, base(y)], size)
        });
        fitted.collect()
    }
}

/// Breaks a text into at most three rows, after words, where letters of this size do not fit any more.
fn rows(mut text: &str, size: f32, room: f32) -> Vec<&str> {
    let mut rows = Vec::new();
    let fits = |text: &str| glyphs::width(text, size) <= room;
    while rows.len() < 2 && !fits(text) {
        let blanks = text.match_indices(' ').map(|(at, _)| at);
        let Some(at) = blanks.take_while(|&at| fits(&text[..at])).last() else {
            break;
        };
        rows.push(&text[..at]);
        text = &text[at + 1..];
    }
    rows.push(text);
    rows
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_is_broken_after_the_last_word_that_fits() {
        let room = glyphs::width("one two", 1.0);
        assert_eq!(rows("one two", 1.0, room), ["one two"]);
        assert_eq!(rows("one two one two", 1.0, room), ["one two", "one two"]);
        assert_eq!(
            rows("one two one two one two one", 1.0, room),
            ["one two", "one two", "one two one"]
        );
        assert_eq!(
            rows("onetwothreefour one", 1.0, room),
            ["onetwothreefour one"]
        );
    }

    #[test]
    fn every_cell_lies_on_the_page() {
        for cells in 1..=100 {
            let grid = Grid::new(cells, 1600.0);
            assert!(
                grid.page.iter().all(|&v| (1.0..=1600.0).contains(&v)),
                "{cells}"
            );
            for i in 0..cells {
                let corner = grid.corner(i);
                let fits = |k: usize| corner[k] + grid.cell[k] <= grid.page[k] + 1.0;
                assert!(fits(0) && fits(1), "{cells}: {corner:?} {:?}", grid.page);
            }
        }
        let columns = [1, 2, 9, 12, 20].map(|cells| Grid::new(cells, 1600.0).columns);
        assert_eq!(columns, [1, 2, 3, 4, 5]);
    }
}
