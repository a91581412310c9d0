//! Triangles, data and numbers in panels beside each other, as SVG.

use delone::Point;
use std::fmt::Write;

/// Panels beside each other, each with the same part of the plane, and words below.
pub struct Panels {
    low: Point,
    /// Pixels of a unit.
    unit: f64,
    /// Pixels of a panel.
    size: [f64; 2],
    body: String,
    panels: usize,
}

/// Pixels around what is drawn, and below it for words.
const MARGIN: f64 = 26.0;
const WORDS: f64 = 34.0;

impl Panels {
    /// Panels that show the plane from `low` to `high`, so many pixels wide.
    pub fn new([low, high]: [Point; 2], width: f64) -> Self {
        let unit = (width - 2.0 * MARGIN) / (high.x - low.x);
        let height = unit * (high.y - low.y) + 2.0 * MARGIN + WORDS;
        Self {
            low,
            unit,
            size: [width, height],
            body: String::new(),
            panels: 0,
        }
    }

    /// Goes on to the next panel, with these words below it.
    pub fn next(&mut self, words: &str) {
        self.panels += 1;
        let [x, y] = [self.left() + MARGIN, self.size[1] - 12.0];
        self.text([x, y], "font-size=\"15\"", words);
    }

    fn left(&self) -> f64 {
        self.size[0] * (self.panels - 1) as f64
    }

    /// Returns where a point of the plane is on the page.
    pub fn place(&self, p: Point) -> [f64; 2] {
        let x = self.left() + MARGIN + self.unit * (p.x - self.low.x);
        let y = self.size[1] - WORDS - MARGIN - self.unit * (p.y - self.low.y);
        [x, y]
    }

    /// Fills a triangle.
    pub fn triangle(&mut self, corners: [Point; 3], fill: &str) {
        let corners = corners.map(|corner| {
            let [x, y] = self.place(corner);
            format!("{x:.1},{y:.1}")
        });
        let points = corners.join(" ");
        self.add(format_args!(
            "<polygon points=\"{points}\" fill=\"{fill}\" stroke=\"#333\" stroke-linejoin=\"round\"/>"
        ));
    }

    /// Draws a dot.
    pub fn dot(&mut self, p: Point, radius: f64, fill: &str) {
        let [x, y] = self.place(p);
        self.add(format_args!(
            "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{radius}\" fill=\"{fill}\"/>"
        ));
    }

    /// Draws a way from one point to another, dashed.
    pub fn way(&mut self, [from, to]: [Point; 2]) {
        let [[x1, y1], [x2, y2]] = [from, to].map(|p| self.place(p));
        let look = "stroke=\"#c0187a\" stroke-width=\"3\" stroke-dasharray=\"4 3\"";
        self.add(format_args!(
            "<line x1=\"{x1:.1}\" y1=\"{y1:.1}\" x2=\"{x2:.1}\" y2=\"{y2:.1}\" {look}/>"
        ));
    }

    /// Writes a number, with its middle at a place of the page.
    pub fn number(&mut self, [x, y]: [f64; 2], number: usize) {
        let look = "text-anchor=\"middle\" font-weight=\"bold\" font-size=\"19\" fill=\"#1a4f80\" \
                    stroke=\"white\" stroke-width=\"3\" paint-order=\"stroke\"";
        self.text([x, y + 7.0], look, &number.to_string());
    }

    /// Writes words, beginning at a place of the page.
    pub fn text(&mut self, [x, y]: [f64; 2], look: &str, words: &str) {
        self.add(format_args!(
            "<text x=\"{x:.1}\" y=\"{y:.1}\" {look}>{words}</text>"
        ));
    }

    fn add(&mut self, element: std::fmt::Arguments<'_>) {
        writeln!(self.body, "{element}").expect("strings take everything");
    }

    /// Returns the page.
    pub fn page(self) -> String {
        let [width, height] = [self.size[0] * self.panels as f64, self.size[1].ceil()];
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" \
             height=\"{height}\" font-family=\"sans-serif\">\n<rect width=\"100%\" height=\"100%\" \
             fill=\"white\"/>\n{}</svg>\n",
            self.body
        )
    }
}
