//! From the plane to marks on the page.
//!
//! Circles are made of places on the page, not of the plane: so they go through the dots that are seen,
//! however far apart the magnitudes of coordinates are.

use super::mark::{Detail, Form, Look, Mark, Spot, spot, tenths};
use super::panel;
use crate::picture::View;
use crate::picture::glyphs;
use delone::{Cut, Point, Sweep};

/// Radius, as a multiple of the page, from which on only a part of a circle is drawn.
const FLAT: f64 = 4.0;

/// Size of numbers in the drawing: digits are seven times as high.
const COUNT: f32 = 2.0;

/// Pieces of such a part.
const PIECES: i32 = 48;

/// Draws marks where the view says.
pub(super) struct Pen {
    pub view: View,
    pub detail: Detail,
}

impl Pen {
    /// Draws for so many vertices.
    pub fn new(view: View, unit: f32, vertices: usize) -> Self {
        let spacing = (view.area() / vertices.max(1) as f32).sqrt() / unit;
        let room = (spacing / 62.0).clamp(0.3, 1.0);
        Self {
            view,
            detail: Detail { unit, room },
        }
    }

    fn spot(&self, p: Point) -> Spot {
        spot(self.view.place(p))
    }

    pub fn line(&self, look: Look, ends: [Point; 2]) -> Mark {
        let form = Form::Line(ends.map(|p| self.spot(p)));
        Mark { look, form }
    }

    /// A line that turns into another, each end taking the shorter way.
    pub fn turn(&self, look: Look, from: [Point; 2], to: [Point; 2]) -> Mark {
        let [from, to] = [from, to].map(|ends| ends.map(|p| self.spot(p)));
        let way = |to: [Spot; 2]| distance(from[0], to[0]) + distance(from[1], to[1]);
        let crossed = [to[1], to[0]];
        let to = if way(to) <= way(crossed) { to } else { crossed };
        let form = Form::Turn([from, to]);
        Mark { look, form }
    }

    pub fn triangle(&self, look: Look, corners: [Point; 3]) -> Mark {
        let form = Form::Triangle(corners.map(|p| self.spot(p)));
        Mark { look, form }
    }

    /// The dot of a vertex.
    pub fn dot(&self, look: Look, p: Point) -> Mark {
        self.disc(look, p, self.detail.dot())
    }

    /// What is drawn around a vertex.
    pub fn ring(&self, look: Look, p: Point) -> Mark {
        self.disc(look, p, self.detail.ring())
    }

    /// The vertex whose turn it is.
    pub fn considered(&self, p: Point) -> [Mark; 2] {
        let ring = self.detail.ring();
        [
            self.disc(Look::Casing, p, ring),
            self.disc(Look::Considered, p, 0.74 * ring),
        ]
    }

    pub fn disc(&self, look: Look, p: Point, radius: f32) -> Mark {
        let form = Form::Disc {
            center: self.spot(p),
            radius: tenths(radius).max(1),
        };
        Mark { look, form }
    }

    /// A small square.
    pub fn square(&self, look: Look, p: Point) -> Mark {
        let half = tenths(0.8 * self.detail.ring());
        let form = Form::Bar {
            corner: self.spot(p).map(|v| v - half),
            extent: [2 * half; 2],
        };
        Mark { look, form }
    }

    /// Numbers above a place, on paper.
    pub fn numbers(&self, p: Point, numbers: &[u32]) -> Vec<Mark> {
        let words: Vec<_> = numbers.iter().map(u32::to_string).collect();
        let text = words.join(" ");
        if text.is_empty() {
            return Vec::new();
        }
        let size = COUNT * self.detail.unit * self.detail.room.max(0.6);
        let [x, y] = self.view.place(p);
        let (width, above) = (glyphs::width(&text, size), 1.3 * self.detail.ring());
        // On the page, wherever the place is.
        let [right, _] = self.view.page;
        let left = (x - width / 2.0)
            .min(right - width - 3.0 * size)
            .max(3.0 * size);
        let base = (y - above).max(10.0 * size);
        let corner = [left - 2.0 * size, base - 9.0 * size];
        let form = Form::Bar {
            corner: spot(corner),
            extent: spot([width + 4.0 * size, 11.0 * size]),
        };
        let paper = Mark {
            look: Look::Casing,
            form,
        };
        vec![paper, panel::words(Look::Strong, &text, [left, base], size)]
    }

