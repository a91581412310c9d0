//! Shapes on a page, of a legend or a chart, before they become lines of SVG or pixels of PNG.

use super::domain::RING;
use super::glyphs::{self, Stroke};
use super::{Color, INK, PAPER};

/// Width of the strokes of letters, as a multiple of their size.
const WEIGHT: f32 = 0.76;

/// Shapes, in the order in which they are drawn.
#[derive(Default)]
pub(crate) struct Sheet {
    pub shapes: Vec<Shape>,
}

/// A shape, in pixels.
pub(crate) enum Shape {
    /// A rectangle along the axes.
    Bar {
        corner: [f32; 2],
        extent: [f32; 2],
        color: Color,
    },
    Disc {
        center: [f32; 2],
        radius: f32,
        color: Color,
    },
    /// A convex polygon.
    Area {
        corners: Vec<[f32; 2]>,
        color: Color,
    },
    Lines {
        path: Vec<Stroke>,
        width: f32,
        color: Color,
        opacity: f32,
    },
}

/// What of a line of text lies where it is put.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Anchor {
    Start,
    Middle,
    End,
}

impl Sheet {
    pub fn bar(&mut self, corner: [f32; 2], extent: [f32; 2], color: Color) {
        self.shapes.push(Shape::Bar {
            corner,
            extent,
            color,
        });
    }

    /// Adds a small ring.
    pub fn ring(&mut self, center: [f32; 2], radius: f32) {
        for (radius, color) in [(radius, INK), (RING * radius, PAPER)] {
            self.disc(center, radius, color);
        }
    }

    pub fn disc(&mut self, center: [f32; 2], radius: f32, color: Color) {
        self.shapes.push(Shape::Disc {
            center,
            radius,
            color,
        });
    }

    pub fn area(&mut self, corners: Vec<[f32; 2]>, color: Color) {
        self.shapes.push(Shape::Area { corners, color });
    }

    pub fn line(&mut self, [from, to]: [[f32; 2]; 2], width: f32, color: Color, opacity: f32) {
        self.shapes.push(Shape::Lines {
            path: vec![Stroke::Move(from), Stroke::Line(to)],
            width,
            color,
            opacity,
        });
    }

    /// Adds a line of text on the base line through `at`; digits are seven `size` high.
    pub fn text(&mut self, text: &str, at: [f32; 2], size: f32, anchor: Anchor, color: Color) {
        let share = match anchor {
            Anchor::Start => 0.0,
            Anchor::Middle => 0.5,
            Anchor::End => 1.0,
        };
        let start = [at[0] - share * glyphs::width(text, size), at[1]];
        self.shapes.push(Shape::Lines {
            path: glyphs::strokes(text, start, size),
            width: WEIGHT * size,
            color,
            opacity: 1.0,
        });
    }
}

impl Shape {
    /// Tells whether its sides should fall on pixels.
    pub fn is_bar(&self) -> bool {
        matches!(self, Self::Bar { .. })
    }
}
