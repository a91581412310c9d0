//! Areas of colour with exact coverage of pixels, for any number of triangles.
//!
//! Every directed edge adds, to the pixels it passes, by how much the colour to its right changes;
//! the sum along each row is then colour × covered area (the accumulation buffer of R. Levien's
//! font-rs, here with one colour for each polygon). Neighbouring triangles share pixels exactly, so no
//! background shines through between them, and triangles smaller than a pixel are averaged.
//!
//! *Cost*: proportional to the length of the edges in pixels, whatever the area.

use super::{Color, PAPER};

/// A page of pixels: light of three colours and covered area, as differences along rows.
pub(crate) struct Accumulator {
    width: usize,
    height: usize,
    /// Rows of `width + 2` differences: an edge in the last pixel also changes the next.
    differences: Vec<[f32; 4]>,
}

impl Accumulator {
    pub fn new([width, height]: [f32; 2]) -> Self {
        let (width, height) = (width as usize, height as usize);
        Self {
            width,
            height,
            differences: vec![[0.0; 4]; (width + 2) * height],
        }
    }

    /// Adds a polygon, counter-clockwise to the eye.
    pub fn add(&mut self, corners: &[[f32; 2]], color: Color) {
        let [r, g, b] = color.to_light();
        let weight = [r, g, b, 1.0];
        for (&a, &b) in corners.iter().zip(corners.iter().cycle().skip(1)) {
            self.add_edge(a, b, weight);
        }
    }

    /// Adds an edge: everything to its right up to the end of the row changes by ±`weight`.
    fn add_edge(&mut self, a: [f32; 2], b: [f32; 2], weight: [f32; 4]) {
        // Going counter-clockwise, the left sides of a polygon lead down the page.
        let down = a[1] < b[1];
        let (top, bottom) = if down { (a, b) } else { (b, a) };
        let sign = if down { 1.0 } else { -1.0 };
        if top[1] == bottom[1] {
            return;
        }
        let slope = (bottom[0] - top[0]) / (bottom[1] - top[1]);
        let last_x = self.width as f32;
        let x_at = |y: f32| (top[0] + (y - top[1]) * slope).clamp(0.0, last_x);
        let rows = top[1].max(0.0) as usize..(bottom[1].ceil() as usize).min(self.height);
        for row in rows {
            let (y0, y1) = (top[1].max(row as f32), bottom[1].min((row + 1) as f32));
            let (x0, x1) = (x_at(y0), x_at(y1));
            self.add_to_row(row, [x0.min(x1), x0.max(x1)], (y1 - y0) * sign, weight);
        }
    }

    /// Adds the part of an edge within one row: from `low` to `high`, `dy` high.
    fn add_to_row(&mut self, row: usize, [low, high]: [f32; 2], dy: f32, weight: [f32; 4]) {
        let start = row * (self.width + 2);
        let (first, last) = (low as usize, high as usize);
        let per_x = dy / (high - low).max(f32::MIN_POSITIVE);
        for column in first..=last.min(self.width) {
            let x0 = low.max(column as f32);
            let x1 = high.min((column + 1) as f32);
            let part = if first == last { dy } else { (x1 - x0) * per_x };
            // Of this pixel, what lies right of the edge is covered; of the next ones, all.
            let beyond = (x0 + x1) / 2.0 - column as f32;
            let [here, next] = [part * (1.0 - beyond), part * beyond];
            for (k, w) in weight.into_iter().enumerate() {
                self.differences[start + column][k] += w * here;
                self.differences[start + column + 1][k] += w * next;
            }
        }
    }

    /// Adds a line of some width, longer by a quarter of it at both ends, so that lines join.
    pub fn add_line(&mut self, [a, b]: [[f32; 2]; 2], width: f32, color: Color) {
        let half = width / 2.0;
        let [dx, dy] = [b[0] - a[0], b[1] - a[1]];
        let length = dx.hypot(dy);
        let [u, v] = match length > 0.0 {
            true => [dx / length * half, dy / length * half],
            false => [half, 0.0],
        };
        let corner = |p: [f32; 2], along: f32, across: f32| {
            [p[0] + along * u - across * v, p[1] + along * v + across * u]
        };
        let corners = [
            corner(a, -0.5, -1.0),
            corner(a, -0.5, 1.0),
            corner(b, 0.5, 1.0),
            corner(b, 0.5, -1.0),
        ];
        self.add(&corners, color);
    }

