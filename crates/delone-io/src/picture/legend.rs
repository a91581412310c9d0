//! The legend: the scale of colours with degrees, and beside it how many triangles have which
//! angle.

use super::glyphs::{self, Stroke};
use super::{Color, Scene, scale};

/// Bars of the histogram: two degrees each.
const BARS: usize = 30;

/// What the legend consists of.
pub(crate) struct Legend {
    /// Filled rectangles: corner, extent, colour.
    pub bars: Vec<([f32; 2], [f32; 2], Color)>,
    /// Letters and ticks.
    pub strokes: Vec<Stroke>,
    /// Width of the strokes.
    pub stroke_width: f32,
}

impl Legend {
    /// Lays the legend out beside the drawing.
    pub fn new(scene: &Scene<'_>) -> Self {
        let unit = scene.unit;
        let [corner, extent] = scene.view.drawing;
        let height = extent[1].min(560.0 * unit);
        let top = corner[1] + (extent[1] - height) / 2.0;
        let left = corner[0] + extent[0] + 88.0 * unit;
        let at = |share: f32| top + height * (1.0 - share);
        let step = height / BARS as f32;
        let mut bars = Vec::new();
        for (i, share) in scene.histogram::<BARS>().into_iter().enumerate().rev() {
            let color = scale((i as f32 + 0.5) / BARS as f32);
            let y = at((i + 1) as f32 / BARS as f32);
            // Down to the foot, so that the next colour covers it and no seam can show.
            bars.push(([left, y], [16.0 * unit, at(0.0) - y], color));
            let histogram = [left + 22.0 * unit, y];
            bars.push((histogram, [64.0 * unit * share, step * 0.84], color));
        }
        let mut strokes = Vec::new();
        let text_scale = 2.1 * unit;
        for degrees in (0..=60).step_by(10) {
            let y = at(degrees as f32 / 60.0);
            strokes.push(Stroke::Move([left - 8.0 * unit, y]));
            strokes.push(Stroke::Line([left - 2.0 * unit, y]));
            let text = format!("{degrees}°");
            let start = left - 12.0 * unit - glyphs::width(&text, text_scale);
            strokes.extend(glyphs::strokes(
                &text,
                [start, y + 3.5 * text_scale],
                text_scale,
            ));
        }
        let title = title_baselines(top, unit);
        for (text, y) in ["smallest", "angle"].into_iter().zip(title) {
            strokes.extend(glyphs::strokes(text, [left, y], text_scale));
        }
        let stroke_width = 1.6 * unit;
        Self {
            bars,
            strokes,
            stroke_width,
        }
    }
}

/// Returns the baselines of the title's two lines above a scale that begins at `top`: on the page
/// even if the drawing is flat, and never upon each other.
fn title_baselines(top: f32, unit: f32) -> [f32; 2] {
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