    /// The line along which a set is cut, across the drawing.
    pub fn cut(&self, look: Look, cut: Cut) -> Mark {
        let [corner, extent] = self.view.drawing;
        let far = [0, 1].map(|k| corner[k] + extent[k]);
        let ends = match cut {
            Cut::Vertical(x) => {
                let [x, _] = self.view.place(Point::new(x, 0.0));
                [[x, corner[1]], [x, far[1]]]
            }
            Cut::Horizontal(y) => {
                let [_, y] = self.view.place(Point::new(0.0, y));
                [[corner[0], y], [far[0], y]]
            }
        };
        let form = Form::Line(ends.map(spot));
        Mark { look, form }
    }

    /// The line or circle that sweeps the plane.
    pub fn sweep(&self, sweep: Sweep) -> Mark {
        match sweep {
            Sweep::Vertical(x) => self.cut(Look::Sweep, Cut::Vertical(x)),
            Sweep::Horizontal(y) => self.cut(Look::Sweep, Cut::Horizontal(y)),
            Sweep::Circle { center, radius } => {
                let center = self.view.place(center).map(f64::from);
                let radius = self.view.length(radius);
                let on = [center[0] + radius, center[1]];
                self.round(Look::Sweep, on, center, radius)
            }
        }
    }

    /// The circle through three points, if they are not in line on the page.
    pub fn circle(&self, look: Look, corners: [Point; 3]) -> Option<Mark> {
        let places = corners.map(|p| self.view.place(p).map(f64::from));
        let (center, radius) = circumcircle(places)?;
        Some(self.round(look, places[0], center, radius))
    }

    /// The circle of which a line is the diameter.
    pub fn diametral(&self, look: Look, ends: [Point; 2]) -> Mark {
        let [a, b] = ends.map(|p| self.view.place(p).map(f64::from));
        let center = [0, 1].map(|k| (a[k] + b[k]) / 2.0);
        let radius = (a[0] - b[0]).hypot(a[1] - b[1]) / 2.0;
        self.round(look, a, center, radius)
    }

    fn round(&self, look: Look, on: [f64; 2], center: [f64; 2], radius: f64) -> Mark {
        let size = f64::from(self.view.page[0] + self.view.page[1]);
        let form = match radius < FLAT * size {
            true => Form::Disc {
                center: spot(center.map(|v| v as f32)),
                radius: tenths(radius as f32).max(1),
            },
            false => Form::Path(arc(on, center, radius, 2.0 * size)),
        };
        Mark { look, form }
    }
}

/// A part of a large circle around a point on it; computed from there, so that nothing cancels.
fn arc(on: [f64; 2], center: [f64; 2], radius: f64, length: f64) -> Vec<Spot> {
    let [nx, ny] = [0, 1].map(|k| (on[k] - center[k]) / radius);
    let place = |i: i32| {
        let along = length * f64::from(i) / f64::from(PIECES / 2);
        let sag = along * along / (radius + (radius * radius - along * along).sqrt());
        let [x, y] = [on[0] - along * ny - sag * nx, on[1] + along * nx - sag * ny];
        spot([x as f32, y as f32])
    };
    (-PIECES / 2..=PIECES / 2).map(place).collect()
}

fn circumcircle([a, b, c]: [[f64; 2]; 3]) -> Option<([f64; 2], f64)> {
    let [bx, by] = [b[0] - a[0], b[1] - a[1]];
    let [cx, cy] = [c[0] - a[0], c[1] - a[1]];
    let twice = 2.0 * (bx * cy - by * cx);
    let (bb, cc) = (bx * bx + by * by, cx * cx + cy * cy);
    let [x, y] = [(cy * bb - by * cc) / twice, (bx * cc - cx * bb) / twice];
    let radius = x.hypot(y);
    radius.is_finite().then_some(([a[0] + x, a[1] + y], radius))
}

fn distance(a: Spot, b: Spot) -> i64 {
    let [x, y] = [0, 1].map(|k| i64::from(a[k]) - i64::from(b[k]));
    x * x + y * y
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_flat_circle_goes_through_its_points() {
        let corners = [[0.0, 0.0], [500.0, 0.001], [1000.0, 0.0]];
        let (center, radius) = circumcircle(corners).expect("not in line");
        assert!(radius > 1e7);
        let places = arc(corners[1], center, radius, 1000.0);
        assert!(places.iter().all(|&[_, y]| y.abs() <= 1), "{places:?}");
        assert!(places.iter().any(|&[x, _]| x <= 0) && places.iter().any(|&[x, _]| x >= 10_000));
        assert_eq!(circumcircle([[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]]), None);
    }
}
