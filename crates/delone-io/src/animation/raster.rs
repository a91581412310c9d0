//! Marks to pixels.

use super::mark::{Detail, Form, Ink, Look, Mark, Spot};
use super::player::Marks;
use crate::picture::PAPER;
use crate::picture::glyphs;
use crate::png::{paint, path_of, round_stroke};
use tiny_skia::{FillRule, Path, PathBuilder, Pixmap, Rect, StrokeDash, Transform};

/// Draws the marks of a frame.
pub(super) fn draw(page: &mut Pixmap, marks: &Marks, detail: Detail) {
    let [r, g, b] = PAPER.0;
    page.fill(tiny_skia::Color::from_rgba(r, g, b, 1.0).expect("bug: a color"));
    draw_upon(page, marks, detail);
}

/// Draws marks upon what there is.
pub(super) fn draw_upon(page: &mut Pixmap, marks: &Marks, detail: Detail) {
    let all: Vec<_> = marks.iter().collect();
    for alike in all.chunk_by(|a, b| a.look == b.look) {
        draw_alike(page, alike, detail);
    }
}

/// Draws marks of one look, all forms in one path.
fn draw_alike(page: &mut Pixmap, marks: &[&Mark], detail: Detail) {
    let look = marks[0].look;
    let ink = look.ink(detail);
    let mut shapes = PathBuilder::new();
    for mark in marks {
        if let Form::Text { start, size, text } = &mark.form {
            write(page, look, ink, pixels(*start), *size as f32 / 1000.0, text);
        } else {
            push(&mut shapes, &mark.form);
        }
    }
    if let Some(path) = shapes.finish() {
        draw_path(page, &path, ink, detail);
    }
}

fn draw_path(page: &mut Pixmap, path: &Path, ink: Ink, detail: Detail) {
    let identity = Transform::identity();
    if let Some(color) = ink.fill {
        let paint = paint(color, ink.opacity);
        page.fill_path(path, &paint, FillRule::Winding, identity, None);
    }
    if let Some((color, width)) = ink.line {
        let mut stroke = round_stroke(width);
        if ink.is_dashed {
            let dash = detail.dash();
            stroke.dash = StrokeDash::new(vec![dash, dash], 0.0);
        }
        page.stroke_path(path, &paint(color, ink.opacity), &stroke, identity, None);
    }
}

fn write(page: &mut Pixmap, look: Look, ink: Ink, start: [f32; 2], size: f32, text: &str) {
    let strokes = glyphs::strokes(text, start, size);
    if let (Some(path), Some((color, _))) = (path_of(&strokes), ink.line) {
        let stroke = round_stroke(look.weight() * size);
        let paint = paint(color, ink.opacity);
        page.stroke_path(&path, &paint, &stroke, Transform::identity(), None);
    }
}

fn push(path: &mut PathBuilder, form: &Form) {
    match form {
        &Form::Disc { center, radius } => {
            let [x, y] = pixels(center);
            path.push_circle(x, y, radius as f32 / 10.0);
        }
        // A line that moves has come.
        Form::Line(ends) | Form::Turn([_, ends]) => push_line(path, ends, false),
        Form::Triangle(corners) => push_line(path, corners, true),
        Form::Path(places) => push_line(path, places, false),
        &Form::Bar { corner, extent } => {
            let [[x, y], [width, height]] = [corner, extent].map(pixels);
            if let Some(rect) = Rect::from_xywh(x, y, width, height) {
                path.push_rect(rect);
            }
        }
        Form::Text { .. } => {}
    }
}

fn push_line(path: &mut PathBuilder, places: &[Spot], is_closed: bool) {
    for (i, &place) in places.iter().enumerate() {
        let [x, y] = pixels(place);
        match i {
            0 => path.move_to(x, y),
            _ => path.line_to(x, y),
        }
    }
    if is_closed {
        path.close();
    }
}

fn pixels(place: Spot) -> [f32; 2] {
    place.map(|v| v as f32 / 10.0)
}