    /// Sums up: the colour of each pixel over the paper, row by row.
    pub fn into_pixels(self) -> impl Iterator<Item = Color> {
        let paper = PAPER.to_light();
        self.into_sums().map(move |[r, g, b, covered]| {
            // Where polygons overlap, their colours are averaged.
            let (share, rest) = (1.0 / covered.max(1.0), (1.0 - covered).clamp(0.0, 1.0));
            let mix = |c: f32, p: f32| c * share + p * rest;
            let light = [mix(r, paper[0]), mix(g, paper[1]), mix(b, paper[2])];
            Color::from_light(light)
        })
    }

    /// Sums up: the covered share of each pixel, row by row.
    pub fn into_coverage(self) -> impl Iterator<Item = f32> {
        self.into_sums()
            .map(|[.., covered]| covered.clamp(0.0, 1.0))
    }

    /// Sums up the differences along each row.
    fn into_sums(self) -> impl Iterator<Item = [f32; 4]> {
        let (width, stride) = (self.width, self.width + 2);
        let mut sum = [0.0f32; 4];
        (0..stride * self.height).filter_map(move |i| {
            if i % stride == 0 {
                sum = [0.0; 4];
            }
            for (s, d) in sum.iter_mut().zip(self.differences[i]) {
                *s += d;
            }
            (i % stride < width).then_some(sum)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::{Accumulator, Color};

    fn light(accumulator: Accumulator) -> Vec<f32> {
        accumulator.into_pixels().map(|c| c.to_light()[0]).collect()
    }

    const BLACK: Color = Color([0.0; 3]);

    #[test]
    fn coverage_is_the_exact_area() {
        let mut page = Accumulator::new([4.0, 2.0]);
        page.add(&[[0.5, 0.0], [0.5, 1.5], [3.0, 1.5], [3.0, 0.0]], BLACK);
        let expected = [0.5, 0.0, 0.0, 1.0, 0.75, 0.5, 0.5, 1.0];
        for (found, expected) in light(page).into_iter().zip(expected) {
            assert!((found - expected).abs() < 1e-5, "{found} {expected}");
        }
    }

    #[test]
    fn a_sliver_covers_its_area() {
        let mut page = Accumulator::new([8.0, 8.0]);
        let corners = [[0.3, 0.2], [2.2, 7.7], [7.9, 5.1]];
        page.add(&corners, BLACK);
        let [a, b, c] = corners;
        let area = ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])).abs() / 2.0;
        let covered: f32 = light(page).into_iter().map(|l| 1.0 - l).sum();
        assert!((covered - area).abs() < 1e-3, "{covered} {area}");
    }

    #[test]
    fn lines_cover_their_area_in_every_direction() {
        let lines = [
            ([3.0, 2.0], [7.0, 2.0]),
            ([2.0, 3.0], [2.0, 7.0]),
            ([3.0, 3.0], [6.0, 7.0]),
            ([5.0, 5.0], [5.0, 5.0]),
        ];
        for (from, to) in lines {
            for line in [[from, to], [to, from]] {
                let mut page = Accumulator::new([10.0, 10.0]);
                page.add_line(line, 2.0, BLACK);
                let covered: f32 = page.into_coverage().sum();
                let length = (to[0] - from[0]).hypot(to[1] - from[1]);
                let expected = 2.0 * (length + 1.0);
                assert!((covered - expected).abs() < 1e-3, "{line:?}: {covered}");
            }
        }
    }

    #[test]
    fn neighbours_leave_no_seam() {
        let mut page = Accumulator::new([5.0, 5.0]);
        let [a, b, c, d] = [[0.0, 0.0], [5.0, 0.0], [5.0, 5.0], [0.0, 5.0]];
        page.add(&[a, c, b], BLACK);
        page.add(&[a, d, c], BLACK);
        assert!(light(page).into_iter().all(|l| l < 1e-5));
    }
}
